"""What every name of a script stands for.

One idea: the host's vocabulary and the script's declarations become one set of tables, asked by
name; a miss is answered with the nearest name that would fit.
Invariant: bits are given to balls in the vocabulary's order, then to pins.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from difflib import get_close_matches
from typing import TYPE_CHECKING

from rulelang.code import Mistake

if TYPE_CHECKING:
    from collections.abc import Iterable

    from rulelang import syntax as s
    from rulelang.code import Code
    from rulelang.probe import Probe
    from rulelang.program import FactDecl, Timer, Track
    from rulelang.vocabulary import Vocabulary


@dataclass(slots=True)
class Scope:
    """Names of one program while it is compiled."""

    vocabulary: Vocabulary
    bits: dict[str, int] = field(default_factory=dict)
    groups: dict[str, int] = field(default_factory=dict)
    values: dict[int, int] = field(default_factory=dict)
    balls: int = 0
    pins: int = 0
    phases: tuple[str, ...] = ()
    families: dict[str, tuple[str, ...]] = field(default_factory=dict)
    tracks: dict[str, Track] = field(default_factory=dict)
    track_kinds: dict[str, str] = field(default_factory=dict)
    facts: dict[str, FactDecl] = field(default_factory=dict)
    fact_nodes: dict[str, s.Fact] = field(default_factory=dict)
    mates: int = 0
    timers: dict[str, Timer] = field(default_factory=dict)
    defines: dict[str, s.Define] = field(default_factory=dict)
    poisoned: set[str] = field(default_factory=set)
    compiled: dict[tuple[str, bool], Code] = field(default_factory=dict)
    busy: list[str] = field(default_factory=list)
    below: list[int] = field(default_factory=list)
    depths: dict[str, int] = field(default_factory=dict)
    used: set[str] = field(default_factory=set)
    fouls: dict[str, None] = field(default_factory=dict)
    options: dict[str, None] = field(default_factory=dict)
    sources: dict[str, str] = field(default_factory=dict)
    scripts: list[s.Script] = field(default_factory=list)
    owners: dict[str, s.Script] = field(default_factory=dict)
    lasting: int = 0
    passing: int = 0
    asks: set[str] = field(default_factory=set)
    probe: Probe | None = None

    def __post_init__(self) -> None:
        for number, ball in enumerate(self.vocabulary.balls):
            bit = 1 << number
            self.bits[ball.name] = bit
            self.balls |= bit
            self.values[bit] = ball.value
            for group in ball.groups:
                self.groups[group] = self.groups.get(group, 0) | bit
        first = len(self.vocabulary.balls)
        for number, pin in enumerate(self.vocabulary.pins, first):
            self.bits[pin] = 1 << number
            self.pins |= 1 << number

    def group(self, name: str) -> int | None:
        """Return the mask of a group by its name or its singular, None where there is none."""
        if name in self.groups:
            return self.groups[name]
        return self.groups.get(name + "s")

    def cue_balls(self) -> int:
        """Return the mask of every player's cue ball."""
        mask = 0
        for name in self.vocabulary.cue_balls:
            mask |= self.bits.get(name, 0)
        return mask

    def known(self) -> list[str]:
        """Return every name that can stand as a noun."""
        singles = [name.removesuffix("s") for name in self.groups]
        return [
            *self.defines, *self.tracks, *self.facts, *self.vocabulary.settings, *self.bits,
            *self.groups, *singles,
        ]  # fmt: skip

    def place(self, sort: str, name: str, at: s.Span) -> str:
        """Return `name` if it is a zone, line, spot, pocket, cushion or pin; else raise R203."""
        tables: dict[str, Iterable[str]] = {
            "zone": self.vocabulary.zones,
            "line": self.vocabulary.lines,
            "spot": self.vocabulary.spots,
            "pocket": self.vocabulary.pockets,
            "cushion": self.vocabulary.cushions,
        }
        table = tuple(tables[sort])
        if name in table:
            return name
        listed = f"the {sort}s are {', '.join(table)}" if table else f"this table has no {sort}s"
        raise Mistake("R203", at, f'"{name}" is not a {sort}', nearest(name, table) or listed)

    def zones(self, name: str, at: s.Span) -> tuple[str, ...]:
        """Return the zones declared under `name`, or the zone of that name; else raise R203."""
        if name in self.families:
            self.used.add(name)
            return self.families[name]
        if name in self.poisoned:
            raise Mistake("R203", at, "", silent=True)
        if name in self.vocabulary.zones:
            return (name,)
        known = (*self.families, *self.vocabulary.zones)
        listed = f"declare it: zones {name} are ..."
        message = f'"{name}" is not a zone, nor the name of several'
        raise Mistake("R203", at, message, nearest(name, known) or listed)

    def phase(self, name: str, at: s.Span) -> str:
        """Return `name` if it is a phase; else raise R202."""
        if name in self.phases:
            return name
        listed = f"declare it: phases {', '.join((*self.phases, name))}"
        raise Mistake("R202", at, f'"{name}" is not a phase', nearest(name, self.phases) or listed)


def nearest(name: str, names: Iterable[str]) -> str:
    """Return "did you mean ...?" with the closest name, or nothing."""
    close = get_close_matches(name, list(names), 1, 0.6)
    return f"did you mean `{close[0]}`?" if close else ""
