"""Nasty moments on the cloth, rows 23 to 30: each test's first line is what must happen."""

from dataclasses import replace
from math import inf

import numpy as np
import pytest
from physics_cases import R, make_world, open_world, throw

from engine.physics import state
from engine.physics.events import BallsCollided, BallStopped, RollingBegan
from engine.physics.simulate import simulate
from engine.physics.world import Ball, Cloth, Contact, Strike

HOME = {"b0": (0.0, 0.0)}
SLIDING, ROLLING = 0.2 * 9.81, 0.01 * 9.81


def told(trace, kind):
    return [e for e in trace.events() if isinstance(e, kind)]


def test_23_a_draw_that_dies_with_its_slip_goes_straight_to_rest():
    """Speed and spin end at once: rest, and no roll in a direction of chance."""
    trace = throw(open_world(1), HOME, {"b0": ((1.0, 0.0), (0.0, -2.5 / R, 0.0))})
    assert [type(e) for e in trace.events()] == [BallStopped]
    assert trace.duration == pytest.approx(1.0 / SLIDING, abs=1e-12)
    assert trace.final["b0"] == pytest.approx((0.5 / SLIDING, 0.0), abs=1e-12)


def test_24_nothing_happens_where_a_draw_shot_turns_round():
    """Speed passes through zero while slipping: no event, and a ball behind is found."""
    draw = {"b0": ((1.0, 0.0), (0.0, -6.0 / R, 0.0))}
    alone = throw(open_world(2), HOME, draw)
    assert [type(e) for e in alone.events()] == [RollingBegan, BallStopped]
    turn = 1.0 / SLIDING
    assert alone.velocities([turn])[0, 0] == pytest.approx([0.0, 0.0, 0.0], abs=1e-12)
    behind = throw(open_world(2), {**HOME, "b1": (-0.1, 0.0)}, draw)
    assert told(behind, BallsCollided)[0].time > turn


@pytest.mark.parametrize("speed", [1e-9, 1e-8, 1e-6, 1e-4])
def test_25_the_slowest_ball_stops_where_it_should(speed):
    """Speeds of nanometres a second: few lawful events in order, v^2 / (2 mu g) far."""
    trace = throw(open_world(1), HOME, {"b0": ((speed, 0.0), (0.0, speed / R, 0.0))})
    times = [e.time for e in trace.events()]
    assert times == sorted(times)
    assert len(trace.log) <= 3
    assert trace.final["b0"][0] <= speed**2 / (2 * ROLLING) * (1.0 + 1e-6)
    if speed > 1e-8:
        assert trace.final["b0"][0] == pytest.approx(speed**2 / (2 * ROLLING), rel=1e-6)


@pytest.mark.parametrize("off", [0.0, 1e-16, -1e-16, 1e-13, -1e-13])
def test_26_a_slip_of_rounding_is_rolling(off):
    """Spin of v / R but for the last bit: rolls at once, with no sliding piece."""
    trace = throw(open_world(1), HOME, {"b0": ((0.7, 0.3), (-0.3 / R, 0.7 / R * (1 + off), 0.0))})
    kinds = trace.pieces[:, state.P_KIND].tolist()
    assert kinds == [state.ROLL, state.REST]


@pytest.mark.parametrize("turn", [0.0, 0.4 / R])
def test_27_side_spin_ends_within_a_slide_and_moves_no_ball(turn):
    """Side spin that ceases is no event for the place; rest waits for it."""
    v, w = (1.5, 0.2), (0.0, turn, 0.0)
    plain = throw(open_world(1), HOME, {"b0": (v, w)})
    times = np.linspace(0.0, plain.duration, 50)
    for side in (0.5, -3.0, 40.0):
        spun = throw(open_world(1), HOME, {"b0": (v, (0.0, turn, side))})
        assert (spun.positions(times) == plain.positions(times)).all()
        assert (np.abs(spun.spins(times)[:, 0, 2]) <= abs(side)).all()
    slow = throw(open_world(1), HOME, {"b0": ((0.1, 0.0), (0.0, 0.1 / R, 50.0))})
    stopped = told(slow, BallStopped)
    assert [e.time for e in stopped] == [pytest.approx(5.0, abs=1e-12)]
    assert slow.final["b0"][0] == pytest.approx(0.01 / (2 * ROLLING), abs=1e-12)


@pytest.mark.parametrize(
    ("part", "value"),
    [
        ("cloth", Cloth(0.0, 0.01, 10.0)),
        ("cloth", Cloth(0.2, 0.0, 10.0)),
        ("contact", Contact(1.01, 0.0)),
        ("contact", Contact(-0.1, 0.0)),
        ("balls", (Ball("b0", -R, 0.17),)),
        ("balls", (Ball("b0", R, 0.0),)),
        ("balls", (Ball("b0", float("nan"), 0.17),)),
    ],
)
def test_28_numbers_that_cannot_be_are_refused_before_the_first_event(part, value):
    """No friction, restitution above one, a radius below zero: an error, not a shot without end."""
    world = replace(make_world(1), **{part: value})
    with pytest.raises(ValueError, match=r"above zero|restitution"):
        simulate(world, HOME, "b0", Strike(1.0, 0.0))


def test_29_a_shot_of_minutes_keeps_its_digits():
    """Ten metres a second on a fast cloth for 220 s: places and a late meeting as by formula."""
    slow = 0.0045 * 9.81
    world = make_world(2, size=(3000.0, 10.0), cloth=Cloth(0.2, 0.0045, 10.0))
    start, roll = (-1400.0, 0.0), ((10.0, 0.0), (0.0, 10.0 / R, 0.0))
    trace = throw(world, {"b0": start}, {"b0": roll})
    assert trace.duration == pytest.approx(10.0 / slow, rel=1e-12)
    assert trace.final["b0"][0] + 1400.0 == pytest.approx(50.0 / slow, rel=1e-12)
    met = throw(world, {"b0": start, "b1": (-400.0, R)}, {"b0": roll})
    way = 1000.0 - np.sqrt(3.0) * R
    when = (10.0 - np.sqrt(100.0 - 2.0 * slow * way)) / slow
    assert told(met, BallsCollided)[0].time == pytest.approx(when, abs=1e-9)


def test_30_two_changes_at_one_instant_both_happen():
    """A shot symmetric about the middle: both balls start to roll at the same time."""
    start = {"b0": (-0.5, 0.0), "b1": (0.5, 0.0)}
    shove = {"b0": ((0.9, 0.0), (0.0, 0.0, 0.0)), "b1": ((-0.9, 0.0), (0.0, 0.0, 0.0))}
    trace = throw(make_world(2), start, shove, inf)
    began = told(trace, RollingBegan)
    assert [e.ball for e in began[:2]] == ["b0", "b1"]
    assert began[0].time == began[1].time
    assert trace.final["b0"][0] == -trace.final["b1"][0]
