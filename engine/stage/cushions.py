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
    from engine.table.furniture import Point, Table

TURN = 0.2
"""The longest step along a curve, rad."""
UNDERCUT = 0.012
"""How far the foot of the rubber stands back from its nose, m."""
RISE = 0.06
"""Slope of the top, from the nose up to the wood."""


def build_cushions(table: Table, frame: Frame, colour: Rgb) -> list[Mesh]:
    """Return the parts of every cushion of a table, mitred where two noses meet."""
    noses = [plan.trace_shapes(cushion.shapes, TURN) for cushion in table.cushions]
    parts = []
    for nose in noses:
        before = next((n[-2] for n in noses if _same(n[-1], nose[0])), None)
        after = next((n[1] for n in noses if _same(n[0], nose[-1])), None)
        parts += _parts(_with_jaws(table, nose), before, after, frame, colour)
    return parts


def _with_jaws(table: Table, nose: list[Point]) -> list[Point]:
    """Return the nose's points with those of the jaws that run on from its ends."""
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


def _parts(
    chain: list[Point],
    before: Point | None,
    after: Point | None,
    frame: Frame,
    colour: Rgb,
) -> list[Mesh]:
    """Return the parts along a chain; `before` and `after` are the neighbours' next points."""
    first, last = _mitre(before, chain[0], chain[1]), _mitre(chain[-2], chain[-1], after)
    if _bulges(chain):
        start, end = max(itertools.pairwise(chain), key=_length)
        first = first if before else _out(start, end)
        last = last if after else _out(start, end)
        return [_part(chain, (start, end), (first, last), frame, colour)]
    inner = [_mitre(*three) for three in zip(chain[:-2], chain[1:-1], chain[2:], strict=True)]
    ways = [first, *inner, last]
    return [
        _part([*piece], piece, ends, frame, colour)
        for piece, ends in zip(itertools.pairwise(chain), itertools.pairwise(ways), strict=True)
    ]


def _out(a: Point, b: Point) -> Point:
    """Return the unit vector away from the bed, to the right of the way from a to b."""
    size = _length((a, b))
    return (b[1] - a[1]) / size, (a[0] - b[0]) / size


def _mitre(before: Point | None, here: Point, after: Point | None) -> Point:
    """Return the way backwards at a corner that is one metre behind both of its noses."""
    if before is None or after is None:
        return _out(here, after) if after else _out(before or here, here)
    one, two = _out(before, here), _out(here, after)
    share = max(1.0 + one[0] * two[0] + one[1] * two[1], 0.2)
    return (one[0] + two[0]) / share, (one[1] + two[1]) / share


def _length(piece: tuple[Point, Point]) -> float:
    return hypot(piece[1][0] - piece[0][0], piece[1][1] - piece[0][1])


def _bulges(chain: list[Point]) -> bool:
    for a, b, c in zip(chain[:-2], chain[1:-1], chain[2:], strict=True):
        if (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]) > 1e-9:
            return False
    return True


def _part(
    chain: list[Point],
    nose: tuple[Point, Point],
    ways: tuple[Point, Point],
    frame: Frame,
    colour: Rgb,
) -> Mesh:
    """Return the hull between a chain and the wood, `cushion_depth` behind its `nose`.

    `ways` lead backwards from the chain's first and last point.
    """
    start, out, depth = nose[0], _out(*nose), frame.cushion_depth
    back = start[0] + out[0] * depth, start[1] + out[1] * depth
    polygon = plan.cut(_closed(chain, start, out, ways, depth), back, out)
    heights = [_behind(p, start, out) for p in polygon]
    tops = [(x, y, frame.nose + RISE * d) for (x, y), d in zip(polygon, heights, strict=True)]
    feet = []
    for (x, y), height in zip(polygon, heights, strict=True):
        shift = min(UNDERCUT, max(depth - height, 0.0))
        way = _way((x, y), chain, ways) or out
        feet.append((x + way[0] * shift, y + way[1] * shift, 0.0))
    return _prism(tops, feet, [d > depth - 1e-6 for d in heights], colour)


def _way(point: Point, chain: list[Point], ways: tuple[Point, Point]) -> Point | None:
    if _same(point, chain[0]):
        return ways[0]
    return ways[1] if _same(point, chain[-1]) else None


def _behind(point: Point, start: Point, out: Point) -> float:
    return (point[0] - start[0]) * out[0] + (point[1] - start[1]) * out[1]


def _closed(
    chain: list[Point], start: Point, out: Point, ways: tuple[Point, Point], depth: float
) -> plan.Polygon:
    """Return the chain closed behind, counter-clockwise."""
    polygon = list(reversed(chain))
    ends = ((chain[0], ways[0], len(polygon)), (chain[-1], ways[1], 0))
    for point, way, place in ends:
        missing = depth - _behind(point, start, out)
        if missing > 1e-6:
            polygon.insert(place, (point[0] + way[0] * missing, point[1] + way[1] * missing))
    return polygon


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
