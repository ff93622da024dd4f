"""Soft discs that lie flat: shadows and spots on the cloth.

One idea: every pixel's ray is met with the disc's level plane, and how far from the middle it meets
it says how much is mixed in.
"""
# ruff: noqa: FBT001  a kernel takes its flags by place

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

from engine.render.raster import blend

if TYPE_CHECKING:
    from engine.render.arrays import Floats, Pixels, Singles

SAME = 0.0025
"""Depths that differ by less than this share are the same."""
LIFTED = 0.001
"""A disc lies on what is no more than this (m) under its plane."""


@njit(cache=True, nogil=True, error_model="numpy")
def disc_box(
    disc: Floats,
    eye: Floats,
    basis: Floats,
    focal: float,
    near: float,
    width: float,
    height: float,
) -> tuple[float, float, float, float]:
    """Return left, top, right and bottom (px) of the square about a disc; empty where too near."""
    left, top, right, bottom = 1e9, 1e9, -1e9, -1e9
    radius = disc[3]
    for corner in range(4):
        dx = disc[0] + (radius if corner & 1 else -radius) - eye[0]
        dy = disc[1] + (radius if corner & 2 else -radius) - eye[1]
        dz = disc[2] - eye[2]
        z = basis[2, 0] * dx + basis[2, 1] * dy + basis[2, 2] * dz
        if z < near:
            return 1e9, 1e9, -1e9, -1e9
        x = width * 0.5 + focal * (basis[0, 0] * dx + basis[0, 1] * dy + basis[0, 2] * dz) / z
        y = height * 0.5 + focal * (basis[1, 0] * dx + basis[1, 1] * dy + basis[1, 2] * dz) / z
        left, right, top, bottom = min(left, x), max(right, x), min(top, y), max(bottom, y)
    return left, top, right, bottom


@njit(cache=True, nogil=True, error_model="numpy")
def mix_row(
    row: Pixels,
    depths: Singles,
    tested: bool,
    first: Floats,
    grow: Floats,
    disc: Floats,
    shade: np.uint32,
) -> None:
    """Mix a disc into a piece of a row; `first` is the ray's way at its first pixel."""
    rise, radius, alpha = disc[2], disc[3], 256.0 * disc[4]
    square, sharp = radius * radius, 1.0 / max(disc[5], 1e-9)
    slack = SAME + LIFTED / abs(rise)
    for i in range(row.shape[0]):
        t = rise / (first[2] + grow[2] * i)
        x = t * (first[0] + grow[0] * i) - disc[0]
        y = t * (first[1] + grow[1] * i) - disc[1]
        away = x * x + y * y
        if t <= 0.0 or away >= square:
            continue
        if tested and abs(depths[i] * t - 1.0) > slack:
            continue
        part = min((radius - np.sqrt(away)) * sharp, 1.0)
        share = alpha * part * part * (3.0 - 2.0 * part)
        row[i] = blend(row[i], shade, np.uint32(share + 0.5))


@njit(cache=True, nogil=True, error_model="numpy")
def draw_discs(
    image: Pixels,
    depth: Singles,
    tested: bool,
    top: int,
    bottom: int,
    discs: Floats,
    shades: Pixels,
    eye: Floats,
    basis: Floats,
    focal: float,
    near: float,
    width: float,
    height: float,
) -> None:
    """Mix in flat discs (n, 6): centre, radius, alpha, softness.

    Where `tested`, only on what lies at their own depth (1/z), or where that is no number.
    """
    first, grow, own = np.empty(3), np.empty(3), np.empty(6)
    for k in range(len(discs)):
        disc = discs[k]
        low_x, low_y, high_x, high_y = disc_box(disc, eye, basis, focal, near, width, height)
        if low_x > width or high_x < 0.0 or low_y > bottom or high_y < top:
            continue
        # the disc as seen from an eye at the origin
        for m in range(6):
            own[m] = disc[m] - (eye[m] if m < 3 else 0.0)
        begin, end = max(int(low_x), 0), min(int(high_x) + 1, int(width))
        u = (begin + 0.5 - width * 0.5) / focal
        for y in range(max(int(low_y), top), min(int(high_y) + 1, bottom)):
            v = (y + 0.5 - height * 0.5) / focal
            for m in range(3):
                first[m] = basis[0, m] * u + basis[1, m] * v + basis[2, m]
                grow[m] = basis[0, m] / focal
            depths = depth[y, begin:end] if tested else depth[0]
            mix_row(image[y, begin:end], depths, tested, first, grow, own, shades[k])
