"""The painter's strokes: parts and spheres filled one after the other, each face one light.

One idea: a whole list of things is painted in one call. Parts are numbered first, spheres after
them. Invariant: nothing outside the box that may be touched is.
"""
# ruff: noqa: FBT001  a kernel takes its flags by place

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

from engine.render.raster import SNAP, by_height, corners_of, fill_flat, rows_of, slopes_of, span_of
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
            corners = (
                corner[0, 0],
                corner[0, 1],
                corner[part + 1, 0],
                corner[part + 1, 1],
                corner[part + 2, 0],
                corner[part + 2, 1],
            )
            fill_flat(image, box, corners, shades[f], lights[f, 1])


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
    corners: tuple[float, float, float, float, float, float],
    own: tuple[float, float, float, float, float, float, float, float, float],
    light: float,
    shine: float,
    skins: Bytes,
    offset: int,
    size: int,
) -> None:
    """Fill one triangle with a skin under one light; `own` are directions at its corners."""
    left, top, right, bottom = box
    px, py, qx, qy, rx, ry = corners
    x0, y0, x1, y1, x2, y2, cross = by_height(px, py, qx, qy, rx, ry)
    first, last = rows_of(y0, y2, top, bottom)
    if cross == 0.0 or first >= last or max(x0, x1, x2) < left or min(x0, x1, x2) > right:
        return
    ax, ay, bx, by = qx - px, qy - py, rx - px, ry - py
    scale = 1.0 / (ax * by - bx * ay)
    slopes = slopes_of(x0, y0, x1, y1, x2, y2)
    for y in range(first, last):
        begin, end = span_of(y, left, right, x0, y0, x1, y1, y2, cross, slopes)
        for x in range(begin, end):
            dx, dy = x + 0.5 - px, y + 0.5 - py
            s, t = (dx * by - dy * bx) * scale, (dy * ax - dx * ay) * scale
            rest = 1.0 - s - t
            at = texel(
                offset,
                size,
                own[0] * rest + own[3] * s + own[6] * t,
                own[1] * rest + own[4] * s + own[7] * t,
                own[2] * rest + own[5] * s + own[8] * t,
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
    point_shift: int,
    face_shift: int,
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

    `first_point` and `first_face` are the unit sphere's first ones among all `points`,
    `point_shift` and `face_shift` the sphere's own first ones in `screen` and `light`.
    """
    red, green, blue = float(colour[0]), float(colour[1]), float(colour[2])
    for t in range(first, last):
        f = faces[t] - first_face + face_shift
        if light[f, 0] == HIDDEN or (upper_half and light[f, 2] < 0.0):
            continue
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        shift = point_shift - first_point
        corners = (
            screen[a + shift, 0],
            screen[a + shift, 1],
            screen[b + shift, 0],
            screen[b + shift, 1],
            screen[c + shift, 0],
            screen[c + shift, 1],
        )
        if size > 0:
            own = (
                points[a, 0],
                points[a, 1],
                points[a, 2],
                points[b, 0],
                points[b, 1],
                points[b, 2],
                points[c, 0],
                points[c, 1],
                points[c, 2],
            )
            fill_skin(image, box, corners, own, light[f, 0], light[f, 1], skins, offset, size)
        else:
            fill_flat(image, box, corners, mix(red, green, blue, light[f, 0], light[f, 1]), 1.0)


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
                ball_starts[s, 0],
                ball_starts[s, 1],
                unit_triangles,
                unit_faces,
                unit_points,
                ball_screen,
                ball_light,
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
