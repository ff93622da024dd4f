"""The painter's strokes: parts and spheres filled one after the other, each face one light.

One idea: a whole list of things is painted in one call. Parts are numbered first, spheres after
them. Invariant: nothing outside the box that may be touched is.
"""
# ruff: noqa: FBT001  a kernel takes its flags by place

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

from engine.render.raster import SNAP, by_height, corners_of, fill_flat, rows_of, span_of
from engine.render.shading import light_at, mix, texel

if TYPE_CHECKING:
    from engine.render.arrays import Bytes, Floats, Ints, Longs, Pixels, Singles

HIDDEN = -1.0
"""In place of a face's light: it is turned away from the eye."""


@njit(cache=True, nogil=True, error_model="numpy")
def paint_part(
    image: Pixels,
    box: tuple[int, int, int, int],
    first: int,
    last: int,
    seen: Floats,
    screen: Floats,
    triangles: Ints,
    faces: Ints,
    normals: Floats,
    offsets: Floats,
    lights: Singles,
    shades: Pixels,
    eye: Floats,
    focal: float,
    near: float,
    width: float,
    height: float,
) -> None:
    """Fill the triangles first to last that are turned to the eye."""
    corner = np.empty((4, 3))
    for t in range(first, last):
        f = faces[t]
        if normals[f, 0] * eye[0] + normals[f, 1] * eye[1] + normals[f, 2] * eye[2] <= offsets[f]:
            continue
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        count = corners_of(seen, screen, a, b, c, focal, near, width, height, corner)
        for part in range(count - 2):
            fill_flat(
                image, box, corner[0], corner[part + 1], corner[part + 2], shades[f], lights[f, 1]
            )


@njit(cache=True, nogil=True, error_model="numpy")
def place_spheres(
    units: Longs,
    unit_starts: Ints,
    unit_points: Floats,
    unit_normals: Floats,
    unit_centres: Floats,
    centres: Floats,
    rotations: Floats,
    radii: Floats,
    gloss: Singles,
    lamps: Floats,
    ambient: float,
    eye: Floats,
    basis: Floats,
    focal: float,
    near: float,
    width: float,
    height: float,
    starts: Longs,
    screen: Floats,
    light: Floats,
) -> None:
    """Write where every corner of every sphere lands, and the light and height of every face.

    `starts` (n, 2): where the corners and the faces of a sphere begin. `light` (m, 3): light,
    highlight, and whether the face's middle is above the ground; `HIDDEN` where turned away.
    """
    n, p = np.empty(3), np.empty(3)
    for s in range(len(radii)):
        m, radius, unit = rotations[s], radii[s], units[s]
        first = unit_starts[unit, 0]
        for i in range(first, unit_starts[unit + 1, 0]):
            x, y, z = 0.0, 0.0, 0.0
            for k in range(3):
                place = centres[s, k] - eye[k]
                for j in range(3):
                    place += radius * m[k, j] * unit_points[i, j]
                x, y, z = x + basis[0, k] * place, y + basis[1, k] * place, z + basis[2, k] * place
            w = 1.0 / max(z, near)
            at = starts[s, 0] + i - first
            screen[at, 0] = np.floor((width * 0.5 + focal * x * w) * SNAP + 0.5) / SNAP
            screen[at, 1] = np.floor((height * 0.5 + focal * y * w) * SNAP + 0.5) / SNAP
        first = unit_starts[unit, 2]
        for f in range(first, unit_starts[unit + 1, 2]):
            toward = 0.0
            for k in range(3):
                n[k], p[k] = 0.0, centres[s, k]
                for j in range(3):
                    n[k] += m[k, j] * unit_normals[f, j]
                    p[k] += radius * m[k, j] * unit_centres[f, j]
                toward += n[k] * (eye[k] - p[k])
            at = starts[s, 1] + f - first
            light[at, 0], light[at, 2] = HIDDEN, p[2]
            if toward > 0.0:
                light[at, 0], light[at, 1] = light_at(
                    p[0], p[1], p[2], n[0], n[1], n[2], eye, lamps, ambient, gloss[s] * 0.5
                )


@njit(cache=True, nogil=True, error_model="numpy")
def fill_skin(
    image: Pixels,
    box: tuple[int, int, int, int],
    p: Floats,
    q: Floats,
    r: Floats,
    own: Floats,
    light: float,
    shine: float,
    skins: Bytes,
    offset: int,
    size: int,
) -> None:
    """Fill one triangle with a skin under one light; `own` (3, 3): directions at its corners."""
    left, top, right, bottom = box
    x0, y0, x1, y1, x2, y2, cross = by_height(p[0], p[1], q[0], q[1], r[0], r[1])
    if cross == 0.0 or max(x0, x1, x2) < left or min(x0, x1, x2) > right:
        return
    ax, ay, bx, by = q[0] - p[0], q[1] - p[1], r[0] - p[0], r[1] - p[1]
    scale = 1.0 / (ax * by - bx * ay)
    first, last = rows_of(y0, y2, top, bottom)
    for y in range(first, last):
        begin, end = span_of(y, left, right, x0, y0, x1, y1, x2, y2, cross)
        for x in range(begin, end):
            dx, dy = x + 0.5 - p[0], y + 0.5 - p[1]
            s, t = (dx * by - dy * bx) * scale, (dy * ax - dx * ay) * scale
            rest = 1.0 - s - t
            at = texel(
                offset,
                size,
                own[0, 0] * rest + own[1, 0] * s + own[2, 0] * t,
                own[0, 1] * rest + own[1, 1] * s + own[2, 1] * t,
                own[0, 2] * rest + own[1, 2] * s + own[2, 2] * t,
            )
            image[y, x] = mix(
                float(skins[at]), float(skins[at + 1]), float(skins[at + 2]), light, shine
            )


@njit(cache=True, nogil=True, error_model="numpy")
def paint_sphere(
    image: Pixels,
    box: tuple[int, int, int, int],
    upper_half: bool,
    first: int,
    last: int,
    first_point: int,
    first_face: int,
    triangles: Ints,
    faces: Ints,
    points: Floats,
    screen: Floats,
    light: Floats,
    colour: Bytes,
    skins: Bytes,
    offset: int,
    size: int,
) -> None:
    """Fill a sphere's triangles first to last; `upper_half`: only those above the ground.

    `screen` and `light` are the sphere's own corners and faces; `first_point` and `first_face` are
    the unit sphere's first ones among all `points`.
    """
    own = np.empty((3, 3))
    red, green, blue = float(colour[0]), float(colour[1]), float(colour[2])
    for t in range(first, last):
        f = faces[t] - first_face
        if light[f, 0] == HIDDEN or (upper_half and light[f, 2] < 0.0):
            continue
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        p, q, r = screen[a - first_point], screen[b - first_point], screen[c - first_point]
        if size > 0:
            for k in range(3):
                own[0, k], own[1, k], own[2, k] = points[a, k], points[b, k], points[c, k]
            fill_skin(image, box, p, q, r, own, light[f, 0], light[f, 1], skins, offset, size)
        else:
            fill_flat(image, box, p, q, r, mix(red, green, blue, light[f, 0], light[f, 1]), 1.0)


@njit(cache=True, nogil=True, error_model="numpy")
def paint_items(
    image: Pixels,
    top: int,
    bottom: int,
    items: Ints,
    after: int,
    whole: bool,
    boxes: Floats,
    seen: Floats,
    screen: Floats,
    starts: Ints,
    triangles: Ints,
    faces: Ints,
    normals: Floats,
    offsets: Floats,
    lights: Singles,
    shades: Pixels,
    units: Longs,
    unit_starts: Ints,
    unit_triangles: Ints,
    unit_faces: Ints,
    unit_points: Floats,
    ball_starts: Longs,
    ball_screen: Floats,
    ball_light: Floats,
    centres: Floats,
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
) -> None:
    """Paint items in their order: parts, and spheres from the number of parts on.

    Parts before number `after` are on the picture already: they are painted again only over the
    `boxes` (n, 4) of items from `after` on that came before them. A sphere sunk into the ground is
    painted above it alone, unless `whole`.
    """
    parts = len(starts) - 1
    placed = np.empty(len(items), np.int32)
    count = 0
    for item in items:
        if item >= parts:
            s = item - parts
            away = 0.0
            for k in range(3):
                away += basis[2, k] * (centres[s, k] - eye[k])
            if away - radii[s] < near:
                continue
            unit = units[s]
            paint_sphere(
                image,
                (0, top, int(width), bottom),
                not whole and centres[s, 2] < 0.98 * radii[s],
                unit_starts[unit, 1],
                unit_starts[unit + 1, 1],
                unit_starts[unit, 0],
                unit_starts[unit, 2],
                unit_triangles,
                unit_faces,
                unit_points,
                ball_screen[ball_starts[s, 0] :],
                ball_light[ball_starts[s, 1] :],
                colours[s],
                skins,
                skin_places[s, 0],
                skin_places[s, 1],
            )
        over = 1 if item >= after else count
        for k in range(over if item < parts else 0):
            box = (0, top, int(width), bottom)
            if item < after:
                box = overlap(boxes, item, placed[k], top, bottom, int(width))
            if box[0] < box[2] and box[1] < box[3]:
                paint_part(
                    image,
                    box,
                    starts[item, 1],
                    starts[item + 1, 1],
                    seen,
                    screen,
                    triangles,
                    faces,
                    normals,
                    offsets,
                    lights,
                    shades,
                    eye,
                    focal,
                    near,
                    width,
                    height,
                )
        if item >= after:
            placed[count] = item
            count += 1


@njit(cache=True, nogil=True, error_model="numpy")
def overlap(
    boxes: Floats, one: int, two: int, top: int, bottom: int, width: int
) -> tuple[int, int, int, int]:
    """Return the pixels that two boxes share in a band of rows."""
    left = max(boxes[one, 0], boxes[two, 0], 0.0)
    upper = max(boxes[one, 1], boxes[two, 1], top)
    right = min(boxes[one, 2], boxes[two, 2], width - 1.0)
    lower = min(boxes[one, 3], boxes[two, 3], bottom - 1.0)
    if left > right or upper > lower:
        return 0, 0, 0, 0
    return int(left), int(upper), int(right) + 1, int(lower) + 1
