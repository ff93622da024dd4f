"""Spans of pixels lit one by one, each kept where it is the nearest so far.

One idea: on a flat face 1/z is linear across the picture, and with it the place of every pixel and
its light follow from the ray alone; nothing else has to be carried along a span. The loops are
plain and without a branch, so that they vectorise.
Invariant: a pixel keeps the nearest surface; of equal depths the first one drawn.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

from engine.render.raster import blend
from engine.render.shading import light_at, mix

if TYPE_CHECKING:
    from engine.render.arrays import Floats, Pixels, Singles


ONE = np.float32(1.0)
FULL = np.float32(255.0)
HALF = np.float32(0.5)
TWO = np.float32(2.0)
NONE = np.float32(0.0)

ROOM = 5
"""Rows of scratch that a span needs; the first counts 0, 1, 2, ... along the picture."""


@njit(cache=True, nogil=True, error_model="numpy")
def make_scratch(width: int) -> Singles:
    """Return room for spans of a picture that is `width` pixels wide, (ROOM, width)."""
    scratch = np.zeros((ROOM, width), np.float32)
    for i in range(width):
        scratch[0, i] = np.float32(i)
    return scratch


@njit(cache=True, nogil=True, error_model="numpy")
def flat_span(
    row: Pixels, depths: Singles, w: np.float32, dw: np.float32, shade: np.uint32
) -> None:
    """Give one span one colour."""
    for i in range(row.shape[0]):
        new = w + dw * np.float32(i)
        old = depths[i]
        row[i] = shade if new > old else row[i]
        depths[i] = new if new > old else old  # noqa: FURB136  a choice vectorises


@njit(cache=True, nogil=True, error_model="numpy")
def tint_span(
    row: Pixels, depths: Singles, w: np.float32, dw: np.float32, shade: np.uint32, part: np.uint32
) -> None:
    """Mix `part` / 256 of one colour into a span where nothing nearer is."""
    for i in range(row.shape[0]):
        old = row[i]
        row[i] = blend(old, shade, part) if w + dw * np.float32(i) > depths[i] else old


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
    `lamps` (n, 4): 2 V.D at the first pixel, its difference, |V|^2 (V from eye to lamp), and the
    lamp's height over the face; `shares` the power of each; `rise` is the eye's height over the
    face; `scratch` is from `make_scratch`.
    """
    d0, d1, d2 = ray
    count = row.shape[0]
    steps, depth_of, square_of = scratch[0, :count], scratch[1, :count], scratch[2, :count]
    light_of, white_of = scratch[3, :count], scratch[4, :count]
    for i in range(count):
        step = steps[i]
        z = ONE / (w + dw * step)
        depth_of[i] = z
        square_of[i] = (d0 + step * (d1 + step * d2)) * z * z
        light_of[i] = lit
        white_of[i] = NONE
    for k in range(len(shares)):
        share, far, first, grow = shares[k], lamps[k, 2], lamps[k, 0], lamps[k, 1]
        if share == NONE:
            continue
        for i in range(count):
            toward = first + grow * steps[i]
            light_of[i] += share / (square_of[i] - toward * depth_of[i] + far)
        if gloss > NONE:
            add_shine(
                white_of, steps, depth_of, square_of, first, grow, far, lamps[k, 3], rise, gloss
            )
    red, green, blue = colour
    for i in range(count):
        light, white = light_of[i], white_of[i] * FULL
        r = np.int32(min(red * light + white, FULL) + HALF)
        g = np.int32(min(green * light + white, FULL) + HALF)
        b = np.int32(min(blue * light + white, FULL) + HALF)
        new = np.uint32((r << 16) | (g << 8) | b)
        inverse = w + dw * steps[i]
        old = depths[i]
        row[i] = new if inverse > old else row[i]
        depths[i] = inverse if inverse > old else old  # noqa: FURB136  a choice vectorises


@njit(cache=True, nogil=True, error_model="numpy")
def add_shine(
    white_of: Singles,
    steps: Singles,
    depth_of: Singles,
    square_of: Singles,
    first: np.float32,
    grow: np.float32,
    far: np.float32,
    height: np.float32,
    rise: np.float32,
    gloss: np.float32,
) -> None:
    """Add one lamp's highlight on a flat face to a span.

    The cosine to the bisector of the ways L to the lamp and V to the eye, squared, is
    (|V| N.L + |L| N.V)^2 / (2 |L| |V| (|L| |V| + L.V)), and L.V follows from the triangle's sides.
    """
    for i in range(white_of.shape[0]):
        square = square_of[i]
        lamp = square - (first + grow * steps[i]) * depth_of[i] + far
        to_lamp, to_eye = np.sqrt(lamp), np.sqrt(square)
        both = to_lamp * to_eye
        half = height * to_eye + rise * to_lamp
        half = half * half / (both * (TWO * both + lamp + square - far))
        half *= half
        half *= half
        half *= half
        half *= half
        half *= half
        white_of[i] += gloss * half


@njit(cache=True, nogil=True, error_model="numpy")
def shiny_span(
    row: Pixels,
    depths: Singles,
    w: float,
    dw: float,
    ray: Floats,
    normals: Floats,
    colour: tuple[np.float32, np.float32, np.float32],
    gloss: float,
    scene: tuple[Floats, Floats, float],
) -> None:
    """Shade one span of a smooth face; `normals` (2, 3) over z at the first pixel, difference.

    `ray` (2, 3) is the ray through the first pixel and its difference.
    """
    eye, lamps, ambient = scene
    red, green, blue = float(colour[0]), float(colour[1]), float(colour[2])
    for i in range(row.shape[0]):
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
        row[i] = mix(red, green, blue, light, shine * 0.5)
        depths[i] = np.float32(inverse)
