"""What must hold for every meeting of two balls in space, over random states.

One idea: pairs of unequal balls that touch and near each other in any direction are handed to the
function that resolves meetings in the air, all at once before and after. Invariant: the same seed
gives the same pairs.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from engine.physics import state
from engine.physics.impact import meet_ball
from engine.physics.pack import pack_world
from engine.physics.world import Contact
from tools.validate.lab import contact_of, world_of
from tools.validate.prose import spoken

if TYPE_CHECKING:
    from tools.validate.check import Check, Wanted
    from tools.validate.lab import Floats

R = [state.X, state.Y, state.Z]
V, W = [state.VX, state.VY, state.VZ], [state.WX, state.WY, state.WZ]


def _pairs(check: Check) -> Floats:
    """Return random pairs (n, 2, columns) of balls that touch and near each other."""
    n = int(spoken(check, "states", r"#(?: random)? states"))
    chance = np.random.default_rng(int(check.number("seed", default=1)))
    top, turn = check.number("v_max"), check.number("w_max")
    rows = np.zeros((n, 2, state.BALL_WIDTH))
    rows[..., state.RADIUS] = chance.uniform(0.02, 0.04, (n, 2))
    rows[..., state.MASS] = chance.uniform(0.1, 0.4, (n, 2))
    rows[..., V] = chance.uniform(-top, top, (n, 2, 3))
    rows[..., W] = chance.uniform(-turn, turn, (n, 2, 3))
    way = chance.normal(size=(n, 3))
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    rows[:, 0, R] = chance.uniform(-1.0, 1.0, (n, 3))
    rows[:, 1, R] = rows[:, 0, R] + way * rows[..., state.RADIUS].sum(1)[:, None]
    nearing = ((rows[:, 0, V] - rows[:, 1, V]) * way).sum(1)
    rows[..., V] *= np.sign(nearing)[:, None, None]
    chosen: Floats = rows[np.abs(nearing) >= state.SOFT]  # what is slower rests
    return chosen


def _met(check: Check, contact: Contact) -> tuple[Floats, Floats]:
    """Return random pairs before and after they met."""
    before = _pairs(check)
    after, world = before.copy(), pack_world(world_of(check, contact=contact))
    for one, two in after:
        meet_ball(one, two, state.FLY, state.FLY, world)
    return before, after


def _energy(rows: Floats) -> Floats:
    v2, w2 = (rows[..., V] ** 2).sum(-1), (rows[..., W] ** 2).sum(-1)
    each = rows[..., state.MASS] * (0.5 * v2 + 0.2 * rows[..., state.RADIUS] ** 2 * w2)
    total: Floats = each.sum(1)
    return total


def _momenta(rows: Floats) -> Floats:
    """Return each ball's momentum (n, 2, 3), kg m/s."""
    found: Floats = rows[..., state.MASS][..., None] * rows[..., V]
    return found


def _turning(rows: Floats) -> Floats:
    """Return each ball's angular momentum about the origin (n, 2, 3), kg m2/s."""
    inertia = 0.4 * rows[..., state.MASS] * rows[..., state.RADIUS] ** 2
    found: Floats = np.cross(rows[..., R], _momenta(rows)) + inertia[..., None] * rows[..., W]
    return found


def _worst_change(before: Floats, after: Floats) -> float:
    """Return by how much a sum over both balls changes, as a share of what it is made of."""
    scale = np.abs(before).sum((1, 2))
    return float((np.abs(after.sum(1) - before.sum(1)).max(-1) / scale).max())


def _momentum(check: Check, wanted: Wanted) -> object:
    before, after = _met(check, contact_of(check))
    part = _turning if "angular" in wanted.quantity else _momenta
    return _worst_change(part(before), part(after))


def _gain(check: Check, _: Wanted) -> object:
    before, after = _met(check, contact_of(check))
    return max(0.0, float((_energy(after) - _energy(before)).max()))


def _kept(check: Check, _: Wanted) -> object:
    """Return the worst change of energy, as a share of it, where nothing may be lost."""
    before, after = _met(check, Contact(1.0, 0.0))
    return float((np.abs(_energy(after) - _energy(before)) / _energy(before)).max())


KINDS = (
    (r"rel\. (angular )?momentum error", _momentum),
    (r"max dKE", _gain),
    (r"e=1, mu=0: .*", _kept),
)
"""Which quantity is answered by what."""

__all__ = ["KINDS"]
