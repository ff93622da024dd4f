"""Where balls lie after a stroke that was made up, and where a ball in hand is put.

One idea: a place is drawn by lot and kept where the referee would let a ball lie there.
Invariant: no ball lies in another; without room nothing is said of places.
"""

from __future__ import annotations

from math import hypot
from typing import TYPE_CHECKING

from engine.game.placing import refuse_place
from engine.table.furniture import Area, BallId, Disc, Places

if TYPE_CHECKING:
    from random import Random

    from engine.game.situation import Situation
    from engine.table.furniture import Point, Table, Zone
    from engine.variant.variant import Variant

PLACED = 0.3
"""The share of balls in hand of which it is told where they were put."""
DRAWN = 4
"""So many places are looked at for a ball in hand before nothing is said of its place."""


def anywhere(variant: Variant, balls: list[BallId], rng: Random) -> dict[BallId, Point] | None:
    """Return places (m) on the bed for the balls, none over another; None where there is no room.

    Now and then a ball lies on one of the spots.
    """
    table = variant.world.table
    radii = {one.id: one.radius for one in variant.world.balls}
    spots = list(table.spots.values())
    lying: dict[BallId, Point] = {}
    for ball in balls:
        radius = radii[ball]
        wide, high = table.length / 2 - 2 * radius, table.width / 2 - 2 * radius
        for _ in range(50):
            at = (rng.uniform(-wide, wide), rng.uniform(-high, high))
            if spots and rng.random() < 0.2:
                at = rng.choice(spots)
            if all(
                hypot(at[0] - x, at[1] - y) > radius + radii[other] + 1e-4
                for other, (x, y) in lying.items()
            ):
                lying[ball] = at
                break
        else:
            return None
    return lying


def placement(variant: Variant, situation: Situation, rng: Random) -> Point | None:
    """Return where (m) the ball in hand was put, lawfully; None where nobody told."""
    if situation.in_hand is None or rng.random() >= PLACED:
        return None
    table = variant.world.table
    zone = table.zones[situation.in_hand]
    for _ in range(DRAWN):
        at = _drawn(zone, table, rng)
        if refuse_place(variant, situation, at) is None:
            return at
    return None


def _drawn(zone: Zone, table: Table, rng: Random) -> Point:
    """Return a place by lot in a zone or not far from it."""
    if isinstance(zone, Places):
        return rng.choice(zone.points)
    west, east, south, north = (
        -table.length / 2,
        table.length / 2,
        -table.width / 2,
        table.width / 2,
    )
    for part in zone.parts if isinstance(zone, Area) else ():
        if isinstance(part, Disc):
            (x, y), r = part.centre, part.radius
            west, east, south, north = (
                max(west, x - r),
                min(east, x + r),
                max(south, y - r),
                min(north, y + r),
            )
    return rng.uniform(west, east), rng.uniform(south, north)
