"""Tables and scenes that the renderers are checked with.

One idea: renderers know no game, so most scenes stand on tables made here; a variant's own table
comes with its balls as they lie at the start.
"""

from __future__ import annotations

from dataclasses import replace
from math import pi, radians
from typing import TYPE_CHECKING

import numpy as np

from engine.game.placing import opening_layout
from engine.physics.world import Ball
from engine.scene.shape import Polyline, Sphere
from engine.stage.cameras import above_camera, cue_camera, orbit_camera
from engine.stage.cue import CuePose
from engine.stage.stage import build_stage, stage_of
from engine.table.build import PocketCut, build_table
from engine.table.furniture import BallId
from engine.variant.load import load_variant
from engine.variant.variant import BallKind, Look

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from engine.render.renderer import Renderer
    from engine.scene.camera import Size, Vector
    from engine.scene.scene import Scene
    from engine.stage.stage import Stage
    from engine.table.furniture import Table

    Pixels = NDArray[np.uint32]

RADIUS = 0.0286
LOOK = Look((0, 98, 82), (104, 52, 26))
POSES = ("cue", "above", "orbit")
WIDE: Size = (1280, 720)


def pocket_table() -> Table:
    """Return a table with straight jaws."""
    corner = PocketCut(0.1168, radians(142), 0.04, 0.003, 0.067)
    side = PocketCut(0.1302, radians(104), 0.0, 0.003, 0.068)
    return build_table(2.54, 1.27, 0.0365, corner, side, 0.12)


def round_jaw_table() -> Table:
    """Return a table with round jaws."""
    corner = PocketCut(0.083, radians(135), 0.02, 0.102, 0.058)
    side = PocketCut(0.087, radians(90), 0.005, 0.064, 0.058)
    return build_table(3.569, 1.778, 0.03675, corner, side, 0.127)


def plain_table() -> Table:
    """Return a table without pockets."""
    return build_table(2.84, 1.42, 0.037, None, None, 0.14)


TABLES = {"pockets": pocket_table, "round jaws": round_jaw_table, "plain": plain_table}


def make_stage(table: Table, count: int = 16) -> Stage:
    """Return the stage of a table with so many balls, every other one striped."""
    kinds, bodies = [], []
    for k in range(count):
        name = BallId(f"b{k}")
        colour = ((53 * k + 90) % 256, (97 * k + 40) % 256, (151 * k + 70) % 256)
        kinds.append(BallKind(name, colour, "stripe" if k % 2 else "plain", str(k) if k else ""))
        bodies.append(Ball(name, RADIUS, 0.17))
    return stage_of(table, bodies, kinds, LOOK)


def scatter(stage: Stage, seed: int) -> dict[BallId, Vector]:
    """Return random places, some on cushions and in jaws, none overlapping."""
    dice = np.random.default_rng(seed)
    x, y = stage.table.length / 2 - RADIUS, stage.table.width / 2 - RADIUS
    places: dict[BallId, Vector] = {}
    for ball in stage.spheres:
        for _ in range(200):
            spot = dice.uniform(-1, 1, 2) * (x, y)
            kind = dice.integers(0, 4)
            if kind == 0:
                side = dice.integers(0, 2)
                spot[side] = np.sign(spot[side]) * (x, y)[side]
            elif kind == 1 and stage.table.pockets:
                pocket = stage.table.pockets[dice.integers(0, len(stage.table.pockets))]
                middle = np.mean(pocket.mouth, axis=0)
                spot = middle - 0.02 * np.sign(middle) * dice.uniform(0, 1)
            free = all(np.hypot(*(spot - p[:2])) > 2.0 * RADIUS for p in places.values())
            if free:
                places[ball] = (float(spot[0]), float(spot[1]), RADIUS)
                break
    return places


def standard_scene(stage: Stage, pose: str, seed: int = 1) -> Scene:
    """Return scattered balls seen in one of the standard `POSES`."""
    places = scatter(stage, seed)
    place = next(iter(places.values()))
    if pose == "cue":
        camera = cue_camera(stage.table, place[:2], 0.3)
        return stage.scene(places, camera, cue=CuePose(place, RADIUS, 0.3, 0.08))
    if pose == "above":
        return stage.scene(places, above_camera(stage.table, 16 / 9))
    return stage.scene(places, orbit_camera(stage.table, 2.4, 0.5))


def random_scene(stage: Stage, seed: int) -> Scene:
    """Return scattered balls seen from a random side."""
    dice = np.random.default_rng([seed, 7])
    turn, rise = dice.uniform(0.0, 2.0 * pi), dice.uniform(0.12, 1.2)
    away = dice.uniform(0.55, 1.1) * stage.table.length
    return stage.scene(scatter(stage, seed), orbit_camera(stage.table, turn, rise, away))


def variant_scene(name: str) -> Scene:
    """Return a variant's table with its balls as they lie at the start, seen from one side."""
    variant = load_variant(name)
    stage = build_stage(variant)
    radii = {ball.id: ball.radius for ball in variant.world.balls}
    lying = {ball: (x, y, radii[ball]) for ball, (x, y) in opening_layout(variant).items()}
    return stage.scene(lying, orbit_camera(stage.table, 2.4, 0.5))


def bare(scene: Scene) -> Scene:
    """Return a scene of nothing but faces with one colour each, none of them clear."""
    objects = []
    for thing in scene.objects:
        shapes = []
        for shape in thing.shapes:
            if isinstance(shape, Polyline) or getattr(shape, "alpha", 1.0) < 1.0:
                continue
            shapes.append(replace(shape, skin=None) if isinstance(shape, Sphere) else shape)
        objects.append(replace(thing, shapes=tuple(shapes)))
    return replace(scene, objects=tuple(objects), marks=(), shadows=())


def draw(renderer: Renderer, scene: Scene, size: Size = (640, 360)) -> Pixels:
    """Return the pixels of a scene."""
    pixels = np.zeros((size[1], size[0]), np.uint32)
    renderer.render(scene, pixels)
    return pixels
