"""A scene: game objects, lights and a camera, as plain data.

Invariant: a scene says what there is, never how it is drawn.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from engine.scene.camera import Camera, Vector
    from engine.scene.shape import Disc, Rgb, Shape

UPRIGHT = np.eye(3)
"""The rotation of what is not turned."""


@dataclass(frozen=True, slots=True, eq=False)
class GameObject:
    """Shapes that stand and turn together.

    `rotation` is (3, 3), from the object's own frame to the world's; `position` in m. What is
    `fixed` never moves, and the same object is handed over in every scene: renderers keep it.
    """

    shapes: tuple[Shape, ...]
    position: Vector = (0.0, 0.0, 0.0)
    rotation: NDArray[np.float64] = field(default_factory=lambda: UPRIGHT)
    visible: bool = True
    fixed: bool = False


@dataclass(frozen=True, slots=True)
class Light:
    """A lamp at `position` (m); `power` is the light on a surface one metre below it."""

    position: Vector
    power: float = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class Scene:
    """What is to be drawn; `marks` and `shadows` lie on level planes, in the order drawn."""

    objects: tuple[GameObject, ...]
    lights: tuple[Light, ...]
    camera: Camera
    background: tuple[tuple[float, Rgb], ...] = ((0.0, (46, 50, 58)), (1.0, (14, 15, 18)))
    """Colours down the picture, each with its share of the height; between them they are mixed."""
    ambient: float = 0.3
    marks: tuple[Disc, ...] = ()
    shadows: tuple[Disc, ...] = ()
