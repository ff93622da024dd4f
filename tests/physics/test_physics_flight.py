"""Flight: groups F and G, jumps, landings, over the cushion, pockets from above, soundness."""

from functools import partial
from math import atan2, degrees, hypot, inf, pi, radians, sqrt

import numpy as np
import physics_cases
import pytest
from physics_cases import (
    ALCIATORE,
    CORNER,
    IDEAL,
    SIDE,
    M,
    R,
    grounded,
    open_world,
    rack,
    random_layout,
)

from engine.physics import state
from engine.physics.events import (
    BallJumpedOver,
    BallLanded,
    BallLeftTable,
    BallPocketed,
    BallsCollided,
    BallStopped,
    CushionHit,
    JawHit,
    RollingBegan,
)
from engine.physics.impact import meet_ball, meet_bed, meet_nose
from engine.physics.monitor import examine
from engine.physics.pack import packed
from engine.physics.simulate import Simulation, simulate
from engine.physics.strike import strike_ball
from engine.physics.world import Ball, Cloth, Cue, Strike

make_world = partial(physics_cases.make_world, flight="ballistic")

G = 9.81
JUMP = Strike(4.0, 0.0, radians(45))


def release(world, layout, motions, until=inf):
    """A shot whose balls start with given heights above the bed, velocities and spins."""
    shot = Simulation(world, layout, next(iter(layout)), Strike(0.0, 0.0))
    for index, ball in enumerate(shot._balls):
        if ball.id in motions:
            height, v, w = motions[ball.id]
            row = shot._rows[index]
            row[state.Z] = R + height
            row[[state.VX, state.VY, state.VZ]] = v
            row[[state.WX, state.WY, state.WZ]] = w
            shot._kinds[index] = state.FLY
    shot.advance(until)
    return shot.trace()


def row_of(v, w=(0.0, 0.0, 0.0), place=(0.0, 0.0, R), radius=R, mass=M):
    row = np.zeros(state.BALL_WIDTH)
    row[state.RADIUS], row[state.MASS], row[state.SLIDING] = radius, mass, 0.2
    row[state.REACH] = sqrt(radius**2 - (0.03629025 - radius) ** 2)
    row[[state.X, state.Y, state.Z]] = place
    row[[state.VX, state.VY, state.VZ]] = v
    row[[state.WX, state.WY, state.WZ]] = w
    return row


def told(trace, kind):
    return [event for event in trace.events() if isinstance(event, kind)]


def sound(trace, table=None):
    assert examine(trace, table).faults() == ()


def test_a_dropped_ball_bounces_as_a_geometric_series():
    trace = release(open_world(1), {"b0": (0.0, 0.0)}, {"b0": (0.05, (0, 0, 0), (0, 0, 0))})
    times = [event.time for event in told(trace, BallLanded)]
    assert times[:3] == pytest.approx([0.100963755469, 0.201927510938, 0.252409388673], abs=1e-9)
    ever = times[0] + 2.0 * (times[1] - times[0])
    assert ever == pytest.approx(0.302891266408, abs=1e-9)
    apex = trace.positions([0.5 * (times[0] + times[1])])[0, 0, 2] - R
    assert apex == pytest.approx(0.0125, abs=1e-12)
    assert len(times) == 3
    assert trace.positions([trace.duration])[0, 0, 2] == R
    sound(trace)


@pytest.mark.parametrize(
    ("v", "w", "after_v", "after_w"),
    [
        ((1.0, 0.0, -1.0), (0.0, -20.0, 7.0), (0.7, 0.0, 0.5), (0.0, 6.2467191601, 7.0)),
        (
            (1.0, 0.3, -3.0),
            (5.0, 20.0, 7.0),
            (0.877571428571, 0.173464285714, 1.5),
            (-6.0704911886, 30.7111611049, 7.0),
        ),
    ],
)
def test_the_bed_answers_with_restitution_and_friction(v, w, after_v, after_w):
    numbers = packed(open_world(1)).numbers
    ball = row_of(v, w)
    assert meet_bed(ball, numbers) == -v[2]
    slip = np.array([v[0] - R * w[1], v[1] + R * w[0]])
    change = min(0.2 * 1.5 * -v[2], np.linalg.norm(slip) / 3.5)
    expected = np.array(v[:2]) - change * slip / np.linalg.norm(slip)
    assert ball[[state.VX, state.VY]] == pytest.approx(expected, abs=1e-12)
    assert ball[state.VZ] == pytest.approx(-0.5 * v[2], abs=1e-15)
    assert ball[state.WZ] == 7.0
    invariant = 5 * np.array(v[:2]) + 2 * R * np.array([w[1], -w[0]])
    end = 5 * ball[[state.VX, state.VY]] + 2 * R * np.array([ball[state.WY], -ball[state.WX]])
    assert end == pytest.approx(invariant, abs=1e-12)
    assert ball[[state.VX, state.VY, state.VZ]] == pytest.approx(after_v, abs=1e-11)
    assert ball[[state.WX, state.WY, state.WZ]] == pytest.approx(after_w, abs=1e-9)


def test_a_jump_shot_by_the_figures():
    cloth = Cloth(0.2, 0.01, 10.0, bounce=0.6)
    cue = Cue(0.2551, 0.85, 0.6, 25.0)
    motion = strike_ball(Ball("b0", R, M), cue, cloth, JUMP)
    assert motion.velocity == pytest.approx((2.24237866736, 0.0), abs=1e-9)
    assert motion.rise == pytest.approx(1.88359808058, abs=1e-9)
    assert motion.spin == pytest.approx((0.0, 78.4734441772, 0.0), abs=1e-7)
    start = {"b0": (0.0, (*motion.velocity, motion.rise), motion.spin)}
    trace = release(open_world(1, cloth=cloth), {"b0": (0.0, 0.0)}, start)
    landing = told(trace, BallLanded)[0].time
    apex = trace.positions([landing / 2])[0, 0, 2] - R
    assert apex == pytest.approx(0.180832911783, abs=1e-9)
    assert landing == pytest.approx(0.38401591857, abs=1e-9)
    assert trace.positions([landing])[0, 0, 0] == pytest.approx(0.861109103728, abs=1e-9)
    assert trace.spins([0.5 * landing])[0, 0] == pytest.approx(motion.spin, abs=1e-9)


def test_a_raised_cue_gives_its_downward_speed_to_the_bed():
    cloth, cue = Cloth(1e-300, 0.01, 10.0, bounce=0.5), Cue(0.567, 1.0, 0.9, 1e12)
    strike = Strike(3.0, 0.0, radians(20), 0.3, -0.2)
    motion = strike_ball(Ball("b0", R, M), cue, cloth, strike)
    assert motion.velocity == pytest.approx((3.46964558931, 0.0), abs=1e-6)
    assert motion.rise == pytest.approx(0.5 * 1.26284771796, abs=1e-9)
    assert motion.spin == pytest.approx((33.1456093953, -64.6075190641, 91.0668133677), abs=1e-4)
    flat = strike_ball(Ball("b0", R, M), cue, cloth, strike, flies=False)
    assert flat.rise == 0.0


@pytest.mark.parametrize("speed", [1.0, 3.0])
@pytest.mark.parametrize("sliding", [0.1, 0.25])
@pytest.mark.parametrize(
    ("elevation", "side", "follow", "expected"),
    [
        (20, 0.3, 0.0, -6.23150032317),
        (60, 0.35, -0.2, -45.2953443014),
        (80, 0.4, -0.1, -79.4101923608),
        (45, 0.3, -0.4, -34.6345276663),
    ],
)
def test_masse_ends_as_coriolis_says_however_it_hops(
    elevation, side, follow, expected, speed, sliding
):
    world = open_world(1, cloth=Cloth(sliding, 0.01, 10.0))
    cue = Cue(0.54, 0.73, 1e9, 1e18)
    strike = Strike(speed, 0.0, radians(elevation), side, follow)
    motion = strike_ball(world.balls[0], cue, world.cloth, strike)
    start = {"b0": (0.0, (*motion.velocity, motion.rise), motion.spin)}
    trace = release(world, {"b0": (0.0, 0.0)}, start)
    rolls = max(event.time for event in told(trace, (RollingBegan, BallLanded)))
    vx, vy, vz = trace.velocities([rolls + 1e-9])[0, 0]
    assert degrees(atan2(vy, vx)) == pytest.approx(expected, abs=1e-7)
    assert vz == 0.0
    sound(trace)


def test_head_on_follow_lifts_in_three_dimensions():
    numbers = packed(open_world(2)).numbers
    one = row_of((1.0, 0.0, 0.0), (0.0, 1.0 / R, 0.0))
    two = row_of((0.0, 0.0, 0.0), place=(2 * R, 0.0, R))
    assert meet_ball(one, two, state.FLY, state.FLY, numbers) == pytest.approx(1.0)
    velocity = [state.VX, state.VY, state.VZ]
    assert one[velocity] == pytest.approx((0.025, 0.0, 0.0451766998353), abs=1e-6)
    assert two[velocity] == pytest.approx((0.975, 0.0, -0.0451766998353), abs=1e-6)
    assert R * one[state.WY] == pytest.approx(0.887058250412, abs=1e-6)
    assert R * two[state.WY] == pytest.approx(-0.112941749588, abs=1e-6)


def energy(*rows):
    return sum(
        0.5 * b[state.MASS] * (b[[state.VX, state.VY, state.VZ]] ** 2).sum()
        + 0.2
        * b[state.MASS]
        * b[state.RADIUS] ** 2
        * (b[[state.WX, state.WY, state.WZ]] ** 2).sum()
        for b in rows
    )


def test_meetings_in_the_air_keep_momentum_and_gain_no_energy():
    rng = np.random.default_rng(7)
    numbers = packed(open_world(2)).numbers
    xyz, spin = [state.VX, state.VY, state.VZ], [state.WX, state.WY, state.WZ]
    for k in range(5000):
        n = rng.normal(size=3)
        n /= np.linalg.norm(n)
        radii, masses = rng.uniform(0.02, 0.04, 2), rng.uniform(0.1, 0.3, 2)
        one = row_of(rng.normal(size=3), rng.normal(size=3) * 50, (0, 0, 1), radii[0], masses[0])
        place = np.array([0, 0, 1]) + n * radii.sum()
        two = row_of(rng.normal(size=3), rng.normal(size=3) * 50, place, radii[1], masses[1])
        bedded = k % 2
        if bedded:
            two[state.VZ] = 0.0
        closing = (one[xyz] - two[xyz]) @ n
        if closing <= state.KICK:
            continue
        before, momentum = energy(one, two), masses[0] * one[xyz] + masses[1] * two[xyz]
        turned = [one[spin] @ n, two[spin] @ n]
        meet_ball(one, two, state.FLY, state.REST if bedded else state.FLY, numbers)
        after = masses[0] * one[xyz] + masses[1] * two[xyz]
        axes = 2 if bedded else 3
        assert after[:axes] == pytest.approx(momentum[:axes], abs=1e-14)
        assert energy(one, two) <= before + 1e-14
        assert [one[spin] @ n, two[spin] @ n] == pytest.approx(turned, abs=1e-11)
        if bedded:
            assert two[state.VZ] >= 0.0
        else:
            e = 0.95 if closing >= 0.02 else 1.0
            assert (one[xyz] - two[xyz]) @ n == pytest.approx(-e * closing, abs=1e-12)


def test_noses_gain_no_energy_and_send_balls_away():
    rng = np.random.default_rng(8)
    world = make_world(1)
    numbers, nose = packed(world).numbers, packed(world).noses[0]
    for _ in range(3000):
        angle = rng.uniform(-1.2, 1.2)
        height = 0.03629025 - R * np.sin(angle)
        if height < R:
            continue
        ball = row_of(rng.normal(size=3) * 3, rng.normal(size=3) * 50, (0, 0, height))
        n = np.array([np.cos(angle), 0.0, np.sin(angle)])
        xyz = [state.VX, state.VY, state.VZ]
        if ball[xyz] @ n <= 0.0:
            continue
        before = energy(ball)
        meet_nose(ball, numbers, nose, R * np.cos(angle), 0.0)
        assert energy(ball) <= before + 1e-13
        assert ball[xyz] @ n <= 1e-12


def test_a_ball_jumps_over_another():
    layout = {"b0": (-0.9, 0.0), "b1": (-0.5, 0.01)}
    trace = simulate(make_world(2), layout, "b0", JUMP)
    events = trace.events()
    jump = next(e for e in events if isinstance(e, BallJumpedOver))
    assert (jump.ball, jump.other) == ("b0", "b1")
    assert trace.positions([jump.time])[0, 0, 0] == pytest.approx(-0.5, abs=1e-9)
    assert trace.positions([jump.time])[0, 0, 2] > 3 * R
    first = next(e for e in events if isinstance(e, BallsCollided))
    assert first.time > jump.time + 1.0
    flat = simulate(grounded(make_world(2)), layout, "b0", JUMP)
    assert not told(flat, BallJumpedOver)
    assert told(flat, BallsCollided)[0].time < 0.3
    sound(trace)


def test_a_ball_beside_the_way_is_not_jumped_over():
    layout = {"b0": (-0.9, 0.0), "b1": (-0.5, 2 * R + 1e-4)}
    assert not told(simulate(make_world(2), layout, "b0", JUMP), BallJumpedOver)


@pytest.mark.parametrize("aside", [0.0, 0.004, 0.02])
def test_a_ball_lands_on_another(aside):
    world = open_world(2)
    layout = {"b0": (0.0, 0.0), "b1": (0.3, aside)}
    start = {"b0": (0.2, (1.5, 0.0, 0.0), (0.0, 0.0, 0.0))}
    trace = release(world, layout, start)
    hit = told(trace, BallsCollided)[0]
    place = trace.positions([hit.time])[0]
    assert np.linalg.norm(place[0] - place[1]) == pytest.approx(2 * R, abs=1e-12)
    assert place[0, 2] > 2 * R
    assert place[1, 2] == R
    before, after = trace.velocities([hit.time - 1e-9, hit.time + 1e-9])
    momentum = before.sum(0) - after.sum(0)
    assert momentum[:2] == pytest.approx((0.0, 0.0), abs=1e-8)
    sound(trace)


@pytest.mark.parametrize("aside", [0.0, 1e-6, 1e-3])
@pytest.mark.parametrize("height", [0.06, 0.0715, 0.2])
def test_a_ball_dropped_onto_another_rolls_off_or_stays_bouncing(aside, height):
    world = open_world(2)
    layout = {"b0": (0.0, 0.0), "b1": (aside, 0.0)}
    start = {"b0": (height, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))}
    shot_end = 0.9 if aside < 1e-9 else inf
    trace = start_over(world, layout, start, shot_end)
    assert told(trace, BallsCollided)
    assert len(trace.log) < 10000
    sound(trace)


def start_over(world, layout, start, until):
    """As `release`, for balls that lie above each other and so overlap seen from above."""
    apart = {"b0": (9.0, 9.0), "b1": layout["b1"]}
    shot = Simulation(world, apart, "b0", Strike(0.0, 0.0))
    height, v, w = start["b0"]
    shot._rows[0, [state.X, state.Y]] = layout["b0"]
    shot._rows[0, state.Z] = R + height
    shot._rows[0, [state.VX, state.VY, state.VZ]] = v
    shot._rows[0, [state.WX, state.WY, state.WZ]] = w
    shot._kinds[0] = state.FLY
    shot.advance(until)
    return shot.trace()


def test_over_the_cushion_off_the_table():
    world = make_world(1)
    trace = simulate(world, {"b0": (0.6, 0.0)}, "b0", Strike(5.0, 0.0, radians(45)))
    (left,) = told(trace, BallLeftTable)
    place = trace.positions([left.time])[0, 0]
    assert place[0] > 1.27
    assert place[2] == pytest.approx(world.table.nose_height + R, abs=1e-12)
    assert trace.positions([left.time + 0.1])[0, 0, 2] < 0.0
    assert not trace.final
    assert not told(trace, CushionHit)
    sound(trace, world.table)


def test_a_low_flight_comes_back_off_the_nose():
    world = make_world(1)
    trace = simulate(world, {"b0": (1.03, 0.0)}, "b0", Strike(2.0, 0.0, radians(25)))
    hit = told(trace, CushionHit)[0]
    assert trace.positions([hit.time])[0, 0, 2] > R + 1e-3
    assert trace.velocities([hit.time + 1e-6])[0, 0, 0] < -0.5
    assert not told(trace, BallLeftTable)
    sound(trace, world.table)


def test_into_a_pocket_from_the_air():
    world = make_world(1, pockets=True)
    pocket = world.table.pockets[0]
    x, y = pocket.centre
    reach = 0.5
    way = atan2(y, x)
    start = (x - reach * np.cos(way), y - reach * np.sin(way))
    speed = reach / (2 * 1.5 / G)
    v = (speed * np.cos(way), speed * np.sin(way), 1.5)
    trace = release(world, {"b0": start}, {"b0": (0.0, v, (0.0, 0.0, 0.0))})
    (drop,) = told(trace, BallPocketed)
    assert drop.pocket == pocket.id
    assert drop.time == pytest.approx(3.0 / G, abs=1e-9)
    assert not told(trace, JawHit)
    sound(trace, world.table)


def test_a_ball_flies_over_a_drop_and_off():
    world = make_world(1, pockets=True)
    trace = simulate(world, {"b0": (0.0, 0.0)}, "b0", Strike(6.0, pi / 2, radians(40)))
    assert told(trace, BallLeftTable)
    assert not told(trace, BallPocketed)


def test_nothing_flies_where_it_is_not_worth_it():
    world = make_world(2)
    layout, strike = {"b0": (-0.5, 0.0), "b1": (0.5, 0.1)}, Strike(1.0, 0.3, radians(5), 0.2)
    trace = simulate(world, layout, "b0", strike)
    assert not trace.flies
    assert trace.hash() == simulate(grounded(world), layout, "b0", strike).hash()


def random_flight(seed):
    rng = np.random.default_rng(seed)
    n = int(rng.integers(1, 14))
    cushion = ["han-2005", "restitution", "mathavan-2010"][seed % 3]
    contact = IDEAL if seed % 5 == 0 else ALCIATORE
    cuts = (CORNER, SIDE)
    world = make_world(n, pockets=bool(seed % 2), cuts=cuts, ball_cushion=cushion, contact=contact)
    strike = Strike(
        rng.uniform(0.5, 9.0),
        rng.uniform(0.0, 6.28),
        rng.uniform(0.05, 1.5),
        rng.uniform(-0.35, 0.35),
        rng.uniform(-0.35, 0.35),
    )
    return world, random_layout(rng, n), strike


@pytest.mark.parametrize("seed", range(150))
def test_random_flights_keep_all_rules(seed):
    world, layout, strike = random_flight(seed)
    trace = simulate(world, layout, "b0", strike)
    sound(trace, world.table)
    left = told(trace, BallLeftTable)
    assert len(trace.final) + len(trace.pocketed) + len(left) == len(layout)
    assert len(trace.log) < 3000
    for x, y in trace.final.values():
        assert hypot(x, y) < 1.45
    assert (trace.positions([trace.duration + 1e-9])[0, :, 2] <= R).all()
    assert trace.kinetic_energy([trace.duration + 1e-9])[0] == 0.0


@pytest.mark.parametrize("seed", range(0, 60, 3))
def test_chunks_change_no_bit_of_a_flight(seed):
    world, layout, strike = random_flight(seed)
    whole = simulate(world, layout, "b0", strike)
    for step in (1 / 24, 1 / 60, 0.31):
        shot, until = Simulation(world, layout, "b0", strike), 0.0
        while not shot.finished:
            until += step
            shot.advance(until)
            if until < 0.5:
                shot.trace()
        assert shot.trace().hash() == whole.hash()


@pytest.mark.parametrize("seed", range(1, 40, 3))
def test_labels_change_no_bit_of_a_flight(seed):
    world, layout, strike = random_flight(seed)
    n = len(layout)
    rng = np.random.default_rng(seed)
    names = [f"b{k}" for k in rng.permutation(n)]
    cuts = {"pockets": bool(world.table.pockets), "ball_cushion": world.models.ball_cushion}
    other = make_world(ids=names, contact=world.contact, **cuts)
    one, two = simulate(world, layout, "b0", strike), simulate(other, layout, "b0", strike)
    order = [names.index(f"b{k}") for k in range(n)]
    times = np.linspace(0.0, one.duration, 50)
    assert (two.positions(times)[:, order] == one.positions(times)).all()


def test_a_jump_into_a_frozen_rack_is_sound():
    layout = {"b0": (-0.2, 0.003), **{f"b{k + 1}": p for k, p in enumerate(rack(0.635))}}
    met = 0
    for elevation in (10, 20, 30, 40):
        world = make_world(16, pockets=True)
        trace = simulate(world, layout, "b0", Strike(4.5, 0.0, radians(elevation)))
        met += len(told(trace, BallsCollided)) > 0
        sound(trace, world.table)
    assert met >= 2


def test_a_grazed_nose_top_and_a_ball_that_stops_are_told_once():
    trace = simulate(make_world(1), {"b0": (0.0, 0.0)}, "b0", Strike(1.0, 0.0, pi / 2))
    assert len(told(trace, BallStopped)) == 1
    assert trace.final["b0"] == pytest.approx((0.0, 0.0), abs=1e-12)


def test_a_bounce_is_between_none_and_all():
    with pytest.raises(ValueError, match="ball on bed"):
        simulate(
            make_world(1, cloth=Cloth(0.2, 0.01, 10.0, bounce=1.1)),
            {"b0": (0.0, 0.0)},
            "b0",
            JUMP,
        )
