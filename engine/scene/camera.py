"""The camera: where the eye is, and the way between the world and the window.

One idea: a pinhole. A point at depth z ahead of the eye lands `focal / z` pixels a metre from
the window's middle. Pixels count from the upper left corner; a pixel's middle is at +0.5.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, hypot, sin, tan

import numpy as np
from numpy.typing import NDArray

Vector = tuple[float, float, float]
Size = tuple[int, int]
"""Width and height in pixels."""
Pixel = tuple[float, float]
Matrix = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Camera:
    """An eye at `eye` that looks at `target` (m); `field` is the view's height in rad."""

    eye: Vector
    target: Vector
    up: Vector = (0.0, 0.0, 1.0)
    field: float = 0.7
    near: float = 0.02

    def basis(self) -> Matrix:
        """Return the rows right, down and ahead: world to camera by `basis @ (p - eye)`.

        Raises ValueError where `up` lies along the view, or the target at the eye.
        """
        x, y, z = (t - e for t, e in zip(self.target, self.eye, strict=True))
        u, v, w = self.up
        right = (y * w - z * v, z * u - x * w, x * v - y * u)
        far, wide = hypot(x, y, z), hypot(*right)
        if min(far, wide) < 1e-12:
            raise ValueError("a camera looks somewhere, and its up is not where it looks")
        x, y, z = x / far, y / far, z / far
        a, b, c = (part / wide for part in right)
        return np.array([(a, b, c), (y * c - z * b, z * a - x * c, x * b - y * a), (x, y, z)])

    def focal(self, height: int) -> float:
        """Return the pixels that one metre takes at a depth of one metre."""
        return height / 2.0 / tan(self.field / 2.0)


def orbit(
    target: Vector, azimuth: float, elevation: float, distance: float, field: float = 0.7
) -> Camera:
    """Return a camera `distance` (m) from `target`, seen at angles in rad; up is +z."""
    flat = distance * cos(elevation)
    eye = (
        target[0] + flat * cos(azimuth),
        target[1] + flat * sin(azimuth),
        target[2] + distance * sin(elevation),
    )
    return Camera(eye, target, field=field)


def project(camera: Camera, size: Size, point: Vector) -> Pixel | None:
    """Return where `point` (m) lands in a window, or None where it is behind the eye."""
    x, y, z = camera.basis() @ np.subtract(point, camera.eye)
    if z < camera.near:
        return None
    focal = camera.focal(size[1])
    return float(size[0] / 2.0 + focal * x / z), float(size[1] / 2.0 + focal * y / z)


def ray(camera: Camera, size: Size, pixel: Pixel) -> Vector:
    """Return the unit vector from the eye through a pixel."""
    focal = camera.focal(size[1])
    aim = ((pixel[0] - size[0] / 2.0) / focal, (pixel[1] - size[1] / 2.0) / focal, 1.0)
    way = camera.basis().T @ np.array(aim)
    length = hypot(*way)
    return float(way[0] / length), float(way[1] / length), float(way[2] / length)


def ground_point(
    camera: Camera, size: Size, pixel: Pixel, height: float = 0.0
) -> tuple[float, float] | None:
    """Return where the ray through a pixel meets the level plane at `height`, or None."""
    way = ray(camera, size, pixel)
    rise = height - camera.eye[2]
    if rise * way[2] <= 0.0:
        return None
    reach = rise / way[2]
    return camera.eye[0] + reach * way[0], camera.eye[1] + reach * way[1]
