"""Which part hides which: separating planes, and a topological sort.

One idea: two parts that do not cut each other have a plane between them; the one on the eye's
side can hide the other and never the reverse, so it is drawn later.
Invariant: the order depends on the scene and the eye alone. A cycle, should one remain, is
broken at the farthest part.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

from engine.render.outline import apart

if TYPE_CHECKING:
    from engine.render.arrays import Floats, Ints, Longs


TOUCH = -1e-6
"""Parts may share a border; a gap above this is a border (m)."""


@njit(cache=True, nogil=True, error_model="numpy")
def support(
    points: Floats, start: int, end: int, a: float, b: float, c: float
) -> tuple[float, float]:
    """Return the least and greatest a x + b y + c z of the points start to end."""
    low, high = 1e30, -1e30
    for i in range(start, end):
        way = a * points[i, 0] + b * points[i, 1] + c * points[i, 2]
        low, high = min(low, way), max(high, way)
    return low, high


@njit(cache=True, nogil=True, error_model="numpy")
def part_planes(
    points: Floats,
    planes: Floats,
    starts: Ints,
    traits: Ints,
    face_normals: Floats,
    one: int,
    two: int,
    best: Floats,
) -> float:
    """Write the best plane with part `one` below and part `two` above; return the gap."""
    gap = -1e30
    for turn in range(2):
        own, other = (one, two) if turn == 0 else (two, one)
        count = starts[own + 1, 3] - starts[own, 3]
        is_sheet = traits[own, 0] == 2
        for k in range(2 if is_sheet else count):
            if is_sheet:
                f = starts[own, 2]
                sign = 1.0 if k == 0 else -1.0
                a = sign * face_normals[f, 0]
                b = sign * face_normals[f, 1]
                c = sign * face_normals[f, 2]
            else:
                plane = planes[starts[own, 3] + k]
                a, b, c = plane[0], plane[1], plane[2]
            _, high = support(points, starts[own, 0], starts[own + 1, 0], a, b, c)
            low, _ = support(points, starts[other, 0], starts[other + 1, 0], a, b, c)
            if low - high > gap:
                gap = low - high
                sign = 1.0 if turn == 0 else -1.0
                best[0], best[1], best[2] = sign * a, sign * b, sign * c
                best[3] = sign * 0.5 * (low + high)
    if gap < TOUCH:
        return skew_plane(points, starts, one, two, gap, best)
    return gap


@njit(cache=True, nogil=True, error_model="numpy")
def skew_plane(points: Floats, starts: Ints, one: int, two: int, gap: float, best: Floats) -> float:
    """Look for a plane that follows no face, by Gilbert's steps; keep the better of both."""
    i, j = starts[one, 0], starts[two, 0]
    qx = points[j, 0] - points[i, 0]
    qy = points[j, 1] - points[i, 1]
    qz = points[j, 2] - points[i, 2]
    for _ in range(40):
        size = np.sqrt(qx * qx + qy * qy + qz * qz)
        if size < 1e-9:
            break
        a, b, c = qx / size, qy / size, qz / size
        high, top, low, under = -1e30, i, 1e30, j
        for k in range(starts[one, 0], starts[one + 1, 0]):
            way = a * points[k, 0] + b * points[k, 1] + c * points[k, 2]
            if way > high:
                high, top = way, k
        for k in range(starts[two, 0], starts[two + 1, 0]):
            way = a * points[k, 0] + b * points[k, 1] + c * points[k, 2]
            if way < low:
                low, under = way, k
        if low - high > gap:
            gap = low - high
            best[0], best[1], best[2], best[3] = a, b, c, 0.5 * (low + high)
            if gap > TOUCH:
                break
        dx = points[under, 0] - points[top, 0] - qx
        dy = points[under, 1] - points[top, 1] - qy
        dz = points[under, 2] - points[top, 2] - qz
        square = dx * dx + dy * dy + dz * dz
        step = -(dx * qx + dy * qy + dz * qz)
        if square < 1e-18 or step <= 1e-15:
            break
        step = min(step / square, 1.0)
        qx, qy, qz = qx + step * dx, qy + step * dy, qz + step * dz
    return gap


@njit(cache=True, nogil=True, error_model="numpy")
def plane_table(
    points: Floats, planes: Floats, starts: Ints, traits: Ints, face_normals: Floats, table: Floats
) -> None:
    """Fill (p, p, 4) with the plane between every two parts, the first of the pair below."""
    count = len(traits)
    best = np.zeros(4)
    for i in range(count):
        for j in range(i + 1, count):
            if traits[i, 1] != 2 or traits[j, 1] != 2:
                continue
            part_planes(points, planes, starts, traits, face_normals, i, j, best)
            for k in range(4):
                table[i, j, k] = best[k]
                table[j, i, k] = -best[k]


@njit(cache=True, nogil=True, error_model="numpy")
def sphere_in_front(
    points: Floats, planes: Floats, starts: Ints, part: int, centre: Floats, eye: Floats
) -> bool:
    """Return whether a sphere may hide a convex part: the eye is on its side of a plane.

    The plane stands across the way from the part's nearest point, found by Gilbert's steps
    (Gilbert 1966) from the part's own planes on.
    """
    first, last = starts[part, 0], starts[part + 1, 0]
    best, result = -1e30, True
    for k in range(starts[part, 3], starts[part + 1, 3]):
        a, b, c, d = planes[k, 0], planes[k, 1], planes[k, 2], planes[k, 3]
        gap = a * centre[0] + b * centre[1] + c * centre[2] - d
        if gap > best:
            best = gap
            result = a * eye[0] + b * eye[1] + c * eye[2] > d
    qx, qy, qz = points[first, 0], points[first, 1], points[first, 2]
    for _ in range(24):
        nx, ny, nz = centre[0] - qx, centre[1] - qy, centre[2] - qz
        size = np.sqrt(nx * nx + ny * ny + nz * nz)
        if size < 1e-9:
            break
        nx, ny, nz = nx / size, ny / size, nz / size
        high, far = -1e30, first
        for i in range(first, last):
            way = nx * points[i, 0] + ny * points[i, 1] + nz * points[i, 2]
            if way > high:
                high, far = way, i
        gap = nx * centre[0] + ny * centre[1] + nz * centre[2] - high
        if gap > best:
            best = gap
            result = nx * eye[0] + ny * eye[1] + nz * eye[2] > high
        dx, dy, dz = points[far, 0] - qx, points[far, 1] - qy, points[far, 2] - qz
        square = dx * dx + dy * dy + dz * dz
        step = dx * (centre[0] - qx) + dy * (centre[1] - qy) + dz * (centre[2] - qz)
        if square < 1e-18 or step <= 1e-15:
            break
        step = min(step / square, 1.0)
        qx, qy, qz = qx + step * dx, qy + step * dy, qz + step * dz
    return result


@njit(cache=True, nogil=True, error_model="numpy")
def hides(
    i: int,
    j: int,
    fixed: int,
    points: Floats,
    planes: Floats,
    starts: Ints,
    traits: Ints,
    face_normals: Floats,
    table: Floats,
    centres: Floats,
    eye: Floats,
    best: Floats,
) -> int:
    """Return 1 where item i may hide item j, -1 the other way; parts count before spheres."""
    parts = len(traits)
    if i < parts and j < parts:
        if i < fixed and j < fixed:
            plane = table[i, j]
        else:
            part_planes(points, planes, starts, traits, face_normals, i, j, best)
            plane = best
        way = plane[0] * eye[0] + plane[1] * eye[1] + plane[2] * eye[2] - plane[3]
        return -1 if way > 0.0 else 1
    if i < parts:
        return -1 if sphere_in_front(points, planes, starts, i, centres[j - parts], eye) else 1
    if j < parts:
        return 1 if sphere_in_front(points, planes, starts, j, centres[i - parts], eye) else -1
    one, two = centres[i - parts], centres[j - parts]
    way = 0.0
    for k in range(3):
        way += (two[k] - one[k]) * (eye[k] - 0.5 * (one[k] + two[k]))
    return -1 if way > 0.0 else 1


@njit(cache=True, nogil=True, error_model="numpy")
def sort_items(
    chosen: Ints,
    boxes: Floats,
    outlines: Floats,
    spans: Longs,
    far: Floats,
    fixed: int,
    points: Floats,
    planes: Floats,
    starts: Ints,
    traits: Ints,
    face_normals: Floats,
    table: Floats,
    centres: Floats,
    eye: Floats,
    order: Ints,
) -> int:
    """Write `chosen` items to `order` so that what may hide comes after what it hides.

    `boxes` (n, 4) and `far` (n,), squared distances, count parts first, then spheres. Returns
    how many cycles had to be broken.
    """
    n = len(chosen)
    before = np.zeros(n, np.int32)
    above = np.zeros((n, n), np.bool_)
    best = np.zeros(4)
    for u in range(n):
        i = chosen[u]
        for w in range(u + 1, n):
            j = chosen[w]
            if (
                boxes[i, 0] > boxes[j, 2]
                or boxes[j, 0] > boxes[i, 2]
                or boxes[i, 1] > boxes[j, 3]
                or boxes[j, 1] > boxes[i, 3]
            ):
                continue
            if apart(outlines, spans, i, j) or apart(outlines, spans, j, i):
                continue
            if (
                hides(
                    i,
                    j,
                    fixed,
                    points,
                    planes,
                    starts,
                    traits,
                    face_normals,
                    table,
                    centres,
                    eye,
                    best,
                )
                > 0
            ):
                above[w, u] = True
                before[u] += 1
            else:
                above[u, w] = True
                before[w] += 1
    done = np.zeros(n, np.bool_)
    broken = 0
    for place in range(n):
        pick, distance, free = -1, -1.0, False
        for u in range(n):
            if done[u]:
                continue
            ready = before[u] <= 0
            if (ready and not free) or (ready == free and far[chosen[u]] > distance):
                pick, distance, free = u, far[chosen[u]], ready
        if not free:
            broken += 1
        done[pick] = True
        order[place] = chosen[pick]
        for w in range(n):
            if above[pick, w]:
                before[w] -= 1
    return broken
