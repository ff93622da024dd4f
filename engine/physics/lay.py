"""From a layout to the balls' rows: who lies on the table, where, and clear of whom.

One idea: few balls are looked through one by one, many by numpy at once. Invariant: rows follow
the order of `World.balls`, and no two balls overlap by more than OVERLAP.
"""

from __future__ import annotations

from math import isfinite, sqrt
from typing import TYPE_CHECKING

import numpy as np

from engine.physics import state

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from engine.physics.pack import Packed
    from engine.physics.world import Ball, Layout
    from engine.table.furniture import Point

OVERLAP = 1e-4


def place_balls(world: Packed, layout: Layout) -> tuple[tuple[Ball, ...], NDArray[np.float64]]:
    """Return the balls on the table in the world's order and their rows, at rest.

    Raises ValueError for a layout that cannot be.
    """
    index, known = world.index, world.world.balls
    try:
        chosen = sorted([index[ball] for ball in layout])
    except KeyError:
        message = (
            f"the layout names balls that the world has not: {sorted(set(layout) - set(index))}"
        )
        raise ValueError(message) from None
    balls = tuple([known[i] for i in chosen])
    whole = len(chosen) == len(known)
    rows = world.rows.copy() if whole else world.rows.take(chosen, axis=0)
    if len(balls) > FEW:
        rows[:, state.X : state.Y + 1] = [layout[ball.id] for ball in balls]
        _check_places(balls, rows)
    else:
        places = [layout[ball.id] for ball in balls]
        for i, (x, y) in enumerate(places):
            rows[i, state.X], rows[i, state.Y] = x, y
        _check_few(balls, places)
    return balls, rows


FEW = 4
"""So few balls are looked through one by one."""


def _check_few(balls: tuple[Ball, ...], places: list[Point]) -> None:
    for i, (x, y) in enumerate(places):
        if not isfinite(x + y):
            raise ValueError("a ball's place must be two finite numbers")
        for k in range(i):
            u, v = places[k]
            dx, dy = x - u, y - v
            need = 2.0 * sqrt(balls[i].radius * balls[k].radius) - OVERLAP
            if dx * dx + dy * dy < need * need:
                message = f"balls overlap: {balls[k].id} and {balls[i].id}"
                raise ValueError(message)


def _check_places(balls: tuple[Ball, ...], rows: NDArray[np.float64]) -> None:
    x, y, radii = rows[:, state.X], rows[:, state.Y], rows[:, state.RADIUS]
    if not isfinite(x.sum() + y.sum()):
        raise ValueError("a ball's place must be two finite numbers")
    dx, dy = x[:, None] - x, y[:, None] - y
    need = 2.0 * np.sqrt(radii[:, None] * radii) - OVERLAP
    bad = dx * dx + dy * dy < need * need
    if np.count_nonzero(bad) > len(balls):
        first, second = next((i, j) for i, j in np.argwhere(bad) if i < j)
        message = f"balls overlap: {balls[first].id} and {balls[second].id}"
        raise ValueError(message)


__all__ = ["place_balls"]
