# ruff: noqa: D101 - a class here is its construct, and the grammar tells what it is
"""What a rule says is to be done, as written.

One idea: an `Action` does one thing, and only branches, loops and offers hold other statements.
Invariant: `walk` meets every statement and choice once, in the order of the text.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang.frozen import value

if TYPE_CHECKING:
    from rulelang.syntax.expressions import Expr
    from rulelang.syntax.places import Span


@value
class Foul:
    at: Span
    name: str
    worth: Expr | None
    alone: bool


@value
class Award:
    """`award` or `deduct`."""

    at: Span
    verb: str
    amount: Expr
    who: Expr


@value
class Write:
    """`add`, `set`, `reset` or `assign`, to a tracked value."""

    at: Span
    verb: str
    name: str
    who: Expr | None
    value: Expr | None


@value
class Turn:
    at: Span
    continues: bool
    who: Expr | None


@value
class GoToPhase:
    at: Span
    phase: str


@value
class PlaceAt:
    """One place of a `spot`.

    Kinds are at, home, occupant, own, highest-free, lay, later, near, near-own.
    """

    at: Span
    kind: str
    spot: str | None = None
    toward: str = "foot"


@value
class SpotBalls:
    at: Span
    balls: Expr
    places: tuple[PlaceAt, ...]


@value
class RemoveBalls:
    at: Span
    balls: Expr


@value
class SetUpPins:
    at: Span
    pins: Expr


@value
class RackAgain:
    at: Span
    keeping: Expr | None


@value
class RestoreTable:
    at: Span


@value
class GiveInHand:
    at: Span
    who: Expr
    zone: str | None


@value
class Require:
    """`require` or `allow` a call."""

    at: Span
    verb: str
    what: str
    who: Expr


@value
class AllowStrike:
    """`allow BALLS as cue ball`."""

    at: Span
    balls: Expr


@value
class Win:
    """`wins`, `loses` or `tie` of a unit."""

    at: Span
    verb: str
    who: Expr | None
    unit: str


@value
class Seat:
    """`eliminate` or `reinstate` a player."""

    at: Span
    verb: str
    who: Expr


@value
class Plays:
    at: Span
    who: Expr


@value
class NothingHappens:
    at: Span


@value
class If:
    """Branches of condition and body, tried in order, and the body of `otherwise`."""

    at: Span
    branches: tuple[tuple[Expr, tuple[Statement, ...]], ...]
    otherwise: tuple[Statement, ...]


@value
class ForEach:
    """Over the balls of a set; over the players where `over` is None."""

    at: Span
    over: Expr | None
    body: tuple[Statement, ...]


@value
class Choice:
    at: Span
    option: str
    condition: Expr | None
    body: tuple[Statement, ...]


@value
class OfferChoices:
    at: Span
    who: Expr
    choices: tuple[Choice, ...]


Action = (
    Foul | Award | Write | Turn | GoToPhase | SpotBalls | RemoveBalls | SetUpPins | RackAgain
    | RestoreTable | GiveInHand | Require | AllowStrike | Win | Seat | Plays | NothingHappens
)  # fmt: skip
Statement = Action | If | ForEach | OfferChoices


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
