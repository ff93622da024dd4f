"""The room round a table: legs, its soft shadow, and floor and wall as a backdrop.

One idea: all of it is seen only past the wood; the floor is so even that it is the picture's
backdrop, one colour a row, which costs nothing, and only the shadow on it is laid as tints.
Invariant: no leg stands out beyond the table.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from math import asin, hypot, inf, pi, tan
from typing import TYPE_CHECKING

import numpy as np

from engine.scene.shape import make_mesh
from engine.stage import plan
from engine.stage.bed import flat_sheet
from engine.stage.dimensions import APRON
from engine.stage.region import convex_pieces, stations, tidy

if TYPE_CHECKING:
    from engine.scene.camera import Camera
    from engine.scene.shape import Mesh, Rgb
    from engine.stage.dimensions import Frame
    from engine.table.furniture import Point, Table

FLOOR = -0.81
"""Height of the floor, m; the bed is at 0."""
BLACK: Rgb = (0, 0, 0)
SHADOW: tuple[tuple[float, float], ...] = (
    (-0.1, 0.64),
    (0.05, 0.53),
    (0.18, 0.42),
    (0.32, 0.31),
    (0.47, 0.20),
    (0.65, 0.10),
)
"""How dark the table's shadow is, a share, up to so far beyond its edge (m)."""
WALL: tuple[Rgb, Rgb] = ((48, 52, 60), (27, 29, 34))
"""The wall from far above the horizon down to it."""
FLOOR_NEAR: Rgb = (50, 45, 41)
FLOOR_FAR: Rgb = (19, 18, 18)
FADES = 5.0
"""The floor is darker by half towards what is far at each so many metres."""
DOWN = (0.0, 0.02, 0.05, 0.09, 0.15, 0.23, 0.35, 0.6, 1.0, 0.5 * pi)
"""Angles below the horizon (rad) at which the colour of the floor is worked out."""
LEG_TOP, LEG_FOOT = 0.062, 0.040
"""Half the width of a leg, m."""
INSET = 0.17
"""How far the middle of a leg stands in from the table's edge, m."""
MANY = 3.2
"""From this length on (m) a table has four legs a side, not two."""
APART = 0.7
"""Legs along an outline are at least so far apart, m."""


def backdrop(camera: Camera) -> tuple[tuple[float, Rgb], ...]:
    """Return the wall and the floor as this camera sees them: colours down the picture.

    Each goes with its share of the picture's height; shares may lie outside the picture.
    """
    steep = asin(max(-1.0, min(1.0, -float(camera.basis()[2][2]))))
    slope = 2.0 * tan(camera.field / 2.0)
    high = max(camera.eye[2] - FLOOR, 0.1)
    stops = [
        (_share(-0.5 - steep, slope) - 2e-4, WALL[0]),
        (_share(-steep, slope) - 1e-4, WALL[1]),
    ]
    for angle in DOWN:
        away = high / tan(angle) if angle > 0.0 else inf
        colour = _mixed(FLOOR_FAR, FLOOR_NEAR, 0.5 ** (away / FADES))
        stops.append((_share(angle - steep, slope), colour))
    return tuple(stops)


def _share(angle: float, slope: float) -> float:
    """Return how far down the picture a ray is that so much below its middle; level at most."""
    return 0.5 + tan(max(-1.5, min(1.5, angle))) / slope


def _mixed(a: Rgb, b: Rgb, share: float) -> Rgb:
    red, green, blue = (round(u + (v - u) * share) for u, v in zip(a, b, strict=True))
    return red, green, blue


def build_shadow(table: Table, frame: Frame) -> list[Mesh]:
    """Return the table's shadow on the floor, as tints in rings that touch, without edges."""
    shadow = [(reach, dark) for reach, dark in SHADOW if reach > 0.1 - min(frame.outer)]
    borders = [_border(table, frame, reach) for reach, _ in shadow]
    parts = [convex_pieces(tidy(borders[0]))]
    for inner, outer in pairwise(borders):
        ring = [tidy([outer[k - 1], outer[k], inner[k], inner[k - 1]]) for k in range(len(inner))]
        parts.append([part for part in ring if part])
    sheets = [
        flat_sheet(part, FLOOR, BLACK, layer=0, alpha=dark)
        for part, (_, dark) in zip(parts, shadow, strict=True)
    ]
    return [replace(sheet, edges=sheet.edges[:0]) for sheet in sheets]


def _border(table: Table, frame: Frame, reach: float) -> plan.Polygon:
    """Return the line so far (m) beyond the edge of a table."""
    if table.outline:
        return [one.behind(frame.rail + reach) for one in stations(table.outline)]
    x, y = frame.outer
    return plan.rectangle(-x - reach, -y - reach, x + reach, y + reach)


def build_legs(table: Table, frame: Frame, wood: Rgb) -> list[Mesh]:
    """Return the legs, square and tapering, down to the floor.

    They have no edges: lines alone would show them through the bed.
    """
    return [_leg(place, wood) for place in leg_places(table, frame)]


def leg_places(table: Table, frame: Frame) -> list[Point]:
    """Return where the legs stand: in rows along a rectangle, else near an outline's corners."""
    if table.outline:
        return _along_outline(table)
    x, y = (max(size - INSET, LEG_TOP) for size in frame.outer)
    count = 4 if table.length >= MANY else 2
    return [
        (x * (2.0 * k / (count - 1) - 1.0), hand * y) for k in range(count) for hand in (-1.0, 1.0)
    ]


def _along_outline(table: Table) -> list[Point]:
    places: list[Point] = []
    for one in stations(table.outline):
        place = one.root[0] - 0.5 * INSET * one.way[0], one.root[1] - 0.5 * INSET * one.way[1]
        if all(hypot(place[0] - p[0], place[1] - p[1]) > APART for p in places):
            places.append(place)
    return places


def _leg(place: Point, wood: Rgb) -> Mesh:
    x, y = place
    rings = [
        (corner, height)
        for height, half in ((-APRON, LEG_TOP), (FLOOR, LEG_FOOT))
        for corner in plan.rectangle(x - half, y - half, x + half, y + half)
    ]
    points = [(*corner, height) for corner, height in rings]
    sides = [(k, 4 + k, 4 + (k + 1) % 4, (k + 1) % 4) for k in range(4)]
    hidden = [(0, 1, 2, 3), (7, 6, 5, 4)]
    leg = make_mesh(np.array(points), sides, wood, hidden=hidden, layer=0, gloss=0.2)
    return replace(leg, edges=leg.edges[:0])
