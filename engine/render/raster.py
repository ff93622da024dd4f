"""From points in the world to spans of pixels: projection, near clip and the fill rule.

One idea: corners are snapped to 1/256 pixel and every edge is evaluated in float64 from its
upper to its lower end, so that two triangles that share an edge agree on every row where it is.
Invariant: a pixel whose middle is inside a closed surface's outline is hit exactly once by its
front; nothing outside the box that may be touched is.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

if TYPE_CHECKING:
    from engine.render.arrays import Floats, Pixels


SNAP = 256.0
FEW = 12
"""Pixels of a row that are filled one by one, without a view of the row."""


@njit(cache=True, nogil=True, error_model="numpy")
def project_points(
    points: Floats,
    eye: Floats,
    basis: Floats,
    focal: float,
    near: float,
    width: float,
    height: float,
    seen: Floats,
    screen: Floats,
) -> None:
    """Write camera coordinates to `seen` (n, 3), and x, y (px), 1/z to `screen` (n, 3).

    1/z is zero for a point nearer than the near plane.
    """
    for i in range(len(points)):
        dx, dy, dz = points[i, 0] - eye[0], points[i, 1] - eye[1], points[i, 2] - eye[2]
        x = basis[0, 0] * dx + basis[0, 1] * dy + basis[0, 2] * dz
        y = basis[1, 0] * dx + basis[1, 1] * dy + basis[1, 2] * dz
        z = basis[2, 0] * dx + basis[2, 1] * dy + basis[2, 2] * dz
        seen[i, 0], seen[i, 1], seen[i, 2] = x, y, z
        if z < near:
            screen[i, 2] = 0.0
            continue
        w = 1.0 / z
        screen[i, 0] = np.floor((width * 0.5 + focal * x * w) * SNAP + 0.5) / SNAP
        screen[i, 1] = np.floor((height * 0.5 + focal * y * w) * SNAP + 0.5) / SNAP
        screen[i, 2] = w


@njit(cache=True, nogil=True, error_model="numpy")
def corners_of(
    seen: Floats,
    screen: Floats,
    a: int,
    b: int,
    c: int,
    focal: float,
    near: float,
    width: float,
    height: float,
    out: Floats,
) -> int:
    """Write the corners of a triangle after the near clip to `out` (4, 3); return how many.

    A cut edge is always measured from its inner end outwards: neighbours cut alike.
    """
    inside = (screen[a, 2] > 0.0) + (screen[b, 2] > 0.0) + (screen[c, 2] > 0.0)
    if inside == 0:
        return 0
    if inside == 3:
        for k in range(3):
            out[0, k], out[1, k], out[2, k] = screen[a, k], screen[b, k], screen[c, k]
        return 3
    count = 0
    for side in range(3):
        if side == 0:
            here, after = a, b
        elif side == 1:
            here, after = b, c
        else:
            here, after = c, a
        here_in, after_in = screen[here, 2] > 0.0, screen[after, 2] > 0.0
        if here_in:
            for k in range(3):
                out[count, k] = screen[here, k]
            count += 1
        if here_in != after_in:
            start, end = (here, after) if here_in else (after, here)
            share = (near - seen[start, 2]) / (seen[end, 2] - seen[start, 2])
            x = seen[start, 0] + share * (seen[end, 0] - seen[start, 0])
            y = seen[start, 1] + share * (seen[end, 1] - seen[start, 1])
            w = 1.0 / near
            out[count, 0] = np.floor((width * 0.5 + focal * x * w) * SNAP + 0.5) / SNAP
            out[count, 1] = np.floor((height * 0.5 + focal * y * w) * SNAP + 0.5) / SNAP
            out[count, 2] = w
            count += 1
    return count


@njit(cache=True, nogil=True, error_model="numpy")
def by_height(
    x0: float, y0: float, x1: float, y1: float, x2: float, y2: float
) -> tuple[float, float, float, float, float, float, float]:
    """Return the corners from the upper to the lower, and whether the middle one is right."""
    if y1 < y0:
        x0, y0, x1, y1 = x1, y1, x0, y0
    if y2 < y0:
        x0, y0, x2, y2 = x2, y2, x0, y0
    if y2 < y1:
        x1, y1, x2, y2 = x2, y2, x1, y1
    cross = (x1 - x0) * (y2 - y0) - (y1 - y0) * (x2 - x0)
    return x0, y0, x1, y1, x2, y2, cross


@njit(cache=True, nogil=True, error_model="numpy")
def span_of(
    y: int,
    begin: int,
    end: int,
    x0: float,
    y0: float,
    x1: float,
    y1: float,
    y2: float,
    cross: float,
    slopes: tuple[float, float, float],
) -> tuple[int, int]:
    """Return the first pixel and the one after the last of a row, within `begin` and `end`.

    The corners come as from `by_height`, with their `slopes_of`.
    """
    middle = y + 0.5
    along = x0 + (middle - y0) * slopes[0]
    if middle < y1:
        aside = x0 + (middle - y0) * slopes[1] if y1 > y0 else x1
    else:
        aside = x1 + (middle - y1) * slopes[2] if y2 > y1 else x1
    left, right = (along, aside) if cross > 0.0 else (aside, along)
    left = min(max(left, begin), end + 1.0)
    right = min(max(right, begin), end + 1.0)
    return max(int(np.ceil(left - 0.5)), begin), min(int(np.ceil(right - 0.5)), end)


@njit(cache=True, nogil=True, error_model="numpy")
def rows_of(y0: float, y2: float, top: int, bottom: int) -> tuple[int, int]:
    """Return the first row and the one after the last between two heights."""
    first = np.ceil(min(max(y0, top - 1.0), bottom + 1.0) - 0.5)
    last = np.ceil(min(max(y2, top - 1.0), bottom + 1.0) - 0.5)
    return max(int(first), top), min(int(last), bottom)


@njit(cache=True, nogil=True, error_model="numpy")
def slopes_of(
    x0: float, y0: float, x1: float, y1: float, x2: float, y2: float
) -> tuple[float, float, float]:
    """Return x per y of the long edge, the upper and the lower one; corners as `by_height`."""
    long = (x2 - x0) / (y2 - y0) if y2 > y0 else 0.0
    upper = (x1 - x0) / (y1 - y0) if y1 > y0 else 0.0
    lower = (x2 - x1) / (y2 - y1) if y2 > y1 else 0.0
    return long, upper, lower


@njit(cache=True, nogil=True, error_model="numpy")
def fill_flat(
    image: Pixels,
    box: tuple[int, int, int, int],
    corners: tuple[float, float, float, float, float, float],
    colour: np.uint32,
    share: float,
) -> None:
    """Fill one triangle with one colour, or mix it in where `share` is less than 1.

    `box` is the first column and row that may be touched, and those after the last; `corners` are
    x and y of each.
    """
    left, top, right, bottom = box
    ax, ay, bx, by, cx, cy = corners
    if max(ax, bx, cx) < left or min(ax, bx, cx) > right:
        return
    x0, y0, x1, y1, x2, y2, cross = by_height(ax, ay, bx, by, cx, cy)
    first, last = rows_of(y0, y2, top, bottom)
    if cross == 0.0 or first >= last:
        return
    slopes = slopes_of(x0, y0, x1, y1, x2, y2)
    part = np.uint32(share * 256.0)
    for y in range(first, last):
        begin, end = span_of(y, left, right, x0, y0, x1, y1, y2, cross, slopes)
        if share >= 1.0 and end - begin < FEW:
            for x in range(begin, end):
                image[y, x] = colour
        elif share >= 1.0:
            row = image[y, begin:end]
            for i in range(row.shape[0]):
                row[i] = colour
        elif begin < end:
            row = image[y, begin:end]
            for i in range(row.shape[0]):
                row[i] = blend(row[i], colour, part)


@njit(cache=True, nogil=True, error_model="numpy")
def blend(old: np.uint32, new: np.uint32, part: np.uint32) -> np.uint32:
    """Return `new` mixed into `old` by `part` / 256, both 0x00RRGGBB."""
    odd, even = np.uint32(0xFF00FF), np.uint32(0x00FF00)
    keep = np.uint32(256) - part
    outer = ((old & odd) * keep + (new & odd) * part + np.uint32(0x800080)) >> np.uint32(8)
    inner = ((old & even) * keep + (new & even) * part + np.uint32(0x008000)) >> np.uint32(8)
    return np.uint32((outer & odd) | (inner & even))
