"""The situation before a record's first shot.

One idea: a record without `before` begins where a game begins; a key left out has the default of
the format, and what is not told is not known.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from engine.game.match import SettingError, balls_at_start, check_settings, start_game, start_state
from engine.game.referee import announce, take_in_hand
from engine.game.situation import Rest, Situation
from engine.game.spotting import take_up_positions
from engine.table.furniture import BallId, ZoneId
from engine.variant.ballset import RangeError, names_in
from rulelang.decisions import Offer

if TYPE_CHECKING:
    from collections.abc import Mapping

    from engine.records.names import Names
    from engine.records.spec import BeforeSpec, RecordSpec, Value
    from engine.variant.locate import KeyPath
    from rulelang.vocabulary import Tracked

UNKNOWN_KEY = -1
"""Marks an offer that a record puts on the table, whose rule is found by its option."""


def start_of(names: Names, spec: RecordSpec, seed: int = 0) -> Situation:
    """Return the situation before the first shot."""
    players = _players(names, spec)
    settings = _settings(names, spec)
    opened = start_game(names.variant, players, settings, seed)
    if spec.before is None:
        return opened
    return _before(names, spec.before, opened)


def _players(names: Names, spec: RecordSpec) -> int:
    fewest, most, usual = names.variant.players
    scores = spec.before.scores if spec.before else None
    players = usual if scores is None else len(scores)
    if not fewest <= players <= most:
        message = f"{players} scores: the game is for {fewest} to {most} players"
        names.report.add("T304", ("before", "scores"), message)
        return usual
    return players


def _settings(names: Names, spec: RecordSpec) -> Mapping[str, Value]:
    try:
        return check_settings(names.variant, spec.settings)
    except SettingError as error:
        names.report.add("T302", ("settings",), str(error))
        return check_settings(names.variant, {})


def _before(names: Names, spec: BeforeSpec, opened: Situation) -> Situation:
    path: KeyPath = ("before",)
    phases = names.variant.program.phases
    if spec.phase is not None:
        names.known("T303", (*path, "phase"), "phase", spec.phase, phases)
    if spec.shooter > opened.players:
        names.report.add("T304", (*path, "shooter"), f"there is no player {spec.shooter}")
    positions = names.positions(spec.positions, (*path, "positions"))
    rest = Rest(
        zones=_zones(names, spec.zones, (*path, "zones")),
        frozen=names.contacts(spec.frozen, (*path, "frozen")) | names.drawn(positions),
    )
    names.agreeing(replace(rest, positions=positions), path)
    situation = replace(
        opened,
        shooter=spec.shooter,
        phase=spec.phase if spec.phase is not None else (phases or ("",))[0],
        scores=tuple(spec.scores) if spec.scores else (0,) * opened.players,
        on_table=_on_table(names, spec, (*path, "on_table")),
        state={
            **start_state(names.variant, opened.players),
            **_of_the_match(names, opened),
            **names.state(spec.state, opened.players, (*path, "state")),
        },
        rest=take_up_positions(names.variant, rest, positions),
        in_hand=names.zone(spec.in_hand, (*path, "in_hand")),
        offers=(),
    )
    if situation.in_hand is not None:
        situation = take_in_hand(names.variant, situation, situation.in_hand)
    offers = _offers(names, spec.options, spec.shooter, (*path, "options"))
    if names.report.diagnostics:
        return situation
    announced = announce(names.variant, situation)
    return replace(announced, offers=offers) if "options" in spec.model_fields_set else announced


def _of_the_match(names: Names, opened: Situation) -> Mapping[str, Tracked]:
    """Return what the start of the match set, by settings for one; no game changes its start."""
    tracked = names.variant.program.tracked
    return {n: value for n, value in opened.state.items() if tracked[n].scope == "match"}


def _on_table(names: Names, spec: BeforeSpec, path: KeyPath) -> frozenset[BallId]:
    if spec.on_table is None:
        given = frozenset(map(BallId, spec.positions))
        return given or balls_at_start(names.variant)
    found: set[BallId] = set()
    for index, written in enumerate(spec.on_table):
        try:
            found.update(names.ball(name, (*path, index)) for name in names_in(written))
        except RangeError as error:
            names.report.add("T305", (*path, index), str(error), 'ranges: "1..9"')
    return frozenset(found)


def _zones(
    names: Names, given: Mapping[str, str | list[str]], path: KeyPath
) -> dict[BallId, frozenset[ZoneId]]:
    zones = {}
    for name, where in given.items():
        listed = [where] if isinstance(where, str) else where
        for zone in listed:
            names.known("T306", (*path, name), "zone", zone, names.words.zones)
        zones[names.ball(name, (*path, name))] = frozenset(map(ZoneId, listed))
    return zones


def _offers(names: Names, options: list[str], player: int, path: KeyPath) -> tuple[Offer, ...]:
    for index, option in enumerate(options):
        names.option(option, (*path, index))
    return tuple(Offer(player, option, UNKNOWN_KEY) for option in options)
