"""Edges to be drawn: those of faces turned to the eye, of meshes and of spheres.

One idea: every edge is looked at once and becomes a stroke on the screen where one of its faces is
turned to the eye. Invariant: the order of the strokes is that of the edges.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

from engine.render.line_kernels import place_stroke, see_point
from engine.render.shading import texel

if TYPE_CHECKING:
    from engine.render.arrays import Bytes, Floats, Ints, Longs, Pixels, Singles

FAINT = 0.12
"""Tints no stronger than this are left out."""
DIMMED = 0.85
TINTED = 0.4
LEAST_PEAK = 150.0
DARK = 40.0
GREY = np.uint32(0x6E6E6E)


@njit(cache=True, nogil=True, error_model="numpy")
def bright(red: int, green: int, blue: int) -> np.uint32:
    """Return a colour that stands out on black: a dark one lifted, its hue kept."""
    peak = float(max(red, green, blue))
    if peak < DARK:
        return GREY
    lift = max(peak, LEAST_PEAK) / peak
    return np.uint32((int(red * lift) << 16) | (int(green * lift) << 8) | int(blue * lift))


@njit(cache=True, nogil=True, error_model="numpy")
def turned_to(normals: Floats, offsets: Floats, face: int, eye: Floats) -> bool:
    """Return whether a face looks at the eye."""
    way = normals[face, 0] * eye[0] + normals[face, 1] * eye[1] + normals[face, 2] * eye[2]
    return way > offsets[face]


@njit(cache=True, nogil=True, error_model="numpy")
def mesh_strokes(
    points: Floats,
    edges: Ints,
    normals: Floats,
    offsets: Floats,
    colours: Bytes,
    light: Singles,
    eye: Floats,
    basis: Floats,
    focal: float,
    near: float,
    width: float,
    height: float,
    strokes: Floats,
    shades: Pixels,
    start: int,
) -> int:
    """Write the edges of meshes as strokes from number `start` on; return the number after."""
    seen = np.empty((len(points), 3))
    for i in range(len(points)):
        see_point(points[i], eye, basis, seen[i])
    count = start
    for i in range(len(edges)):
        face, other = edges[i, 2], edges[i, 3]
        shown = turned_to(normals, offsets, face, eye)
        if not shown and (other < 0 or not turned_to(normals, offsets, other, eye)):
            continue
        alpha = light[face, 1]
        if alpha <= FAINT:
            continue
        one, two = seen[edges[i, 0]], seen[edges[i, 1]]
        if place_stroke(one, two, width, height, focal, near, strokes[count]):
            strokes[count, 6] = 0.0
            strokes[count, 7] = TINTED if alpha < 1.0 else DIMMED
            shades[count] = bright(
                int(colours[face, 0]), int(colours[face, 1]), int(colours[face, 2])
            )
            count += 1
    return count


@njit(cache=True, nogil=True, error_model="numpy")
def sphere_strokes(
    order: Longs,
    steps: Longs,
    unit_starts: Ints,
    unit_points: Floats,
    unit_edges: Ints,
    unit_normals: Floats,
    unit_offsets: Floats,
    centres: Floats,
    rotations: Floats,
    radii: Floats,
    colours: Bytes,
    skins: Bytes,
    skin_places: Ints,
    eye: Floats,
    basis: Floats,
    focal: float,
    near: float,
    width: float,
    height: float,
    strokes: Floats,
    shades: Pixels,
    start: int,
) -> int:
    """Write the edges of spheres as strokes; `unit_starts` (k, 2): first point, first edge.

    `steps` says which of the unit spheres each is drawn by. Points and faces of the unit spheres
    count through all of them.
    """
    count = start
    own_eye, place = np.empty(3), np.empty(3)
    most = 0
    for k in range(len(unit_starts) - 1):
        most = max(most, unit_starts[k + 1, 0] - unit_starts[k, 0])
    seen = np.empty((most, 3))
    for s in order:
        see_point(centres[s], eye, basis, place)
        if place[2] < near:
            continue
        m, radius = rotations[s], radii[s]
        for k in range(3):
            own_eye[k] = 0.0
            for i in range(3):
                own_eye[k] += m[i, k] * (eye[i] - centres[s, i]) / radius
        unit = steps[s]
        first = unit_starts[unit, 0]
        for i in range(first, unit_starts[unit + 1, 0]):
            for k in range(3):
                place[k] = centres[s, k]
                for j in range(3):
                    place[k] += radius * m[k, j] * unit_points[i, j]
            see_point(place, eye, basis, seen[i - first])
        offset, size = skin_places[s, 0], skin_places[s, 1]
        shade = bright(int(colours[s, 0]), int(colours[s, 1]), int(colours[s, 2]))
        for e in range(unit_starts[unit, 1], unit_starts[unit + 1, 1]):
            one, two = unit_edges[e, 0], unit_edges[e, 1]
            face, other = unit_edges[e, 2], unit_edges[e, 3]
            shown = turned_to(unit_normals, unit_offsets, face, own_eye)
            if not shown and not turned_to(unit_normals, unit_offsets, other, own_eye):
                continue
            a, b = seen[one - first], seen[two - first]
            if not place_stroke(a, b, width, height, focal, near, strokes[count]):
                continue
            if size > 0:
                at = texel(
                    offset,
                    size,
                    unit_points[one, 0] + unit_points[two, 0],
                    unit_points[one, 1] + unit_points[two, 1],
                    unit_points[one, 2] + unit_points[two, 2],
                )
                shade = bright(int(skins[at]), int(skins[at + 1]), int(skins[at + 2]))
            strokes[count, 6], strokes[count, 7] = 0.0, 1.0
            shades[count] = shade
            count += 1
    return count
