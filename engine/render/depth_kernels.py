"""Surfaces into picture and depth: what is turned to the eye, row by row, span by span.

One idea: the triangles of one plane and look are one surface; where their spans meet they are one
span, whose depth follows from the plane itself, not from corners that were moved to a raster (the
spans' light: see `engine.render.span_kernels`).
Invariant: nothing outside rows [`top`, `bottom`) and the picture's width is touched.
"""
# ruff: noqa: FBT001  a kernel takes its flags by place

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

from engine.render.raster import by_height, corners_of, rows_of, slopes_of, span_of
from engine.render.span_kernels import flat_span, lit_span, make_scratch, shiny_span, tint_span

if TYPE_CHECKING:
    from engine.render.arrays import Bytes, Flags, Floats, Ints, Longs, Pixels, Singles

FAR = 1 << 30
LEAST_RISE = 1e-7
"""A face that the eye is no higher above (m) is seen edge-on."""


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
def cover(
    corner: Floats,
    count: int,
    rows: tuple[int, int],
    width: int,
    turns: Bytes,
    reach: Ints,
    bounds: Floats,
) -> None:
    """Note which pixels of a band a polygon covers: where its spans begin and end.

    `turns` (rows, width) gets one more where a span begins and one less where it has ended; `reach`
    (rows, 2) the first and last such places of a row; `bounds` the first row, the one after the
    last, the least and the greatest 1/z. Spans that meet cancel out and are one.
    """
    top, bottom = rows
    for part in range(count - 2):
        p, q, r = corner[0], corner[part + 1], corner[part + 2]
        x0, y0, x1, y1, x2, y2, cross = by_height(p[0], p[1], q[0], q[1], r[0], r[1])
        first, last = rows_of(y0, y2, top, bottom)
        if cross == 0.0 or first >= last or max(x0, x1, x2) < 0.0 or min(x0, x1, x2) > width:
            continue
        bounds[0], bounds[1] = min(bounds[0], first), max(bounds[1], last)
        bounds[2] = min(bounds[2], p[2], q[2], r[2])
        bounds[3] = max(bounds[3], p[2], q[2], r[2])
        slopes = slopes_of(x0, y0, x1, y1, x2, y2)
        for y in range(first, last):
            begin, end = span_of(y, 0, width, x0, y0, x1, y1, y2, cross, slopes)
            if begin >= end:
                continue
            turns[y - top, begin] += np.uint8(1)
            turns[y - top, end] -= np.uint8(1)
            reach[y - top, 0] = min(reach[y - top, 0], begin)
            reach[y - top, 1] = max(reach[y - top, 1], end)


@njit(cache=True, nogil=True, error_model="numpy")
def cover_border(
    edges: Ints,
    first: int,
    last: int,
    screen: Floats,
    rows: tuple[int, int],
    width: int,
    turns: Bytes,
    reach: Ints,
    bounds: Floats,
) -> bool:
    """Note where a surface's border, its edges first to last, crosses the rows (see `cover`).

    Returns False, with nothing noted, where a corner is too near for that.
    """
    for e in range(first, last):
        if screen[edges[e, 0], 2] <= 0.0:
            return False
    top, bottom = rows
    for e in range(first, last):
        a, b, step = edges[e, 0], edges[e, 1], np.uint8(1)
        bounds[2] = min(bounds[2], screen[a, 2])
        bounds[3] = max(bounds[3], screen[a, 2])
        if screen[a, 1] > screen[b, 1]:
            a, b, step = b, a, np.uint8(255)
        x, upper, lower = screen[a, 0], screen[a, 1], screen[b, 1]
        begin, end = rows_of(upper, lower, top, bottom)
        if begin >= end:
            continue
        bounds[0], bounds[1] = min(bounds[0], begin), max(bounds[1], end)
        slope = (screen[b, 0] - x) / (lower - upper)
        for y in range(begin, end):
            place = np.ceil(x + (y + 0.5 - upper) * slope - 0.5)
            at = int(min(max(place, 0.0), width))
            turns[y - top, at] += step
            reach[y - top, 0] = min(reach[y - top, 0], at)
            reach[y - top, 1] = max(reach[y - top, 1], at)
    return True


@njit(cache=True, nogil=True, error_model="numpy")
def next_turn(turns: Bytes, words: Longs, row: int, x: int, last: int) -> int:
    """Return the first place from `x` to `last` where a row of `turns` is not zero, else after it.

    `words` are the same rows, eight places at a time.
    """
    while x <= last:
        if x % 8 == 0 and words[row, x // 8] == 0:
            x += 8
        elif turns[row, x] == 0:
            x += 1
        else:
            return x
    return last + 1


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
