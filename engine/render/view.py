"""A camera in numbers, for one size of picture."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from engine.render.arrays import Floats
    from engine.scene.camera import Camera, Size


@dataclass(frozen=True, slots=True, eq=False)
class View:
    """A camera in numbers for one size of picture."""

    eye: Floats
    basis: Floats
    focal: float
    near: float
    size: Size

    @property
    def numbers(self) -> tuple[Floats, Floats, float, float, float, float]:
        """Return eye, basis, focal length, near plane, width and height, as kernels take them."""
        return self.eye, self.basis, self.focal, self.near, float(self.size[0]), float(self.size[1])


def view_of(camera: Camera, size: Size) -> View:
    """Return the numbers of a camera for a picture of `size` pixels."""
    return View(
        np.array(camera.eye, dtype=np.float64),
        np.ascontiguousarray(camera.basis()),
        camera.focal(size[1]),
        camera.near,
        size,
    )
