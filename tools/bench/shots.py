"""The shots whose cost is measured: breaks, strokes among few balls, strokes among many.

One idea: a piece of work is some like shots, each a little different so that none is special;
what one simulator plays, another can play from the same places and the same first velocity.
Invariant: the same shots on every run and machine.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, hypot, pi, sin
from typing import TYPE_CHECKING

import numpy as np

from engine.game.placing import opening_layout
from engine.physics.world import Strike
from engine.variant.load import load_variant

if TYPE_CHECKING:
    from engine.physics.world import Layout, World
    from engine.table.furniture import BallId, Point

SEED = 2012
GAP = 5.7e-5
"""How far (m) neighbours of a loosened rack stand apart on average: a thousandth of a diameter."""

TURNS = 0.004
"""How far (rad) the heading of like shots goes to either side."""


@dataclass(frozen=True, slots=True)
class Work:
    """Like shots at one world: their layouts and strikes, the ball struck, and the goal (ms)."""

    name: str
    world: World
    ball: BallId
    shots: tuple[tuple[Layout, Strike], ...]
    goal: float | None = None
    kind: str = "pool"


def breaks(shots: int) -> tuple[Work, ...]:
    """Return the opening breaks, from loosened and from frozen racks."""
    return (
        _break("9-ball break 8 m/s, small gaps", "nine_ball", 8.0, shots, 0.5),
        _break("8-ball break 8 m/s, small gaps", "eight_ball", 8.0, shots, 1.0),
        _break("8-ball break 8 m/s, frozen rack", "eight_ball", 8.0, shots, 10.0, gap=0.0),
        _smash("snooker break 4 m/s, small gaps", shots, 1.5, GAP),
        _smash("snooker break 4 m/s, frozen pack", shots, None, 0.0),
    )


def few(shots: int) -> tuple[Work, ...]:
    """Return strokes of two and three balls."""
    pool, carom = load_variant("eight_ball"), load_variant("three_cushion")
    cue, other = pool.cue_balls[0], pool.world.balls[1].id
    layout = {cue: (-0.5, 0.1), other: (0.4, 0.0)}
    two = tuple((layout, _towards(layout, cue, (0.4, 0.02), 1.5, t)) for t in _turns(shots))
    ball, opening = carom.cue_balls[0], opening_layout(carom)
    aim = opening[carom.world.balls[-1].id]
    three = tuple((opening, _towards(opening, ball, aim, 4.0, t, 0.3)) for t in _turns(shots))
    return (
        Work("two-ball stroke 1.5 m/s", pool.world, cue, two, 0.03),
        Work("three-ball stroke 4 m/s", carom.world, ball, three, 0.03, "carom"),
    )


def crowds(shots: int) -> tuple[Work, ...]:
    """Return strokes among 2, 9, 16 and 22 balls strewn over one table, for the cost an event."""
    variant = load_variant("snooker")
    chance = np.random.default_rng(SEED)
    works = []
    for count in (2, 9, 16, 22):
        balls = [variant.cue_balls[0]]
        balls += [ball.id for ball in variant.world.balls if ball.id not in balls]
        played = []
        for _ in range(shots):
            layout = strewn(chance, variant.world, tuple(balls[:count]))
            target = layout[balls[1]]
            speed = float(chance.uniform(3.0, 5.0))
            played.append((layout, _towards(layout, balls[0], target, speed, 0.0)))
        name = f"stroke among {count} balls, 3 to 5 m/s"
        works.append(Work(name, variant.world, balls[0], tuple(played), kind="snooker"))
    return tuple(works)


def random_breaks(shots: int) -> Work:
    """Return breaks of 2 to 9 m/s into racks with gaps from none to 1 mm, struck at random."""
    variant = load_variant("eight_ball")
    opening, ball = opening_layout(variant), variant.cue_balls[0]
    chance = np.random.default_rng(SEED)
    played = []
    for number in range(shots):
        gap = 0.0 if number % 4 == 0 else float(10.0 ** chance.uniform(-6.0, -3.0))
        layout = dict(loosened(chance, opening, ball, gap))
        x, y = layout[ball]
        layout[ball] = (x, y + float(chance.uniform(-0.3, 0.3)))
        speed, turn = float(chance.uniform(2.0, 9.0)), float(chance.normal(0.0, 0.01))
        offset, angle = 0.5 * chance.uniform() ** 0.5, chance.uniform(0.0, 2.0 * pi)
        side, follow = float(offset * cos(angle)), float(offset * sin(angle))
        strike = _towards(layout, ball, _nearest(layout, ball), speed, turn, side, follow)
        played.append((layout, strike))
    return Work("random 8-ball breaks, 2 to 9 m/s", variant.world, ball, tuple(played), 10.0)


def _break(
    name: str, variant_name: str, speed: float, shots: int, goal: float, gap: float = GAP
) -> Work:
    variant = load_variant(variant_name)
    ball, opening = variant.cue_balls[0], opening_layout(variant)
    chance = np.random.default_rng(SEED)
    played = []
    for turn in _turns(shots):
        layout = loosened(chance, opening, ball, gap)
        played.append((layout, _towards(layout, ball, _nearest(layout, ball), speed, turn)))
    return Work(name, variant.world, ball, tuple(played), goal)


def _smash(name: str, shots: int, goal: float | None, gap: float) -> Work:
    """Return full strokes at 4 m/s into the side of a pack of reds, from beside the brown."""
    variant = load_variant("snooker")
    ball, opening = variant.cue_balls[0], dict(opening_layout(variant))
    named = {str(one): at for one, at in opening.items()}
    opening[ball] = named["brown"][0], -0.2
    chance = np.random.default_rng(SEED)
    played = []
    for turn in _turns(shots):
        layout = loosened(chance, opening, ball, gap)
        played.append((layout, _towards(layout, ball, named["red-6"], 4.0, turn)))
    return Work(name, variant.world, ball, tuple(played), goal, "snooker")


def loosened(
    chance: np.random.Generator, layout: Layout, cue: BallId, gap: float
) -> dict[BallId, Point]:
    """Return the balls that touch others drawn apart by `gap` (m) and moved by up to half of it."""
    placed = dict(layout)
    packed = [ball for ball in layout if ball != cue and _touches(layout, ball)]
    if gap == 0.0 or not packed:
        return placed
    ax, ay = min(layout[ball] for ball in packed)
    near = min(hypot(layout[ball][0] - ax, layout[ball][1] - ay) or 1.0 for ball in packed)
    for ball in packed:
        x, y = layout[ball]
        far, angle = chance.uniform(0.0, gap / 2.0), chance.uniform(0.0, 2.0 * pi)
        stretch = 1.0 + gap / near
        placed[ball] = (
            float(ax + (x - ax) * stretch + far * cos(angle)),
            float(ay + (y - ay) * stretch + far * sin(angle)),
        )
    return placed


def _touches(layout: Layout, ball: BallId) -> bool:
    x, y = layout[ball]
    apart = sorted(hypot(u - x, v - y) for other, (u, v) in layout.items() if other != ball)
    return len(apart) > 1 and apart[1] - apart[0] < 1e-9


def strewn(
    chance: np.random.Generator, world: World, balls: tuple[BallId, ...]
) -> dict[BallId, Point]:
    """Return places here and there on the bed, no two balls nearer than three radii."""
    radius = max(ball.radius for ball in world.balls)
    half = world.table.length / 2.0 - 4.0 * radius, world.table.width / 2.0 - 4.0 * radius
    layout: dict[BallId, Point] = {}
    for ball in balls:
        while ball not in layout:
            x, y = (float(chance.uniform(-limit, limit)) for limit in half)
            if all(hypot(x - u, y - v) > 3.0 * radius for u, v in layout.values()):
                layout[ball] = (x, y)
    return layout


def _nearest(layout: Layout, ball: BallId) -> Point:
    x, y = layout[ball]
    others = [at for other, at in layout.items() if other != ball]
    return min(others, key=lambda at: hypot(at[0] - x, at[1] - y))


def _turns(shots: int) -> list[float]:
    return [float(turn) for turn in np.linspace(-TURNS, TURNS, shots)]


def _towards(
    layout: Layout,
    ball: BallId,
    target: Point,
    speed: float,
    turn: float,
    side: float = 0.0,
    follow: float = 0.0,
) -> Strike:
    x, y = layout[ball]
    heading = atan2(target[1] - y, target[0] - x) + turn
    return Strike(speed, heading, 0.0, side, follow)


__all__ = ["Work", "breaks", "crowds", "few", "loosened", "random_breaks", "strewn"]
