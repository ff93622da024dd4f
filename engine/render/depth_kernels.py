"""Triangles into picture and depth: what is turned to the eye, row by row, span by span.

One idea: what all rows of a face share is worked out once for the face, what a row's pixels share
once for the row, and the spans do the rest (see `engine.render.span_kernels`).
Invariant: nothing outside rows [`top`, `bottom`) and the picture's width is touched.
"""
# ruff: noqa: FBT001  a kernel takes its flags by place

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

from engine.render.raster import blend, by_height, corners_of, rows_of, span_of
from engine.render.span_kernels import flat_span, lit_span, make_scratch, shiny_span

if TYPE_CHECKING:
    from engine.render.arrays import Bytes, Flags, Floats, Ints, Pixels, Singles


@njit(cache=True, nogil=True, error_model="numpy")
def plane_of(
    p: Floats, q: Floats, r: Floats, a: float, b: float, c: float
) -> tuple[float, float, float]:
    """Return the value at pixel (0, 0)'s corner and the slopes of a value given at 3 corners."""
    x1, y1, x2, y2 = q[0] - p[0], q[1] - p[1], r[0] - p[0], r[1] - p[1]
    area = x1 * y2 - x2 * y1
    du, dv = b - a, c - a
    sx = (du * y2 - dv * y1) / area
    sy = (dv * x1 - du * x2) / area
    return a - sx * p[0] - sy * p[1], sx, sy


@njit(cache=True, nogil=True, error_model="numpy")
def lamps_over(
    normal: Floats, offset: float, lamps: Floats, terms: Singles, shares: Singles
) -> None:
    """Write each lamp's height over a face to `terms` (n, 4), and its power on it to `shares`."""
    for k in range(len(lamps)):
        height = lamps[k, 0] * normal[0] + lamps[k, 1] * normal[1] + lamps[k, 2] * normal[2]
        terms[k, 3] = height - offset
        shares[k] = lamps[k, 3] * max(height - offset, 0.0)


@njit(cache=True, nogil=True, error_model="numpy")
def lamps_along(ray: Floats, eye: Floats, lamps: Floats, terms: Singles) -> None:
    """Write how each lamp lies along a row's rays to `terms` (see `lit_span`)."""
    for k in range(len(lamps)):
        x, y, z = lamps[k, 0] - eye[0], lamps[k, 1] - eye[1], lamps[k, 2] - eye[2]
        terms[k, 0] = 2.0 * (x * ray[0, 0] + y * ray[0, 1] + z * ray[0, 2])
        terms[k, 1] = 2.0 * (x * ray[1, 0] + y * ray[1, 1] + z * ray[1, 2])
        terms[k, 2] = x * x + y * y + z * z


@njit(cache=True, nogil=True, error_model="numpy")
def rays_of(u: float, v: float, basis: Floats, focal: float, ray: Floats) -> None:
    """Write the ray through a pixel, and how it grows from pixel to pixel, to `ray` (2, 3)."""
    for k in range(3):
        ray[0, k] = basis[0, k] * u + basis[1, k] * v + basis[2, k]
        ray[1, k] = basis[0, k] / focal


@njit(cache=True, nogil=True, error_model="numpy")
def fill_face(
    image: Pixels,
    depth: Singles,
    edge: tuple[float, float, float, float, float, float, float],
    rows: tuple[int, int],
    flat: bool,
    shade: np.uint32,
    plane: tuple[float, float, float],
    colour: tuple[np.float32, np.float32, np.float32],
    lit: np.float32,
    gloss: np.float32,
    rise: np.float32,
    scene: tuple[Floats, Floats, float],
    view: tuple[Floats, float, float, float],
    ray: Floats,
    terms: Singles,
    shares: Singles,
    scratch: Singles,
) -> None:
    """Fill one triangle of a flat face; with `flat`, with one colour."""
    x0, y0, x1, y1, x2, y2, cross = edge
    base, step_x, step_y = plane
    eye, lamps, _ = scene
    basis, focal, width, height = view
    for y in range(rows[0], rows[1]):
        begin, end = span_of(y, 0, int(width), x0, y0, x1, y1, x2, y2, cross)
        if begin >= end:
            continue
        px, py = begin + 0.5, y + 0.5
        inverse = np.float32(base + step_x * px + step_y * py)
        row, depths = image[y, begin:end], depth[y, begin:end]
        if flat:
            flat_span(row, depths, inverse, np.float32(step_x), shade)
            continue
        u, v = (px - width * 0.5) / focal, (py - height * 0.5) / focal
        rays_of(u, v, basis, focal, ray)
        lamps_along(ray, eye, lamps, terms)
        square = (
            np.float32(u * u + v * v + 1.0),
            np.float32(2.0 * u / focal),
            np.float32(1.0 / (focal * focal)),
        )
        lit_span(
            row,
            depths,
            inverse,
            np.float32(step_x),
            square,
            colour,
            lit,
            gloss,
            rise,
            terms,
            shares,
            scratch,
        )


@njit(cache=True, nogil=True, error_model="numpy")
def fill_smooth(
    image: Pixels,
    depth: Singles,
    edge: tuple[float, float, float, float, float, float, float],
    rows: tuple[int, int],
    plane: tuple[float, float, float],
    normal_planes: Floats,
    colour: tuple[np.float32, np.float32, np.float32],
    gloss: float,
    scene: tuple[Floats, Floats, float],
    view: tuple[Floats, float, float, float],
    ray: Floats,
    carried: Floats,
) -> None:
    """Fill one triangle whose normals change from corner to corner."""
    x0, y0, x1, y1, x2, y2, cross = edge
    base, step_x, step_y = plane
    basis, focal, width, height = view
    for y in range(rows[0], rows[1]):
        begin, end = span_of(y, 0, int(width), x0, y0, x1, y1, x2, y2, cross)
        if begin >= end:
            continue
        px, py = begin + 0.5, y + 0.5
        rays_of((px - width * 0.5) / focal, (py - height * 0.5) / focal, basis, focal, ray)
        for k in range(3):
            part = normal_planes[k]
            carried[0, k] = part[0] + part[1] * px + part[2] * py
            carried[1, k] = part[1]
        shiny_span(
            image[y, begin:end],
            depth[y, begin:end],
            base + step_x * px + step_y * py,
            step_x,
            ray,
            carried,
            colour,
            gloss,
            scene,
        )


@njit(cache=True, nogil=True, error_model="numpy")
def draw_triangles(
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
    """Draw the triangles turned to the eye. With `flat`, each face has its colour in `shades`."""
    corner = np.empty((4, 3))
    terms, shares = np.empty((len(lamps), 4), np.float32), np.empty(len(lamps), np.float32)
    ray, carried, normal_planes = np.empty((2, 3)), np.empty((2, 3)), np.empty((3, 3))
    scratch = make_scratch(int(width))
    scene, view = (eye, lamps, ambient), (basis, focal, width, height)
    lit_face = -1
    for t in range(len(triangles)):
        f = faces[t]
        n = face_normals[f]
        rise = n[0] * eye[0] + n[1] * eye[1] + n[2] * eye[2] - face_offsets[f]
        if rise <= 0.0 or face_light[f, 1] < 1.0:
            continue
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        count = corners_of(seen, screen, a, b, c, focal, near, width, height, corner)
        smooth = face_smooth[f] and not flat and count == 3
        colour = (
            np.float32(face_colours[f, 0]),
            np.float32(face_colours[f, 1]),
            np.float32(face_colours[f, 2]),
        )
        for part in range(count - 2):
            p, q, r = corner[0], corner[part + 1], corner[part + 2]
            edge = by_height(p[0], p[1], q[0], q[1], r[0], r[1])
            rows = rows_of(edge[1], edge[5], top, bottom)
            left, right = min(p[0], q[0], r[0]), max(p[0], q[0], r[0])
            if edge[6] == 0.0 or rows[0] >= rows[1] or right < 0.0 or left > width:
                continue
            plane = plane_of(p, q, r, p[2], q[2], r[2])
            if smooth:
                for k in range(3):
                    m = plane_of(
                        p, q, r, normals[a, k] * p[2], normals[b, k] * q[2], normals[c, k] * r[2]
                    )
                    normal_planes[k, 0], normal_planes[k, 1], normal_planes[k, 2] = m
                fill_smooth(
                    image,
                    depth,
                    edge,
                    rows,
                    plane,
                    normal_planes,
                    colour,
                    float(face_light[f, 0]),
                    scene,
                    view,
                    ray,
                    carried,
                )
                continue
            if f != lit_face and not flat:
                lamps_over(n, face_offsets[f], lamps, terms, shares)
                lit_face = f
            fill_face(
                image,
                depth,
                edge,
                rows,
                flat,
                shades[f],
                plane,
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
            for y in range(rows[0], rows[1]):
                begin, end = span_of(y, 0, int(width), x0, y0, x1, y1, x2, y2, cross)
                for x in range(begin, end):
                    inverse = base + step_x * (x + 0.5) + step_y * (y + 0.5)
                    if inverse > depth[y, x]:
                        image[y, x] = blend(image[y, x], shades[f], part)
