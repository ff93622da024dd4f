"""A picture of a variant without a window: stage, camera and renderer put together.

Invariant: pygame is not needed here, so pictures can be made anywhere.
"""

from __future__ import annotations

from math import atan2
from typing import TYPE_CHECKING

import numpy as np
from PIL import Image

from engine.render.renderer import make_renderer
from engine.stage.cameras import above_camera, cue_camera, orbit_camera
from engine.stage.cue import CuePose
from engine.stage.stage import build_stage

if TYPE_CHECKING:
    from pathlib import Path

    from engine.physics.world import Layout
    from engine.scene.camera import Camera, Size
    from engine.scene.scene import Scene
    from engine.stage.stage import Stage
    from engine.table.furniture import Point
    from engine.variant.variant import Variant

CAMERAS = ("cue", "above", "orbit")


def render_variant(
    variant: Variant,
    layout: Layout,
    renderer_name: str,
    camera_name: str,
    size: Size,
    path: Path | str,
) -> None:
    """Write a PNG of `layout` at `size` (pixels) to `path`.

    Raises ValueError for a renderer or camera that is not known, OSError where the file cannot
    be written.
    """
    renderer = make_renderer(renderer_name)
    picture = np.zeros((size[1], size[0], 3), np.uint8)
    renderer.render(compose(variant, layout, camera_name, size), picture)
    Image.fromarray(picture).save(path)


def compose(variant: Variant, layout: Layout, camera_name: str, size: Size) -> Scene:
    """Return the scene of a layout, with the cue behind its ball where the camera is there."""
    stage = build_stage(variant)
    radii = {body.id: body.radius for body in variant.world.balls}
    positions = {ball: (x, y, radii[ball]) for ball, (x, y) in layout.items()}
    struck = next((ball for ball in variant.cue_balls if ball in layout), None)
    if camera_name != "cue" or struck is None:
        return stage.scene(positions, _camera(stage, camera_name, size))
    heading = _heading(layout[struck], [p for b, p in layout.items() if b != struck])
    pose = CuePose(positions[struck], radii[struck], heading, elevation=0.06)
    camera = cue_camera(variant.world.table, layout[struck], heading)
    return stage.scene(positions, camera, cue=pose)


def _camera(stage: Stage, name: str, size: Size) -> Camera:
    if name == "above":
        return above_camera(stage.table, size[0] / size[1])
    if name == "orbit":
        return orbit_camera(stage.table, 2.5, 0.5)
    if name == "cue":
        return cue_camera(stage.table, (-stage.table.length / 4.0, 0.0), 0.0)
    raise ValueError(f"there is no camera {name!r}; choose from {', '.join(CAMERAS)}")


def _heading(ball: Point, others: list[Point]) -> float:
    """Return the way to the middle of the other balls."""
    if not others:
        return 0.0
    x = sum(p[0] for p in others) / len(others)
    y = sum(p[1] for p in others) / len(others)
    return atan2(y - ball[1], x - ball[0])
