"""How fast the renderers are: best, median and 95th percentile of the time of a frame.

One idea: a fixed scene, 22 balls on a twelve-foot table, is drawn into memory without a window;
the camera moves every frame, or rests while the balls roll.
"""

from __future__ import annotations

from math import pi, radians
from time import perf_counter
from typing import TYPE_CHECKING

import numpy as np

from engine.physics.world import Ball
from engine.render.renderer import RENDERERS, make_renderer
from engine.stage.cameras import orbit_camera
from engine.stage.stage import stage_of
from engine.table.build import PocketCut, build_table
from engine.table.furniture import BallId
from engine.variant.variant import BallKind, Look

if TYPE_CHECKING:
    from collections.abc import Iterator

    from engine.scene.scene import Scene
    from engine.stage.stage import Stage

SIZES = ((1280, 720), (1920, 1080))
BALLS = 22
RADIUS = 0.02625


def build() -> tuple[Stage, dict[BallId, tuple[float, float, float]]]:
    """Return the stage of the fixed scene and where its balls lie."""
    corner = PocketCut(0.083, radians(135.0), 0.02, 0.102, 0.058)
    side = PocketCut(0.087, radians(90.0), 0.005, 0.064, 0.058)
    table = build_table(3.569, 1.778, 0.03675, corner, side, 0.127)
    names = [BallId(f"ball-{k}") for k in range(BALLS)]
    dice = np.random.default_rng(2012)
    kinds = [
        BallKind(
            name,
            tuple(int(c) for c in dice.integers(20, 250, 3)),  # type: ignore[arg-type]
            ("plain", "stripe")[k % 2],
            str(k) if k % 3 else "",
        )
        for k, name in enumerate(names)
    ]
    bodies = [Ball(name, RADIUS, 0.1406) for name in names]
    places = {
        name: (-1.5 + 3.0 * (k % 6) / 5.0, -0.7 + 1.4 * (k // 6) / 3.0, RADIUS)
        for k, name in enumerate(names)
    }
    return stage_of(table, bodies, kinds, Look((14, 104, 46), (84, 42, 22))), places


def scenes(frames: int, *, resting: bool) -> Iterator[Scene]:
    """Yield the scene of every frame."""
    stage, places = build()
    for frame in range(frames):
        turn = 0.0 if resting else 2.0 * pi * frame / 240.0
        camera = orbit_camera(stage.table, 2.2 + turn, 0.55, 3.4)
        shift = 0.0005 * frame
        yield stage.scene({b: (x + shift, y, z) for b, (x, y, z) in places.items()}, camera)


def measure(name: str, size: tuple[int, int], frames: int, *, resting: bool) -> list[float]:
    """Return the milliseconds of every frame after the first ten."""
    renderer = make_renderer(name)
    pixels = np.zeros((size[1], size[0]), np.uint32)
    times = []
    for scene in scenes(frames + 10, resting=resting):
        start = perf_counter()
        renderer.render(scene, pixels)
        times.append((perf_counter() - start) * 1000.0)
    return times[10:]


def rows(frames: int = 120) -> Iterator[dict[str, object]]:
    """Yield a row for every renderer, size and kind of camera; times in ms a frame."""
    for size in SIZES:
        for name in RENDERERS:
            for resting in (False, True):
                times = measure(name, size, frames, resting=resting)
                yield {
                    "renderer": name,
                    "size": f"{size[0]}x{size[1]}",
                    "camera": "rests" if resting else "moves",
                    "best_ms": round(min(times), 2),
                    "median_ms": round(float(np.median(times)), 2),
                    "p95_ms": round(float(np.percentile(times, 95)), 2),
                    "fps": round(1000.0 / float(np.median(times))),
                }
