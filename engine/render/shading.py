"""Light and skins: the colours that both filled renderers share.

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
    facing = vx * nx + vy * ny + vz * nz
    for k in range(len(lamps)):
        lx, ly, lz = lamps[k, 0] - px, lamps[k, 1] - py, lamps[k, 2] - pz
        square = lx * lx + ly * ly + lz * lz
        toward = lx * nx + ly * ny + lz * nz
        if toward <= 0.0:
            continue
        light += lamps[k, 3] * toward / square
        if gloss > 0.0:
            # |L/|L| + V|^2 is 2 + 2 cos of the angle between them
            size = 1.0 / np.sqrt(square)
            half = toward * size + facing
            half = half * half / (2.0 + 2.0 * size * (lx * vx + ly * vy + lz * vz))
            for _ in range(SHINE - 1):
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
    lit: bool,
    eye: Floats,
    lamps: Floats,
    ambient: float,
    out: Pixels,
) -> None:
    """Write one colour for every face turned to the eye; the others are left alone.

    Tints have their own colour; where not `lit`, nothing else has one.
    """
    for f in range(len(centres)):
        if not lit and lights[f, 1] >= 1.0:
            continue
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
