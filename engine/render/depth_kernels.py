"""The scanline renderer's inner loops: depth as 1/z, spans, light at every pixel.

One idea: on a flat face 1/z is linear across the picture, and with it the place of every pixel
and its light follow from the ray alone; nothing else has to be carried along a span.
Invariant: a pixel keeps the nearest surface; of equal depths the first one drawn.
"""
# ruff: noqa: FBT001  a kernel takes its flags by place

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

from engine.render.raster import by_height, corners_of, rows_of, span_of
from engine.render.shading import light_at, mix, texel

if TYPE_CHECKING:
    from engine.render.arrays import Bytes, Flags, Floats, Ints, Longs, Pixels, Singles


ONE = np.float32(1.0)
FULL = np.float32(255.0)
HALF = np.float32(0.5)
TWO = np.float32(2.0)
NONE = np.float32(0.0)


@njit(cache=True, nogil=True, error_model="numpy")
def lit_span(
    row: Pixels,
    depths: Singles,
    w: np.float32,
    dw: np.float32,
    ray: tuple[np.float32, np.float32, np.float32],
    colour: tuple[np.float32, np.float32, np.float32],
    lit: np.float32,
    gloss: np.float32,
    rise: np.float32,
    lamps: Singles,
    shares: Singles,
    scratch: Singles,
) -> None:
    """Shade one span of a flat face whose 1/z is `w` at its first pixel and grows by `dw`.

    `ray` is |D|^2 and its first and second differences; `lit` the light from all round;
    `lamps` (n, 4): V.D at the first pixel, its difference, |V|^2 (V from eye to lamp), and the
    lamp's height over the face; `shares` the power of each; `rise` is the eye's height over the
    face; `scratch` (4, width) is room for the span. The cosine between the ways to lamp and eye
    follows from the three sides of their triangle.
    """
    red, green, blue = colour
    d0, d1, d2 = ray
    count = row.shape[0]
    depth_of, square_of = scratch[0, :count], scratch[1, :count]
    light_of, white_of = scratch[2, :count], scratch[3, :count]
    for i in range(count):
        step = np.float32(i)
        z = ONE / (w + dw * step)
        depth_of[i] = z
        square_of[i] = (d0 + step * (d1 + step * d2)) * z * z
        light_of[i] = lit
        white_of[i] = NONE
    for k in range(len(shares)):
        share, far = shares[k], lamps[k, 2]
        first, grow = lamps[k, 0] + lamps[k, 0], lamps[k, 1] + lamps[k, 1]
        for i in range(count):
            toward = first + grow * np.float32(i)
            light_of[i] += share / (square_of[i] - toward * depth_of[i] + far)
        if gloss > NONE and share > NONE:
            height = lamps[k, 3]
            for i in range(count):
                square = square_of[i]
                lamp = square - (first + grow * np.float32(i)) * depth_of[i] + far
                to_lamp, to_eye = ONE / np.sqrt(lamp), ONE / np.sqrt(square)
                cosine = (lamp + square - far) * HALF * to_lamp * to_eye
                half = (height * to_lamp + rise * to_eye) / np.sqrt(TWO + TWO * cosine)
                half *= half
                half *= half
                half *= half
                half *= half
                half *= half
                half *= half
                white_of[i] += gloss * half
    for i in range(count):
        light, white = light_of[i], white_of[i] * FULL
        r = np.int32(min(red * light + white, FULL) + HALF)
        g = np.int32(min(green * light + white, FULL) + HALF)
        b = np.int32(min(blue * light + white, FULL) + HALF)
        new = np.uint32((r << 16) | (g << 8) | b)
        inverse = w + dw * np.float32(i)
        old = depths[i]
        row[i] = new if inverse > old else row[i]
        depths[i] = inverse if inverse > old else old  # noqa: FURB136  a choice vectorises


@njit(cache=True, nogil=True, error_model="numpy")
def shiny_span(
    row: Pixels,
    depths: Singles,
    w: float,
    dw: float,
    ray: Floats,
    normals: Floats,
    colour: tuple[float, float, float],
    gloss: float,
    scene: tuple[Floats, Floats, float],
) -> None:
    """Shade one span with highlights; `normals` (2, 3) over z at the first pixel, difference."""
    eye, lamps, ambient = scene
    count = row.shape[0]
    for i in range(count):
        inverse = w + dw * i
        if inverse <= depths[i]:
            continue
        z = 1.0 / inverse
        nx = normals[0, 0] + normals[1, 0] * i
        ny = normals[0, 1] + normals[1, 1] * i
        nz = normals[0, 2] + normals[1, 2] * i
        size = 1.0 / np.sqrt(nx * nx + ny * ny + nz * nz)
        px = eye[0] + (ray[0, 0] + ray[1, 0] * i) * z
        py = eye[1] + (ray[0, 1] + ray[1, 1] * i) * z
        pz = eye[2] + (ray[0, 2] + ray[1, 2] * i) * z
        light, shine = light_at(
            px, py, pz, nx * size, ny * size, nz * size, eye, lamps, ambient, gloss
        )
        row[i] = mix(colour[0], colour[1], colour[2], light, shine * 0.5)
        depths[i] = np.float32(inverse)


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
    eye: Floats,
    basis: Floats,
    focal: float,
    near: float,
    lamps: Floats,
    ambient: float,
    flat: bool,
    shades: Pixels,
) -> None:
    """Draw the triangles turned to the eye. With `flat`, each face has its colour in `shades`."""
    height, width = image.shape
    corner = np.empty((4, 3))
    lamp_count = len(lamps)
    lamp_terms = np.empty((lamp_count, 4), np.float32)
    shares = np.empty(lamp_count, np.float32)
    ray = np.empty((2, 3))
    scratch = np.empty((4, width), np.float32)
    carried = np.empty((2, 3))
    normal_planes = np.empty((3, 3))
    scene = (eye, lamps, ambient)
    for t in range(len(triangles)):
        f = faces[t]
        if face_light[f, 1] < 1.0:
            continue
        nx, ny, nz = face_normals[f, 0], face_normals[f, 1], face_normals[f, 2]
        if nx * eye[0] + ny * eye[1] + nz * eye[2] <= face_offsets[f]:
            continue
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        count = corners_of(seen, screen, a, b, c, focal, near, float(width), float(height), corner)
        if count < 3:
            continue
        smooth = face_smooth[f] and not flat and count == 3
        colour = (float(face_colours[f, 0]), float(face_colours[f, 1]), float(face_colours[f, 2]))
        colour32 = (np.float32(colour[0]), np.float32(colour[1]), np.float32(colour[2]))
        lit = np.float32(ambient * (0.76 + 0.24 * nz))
        for k in range(lamp_count):
            toward = lamps[k, 0] * nx + lamps[k, 1] * ny + lamps[k, 2] * nz - face_offsets[f]
            shares[k] = lamps[k, 3] * max(toward, 0.0)
            lamp_terms[k, 3] = toward
        rise = np.float32(nx * eye[0] + ny * eye[1] + nz * eye[2] - face_offsets[f])
        gloss = np.float32(0.5 * face_light[f, 0])
        for part in range(count - 2):
            p, q, r = corner[0], corner[part + 1], corner[part + 2]
            x0, y0, x1, y1, x2, y2, cross = by_height(p[0], p[1], q[0], q[1], r[0], r[1])
            first, last = rows_of(y0, y2, top, bottom)
            if cross == 0.0 or first >= last or max(x0, x1, x2) < 0.0 or min(x0, x1, x2) > width:
                continue
            base, step_x, step_y = plane_of(p, q, r, p[2], q[2], r[2])
            if smooth:
                for k in range(3):
                    m = plane_of(
                        p, q, r, normals[a, k] * p[2], normals[b, k] * q[2], normals[c, k] * r[2]
                    )
                    normal_planes[k, 0], normal_planes[k, 1], normal_planes[k, 2] = m
            for y in range(first, last):
                begin, end = span_of(y, width, x0, y0, x1, y1, x2, y2, cross)
                if begin >= end:
                    continue
                row, depths = image[y, begin:end], depth[y, begin:end]
                px, py = begin + 0.5, y + 0.5
                inverse = base + step_x * px + step_y * py
                if flat:
                    shade = shades[f]
                    for i in range(row.shape[0]):
                        new = np.float32(inverse + step_x * i)
                        nearer = new > depths[i]
                        row[i] = shade if nearer else row[i]
                        depths[i] = new if nearer else depths[i]
                    continue
                u, v = (px - width * 0.5) / focal, (py - height * 0.5) / focal
                for k in range(3):
                    ray[0, k] = basis[0, k] * u + basis[1, k] * v + basis[2, k]
                    ray[1, k] = basis[0, k] / focal
                if smooth:
                    for k in range(3):
                        plane = normal_planes[k]
                        carried[0, k] = plane[0] + plane[1] * px + plane[2] * py
                        carried[1, k] = plane[1]
                    shiny_span(
                        row,
                        depths,
                        inverse,
                        step_x,
                        ray,
                        carried,
                        colour,
                        float(face_light[f, 0]),
                        scene,
                    )
                    continue
                for k in range(lamp_count):
                    lx, ly, lz = lamps[k, 0] - eye[0], lamps[k, 1] - eye[1], lamps[k, 2] - eye[2]
                    lamp_terms[k, 0] = lx * ray[0, 0] + ly * ray[0, 1] + lz * ray[0, 2]
                    lamp_terms[k, 1] = lx * ray[1, 0] + ly * ray[1, 1] + lz * ray[1, 2]
                    lamp_terms[k, 2] = lx * lx + ly * ly + lz * lz
                square = (
                    np.float32(u * u + v * v + 1.0),
                    np.float32(2.0 * u / focal),
                    np.float32(1.0 / (focal * focal)),
                )
                lit_span(
                    row,
                    depths,
                    np.float32(inverse),
                    np.float32(step_x),
                    square,
                    colour32,
                    lit,
                    gloss,
                    rise,
                    lamp_terms,
                    shares,
                    scratch,
                )


@njit(cache=True, nogil=True, error_model="numpy")
def draw_spheres(
    image: Pixels,
    depth: Singles,
    top: int,
    bottom: int,
    order: Longs,
    centres: Floats,
    rotations: Floats,
    radii: Floats,
    colours: Bytes,
    gloss: Singles,
    skins: Bytes,
    skin_places: Ints,
    eye: Floats,
    basis: Floats,
    focal: float,
    near: float,
    lamps: Floats,
    ambient: float,
) -> None:
    """Draw spheres from their equation, far ones first, with blended outlines."""
    height, width = image.shape
    for s in order:
        radius = radii[s]
        dx, dy, dz = centres[s, 0] - eye[0], centres[s, 1] - eye[1], centres[s, 2] - eye[2]
        cx = basis[0, 0] * dx + basis[0, 1] * dy + basis[0, 2] * dz
        cy = basis[1, 0] * dx + basis[1, 1] * dy + basis[1, 2] * dz
        cz = basis[2, 0] * dx + basis[2, 1] * dy + basis[2, 2] * dz
        if cz - radius < near:
            continue
        whole = cx * cx + cy * cy + cz * cz
        rest = whole - radius * radius
        flat = cz * cz - radius * radius
        side = radius * np.sqrt(cx * cx + flat)
        left = width * 0.5 + focal * (cx * cz - side) / flat
        right = width * 0.5 + focal * (cx * cz + side) / flat
        side = radius * np.sqrt(cy * cy + flat)
        upper = height * 0.5 + focal * (cy * cz - side) / flat
        lower = height * 0.5 + focal * (cy * cz + side) / flat
        if right < 0.0 or left > width or lower < top or upper > bottom:
            continue
        # pixels per unit of the discriminant, at the outline
        sharp = focal / (2.0 * radius * np.sqrt(rest))
        offset, size = skin_places[s, 0], skin_places[s, 1]
        for y in range(max(int(upper) - 1, top), min(int(lower) + 2, bottom)):
            v = (y + 0.5 - height * 0.5) / focal
            for x in range(max(int(left) - 1, 0), min(int(right) + 2, width)):
                u = (x + 0.5 - width * 0.5) / focal
                square = u * u + v * v + 1.0
                along = u * cx + v * cy + cz
                room = along * along - square * rest
                cover = min(room * sharp + 0.5, 1.0)
                if cover <= 0.0:
                    continue
                z = (along - np.sqrt(max(room, 0.0))) / square
                inverse = 1.0 / z
                if inverse <= depth[y, x]:
                    continue
                ox, oy, oz = (u * z - cx) / radius, (v * z - cy) / radius, (z - cz) / radius
                nx = basis[0, 0] * ox + basis[1, 0] * oy + basis[2, 0] * oz
                ny = basis[0, 1] * ox + basis[1, 1] * oy + basis[2, 1] * oz
                nz = basis[0, 2] * ox + basis[1, 2] * oy + basis[2, 2] * oz
                red, green, blue = float(colours[s, 0]), float(colours[s, 1]), float(colours[s, 2])
                if size > 0:
                    m = rotations[s]
                    at = texel(
                        offset,
                        size,
                        m[0, 0] * nx + m[1, 0] * ny + m[2, 0] * nz,
                        m[0, 1] * nx + m[1, 1] * ny + m[2, 1] * nz,
                        m[0, 2] * nx + m[1, 2] * ny + m[2, 2] * nz,
                    )
                    red, green, blue = float(skins[at]), float(skins[at + 1]), float(skins[at + 2])
                light, shine = light_at(
                    centres[s, 0] + nx * radius,
                    centres[s, 1] + ny * radius,
                    centres[s, 2] + nz * radius,
                    nx,
                    ny,
                    nz,
                    eye,
                    lamps,
                    ambient,
                    float(gloss[s]),
                )
                new = mix(red, green, blue, light, shine)
                if cover < 1.0:
                    old = image[y, x]
                    keep = 1.0 - cover
                    r = int(((old >> 16) & 255) * keep + ((new >> 16) & 255) * cover + 0.5)
                    g = int(((old >> 8) & 255) * keep + ((new >> 8) & 255) * cover + 0.5)
                    b = int((old & 255) * keep + (new & 255) * cover + 0.5)
                    new = np.uint32((r << 16) | (g << 8) | b)
                image[y, x] = new
                if cover > 0.5:
                    depth[y, x] = np.float32(inverse)


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
    face_colours: Bytes,
    face_light: Singles,
    eye: Floats,
    focal: float,
    near: float,
) -> None:
    """Mix in the triangles that let light through; they hide nothing."""
    height, width = image.shape
    corner = np.empty((4, 3))
    for t in range(len(triangles)):
        f = faces[t]
        share = float(face_light[f, 1])
        toward = 0.0
        for k in range(3):
            toward += face_normals[f, k] * eye[k]
        if share >= 1.0 or toward <= face_offsets[f]:
            continue
        a, b, c = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        count = corners_of(seen, screen, a, b, c, focal, near, float(width), float(height), corner)
        for part in range(count - 2):
            p, q, r = corner[0], corner[part + 1], corner[part + 2]
            x0, y0, x1, y1, x2, y2, cross = by_height(p[0], p[1], q[0], q[1], r[0], r[1])
            if cross == 0.0:
                continue
            base, step_x, step_y = plane_of(p, q, r, p[2], q[2], r[2])
            first, last = rows_of(y0, y2, top, bottom)
            for y in range(first, last):
                begin, end = span_of(y, width, x0, y0, x1, y1, x2, y2, cross)
                for x in range(begin, end):
                    inverse = base + step_x * (x + 0.5) + step_y * (y + 0.5)
                    if inverse <= depth[y, x]:
                        continue
                    old = image[y, x]
                    keep = 1.0 - share
                    red = int(((old >> 16) & 255) * keep + face_colours[f, 0] * share + 0.5)
                    green = int(((old >> 8) & 255) * keep + face_colours[f, 1] * share + 0.5)
                    blue = int((old & 255) * keep + face_colours[f, 2] * share + 0.5)
                    image[y, x] = np.uint32((red << 16) | (green << 8) | blue)
