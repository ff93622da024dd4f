"""Nasty configurations off the bed: unequal balls, tiny lifts, endless bounces, stacks, rails."""

from functools import cache, partial
from itertools import pairwise
from math import atan2, cos, hypot, inf, pi, radians, sin, sqrt

import numpy as np
import physics_cases
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from physics_cases import ALCIATORE, CORNER, NOSE, SIDE, M, R, grounded, open_world

from engine.physics import state
from engine.physics.airborne import nose_in_air
from engine.physics.events import (
    BallJumpedOver,
    BallLanded,
    BallLeftBed,
    BallLeftTable,
    BallsCollided,
    BallStopped,
    CushionHit,
)
from engine.physics.impact import meet_ball, meet_bed
from engine.physics.monitor import examine
from engine.physics.pack import packed
from engine.physics.simulate import Simulation, simulate
from engine.physics.strike import Motion, strike_ball
from engine.physics.throw import throw_balls
from engine.physics.world import Ball, Cloth, Strike, World

G = 9.81
V, W = [state.VX, state.VY, state.VZ], [state.WX, state.WY, state.WZ]
REST = Motion((0.0, 0.0), (0.0, 0.0, 0.0))
make_world = cache(partial(physics_cases.make_world, cuts=(CORNER, SIDE)))


def told(trace, kind):
    return [event for event in trace.events() if isinstance(event, kind)]


def sound(trace, table=None):
    assert examine(trace, table).faults() == ()


def bedded(n=2, bounce=0.5):
    return open_world(n, cloth=Cloth(0.2, 0.01, 10.0, bounce=bounce))


def above_rail(world, place, motion, height):
    """A ball that begins above the top of the rail."""
    shot = Simulation(world, {"b0": (0.0, 0.0)}, "b0", Strike(0.0, 0.0))
    row = shot._rows[0]
    row[[state.X, state.Y]] = place
    row[state.Z] = world.table.nose_height + R + height
    row[V] = (*motion.velocity, motion.rise)
    row[W] = motion.spin
    shot._kinds[0] = state.FLY
    shot.advance(inf)
    return shot.trace()


# 11: unequal radii


def test_11_unequal_balls_meet_along_their_true_normal():
    numbers = packed(bedded()).numbers
    big, small = packed(bedded()).rows.copy()
    big[state.RADIUS], big[state.MASS], big[state.Z] = 0.04, 0.3, 0.04
    small[state.RADIUS], small[state.Z] = 0.025, 0.025
    small[state.X] = 2.0 * sqrt(0.04 * 0.025)
    big[state.VX] = 1.0
    n = np.array([small[state.X], 0.0, 0.025 - 0.04])
    n /= np.linalg.norm(n)
    assert np.linalg.norm([small[state.X], 0.015]) == pytest.approx(0.065, abs=1e-15)
    meet_ball(big, small, state.FLY, state.ROLL, numbers)
    assert big[state.VZ] > 0.05  # lifted
    assert small[state.VZ] == 0.0  # pressed onto the bed
    assert (big[V] - small[V]) @ n == pytest.approx(-0.95 * n[0], abs=0.01)
    assert 0.3 * big[state.VX] + M * small[state.VX] == pytest.approx(0.3, abs=1e-15)


def test_11_unequal_balls_on_the_bed_touch_at_their_own_distance():
    world = bedded()
    balls = (Ball("b0", 0.034, 0.25), Ball("b1", 0.0285, 0.17))
    world = World(**{k: getattr(world, k) for k in World.__slots__} | {"balls": balls})
    trace = throw_balls(
        world, {"b0": (0.0, 0.0), "b1": (0.4, 0.01)}, {"b0": Motion((1.5, 0.0), (0.0, 0.0, 0.0))}
    )
    hit = told(trace, BallsCollided)[0]
    place = trace.positions([hit.time])[0]
    assert np.linalg.norm(place[0] - place[1]) == pytest.approx(0.0625, abs=1e-12)
    sound(trace)


# 12: what friction between balls on the bed would lift


@pytest.mark.parametrize("speed", [0.5, 1.0, 1.5, 2.0, 5.0, 9.0, 12.0])
def test_12_follow_would_lift_a_ball_by_less_than_a_hop(speed):
    world = make_world(2, contact=ALCIATORE)
    one, two = packed(world).rows.copy()
    one[state.VX], one[state.WY], two[state.X] = speed, speed / R, 2.0 * R
    meet_ball(one, two, state.FLY, state.FLY, packed(world).numbers)
    assert 0.0 < one[state.VZ] ** 2 / (2.0 * G) < state.HOP


def test_12_a_hard_follow_shot_stays_on_the_bed():
    world, strike = make_world(2), Strike(9.0, 0.0, 0.0, 0.0, 0.45)
    layout = {"b0": (-0.6, 0.0), "b1": (0.2, 0.004)}
    trace = simulate(world, layout, "b0", strike)
    assert not trace.flies
    assert trace.hash() == simulate(grounded(world), layout, "b0", strike).hash()
    assert told(trace, BallsCollided)


# 36: bounces that pile up


@pytest.mark.parametrize("bounce", [0.0, 0.3, 0.5, 0.9, 0.95])
def test_36_bounces_end_and_fall_off_as_the_square(bounce):
    fall = {"b0": Motion((0.3, 0.0), (0.0, 0.0, 5.0), height=0.1)}
    trace = throw_balls(bedded(1, bounce), {"b0": (0.0, 0.0)}, fall)
    times = [event.time for event in told(trace, BallLanded)]
    middles = [(a + b) / 2 for a, b in pairwise(times)]
    rises = np.array([trace.positions([time])[0, 0, 2] - R for time in middles])
    assert rises == pytest.approx(0.1 * bounce ** (2.0 * np.arange(1, len(rises) + 1)), rel=1e-9)
    assert (rises > state.HOP).all()
    assert 0.1 * bounce ** (2 * (len(rises) + 1)) <= state.HOP
    assert len(told(trace, BallStopped)) == 1
    sound(trace)


def test_36_a_bed_that_never_lets_go_is_refused():
    with pytest.raises(ValueError, match="ball on bed"):
        throw_balls(bedded(1, 0.96), {"b0": (0.0, 0.0)}, {"b0": REST})


# 37: the slate answers inside the strike


@pytest.mark.parametrize("elevation", [1, 5, 20, 45, 70, 90])
@pytest.mark.parametrize("speed", [0.05, 0.5, 3.0, 9.0])
def test_37_a_raised_strike_has_no_event_of_no_duration(elevation, speed):
    world = make_world(1)
    strike = Strike(speed, 0.4, radians(elevation), 0.2, -0.1)
    motion = strike_ball(world.balls[0], world.cue, world.cloth, strike)
    assert motion.rise == 0.0 or motion.rise**2 > 2.0 * G * state.HOP
    trace = simulate(world, {"b0": (0.0, 0.0)}, "b0", strike)
    assert all(row[state.E_TIME] > 0.0 for row in trace.log)
    assert trace.positions([0.0, 1e-6])[:, 0, 2].min() >= R
    lifted = told(trace, BallLeftBed)[:1]
    assert [event.time for event in lifted] == [0.0] * (motion.rise > 0.0)
    assert (trace.positions(np.linspace(0.0, trace.duration, 300))[:, 0, 2] != 0.0).all()


# 38: landing on another ball


@pytest.mark.parametrize("aside", [1e-9, 1e-4, 0.01, 0.04])
def test_38_a_ball_that_is_landed_on_is_pressed_and_not_sunk(aside):
    world = bedded()
    one, two = packed(world).rows.copy()
    n = np.array([aside, 0.0, -sqrt(4.0 * R * R - aside * aside)])
    one[[state.X, state.Y, state.Z]], two[[state.X, state.Y]] = (0.0, 0.0, R - n[2]), n[:2]
    one[V], one[W] = (0.7, 0.1, -2.0), (3.0, 20.0, -9.0)
    before = M * (one[V] + two[V])
    meet_ball(one, two, state.FLY, state.REST, packed(world).numbers)
    after = M * (one[V] + two[V])
    assert after[:2] == pytest.approx(before[:2], abs=1e-15)
    assert after[2] > before[2]  # the slate's push
    assert two[state.VZ] == 0.0
    assert one[V] @ n > -2.0 * R * hypot(0.71, 2.0)


def test_38_a_ball_exactly_on_top_of_another_falls_off():
    shot = Simulation(bedded(), {"b0": (9.0, 9.0), "b1": (0.0, 0.0)}, "b0", Strike(0.0, 0.0))
    shot._rows[0, [state.X, state.Y, state.Z]] = (0.0, 0.0, 3.0 * R + 0.05)
    shot._kinds[0] = state.FLY
    shot.advance(inf)
    trace = shot.trace()
    assert len(trace.log) < 5000
    assert told(trace, BallLanded)
    sound(trace)


# 39: the nose from the air


def brute(ball, nose, last):
    """Return the first time at which a flying ball lies in a nose, on a fine grid."""
    t = np.linspace(0.0, last, 200001)
    x, y = ball[state.X] + t * ball[state.VX], ball[state.Y] + t * ball[state.VY]
    z = ball[state.Z] + t * (ball[state.VZ] - 0.5 * G * t) - NOSE
    if nose[state.N_CURVED] == 0.0:
        dx, dy = nose[state.N_DX], nose[state.N_DY]
        at = np.clip((x - nose[state.N_X]) * dx + (y - nose[state.N_Y]) * dy, 0, nose[state.N_SIZE])
        px, py = nose[state.N_X] + at * dx, nose[state.N_Y] + at * dy
    else:
        middle = atan2(nose[state.N_DY], nose[state.N_DX])
        half = np.arccos(np.clip(nose[state.N_SPAN], -1.0, 1.0))
        angle = np.arctan2(y - nose[state.N_Y], x - nose[state.N_X]) - middle
        angle = np.clip((angle + pi) % (2.0 * pi) - pi, -half, half) + middle
        px = nose[state.N_X] + abs(nose[state.N_SIZE]) * np.cos(angle)
        py = nose[state.N_Y] + abs(nose[state.N_SIZE]) * np.sin(angle)
    gap = np.sqrt((x - px) ** 2 + (y - py) ** 2 + z**2) - R
    deep = np.flatnonzero(gap < 0.0)
    return (t[deep[0]] if len(deep) else None), gap


def test_39_noses_and_jaws_are_met_from_the_air_when_they_are_reached():
    world = packed(make_world(1, pockets=True))
    chance, met = np.random.default_rng(3), 0
    for _ in range(150):
        nose = world.noses[chance.integers(len(world.noses))]
        ball = world.rows[0].copy()
        way, far = chance.uniform(0, 2 * pi), chance.uniform(0.05, 0.2)
        x, y = 0.5 * (nose[[state.N_LOX, state.N_LOY]] + nose[[state.N_HIX, state.N_HIY]])
        ball[[state.X, state.Y]] = x - far * cos(way), y - far * sin(way)
        ball[state.Z] = R + chance.uniform(0.0, 0.06)
        ball[V] = 1.5 * cos(way), 1.5 * sin(way), chance.uniform(-0.3, 0.8)
        first, gap = brute(ball, nose, 0.2)
        if gap[0] < 0.0 or abs(gap.min()) < 1e-8:
            continue
        found = nose_in_air(ball, nose, world.numbers, 0.2)
        assert (found < 1e9) == (first is not None)
        if first is not None:
            met += 1
            assert first - 1.1e-6 <= found <= first
    assert met > 40


# 40: side spin and the slate


@given(
    v=st.tuples(*[st.floats(-8.0, 8.0)] * 2, st.floats(-6.0, -1e-3)),
    w=st.tuples(*[st.floats(-300.0, 300.0)] * 3),
)
@settings(max_examples=200, deadline=None)
def test_40_a_bounce_leaves_side_spin_and_the_end_of_the_slide(v, w):
    ball = packed(bedded(1)).rows[0].copy()
    ball[V], ball[W] = v, w
    meet_bed(ball, packed(bedded(1)).numbers)
    assert ball[state.WZ] == w[2]
    lasting = 5.0 * ball[V[:2]] + 2.0 * R * np.array([ball[state.WY], -ball[state.WX]])
    assert lasting == pytest.approx(5.0 * np.array(v[:2]) + 2.0 * R * np.array([w[1], -w[0]]))
    gained = 0.5 * (ball[V] @ ball[V]) + 0.2 * R**2 * (ball[W] @ ball[W])
    assert gained <= (0.5 * np.dot(v, v) + 0.2 * R**2 * np.dot(w, w)) * (1.0 + 1e-12)


# the top of the rail


def test_a_ball_comes_back_off_the_top_of_the_rail():
    world = make_world(1)
    trace = above_rail(world, (1.32, 0.0), Motion((-0.6, 0.2), (0.0, 0.0, 0.0)), 0.02)
    landings = told(trace, BallLanded)
    assert landings[0].rail
    assert not landings[-1].rail
    assert trace.positions([landings[0].time])[0, 0, 2] == pytest.approx(NOSE + R, abs=1e-12)
    assert abs(trace.final["b0"][0]) < 1.27
    assert not told(trace, BallLeftTable)
    sound(trace, world.table)


@pytest.mark.parametrize(("vx", "vy"), [(0.0, 0.3), (0.5, 0.0), (0.0, 0.0)])
def test_a_ball_that_stays_on_the_rail_or_passes_it_has_left_the_table(vx, vy):
    world = make_world(1)
    trace = above_rail(world, (1.30, 0.0), Motion((vx, vy), (0.0, 0.0, 0.0)), 0.1)
    assert len(told(trace, BallLeftTable)) == 1
    assert "b0" not in trace.final
    assert len(trace.log) < 500
    sound(trace, world.table)


def test_the_nose_is_met_from_above():
    world = make_world(1)
    trace = above_rail(world, (1.28, 0.0), Motion((-0.2, 0.0), (0.0, 0.0, 0.0)), 0.05)
    hit = told(trace, CushionHit)[0]
    assert trace.positions([hit.time])[0, 0, 2] > NOSE + 0.5 * R
    assert not told(trace, BallLeftTable)
    sound(trace, world.table)


# two in the air, and what is told


def test_two_flying_balls_meet():
    start = {
        "b0": Motion((1.0, 0.0), (0.0, 0.0, 0.0), 1.0, 0.05),
        "b1": Motion((-1.0, 0.05), (0.0, 0.0, 0.0), 1.0, 0.05),
    }
    trace = throw_balls(bedded(), {"b0": (-0.1, 0.0), "b1": (0.1, 0.0)}, start)
    hit = told(trace, BallsCollided)[0]
    assert trace.positions([hit.time])[0, :, 2].min() > R + 0.05
    before, after = trace.velocities([hit.time - 1e-9, hit.time + 1e-9])
    assert before.sum(0) == pytest.approx(after.sum(0), abs=1e-7)
    assert not told(trace, BallLeftBed)  # they began in the air
    sound(trace)


def test_a_jump_is_told_from_the_bed_to_the_landing():
    layout = {"b0": (-0.9, 0.0), "b1": (-0.5, 0.01)}
    trace = simulate(make_world(2), layout, "b0", Strike(4.0, 0.0, radians(45)))
    kinds = [type(event) for event in trace.events()][:3]
    assert kinds == [BallLeftBed, BallJumpedOver, BallLanded]
    assert told(trace, BallLeftBed) == [BallLeftBed(0.0, "b0")]


# properties


STROKES = st.builds(
    Strike,
    st.floats(0.2, 9.0),
    st.floats(-pi, pi),
    st.floats(0.0, pi / 2),
    st.floats(-0.35, 0.35),
    st.floats(-0.35, 0.35),
)
PLACES = st.tuples(st.floats(-1.1, 1.1), st.floats(-0.5, 0.5))


def fits(places):
    pairs = [(a, b) for k, a in enumerate(places) for b in places[k + 1 :]]
    return all(hypot(a[0] - b[0], a[1] - b[1]) > 2.0 * R + 1e-3 for a, b in pairs)


LAYOUTS = st.lists(PLACES, min_size=1, max_size=5).filter(fits)


@given(LAYOUTS, STROKES, st.booleans())
@settings(max_examples=60, deadline=None)
def test_no_raised_stroke_gains_energy_or_breaks_a_rule(places, strike, pockets):
    world = make_world(5, pockets=pockets)
    trace = simulate(world, {f"b{k}": at for k, at in enumerate(places)}, "b0", strike)
    sound(trace, world.table)


@given(LAYOUTS, STROKES, st.lists(st.floats(0.001, 3.0), min_size=1, max_size=12))
@settings(max_examples=30, deadline=None)
def test_chunks_of_any_size_change_no_bit(places, strike, steps):
    world, layout = make_world(5, pockets=True), {f"b{k}": at for k, at in enumerate(places)}
    shot, until = Simulation(world, layout, "b0", strike), 0.0
    for step in steps:
        until += step
        shot.advance(until)
    shot.advance(inf)
    assert shot.trace().hash() == simulate(world, layout, "b0", strike).hash()


@given(PLACES, STROKES)
@settings(max_examples=40, deadline=None)
def test_a_mirrored_stroke_is_the_mirrored_flight(place, strike):
    world = make_world(1)
    mirrored = Strike(strike.speed, -strike.heading, strike.elevation, -strike.side, strike.follow)
    one = simulate(world, {"b0": place}, "b0", strike)
    two = simulate(world, {"b0": (place[0], -place[1])}, "b0", mirrored)
    until = one.log[5, state.E_TIME] if len(one.log) > 5 else one.duration
    times = np.linspace(0.0, until, 40)[:-1]
    flip = np.array([1.0, -1.0, 1.0])
    assert two.positions(times) == pytest.approx(one.positions(times) * flip, abs=1e-7)


@given(LAYOUTS, STROKES, st.permutations(range(5)))
@settings(max_examples=30, deadline=None)
def test_names_decide_nothing_in_the_air(places, strike, order):
    names = [f"b{k}" for k in order]
    world, other = make_world(5), make_world(ids=tuple(names))
    layout = {f"b{k}": at for k, at in enumerate(places)}
    one, two = simulate(world, layout, "b0", strike), simulate(other, layout, "b0", strike)
    mine, yours = [b.id for b in one.balls], [b.id for b in two.balls]
    times = np.linspace(0.0, one.duration, 30)
    seat = [yours.index(name) for name in mine]
    assert (two.positions(times)[:, seat] == one.positions(times)).all()


# who has jumped over whom


def jumped(gap, speed):
    """A ball jumped at another `gap` m ahead: the kinds of events in which both have a part."""
    layout = {"b0": (-1.0, 0.0), "b1": (-1.0 + gap, 0.0)}
    trace = simulate(make_world(2), layout, "b0", Strike(speed, 0.0, radians(60)))
    early = [e for e in trace.events() if e.time < 0.35]
    return [type(e) for e in early if isinstance(e, BallJumpedOver | BallsCollided)]


def test_passed_wholly_touched_in_passing_landed_on_and_not_reached():
    assert jumped(0.095, 1.9) == [BallJumpedOver]
    assert jumped(0.13, 1.9) == [BallsCollided, BallJumpedOver]  # on its way over
    assert jumped(0.16, 2.1) == [BallJumpedOver, BallsCollided]  # on its way down behind
    assert jumped(0.17, 1.9) == [BallsCollided]
    assert jumped(0.6, 1.9) == []


def test_a_ball_that_has_rolled_away_is_not_jumped_over_where_it_was():
    world, start = bedded(), {"b0": Motion((1.0, 0.0), (0.0, 0.0, 0.0), 1.0, 0.06)}
    start["b1"] = Motion((0.0, 1.5), (-1.5 / R, 0.0, 0.0))
    trace = throw_balls(world, {"b0": (-0.2, 0.0), "b1": (0.0, 0.0)}, start)
    assert not told(trace, BallJumpedOver)
    start["b1"] = REST
    trace = throw_balls(world, {"b0": (-0.1, 0.0), "b1": (0.0, 0.0)}, start)
    assert len(told(trace, BallJumpedOver)) == 1


# pockets from the air


@pytest.mark.parametrize("aside", [-0.01, 0.0, 0.01])
@pytest.mark.parametrize("speed", [1.0, 2.0, 3.5])
def test_a_ball_that_flies_in_below_the_rail_ends_at_the_back_of_the_pocket(aside, speed):
    world = make_world(1, pockets=True)
    pocket = world.table.pockets[0]
    x, y = pocket.centre
    way = pi / 4.0  # of the corner
    place = x - 0.25 * cos(way) - aside * sin(way), y - 0.25 * sin(way) + aside * cos(way)
    rise = 0.25 / speed * G / 2.0 - 0.02 * speed / 0.25 + 0.05
    velocity = speed * cos(way), speed * sin(way)
    start = Motion(velocity, (0.0, 0.0, 0.0), max(rise, 0.0), 0.02)
    trace = throw_balls(world, {"b0": place}, {"b0": start})
    assert list(trace.pocketed) == ["b0"]
    (drop,) = [row for row in trace.log if row[state.E_KIND] == state.DROPPED]
    at = trace.positions([drop[state.E_TIME]])[0, 0]
    assert hypot(at[0] - x, at[1] - y) <= pocket.radius + 1e-9
    sound(trace, world.table)


def test_a_ball_that_flies_over_the_back_of_a_pocket_is_off():
    world = make_world(1, pockets=True)
    x, y = world.table.pockets[0].centre
    way = pi / 4.0  # of the corner
    start = Motion((3.0 * cos(way), 3.0 * sin(way)), (0.0, 0.0, 0.0), 1.5, 0.05)
    place = x - 0.3 * cos(way), y - 0.3 * sin(way)
    trace = throw_balls(world, {"b0": place}, {"b0": start})
    assert told(trace, BallLeftTable)
    assert not trace.pocketed
