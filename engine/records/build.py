"""From the models of the format to situations and shots, every name checked.

One idea: names are looked up in the variant's vocabulary and its script; whatever is not there
is told at its line with the nearest name that is, and the walk goes on.
"""

from __future__ import annotations

from dataclasses import replace
from math import radians
from typing import TYPE_CHECKING

from engine.game.match import SettingError, balls_at_start, check_settings, start_game, start_state
from engine.game.phrases import PhraseError, parse_event
from engine.game.shot import Shot
from engine.game.situation import Pair, Rest, Situation
from engine.game.spotting import take_up_positions
from engine.physics.world import Strike
from engine.records.record import Record, Step
from engine.table.furniture import BallId, SpotId, ZoneId
from engine.variant.ballset import RangeError, names_in
from rulelang.decisions import Offer
from rulelang.facts import Call

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from pathlib import Path

    from engine.records.spec import (
        AfterSpec,
        BeforeSpec,
        CallSpec,
        ExpectSpec,
        RecordSpec,
        ShotSpec,
        StrikeSpec,
        Value,
    )
    from engine.table.furniture import Point
    from engine.variant.locate import KeyPath
    from engine.variant.report import Report
    from engine.variant.variant import Variant
    from rulelang.events import Event
    from rulelang.facts import Tracked

UNKNOWN_KEY = -1
"""Marks an offer that a record puts on the table, whose rule is found by its option."""


def build_record(path: Path, spec: RecordSpec, variant: Variant, report: Report) -> Record | None:
    """Return the record, None where it has mistakes; those go to the report."""
    builder = _Builder(variant, report)
    start = builder.start(spec)
    steps = tuple(
        builder.step(shot, ("shot", index), start.players) for index, shot in enumerate(spec.shot)
    )
    if report.diagnostics:
        return None
    return Record(
        path, spec.title, tuple(spec.cites), variant, start, steps, spec.physics, report.root
    )


class _Builder:
    """Turns one record into values; mistakes go to the report."""

    def __init__(self, variant: Variant, report: Report) -> None:
        self.variant = variant
        self.report = report
        self.words = variant.program.vocabulary
        self.balls = [ball.name for ball in self.words.balls]

    def known(self, code: str, path: KeyPath, what: str, name: str, among: Iterable[str]) -> str:
        """Return the name; report it where it is not `among` those known."""
        names = list(among)
        if name not in names:
            self.report.unknown(code, path, what, name, names)
        return name

    def ball(self, name: str, path: KeyPath) -> BallId:
        """Return the name of a ball."""
        return BallId(self.known("T301", path, "ball", name, self.balls))

    # -- the situation

    def start(self, spec: RecordSpec) -> Situation:
        """Return the situation before the first shot."""
        players = self._players(spec)
        settings = self._settings(spec)
        opened = start_game(self.variant, players, settings)
        if spec.before is None:
            return opened
        return self._before(spec.before, opened)

    def _players(self, spec: RecordSpec) -> int:
        fewest, most, usual = self.variant.players
        scores = spec.before.scores if spec.before else None
        players = usual if scores is None else len(scores)
        if not fewest <= players <= most:
            message = f"{players} scores: the game is for {fewest} to {most} players"
            self.report.add("T304", ("before", "scores"), message)
            return usual
        return players

    def _settings(self, spec: RecordSpec) -> Mapping[str, Value]:
        try:
            return check_settings(self.variant, spec.settings)
        except SettingError as error:
            self.report.add("T302", ("settings",), str(error))
            return check_settings(self.variant, {})

    def _before(self, spec: BeforeSpec, opened: Situation) -> Situation:
        path: KeyPath = ("before",)
        phases = self.variant.program.phases
        if spec.phase is not None:
            self.known("T303", (*path, "phase"), "phase", spec.phase, phases)
        if spec.shooter > opened.players:
            self.report.add("T304", (*path, "shooter"), f"there is no player {spec.shooter}")
        positions = self._positions(spec.positions, (*path, "positions"))
        rest = Rest(
            zones=self._zones(spec.zones, (*path, "zones")),
            frozen=self._contacts(spec.frozen, (*path, "frozen")),
        )
        situation = replace(
            opened,
            shooter=spec.shooter,
            phase=spec.phase if spec.phase is not None else (phases or ("",))[0],
            scores=tuple(spec.scores) if spec.scores else (0,) * opened.players,
            on_table=self._on_table(spec, (*path, "on_table")),
            state={
                **start_state(self.variant, opened.players),
                **self._state(spec.state, opened.players, (*path, "state")),
            },
            rest=take_up_positions(self.variant, rest, positions),
            in_hand=self._zone(spec.in_hand, (*path, "in_hand")),
        )
        offers = self._offers(spec.options, spec.shooter, (*path, "options"))
        return replace(situation, offers=offers)

    def _on_table(self, spec: BeforeSpec, path: KeyPath) -> frozenset[BallId]:
        if spec.on_table is None:
            given = frozenset(map(BallId, spec.positions))
            return given or balls_at_start(self.variant)
        found: set[BallId] = set()
        for index, written in enumerate(spec.on_table):
            try:
                found.update(self.ball(name, (*path, index)) for name in names_in(written))
            except RangeError as error:
                self.report.add("T305", (*path, index), str(error), 'ranges: "1..9"')
        return frozenset(found)

    def _positions(self, given: Mapping[str, list[float]], path: KeyPath) -> dict[BallId, Point]:
        return {
            self.ball(name, (*path, name)): (float(at[0]), float(at[1]))
            for name, at in given.items()
        }

    def _zones(
        self, given: Mapping[str, str | list[str]], path: KeyPath
    ) -> dict[BallId, frozenset[ZoneId]]:
        zones = {}
        for name, where in given.items():
            listed = [where] if isinstance(where, str) else where
            for zone in listed:
                self.known("T306", (*path, name), "zone", zone, self.words.zones)
            zones[self.ball(name, (*path, name))] = frozenset(map(ZoneId, listed))
        return zones

    def _zone(self, name: str | None, path: KeyPath) -> ZoneId | None:
        if name is None:
            return None
        return ZoneId(self.known("T306", path, "zone", name, self.words.zones))

    def _contacts(self, given: list[str], path: KeyPath) -> frozenset[Pair]:
        pairs = set()
        for index, phrase in enumerate(given):
            one, between, other = phrase.partition(" to ")
            if not between:
                mend = 'write "5 to cushion foot" or "cue to red-1"'
                self.report.add("T307", (*path, index), f'"{phrase}" is no contact', mend)
                continue
            self.ball(one, (*path, index))
            if other.startswith("cushion "):
                name = other.removeprefix("cushion ")
                self.known("T308", (*path, index), "cushion", name, self.words.cushions)
            else:
                self.ball(other, (*path, index))
            pairs.add((one, other))
        return frozenset(pairs)

    def _state(
        self, given: Mapping[str, Value | list[Value]], players: int, path: KeyPath
    ) -> dict[str, Tracked]:
        state: dict[str, Tracked] = {}
        tracked = self.variant.program.tracked
        for name, value in given.items():
            self.known("T309", (*path, name), "tracked value", name, tracked)
            if name not in tracked:
                continue
            if tracked[name].per_player != isinstance(value, list):
                wanted = "a list, one per player" if tracked[name].per_player else "one value"
                self.report.add("T310", (*path, name), f"`{name}` is {wanted}")
            elif isinstance(value, list) and len(value) != players:
                message = f"`{name}` has {len(value)} values for {players} players"
                self.report.add("T310", (*path, name), message)
            else:
                state[name] = tuple(value) if isinstance(value, list) else value
        return state

    def _offers(self, options: list[str], player: int, path: KeyPath) -> tuple[Offer, ...]:
        for index, option in enumerate(options):
            self._option(option, (*path, index))
        return tuple(Offer(player, option, UNKNOWN_KEY) for option in options)

    def _option(self, option: str, path: KeyPath) -> str:
        known = ("play", *self.variant.program.options)
        return self.known("T311", path, "option", option, known)

    # -- the shots

    def step(self, spec: ShotSpec, path: KeyPath, players: int) -> Step:
        """Return one shot with its expectation."""
        struck = None if spec.struck is None else self.ball(spec.struck, (*path, "struck"))
        if spec.choose is not None:
            self._option(spec.choose, (*path, "choose"))
        elif spec.events is None and spec.strike is None:
            mend = "give `events`, `strike`, or `choose` for a choice alone"
            self.report.add("T312", path, "a shot without anything that happened", mend)
        shot = Shot(
            choice=spec.choose,
            call=self._call(spec.call, (*path, "call")),
            struck=struck,
            placement=None if spec.place is None else (spec.place[0], spec.place[1]),
            facts=self._facts(spec.facts, (*path, "facts")),
            strike=None if spec.strike is None else as_strike(spec.strike),
            events=self._events(spec.events, (*path, "events")),
            after=self._after(spec.after, (*path, "after")),
        )
        self._expect(spec.expect, (*path, "expect"), players)
        return Step(shot, spec.expect)

    def _call(self, spec: CallSpec, path: KeyPath) -> Call:
        if spec.ball is not None:
            self.ball(spec.ball, (*path, "ball"))
        if spec.pocket is not None:
            self.known("T313", (*path, "pocket"), "pocket", spec.pocket, self.words.pockets)
        if spec.group is not None:
            groups = dict.fromkeys(group for ball in self.words.balls for group in ball.groups)
            self.known("T314", (*path, "group"), "group", spec.group, groups)
        return Call(spec.ball, spec.pocket, spec.safety, spec.group)

    def _facts(self, given: Mapping[str, Value], path: KeyPath) -> Mapping[str, Value]:
        declared = self.variant.program.facts
        for name in given:
            self.known("T315", (*path, name), "fact", name, declared)
        return dict(given)

    def _events(self, given: list[str] | None, path: KeyPath) -> tuple[Event, ...] | None:
        if given is None:
            return None
        events = []
        for index, text in enumerate(given):
            try:
                events.append(parse_event(text, self.words))
            except PhraseError as error:
                self.report.add("T316", (*path, index), str(error), error.mend)
        times = [event.time for event in events]
        if any(time is None for time in times) and any(time is not None for time in times):
            self.report.add("T317", path, "some events have a time and some have not")
        known = [time for time in times if time is not None]
        if known != sorted(known):
            self.report.add("T317", path, "the times of the events go back")
        return tuple(events)

    def _after(self, spec: AfterSpec, path: KeyPath) -> Rest:
        covered = {}
        for spot, ball in spec.spots.items():
            self.known("T318", (*path, "spots", spot), "spot", spot, self.words.spots)
            covered[SpotId(spot)] = self.ball(ball, (*path, "spots", spot))
        return Rest(
            positions=self._positions(spec.positions, (*path, "positions")),
            frozen=self._contacts(spec.frozen, (*path, "frozen")),
            covered=covered,
        )

    def _expect(self, spec: ExpectSpec, path: KeyPath, players: int) -> None:
        program = self.variant.program
        for index, foul in enumerate(spec.fouls or ()):
            self.known("T319", (*path, "fouls", index), "foul", foul, program.fouls)
        for key in ("spotted", "spotted_in_order"):
            for index, text in enumerate(getattr(spec, key) or ()):
                self._spotted(text, (*path, key, index))
        for index, option in enumerate(spec.options or ()):
            self._option(option, (*path, "options", index))
        if spec.in_hand not in {None, "none"}:
            self._zone(spec.in_hand, (*path, "in_hand"))
        if spec.phase is not None:
            self.known("T303", (*path, "phase"), "phase", spec.phase, program.phases)
        for key, value in (("next", spec.next), ("winner", spec.winner)):
            if value is not None and value > players:
                self.report.add("T304", (*path, key), f"there is no player {value}")
        if spec.points is not None and len(spec.points) != players:
            self.report.add("T304", (*path, "points"), f"the game has {players} players")
        self._positions(spec.positions or {}, (*path, "positions"))
        self._state(spec.state or {}, players, (*path, "state"))

    def _spotted(self, text: str, path: KeyPath) -> None:
        words = text.split(" ")
        self.ball(words[0], path)
        if len(words) == 3 and words[1] in {"at", "near"}:
            self.known("T318", path, "spot", words[2], self.words.spots)
        elif len(words) != 1:
            mend = 'write "9", "9 at foot-spot" or "9 near foot-spot"'
            self.report.add("T320", path, f'"{text}" tells no spotted ball', mend)


def as_strike(spec: StrikeSpec) -> Strike:
    """Return the stroke in radians."""
    return Strike(
        spec.speed, radians(spec.heading), radians(spec.elevation), spec.side, spec.follow
    )
