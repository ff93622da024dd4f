"""Cushions: rubber under cloth along the noses and into the jaws.

One idea: a cushion with the jaws at its ends bulges towards the bed, so it is one convex part;
where an outline bends the other way, each of its pieces is a part of its own.
"""

from __future__ import annotations

import itertools
from math import hypot
from typing import TYPE_CHECKING

import numpy as np

from engine.scene.shape import make_mesh
from engine.stage import plan

if TYPE_CHECKING:
    from engine.scene.shape import Mesh, Rgb
    from engine.stage.dimensions import Frame
    from engine.table.furniture import Cushion, Point, Table

TURN = 0.2
"""The longest step along a curve, rad."""
UNDERCUT = 0.012
"""How far the foot of the rubber stands back from its nose, m."""
RISE = 0.06
"""Slope of the top, from the nose up to the wood."""


def build_cushions(table: Table, frame: Frame, colour: Rgb) -> list[Mesh]:
    """Return the parts of every cushion of a table."""
    return [
        part
        for cushion in table.cushions
        for chain in [_with_jaws(table, cushion)]
        for part in _parts(chain, frame, colour)
    ]


def _with_jaws(table: Table, cushion: Cushion) -> list[Point]:
    """Return the nose's points with those of the jaws that run on from its ends."""
    nose = plan.trace_shapes(cushion.shapes, TURN)
    before: list[Point] = []
    after: list[Point] = []
    for jaw in table.jaws:
        points = plan.trace_shapes(jaw.shapes, TURN)
        if _same(points[-1], nose[0]):
            before = points[:-1]
        elif _same(points[0], nose[-1]):
            after = points[1:]
    return [*before, *nose, *after]


def _same(a: Point, b: Point) -> bool:
    return hypot(a[0] - b[0], a[1] - b[1]) < 1e-6


def _parts(chain: list[Point], frame: Frame, colour: Rgb) -> list[Mesh]:
    if _bulges(chain):
        start, end = max(itertools.pairwise(chain), key=_length)
        return [_part(chain, start, end, frame, colour)]
    pieces = itertools.pairwise(chain)
    return [_part([a, b], a, b, frame, colour) for a, b in pieces]


def _length(piece: tuple[Point, Point]) -> float:
    return hypot(piece[1][0] - piece[0][0], piece[1][1] - piece[0][1])


def _bulges(chain: list[Point]) -> bool:
    for a, b, c in zip(chain[:-2], chain[1:-1], chain[2:], strict=True):
        if (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]) > 1e-9:
            return False
    return True


def _part(chain: list[Point], start: Point, end: Point, frame: Frame, colour: Rgb) -> Mesh:
    """Return the hull between a nose chain and the wood, `cushion_depth` behind start-end."""
    size = _length((start, end))
    out = ((end[1] - start[1]) / size, (start[0] - end[0]) / size)
    depth = frame.cushion_depth
    back = start[0] + out[0] * depth, start[1] + out[1] * depth
    polygon = plan.cut(_closed(chain, start, out, depth), back, out)
    heights = [_behind(p, start, out) for p in polygon]
    tops = [(x, y, frame.nose + RISE * d) for (x, y), d in zip(polygon, heights, strict=True)]
    feet = _feet(polygon, heights, depth, out)
    return _prism(tops, feet, [d > depth - 1e-6 for d in heights], colour)


def _behind(point: Point, start: Point, out: Point) -> float:
    return (point[0] - start[0]) * out[0] + (point[1] - start[1]) * out[1]


def _closed(chain: list[Point], start: Point, out: Point, depth: float) -> plan.Polygon:
    """Return the chain closed behind, counter-clockwise."""
    polygon = list(reversed(chain))
    for point, place in ((chain[0], len(polygon)), (chain[-1], 0)):
        missing = depth - _behind(point, start, out)
        if missing > 1e-6:
            corner = point[0] + out[0] * missing, point[1] + out[1] * missing
            polygon.insert(place, corner)
    return polygon


def _feet(
    polygon: plan.Polygon, heights: list[float], depth: float, out: Point
) -> list[tuple[float, float, float]]:
    """Return the foot of every corner, straight behind it, so that no jaw is turned inside out."""
    shifts = [min(UNDERCUT, max(depth - d, 0.0)) for d in heights]
    return [
        (x + out[0] * s, y + out[1] * s, 0.0) for (x, y), s in zip(polygon, shifts, strict=True)
    ]


def _prism(
    tops: list[tuple[float, float, float]],
    feet: list[tuple[float, float, float]],
    backs: list[bool],
    colour: Rgb,
) -> Mesh:
    count = len(tops)
    shown: list[tuple[int, ...]] = [tuple(range(count))]
    hidden: list[tuple[int, ...]] = [tuple(reversed(range(count, 2 * count)))]
    for i in range(count):
        after = (i + 1) % count
        side = (i, count + i, count + after, after)
        (hidden if backs[i] and backs[after] else shown).append(side)
    return make_mesh(np.array([*tops, *feet]), shown, colour, hidden=hidden)
