"""The wood round a table: straight lengths, and fans of small blocks round the pockets."""

from __future__ import annotations

import itertools
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from engine.scene.shape import make_mesh
from engine.stage import plan
from engine.stage.dimensions import APRON, LINER, RIM_STEPS
from engine.stage.region import stations, tidy
from engine.stage.wood import SIDE, SKIRT, cuts_between, framed, grained, toned
from engine.table.region import is_hole

if TYPE_CHECKING:
    from collections.abc import Callable

    from engine.scene.shape import Mesh, Rgb
    from engine.stage.dimensions import Frame
    from engine.table.furniture import Pocket, Point, Table

    Bottom = Callable[[Point, Point, Pocket | None], float | None]
    Painted = list[tuple[plan.Polygon, Rgb]]
    Grain = Callable[[plan.Polygon, Rgb], Painted]

GLOSS = 0.35
LONGEST = 0.3
"""The longest length of wood in one piece, m, so that flat shading shows the lamps."""
LIP = 0.028
"""How far the outer side of the rail reaches below the bed, m; below it is the apron."""


def build_rails(table: Table, frame: Frame, wood: Rgb, liner: Rgb) -> list[Mesh]:
    """Return the convex blocks of wood, each with its top and the sides that show."""
    if table.outline:
        return _outlined(table, frame, wood, liner)
    plain: list[plan.Polygon] = []
    round_pockets: list[tuple[plan.Polygon, Pocket]] = []
    for cell in _cells(table, frame):
        near = [p for p in table.pockets if plan.reaches(cell, p.centre, p.radius)]
        if near:
            round_pockets.append((cell, near[0]))
        else:
            plain.append(cell)
    bottom = partial(_bottom, frame=frame)
    grain = partial(framed, frame=frame)
    blocks = [
        _block(
            [top for length in _lengths(c) for top in grain(length, wood)], c, frame, wood, bottom
        )
        for c in plain
    ]
    blocks += [
        _fan_block(wedge, pocket, frame, (wood, liner), bottom, grain)
        for cell, pocket in round_pockets
        for wedge in plan.wedges(cell, pocket.centre, pocket.radius, RIM_STEPS)
    ]
    return blocks


def _lengths(cell: plan.Polygon) -> list[plan.Polygon]:
    """Return a rectangle cut across its longer way, so that flat shading shows the lamps."""
    (x0, y0), (x1, y1) = cell[0], cell[2]
    count = max(1, round(max(x1 - x0, y1 - y0) / LONGEST))
    steps = [k / count for k in range(count + 1)]
    if x1 - x0 >= y1 - y0:
        xs = [x0 + (x1 - x0) * s for s in steps]
        return [plan.rectangle(a, y0, b, y1) for a, b in itertools.pairwise(xs)]
    ys = [y0 + (y1 - y0) * s for s in steps]
    return [plan.rectangle(x0, a, x1, b) for a, b in itertools.pairwise(ys)]


def _cells(table: Table, frame: Frame) -> list[plan.Polygon]:
    """Return rectangles that fill the frame, each touching one pocket at most."""
    (ix, iy), (ox, oy) = frame.inner, frame.outer
    xs, ys = {-ix, ix}, {-iy, iy}
    for pocket in table.pockets:
        (x, y), reach = pocket.centre, pocket.radius + 2.0 * LINER
        xs |= {e for e in (x - reach, x + reach) if abs(e) < ix}
        ys |= {e for e in (y - reach, y + reach) if abs(e) < iy}
    across, along = sorted(xs), sorted(ys)
    cells = [
        plan.rectangle(a, s * m, b, s * n) if s > 0 else plan.rectangle(a, -n, b, -m)
        for a, b in itertools.pairwise(across)
        for s, m, n in ((1, iy, oy), (-1, iy, oy))
    ]
    cells += [
        plan.rectangle(m, a, n, b)
        for a, b in itertools.pairwise(along)
        for m, n in ((ix, ox), (-ox, -ix))
    ]
    for x0, x1 in ((ix, ox), (-ox, -ix)):
        cells += [plan.rectangle(x0, y0, x1, y1) for y0, y1 in ((iy, oy), (-oy, -iy))]
    return cells


def _outlined(table: Table, frame: Frame, wood: Rgb, liner: Rgb) -> list[Mesh]:
    """Return the wood along an outline, from station to station."""
    places = stations(table.outline)
    pockets = [pocket for pocket in table.pockets if not is_hole(pocket)]
    blocks = []
    for a, b in zip(places, (*places[1:], places[0]), strict=True):
        inner = a.behind(frame.cushion_depth), b.behind(frame.cushion_depth)
        outer = a.behind(frame.rail), b.behind(frame.rail)
        cell = tidy([inner[1], inner[0], outer[0], outer[1]])
        if not cell:
            continue
        bottom = partial(_bottom_between, inner=inner, outer=outer)
        grain = partial(grained, cuts=cuts_between((inner[1], inner[0]), (outer[1], outer[0])))
        near = [p for p in pockets if plan.reaches(cell, p.centre, p.radius)]
        if near:
            blocks += [
                _fan_block(wedge, near[0], frame, (wood, liner), bottom, grain)
                for wedge in plan.wedges(cell, near[0].centre, near[0].radius, RIM_STEPS)
            ]
        else:
            blocks.append(_block(grain(cell, wood), cell, frame, wood, bottom))
    return blocks


def _bottom_between(
    a: Point,
    b: Point,
    pocket: Pocket | None,
    inner: tuple[Point, Point],
    outer: tuple[Point, Point],
) -> float | None:
    """Return how far down a side shows on a block between two lines, None for hidden."""
    if max(_aside(p, *outer) for p in (a, b)) < 1e-6:
        return -APRON
    if max(_aside(p, *inner) for p in (a, b)) < 1e-6:
        return 0.0
    return _bottom_at_rim(a, b, pocket)


def _aside(point: Point, a: Point, b: Point) -> float:
    """Return how far a point lies beside the line from a to b; far off where there is none."""
    size = _distance(a, b)
    if size < 1e-6:
        return 1.0
    return abs((point[0] - a[0]) * (b[1] - a[1]) - (point[1] - a[1]) * (b[0] - a[0])) / size


def _fan_block(
    wedge: plan.Polygon,
    pocket: Pocket,
    frame: Frame,
    colours: tuple[Rgb, Rgb],
    bottom: Bottom,
    grain: Grain,
) -> Mesh:
    """Return a block whose top has a strip of liner along the pocket's rim."""
    wood, liner = colours
    rim = [p for p in wedge if _distance(p, pocket.centre) < pocket.radius + 1e-6]
    if len(rim) != 2:
        return _block(grain(wedge, wood), wedge, frame, wood, bottom)
    (ax, ay), (bx, by) = rim
    size = _distance(rim[0], rim[1])
    out = ((ay - by) / size, (bx - ax) / size)
    if (pocket.centre[0] - ax) * out[0] + (pocket.centre[1] - ay) * out[1] > 0.0:
        out = (-out[0], -out[1])
    line = ax + out[0] * LINER, ay + out[1] * LINER
    near, far = plan.cut(wedge, line, out), plan.cut(wedge, line, (-out[0], -out[1]))
    tops = grain(far, wood) if far else []
    if near:
        corners = [point for top, _ in tops for point in top] or near
        tops = [(plan.weld_to(near, np.array(corners)), liner), *tops]
    return _block(tops, wedge, frame, wood, bottom, (pocket, liner))


def _distance(a: Point, b: Point) -> float:
    return float(np.hypot(a[0] - b[0], a[1] - b[1]))


def _block(
    tops: Painted,
    outline: plan.Polygon,
    frame: Frame,
    wood: Rgb,
    bottom_of: Bottom,
    rim: tuple[Pocket, Rgb] | None = None,
) -> Mesh:
    """Return a prism from the frame's top down; sides against other blocks are hidden.

    Where tops meet one another there is no edge, only another tone.
    """
    points: list[tuple[float, float, float]] = []
    shown: list[list[int]] = []
    hidden: list[list[int]] = []
    paint = [colour for _, colour in tops]
    for top, _ in tops:
        shown.append(list(range(len(points), len(points) + len(top))))
        points += [(x, y, frame.top) for x, y in top]
    flat, borders = len(points), []
    pocket, liner = rim or (None, wood)
    for a, b in zip(outline, (*outline[1:], outline[0]), strict=True):
        bottom = bottom_of(a, b, pocket)
        if bottom is not None:
            borders.append((a, b))
        for high, low, colour in _bands(bottom, frame.top, wood, liner):
            side = list(range(len(points), len(points) + 4))
            points += [(*a, high), (*a, low), (*b, low), (*b, high)]
            if bottom is None:
                hidden.append(side)
            else:
                shown.append(side)
                paint.append(colour)
    mesh = make_mesh(np.array(points), shown, paint, hidden=hidden, gloss=GLOSS)
    kept = [
        int(one) >= flat
        or any(max(_aside(points[k][:2], *side) for k in (one, two)) < 1e-6 for side in borders)
        for one, two, _, _ in mesh.edges
    ]
    return replace(mesh, edges=mesh.edges[kept])


def _bands(
    bottom: float | None, top: float, wood: Rgb, liner: Rgb
) -> list[tuple[float, float, Rgb]]:
    """Return a side's bands from its top down: one, or rail and apron where it is outer."""
    if bottom is None:
        return [(top, -APRON, wood)]
    if bottom == 0.0:
        return [(top, 0.0, liner)]
    return [
        (top, -LIP, toned(wood, SIDE)),
        (-LIP, -APRON, toned(wood, SKIRT)),
    ]


def _bottom(a: Point, b: Point, pocket: Pocket | None, frame: Frame) -> float | None:
    """Return how far down a side shows: the apron outside, the bed inside, None for hidden."""
    for axis in (0, 1):
        ends = abs(a[axis]), abs(b[axis])
        if min(ends) > frame.outer[axis] - 1e-6:
            return -APRON
        if max(abs(e - frame.inner[axis]) for e in ends) < 1e-6 and all(
            abs(p[1 - axis]) < frame.inner[1 - axis] + 1e-6 for p in (a, b)
        ):
            return 0.0
    return _bottom_at_rim(a, b, pocket)


def _bottom_at_rim(a: Point, b: Point, pocket: Pocket | None) -> float | None:
    if pocket and max(_distance(p, pocket.centre) for p in (a, b)) < pocket.radius + 1e-6:
        return 0.0
    return None
