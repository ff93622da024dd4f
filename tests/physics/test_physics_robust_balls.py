"""Nasty meetings of balls, rows 1 to 10: each test's first line is what must happen."""

from math import sqrt

import numpy as np
import pytest
from physics_cases import ALCIATORE, IDEAL, R, make_world, open_world, rack, throw, watch

from engine.physics.events import BallsCollided
from engine.physics.monitor import examine
from engine.physics.simulate import simulate
from engine.physics.world import Cloth, Strike

STILL = ((0.0, 0.0), (0.0, 0.0, 0.0))
SLICK = Cloth(1e-9, 1e-10, 1e-6)
"""A cloth so smooth that blows alone change speeds."""


def rolling(speed, way=0.0):
    vx, vy = speed * np.cos(way), speed * np.sin(way)
    return (vx, vy), (-vy / R, vx / R, 0.0)


def hits(trace):
    return [e for e in trace.events() if isinstance(e, BallsCollided)]


@pytest.mark.parametrize("tilt", [0.0, 1e-15, 1e-14, 1e-10, 1e-6])
@pytest.mark.parametrize("slide", [False, True])
def test_01_balls_along_one_line_meet_when_and_only_when_they_must(tilt, slide):
    """Rolling along one line, no relative acceleration: met on time, no meeting invented."""
    far = 0.08 if slide else 0.3
    world, start = open_world(2), {"b0": (0.0, 0.0), "b1": (far, 0.0)}
    fast, slow = rolling(1.0), rolling(0.5, tilt)
    if slide:
        fast, slow = (fast[0], (0.0, 0.0, 0.0)), (slow[0], (0.0, 0.0, 0.0))
    met = hits(throw(world, start, {"b0": fast, "b1": slow}))
    assert met[0].time == pytest.approx((far - 2 * R) / 0.5, abs=1e-9 + tilt)
    assert not hits(throw(world, start, {"b0": slow, "b1": fast}))


def test_01_a_straight_follow_shot_hits_once():
    """The second ball starts to roll on the first's line: that is no meeting."""
    world = open_world(2)
    trace = simulate(world, {"b0": (-0.5, 0.0), "b1": (0.3, 0.0)}, "b0", Strike(1.5, 0.0))
    assert len(hits(trace)) == 1
    watch(trace, size=(200.0, 200.0))


def test_02_a_pair_just_parted_does_not_meet_again_until_it_does():
    """Gap zero and separating is no contact; the first true return is found."""
    world, start = open_world(2), {"b0": (0.0, 0.0), "b1": (0.06, 0.0)}
    over = ((1.0, 0.0), (0.0, 10.0 / R, 0.0))
    first, second, *_ = hits(throw(world, start, {"b0": over}))
    assert second.time - first.time > 0.05
    assert second.speed < first.speed
    part = throw(world, start, {"b0": over}, until=first.time + 1e-3)
    assert len(part.log) < 6
    alone = throw(world, start, {"b0": ((1.0, 0.0), (0.0, 1.0 / R, 0.0))})
    assert len(hits(alone)) == 1


@pytest.mark.parametrize("gap", [0.0, 1e-12, -1e-12, 1e-15, -1e-15])
def test_03_a_ball_shot_into_one_it_touches_hits_at_once(gap):
    """Touching and closing at the start: the event is at time zero, not missed."""
    start = {"b0": (0.1, 0.2), "b1": (0.1 + 2 * R + gap, 0.2)}
    trace = simulate(make_world(2), start, "b0", Strike(2.0, 0.0))
    assert hits(trace)[0].time <= 1e-11
    assert trace.velocities([1e-6])[0, 1, 0] > 2.0
    watch(trace)


@pytest.mark.parametrize("turn", [1.0, 10.0, 80.0])
def test_04_a_ball_pressed_into_another_pushes_it_and_does_not_sink_in(turn):
    """Touching without speed and pressed together by top spin: they move on as one contact."""
    start = {"b0": (0.0, 0.0), "b1": (2 * R, 0.0)}
    trace = throw(make_world(2), start, {"b0": ((0.0, 0.0), (0.0, turn, 0.0))})
    watch(trace)
    assert trace.final["b1"][0] > 2 * R
    assert len(trace.log) < 3000


@pytest.mark.parametrize("miss", [1e-6, 1e-8, 1e-10, 1e-12])
def test_05_a_graze_is_decided_by_the_smallest_gap(miss):
    """A closest approach of 2R and a nothing: the same answer each time, and no overlap."""
    seen = []
    for sign in (1.0, -1.0):
        start = {"b0": (-0.5, 0.0), "b1": (0.3, 2 * R + sign * miss)}
        traces = [throw(make_world(2), start, {"b0": rolling(1.0)}, until=2.0) for _ in range(2)]
        assert traces[0].hash() == traces[1].hash()
        watch(traces[0])
        seen.append(len(hits(traces[0])))
    if miss >= 1e-10:
        assert seen == [0, 1]


@pytest.mark.parametrize("gap", [0.0, 1e-9, 1e-6, 1e-4])
def test_06_balls_of_nearly_one_speed_make_no_storm_and_lose_no_momentum(gap):
    """A chain after a head-on train: finite events, momentum exact, no theft."""
    pitch = 2 * R + gap
    start = {f"b{k}": (k * pitch, 0.0) for k in range(6)}
    speeds = [1.0, 0.9999, 0.9999, 0.99989, 0.5, 0.4999]
    world = open_world(6, cloth=SLICK)
    trace = throw(world, start, {f"b{k}": rolling(v) for k, v in enumerate(speeds)}, until=5.0)
    momentum = trace.velocities([0.0, 5.0])[..., 0].sum(-1)
    assert momentum[1] == pytest.approx(momentum[0], abs=1e-7)
    assert examine(trace, world).momentum < 1e-14
    assert len(trace.log) < 3000


def test_06_balls_that_roll_side_by_side_touching_never_collide():
    """No relative motion is no event."""
    start = {"b0": (0.0, 0.0), "b1": (0.0, 2 * R)}
    trace = throw(open_world(2), start, {"b0": rolling(0.7), "b1": rolling(0.7)})
    assert not hits(trace)
    assert trace.final["b0"][0] == trace.final["b1"][0]


def test_07_a_cradle_with_gaps_hands_on_its_speed_ball_by_ball():
    """Sequential blows: the last ball of five leaves with ((1 + e) / 2)^4 of the speed."""
    start = {f"b{k}": (k * (2 * R + 1e-3), 0.0) for k in range(5)}
    world = open_world(5, cloth=SLICK)
    trace = throw(world, start, {"b0": ((1.0, 0.0), (0.0, 0.0, 0.0))}, until=0.02)
    last = trace.velocities([trace.log[3, 1] + 1e-9])[0, 4, 0]
    assert last == pytest.approx(0.975**4, abs=1e-7)
    assert [e.other for e in hits(trace)[:4]] == ["b1", "b2", "b3", "b4"]


def test_07_a_frozen_line_does_not_depend_on_names():
    """One compliant blow runs through the line: momentum exact, the last ball leads."""
    ends = []
    for names in (["b0", "b1", "b2", "b3", "b4"], ["b4", "b2", "b0", "b1", "b3"]):
        start = {name: (k * 2 * R, 0.0) for k, name in enumerate(names)}
        world = open_world(5, cloth=SLICK, contact=IDEAL)
        trace = throw(world, start, {names[0]: ((1.0, 0.0), (0.0, 0.0, 0.0))}, until=1e-6)
        order = [int(name[1]) for name in names]
        ends.append(trace.velocities([1e-6])[0, order, 0])
    assert ends[0] == pytest.approx(ends[1], abs=1e-9)
    assert ends[0].sum() == pytest.approx(1.0, abs=1e-8)
    assert ends[0][4] > 0.9
    assert (np.diff(ends[0]) > 0.0).all()


def test_08_two_frozen_balls_struck_in_the_middle_part_alike():
    """Smooth and elastic: both 0.6928 of the speed, the cue ball -0.2, whatever the names."""
    high, low = (sqrt(3.0) * R, R), (sqrt(3.0) * R, -R)
    for one, two in (("b1", "b2"), ("b2", "b1")):
        start = {"b0": (0.0, 0.0), one: high, two: low}
        world = open_world(3, cloth=SLICK, contact=IDEAL)
        trace = throw(world, start, {"b0": ((1.0, 0.0), (0.0, 0.0, 0.0))}, until=1e-6)
        v = trace.velocities([1e-6])[0]
        assert v[0, :2] == pytest.approx([-0.2, 0.0], abs=2e-3)
        assert np.hypot(*v[1, :2]) == pytest.approx(0.6928, abs=1e-3)
        assert np.hypot(*v[1, :2]) == pytest.approx(np.hypot(*v[2, :2]), abs=1e-9)


@pytest.mark.parametrize("contact", [ALCIATORE, IDEAL])
def test_09_a_frozen_rack_opens_symmetrically_and_in_bounded_work(contact):
    """Fifteen balls without gaps: mirrored halves, few events, no energy out of nothing."""
    start = {"b0": (-0.5, 0.0), **{f"b{k + 1}": p for k, p in enumerate(rack(0.5))}}
    world = make_world(16, contact=contact)
    trace = simulate(world, start, "b0", Strike(7.0, 0.0))
    watch(trace)
    when = hits(trace)[0].time + 1e-4
    v = trace.velocities([when])[0, :, :2]
    for row in v:
        assert np.abs(v * [1, -1] - row).max(-1).min() < 1e-9
    assert len(trace.log) < 2000


@pytest.mark.parametrize("seed", range(8))
def test_09_a_rack_with_random_gaps_is_sound(seed):
    """Gaps of none to 57 micrometres, each its own: blows one after the other and together."""
    rng = np.random.default_rng(seed)
    places = rack(0.5, 5.7e-5) + rng.uniform(-1.4e-5, 1.4e-5, (15, 2))
    start = {"b0": (-0.5, 0.0), **{f"b{k + 1}": tuple(p) for k, p in enumerate(places)}}
    trace = simulate(make_world(16), start, "b0", Strike(8.0, rng.uniform(-0.01, 0.01)))
    watch(trace)
    assert len(trace.log) < 3000


def test_10_pairs_that_meet_at_one_instant_do_not_disturb_each_other():
    """Two disjoint meetings at the same time: each as if it were alone, to the bit."""
    one, two = {"b0": (0.0, 0.25), "b1": (0.3, 0.25)}, {"b2": (0.0, -0.25), "b3": (0.3, -0.25)}
    world, shove = make_world(4), ((1.0, 0.0), (0.0, 0.0, 0.0))
    both = throw(world, {**one, **two}, {"b0": shove, "b2": shove}, until=0.6)
    alone = throw(world, one, {"b0": shove}, until=0.6)
    times = np.linspace(0.0, 0.6, 61)
    assert (both.positions(times)[:, :2] == alone.positions(times)).all()
    first, second = hits(both)[:2]
    assert first.time == second.time
