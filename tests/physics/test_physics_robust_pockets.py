"""Nasty moments at pockets, rows 31 to 35: each test's first line is what must happen."""

from dataclasses import replace
from math import acos, cos, degrees, sin, sqrt

import numpy as np
import pytest
from physics_cases import R, make_world, throw

from engine.physics.events import BallPocketed, BallsCollided
from engine.physics.lip import leaving_angle
from engine.physics.simulate import simulate
from engine.physics.world import Strike
from engine.table.furniture import Pocket

ROLLING = 0.01 * 9.81
HOLE = (0.5, 0.0)
SIZE = 0.05


def holed(n=2, size=SIZE, **models):
    """A table whose bed has one round hole."""
    world = make_world(n, flight="none", **models)
    x, y = HOLE
    hole = Pocket("hole", HOLE, size, ((x - size, y), (x + size, y)))
    return replace(world, table=replace(world.table, pockets=(hole,)))


def rolls(speed):
    return {"b0": ((speed, 0.0), (0.0, speed / R, 0.0))}


@pytest.mark.parametrize(("past", "falls"), [(1e-9, True), (-1e-9, False), (1e-7, True)])
def test_31_a_ball_that_stops_at_the_edge_falls_inside_and_stays_outside(past, falls):
    """A nanometre decides, and decides alike each time."""
    far = HOLE[0] - SIZE + past
    speed = sqrt(2.0 * ROLLING * far)
    seen = {throw(holed(), {"b0": (0.0, 0.0)}, rolls(speed)).hash() for _ in range(3)}
    trace = throw(holed(), {"b0": (0.0, 0.0)}, rolls(speed))
    assert len(seen) == 1
    assert bool(trace.pocketed) == falls
    if not falls:
        assert trace.final["b0"][0] == pytest.approx(far, abs=1e-12)


def test_32_a_slow_roll_leaves_the_lip_at_54_degrees_a_fast_one_at_once():
    """The lip is left at cos(psi) = 10/17, and from sqrt(g rho) on at the edge itself."""
    assert degrees(leaving_angle(1e-6, 9.81, R)) == pytest.approx(degrees(acos(10 / 17)), abs=1e-3)
    assert leaving_angle(sqrt(9.81 * R) * 1.0001, 9.81, R) == 0.0
    for model in ("drop-edge", "rim-lip"):
        trace = throw(holed(pocket=model), {"b0": (0.2, 0.0)}, rolls(0.5))
        (fell,) = [e for e in trace.events() if isinstance(e, BallPocketed)]
        edge = (0.5 - sqrt(0.25 - 2.0 * ROLLING * 0.25)) / ROLLING
        assert fell.time == pytest.approx(edge, abs=1e-12 if model == "drop-edge" else 0.5)
        assert fell.time >= edge - 1e-12


@pytest.mark.parametrize(("inside", "falls"), [(1e-6, True), (1e-9, True), (-1e-9, False)])
def test_33_a_fast_ball_that_clips_the_circle_within_one_piece_is_taken(inside, falls):
    """Entered and left between two events: taken where it enters; one that only touches is not."""
    start = {"b0": (0.0, HOLE[1] + SIZE - inside)}
    trace = throw(holed(), start, rolls(6.0), until=0.15)
    fell = [e for e in trace.events() if isinstance(e, BallPocketed)]
    assert bool(fell) == falls
    if falls:
        at = trace.positions([fell[0].time])[0, 0]
        assert np.hypot(at[0] - HOLE[0], at[1] - HOLE[1]) == pytest.approx(SIZE, abs=1e-9)
        assert at[0] <= HOLE[0]


def test_34_a_ball_on_the_lip_is_hit_and_then_falls():
    """An ordinary meeting first, the pocket afterwards."""
    start = {"b0": (0.0, 0.0), "b1": (HOLE[0] - SIZE - 1e-6, 0.0)}
    trace = simulate(holed(), start, "b0", Strike(1.0, 0.0))
    events = [e for e in trace.events() if isinstance(e, (BallsCollided, BallPocketed))]
    assert [type(e) for e in events[:2]] == [BallsCollided, BallPocketed]
    assert events[1].ball == "b1"
    assert events[0].time < events[1].time


@pytest.mark.parametrize("names", [("b0", "b1"), ("b1", "b0")])
def test_35_at_one_instant_the_drop_comes_before_the_meeting(names):
    """A ball over the edge that touches another just then is gone: the other does not move."""
    one, two = names
    size, turn = 0.03125, 1.0  # in binary without rounding
    x = HOLE[0] - size
    other = (x + 2 * R * cos(turn), 2 * R * sin(turn))
    world = holed(size=size)
    trace = throw(world, {one: (x, 0.0), two: other}, {one: rolls(1.0)["b0"]})
    assert [type(e) for e in trace.events()] == [BallPocketed]
    assert trace.events()[0].time == 0.0
    assert trace.final == {two: other}
