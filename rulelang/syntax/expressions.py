# ruff: noqa: D101 - a class here is its construct, and the grammar tells what it is
"""Nouns, numbers and conditions, as written.

One idea: whatever has a value is one kind of node, an `Expr`; whether it is a set, a number or a
condition is found out later. Invariant: a node is built of nodes of this file alone.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rulelang.syntax.places import Span


@dataclass(frozen=True, slots=True)
class Number:
    at: Span
    value: int


@dataclass(frozen=True, slots=True)
class Flag:
    at: Span
    value: bool


@dataclass(frozen=True, slots=True)
class Nothing:
    at: Span


@dataclass(frozen=True, slots=True)
class Name:
    """A bare word: a name of the variant or of the author."""

    at: Span
    name: str


@dataclass(frozen=True, slots=True)
class NameOf:
    """A tracked value of one player: `fouls-in-a-row of shooter`."""

    at: Span
    name: str
    who: Expr


@dataclass(frozen=True, slots=True)
class BallNumber:
    """`9-ball`: the ball whose name is 9."""

    at: Span
    name: str


@dataclass(frozen=True, slots=True)
class Noun:
    """A noun of the language: `object balls`, `first ball hit`, `phase` ..."""

    at: Span
    words: str


@dataclass(frozen=True, slots=True)
class Called:
    """`called NAME`: a group claimed for the shot."""

    at: Span
    what: str


@dataclass(frozen=True, slots=True)
class Player:
    at: Span
    words: str


@dataclass(frozen=True, slots=True)
class OpponentOf:
    at: Span
    who: Expr


@dataclass(frozen=True, slots=True)
class PartnerOf:
    """The next player of the same side."""

    at: Span
    who: Expr


@dataclass(frozen=True, slots=True)
class CueBallOf:
    at: Span
    who: Expr


@dataclass(frozen=True, slots=True)
class ScoreOf:
    at: Span
    who: Expr


@dataclass(frozen=True, slots=True)
class LotOf:
    """A number from 1 to `most` drawn by lot for a player, another for each."""

    at: Span
    who: Expr
    most: int


@dataclass(frozen=True, slots=True)
class ScoreGap:
    at: Span


@dataclass(frozen=True, slots=True)
class Listing:
    at: Span
    items: tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class OnTable:
    at: Span
    base: Expr


@dataclass(frozen=True, slots=True)
class Standing:
    """The pins of a set that stand."""

    at: Span
    base: Expr


@dataclass(frozen=True, slots=True)
class UpTo:
    """`up to N among X`: the first N balls of a set, in the order of the variant."""

    at: Span
    count: Expr
    base: Expr


@dataclass(frozen=True, slots=True)
class ScoreExtreme:
    """The highest or the lowest score, or the second after it."""

    at: Span
    which: str
    second: bool = False


@dataclass(frozen=True, slots=True)
class Extreme:
    """The ball of highest or lowest value in a set."""

    at: Span
    which: str
    base: Expr


@dataclass(frozen=True, slots=True)
class Except:
    at: Span
    base: Expr
    but: Expr


@dataclass(frozen=True, slots=True)
class Quantified:
    """`any`, `every`, `no`, `only`, or a count with its number."""

    at: Span
    how: str
    count: int
    base: Expr


@dataclass(frozen=True, slots=True)
class Verb:
    """An event phrase: its word, what it is done to, and the name of a place."""

    at: Span
    word: str
    target: Expr | None = None
    place: str | None = None
    negated: bool = False


@dataclass(frozen=True, slots=True)
class Happened:
    """`SUBJECT EVENT`; without a subject the event stands alone (`foot left floor`)."""

    at: Span
    subject: Expr | None
    verb: Verb


@dataclass(frozen=True, slots=True)
class Total:
    """`number of`, `value of`, `highest value of`, `highest worth of`, `highest of` ..."""

    at: Span
    what: str
    base: Expr


@dataclass(frozen=True, slots=True)
class Arithmetic:
    at: Span
    op: str
    left: Expr
    right: Expr


@dataclass(frozen=True, slots=True)
class Test:
    """What stands after `is`: a word for the test, its operand, the name of a place."""

    at: Span
    word: str
    value: Expr | None = None
    place: str | None = None


@dataclass(frozen=True, slots=True)
class Is:
    at: Span
    subject: Expr
    negated: bool
    test: Test


@dataclass(frozen=True, slots=True)
class Junction:
    """`and` or `or` of at least two parts."""

    at: Span
    word: str
    parts: tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class Not:
    at: Span
    part: Expr


@dataclass(frozen=True, slots=True)
class Sequence:
    """`before`, `after` or `then` between events."""

    at: Span
    word: str
    parts: tuple[Expr, ...]


Expr = (
    Number | Flag | Nothing | Name | NameOf | BallNumber | Noun | Called | Player | OpponentOf
    | PartnerOf | CueBallOf | ScoreOf | LotOf | ScoreGap | ScoreExtreme | Listing | OnTable
    | Standing | UpTo | Extreme | Except | Quantified
    | Happened | Total | Arithmetic | Is | Junction | Not | Sequence
)  # fmt: skip
