"""Lines in pixels: near clip, Liang-Barsky, and strokes whose edges are blended.

One idea: segments become strokes on the screen once a frame, and every band of rows draws those
that cross it. A stroke steps along its longer way and covers, across it, the share of each pixel
that its width reaches. Invariant: a row outside [`top`, `bottom`) is never touched.
"""
# ruff: noqa: FBT001  a kernel takes its flags by place

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

from engine.render.raster import blend

if TYPE_CHECKING:
    from engine.render.arrays import Bytes, Floats, Pixels, Singles

FIELDS = 8
"""Numbers of a stroke: x, y (px), 1/z at both ends, pixels of half its width per 1/z, alpha."""


@njit(cache=True, nogil=True, error_model="numpy")
def place_stroke(
    a: Floats, b: Floats, width: float, height: float, focal: float, near: float, out: Floats
) -> bool:
    """Write ends on the screen of a segment a to b in camera coordinates, cut at the near plane.

    Returns False where nothing of it is ahead of the eye.
    """
    if a[2] < near and b[2] < near:
        return False
    for end in range(2):
        here, other = (a, b) if end == 0 else (b, a)
        x, y, z = here[0], here[1], here[2]
        if z < near:
            share = (near - other[2]) / (z - other[2])
            x = other[0] + share * (x - other[0])
            y = other[1] + share * (y - other[1])
            z = near
        inverse = 1.0 / z
        out[3 * end] = width * 0.5 + focal * x * inverse
        out[3 * end + 1] = height * 0.5 + focal * y * inverse
        out[3 * end + 2] = inverse
    return True


@njit(cache=True, nogil=True, error_model="numpy")
def see_point(p: Floats, eye: Floats, basis: Floats, out: Floats) -> None:
    """Write the camera coordinates of a point in the world."""
    dx, dy, dz = p[0] - eye[0], p[1] - eye[1], p[2] - eye[2]
    for k in range(3):
        out[k] = basis[k, 0] * dx + basis[k, 1] * dy + basis[k, 2] * dz


@njit(cache=True, nogil=True, error_model="numpy")
def place_segments(
    ends: Floats,
    colours: Bytes,
    widths: Floats,
    alphas: Floats,
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
    """Write segments (n, 2, 3) as strokes from number `start` on; return the number after."""
    a, b = np.empty(3), np.empty(3)
    count = start
    for i in range(len(ends)):
        see_point(ends[i, 0], eye, basis, a)
        see_point(ends[i, 1], eye, basis, b)
        if not place_stroke(a, b, width, height, focal, near, strokes[count]):
            continue
        strokes[count, 6], strokes[count, 7] = 0.5 * widths[i] * focal, alphas[i]
        red, green, blue = np.uint32(colours[i, 0]), np.uint32(colours[i, 1]), colours[i, 2]
        shades[count] = (red << np.uint32(16)) | (green << np.uint32(8)) | np.uint32(blue)
        count += 1
    return count


@njit(cache=True, nogil=True, error_model="numpy")
def clip_line(
    x0: float, y0: float, x1: float, y1: float, room: float, top: float, bottom: float, width: float
) -> tuple[float, float]:
    """Return the shares of a line where it enters and leaves a box (Liang and Barsky 1984)."""
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
                return 1.0, 0.0
        elif p < 0.0:
            enter = max(enter, q / p)
        else:
            leave = min(leave, q / p)
    return enter, leave


@njit(cache=True, nogil=True, error_model="numpy")
def draw_stroke(
    image: Pixels,
    width: int,
    depth: Singles,
    tested: bool,
    top: int,
    bottom: int,
    line: Floats,
    shade: np.uint32,
    least: float,
) -> None:
    """Draw one stroke; half its width is `least` pixels at least."""
    x0, y0, w0, x1, y1, w1 = line[0], line[1], line[2], line[3], line[4], line[5]
    scale, strength = line[6], 256.0 * line[7]
    room = max(scale * max(w0, w1), least) + 2.0
    if max(y0, y1) + room < top or min(y0, y1) - room > bottom:
        return
    enter, leave = clip_line(x0, y0, x1, y1, room, float(top), float(bottom), float(width))
    dx, dy = x1 - x0, y1 - y0
    steep = abs(dy) > abs(dx)
    long = dy if steep else dx
    if enter >= leave or long == 0.0:
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
        reach = max(scale * inverse, least) * lean + 0.5
        # the pixels whose middles are nearer than `reach`
        begin = max(int(middle - reach + 1024.5) - 1024, floor_cross)
        stop = min(int(middle + reach + 1024.5) - 1024, limit_cross)
        for minor in range(begin, stop):
            share = min(reach - abs(minor + 0.5 - middle), 1.0)
            part = np.uint32(max(share, 0.0) * strength + 0.5)
            y, x = (major, minor) if steep else (minor, major)
            if tested and inverse * 1.002 < depth[y, x]:
                continue
            image[y, x] = blend(image[y, x], shade, part)


@njit(cache=True, nogil=True, error_model="numpy")
def draw_strokes(
    image: Pixels,
    width: int,
    depth: Singles,
    tested: bool,
    top: int,
    bottom: int,
    strokes: Floats,
    shades: Pixels,
    first: int,
    last: int,
    least: float,
) -> None:
    """Draw strokes first to last; where `tested`, only in front of `depth` (1/z)."""
    for i in range(first, last):
        draw_stroke(image, width, depth, tested, top, bottom, strokes[i], shades[i], 0.5 * least)
