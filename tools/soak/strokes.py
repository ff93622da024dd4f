"""Random shots by number: breaks, strewn balls and crowds of touching balls.

One idea: shot number k of a plan is always the same shot, made from the seed and k alone.
Invariant: every shot can be played: balls lie apart, on the bed, and not over a drop.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache
from math import atan2, cos, hypot, pi, radians, sin, sqrt
from typing import TYPE_CHECKING

import numpy as np

from engine.game.placing import opening_layout
from engine.game.shot import as_written
from engine.physics.pack import nose_reach
from engine.physics.world import MODEL_NAMES, Strike
from engine.table.region import has_room
from engine.variant.load import load_variant

if TYPE_CHECKING:
    from engine.physics.world import Layout, World
    from engine.table.furniture import BallId, Point
    from engine.variant.variant import Variant

GAPS = (0.0, 1e-9, 1e-6, 2e-5, 1e-4)
"""How far (m) neighbours in a crowd stand from each other."""

FLYING = 0.5
"""The share of strokes with a raised cue after which balls may fly, whatever the variant says."""

LOOSE = 5.7e-5
"""How far (m) the balls of a loosened rack stand from each other at most."""


@dataclass(frozen=True, slots=True)
class Plan:
    """What is soaked: the seed, the variants by name, and models that replace theirs.

    With `every` model, shots go through all of them in turn.
    """

    seed: int
    variants: tuple[str, ...]
    models: tuple[tuple[str, str], ...] = ()
    every: bool = False


@dataclass(frozen=True, slots=True)
class Stroke:
    """One random shot."""

    number: int
    variant: Variant
    world: World
    scene: str
    layout: Layout
    ball: BallId
    strike: Strike


@cache
def _loaded(name: str) -> Variant:
    return load_variant(name)


@cache
def _opening(name: str) -> Layout:
    return opening_layout(_loaded(name))


@cache
def _world(name: str, models: tuple[tuple[str, str], ...]) -> World:
    world = _loaded(name).world
    if not models:
        return world
    return replace(world, models=replace(world.models, **dict(models)))


def _models(plan: Plan, number: int) -> tuple[tuple[str, str], ...]:
    """Return the models that replace the variant's own in this shot."""
    chosen = dict(plan.models)
    if plan.every:
        turn = number // len(plan.variants)
        for what in ("ball_ball", "ball_cushion"):
            names = MODEL_NAMES[what]
            chosen.setdefault(what, names[turn % len(names)])
            turn //= len(names)
    return tuple(sorted(chosen.items()))


def make_stroke(plan: Plan, number: int) -> Stroke:
    """Return the shot of this number."""
    chance = np.random.default_rng([plan.seed, number])
    name = plan.variants[number % len(plan.variants)]
    variant = _loaded(name)
    ball = variant.cue_balls[0]
    scene = ("break", "strewn", "crowd")[int(chance.integers(3))]
    if scene == "break":
        layout, strike = _break(chance, variant)
    else:
        layout = _strewn(chance, variant, crowd=scene == "crowd")
        strike = _strike(chance, chance.uniform(0.0, 2.0 * pi))
    models = dict(_models(plan, number))
    if chance.uniform() < FLYING and strike.elevation > 0.0:
        models.setdefault("flight", "ballistic")
    world = _world(name, tuple(sorted(models.items())))
    return Stroke(number, variant, world, scene, layout, ball, as_written(strike))


def _strike(chance: np.random.Generator, heading: float) -> Strike:
    """Return a strike of any force, anywhere on the ball, now and then with a raised cue."""
    offset, turn = 0.55 * chance.uniform() ** 0.5, chance.uniform(0.0, 2.0 * pi)
    raised = radians(chance.uniform(0.0, 80.0)) if chance.uniform() < 0.2 else 0.0
    speed = chance.uniform(0.5, 11.0) if chance.uniform() < 0.8 else 10.0 ** chance.uniform(-4, 0)
    return Strike(speed, heading, raised, offset * cos(turn), offset * sin(turn))


def _break(chance: np.random.Generator, variant: Variant) -> tuple[Layout, Strike]:
    """Return the opening, as it lies or loosened, and a hard stroke at the nearest ball."""
    layout = dict(_opening(variant.name))
    cue = variant.cue_balls[0]
    if chance.uniform() < 0.5:
        layout = _loosened(chance, layout, variant)
    x, y = layout[cue]
    moved = (x, y + chance.uniform(-0.12, 0.12))
    if _free(variant.world, {k: v for k, v in layout.items() if k != cue}, cue, moved):
        layout[cue] = moved
    x, y = layout[cue]
    others = [at for ball, at in layout.items() if ball != cue]
    u, v = min(others, key=lambda at: hypot(at[0] - x, at[1] - y))
    strike = _strike(chance, atan2(v - y, u - x) + chance.normal(0.0, 0.02))
    return layout, replace(strike, speed=chance.uniform(1.0, 12.0))


def _loosened(chance: np.random.Generator, layout: Layout, variant: Variant) -> dict[BallId, Point]:
    """Return a layout whose balls stand a little apart."""
    others = [at for ball, at in layout.items() if ball not in variant.cue_balls]
    centre = min(others)
    spread = 1.0 + LOOSE / (2.0 * min(ball.radius for ball in variant.world.balls))
    loose = {}
    for ball, (x, y) in layout.items():
        if ball in variant.cue_balls:
            loose[ball] = (x, y)
            continue
        dx, dy = chance.uniform(-LOOSE / 4.0, LOOSE / 4.0, 2)
        ux, uy = centre[0] + (x - centre[0]) * spread, centre[1] + (y - centre[1]) * spread
        loose[ball] = (float(ux + dx), float(uy + dy))
    return loose


def _strewn(chance: np.random.Generator, variant: Variant, *, crowd: bool) -> Layout:
    """Return some balls of the set here and there; in a crowd many touch a ball or a nose."""
    world, cue = variant.world, variant.cue_balls[0]
    others = [ball.id for ball in world.balls if ball.id != cue]
    count = int(chance.integers(0, len(others) + 1))
    names = [cue, *(others[k] for k in sorted(chance.permutation(len(others))[:count]))]
    layout: dict[BallId, Point] = {}
    for name in names:
        half = _half(world, name)
        for _ in range(200):
            at = (float(chance.uniform(-1, 1)) * half[0], float(chance.uniform(-1, 1)) * half[1])
            if crowd:
                at = _beside(chance, world, layout, name, at)
            if _free(world, layout, name, at):
                layout[name] = at
                break
    return layout


def _radius(world: World, name: BallId) -> float:
    return next(ball.radius for ball in world.balls if ball.id == name)


def _apart(world: World, one: BallId, two: BallId) -> float:
    """Return the distance (m) of two balls' centres when they touch on the bed."""
    return 2.0 * sqrt(_radius(world, one) * _radius(world, two))


def _reach(world: World, name: BallId) -> float:
    """Return how far (m) a ball's centre is from a nose that it touches."""
    return nose_reach(_radius(world, name), world.table.nose_height)


def _half(world: World, name: BallId) -> Point:
    """Return how far (m) from the middle of the bed a ball's centre can lie, along and across."""
    reach = _reach(world, name)
    return world.table.length / 2.0 - reach, world.table.width / 2.0 - reach


def _beside(
    chance: np.random.Generator, world: World, layout: Layout, name: BallId, at: Point
) -> Point:
    """Return a place that touches another ball or a long cushion, or the place as it is."""
    if layout and chance.uniform() < 0.5:
        other, (x, y) = list(layout.items())[int(chance.integers(len(layout)))]
        turn = chance.uniform(0.0, 2.0 * pi)
        apart = _apart(world, name, other) + GAPS[int(chance.integers(len(GAPS)))]
        return float(x + apart * cos(turn)), float(y + apart * sin(turn))
    if chance.uniform() < 0.2:
        edge = _half(world, name)[1]
        return at[0], edge if chance.uniform() < 0.5 else -edge
    return at


def _free(world: World, layout: Layout, name: BallId, at: Point) -> bool:
    """Say whether a ball fits in at a place: clear of all others, on the bed, not over a drop."""
    for other, (x, y) in layout.items():
        if hypot(at[0] - x, at[1] - y) < _apart(world, name, other):
            return False
    pulled = at[0] * (1.0 - 1e-6), at[1] * (1.0 - 1e-6)
    return has_room(world.table, pulled, _radius(world, name))
