# ruff: noqa: D101 - a class here is its construct, and the grammar tells what it is
"""What stands at the left margin of a file, as written: declarations and rules.

One idea: a `Script` is one file, its declarations and rules in the order of the text.
Invariant: a rule of no section, or without a name, stays so; nothing is filled in.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rulelang.frozen import value

if TYPE_CHECKING:
    from rulelang.syntax.expressions import Expr
    from rulelang.syntax.places import Span
    from rulelang.syntax.statements import Statement


@value
class Rule:
    """A rule with its section (`fouls`, `game start` ...); a bare rule has no name."""

    at: Span
    name: str
    section: str | None
    phases: tuple[str, ...]
    cites: tuple[str, ...]
    overrides: tuple[tuple[str, Span], ...]
    body: tuple[Statement, ...]


@value
class Track:
    at: Span
    name: str
    units: tuple[str, ...]
    start: Expr | None


@value
class Timer:
    """Seconds that run `per` a unit; that it ran out is told like a fact."""

    at: Span
    name: str
    seconds: str
    per: str


@value
class Fact:
    """An author's fact; `kind` is "", "ball", "number", "player" or "values".

    `asked_from` is the zone that a cue ball off the bed is played from.
    """

    at: Span
    name: str
    kind: str
    values: tuple[str, ...]
    default: Expr | None
    predicate: str | None
    asked_on: Expr | None
    asked_from: str | None = None


@value
class Home:
    at: Span
    balls: Expr
    spot: str


@value
class SpottingOrder:
    """Sets of balls in the order in which they are spotted."""

    at: Span
    sets: tuple[Expr, ...]


@value
class Define:
    """Cases of condition and value; a plain define has one case without a condition."""

    at: Span
    name: str
    frozen: bool
    cases: tuple[tuple[Expr | None, Expr], ...]


@value
class Header:
    """A line of one word with its text.

    That is `language`, `game`, `cites`, `book`, `uses`, `spotting`, `settled` or `side`.
    """

    at: Span
    word: str
    text: str


@value
class Phases:
    at: Span
    names: tuple[tuple[str, Span], ...]


@value
class Zones:
    """Zones under one name, any of which balls may lie in together."""

    at: Span
    name: str
    members: tuple[tuple[str, Span], ...]


Declaration = Header | Phases | Zones | Timer | Track | Fact | Home | SpottingOrder | Define


@value
class Script:
    """One file: its declarations and rules in the order of the text."""

    file: str
    source: str
    declarations: tuple[Declaration, ...]
    rules: tuple[Rule, ...]
