"""A tiny shot that touches every kernel: two balls and one nose, for warming up.

One idea: compiling on a fresh machine takes seconds, so it is done at a moment the caller
chooses. Invariant: nothing of it is kept but the compiled code.
"""

from __future__ import annotations

from math import inf

from engine.physics.simulate import Simulation
from engine.physics.world import (
    Ball,
    Cloth,
    Contact,
    Cue,
    Models,
    Rubber,
    Strike,
    World,
)
from engine.table.build import build_table
from engine.table.furniture import BallId


def play_trial() -> None:
    """Play the tiny shot."""
    one, two = BallId("one"), BallId("two")
    world = World(
        table=build_table(1.0, 0.5, 0.036, None, None, 0.1),
        balls=(Ball(one, 0.028, 0.17), Ball(two, 0.028, 0.17)),
        cloth=Cloth(0.2, 0.01, 10.0),
        contact=Contact(0.95, 0.05),
        rubber=Rubber(0.9, 0.0, 0.0, 0.14),
        cue=Cue(0.54, 0.73, 0.6, 25.0),
        models=Models(),
    )
    shot = Simulation(world, {one: (0.0, 0.0), two: (0.2, 0.0)}, one, Strike(1.0, 0.0))
    shot.advance(inf)
    shot.trace()


__all__ = ["play_trial"]
