"""Names in a record, looked up in the variant's vocabulary and its script.

One idea: whatever is not there is told at its line with the nearest name that is, and the walk
goes on.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from engine.records.agree import strange_contacts, strange_covers, strange_zones
from engine.records.drawn import drawn_contacts
from engine.table.furniture import BallId, ZoneId

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from engine.game.situation import Pair, Rest
    from engine.records.spec import Value
    from engine.table.furniture import Point
    from engine.variant.locate import KeyPath
    from engine.variant.report import Report
    from engine.variant.variant import Variant
    from rulelang.vocabulary import Tracked


class Names:
    """The names of one record; mistakes go to the report."""

    def __init__(self, variant: Variant, report: Report, *, by_hand: bool = False) -> None:
        self.variant = variant
        self.report = report
        self.by_hand = by_hand
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

    def positions(self, given: Mapping[str, list[float]], path: KeyPath) -> dict[BallId, Point]:
        """Return places (m) by ball."""
        return {
            self.ball(name, (*path, name)): (float(at[0]), float(at[1]))
            for name, at in given.items()
        }

    def zone(self, name: str | None, path: KeyPath) -> ZoneId | None:
        """Return the name of a zone, None for none."""
        if name is None:
            return None
        return ZoneId(self.known("T306", path, "zone", name, self.words.zones))

    def contacts(self, given: list[str], path: KeyPath) -> frozenset[Pair]:
        """Return contacts written as `5 to cushion foot` or `cue to red-1`."""
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

    def drawn(self, positions: Mapping[BallId, Point]) -> frozenset[Pair]:
        """Return the contacts that positions (m) of a record written by hand mean besides."""
        return drawn_contacts(self.variant.world, positions) if self.by_hand else frozenset()

    def agreeing(self, rest: Rest, path: KeyPath) -> None:
        """Report where zones, contacts and taken spots are not what the positions tell."""
        world, positions = self.variant.world, rest.positions
        mend = "tell it once, or mend one of the two"
        for ball, message in strange_zones(world, positions, rest.zones):
            self.report.add("T321", (*path, "zones", ball), message, mend)
        for message in strange_contacts(world, positions, rest.frozen):
            self.report.add("T321", (*path, "frozen"), message, mend)
        for spot, message in strange_covers(world, positions, rest.covered):
            self.report.add("T321", (*path, "spots", spot), message, mend)

    def state(
        self, given: Mapping[str, Value | list[Value]], players: int, path: KeyPath
    ) -> dict[str, Tracked]:
        """Return tracked values, a tuple for one per player."""
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

    def option(self, option: str, path: KeyPath) -> str:
        """Return the name of an option."""
        known = ("play", *self.variant.program.options)
        return self.known("T311", path, "option", option, known)
