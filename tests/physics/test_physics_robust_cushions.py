"""Nasty places at cushions and jaws, rows 13 to 22: each test's first line is what must happen."""

from dataclasses import replace
from itertools import pairwise
from math import asin, cos, pi, sqrt

import numpy as np
import pytest
from physics_cases import REACH, ROUND, TIGHT, R, make_world, throw, watch

from engine.physics.events import BallsCollided, CushionHit, JawHit
from engine.physics.monitor import examine
from engine.physics.simulate import simulate
from engine.physics.world import Rubber, Strike

MODELS = ("han-2005", "restitution", "mathavan-2010")
EDGE = 0.635 - REACH


def rail_hits(trace):
    return [e for e in trace.events() if isinstance(e, CushionHit)]


def off_the_rail(model, rubber, v, w):
    """Velocity and spin just after a ball that touches the left cushion went into it."""
    world = make_world(1, ball_cushion=model, rubber=rubber)
    trace = throw(world, {"b0": (0.0, EDGE)}, {"b0": (v, w)}, until=1e-7)
    at = trace.pieces[-1, 1]
    return np.concatenate([trace.velocities([at])[0, 0, :2], R * trace.spins([at])[0, 0]])


@pytest.mark.parametrize(("high", "short"), [(1.27, 1.06e-3), (1.4, 2.39e-3), (1.2, 0.577e-3)])
def test_13_a_ball_meets_the_nose_at_less_than_its_radius(high, short):
    """The nose is above the centre: contact at R cos(theta), a millimetre or two nearer than R."""
    world = make_world(1, nose=high * R, size=(2.54, 1.27))
    trace = simulate(world, {"b0": (0.0, 0.0)}, "b0", Strike(2.0, 0.0))
    hit = rail_hits(trace)[0]
    x = trace.positions([hit.time])[0, 0, 0]
    assert 1.27 - x == pytest.approx(R * cos(asin(high - 1.0)), abs=1e-12)
    assert R - (1.27 - x) == pytest.approx(short, rel=0.01)


@pytest.mark.parametrize("aside", [0.0, 1e-16, -1e-16, 1e-12, -1e-12, 1e-7])
@pytest.mark.parametrize("speed", [0.8, 3.0, 9.0])
def test_14_a_ball_into_a_closed_corner_stays_inside(aside, speed):
    """Both cushions within an instant: both are met, and the centre is never outside."""
    trace = simulate(make_world(1), {"b0": (0.9, 0.265 + aside)}, "b0", Strike(speed, pi / 4))
    watch(trace)
    hits = rail_hits(trace)
    assert {hits[0].cushion, hits[1].cushion} == {"foot", "left"}
    assert hits[1].time - hits[0].time < 1e-6


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("turn", [0.0, -30.0, 30.0])
def test_15_a_ball_frozen_to_a_cushion_and_shot_along_it_makes_no_storm(model, turn):
    """No speed into the nose is no blow; spin that presses is a contact, not a chain of events."""
    world = make_world(1, ball_cushion=model)
    start = {"b0": (-0.5, EDGE)}
    trace = throw(world, start, {"b0": ((1.0, 0.0), (turn, 0.0, 0.0))}, until=0.5)
    watch(trace)
    assert len(trace.events()) < 12
    if turn == 0.0:
        assert trace.positions([0.5])[0, 0, 1] == EDGE


@pytest.mark.parametrize("model", MODELS)
def test_16_a_ball_frozen_to_a_cushion_and_hit_into_it_sends_the_other_back(model):
    """Ball, cushion, ball again at one moment: a finite sequence, and the cue ball comes back."""
    world = make_world(2, ball_cushion=model)
    start = {"b0": (0.0, 0.2), "b1": (0.0, EDGE)}
    trace = simulate(world, start, "b0", Strike(2.0, pi / 2))
    watch(trace)
    assert sum(hit.time < 0.2 for hit in rail_hits(trace)) < 10
    first = next(e for e in trace.events() if isinstance(e, BallsCollided))
    rail = rail_hits(trace)[0]
    assert rail.time == pytest.approx(first.time, abs=1e-9)
    assert trace.velocities([rail.time + 1e-3])[0, 0, 1] < -1.0


@pytest.mark.parametrize("over", [1.0, 3.0, 10.0])
def test_17_spin_drives_a_slow_ball_into_the_rail_ever_more_gently_and_it_ends(over):
    """Follow against the rail: each hit weaker than the last, then a contact that rests."""
    start = {"b0": (0.0, EDGE)}
    trace = throw(make_world(1), start, {"b0": ((0.0, 0.3), (-over * 0.3 / R, 0.0, 0.0))})
    watch(trace)
    speeds = [hit.speed for hit in rail_hits(trace)]
    assert 1 <= len(speeds) < 40
    real = [speed for speed in speeds if speed > 2e-3]
    assert all(later < earlier for earlier, later in pairwise(real))
    assert trace.kinetic_energy([trace.duration])[0] == 0.0


def joints(table):
    """Places of all ends of cushions and jaws."""
    from engine.physics.noses import _end, _start

    shapes = [s for c in table.cushions for s in c.shapes]
    shapes += [s for j in table.jaws for s in j.shapes]
    return sorted({tuple(np.round(f(s)[0], 12)) for s in shapes for f in (_start, _end)})


@pytest.mark.parametrize("aside", [0.0, 1e-9, -1e-9])
def test_18_no_ball_slips_between_a_cushion_and_a_jaw(aside):
    """Shot at every joint of noses and jaws: nothing gets through, no phantom turns it back."""
    world = make_world(1, pockets=True, flight="none")
    for x, y in joints(world.table):
        for start in ((0.0, 0.0), (-0.4, 0.3), (0.7, -0.35)):
            heading = np.arctan2(y - start[1], x - start[0]) + aside
            trace = simulate(world, {"b0": start}, "b0", Strike(4.0, float(heading)))
            assert examine(trace, world).faults() == ()
            assert len(trace.final) + len(trace.pocketed) == 1


@pytest.mark.parametrize("cuts", [TIGHT, ROUND])
@pytest.mark.parametrize("aside", np.linspace(-0.02, 0.02, 9))
def test_19_a_ball_in_a_narrow_jaw_rattles_a_finite_time(cuts, aside):
    """Jaws a few millimetres apart: every hit loses energy, it falls or comes out or rests."""
    world = make_world(1, pockets=True, cuts=cuts, ball_cushion="mathavan-2010")
    heading = np.arctan2(0.635, 1.27) + aside
    for speed in (0.6, 2.0, 6.0):
        trace = simulate(world, {"b0": (0.0, 0.0)}, "b0", Strike(speed, float(heading)))
        assert examine(trace, world).faults() == ()
        assert sum(isinstance(e, JawHit) for e in trace.events()) < 60


@pytest.mark.parametrize("friction", [0.14, 0.208, 0.3, 0.436, 0.9])
@pytest.mark.parametrize("high", [1.2, 1.27, 1.4])
def test_20_more_friction_than_the_plane_model_allows_pulls_no_ball_down(friction, high):
    """Beyond tan(theta) the bed's push would be negative: it is nothing then, and energy sinks."""
    world = make_world(1, ball_cushion="mathavan-2010", nose=high * R)
    world = replace(world, rubber=Rubber(0.9, 0.0, 0.0, friction))
    reach = R * sqrt(1.0 - (high - 1.0) ** 2)
    rng = np.random.default_rng(20)
    for _ in range(12):
        v, w = rng.uniform(-3, 3, 2), rng.uniform(-120, 120, 3)
        v[1] = abs(v[1]) + 0.05
        start = {"b0": (0.0, 0.635 - reach)}
        trace = throw(world, start, {"b0": (v, w)}, until=1e-7)
        assert examine(trace, world).faults() == ()
        after = trace.velocities([1e-7])[0, 0]
        assert -v[1] * 1.2 - 0.4 * R * np.linalg.norm(w) < after[1] <= 1e-9


@pytest.mark.parametrize("friction", [0.2, 0.4])
def test_21_friction_that_holds_the_ball_during_the_blow_does_not_chatter(friction):
    """Sticking in the impulse is a state of its own: twice the speed gives twice the answer."""
    rubber, rng = Rubber(0.9, 0.0, 0.0, friction), np.random.default_rng(21)
    for _ in range(15):
        v = np.array([rng.uniform(-0.5, 0.5), rng.uniform(0.5, 2.0)])
        w = np.array([-v[1] / R, v[0] / R, rng.uniform(-10.0, 10.0)])
        once = off_the_rail("mathavan-2010", rubber, v, w)
        twice = off_the_rail("mathavan-2010", rubber, 2.0 * v, 2.0 * w)
        assert twice == pytest.approx(2.0 * once, abs=2e-5)


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("into", [1e-12, 1e-9, 1e-6, 1e-4, 1e-3, 1e-2])
def test_22_a_glancing_touch_is_no_division_by_nothing(model, into):
    """Almost all speed along the cushion: finite, hardly slowed, and not shot away."""
    after = off_the_rail(model, Rubber(0.9, 0.0, 0.0, 0.2), (5.0, into), (0.0, 5.0 / R, 0.0))
    assert np.isfinite(after).all()
    assert after[0] == pytest.approx(5.0, abs=3.0 * into + 1e-4)
    assert abs(after[1]) <= max(1.1 * into, 1.1e-3)
