"""The fixed scene of the renderers' speed tables: 22 balls on a twelve-foot table.

One idea: the camera goes once round the table in 240 frames, or rests while the balls roll on.
"""

from __future__ import annotations

from math import pi, radians
from typing import TYPE_CHECKING

import numpy as np

from engine.physics.world import Ball
from engine.scene.shape import Mesh, sphere_mesh
from engine.stage.cameras import orbit_camera
from engine.stage.stage import stage_of
from engine.table.build import PocketCut, build_table
from engine.table.furniture import BallId
from engine.variant.variant import BallKind, Look

if TYPE_CHECKING:
    from engine.scene.camera import Camera, Vector
    from engine.scene.scene import Scene
    from engine.stage.stage import Stage

SIZES = ((1280, 720), (1920, 1080))
BALLS = 22
RADIUS = 0.02625
GRADIENT = 20
"""Steps of latitude of a ball where balls are drawn as triangles."""
ROUND = 240
"""Frames in which the camera goes round the table."""
ROLL = 0.0005
"""How far (m) the balls move in a frame while the camera rests."""


class TableScene:
    """The stage of the scene, and the scene of any frame."""

    def __init__(self) -> None:
        corner = PocketCut(0.083, radians(135.0), 0.02, 0.102, 0.058)
        side = PocketCut(0.087, radians(90.0), 0.005, 0.064, 0.058)
        table = build_table(3.569, 1.778, 0.03675, corner, side, 0.127)
        names = [BallId(f"ball-{k}") for k in range(BALLS)]
        bodies = [Ball(name, RADIUS, 0.1406) for name in names]
        look = Look((14, 104, 46), (84, 42, 22))
        self.stage: Stage = stage_of(table, bodies, _kinds(names), look)
        self.places: dict[BallId, Vector] = {
            name: (-1.5 + 3.0 * (k % 6) / 5.0, -0.7 + 1.4 * (k // 6) / 3.0, RADIUS)
            for k, name in enumerate(names)
        }

    def camera(self, frame: int, *, resting: bool) -> Camera:
        """Return the camera of a frame."""
        turn = 0.0 if resting else 2.0 * pi * frame / ROUND
        return orbit_camera(self.stage.table, 2.2 + turn, 0.55, 3.4)

    def at(self, frame: int, *, resting: bool) -> Scene:
        """Return the scene of a frame."""
        shift = ROLL * (frame % ROUND)
        places = {ball: (x + shift, y, z) for ball, (x, y, z) in self.places.items()}
        return self.stage.scene(places, self.camera(frame, resting=resting))

    def triangles(self) -> int:
        """Return how many triangles the scene has, its balls as meshes."""
        shapes = self.stage.furniture.shapes
        table = sum(len(shape.triangles) for shape in shapes if isinstance(shape, Mesh))
        return table + BALLS * len(sphere_mesh(GRADIENT).triangles)


def _kinds(names: list[BallId]) -> list[BallKind]:
    dice = np.random.default_rng(2012)
    kinds = []
    for k, name in enumerate(names):
        red, green, blue = (int(c) for c in dice.integers(20, 250, 3))
        pattern = "stripe" if k % 2 else "plain"
        kinds.append(BallKind(name, (red, green, blue), pattern, str(k) if k % 3 else ""))
    return kinds


__all__ = ["BALLS", "GRADIENT", "SIZES", "TableScene"]
