# ruff: noqa: D101 - a class here is its construct, and the grammar tells what it is
"""The tree of a script: what was written, before anybody asks whether it makes sense.

One idea: one class per construct, each with the place it was written at; kinds and names are
checked later. Invariant: a tree holds no name resolved and no value computed.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Span:
    """Where something stands: line and column from 1, and the range of characters."""

    line: int
    column: int
    start: int
    end: int


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
class CueBallOf:
    at: Span
    who: Expr


@dataclass(frozen=True, slots=True)
class ScoreOf:
    at: Span
    who: Expr


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
    | CueBallOf | ScoreOf | ScoreGap | Listing | OnTable | Extreme | Except | Quantified
    | Happened | Total | Arithmetic | Is | Junction | Not | Sequence
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Foul:
    at: Span
    name: str
    worth: Expr | None
    alone: bool


@dataclass(frozen=True, slots=True)
class Award:
    """`award` or `deduct`."""

    at: Span
    verb: str
    amount: Expr
    who: Expr


@dataclass(frozen=True, slots=True)
class Write:
    """`add`, `set`, `reset` or `assign`, to a tracked value."""

    at: Span
    verb: str
    name: str
    who: Expr | None
    value: Expr | None


@dataclass(frozen=True, slots=True)
class Turn:
    at: Span
    continues: bool
    who: Expr | None


@dataclass(frozen=True, slots=True)
class GoToPhase:
    at: Span
    phase: str


@dataclass(frozen=True, slots=True)
class PlaceAt:
    """One place of a `spot`: kinds at, home, occupant, own, highest-free, lay, near, near-own."""

    at: Span
    kind: str
    spot: str | None = None
    toward: str = "foot"


@dataclass(frozen=True, slots=True)
class SpotBalls:
    at: Span
    balls: Expr
    places: tuple[PlaceAt, ...]


@dataclass(frozen=True, slots=True)
class RemoveBalls:
    at: Span
    balls: Expr


@dataclass(frozen=True, slots=True)
class RackAgain:
    at: Span
    keeping: Expr | None


@dataclass(frozen=True, slots=True)
class RestoreTable:
    at: Span


@dataclass(frozen=True, slots=True)
class GiveInHand:
    at: Span
    who: Expr
    zone: str | None


@dataclass(frozen=True, slots=True)
class Require:
    """`require` or `allow` a call."""

    at: Span
    verb: str
    what: str
    who: Expr


@dataclass(frozen=True, slots=True)
class Win:
    """`wins`, `loses` or `tie` of a unit."""

    at: Span
    verb: str
    who: Expr | None
    unit: str


@dataclass(frozen=True, slots=True)
class Seat:
    """`eliminate` or `reinstate` a player."""

    at: Span
    verb: str
    who: Expr


@dataclass(frozen=True, slots=True)
class Plays:
    at: Span
    who: Expr


@dataclass(frozen=True, slots=True)
class NothingHappens:
    at: Span


@dataclass(frozen=True, slots=True)
class If:
    """Branches of condition and body, tried in order, and the body of `otherwise`."""

    at: Span
    branches: tuple[tuple[Expr, tuple[Statement, ...]], ...]
    otherwise: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class ForEach:
    """Over the balls of a set; over the players where `over` is None."""

    at: Span
    over: Expr | None
    body: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class Choice:
    at: Span
    option: str
    condition: Expr | None
    body: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class OfferChoices:
    at: Span
    who: Expr
    choices: tuple[Choice, ...]


Action = (
    Foul | Award | Write | Turn | GoToPhase | SpotBalls | RemoveBalls | RackAgain | RestoreTable
    | GiveInHand | Require | Win | Seat | Plays | NothingHappens
)  # fmt: skip
Statement = Action | If | ForEach | OfferChoices


@dataclass(frozen=True, slots=True)
class Rule:
    """A rule with its section (`fouls`, `game start` ...); a bare rule has no name."""

    at: Span
    name: str
    section: str | None
    phases: tuple[str, ...]
    cites: tuple[str, ...]
    overrides: tuple[tuple[str, Span], ...]
    body: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class Track:
    at: Span
    name: str
    units: tuple[str, ...]
    start: Expr | None


@dataclass(frozen=True, slots=True)
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


@dataclass(frozen=True, slots=True)
class Home:
    at: Span
    balls: Expr
    spot: str


@dataclass(frozen=True, slots=True)
class Define:
    """Cases of condition and value; a plain define has one case without a condition."""

    at: Span
    name: str
    frozen: bool
    cases: tuple[tuple[Expr | None, Expr], ...]


@dataclass(frozen=True, slots=True)
class Header:
    """`language`, `game`, `cites`, `uses`, `spotting` or `settled` with its text."""

    at: Span
    word: str
    text: str


@dataclass(frozen=True, slots=True)
class Phases:
    at: Span
    names: tuple[tuple[str, Span], ...]


Declaration = Header | Phases | Track | Fact | Home | Define


@dataclass(frozen=True, slots=True)
class Script:
    """One file: its declarations and rules in the order of the text."""

    file: str
    source: str
    declarations: tuple[Declaration, ...]
    rules: tuple[Rule, ...]


def walk(body: tuple[Any, ...]) -> list[Any]:
    """Return every statement and choice inside a body."""
    found: list[Any] = []
    for node in body:
        found.append(node)
        match node:
            case If():
                for _, inner in node.branches:
                    found.extend(walk(inner))
                found.extend(walk(node.otherwise))
            case ForEach():
                found.extend(walk(node.body))
            case OfferChoices():
                for choice in node.choices:
                    found.append(choice)
                    found.extend(walk(choice.body))
            case _:
                pass
    return found
