"""The round of a corner between two noses, straight or curved: one arc, tangent to both.

One idea: the arc's centre lies on both noses moved aside by its radius, so it is where two lines
or circles meet, the nearest such point to the corner.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, hypot, sqrt, tau
from typing import TYPE_CHECKING

from engine.table.furniture import Curve, Straight
from engine.table.mouth import length_of, point_along
from engine.table.region import ends

if TYPE_CHECKING:
    from engine.table.furniture import Point, Shape


@dataclass(frozen=True, slots=True)
class Rounding:
    """The arc, and how much (m) it takes of the nose before it and the one after it."""

    arc: Curve
    before: float
    after: float


def round_corner(before: Shape, after: Shape, radius: float, turn: float) -> Rounding | None:
    """Return the round of `radius` (m) between two noses that meet, None where none fits.

    `turn` (rad) is how the chain turns at the corner; the round lies on the side it turns to.
    """
    hand = 1.0 if turn > 0.0 else -1.0
    corner = ends(before)[1]
    centres = [
        centre
        for centre in _meetings(before, after, hand * radius)
        if _from_end(before, centre) is not None and _from_start(after, centre) is not None
    ]
    if not centres:
        return None
    centre = min(centres, key=lambda c: hypot(c[0] - corner[0], c[1] - corner[1]))
    taken, left = _from_end(before, centre), _from_start(after, centre)
    if taken is None or left is None:
        return None
    first = point_along(before, length_of(before) - taken)[0]
    last = point_along(after, left)[0]
    start = atan2(first[1] - centre[1], first[0] - centre[0])
    sweep = (hand * (atan2(last[1] - centre[1], last[0] - centre[0]) - start)) % tau
    return Rounding(Curve(centre, radius, start, hand * sweep), taken, left)


def _from_start(shape: Shape, centre: Point) -> float | None:
    """Return how far along a nose (m) the foot of `centre` lies, None where it is beyond."""
    if isinstance(shape, Straight):
        way = point_along(shape, 0.0)[1]
        at = (centre[0] - shape.start[0]) * way[0] + (centre[1] - shape.start[1]) * way[1]
    else:
        hand = 1.0 if shape.sweep > 0.0 else -1.0
        angle = atan2(centre[1] - shape.centre[1], centre[0] - shape.centre[0])
        at = ((hand * (angle - shape.start)) % tau) * shape.radius
    return at if 0.0 <= at <= length_of(shape) else None


def _from_end(shape: Shape, centre: Point) -> float | None:
    at = _from_start(shape, centre)
    return None if at is None else length_of(shape) - at


def _meetings(one: Shape, two: Shape, aside: float) -> list[Point]:
    """Return where two noses meet when both are moved `aside` (m) to their left."""
    if isinstance(one, Straight) and isinstance(two, Straight):
        return _lines(*_moved(one, aside), *_moved(two, aside))
    if isinstance(one, Curve) and isinstance(two, Curve):
        return _circles(one.centre, _grown(one, aside), two.centre, _grown(two, aside))
    line, curve = (one, two) if isinstance(one, Straight) else (two, one)
    if isinstance(line, Straight) and isinstance(curve, Curve):
        return _line_circle(*_moved(line, aside), curve.centre, _grown(curve, aside))
    return []


def _moved(line: Straight, aside: float) -> tuple[Point, Point]:
    way = point_along(line, 0.0)[1]
    return (line.start[0] - aside * way[1], line.start[1] + aside * way[0]), way


def _grown(curve: Curve, aside: float) -> float:
    """Return the radius of an arc moved to its left: smaller where it turns left."""
    return curve.radius - aside if curve.sweep > 0.0 else curve.radius + aside


def _lines(p: Point, u: Point, q: Point, v: Point) -> list[Point]:
    cross = u[0] * v[1] - u[1] * v[0]
    if abs(cross) < 1e-12:
        return []
    s = ((q[0] - p[0]) * v[1] - (q[1] - p[1]) * v[0]) / cross
    return [(p[0] + s * u[0], p[1] + s * u[1])]


def _line_circle(p: Point, u: Point, centre: Point, radius: float) -> list[Point]:
    dx, dy = centre[0] - p[0], centre[1] - p[1]
    along, across = dx * u[0] + dy * u[1], dx * u[1] - dy * u[0]
    square = radius * radius - across * across
    if radius <= 0.0 or square < 0.0:
        return []
    half = sqrt(square)
    return [(p[0] + s * u[0], p[1] + s * u[1]) for s in (along - half, along + half)]


def _circles(a: Point, r: float, b: Point, s: float) -> list[Point]:
    dx, dy = b[0] - a[0], b[1] - a[1]
    apart = hypot(dx, dy)
    if r <= 0.0 or s <= 0.0 or apart < 1e-12:
        return []
    along = (apart * apart + r * r - s * s) / (2.0 * apart)
    square = r * r - along * along
    if square < 0.0:
        return []
    ux, uy, half = dx / apart, dy / apart, sqrt(square)
    return [(a[0] + along * ux - h * uy, a[1] + along * uy + h * ux) for h in (half, -half)]


__all__ = ["Rounding", "round_corner"]
