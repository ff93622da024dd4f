"""Where on the bed there is room for a ball that comes back.

One idea: a place is asked for from a spot on, straight towards a cushion or any way, and every
other ball is a centre and a radius. Invariant: no place overlaps a ball, a nose or a post.
"""

from __future__ import annotations

from math import hypot, sqrt
from typing import TYPE_CHECKING

from engine.geometry.vectors import distance, dot
from engine.table.region import has_room, obstacles

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from engine.table.furniture import Point, Table

FINE = 50
_ROUND = 1e-12


def spot_is_free(
    point: Point, radius: float, others: Iterable[tuple[Point, float]], gap: float = 0.0
) -> bool:
    """Tell whether a ball can stand at `point` with `gap` (m) to each of the others.

    `others` are centres and radii. With no gap, touching is allowed.
    """
    return all(distance(point, other) >= radius + size + gap - 1e-9 for other, size in others)


def nearest_place(
    table: Table,
    spot: Point,
    toward: Point,
    radius: float,
    others: Iterable[tuple[Point, float]],
    gap: float = 0.0,
) -> Point | None:
    """Return the place nearest to `spot`, on the straight way `toward`, where a ball can stand.

    The ball keeps `gap` (m) to every other ball (centre, radius), lies wholly on the bed and on
    no post or hole; None where the way to the cushion has no room. Sources: WPA 2025 1.5; WPBSA
    section 3 rule 7.
    """
    long = hypot(*toward)
    way = toward[0] / long, toward[1] / long
    covered = sorted(
        interval
        for other, reach in (
            *((other, radius + size + gap) for other, size in others),
            *obstacles(table, radius),
        )
        if (interval := _covered(spot, way, other, reach)) is not None
    )
    at = 0.0
    for low, high in covered:
        if low + _ROUND < at < high - _ROUND:
            at = high
    place = spot[0] + way[0] * at, spot[1] + way[1] * at
    return place if has_room(table, place, radius) else None


def _covered(spot: Point, way: Point, other: Point, reach: float) -> tuple[float, float] | None:
    """Return the stretch of a way, in metres from the spot, that is nearer than `reach`."""
    away = other[0] - spot[0], other[1] - spot[1]
    along, across = dot(way, away), way[0] * away[1] - way[1] * away[0]
    if abs(across) >= reach - _ROUND:
        return None
    half = sqrt(reach * reach - across * across)
    return along - half, along + half


def free_place(
    table: Table,
    spot: Point,
    ways: Sequence[Point],
    radius: float,
    others: Sequence[tuple[Point, float]],
    gap: float = 0.0,
) -> Point | None:
    """Return `nearest_place` along the first of `ways` that has room, or None."""
    for way in ways:
        place = nearest_place(table, spot, way, radius, others, gap)
        if place is not None:
            return place
    return None


def nearest_room(
    table: Table,
    spot: Point,
    radius: float,
    others: Sequence[tuple[Point, float]],
    gap: float = 0.0,
) -> Point | None:
    """Return the place nearest to `spot` where a ball can stand, off every straight way.

    For beds of any outline; places are looked for on a grid of a fiftieth of the bed.
    """
    steps = [k / FINE - 0.5 for k in range(1, FINE)]
    places = [(a * table.length, b * table.width) for a in steps for b in steps]
    for place in sorted(places, key=lambda at: distance(at, spot)):
        clear = all(distance(place, at) >= radius + size + gap for at, size in others)
        if clear and has_room(table, place, radius):
            return place
    return None
