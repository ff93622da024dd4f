"""The table at rest after a stroke, before the referee touches a ball.

One idea: a ball whose place was told lies there; one that no event names lies as before; and of
any other it is known only what events say. Zones and contacts that places show are not kept here.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from engine.game.contacts import ZonesAt
from engine.game.situation import Rest
from engine.table.furniture import BallId, PinId, ZoneId
from rulelang.account import ENTERED, FELL, LEANED, LEFT_ZONE
from rulelang.closures import singles

if TYPE_CHECKING:
    from collections.abc import Mapping
    from collections.abc import Set as AbstractSet

    from engine.game.shot import Shot
    from engine.game.situation import Situation
    from engine.table.furniture import Point
    from engine.variant.variant import Variant
    from rulelang.account import Account

NOBODY: frozenset[BallId] = frozenset()
NOTHING_KNOWN = Rest()
OF_PLACES = 1 << ENTERED | 1 << LEFT_ZONE | 1 << FELL | 1 << LEANED
"""What tells of places where none are known."""


def balls_in(variant: Variant, mask: int) -> frozenset[BallId]:
    """Return the balls of a set that the rules hold as bits."""
    names = variant.program.names
    return frozenset(BallId(names[bit]) for bit in singles(mask)) if mask else NOBODY


def rest_after(
    variant: Variant, before: Situation, shot: Shot, account: Account, down: frozenset[BallId]
) -> Rest:
    """Return what is known of the balls at rest after the shot, `down` being off the bed."""
    was, told = before.rest, shot.after
    if was == told == NOTHING_KNOWN and not account.happened & OF_PLACES:
        return was
    stirred = down
    if was.positions or was.frozen or was.covered:
        stirred = down | balls_in(variant, account.named)
    positions = {ball: at for ball, at in was.positions.items() if ball not in stirred}
    positions.update(told.positions)
    for ball in down & positions.keys():
        del positions[ball]
    kept = frozenset(pair for pair in was.frozen if stirred.isdisjoint(pair))
    covered = {spot: ball for spot, ball in was.covered.items() if ball not in stirred}
    return Rest(
        positions,
        _zones(variant, was, positions, account, down),
        told.frozen if told.positions else told.frozen | kept,
        {**covered, **told.covered},
        was.fallen | _pins_down(variant, account),
    )


def _zones(
    variant: Variant,
    was: Rest,
    positions: Mapping[BallId, Point],
    account: Account,
    down: frozenset[BallId],
) -> Mapping[BallId, AbstractSet[ZoneId]]:
    """Return the zones of balls whose places are not known now: as before, and as events say."""
    table, names = variant.world.table, variant.program.names
    zones = dict(was.zones)
    zones.update(
        (ball, ZonesAt(table, was.positions[ball])) for ball in was.positions.keys() - positions
    )
    moves = [(number, bit, zone, True) for number, bit, zone in account.ev[ENTERED]]
    moves += [(number, bit, zone, False) for number, bit, zone in account.ev[LEFT_ZONE]]
    for _, bit, zone, entered in sorted(moves):
        ball, there = BallId(names[bit]), frozenset({ZoneId(zone)})
        standing = zones.get(ball, frozenset())
        zones[ball] = standing | there if entered else standing - there
    for ball in (positions.keys() | down) & zones.keys():
        del zones[ball]
    return zones


def _pins_down(variant: Variant, account: Account) -> frozenset[PinId]:
    """Return the pins that a stroke made fall, those that lean on a ball too."""
    mask = account.seen[FELL] | account.seen[LEANED]
    return frozenset(PinId(name) for name in balls_in(variant, mask))
