"""The game between two shots: one value that holds all that is known.

One idea: a Situation is complete, so undo, resume, replay and records are the same mechanism.
Invariant: whatever is not known (places of balls in a record without positions) is absent,
never guessed. Players count from 1.
"""

from __future__ import annotations

from dataclasses import field
from types import MappingProxyType
from typing import TYPE_CHECKING

from engine.table.marks import contains
from rulelang.frozen import value

if TYPE_CHECKING:
    from collections.abc import Mapping
    from collections.abc import Set as AbstractSet

    from engine.table.furniture import BallId, PinId, Point, SpotId, Table, ZoneId
    from engine.variant.variant import Value, Variant
    from rulelang import facts as said
    from rulelang.decisions import Offer
    from rulelang.vocabulary import Tracked

TOUCHING = 2e-5
"""Balls, or a ball and a nose, that lie closer than this (m) are frozen to each other."""

Pair = tuple[str, str]
"""Two things that touch: (ball, ball) or (ball, "cushion NAME")."""


def empty() -> Mapping:  # type: ignore[type-arg]
    """Return a mapping that holds nothing and stays so."""
    return MappingProxyType({})


@value
class Rest:
    """What is known of the balls at rest, as far as it is known.

    `positions` in metres; `zones` the zones that a ball of which no position is known stands in;
    `frozen` who touches whom, beside what positions show; `covered` the spots on which no ball
    can be put, by the ball that stands there; `fallen` the pins that do not stand.
    """

    positions: Mapping[BallId, Point] = field(default_factory=empty)
    zones: Mapping[BallId, AbstractSet[ZoneId]] = field(default_factory=empty)
    frozen: frozenset[Pair] = frozenset()
    covered: Mapping[SpotId, BallId] = field(default_factory=empty)
    fallen: frozenset[PinId] = frozenset()


@value
class Judged:
    """The shot that was judged last, as the rules saw it: consequences of a choice ask for it."""

    situation: said.Situation
    shot: said.Shot
    before: Situation


@value
class Situation:
    """The game before a shot; `seed` is the match's, `shots` how many were judged before.

    `in_hand` is the zone in which the shooter's cue ball is in hand. `offers` is what the
    shooter may choose from before the shot; `strikable` are the balls that he may strike, none
    where it is his cue ball alone. `winner` is None while the game goes on, 0 for a
    draw; `match_over` says whether the match ended with it. `games` counts the games of the match
    before this one, `won_last` is who won the last of them, 0 where nobody did.
    """

    players: int
    shooter: int
    phase: str
    scores: tuple[int, ...]
    on_table: frozenset[BallId]
    state: Mapping[str, Tracked]
    settings: Mapping[str, Value]
    rest: Rest = Rest()
    in_hand: ZoneId | None = None
    offers: tuple[Offer, ...] = ()
    breaker: int = 1
    eliminated: frozenset[int] = frozenset()
    seed: int = 0
    shots: int = 0
    games: int = 0
    won_last: int = 0
    winner: int | None = None
    match_over: bool = False
    judged: Judged | None = None
    strikable: frozenset[BallId] = frozenset()

    @property
    def options(self) -> tuple[str, ...]:
        """The names of the options on offer, in the order of the script."""
        return tuple(dict.fromkeys(offer.option for offer in self.offers))

    @property
    def over(self) -> bool:
        """Whether the game (rack, frame, set) has ended."""
        return self.winner is not None


def cue_ball_of(variant: Variant, player: int) -> BallId:
    """Return the cue ball of a player: the one that serves all, or his own."""
    balls = variant.cue_balls
    return balls[(player - 1) % len(balls)]


def ball_to_strike(variant: Variant, situation: Situation) -> BallId:
    """Return the ball that the tip strikes unless a shot names another.

    That is the shooter's cue ball, or the first of those he may strike where it is not among
    them or gone.
    """
    cue = cue_ball_of(variant, situation.shooter)
    if cue in situation.on_table and cue in (situation.strikable or {cue}):
        return cue
    return next((kind.id for kind in variant.balls if kind.id in situation.strikable), cue)


def zones_of(table: Table, point: Point) -> frozenset[ZoneId]:
    """Return every zone of the table that holds `point` (m)."""
    return frozenset(name for name, zone in table.zones.items() if contains(zone, point, table))
