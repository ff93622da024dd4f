"""The bed and the pockets in it: cloth with round holes, and the dark below them."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING

import numpy as np

from engine.scene.shape import make_mesh
from engine.stage import plan
from engine.stage.dimensions import DEPTH, RIM_STEPS
from engine.stage.region import clip, convex_pieces, stations, tidy

if TYPE_CHECKING:
    from engine.scene.shape import Mesh, Rgb
    from engine.stage.dimensions import Frame
    from engine.table.furniture import Pocket, Table

ROWS = 12
"""Cells of cloth across the shorter way."""


def build_bed(table: Table, frame: Frame, colour: Rgb) -> Mesh:
    """Return the cloth as one sheet of small cells, so that flat shading shows the lamps."""
    width, height = frame.inner
    step = 2.0 * min(width, height) / ROWS
    columns, rows = max(1, round(2.0 * width / step)), max(1, round(2.0 * height / step))
    xs = [float(x) for x in np.linspace(-width, width, columns + 1)]
    ys = [float(y) for y in np.linspace(-height, height, rows + 1)]
    cells: list[plan.Polygon] = []
    whole = _outlined(table, frame)
    for x0, x1 in itertools.pairwise(xs):
        for y0, y1 in itertools.pairwise(ys):
            cell = plan.rectangle(x0, y0, x1, y1)
            for part in whole or [cell]:
                cells.extend(_less_holes(clip(cell, part) if whole else cell, table.pockets))
    return flat_sheet(plan.weld(cells), 0.0, colour, layer=1)


def _outlined(table: Table, frame: Frame) -> list[plan.Polygon]:
    """Return the bed under an outline's cushions in convex pieces; nothing for a rectangle."""
    if not table.outline:
        return []
    border = [one.behind(frame.cushion_depth) for one in stations(table.outline)]
    return convex_pieces(tidy(border))


def _less_holes(cell: plan.Polygon, pockets: tuple[Pocket, ...]) -> list[plan.Polygon]:
    pieces = [cell] if cell else []
    for pocket in pockets if cell else ():
        if plan.reaches(cell, pocket.centre, pocket.radius):
            pieces = [
                part
                for piece in pieces
                for part in plan.wedges(piece, pocket.centre, pocket.radius, RIM_STEPS)
            ]
    return pieces


def flat_sheet(
    polygons: list[plan.Polygon],
    height: float,
    colour: Rgb,
    *,
    layer: int,
    gloss: float = 0.0,
    alpha: float = 1.0,
) -> Mesh:
    """Return a level sheet at `height` (m) that shares the corners of its polygons."""
    index: dict[tuple[int, int], int] = {}
    points: list[tuple[float, float, float]] = []
    faces = []
    for polygon in polygons:
        face = []
        for x, y in polygon:
            key = round(x / plan.NEAR), round(y / plan.NEAR)
            if key not in index:
                index[key] = len(points)
                points.append((x, y, height))
            face.append(index[key])
        faces.append(face)
    return make_mesh(
        np.array(points), faces, colour, kind="sheet", layer=layer, gloss=gloss, alpha=alpha
    )


def build_pocket(pocket: Pocket, colour: Rgb) -> Mesh:
    """Return the inside of a pocket below the bed, darker further down."""
    levels = (0.0, -0.2 * DEPTH, -0.5 * DEPTH, -DEPTH)
    rim = plan.circle(pocket.centre, pocket.radius, RIM_STEPS)
    points = [(x, y, z) for z in levels for x, y in rim]
    walls, shades = [], []
    for ring in range(len(levels) - 1):
        top, bottom = ring * RIM_STEPS, (ring + 1) * RIM_STEPS
        for k in range(RIM_STEPS):
            after = (k + 1) % RIM_STEPS
            walls.append((top + k, top + after, bottom + after, bottom + k))
            shades.append(_darker(colour, (1.0, 0.6, 0.3)[ring]))
    floor = (len(levels) - 1) * RIM_STEPS
    walls.append(tuple(range(floor, floor + RIM_STEPS)))  # type: ignore[arg-type]
    shades.append(_darker(colour, 0.15))
    return make_mesh(np.array(points), walls, shades, kind="shell", layer=0)


def _darker(colour: Rgb, share: float) -> Rgb:
    return int(colour[0] * share), int(colour[1] * share), int(colour[2] * share)
