"""The grain of the wood: a board is strips along the rail, each of its own tone.

One idea: every top is cut by the same few lines along its rail, so neighbours meet corner to
corner; at the corners of a rectangle the boards are mitred. Invariant: the strips fill the top.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from engine.stage import plan

if TYPE_CHECKING:
    from collections.abc import Sequence

    from engine.scene.shape import Rgb
    from engine.stage.dimensions import Frame
    from engine.table.furniture import Point

    Border = tuple[Point, Point]
    """A point of a line and the unit way across it, away from the bed."""

GRAIN: tuple[tuple[float, float], ...] = (
    (0.0, 0.74),
    (0.08, 1.06),
    (0.48, 0.95),
    (0.92, 1.3),
)
"""From which share of the wood's width on, from the cushion outwards, it has which tone."""
SIDE, SKIRT = 1.75, 1.2
"""Tones of the outer side of the rail and of the apron below it, which no lamp lights."""


def toned(colour: Rgb, tone: float) -> Rgb:
    """Return a colour made lighter or darker, within what a colour can be."""
    red, green, blue = (min(255, round(part * tone)) for part in colour)
    return red, green, blue


def grained(
    polygon: plan.Polygon, colour: Rgb, cuts: Sequence[Border]
) -> list[tuple[plan.Polygon, Rgb]]:
    """Return a convex top in strips between `cuts`, one for each tone but the first."""
    strips, rest = [], polygon
    for (_, tone), (point, way) in zip(GRAIN, cuts, strict=False):
        strip = plan.cut(rest, point, way)
        if strip:
            strips.append((strip, toned(colour, tone)))
        rest = plan.cut(rest, point, (-way[0], -way[1])) if rest else []
    if rest:
        strips.append((rest, toned(colour, GRAIN[-1][1])))
    return strips


def cuts_between(inner: Border, outer: Border) -> list[Border]:
    """Return the lines of the grain between two lines along the wood, by their points."""
    (a, b), (c, d) = inner, outer
    found = []
    for share, _ in GRAIN[1:]:
        p = a[0] + share * (c[0] - a[0]), a[1] + share * (c[1] - a[1])
        q = b[0] + share * (d[0] - b[0]), b[1] + share * (d[1] - b[1])
        found.append((p, _across(p, q)))
    return found


def _across(p: Point, q: Point) -> Point:
    u, v = q[0] - p[0], q[1] - p[1]
    size = max((u * u + v * v) ** 0.5, plan.NEAR)
    return v / size, -u / size


def framed(polygon: plan.Polygon, colour: Rgb, frame: Frame) -> list[tuple[plan.Polygon, Rgb]]:
    """Return a top of a rectangle's wood in strips, mitred at the corners."""
    x = sum(p[0] for p in polygon) / len(polygon)
    y = sum(p[1] for p in polygon) / len(polygon)
    (ix, iy), (ox, oy) = frame.inner, frame.outer
    hands = (1.0 if x > 0.0 else -1.0, 1.0 if y > 0.0 else -1.0)
    if abs(x) < ix:
        return grained(polygon, colour, _level(1, hands, frame))
    if abs(y) < iy:
        return grained(polygon, colour, _level(0, hands, frame))
    corner = hands[0] * ix, hands[1] * iy
    across = hands[0] * (oy - iy), -hands[1] * (ox - ix)
    parts = []
    for side, axis in ((1.0, 1), (-1.0, 0)):
        half = plan.cut(polygon, corner, (side * across[0], side * across[1]))
        if half:
            parts += grained(half, colour, _level(axis, hands, frame))
    return parts


def _level(axis: int, hands: tuple[float, float], frame: Frame) -> list[Border]:
    """Return the lines of the grain along a side of a rectangle."""
    inner, outer, hand = frame.inner[axis], frame.outer[axis], hands[axis]
    places = [hand * (inner + share * (outer - inner)) for share, _ in GRAIN[1:]]
    if axis == 0:
        return [((place, 0.0), (hand, 0.0)) for place in places]
    return [((0.0, place), (0.0, hand)) for place in places]
