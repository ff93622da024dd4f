"""What the host tells the rules about one shot: values in.

One idea: a Situation is all that is known before the stroke, a Shot what was announced and
happened, and Rest what is known when the balls are still. Whatever is not known is absent,
and a predicate on what nobody gave is false. Players count from 1.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field
from types import MappingProxyType
from typing import TYPE_CHECKING

from rulelang.frozen import value

if TYPE_CHECKING:
    from collections.abc import Set as AbstractSet

    from rulelang.account import Account
    from rulelang.decisions import TableAction
    from rulelang.events import Event
    from rulelang.vocabulary import Tracked, Value

Predicate = Callable[[frozenset[str], "tuple[TableAction, ...]", str | None], "Value | None"]

Nothing: Mapping[str, Value] = MappingProxyType({})


@value
class Situation:
    """The game before a shot.

    `frozen` holds pairs (ball, ball) and (ball, "cushion NAME"); `zones` says in which zones
    a ball stands; `fallen` are the pins that do not stand; `in_hand` is the zone that the
    shooter's cue ball is in hand in.
    `eliminated` are players out of the game. `options` may be chosen from before this shot.
    `seed` is where all chance comes from. `games` counts the games of the match that are over,
    `winner` is who won the last of them, 0 where nobody did.
    """

    players: int
    shooter: int
    phase: str
    scores: tuple[int, ...]
    on_table: frozenset[str]
    state: Mapping[str, Tracked]
    settings: Mapping[str, Value] = field(default_factory=lambda: Nothing)
    in_hand: str | None = None
    zones: Mapping[str, AbstractSet[str]] = field(default_factory=dict)
    frozen: AbstractSet[tuple[str, str]] = frozenset()
    fallen: frozenset[str] = frozenset()
    options: tuple[str, ...] = ()
    breaker: int = 1
    eliminated: frozenset[int] = frozenset()
    seed: int = 0
    games: int = 0
    winner: int = 0


@value
class Call:
    """What was announced; a nominated ball has no pocket."""

    ball: str | None = None
    pocket: str | None = None
    safety: bool = False
    group: str | None = None


@value
class Rest:
    """The table at rest, before the referee touches a ball; `spots` says who covers a spot."""

    zones: Mapping[str, AbstractSet[str]] = field(default_factory=dict)
    frozen: AbstractSet[tuple[str, str]] = frozenset()
    spots: Mapping[str, str] = field(default_factory=dict)


@value
class Shot:
    """One shot as the rules see it.

    `struck` is the ball the tip struck, which the script calls the cue ball. `facts` holds
    what an eye judged. `predicates` supplies, from positions, a fact that nobody stated: by the
    predicate's name a function of the set of balls it is asked on, of the table actions decided
    so far, and of the zone that a cue ball off the bed is played from; None where the positions
    are not known. `placed` says in which zones the
    ball in hand was put, None where that is not known. `account` are the events sorted, where
    the host has already done so. Where nothing is `located`, no place of a ball is known, and
    predicates are asked only of balls that were spotted since.
    """

    struck: str
    events: tuple[Event, ...]
    call: Call = Call()
    chosen: str | None = None
    facts: Mapping[str, Value] = field(default_factory=lambda: Nothing)
    predicates: Mapping[str, Predicate] = field(default_factory=dict)
    placed: AbstractSet[str] | None = None
    rest: Rest = Rest()
    account: Account | None = field(default=None, compare=False, repr=False)
    located: bool = True
