"""The painter's strokes: parts and spheres filled one after the other, each face one light."""
# ruff: noqa: FBT001  a kernel takes its flags by place

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

from engine.render.raster import SNAP, by_height, corners_of, fill_flat, rows_of, span_of
from engine.render.shading import light_at, mix, texel

if TYPE_CHECKING:
    from engine.render.arrays import Bytes, Floats, Ints, Pixels, Singles


@njit(cache=True, nogil=True, error_model="numpy")
def paint_part(
    image: Pixels,
    top: int,
    bottom: int,
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
) -> None:
    """Fill the triangles first to last that are turned to the eye."""
    height, width = image.shape
    corner = np.empty((4, 3))
    for t in range(first, last):
        f = faces[t]
        if normals[f, 0] * eye[0] + normals[f, 1] * eye[1] + normals[f, 2] * eye[2] <= offsets[f]:
            continue
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        count = corners_of(seen, screen, a, b, c, focal, near, float(width), float(height), corner)
        for part in range(count - 2):
            fill_flat(
                image,
                top,
                bottom,
                corner[0],
                corner[part + 1],
                corner[part + 2],
                shades[f],
                lights[f, 1],
            )


@njit(cache=True, nogil=True, error_model="numpy")
def fill_skin(
    image: Pixels,
    top: int,
    bottom: int,
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
    x0, y0, x1, y1, x2, y2, cross = by_height(p[0], p[1], q[0], q[1], r[0], r[1])
    if cross == 0.0:
        return
    width = image.shape[1]
    ax, ay, bx, by = q[0] - p[0], q[1] - p[1], r[0] - p[0], r[1] - p[1]
    scale = 1.0 / (ax * by - bx * ay)
    first, last = rows_of(y0, y2, top, bottom)
    for y in range(first, last):
        begin, end = span_of(y, width, x0, y0, x1, y1, x2, y2, cross)
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
    top: int,
    bottom: int,
    upper_half: bool,
    points: Floats,
    triangles: Ints,
    faces: Ints,
    normals: Floats,
    face_centres: Floats,
    centre: Floats,
    rotation: Floats,
    radius: float,
    colour: Bytes,
    gloss: float,
    skins: Bytes,
    offset: int,
    size: int,
    eye: Floats,
    basis: Floats,
    focal: float,
    near: float,
    lamps: Floats,
    ambient: float,
) -> None:
    """Fill a sphere made of the unit sphere's triangles; `upper_half`: only above the ground."""
    height, width = image.shape
    away = 0.0
    for k in range(3):
        away += basis[2, k] * (centre[k] - eye[k])
    if away - radius < near:
        return
    count = len(points)
    screen = np.empty((count, 2))
    for i in range(count):
        seen = np.zeros(3)
        for k in range(3):
            place = centre[k] - eye[k]
            for m in range(3):
                place += radius * rotation[k, m] * points[i, m]
            seen[0] += basis[0, k] * place
            seen[1] += basis[1, k] * place
            seen[2] += basis[2, k] * place
        w = 1.0 / seen[2]
        screen[i, 0] = np.floor((width * 0.5 + focal * seen[0] * w) * SNAP + 0.5) / SNAP
        screen[i, 1] = np.floor((height * 0.5 + focal * seen[1] * w) * SNAP + 0.5) / SNAP
    own = np.empty((3, 3))
    n, p = np.empty(3), np.empty(3)
    for t in range(len(triangles)):
        f = faces[t]
        toward = 0.0
        for k in range(3):
            n[k] = 0.0
            p[k] = centre[k]
            for m in range(3):
                n[k] += rotation[k, m] * normals[f, m]
                p[k] += radius * rotation[k, m] * face_centres[f, m]
            toward += n[k] * (eye[k] - p[k])
        if toward <= 0.0 or (upper_half and p[2] < 0.0):
            continue
        light, shine = light_at(
            p[0], p[1], p[2], n[0], n[1], n[2], eye, lamps, ambient, gloss * 0.5
        )
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        if size > 0:
            for k in range(3):
                own[0, k], own[1, k], own[2, k] = points[a, k], points[b, k], points[c, k]
            fill_skin(
                image,
                top,
                bottom,
                screen[a],
                screen[b],
                screen[c],
                own,
                light,
                shine,
                skins,
                offset,
                size,
            )
        else:
            shade = mix(float(colour[0]), float(colour[1]), float(colour[2]), light, shine)
            fill_flat(image, top, bottom, screen[a], screen[b], screen[c], shade, 1.0)
