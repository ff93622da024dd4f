"""Surfaces into picture and depth: what is turned to the eye, row by row, span by span.

One idea: the triangles of one plane and look are one surface; where their spans meet they are one
span, whose depth follows from the plane itself, not from corners that were moved to a raster (see
`engine.render.cover_kernels` and `engine.render.surface_kernels`).
Invariant: nothing outside rows [`top`, `bottom`) and the picture's width is touched.
"""
# ruff: noqa: FBT001  a kernel takes its flags by place

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

from engine.render.cover_kernels import FAR, cover, cover_border
from engine.render.raster import by_height, corners_of, rows_of, slopes_of, span_of
from engine.render.span_kernels import make_scratch, tint_span
from engine.render.surface_kernels import (
    fill_smooth,
    lamps_over,
    plane_of,
    plane_over,
    shade_surface,
)

if TYPE_CHECKING:
    from engine.render.arrays import Bytes, Flags, Floats, Ints, Pixels, Singles

LEAST_RISE = 1e-7
"""A face that the eye is no higher above (m) is seen edge-on."""


@njit(cache=True, nogil=True, error_model="numpy")
def draw_triangles(
    image: Pixels,
    depth: Singles,
    top: int,
    bottom: int,
    order: Ints,
    starts: Ints,
    edges: Ints,
    edge_starts: Ints,
    seen: Floats,
    screen: Floats,
    triangles: Ints,
    faces: Ints,
    face_normals: Floats,
    face_offsets: Floats,
    face_colours: Bytes,
    face_light: Singles,
    face_smooth: Flags,
    normals: Singles,
    lamps: Floats,
    ambient: float,
    flat: bool,
    shades: Pixels,
    eye: Floats,
    basis: Floats,
    focal: float,
    near: float,
    width: float,
    height: float,
) -> None:
    """Draw the triangles turned to the eye, in groups of one plane and look (see `groups`).

    With `flat`, each face has its colour in `shades`, and each group is one face.
    """
    wide = int(width)
    corner, bounds = np.empty((4, 3)), np.empty(4)
    terms, shares = np.empty((len(lamps), 4), np.float32), np.empty(len(lamps), np.float32)
    ray, carried, normal_planes = np.empty((2, 3)), np.empty((2, 3)), np.empty((3, 3))
    scratch = make_scratch(wide)
    words = np.zeros((bottom - top, wide // 8 + 1), np.int64)
    turns = words.view(np.uint8)
    reach = np.empty((bottom - top, 2), np.int32)
    reach[:, 0], reach[:, 1] = FAR, -1
    scene, view = (eye, lamps, ambient), (basis, focal, width, height)
    for g in range(len(starts) - 1):
        f = faces[order[starts[g]]]
        n = face_normals[f]
        rise = n[0] * eye[0] + n[1] * eye[1] + n[2] * eye[2] - face_offsets[f]
        if rise <= LEAST_RISE or face_light[f, 1] < 1.0:
            continue
        colour = (
            np.float32(face_colours[f, 0]),
            np.float32(face_colours[f, 1]),
            np.float32(face_colours[f, 2]),
        )
        bounds[0], bounds[1], bounds[2], bounds[3] = bottom, top, 1e30, 0.0
        smooth = face_smooth[f] and not flat
        known = not smooth and edge_starts[g] < edge_starts[g + 1]
        known = known and cover_border(
            edges,
            edge_starts[g],
            edge_starts[g + 1],
            screen,
            (top, bottom),
            wide,
            turns,
            reach,
            bounds,
        )
        for k in range(starts[g], starts[g] if known else starts[g + 1]):
            a, b, c = triangles[order[k], 0], triangles[order[k], 1], triangles[order[k], 2]
            count = corners_of(seen, screen, a, b, c, focal, near, width, height, corner)
            if count != 3 or not smooth:
                cover(corner, count, (top, bottom), wide, turns, reach, bounds)
                continue
            p, q, r = corner[0], corner[1], corner[2]
            edge = by_height(p[0], p[1], q[0], q[1], r[0], r[1])
            rows = rows_of(edge[1], edge[5], top, bottom)
            if edge[6] == 0.0 or rows[0] >= rows[1]:
                continue
            for m in range(3):
                normal_planes[m] = plane_of(
                    p, q, r, normals[a, m] * p[2], normals[b, m] * q[2], normals[c, m] * r[2]
                )
            fill_smooth(
                image,
                depth,
                edge,
                rows,
                plane_of(p, q, r, p[2], q[2], r[2]),
                normal_planes,
                colour,
                float(face_light[f, 0]),
                scene,
                view,
                ray,
                carried,
            )
        if bounds[0] >= bounds[1]:
            continue
        lamps_over(n, face_offsets[f], lamps, terms, shares)
        shade_surface(
            image,
            depth,
            top,
            turns,
            words,
            reach,
            plane_over(n, rise, basis),
            bounds,
            flat,
            shades[f],
            colour,
            np.float32(ambient * (0.76 + 0.24 * n[2])),
            np.float32(0.5 * face_light[f, 0]),
            np.float32(rise),
            scene,
            view,
            ray,
            terms,
            shares,
            scratch,
        )


@njit(cache=True, nogil=True, error_model="numpy")
def draw_tints(
    image: Pixels,
    depth: Singles,
    top: int,
    bottom: int,
    seen: Floats,
    screen: Floats,
    triangles: Ints,
    faces: Ints,
    face_normals: Floats,
    face_offsets: Floats,
    face_light: Singles,
    shades: Pixels,
    eye: Floats,
    focal: float,
    near: float,
    width: float,
    height: float,
) -> None:
    """Mix in the triangles that let light through, each with its shade; they hide nothing."""
    corner = np.empty((4, 3))
    for t in range(len(triangles)):
        f = faces[t]
        n = face_normals[f]
        toward = n[0] * eye[0] + n[1] * eye[1] + n[2] * eye[2]
        if face_light[f, 1] >= 1.0 or toward <= face_offsets[f]:
            continue
        part = np.uint32(face_light[f, 1] * 256.0 + 0.5)
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        count = corners_of(seen, screen, a, b, c, focal, near, width, height, corner)
        for piece in range(count - 2):
            p, q, r = corner[0], corner[piece + 1], corner[piece + 2]
            x0, y0, x1, y1, x2, y2, cross = by_height(p[0], p[1], q[0], q[1], r[0], r[1])
            rows = rows_of(y0, y2, top, bottom)
            if cross == 0.0 or rows[0] >= rows[1]:
                continue
            base, step_x, step_y = plane_of(p, q, r, p[2], q[2], r[2])
            slopes = slopes_of(x0, y0, x1, y1, x2, y2)
            for y in range(rows[0], rows[1]):
                begin, end = span_of(y, 0, int(width), x0, y0, x1, y1, y2, cross, slopes)
                if begin < end:
                    w = base + step_x * (begin + 0.5) + step_y * (y + 0.5)
                    pixels, depths = image[y, begin:end], depth[y, begin:end]
                    tint_span(pixels, depths, np.float32(w), np.float32(step_x), shades[f], part)
