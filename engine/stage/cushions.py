"""Cushions: rubber under cloth along the noses and into the jaws.

One idea: a cushion with the jaws at its ends bulges towards the bed, so it is one convex part;
where an outline bends the other way, each of its pieces is a part of its own.
"""

from __future__ import annotations

import itertools
from math import hypot, inf
from typing import TYPE_CHECKING

import numpy as np

from engine.scene.shape import make_mesh
from engine.stage import plan
from engine.stage.region import stations, tidy
from engine.table.region import ends, posts_of

if TYPE_CHECKING:
    from engine.scene.shape import Mesh, Rgb
    from engine.stage.dimensions import Frame
    from engine.stage.region import Station
    from engine.table.furniture import Point, Shape, Table

TURN = 0.2
"""The longest step along a curve, rad."""
UNDERCUT = 0.012
"""How far the foot of the rubber stands back from its nose, m."""
RISE = 0.06
"""Slope of the top, from the nose up to the wood."""


def build_cushions(table: Table, frame: Frame, colour: Rgb) -> list[Mesh]:
    """Return the parts of every cushion of a table, mitred where two noses meet."""
    if table.outline:
        return [part for run in _runs(table) for part in _lining(table, run, frame, colour)]
    standing = {post.id for post in posts_of(table)}
    noses = [plan.trace_shapes(c.shapes, TURN) for c in table.cushions if c.id not in standing]
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


def _runs(table: Table) -> list[list[Shape]]:
    """Return the noses round the bed in runs without a gap; a single run may be closed."""
    standing = {post.id for post in posts_of(table)}
    shapes = [shape for c in table.cushions if c.id not in standing for shape in c.shapes]
    runs: list[list[Shape]] = []
    for shape in shapes:
        if runs and _same(ends(runs[-1][-1])[1], ends(shape)[0]):
            runs[-1].append(shape)
        else:
            runs.append([shape])
    if len(runs) > 1 and _same(ends(runs[-1][-1])[1], ends(runs[0][0])[0]):
        runs[0] = [*runs.pop(), *runs[0]]
    return runs


def _lining(table: Table, run: list[Shape], frame: Frame, colour: Rgb) -> list[Mesh]:
    """Return the parts along a run of noses, from station to station, with the jaws at its ends."""
    closed = _same(ends(run[0])[0], ends(run[-1])[1])
    places = stations(run, closed=closed, longest=inf)
    if closed:
        places.append(places[0])
    parts = []
    nose = [place.point for place in places]
    jaws = _with_jaws(table, [nose[0], nose[-1]])
    split = jaws.index(nose[0])
    before, after = jaws[:split], jaws[split + 2 :]
    last = len(places) - 2
    for index, (a, b) in enumerate(itertools.pairwise(places)):
        if not closed and ((before and index == 0) or (after and index == last)):
            chain = [
                *(before if index == 0 else []),
                a.point,
                b.point,
                *(after if index == last else []),
            ]
            out = _out(a.point, b.point)
            ways = (
                out if before and index == 0 else _level(a, frame),
                out if after and index == last else _level(b, frame),
            )
            parts.append(_part(chain, (a.point, b.point), ways, frame, colour))
        else:
            parts += _cell(a, b, frame, colour)
    return parts


def _level(station: Station, frame: Frame) -> Point:
    """Return the way from a station's nose to its place at the wood, as if one metre long."""
    x, y = station.behind(frame.cushion_depth)
    size = frame.cushion_depth
    return (x - station.point[0]) / size, (y - station.point[1]) / size


def _cell(a: Station, b: Station, frame: Frame, colour: Rgb) -> list[Mesh]:
    """Return the part between two stations: nose, wood, top and foot."""
    depth = frame.cushion_depth
    polygon = tidy([b.point, a.point, a.behind(depth), b.behind(depth)])
    if not polygon:
        return []
    fronts = [point in (a.point, b.point) for point in polygon]
    tops = [
        (x, y, frame.nose + (0.0 if front else RISE * depth))
        for (x, y), front in zip(polygon, fronts, strict=True)
    ]
    foot = {one.point: one.behind(min(UNDERCUT, 0.5 * (one.depth or 1.0))) for one in (a, b)}
    feet = [(*foot.get(point, point), 0.0) for point in polygon]
    return [_prism(tops, feet, [not front for front in fronts], colour)]
