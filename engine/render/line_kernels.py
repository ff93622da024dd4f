"""Lines in pixels: near clip, Liang-Barsky, and strokes whose edges are blended.

One idea: a stroke steps along its longer way and covers, across it, the share of each pixel
that its width reaches. Invariant: a row outside [`top`, `bottom`) is never touched, so bands of
rows may be drawn at the same time.
"""
# ruff: noqa: FBT001  a kernel takes its flags by place

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

if TYPE_CHECKING:
    from engine.render.arrays import Bytes, Floats, Ints, Pixels, Singles


@njit(cache=True, nogil=True, error_model="numpy")
def blend(image: Pixels, y: int, x: int, r: float, g: float, b: float, share: float) -> None:
    """Mix a colour into one pixel of an (h, w) uint32 image, 0x00RRGGBB."""
    old = image[y, x]
    keep = 1.0 - share
    red = int(((old >> 16) & 255) * keep + r * share + 0.5)
    green = int(((old >> 8) & 255) * keep + g * share + 0.5)
    blue = int((old & 255) * keep + b * share + 0.5)
    image[y, x] = np.uint32((red << 16) | (green << 8) | blue)


@njit(cache=True, nogil=True, error_model="numpy")
def stroke(
    image: Pixels,
    depth: Singles,
    tested: bool,
    top: int,
    bottom: int,
    line: tuple[float, float, float, float, float, float],
    colour: Bytes,
    alpha: float,
    scale: float,
    least: float,
) -> None:
    """Draw one stroke from `line` (x, y in pixels, 1/z at both ends).

    Half its width is `scale` times 1/z, and `least` pixels at least.
    """
    width = image.shape[1]
    x0, y0, w0, x1, y1, w1 = line
    # Liang-Barsky against the picture, with room for the stroke's width
    room = max(scale * max(w0, w1), least) + 2.0
    dx, dy = x1 - x0, y1 - y0
    enter, leave = 0.0, 1.0
    for side in range(4):
        if side == 0:
            p, q = -dx, x0 + room
        elif side == 1:
            p, q = dx, width + room - x0
        elif side == 2:
            p, q = -dy, y0 + room - top
        else:
            p, q = dy, bottom + room - y0
        if p == 0.0:
            if q < 0.0:
                return
        elif p < 0.0:
            enter = max(enter, q / p)
        else:
            leave = min(leave, q / p)
    if enter >= leave:
        return
    r, g, b = float(colour[0]), float(colour[1]), float(colour[2])
    steep = abs(dy) > abs(dx)
    long = dy if steep else dx
    if long == 0.0:
        return
    start = y0 if steep else x0
    low, high = start + enter * long, start + leave * long
    if low > high:
        low, high = high, low
    slope = (dx if steep else dy) / long
    lean = np.sqrt(1.0 + slope * slope)
    base = x0 if steep else y0
    rate = (w1 - w0) / long
    first = max(int(np.ceil(low - 0.5)), top if steep else 0)
    last = min(int(np.ceil(high - 0.5)), bottom if steep else width)
    floor_cross = 0 if steep else top
    limit_cross = width if steep else bottom
    for major in range(first, last):
        gone = major + 0.5 - start
        middle = base + gone * slope
        inverse = w0 + gone * rate
        reach = max(scale * inverse, least) * lean
        begin = max(int(np.floor(middle - reach - 0.5)), floor_cross)
        stop = min(int(np.ceil(middle + reach + 0.5)) + 1, limit_cross)
        for minor in range(begin, stop):
            share = reach + 0.5 - abs(minor + 0.5 - middle)
            if share <= 0.0:
                continue
            share = min(share, 1.0) * alpha
            y, x = (major, minor) if steep else (minor, major)
            if tested and inverse * 1.002 < depth[y, x]:
                continue
            blend(image, y, x, r, g, b, share)


@njit(cache=True, nogil=True, error_model="numpy")
def segment(
    image: Pixels,
    depth: Singles,
    tested: bool,
    top: int,
    bottom: int,
    a: Floats,
    b: Floats,
    view: tuple[Floats, Floats, float, float],
    colour: Bytes,
    alpha: float,
    width: float,
    least: float,
) -> None:
    """Draw a segment between two points in the world, clipped at the near plane."""
    eye, basis, focal, near = view
    ends = np.empty((2, 3))
    for k in range(3):
        ends[0, k] = 0.0
        ends[1, k] = 0.0
        for i in range(3):
            ends[0, k] += basis[k, i] * (a[i] - eye[i])
            ends[1, k] += basis[k, i] * (b[i] - eye[i])
    if ends[0, 2] < near and ends[1, 2] < near:
        return
    for k in range(2):
        if ends[k, 2] < near:
            share = (near - ends[1 - k, 2]) / (ends[k, 2] - ends[1 - k, 2])
            for i in range(2):
                ends[k, i] = ends[1 - k, i] + share * (ends[k, i] - ends[1 - k, i])
            ends[k, 2] = near
    height, wide = image.shape
    w0, w1 = 1.0 / ends[0, 2], 1.0 / ends[1, 2]
    line = (
        wide * 0.5 + focal * ends[0, 0] * w0,
        height * 0.5 + focal * ends[0, 1] * w0,
        w0,
        wide * 0.5 + focal * ends[1, 0] * w1,
        height * 0.5 + focal * ends[1, 1] * w1,
        w1,
    )
    scale = 0.5 * width * focal
    stroke(image, depth, tested, top, bottom, line, colour, alpha, scale, 0.5 * least)


@njit(cache=True, nogil=True, error_model="numpy")
def draw_segments(
    image: Pixels,
    depth: Singles,
    tested: bool,
    top: int,
    bottom: int,
    ends: Floats,
    colours: Bytes,
    widths: Floats,
    alphas: Floats,
    eye: Floats,
    basis: Floats,
    focal: float,
    near: float,
    least: float,
) -> None:
    """Draw segments (n, 2, 3); where `tested`, only in front of `depth` (1/z)."""
    view = (eye, basis, focal, near)
    for i in range(len(ends)):
        segment(
            image,
            depth,
            tested,
            top,
            bottom,
            ends[i, 0],
            ends[i, 1],
            view,
            colours[i],
            alphas[i],
            widths[i],
            least,
        )


@njit(cache=True, nogil=True, error_model="numpy")
def select_edges(edges: Ints, normals: Floats, offsets: Floats, eye: Floats, chosen: Ints) -> int:
    """Write the numbers of edges with a face turned to the eye to `chosen`; return how many."""
    count = 0
    for i in range(len(edges)):
        for side in range(2, 4):
            face = edges[i, side]
            if face < 0:
                continue
            way = 0.0
            for k in range(3):
                way += normals[face, k] * eye[k]
            if way > offsets[face]:
                chosen[count] = i
                count += 1
                break
    return count
