"""How far a straight stroke goes before a cushion or a jaw stops it.

One idea: a ball is as far from a nose as its touch allows, so a nose grown by that much stops its
centre: a line moved aside, or a wider arc. Source: WPBSA S2 R17(e), cushions hide nothing.
"""

from __future__ import annotations

from math import atan2, cos, hypot, inf, sin, sqrt, tau
from typing import TYPE_CHECKING

from engine.table.furniture import Straight

if TYPE_CHECKING:
    from collections.abc import Iterable

    from engine.table.furniture import Curve, Point, Shape, Table

TINY = 1e-9


def noses_of(table: Table) -> tuple[Shape, ...]:
    """Return all noses of a table, those of the jaws included."""
    chains = (*(one.shapes for one in table.cushions), *(one.shapes for one in table.jaws))
    return tuple(shape for chain in chains for shape in chain)


def lies_in_a_mouth(table: Table, at: Point, touch: float) -> bool:
    """Return whether a ball at `at` (m) is nearer to the noses' lines than its `touch` (m) allows.

    Only in the mouth of a pocket it can be; from elsewhere to elsewhere no nose is in the way.
    """
    x, y = at
    return abs(x) > table.length / 2 - touch + TINY or abs(y) > table.width / 2 - touch + TINY


def reach_of_nose(origin: Point, heading: float, noses: Iterable[Shape], touch: float) -> float:
    """Return how far (m) a ball goes along `heading` (rad) before it meets a nose."""
    way = (cos(heading), sin(heading))
    return min((_reach(origin, way, shape, touch) for shape in noses), default=inf)


def _reach(origin: Point, way: Point, shape: Shape, touch: float) -> float:
    if isinstance(shape, Straight):
        return _to_straight(origin, way, shape, touch)
    return _to_curve(origin, way, shape, touch)


def _to_straight(origin: Point, way: Point, nose: Straight, touch: float) -> float:
    (x, y), (u, v) = nose.start, nose.end
    length = hypot(u - x, v - y)
    if length < TINY:
        return inf
    ax, ay = (u - x) / length, (v - y) / length
    aside = (origin[1] - y) * ax - (origin[0] - x) * ay  # the bed lies on the left
    closing = way[0] * ay - way[1] * ax
    if aside < 0.0 or closing <= TINY:
        return inf
    far = max((aside - touch) / closing, 0.0)
    along = (origin[0] + far * way[0] - x) * ax + (origin[1] + far * way[1] - y) * ay
    return far if -TINY <= along <= length + TINY else inf


def _to_curve(origin: Point, way: Point, nose: Curve, touch: float) -> float:
    if nose.sweep > 0.0:  # the bed lies inside: a round table, where a chord meets no nose
        return inf
    (u, v), span = nose.centre, nose.radius + touch
    x, y = origin[0] - u, origin[1] - v
    ahead, beyond = x * way[0] + y * way[1], x * x + y * y - span * span
    square = ahead * ahead - beyond
    if ahead >= -TINY or square <= 0.0:
        return inf
    far = max(-ahead - sqrt(square), 0.0)
    return far if _on_arc(nose, x + far * way[0], y + far * way[1]) else inf


def _on_arc(nose: Curve, x: float, y: float) -> bool:
    turned = (nose.start - atan2(y, x)) % tau
    return turned <= -nose.sweep + TINY or turned >= tau - TINY
