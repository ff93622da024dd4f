"""Surfaces lit: what all of a surface shares, what a row shares, and its spans.

One idea: what all rows of a face share is worked out once for the face, what a row's pixels share
once for the row, and the spans do the rest (see `engine.render.span_kernels`).
Invariant: a pixel's depth lies within the depths of its surface's corners.
"""
# ruff: noqa: FBT001  a kernel takes its flags by place

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

from engine.render.cover_kernels import FAR, next_turn
from engine.render.raster import slopes_of, span_of
from engine.render.span_kernels import flat_span, lit_span, shiny_span

if TYPE_CHECKING:
    from engine.render.arrays import Bytes, Floats, Ints, Longs, Pixels, Singles


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
def plane_over(normal: Floats, rise: float, basis: Floats) -> tuple[float, float, float]:
    """Return 1/z on a face along the ray (u, v, 1) as a constant and the shares of u and v.

    `rise` is the eye's height over the face.
    """
    ahead, right, down = 0.0, 0.0, 0.0
    for k in range(3):
        right -= normal[k] * basis[0, k]
        down -= normal[k] * basis[1, k]
        ahead -= normal[k] * basis[2, k]
    return ahead / rise, right / rise, down / rise


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
def along_plane(w: float, grow: float, count: int, low: float, high: float) -> tuple[float, float]:
    """Return 1/z at a span's first pixel and its growth, within the surface's own bounds.

    A surface seen edge-on grows without bounds from pixel to pixel; its pixels do not lie beyond
    its corners.
    """
    end = w + grow * (count - 1)
    if low <= w <= high and low <= end <= high:
        return w, grow
    w, end = min(max(w, low), high), min(max(end, low), high)
    return w, (end - w) / max(count - 1, 1)


@njit(cache=True, nogil=True, error_model="numpy")
def shade_surface(
    image: Pixels,
    depth: Singles,
    top: int,
    turns: Bytes,
    words: Longs,
    reach: Ints,
    plane: tuple[float, float, float],
    bounds: Floats,
    flat: bool,
    shade: np.uint32,
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
    """Shade the spans that were noted of a surface, and clear what was noted."""
    basis, focal, width, height = view
    for y in range(int(bounds[0]), int(bounds[1])):
        row, level, begin = y - top, 0, 0
        last = reach[row, 1]
        v = (y + 0.5 - height * 0.5) / focal
        x = next_turn(turns, words, row, reach[row, 0], last)
        while x <= last:
            before = level
            level = (level + int(turns[row, x])) & 255
            turns[row, x] = 0
            if before == 0:
                begin = x
            elif level == 0:
                u = (begin + 0.5 - width * 0.5) / focal
                start = plane[0] + plane[1] * u + plane[2] * v
                w, grow = along_plane(start, plane[1] / focal, x - begin, bounds[2], bounds[3])
                pixels, depths = image[y, begin:x], depth[y, begin:x]
                if flat:
                    flat_span(pixels, depths, np.float32(w), np.float32(grow), shade)
                else:
                    rays_of(u, v, basis, focal, ray)
                    lamps_along(ray, scene[0], scene[1], terms)
                    square = (
                        np.float32(u * u + v * v + 1.0),
                        np.float32(2.0 * u / focal),
                        np.float32(1.0 / (focal * focal)),
                    )
                    lit_span(
                        pixels,
                        depths,
                        np.float32(w),
                        np.float32(grow),
                        square,
                        colour,
                        lit,
                        gloss,
                        rise,
                        terms,
                        shares,
                        scratch,
                    )
            x = next_turn(turns, words, row, x + 1, last)
        reach[row, 0], reach[row, 1] = FAR, -1


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
    slopes = slopes_of(x0, y0, x1, y1, x2, y2)
    for y in range(rows[0], rows[1]):
        begin, end = span_of(y, 0, int(width), x0, y0, x1, y1, y2, cross, slopes)
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
