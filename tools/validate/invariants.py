"""What must hold for every hit on a nose: energy, mirror and scale, over random states."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from engine.physics import state
from engine.physics.pack import nose_reach, pack_rubber, pack_world
from engine.physics.rare import rebound as bounce
from engine.physics.world import MODEL_NAMES, Rubber
from tools.validate.lab import MASS, RADIUS, world_of
from tools.validate.prose import spoken

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tools.validate.check import Check, Wanted

    Floats = NDArray[np.float64]

V, W = [state.VX, state.VY], [state.WX, state.WY, state.WZ]


def _states(check: Check) -> int:
    return int(spoken(check, "states", r"#(?: random)? states"))


def _energy(rows: Floats) -> Floats:
    """Return the energy (n,) of rows (n, ..., 17) of balls, summed over all but the first axis."""
    v2, w2 = (rows[..., V] ** 2).sum(-1), (rows[..., W] ** 2).sum(-1)
    each = rows[..., state.MASS] * (0.5 * v2 + 0.2 * rows[..., state.RADIUS] ** 2 * w2)
    total: Floats = each.reshape(len(rows), -1).sum(-1)
    return total


def _rebounds(check: Check, model: str) -> tuple[Floats, tuple[Floats, Floats], Floats]:
    """Return random balls (n, 17) before a nose along X, their packed world, and how they left."""
    n = _states(check) // len(MODEL_NAMES["ball_cushion"])
    chance = np.random.default_rng(int(check.number("seed", default=1)))
    rubber = Rubber(check.number("e", default=0.85), 0.0, 0.0, check.number("mu", default=0.2))
    nose = check.number("h", default=1.27 * RADIUS)
    laid = world_of(check, 1, rubber=rubber, ball_cushion=model)
    world = (pack_world(laid), pack_rubber(laid))
    rows = np.zeros((n, state.BALL_WIDTH))
    rows[:, state.RADIUS], rows[:, state.MASS] = RADIUS, MASS
    rows[:, state.SLIDING] = laid.cloth.sliding
    rows[:, state.REACH] = nose_reach(RADIUS, nose)
    top, turn = check.number("v_max", default=8.0), check.number("w_max", default=250.0)
    rows[:, state.VX] = chance.uniform(-top, top, n)
    rows[:, state.VY] = chance.uniform(2e-3, top, n)
    rows[:, W] = chance.uniform(-turn, turn, (n, 3))
    return rows, world, _bounced(rows, world)


def _bounced(rows: Floats, world: tuple[Floats, Floats]) -> Floats:
    after = rows.copy()
    for row in after:
        bounce(row, *world, 0.0, 1.0)
    return after


MIRROR = (state.VX, state.WY, state.WZ)
SCALED = [*V, *W]


def _rebound_invariant(check: Check, wanted: Wanted) -> object:
    return max(_of_model(check, wanted, model) for model in MODEL_NAMES["ball_cushion"])


def _of_model(check: Check, wanted: Wanted, model: str) -> float:
    """Return the worst error of one model; velocities and spins times radius, m/s."""
    rows, world, after = _rebounds(check, model)
    if "dKE" in wanted.quantity:
        return max(0.0, float((_energy(after) - _energy(rows)).max()))
    other = rows.copy()
    if "mirror" in wanted.quantity:
        factor = np.where(np.isin(SCALED, MIRROR), -1.0, 1.0)
    else:
        factor = np.full(len(SCALED), 2.0)
    other[:, SCALED] *= factor
    error = np.abs(_bounced(other, world)[:, SCALED] - after[:, SCALED] * factor)
    error[:, 2:] *= RADIUS
    return float(error.max())


KINDS = ((r"mirror error|scale error.*|max dKE", _rebound_invariant),)
"""Which quantity is answered by what."""
