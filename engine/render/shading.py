"""Light, skins and soft discs: the colours that both filled renderers share.

One idea: a lamp's light falls as n.L / |L|^2, as from a tube, which needs no root; highlights
follow Blinn (1977). Invariant: the same point in the same light has the same colour however it
is filled.
"""
# ruff: noqa: FBT001  a kernel takes its flags by place

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

if TYPE_CHECKING:
    from engine.render.arrays import Bytes, Floats, Pixels, Singles


SHINE = 6
"""Highlights are raised to the power 2^SHINE."""


@njit(cache=True, nogil=True, error_model="numpy")
def light_at(
    px: float,
    py: float,
    pz: float,
    nx: float,
    ny: float,
    nz: float,
    eye: Floats,
    lamps: Floats,
    ambient: float,
    gloss: float,
) -> tuple[float, float]:
    """Return the light on a point with a normal, and its highlight; lamps (n, 4) with power."""
    light = ambient * (0.76 + 0.24 * nz)
    shine = 0.0
    vx, vy, vz = eye[0] - px, eye[1] - py, eye[2] - pz
    size = 1.0 / np.sqrt(vx * vx + vy * vy + vz * vz)
    vx, vy, vz = vx * size, vy * size, vz * size
    for k in range(len(lamps)):
        lx, ly, lz = lamps[k, 0] - px, lamps[k, 1] - py, lamps[k, 2] - pz
        square = lx * lx + ly * ly + lz * lz
        toward = lx * nx + ly * ny + lz * nz
        if toward <= 0.0:
            continue
        light += lamps[k, 3] * toward / square
        if gloss > 0.0:
            size = 1.0 / np.sqrt(square)
            hx, hy, hz = lx * size + vx, ly * size + vy, lz * size + vz
            half = (hx * nx + hy * ny + hz * nz) / np.sqrt(hx * hx + hy * hy + hz * hz)
            if half > 0.0:
                for _ in range(SHINE):
                    half *= half
                shine += half * gloss
    return light, shine


@njit(cache=True, nogil=True, error_model="numpy")
def mix(red: float, green: float, blue: float, light: float, shine: float) -> np.uint32:
    """Return a colour in light as 0x00RRGGBB."""
    white = 255.0 * shine
    r = min(red * light + white, 255.0)
    g = min(green * light + white, 255.0)
    b = min(blue * light + white, 255.0)
    return np.uint32((int(r + 0.5) << 16) | (int(g + 0.5) << 8) | int(b + 0.5))


@njit(cache=True, nogil=True, error_model="numpy")
def shade_faces(
    centres: Floats,
    normals: Floats,
    colours: Bytes,
    lights: Singles,
    eye: Floats,
    lamps: Floats,
    ambient: float,
    out: Pixels,
) -> None:
    """Write one colour for every face turned to the eye; the others are left alone."""
    for f in range(len(centres)):
        nx, ny, nz = normals[f, 0], normals[f, 1], normals[f, 2]
        px, py, pz = centres[f, 0], centres[f, 1], centres[f, 2]
        if nx * (eye[0] - px) + ny * (eye[1] - py) + nz * (eye[2] - pz) <= 0.0:
            continue
        if lights[f, 1] < 1.0:
            out[f] = mix(float(colours[f, 0]), float(colours[f, 1]), float(colours[f, 2]), 1.0, 0.0)
            continue
        light, shine = light_at(px, py, pz, nx, ny, nz, eye, lamps, ambient, lights[f, 0] * 0.5)
        out[f] = mix(float(colours[f, 0]), float(colours[f, 1]), float(colours[f, 2]), light, shine)


@njit(cache=True, nogil=True, error_model="numpy")
def texel(offset: int, size: int, x: float, y: float, z: float) -> int:
    """Return where in the flat skins the own direction (x, y, z) of a sphere is painted."""
    whole = abs(x) + abs(y) + abs(z)
    u, v = x / whole, y / whole
    if z < 0.0:
        u, v = (
            (1.0 - abs(v)) * (1.0 if u >= 0.0 else -1.0),
            (1.0 - abs(u)) * (1.0 if v >= 0.0 else -1.0),
        )
    column = min(max(int((u + 1.0) * 0.5 * size), 0), size - 1)
    row = min(max(int((v + 1.0) * 0.5 * size), 0), size - 1)
    return offset + 3 * (row * size + column)


@njit(cache=True, nogil=True, error_model="numpy")
def draw_discs(
    image: Pixels,
    depth: Singles,
    tested: bool,
    top: int,
    bottom: int,
    discs: Floats,
    colours: Bytes,
    eye: Floats,
    basis: Floats,
    focal: float,
    near: float,
) -> None:
    """Mix in flat discs (n, 6): centre, radius, alpha, softness.

    Where `tested`, only on what lies at their own depth (1/z).
    """
    height, width = image.shape
    for k in range(len(discs)):
        cx, cy, cz, radius = discs[k, 0], discs[k, 1], discs[k, 2], discs[k, 3]
        alpha, soft = discs[k, 4], discs[k, 5]
        low_x, high_x, low_y, high_y = 1e9, -1e9, 1e9, -1e9
        hidden = False
        for corner in range(4):
            dx = cx + (radius if corner & 1 else -radius) - eye[0]
            dy = cy + (radius if corner & 2 else -radius) - eye[1]
            dz = cz - eye[2]
            z = basis[2, 0] * dx + basis[2, 1] * dy + basis[2, 2] * dz
            if z < near:
                hidden = True
                break
            sx = width * 0.5 + focal * (basis[0, 0] * dx + basis[0, 1] * dy + basis[0, 2] * dz) / z
            sy = height * 0.5 + focal * (basis[1, 0] * dx + basis[1, 1] * dy + basis[1, 2] * dz) / z
            low_x, high_x = min(low_x, sx), max(high_x, sx)
            low_y, high_y = min(low_y, sy), max(high_y, sy)
        if hidden or low_x > width or high_x < 0.0 or low_y > bottom or high_y < top:
            continue
        red, green, blue = float(colours[k, 0]), float(colours[k, 1]), float(colours[k, 2])
        rise = cz - eye[2]
        edge = max(radius - soft, 0.0)
        for y in range(max(int(low_y), top), min(int(high_y) + 1, bottom)):
            v = (y + 0.5 - height * 0.5) / focal
            for x in range(max(int(low_x), 0), min(int(high_x) + 1, width)):
                u = (x + 0.5 - width * 0.5) / focal
                wz = basis[0, 2] * u + basis[1, 2] * v + basis[2, 2]
                if wz * rise <= 0.0:
                    continue
                t = rise / wz
                px = eye[0] + t * (basis[0, 0] * u + basis[1, 0] * v + basis[2, 0]) - cx
                py = eye[1] + t * (basis[0, 1] * u + basis[1, 1] * v + basis[2, 1]) - cy
                away = px * px + py * py
                if away >= radius * radius:
                    continue
                if tested and abs(depth[y, x] * t - 1.0) > 0.0025:
                    continue
                share = alpha
                if soft > 0.0:
                    part = min((radius - np.sqrt(away)) / (radius - edge), 1.0)
                    share *= part * part * (3.0 - 2.0 * part)
                old = image[y, x]
                keep = 1.0 - share
                r = int(((old >> 16) & 255) * keep + red * share + 0.5)
                g = int(((old >> 8) & 255) * keep + green * share + 0.5)
                b = int((old & 255) * keep + blue * share + 0.5)
                image[y, x] = np.uint32((r << 16) | (g << 8) | b)
