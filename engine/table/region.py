"""The bed as a region of the plane: inside or outside, how far from the noses, posts and holes.

One idea: a closed chain of straight and round noses winds round its inside; the chords wind as a
polygon does, and each arc adds or takes away the sliver between itself and its chord.
Invariant: a table without an outline of its own is the rectangle of its length and width.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, hypot, isclose, pi, sin, sqrt, tau
from typing import TYPE_CHECKING

from engine.table.furniture import Curve, Straight
from engine.table.pin import meeting

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from engine.table.furniture import CushionId, Pocket, Point, Shape, Table

_SLACK = 1e-9


@dataclass(frozen=True, slots=True)
class Post:
    """A round body that stands on the bed; it is a cushion to the balls and to the records."""

    id: CushionId
    centre: Point
    radius: float
    upright: bool = False


def posts_of(table: Table) -> tuple[Post, ...]:
    """Return the posts: the cushions that are a whole circle with the bed outside."""
    found = []
    for cushion in table.cushions:
        shape = cushion.shapes[0]
        if isinstance(shape, Curve) and len(cushion.shapes) == 1 and isclose(shape.sweep, -tau):
            found.append(Post(cushion.id, shape.centre, shape.radius, cushion.upright))
    return tuple(found)


def is_hole(pocket: Pocket) -> bool:
    """Tell whether a pocket is a hole in the bed: its mouth lies across its own middle."""
    (ax, ay), (bx, by) = pocket.mouth
    away = hypot((ax + bx) / 2.0 - pocket.centre[0], (ay + by) / 2.0 - pocket.centre[1])
    return away <= _SLACK


def is_inside(outline: Iterable[Shape], point: Point) -> bool:
    """Tell whether a point (m) lies inside a closed chain that has its inside on the left.

    A point on the chain itself may be told either way.
    """
    turns = 0.0
    for shape in outline:
        start, end = ends(shape)
        ax, ay = start[0] - point[0], start[1] - point[1]
        bx, by = end[0] - point[0], end[1] - point[1]
        left = ax * by - ay * bx + 0.0
        turns += atan2(left, ax * bx + ay * by)
        if isinstance(shape, Curve):
            away = hypot(point[0] - shape.centre[0], point[1] - shape.centre[1])
            between = left < 0.0 if shape.sweep > 0.0 else left >= 0.0
            if between and away <= shape.radius:
                turns += tau if shape.sweep > 0.0 else -tau
    return turns > pi


def ends(shape: Shape) -> tuple[Point, Point]:
    """Return where a nose begins and ends (m)."""
    if isinstance(shape, Straight):
        return shape.start, shape.end
    return on_arc(shape, 0.0), on_arc(shape, 1.0)


def on_arc(shape: Curve, share: float) -> Point:
    """Return the point of an arc at a share of its sweep, 0 to 1."""
    angle = shape.start + share * shape.sweep
    return (
        shape.centre[0] + shape.radius * cos(angle),
        shape.centre[1] + shape.radius * sin(angle),
    )


def distance_to(shape: Shape, point: Point) -> float:
    """Return how far (m) a point is from a nose."""
    if isinstance(shape, Straight):
        (ax, ay), (bx, by) = shape.start, shape.end
        dx, dy = bx - ax, by - ay
        share = ((point[0] - ax) * dx + (point[1] - ay) * dy) / (dx * dx + dy * dy)
        share = min(max(share, 0.0), 1.0)
        return hypot(point[0] - ax - share * dx, point[1] - ay - share * dy)
    dx, dy = point[0] - shape.centre[0], point[1] - shape.centre[1]
    if sweeps_over(shape, atan2(dy, dx)):
        return abs(hypot(dx, dy) - shape.radius)
    return min(hypot(point[0] - x, point[1] - y) for x, y in ends(shape))


def sweeps_over(shape: Curve, angle: float) -> bool:
    """Tell whether an arc passes a direction (rad) from its centre."""
    turn = (angle - shape.start) if shape.sweep > 0.0 else (shape.start - angle)
    turn %= tau
    return turn <= abs(shape.sweep) + _SLACK or turn >= tau - _SLACK


def bounds(outline: Iterable[Shape]) -> tuple[float, float, float, float]:
    """Return the least and greatest x and y (m) of a chain: x0, y0, x1, y1."""
    xs, ys = [], []
    for shape in outline:
        points = list(ends(shape))
        if isinstance(shape, Curve):
            (x, y), r = shape.centre, shape.radius
            quarters = ((x + r, y), (x, y + r), (x - r, y), (x, y - r))
            points += [p for k, p in enumerate(quarters) if sweeps_over(shape, k * pi / 2.0)]
        xs += [p[0] for p in points]
        ys += [p[1] for p in points]
    return min(xs), min(ys), max(xs), max(ys)


def on_bed(table: Table, point: Point, slack: float = 0.0) -> bool:
    """Tell whether a point (m) lies within the noses, or outside them by `slack` at most."""
    if abs(point[0]) > table.length / 2 + slack or abs(point[1]) > table.width / 2 + slack:
        return False
    if not table.outline:
        return True
    return is_inside(table.outline, point) or (
        min(distance_to(shape, point) for shape in table.outline) <= slack
    )


def nose_reach(radius: float, nose_height: float) -> float:
    """Return how far (m) over the bed a ball's centre is from a nose that it touches.

    The nose meets the ball above or below its equator: R cos(theta), of WPBSA and WPA tables one
    to two millimetres less than R.
    """
    return sqrt(max(radius**2 - (nose_height - radius) ** 2, 0.0))


def has_room(table: Table, point: Point, radius: float) -> bool:
    """Tell whether a ball of `radius` (m) can lie at a point, clear of noses and all bodies.

    It may touch them. Over a drop it cannot lie; jaws need no look, they stand behind the noses.
    """
    reach = nose_reach(radius, table.nose_height)
    if (
        abs(point[0]) > table.length / 2 - reach + _SLACK
        or abs(point[1]) > table.width / 2 - reach + _SLACK
    ):
        return False
    if table.outline and not (
        is_inside(table.outline, point)
        and all(distance_to(shape, point) >= reach - _SLACK for shape in table.outline)
    ):
        return False
    if any(_away(point, drop.centre) < drop.radius - _SLACK for drop in table.pockets):
        return False
    return all(_away(point, at) >= keep - _SLACK for at, keep in obstacles(table, radius))


def obstacles(table: Table, radius: float) -> list[tuple[Point, float]]:
    """Return what a ball of `radius` (m) cannot lie on: centres, and how far it keeps away."""
    nosed = nose_reach(radius, table.nose_height)
    posts = [
        (post.centre, post.radius + (radius if post.upright else nosed)) for post in posts_of(table)
    ]
    pins = [(pin.at, meeting(pin.profile, radius)[0]) for pin in table.pins]
    return posts + pins + [(p.centre, p.radius) for p in table.pockets if is_hole(p)]


def trace(outline: Sequence[Shape], step: float = 0.05) -> list[Point]:
    """Return points along a closed chain, the first not repeated; `step` (rad) along arcs."""
    points: list[Point] = []
    for shape in outline:
        points.append(ends(shape)[0])
        if isinstance(shape, Curve):
            count = max(2, int(abs(shape.sweep) / step + 0.999))
            points += [on_arc(shape, k / count) for k in range(1, count)]
    return points


def span_at(table: Table, axis: int, value: float) -> tuple[float, float] | None:
    """Return where a line across the table first and last meets the noses.

    The line has x = `value` (m) for axis 0, y = `value` for axis 1; the answer is in the other
    coordinate, None where the line misses the bed.
    """
    size = (table.length, table.width)
    if not table.outline:
        half = size[1 - axis] / 2.0
        return (-half, half) if abs(value) <= size[axis] / 2.0 + _SLACK else None
    found = [at for shape in table.outline for at in _meetings(shape, axis, value)]
    return (min(found), max(found)) if found else None


def _meetings(shape: Shape, axis: int, value: float) -> list[float]:
    if isinstance(shape, Straight):
        a, b = shape.start, shape.end
        if min(a[axis], b[axis]) - _SLACK > value or max(a[axis], b[axis]) + _SLACK < value:
            return []
        if abs(b[axis] - a[axis]) < _SLACK:
            return [a[1 - axis], b[1 - axis]]
        share = (value - a[axis]) / (b[axis] - a[axis])
        return [a[1 - axis] + share * (b[1 - axis] - a[1 - axis])]
    away = value - shape.centre[axis]
    if abs(away) > shape.radius:
        return []
    half = sqrt(shape.radius**2 - away**2)
    found = []
    for other in (-half, half):
        direction = (away, other) if axis == 0 else (other, away)
        if sweeps_over(shape, atan2(direction[1], direction[0])):
            found.append(shape.centre[1 - axis] + other)
    return found


def _away(a: Point, b: Point) -> float:
    return hypot(a[0] - b[0], a[1] - b[1])


__all__ = [
    "Post",
    "bounds",
    "distance_to",
    "ends",
    "has_room",
    "is_hole",
    "is_inside",
    "nose_reach",
    "obstacles",
    "on_arc",
    "on_bed",
    "posts_of",
    "span_at",
    "sweeps_over",
    "trace",
]
