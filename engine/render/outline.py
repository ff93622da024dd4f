"""Outlines on the screen: the convex polygon that a part or a sphere covers.

One idea: only parts whose outlines overlap need an order; boxes alone would ask for orders that
are not needed, and those can run in a circle.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

from engine.render.raster import corners_of

if TYPE_CHECKING:
    from engine.render.arrays import Flags, Floats, Ints, Longs


ROUND = 16
"""Corners of the polygon about a sphere's outline."""


@njit(cache=True, nogil=True, error_model="numpy")
def convex_hull(points: Floats, count: int, hull: Floats) -> int:
    """Write the hull of points (n, 2) to `hull` and return its size (Andrew 1979).

    The points are sorted in place.
    """
    for i in range(1, count):
        x, y = points[i, 0], points[i, 1]
        k = i
        while k > 0 and (points[k - 1, 0] > x or (points[k - 1, 0] == x and points[k - 1, 1] > y)):
            points[k, 0], points[k, 1] = points[k - 1, 0], points[k - 1, 1]
            k -= 1
        points[k, 0], points[k, 1] = x, y
    size = 0
    for sweep in range(2):
        least = size + 1
        for step in range(count):
            i = step if sweep == 0 else count - 1 - step
            x, y = points[i, 0], points[i, 1]
            while (
                size > least
                and (
                    (hull[size - 1, 0] - hull[size - 2, 0]) * (y - hull[size - 2, 1])
                    - (hull[size - 1, 1] - hull[size - 2, 1]) * (x - hull[size - 2, 0])
                )
                <= 0.0
            ):
                size -= 1
            hull[size, 0], hull[size, 1] = x, y
            size += 1
        size -= 1
    return size


@njit(cache=True, nogil=True, error_model="numpy")
def close_outline(
    points: Floats, count: int, item: int, boxes: Floats, outlines: Floats, spans: Longs
) -> None:
    """Write the hull and the box of an item's points; `spans` (n + 1,) says where it begins."""
    start = spans[item]
    size = convex_hull(points, count, outlines[start:]) if count > 0 else 0
    spans[item + 1] = start + size
    boxes[item, 0], boxes[item, 1], boxes[item, 2], boxes[item, 3] = 1e30, 1e30, -1e30, -1e30
    for i in range(start, start + size):
        x, y = outlines[i, 0], outlines[i, 1]
        boxes[item, 0], boxes[item, 1] = min(boxes[item, 0], x), min(boxes[item, 1], y)
        boxes[item, 2], boxes[item, 3] = max(boxes[item, 2], x), max(boxes[item, 3], y)


@njit(cache=True, nogil=True, error_model="numpy")
def part_outlines(
    seen: Floats,
    screen: Floats,
    triangles: Ints,
    faces: Ints,
    normals: Floats,
    offsets: Floats,
    starts: Ints,
    traits: Ints,
    eye: Floats,
    focal: float,
    near: float,
    width: float,
    height: float,
    boxes: Floats,
    outlines: Floats,
    spans: Longs,
    shown: Flags,
) -> None:
    """Find what each part covers: hull and box of its triangles turned to the eye.

    The box of a part below layer 2 is left empty: it needs no order.
    """
    corner = np.empty((4, 3))
    most = 0
    for p in range(len(traits)):
        most = max(most, starts[p + 1, 1] - starts[p, 1])
    points = np.empty((4 * most + 1, 2))
    for p in range(len(traits)):
        count = 0
        shown[p] = False
        for t in range(starts[p, 1], starts[p + 1, 1]):
            f = faces[t]
            way = normals[f, 0] * eye[0] + normals[f, 1] * eye[1] + normals[f, 2] * eye[2]
            if way <= offsets[f]:
                continue
            shown[p] = True
            if traits[p, 1] < 2:
                break
            a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
            for k in range(corners_of(seen, screen, a, b, c, focal, near, width, height, corner)):
                points[count, 0], points[count, 1] = corner[k, 0], corner[k, 1]
                count += 1
        close_outline(points, count, p, boxes, outlines, spans)


@njit(cache=True, nogil=True, error_model="numpy")
def sphere_outlines(
    first: int,
    centres: Floats,
    radii: Floats,
    eye: Floats,
    basis: Floats,
    focal: float,
    near: float,
    width: float,
    height: float,
    boxes: Floats,
    outlines: Floats,
    spans: Longs,
) -> None:
    """Find what each sphere covers, as item `first` and on: a polygon about its outline."""
    points = np.empty((ROUND, 2))
    for s in range(len(radii)):
        c = np.zeros(3)
        for k in range(3):
            for m in range(3):
                c[k] += basis[k, m] * (centres[s, m] - eye[m])
        square = c[0] * c[0] + c[1] * c[1] + c[2] * c[2]
        radius = radii[s]
        if c[2] - radius < near or square <= radius * radius:
            close_outline(points, 0, first + s, boxes, outlines, spans)
            continue
        share = 1.0 - radius * radius / square
        rim = radius * np.sqrt(share) / np.cos(np.pi / ROUND)
        # two ways across the line of sight
        size = np.sqrt(c[0] * c[0] + c[2] * c[2])
        ux, uz = c[2] / size, -c[0] / size
        whole = np.sqrt(square)
        vx, vy, vz = c[1] * uz / whole, (c[2] * ux - c[0] * uz) / whole, -c[1] * ux / whole
        for k in range(ROUND):
            turn = 2.0 * np.pi * k / ROUND
            p, q = rim * np.cos(turn), rim * np.sin(turn)
            x = c[0] * share + p * ux + q * vx
            y = c[1] * share + q * vy
            z = max(c[2] * share + p * uz + q * vz, near)
            points[k, 0] = width * 0.5 + focal * x / z
            points[k, 1] = height * 0.5 + focal * y / z
        close_outline(points, ROUND, first + s, boxes, outlines, spans)


@njit(cache=True, nogil=True, error_model="numpy")
def apart(outlines: Floats, spans: Longs, i: int, j: int) -> bool:
    """Return whether a side of outline i has the whole of outline j beyond it."""
    first, last = spans[i], spans[i + 1]
    for k in range(first, last):
        after = k + 1 if k + 1 < last else first
        x, y = outlines[k, 0], outlines[k, 1]
        dx, dy = outlines[after, 0] - x, outlines[after, 1] - y
        beyond = True
        for m in range(spans[j], spans[j + 1]):
            if dx * (outlines[m, 1] - y) - dy * (outlines[m, 0] - x) > 1e-6:
                beyond = False
                break
        if beyond:
            return True
    return False
