"""Rigid blows through touching balls: at once, and one by one."""

from math import cos, hypot, radians, sin, sqrt

import numpy as np
import pytest
from physics_cases import IDEAL, M, R, make_world, open_world, rack, throw

from engine.physics import state
from engine.physics.clusters import spread_at_once, spread_one_by_one
from engine.physics.events import BallsCollided
from engine.physics.pack import pack_world
from engine.physics.shock import CONTACT_WIDTH
from engine.physics.world import Contact

BOTH = (spread_at_once, spread_one_by_one)
GAP = 2.0 * R
WEDGE = [
    (0.0, 0.0),
    (GAP * cos(radians(30)), GAP * sin(radians(30))),
    (GAP * cos(radians(30)), -GAP * sin(radians(30))),
]
RACK = [(0.0, 0.0), *rack(GAP)]


def blow(spread, places, speed, contact=IDEAL, spin=None, order=None):
    """Velocities (n, 2), and energy and momentum before and after."""
    n = len(places)
    rows = np.zeros((n, state.BALL_WIDTH))
    rows[:, state.RADIUS], rows[:, state.MASS] = R, M
    rows[:, [state.X, state.Y]] = places
    rows[0, [state.VX, state.VY]] = speed
    if spin is not None:
        rows[:, [state.WX, state.WY, state.WZ]] = spin
    order = np.arange(n) if order is None else order
    rows = rows[order]
    before = totals(rows)
    contacts = np.zeros((n * n, CONTACT_WIDTH))
    spread(rows, np.arange(n), n, pack_world(make_world(n, contact=contact)), contacts)
    back = np.argsort(order)
    return rows[back][:, [state.VX, state.VY]], before, totals(rows)


def totals(rows):
    v, w = rows[:, [state.VX, state.VY]], rows[:, [state.WX, state.WY, state.WZ]]
    energy = 0.5 * M * (v**2).sum() + 0.2 * M * R * R * (w**2).sum()
    return energy, M * v.sum(0)


def test_at_once_two_frozen_balls_part_evenly():
    v, before, after = blow(spread_at_once, WEDGE, (1.0, 0.0))
    assert v[0] == pytest.approx([-0.2, 0.0], abs=1e-14)
    assert np.hypot(*v[1]) == pytest.approx(0.4 * sqrt(3.0), abs=1e-14)
    assert v[1] == pytest.approx(v[2] * [1.0, -1.0], abs=1e-14)
    assert after[0] == pytest.approx(before[0], rel=1e-14)


def test_one_by_one_the_left_ball_goes_first():
    v, _, _ = blow(spread_one_by_one, WEDGE, (1.0, 0.0))
    assert v[0] == pytest.approx([-0.125, -sqrt(3.0) / 8.0], abs=1e-14)
    assert (np.hypot(*v[1]), np.hypot(*v[2])) == pytest.approx((sqrt(0.75), sqrt(0.1875)))


@pytest.mark.parametrize("e", [1.0, 0.95, 0.6])
def test_a_line_of_balls(e):
    line = [(k * GAP, 0.0) for k in range(5)]
    at_once, _, _ = blow(spread_at_once, line, (1.0, 0.0), Contact(e, 0.0))
    assert at_once[0, 0] == pytest.approx(1.0 - 0.8 * (1.0 + e), abs=1e-12)
    assert at_once[1:, 0] == pytest.approx([0.2 * (1.0 + e)] * 4, abs=1e-12)
    handed, _, _ = blow(spread_one_by_one, line, (1.0, 0.0), Contact(e, 0.0))
    assert handed[-1, 0] == pytest.approx(((1.0 + e) / 2.0) ** 4, abs=1e-12)


@pytest.mark.parametrize("spread", BOTH)
@pytest.mark.parametrize("contact", [IDEAL, Contact(0.95, 0.06), Contact(0.5, 0.3)])
def test_momentum_is_exact_and_energy_never_gained(spread, contact):
    rng = np.random.default_rng(1)
    for _ in range(10):
        spin = rng.uniform(-150.0, 150.0, (16, 3))
        v, before, after = blow(spread, RACK, (8.0, rng.uniform(-1.0, 1.0)), contact, spin)
        assert after[1] == pytest.approx(before[1], abs=1e-14)
        assert after[0] <= before[0] * (1.0 + 1e-13)
        for (x, y), (vx, vy) in zip(RACK[1:], v[1:], strict=True):
            nearing = (v[0, 0] - vx) * x + (v[0, 1] - vy) * y
            assert hypot(x, y) > GAP + 1e-6 or nearing <= state.SOFT * GAP + 1e-12


@pytest.mark.parametrize("spread", BOTH)
def test_labels_do_not_matter(spread):
    first, _, _ = blow(spread, RACK, (8.0, 0.3), Contact(0.95, 0.06))
    for seed in range(3):
        order = np.random.default_rng(seed).permutation(16)
        other, _, _ = blow(spread, RACK, (8.0, 0.3), Contact(0.95, 0.06), order=order)
        assert other == pytest.approx(first, abs=1e-9)


def test_at_once_a_mirrored_rack_stays_mirrored():
    v, _, _ = blow(spread_at_once, RACK, (8.0, 0.0))
    assert v[0, 1] == pytest.approx(0.0, abs=1e-12)
    for (x, y), velocity in zip(RACK, v, strict=True):
        twin = next(k for k, (u, w) in enumerate(RACK) if hypot(u - x, w + y) < 1e-9)
        assert v[twin] == pytest.approx(velocity * [1.0, -1.0], abs=1e-12)


@pytest.mark.parametrize("cluster", ["simultaneous", "sequential"])
def test_a_whole_shot_names_every_contact_once(cluster):
    world = open_world(3, contact=IDEAL, cluster=cluster)
    layout = {f"b{k}": (x + 0.1, y) for k, (x, y) in enumerate(WEDGE)}
    layout["b0"] = (-0.2, 0.0)
    trace = throw(world, layout, {"b0": ((1.0, 0.0), (0.0, 0.0, 0.0))})
    hits = [event for event in trace.events() if isinstance(event, BallsCollided)]
    first = {frozenset((hit.ball, hit.other)) for hit in hits if hit.time == hits[0].time}
    assert {frozenset(("b0", "b1")), frozenset(("b0", "b2"))} <= first
