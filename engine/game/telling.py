"""The game in the language's own terms: what the rules are told of a situation and of a shot.

One idea: what is dear to work out, zones, contacts, covered spots, is worked out where a rule asks.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from engine.game.contacts import Later, ZonesAt, contacts_of, zones_by_ball
from engine.game.predicates import predicates_of
from engine.game.spotting import covers
from rulelang import facts as said

if TYPE_CHECKING:
    from collections.abc import Mapping
    from collections.abc import Set as AbstractSet

    from engine.game.shot import Shot
    from engine.game.situation import Rest, Situation
    from engine.table.furniture import BallId
    from engine.variant.variant import Variant
    from rulelang.account import Account


ALONE = 2
"""So many balls on the table need places that are known; one alone hides nothing."""


def as_rules_see(variant: Variant, situation: Situation) -> said.Situation:
    """Return the situation in the language's own terms."""
    rest = situation.rest
    return said.Situation(
        situation.players,
        situation.shooter,
        situation.phase,
        situation.scores,
        situation.on_table,
        situation.state,
        situation.settings,
        situation.in_hand,
        _zones(variant, rest),
        contacts_of(variant.world, rest),
        rest.fallen,
        situation.options if situation.offers else (),
        situation.breaker,
        situation.eliminated,
        situation.seed * 1_000_003 + situation.shots,
        situation.games,
        situation.won_last,
    )


def as_rules_hear(
    variant: Variant, before: Situation, shot: Shot, struck: BallId, account: Account, rest: Rest
) -> said.Shot:
    """Return the shot in the language's own terms; `rest` is how the balls lie after it."""
    world, placed = variant.world, shot.placement
    known = rest.positions or rest.covered
    return said.Shot(
        struck,
        shot.events or (),
        shot.call,
        shot.choice,
        shot.facts,
        predicates_of(variant, before, shot, rest),
        None if placed is None else ZonesAt(world.table, placed),
        said.Rest(
            _zones(variant, rest),
            contacts_of(world, rest),
            Later(lambda: covers(variant, rest)) if known else {},
        ),
        account,
        bool(before.rest.positions or rest.positions or len(before.on_table) < ALONE),
    )


def _zones(variant: Variant, rest: Rest) -> Mapping[str, AbstractSet[str]]:
    return cast("Mapping[str, AbstractSet[str]]", zones_by_ball(variant.world.table, rest))
