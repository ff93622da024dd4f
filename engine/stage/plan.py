"""Flat polygons seen from above: cut, spread, welded.

One idea: every polygon is convex and counter-clockwise, a list of points in m, so that cutting
by a line is all the geometry a table's picture needs.
"""

from __future__ import annotations

from math import cos, hypot, pi, sin
from typing import TYPE_CHECKING

import numpy as np

from engine.table.furniture import Straight

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from engine.table.furniture import Point, Shape

Polygon = list["Point"]
NEAR = 1e-7


def cut(polygon: Polygon, point: Point, normal: Point) -> Polygon:
    """Return the part of a convex polygon where (p - point) . normal <= 0; empty if none."""
    result: Polygon = []
    depths = [(p[0] - point[0]) * normal[0] + (p[1] - point[1]) * normal[1] for p in polygon]
    for i, here in enumerate(polygon):
        after, d, e = polygon[(i + 1) % len(polygon)], depths[i], depths[(i + 1) % len(polygon)]
        if d <= NEAR:
            result.append(here)
        if (d < -NEAR and e > NEAR) or (d > NEAR and e < -NEAR):
            share = d / (d - e)
            result.append(
                (here[0] + share * (after[0] - here[0]), here[1] + share * (after[1] - here[1]))
            )
    return result if area(result) > NEAR * NEAR else []


def area(polygon: Sequence[Point]) -> float:
    """Return the signed area (m^2), above zero where counter-clockwise."""
    total = 0.0
    for (ax, ay), (bx, by) in zip(polygon, (*polygon[1:], *polygon[:1]), strict=True):
        total += ax * by - bx * ay
    return total / 2.0


def rectangle(x0: float, y0: float, x1: float, y1: float) -> Polygon:
    """Return the rectangle between two corners."""
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def circle(centre: Point, radius: float, steps: int) -> Polygon:
    """Return the regular polygon of `steps` corners on a circle."""
    turns = [2.0 * pi * k / steps for k in range(steps)]
    return [(centre[0] + radius * cos(t), centre[1] + radius * sin(t)) for t in turns]


def wedges(polygon: Polygon, centre: Point, radius: float, steps: int) -> list[Polygon]:
    """Return convex pieces of `polygon` less a round hole, cut along rays from its centre."""
    pieces = []
    rim = circle(centre, radius, steps)
    for a, b in zip(rim, (*rim[1:], rim[0]), strict=True):
        piece = cut(polygon, centre, (a[1] - centre[1], centre[0] - a[0]))
        piece = piece and cut(piece, centre, (centre[1] - b[1], b[0] - centre[0]))
        piece = piece and cut(piece, a, (a[1] - b[1], b[0] - a[0]))
        if piece:
            pieces.append(piece)
    return pieces


def reaches(polygon: Polygon, centre: Point, radius: float) -> bool:
    """Return whether a circle and the box about a polygon overlap."""
    xs, ys = [p[0] for p in polygon], [p[1] for p in polygon]
    dx = max(min(xs) - centre[0], 0.0, centre[0] - max(xs))
    dy = max(min(ys) - centre[1], 0.0, centre[1] - max(ys))
    return hypot(dx, dy) < radius


def weld(polygons: list[Polygon]) -> list[Polygon]:
    """Return the polygons with every neighbour's corner on an edge made a corner there too.

    Without it, rounding to pixels would open cracks where three polygons meet.
    """
    keys = {(round(x / NEAR), round(y / NEAR)): (x, y) for poly in polygons for x, y in poly}
    corners = np.array(list(keys.values()))
    return [weld_to(polygon, corners) for polygon in polygons]


def weld_to(polygon: Polygon, corners: np.ndarray) -> Polygon:
    """Return the polygon with every one of `corners` (n, 2) that lies on an edge as its own."""
    result: Polygon = []
    for a, b in zip(polygon, (*polygon[1:], polygon[0]), strict=True):
        way = np.subtract(b, a)
        length = float(np.hypot(*way))
        offsets = corners - a
        along = offsets @ way / length
        aside = np.abs(offsets[:, 0] * way[1] - offsets[:, 1] * way[0]) / length
        on = np.flatnonzero((aside < 1e-6) & (along > 1e-6) & (along < length - 1e-6))
        result.append(a)
        result.extend(
            (float(corners[i][0]), float(corners[i][1])) for i in on[np.argsort(along[on])]
        )
    return result


def trace_shapes(shapes: Iterable[Shape], step: float) -> list[Point]:
    """Return points along noses and jaws, a curve in turns of at most `step` (rad)."""
    points: list[Point] = []
    for shape in shapes:
        if isinstance(shape, Straight):
            run = [shape.start, shape.end]
        else:
            count = max(2, int(abs(shape.sweep) / step + 0.999))
            turns = [shape.start + shape.sweep * k / count for k in range(count + 1)]
            x, y, r = *shape.centre, shape.radius
            run = [(x + r * cos(t), y + r * sin(t)) for t in turns]
        for point in run:
            if not points or hypot(point[0] - points[-1][0], point[1] - points[-1][1]) > 1e-6:
                points.append(point)
    return points
