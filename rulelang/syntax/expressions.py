# ruff: noqa: D101 - a class here is its construct, and the grammar tells what it is
"""Nouns, numbers and conditions, as written.

One idea: whatever has a value is one kind of node, an `Expr`; whether it is a set, a number or a
condition is found out later. Invariant: a node is built of nodes of this file alone.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rulelang.frozen import value

if TYPE_CHECKING:
    from rulelang.syntax.places import Span


@value
class Number:
    at: Span
    value: int


@value
class Flag:
    at: Span
    value: bool


@value
class Nothing:
    at: Span


@value
class Name:
    """A bare word: a name of the variant or of the author."""

    at: Span
    name: str


@value
class NameOf:
    """A tracked value of one player: `fouls-in-a-row of shooter`."""

    at: Span
    name: str
    who: Expr


@value
class BallNumber:
    """`9-ball`: the ball whose name is 9."""

    at: Span
    name: str


@value
class Noun:
    """A noun of the language: `object balls`, `first ball hit`, `phase` ..."""

    at: Span
    words: str


@value
class Called:
    """`called NAME`: a group claimed for the shot."""

    at: Span
    what: str


@value
class Player:
    at: Span
    words: str


@value
class OpponentOf:
    at: Span
    who: Expr


@value
class PartnerOf:
    """The next player of the same side."""

    at: Span
    who: Expr


@value
class CueBallOf:
    at: Span
    who: Expr


@value
class ScoreOf:
    at: Span
    who: Expr


@value
class LotOf:
    """A number from 1 to `most` drawn by lot for a player, another for each."""

    at: Span
    who: Expr
    most: int


@value
class ScoreGap:
    at: Span


@value
class Listing:
    at: Span
    items: tuple[Expr, ...]


@value
class OnTable:
    at: Span
    base: Expr


@value
class Standing:
    """The pins of a set that stand."""

    at: Span
    base: Expr


@value
class UpTo:
    """`up to N among X`: the first N balls of a set, in the order of the variant."""

    at: Span
    count: Expr
    base: Expr


@value
class ScoreExtreme:
    """The highest or the lowest score, or the second after it."""

    at: Span
    which: str
    second: bool = False


@value
class Extreme:
    """The ball of highest or lowest value in a set."""

    at: Span
    which: str
    base: Expr


@value
class Except:
    at: Span
    base: Expr
    but: Expr


@value
class Quantified:
    """`any`, `every`, `no`, `only`, or a count with its number."""

    at: Span
    how: str
    count: int
    base: Expr


@value
class Verb:
    """An event phrase: its word, what it is done to, and the name of a place."""

    at: Span
    word: str
    target: Expr | None = None
    place: str | None = None


@value
class Happened:
    """`SUBJECT EVENT`; without a subject the event stands alone (`foot left floor`)."""

    at: Span
    subject: Expr | None
    verb: Verb


@value
class Total:
    """`number of`, `value of`, `highest value of`, `highest worth of`, `highest of` ..."""

    at: Span
    what: str
    base: Expr


@value
class Arithmetic:
    at: Span
    op: str
    left: Expr
    right: Expr


@value
class Test:
    """What stands after `is`: a word for the test, its operand, the name of a place."""

    at: Span
    word: str
    value: Expr | None = None
    place: str | None = None


@value
class Is:
    at: Span
    subject: Expr
    negated: bool
    test: Test


@value
class Junction:
    """`and` or `or` of at least two parts."""

    at: Span
    word: str
    parts: tuple[Expr, ...]


@value
class Not:
    at: Span
    part: Expr


@value
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
