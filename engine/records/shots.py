"""The shots of a record, every name checked.

One idea: what a shot tells and what is expected of it are read apart; nothing is compared here.
"""

from __future__ import annotations

from math import radians
from typing import TYPE_CHECKING

from engine.game.phrases import PhraseError, parse_event
from engine.game.shot import Shot
from engine.game.situation import Rest
from engine.physics.world import Strike
from engine.records.record import Step
from engine.table.furniture import SpotId
from rulelang.facts import Call

if TYPE_CHECKING:
    from collections.abc import Mapping

    from engine.records.names import Names
    from engine.records.spec import AfterSpec, CallSpec, ExpectSpec, ShotSpec, StrikeSpec, Value
    from engine.variant.locate import KeyPath
    from rulelang.events import Event


def step_of(names: Names, spec: ShotSpec, path: KeyPath, players: int) -> Step:
    """Return one shot with its expectation."""
    struck = None if spec.struck is None else names.ball(spec.struck, (*path, "struck"))
    if spec.choose is not None:
        names.option(spec.choose, (*path, "choose"))
    elif spec.events is None and spec.strike is None:
        mend = "give `events`, `strike`, or `choose` for a choice alone"
        names.report.add("T312", path, "a shot without anything that happened", mend)
    shot = Shot(
        choice=spec.choose,
        call=_call(names, spec.call, (*path, "call")),
        struck=struck,
        placement=None if spec.place is None else (spec.place[0], spec.place[1]),
        facts=_facts(names, spec.facts, (*path, "facts")),
        strike=None if spec.strike is None else as_strike(spec.strike),
        events=_events(names, spec.events, (*path, "events")),
        after=_after(names, spec.after, (*path, "after")),
    )
    _expect(names, spec.expect, (*path, "expect"), players)
    return Step(shot, spec.expect)


def _call(names: Names, spec: CallSpec, path: KeyPath) -> Call:
    if spec.ball is not None:
        names.ball(spec.ball, (*path, "ball"))
    if spec.pocket is not None:
        names.known("T313", (*path, "pocket"), "pocket", spec.pocket, names.words.pockets)
    if spec.group is not None:
        groups = dict.fromkeys(group for ball in names.words.balls for group in ball.groups)
        names.known("T314", (*path, "group"), "group", spec.group, groups)
    return Call(spec.ball, spec.pocket, spec.safety, spec.group)


def _facts(names: Names, given: Mapping[str, Value], path: KeyPath) -> Mapping[str, Value]:
    declared = names.variant.program.facts
    for name in given:
        names.known("T315", (*path, name), "fact", name, declared)
    return dict(given)


def _events(names: Names, given: list[str] | None, path: KeyPath) -> tuple[Event, ...] | None:
    if given is None:
        return None
    events = []
    for index, text in enumerate(given):
        try:
            events.append(parse_event(text, names.words))
        except PhraseError as error:
            names.report.add("T316", (*path, index), str(error), error.mend)
    times = [event.time for event in events]
    if any(time is None for time in times) and any(time is not None for time in times):
        names.report.add("T317", path, "some events have a time and some have not")
    known = [time for time in times if time is not None]
    if known != sorted(known):
        names.report.add("T317", path, "the times of the events go back")
    return tuple(events)


def _after(names: Names, spec: AfterSpec, path: KeyPath) -> Rest:
    covered = {}
    for spot, ball in spec.spots.items():
        names.known("T318", (*path, "spots", spot), "spot", spot, names.words.spots)
        covered[SpotId(spot)] = names.ball(ball, (*path, "spots", spot))
    positions = names.positions(spec.positions, (*path, "positions"))
    rest = Rest(
        positions=positions,
        frozen=names.contacts(spec.frozen, (*path, "frozen")) | names.drawn(positions),
        covered=covered,
    )
    names.agreeing(rest, path)
    return rest


def _expect(names: Names, spec: ExpectSpec, path: KeyPath, players: int) -> None:
    program = names.variant.program
    for index, foul in enumerate(spec.fouls or ()):
        names.known("T319", (*path, "fouls", index), "foul", foul, program.fouls)
    for key in ("spotted", "spotted_in_order"):
        for index, text in enumerate(getattr(spec, key) or ()):
            _spotted(names, text, (*path, key, index))
    for index, option in enumerate(spec.options or ()):
        names.option(option, (*path, "options", index))
    if spec.in_hand not in {None, "none"}:
        names.zone(spec.in_hand, (*path, "in_hand"))
    if spec.phase is not None:
        names.known("T303", (*path, "phase"), "phase", spec.phase, program.phases)
    for key, value in (("next", spec.next), ("winner", spec.winner)):
        if value is not None and value > players:
            names.report.add("T304", (*path, key), f"there is no player {value}")
    if spec.points is not None and len(spec.points) != players:
        names.report.add("T304", (*path, "points"), f"the game has {players} players")
    names.positions(spec.positions or {}, (*path, "positions"))
    names.state(spec.state or {}, players, (*path, "state"))


def _spotted(names: Names, text: str, path: KeyPath) -> None:
    words = text.split(" ")
    names.ball(words[0], path)
    if len(words) == 3 and words[1] in {"at", "near"}:
        names.known("T318", path, "spot", words[2], names.words.spots)
    elif len(words) != 1:
        mend = 'write "9", "9 at foot-spot" or "9 near foot-spot"'
        names.report.add("T320", path, f'"{text}" tells no spotted ball', mend)


def as_strike(spec: StrikeSpec) -> Strike:
    """Return the stroke in radians."""
    return Strike(
        spec.speed, radians(spec.heading), radians(spec.elevation), spec.side, spec.follow
    )
