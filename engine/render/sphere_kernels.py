"""Spheres from their equation: the ray of every pixel is met with the sphere itself.

One idea: from the discriminant follow the exact depth, how much of the pixel the outline covers,
and the direction in the sphere's own frame, where its skin is looked up.
Invariant: nothing outside a sphere's box, nor outside rows [`top`, `bottom`), is touched.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

from engine.render.raster import blend
from engine.render.shading import light_at, mix, texel

if TYPE_CHECKING:
    from engine.render.arrays import Bytes, Floats, Ints, Longs, Pixels, Singles


@njit(cache=True, nogil=True, error_model="numpy")
def sphere_boxes(
    centres: Floats,
    radii: Floats,
    eye: Floats,
    basis: Floats,
    focal: float,
    near: float,
    width: float,
    height: float,
    seen: Floats,
    boxes: Ints,
) -> None:
    """Write centres in camera coordinates, and the pixels each sphere may cover, to (n, 4).

    A box is the first column and row, and those after the last; empty where nothing is to be drawn.
    """
    for s in range(len(radii)):
        for k in range(3):
            seen[s, k] = 0.0
            for m in range(3):
                seen[s, k] += basis[k, m] * (centres[s, m] - eye[m])
            boxes[s, k], boxes[s, 3] = 0, 0
        x, y, z, radius = seen[s, 0], seen[s, 1], seen[s, 2], radii[s]
        if z - radius < near:
            continue
        flat = z * z - radius * radius
        side = radius * np.sqrt(x * x + flat)
        left = width * 0.5 + focal * (x * z - side) / flat
        right = width * 0.5 + focal * (x * z + side) / flat
        side = radius * np.sqrt(y * y + flat)
        upper = height * 0.5 + focal * (y * z - side) / flat
        lower = height * 0.5 + focal * (y * z + side) / flat
        if right < 0.0 or left > width or lower < 0.0 or upper > height:
            continue
        boxes[s, 0], boxes[s, 1] = max(int(left) - 1, 0), max(int(upper) - 1, 0)
        boxes[s, 2] = min(int(right) + 2, int(width))
        boxes[s, 3] = min(int(lower) + 2, int(height))


@njit(cache=True, nogil=True, error_model="numpy")
def draw_spheres(
    image: Pixels,
    depth: Singles,
    top: int,
    bottom: int,
    order: Longs,
    seen: Floats,
    boxes: Ints,
    centres: Floats,
    rotations: Floats,
    radii: Floats,
    colours: Bytes,
    gloss: Singles,
    skins: Bytes,
    skin_places: Ints,
    lamps: Floats,
    ambient: float,
    eye: Floats,
    basis: Floats,
    focal: float,
    near: float,
    width: float,
    height: float,
) -> None:
    """Draw spheres in their `order`, far ones first, with blended outlines."""
    for s in order:
        radius = radii[s]
        cx, cy, cz = seen[s, 0], seen[s, 1], seen[s, 2]
        if cz - radius < near:
            continue
        px, py, pz = centres[s, 0], centres[s, 1], centres[s, 2]
        m = rotations[s]
        red, green, blue = float(colours[s, 0]), float(colours[s, 1]), float(colours[s, 2])
        offset, size, shine_of = skin_places[s, 0], skin_places[s, 1], float(gloss[s])
        rest = cx * cx + cy * cy + cz * cz - radius * radius
        # pixels per unit of the discriminant, at the outline
        sharp, small = focal / (2.0 * radius * np.sqrt(rest)), 1.0 / radius
        for y in range(max(boxes[s, 1], top), min(boxes[s, 3], bottom)):
            v = (y + 0.5 - height * 0.5) / focal
            for x in range(boxes[s, 0], boxes[s, 2]):
                u = (x + 0.5 - width * 0.5) / focal
                square = u * u + v * v + 1.0
                along = u * cx + v * cy + cz
                room = along * along - square * rest
                cover = min(room * sharp + 0.5, 1.0)
                if cover <= 0.0:
                    continue
                z = (along - np.sqrt(max(room, 0.0))) / square
                inverse = np.float32(1.0 / z)
                if inverse <= depth[y, x]:
                    continue
                ox, oy, oz = (u * z - cx) * small, (v * z - cy) * small, (z - cz) * small
                nx = basis[0, 0] * ox + basis[1, 0] * oy + basis[2, 0] * oz
                ny = basis[0, 1] * ox + basis[1, 1] * oy + basis[2, 1] * oz
                nz = basis[0, 2] * ox + basis[1, 2] * oy + basis[2, 2] * oz
                if size > 0:
                    at = texel(
                        offset,
                        size,
                        m[0, 0] * nx + m[1, 0] * ny + m[2, 0] * nz,
                        m[0, 1] * nx + m[1, 1] * ny + m[2, 1] * nz,
                        m[0, 2] * nx + m[1, 2] * ny + m[2, 2] * nz,
                    )
                    red, green, blue = float(skins[at]), float(skins[at + 1]), float(skins[at + 2])
                light, shine = light_at(
                    px + nx * radius,
                    py + ny * radius,
                    pz + nz * radius,
                    nx,
                    ny,
                    nz,
                    eye,
                    lamps,
                    ambient,
                    shine_of,
                )
                new = mix(red, green, blue, light, shine)
                if cover < 1.0:
                    new = blend(image[y, x], new, np.uint32(cover * 256.0))
                image[y, x] = new
                if cover > 0.5:
                    depth[y, x] = inverse


@njit(cache=True, nogil=True, error_model="numpy")
def restore(depth: Singles, kept: Singles, boxes: Ints, top: int, bottom: int) -> None:
    """Copy the pixels of boxes (n, 4) from `kept` to `depth`, in rows top to bottom."""
    for k in range(len(boxes)):
        for y in range(max(boxes[k, 1], top), min(boxes[k, 3], bottom)):
            depth[y, boxes[k, 0] : boxes[k, 2]] = kept[y, boxes[k, 0] : boxes[k, 2]]
