"""A tiny scene with one of everything, to compile and load the kernels by drawing it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from engine.scene.camera import Camera
from engine.scene.scene import GameObject, Light, Scene
from engine.scene.shape import Disc, Polyline, Skin, Sphere, make_mesh

if TYPE_CHECKING:
    from engine.render.renderer import Renderer


def draw_tiny(renderer: Renderer) -> None:
    """Draw a tiny scene until the renderer keeps what never moves and draws over it."""
    scene, picture = tiny_scene(), np.zeros((16, 16), np.uint32)
    for _ in range(3):
        renderer.render(scene, picture)


def tiny_scene() -> Scene:
    """Return a scene that passes through every kernel."""
    square = np.array([[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]])
    ground = make_mesh(square, [(0, 1, 2, 3)], (0, 90, 70), kind="sheet", layer=1)
    tint = make_mesh(square, [(0, 1, 2, 3)], (9, 9, 9), kind="sheet", layer=1, alpha=0.5)
    top = make_mesh(square * 0.2 + [0.0, 0.0, 0.1], [(0, 1, 2, 3)], (90, 60, 30), gloss=0.5)
    skin = Skin(np.zeros((4, 4, 3), np.uint8))
    line = Polyline(np.array([[-1, 0, 0.01], [1, 0, 0.01]], np.float32), (255, 255, 255))
    disc = Disc((0.0, 0.0, 0.0), 0.3, (0, 0, 0), 0.5, 0.1)
    return Scene(
        objects=(
            GameObject((ground, top, line), fixed=True),
            GameObject((tint, top), (0.3, 0.0, 0.2)),
            GameObject((Sphere(0.2, (9, 9, 9), skin),), (0.0, 0.0, 0.2)),
            GameObject((Sphere(0.2, (99, 9, 9)),), (0.5, 0.0, 0.2)),
        ),
        lights=(Light((0.0, 0.0, 2.0)),),
        camera=Camera((0.0, -2.0, 1.0), (0.0, 0.0, 0.0)),
        marks=(disc,),
        shadows=(disc,),
    )
