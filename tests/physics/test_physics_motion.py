"""Cloth: the closed forms A01 to A15, one ball on a bed without an end."""

import numpy as np
import pytest
from physics_cases import M, R, open_world, throw

from engine.physics.events import BallStopped, RollingBegan
from engine.physics.world import Cloth


def thrown(v, w, cloth=None):
    world = open_world(1, cloth=cloth or Cloth(0.2, 0.01, 10.0))
    return throw(world, {"b0": (0.0, 0.0)}, {"b0": (v, w)})


def rolling_start(trace):
    return next(e.time for e in trace.events() if isinstance(e, RollingBegan))


@pytest.mark.parametrize(
    ("v0", "rw", "slide", "distance", "rolling", "lost"),
    [
        (2.0, 0.0, 0.291248, 0.49928228, 1.4285714, 0.097198286),
        (2.0, -2.0, 0.582496, 0.83213714, 0.85714286, 0.38879314),
        (2.0, 1.0, 0.145624, 0.27044457, 1.7142857, 0.024299571),
        (1.0, -3.0, 0.582496, 0.24964114, -0.14285714, 0.38879314),
    ],
)
def test_slide_to_roll(v0, rw, slide, distance, rolling, lost):
    trace = thrown((v0, 0.0), (0.0, rw / R, 0.0))
    t = rolling_start(trace)
    assert t == pytest.approx(slide, rel=1e-6)
    assert t == pytest.approx(2.0 * abs(v0 - rw) / (7.0 * 0.2 * 9.81), rel=1e-12)
    assert trace.positions([t])[0, 0, 0] == pytest.approx(distance, rel=1e-7)
    assert trace.velocities([t])[0, 0, 0] == pytest.approx(rolling, rel=1e-7)
    energy = trace.kinetic_energy([0.0, t])
    assert energy[0] - energy[1] == pytest.approx(lost, rel=1e-7)
    assert energy[0] - energy[1] == pytest.approx(M * (v0 - rw) ** 2 / 7.0, rel=1e-12)


def test_dead_stop_never_rolls():
    trace = thrown((1.5, 0.0), (0.0, -3.75 / R, 0.0))
    (event,) = trace.events()
    assert isinstance(event, BallStopped)
    assert event.time == pytest.approx(0.76452599, rel=1e-8)
    assert trace.final["b0"][0] == pytest.approx(0.5733945, rel=1e-8)


def test_natural_roll_does_not_slide():
    trace = thrown((1.0, 0.0), (0.0, 1.0 / R, 0.0))
    assert [type(e) for e in trace.events()] == [BallStopped]
    assert trace.duration == pytest.approx(10.19368, rel=1e-7)
    assert trace.final["b0"][0] == pytest.approx(5.09684, rel=1e-7)


def test_spin_in_place_and_its_angle():
    trace = thrown((0.0, 0.0), (0.0, 0.0, 20.0))
    assert trace.duration == pytest.approx(2.0, rel=1e-12)
    assert trace.spins([1.0])[0, 0, 2] == pytest.approx(10.0, rel=1e-12)
    turn = trace.orientations([trace.duration])[0, 0]
    assert np.arctan2(turn[1, 0], turn[0, 0]) == pytest.approx(20.0 - 6 * np.pi, abs=1e-9)


def test_side_spin_outlives_rolling():
    trace = thrown((0.2, 0.0), (0.0, 0.2 / R, 40.0))
    assert trace.duration == pytest.approx(4.0, rel=1e-12)
    assert trace.spins([2.038736])[0, 0, 2] == pytest.approx(19.61264, rel=1e-6)
    assert trace.final["b0"][0] == pytest.approx(0.2038736, rel=1e-7)


@pytest.mark.parametrize(
    ("mu", "t_roll", "place"),
    [
        (0.1, 0.51171994, (0.39683881, 0.19841941)),
        (0.2, 0.25585997, (0.19841941, 0.099209703)),
        (0.4, 0.12792998, (0.099209703, 0.049604852)),
    ],
)
def test_masse_ends_in_the_same_roll_on_any_cloth(mu, t_roll, place):
    trace = thrown((1.0, 0.5), (10.0, -20.0, 5.0), Cloth(mu, 0.01, 10.0))
    t = rolling_start(trace)
    assert t == pytest.approx(t_roll, rel=1e-7)
    assert trace.velocities([t])[0, 0, :2] == pytest.approx((0.551, 0.2755), abs=1e-12)
    assert trace.positions([t])[0, 0, :2] == pytest.approx(place, abs=1e-8)


def test_lag_speed():
    trace = thrown((0.70593767, 0.0), (0.0, 0.70593767 / R, 0.0))
    assert trace.duration == pytest.approx(7.1961027, rel=1e-7)
    assert trace.final["b0"][0] == pytest.approx(2.54, rel=1e-7)


def test_draw_fades_to_stun():
    trace = thrown((2.0, 0.0), (0.0, -1.0 / R, 0.0))
    assert trace.spins([0.2038736])[0, 0, 1] == pytest.approx(0.0, abs=1e-5)
    assert trace.positions([0.2038736])[0, 0, 0] == pytest.approx(0.36697248, rel=1e-7)
    assert trace.velocities([0.2038736])[0, 0, 0] == pytest.approx(1.6, rel=1e-7)


def test_rolling_turns_the_ball_by_its_way():
    trace = thrown((0.5, 0.0), (0.0, 0.5 / R, 0.0))
    times = np.linspace(0.0, trace.duration, 7)
    turned = trace.orientations(times)[:, 0]
    for x, turn in zip(trace.positions(times)[:, 0, 0], turned, strict=True):
        angle = x / R
        assert turn[0, 0] == pytest.approx(np.cos(angle), abs=1e-9)
        assert turn[0, 2] == pytest.approx(np.sin(angle), abs=1e-9)
        assert turn @ turn.T == pytest.approx(np.eye(3), abs=1e-12)


def test_orientations_follow_a_masse_spin():
    """Against a plain fine integration of dR/dt = w x R."""
    trace = thrown((1.0, 0.5), (40.0, -20.0, 25.0))
    steps = 20000
    times = np.linspace(0.0, 0.6, steps + 1)
    middles = trace.spins(0.5 * (times[1:] + times[:-1]))[:, 0]
    turn = np.eye(3)
    h = times[1]
    for w in middles:
        angle = np.linalg.norm(w) * h
        k = np.cross(np.eye(3), w / np.linalg.norm(w))
        turn = (np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k) @ turn
    assert trace.orientations([0.6])[0, 0] == pytest.approx(turn, abs=1e-5)


def test_two_speed_model_of_the_report():
    """Full friction above 1.5 m/s, a hundredth below: from 1 m/s it rolls for 10.19 s."""
    world = open_world(1, motion="two-speed")
    trace = throw(world, {"b0": (0.0, 0.0)}, {"b0": ((1.0, 0.0), (0.0, 0.0, 0.0))})
    assert trace.duration == pytest.approx(10.19368, rel=1e-6)
    trace = throw(world, {"b0": (0.0, 0.0)}, {"b0": ((3.0, 0.0), (0.0, 0.0, 0.0))})
    fast = 1.5 / (0.2 * 9.81)
    assert rolling_start(trace) == pytest.approx(fast, rel=1e-9)
    assert trace.duration == pytest.approx(fast + 1.5 / 0.0981, rel=1e-9)
    assert trace.velocities([fast / 2])[0, 0, 0] == pytest.approx(2.25, rel=1e-9)
