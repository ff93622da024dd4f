"""The compliant nose model against its published figures and a plain integration in time."""

from math import hypot, pi, radians, sin

import numpy as np
import pytest
from physics_cases import M, R, make_world

from engine.physics import state
from engine.physics.pack import pack_rubber, pack_world
from engine.physics.rare import rebound
from engine.physics.stronge import ACROSS, slip_after
from engine.physics.world import Rubber

PUBLISHED = {
    0.05: -0.0119993130329,
    0.1: -0.0302943272932,
    0.2: -0.0821651487596,
    0.5: -0.329114283276,
    0.8: -0.381068244442,
    1.0: -0.19,
    1.5: 0.31,
    3.0: 1.81,
}
"""Slip after by slip before: v_n = 1 m/s, mu = 0.2, e = 0.7, springs of ratio 1.7."""


@pytest.mark.parametrize(("slip", "after"), PUBLISHED.items())
def test_published_slips(slip, after):
    assert slip_after(slip, 1.0, 0.7, 0.2, 1.7) == pytest.approx(after, abs=1e-12)
    assert slip_after(-slip, 1.0, 0.7, 0.2, 1.7) == pytest.approx(-after, abs=1e-12)
    assert slip_after(3.0 * slip, 3.0, 0.7, 0.2, 1.7) == pytest.approx(3.0 * after, abs=1e-11)


def integrated(slip, e, mu, ratio, steps=40_000):
    """The same by small steps: a spring across whose force friction bounds."""
    h = 0.5 * pi * (1.0 + e) / steps
    v, y = slip, 0.0
    for k in range(steps):
        t = (k + 0.5) * h
        force = sin(t) if t <= pi / 2 else sin(t / e + 0.5 * pi * (1.0 - 1.0 / e))
        most = ACROSS * mu * force / ratio**2
        y = min(max(y + h * v, -most), most)
        v -= h * ratio**2 * y
    return v


@pytest.mark.parametrize("seed", range(12))
def test_any_springs_and_frictions(seed):
    rng = np.random.default_rng(seed)
    slip, e = rng.uniform(0.0, 3.0), rng.uniform(0.2, 1.0)
    mu, ratio = rng.uniform(0.02, 0.6), rng.uniform(0.7, 2.5)
    expected = integrated(slip, e, mu, ratio)
    assert slip_after(slip, 1.0, e, mu, ratio) == pytest.approx(expected, abs=2e-4)


def test_a_glancing_hit_slips_all_the_time():
    got = slip_after(5.0, 1e-9, 0.9, 0.14, 1.7)
    assert got == pytest.approx(5.0 - ACROSS * 0.14 * 1.9e-9, rel=1e-15)


def test_no_bounce_and_no_friction():
    assert slip_after(0.4, 1.0, 0.0, 0.0, 1.7) == 0.4
    assert abs(slip_after(0.1, 1.0, 0.0, 0.5, 1.7)) < 0.1


def struck(world, v, w):
    row = np.zeros(state.BALL_WIDTH)
    row[[state.VX, state.VY]], row[[state.WX, state.WY, state.WZ]] = v, w
    row[state.RADIUS], row[state.MASS] = R, M
    row[state.REACH] = R * (1.0 - 0.27**2) ** 0.5
    rebound(row, pack_world(world), pack_rubber(world), 0.0, 1.0)
    return row


def energy(row):
    spin = row[[state.WX, state.WY, state.WZ]]
    return 0.5 * M * (row[state.VX] ** 2 + row[state.VY] ** 2) + 0.2 * M * R**2 * (spin @ spin)


def test_no_energy_is_gained_and_the_ball_comes_off():
    rng = np.random.default_rng(3)
    world = make_world(1, rubber=Rubber(0.97, 0.035, 1.0, 0.14), ball_cushion="stronge")
    for _ in range(500):
        v = (rng.uniform(-6.0, 6.0), rng.uniform(2e-3, 6.0))
        w = rng.uniform(-250.0, 250.0, 3)
        row, before = struck(world, v, w), np.zeros(state.BALL_WIDTH)
        before[[state.VX, state.VY]], before[[state.WX, state.WY, state.WZ]] = v, w
        assert energy(row) <= energy(before)
        assert row[state.VY] <= 0.0


def test_springs_throw_side_spin_back_further_than_friction_alone():
    """A ball that hits squarely with side spin leaves at a steeper angle than by Han's model."""
    rubber = Rubber(0.9, 0.0, 0.0, 0.4)
    out = {}
    for model in ("stronge", "han-2005"):
        world = make_world(1, rubber=rubber, ball_cushion=model)
        row = struck(world, (0.0, 1.0), (0.0, 0.0, -0.4 / R))
        out[model] = abs(row[state.VX]) / hypot(row[state.VX], row[state.VY])
    assert out["stronge"] > 1.05 * out["han-2005"] > 0.15 * sin(radians(10.0))


def test_springs_of_one_ratio_are_those_of_the_rubber():
    soft, stiff = (
        struck(
            make_world(
                1,
                rubber=Rubber(0.9, 0.0, 0.0, 0.4, frequency_ratio=ratio),
                ball_cushion="stronge",
            ),
            (0.3, 1.0),
            (0.0, 0.0, 0.0),
        )
        for ratio in (1.1, 2.2)
    )
    assert abs(soft[state.VX] - stiff[state.VX]) > 0.01
