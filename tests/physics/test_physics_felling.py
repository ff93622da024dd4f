"""Closes the hole between pins in a shot and the rules that hold for every shot."""

from __future__ import annotations

from dataclasses import replace
from math import atan2, cos, hypot, inf, pi, sin

import numpy as np
import pytest
from physics_cases import R, make_world, random_strike, throw

from engine.physics import state
from engine.physics.events import BallsCollided, PinToppled, PinTouched
from engine.physics.monitor import examine
from engine.physics.pins import LYING
from engine.physics.simulate import Simulation, simulate
from engine.physics.world import Ball, Strike
from engine.table.furniture import BallId, Pin, PinId
from engine.table.pin import meeting

SHORT = ((0.0, 0.0035), (0.013, 0.005), (0.025, 0.003))
TALL = ((0.0, 0.007), (0.036, 0.010), (0.12, 0.0055))
CROSS = {"c": (0.0, 0.0), "h": (-1.0, 0.0), "f": (1.0, 0.0), "l": (0.0, 1.0), "r": (0.0, -1.0)}
STILL = (0.0, 0.0, 0.0)


def with_pins(places, profile=TALL, n=3, mass=None, **options):
    weight = mass or (0.0105 if profile == TALL else 0.0018)
    world = make_world(n, flight="none", **options)
    pins = tuple(Pin(PinId(name), at, profile, weight) for name, at in places.items())
    return replace(world, table=replace(world.table, pins=pins))


def cross(spacing, **options):
    return with_pins({k: (spacing * x, spacing * y) for k, (x, y) in CROSS.items()}, **options)


def felled(trace):
    return {one.pin: one.by for one in trace.events() if isinstance(one, PinToppled)}


def rolling(vx, vy):
    return ((vx, vy), (-vy / R, vx / R, 0.0))


def test_a_ball_fells_a_pin_at_the_moment_it_touches_and_passes_on():
    world = with_pins({"a": (0.0, 0.0)}, n=1)
    trace = throw(world, {"b0": (-0.5, 0.0)}, {"b0": rolling(1.0, 0.0)})
    (event,) = [one for one in trace.events() if isinstance(one, PinToppled)]
    reach = meeting(TALL, R)[0]
    place = trace.positions([event.time])[0, 0]
    assert hypot(place[0], place[1]) == pytest.approx(reach, abs=1e-9)
    assert event.by == ("b0",)
    assert trace.positions([1.0])[0, 0, 0] > 0.2
    assert trace.pins.stances(event.time - 1e-6)["a"].tilt == 0.0
    lying = trace.pins.stances(trace.duration)["a"]
    assert lying.tilt == LYING
    assert lying.way == pytest.approx((1.0, 0.0))
    assert lying.foot[0] > 0.0


def test_a_slow_ball_is_sent_back_and_the_pin_stands():
    world = with_pins({"a": (0.0, 0.0)}, n=1)
    start = (-meeting(TALL, R)[0] - 0.001, 0.0)
    trace = throw(world, {"b0": start}, {"b0": rolling(0.02, 0.0)})
    assert not felled(trace)
    touches = [one for one in trace.events() if isinstance(one, PinTouched)]
    assert touches
    assert {(one.pin, one.by) for one in touches} == {("a", "b0")}
    assert trace.pins.stances(trace.duration)["a"].tilt == 0.0
    assert trace.final["b0"][0] < start[0] + 0.001 + 1e-9
    assert not examine(trace, world).faults()


@pytest.mark.parametrize("heading", np.linspace(-0.06, 0.06, 13))
def test_what_a_ball_loses_at_a_pin_is_what_the_log_says_the_pin_got(heading):
    world = cross(0.082)
    layout = {"b0": (-0.4, 0.01), "b1": (0.4, 0.2), "b2": (0.5, 0.0)}
    trace = simulate(world, layout, "b0", Strike(2.5, float(heading)))
    rows = trace.log[(trace.log[:, state.E_KIND] == state.TOPPLED) & (trace.log[:, 2] >= 0)]
    assert len(rows)
    for _, time, first, second, impulse in rows:
        ball = int(first)
        mine = trace.pieces[trace.pieces[:, state.P_BALL] == ball]
        (after,) = mine[mine[:, state.P_T0] == time]
        (before,) = mine[mine[:, state.P_T1] == time]
        s = time - before[state.P_T0]
        came = before[[state.P_VX, state.P_VY]] + s * before[[state.P_AX, state.P_AY]]
        went = after[[state.P_VX, state.P_VY]]
        lost = trace.balls[ball].mass * (came - went)
        pin = world.table.pins[int(second)]
        way = np.subtract(pin.at, after[[state.P_X, state.P_Y]])
        way /= np.hypot(*way)
        assert lost == pytest.approx(impulse * way, abs=1e-15)


def test_a_tall_pin_fells_the_one_behind_it_and_is_named_for_it():
    world = with_pins({"a": (0.0, 0.0), "b": (0.09, 0.0), "c": (0.18, 0.0)}, n=1)
    trace = throw(world, {"b0": (-0.1, 0.0)}, {"b0": rolling(0.12, 0.0)})
    assert felled(trace) == {"a": ("b0",), "b": ("a",), "c": ("b",)}
    times = [one.time for one in trace.events() if isinstance(one, PinToppled)]
    assert times == sorted(times)
    assert trace.duration >= times[-1]


def test_a_pin_that_stands_fast_stops_the_one_that_falls_on_it():
    world = with_pins({"a": (0.0, 0.0), "b": (0.09, 0.0)}, n=1)
    heavy = replace(world.table.pins[1], threshold=1.0)
    world = replace(world, table=replace(world.table, pins=(world.table.pins[0], heavy)))
    trace = throw(world, {"b0": (-0.1, 0.0)}, {"b0": rolling(0.3, 0.0)})
    assert felled(trace) == {"a": ("b0",)}
    touches = [(one.pin, one.by) for one in trace.events() if isinstance(one, PinTouched)]
    assert touches[0] == ("b", "a")
    assert ("b", "b0") in touches
    assert trace.final["b0"][0] < 0.09 - meeting(TALL, R)[0]


def test_two_balls_that_meet_a_pin_at_once_fell_it_together():
    world = with_pins({"a": (0.0, 0.0)}, n=2)
    layout = {"b0": (-0.2, 0.4), "b1": (-0.2, -0.4)}
    motions = {"b0": rolling(0.5, -1.0), "b1": rolling(0.5, 1.0)}
    trace = throw(world, layout, motions)
    (event,) = [one for one in trace.events() if isinstance(one, PinToppled)]
    assert event.by == ("b0", "b1")
    assert trace.pins.stances(inf)["a"].way == pytest.approx((1.0, 0.0))


def test_pins_that_fall_on_one_at_once_fell_it_together():
    world = with_pins({"u": (0.0, 0.1), "d": (0.0, -0.1), "a": (0.08, 0.0)}, n=2)
    up, down = (0.08, -0.1), (0.08, 0.1)
    layout, motions = {}, {}
    for ball, pin, way in (("b0", (0.0, 0.1), up), ("b1", (0.0, -0.1), down)):
        size = hypot(*way)
        layout[ball] = (pin[0] - 0.3 * way[0] / size, pin[1] - 0.3 * way[1] / size)
        motions[ball] = rolling(0.6 * way[0] / size, 0.6 * way[1] / size)
    trace = throw(world, layout, motions)
    assert set(felled(trace)["a"]) == {"u", "d"}
    assert trace.pins.stances(inf)["a"].way == pytest.approx((1.0, 0.0), abs=1e-9)


def test_a_pin_that_is_down_or_has_no_room_is_not_there():
    world = with_pins({"a": (0.0, 0.0), "b": (0.3, 0.0)}, n=2)
    strike = Strike(1.5, 0.0)
    layout = {"b0": (-0.5, 0.0), "b1": (0.32, 0.0)}
    trace = simulate(world, layout, "b0", strike, fallen=[PinId("a")])
    assert not felled(trace)
    assert trace.pins.stances(0.0) == {}
    assert set(simulate(world, layout, "b0", strike).pins.stances(0.0)) == {"a"}


def test_pins_do_not_stand_in_the_way_of_a_shot_that_leaves_them():
    layout = {"b0": (-0.4, 0.0), "b1": (0.5, 0.5), "b2": (-0.9, 0.1)}
    strike = Strike(3.0, 1.2)
    bare = simulate(make_world(3, flight="none"), layout, "b0", strike)
    world = with_pins({"a": (0.9, -0.55)})
    trace = simulate(world, layout, "b0", strike)
    if not any(isinstance(one, PinToppled | PinTouched) for one in trace.events()):
        assert np.array_equal(trace.log, bare.log)
        assert np.array_equal(trace.pieces, bare.pieces)
    else:
        pytest.fail("the shot was to leave the pin alone")


def shots(seed, count):
    rng = np.random.default_rng(seed)
    for _ in range(count):
        profile = (TALL, SHORT)[int(rng.integers(2))]
        spacing = 0.078 if profile == TALL else 0.066
        world = cross(spacing, profile=profile, ball_cushion="mathavan-2010")
        layout = {}
        while len(layout) < 3:
            x, y = rng.uniform(-1, 1, 2) * (1.2, 0.6) * rng.choice([1.0, 0.25])
            if all(hypot(x - u, y - v) > 2.01 * R for u, v in layout.values()):
                layout[f"b{len(layout)}"] = (float(x), float(y))
        strike = random_strike(rng)
        if rng.random() < 0.7:
            x, y = layout["b0"]
            strike = replace(strike, heading=atan2(-y, -x) + float(rng.normal()) * 0.15)
        if rng.random() < 0.3:
            strike = replace(strike, speed=float(rng.uniform(0.02, 0.6)))
        yield world, layout, strike


@pytest.mark.parametrize("seed", range(8))
def test_random_shots_through_pins_keep_the_rules(seed):
    """The monitor, momentum aside of pins; a pin falls once; chunks of time change no bit."""
    down = 0
    for world, layout, strike in shots(seed, 40):
        trace = simulate(world, layout, "b0", strike)
        assert not examine(trace, world).faults()
        pins = [one.pin for one in trace.events() if isinstance(one, PinToppled)]
        assert len(pins) == len(set(pins))
        down += len(pins)
        for time in np.linspace(0.0, trace.duration, 7):
            for stance in trace.pins.stances(float(time)).values():
                assert 0.0 <= stance.tilt <= LYING
                assert abs(stance.foot[0]) < world.table.length / 2
                assert abs(stance.foot[1]) < world.table.width / 2
    assert down > 20


@pytest.mark.parametrize("chunk", [1 / 24, 1 / 60, 1 / 700])
def test_chunks_of_time_change_no_bit(chunk):
    for world, layout, strike in shots(77, 12):
        whole = simulate(world, layout, "b0", strike)
        shot, until = Simulation(world, layout, "b0", strike), 0.0
        while not shot.finished:
            until += chunk
            shot.advance(until)
        assert shot.trace().hash() == whole.hash()
        assert shot.trace().pins == whole.pins


def renamed(world, rng):
    """The same world with balls and pins in another order."""
    balls, pins = list(world.balls), list(world.table.pins)
    rng.shuffle(balls)
    rng.shuffle(pins)
    table = replace(world.table, pins=tuple(pins))
    return replace(world, balls=tuple(balls), table=table)


def told(trace, sign=1.0):
    """What happened, and where the pins lie, mirrored where the sign is -1."""
    found = [
        (one.pin, tuple(sorted(one.by)), one.time)
        for one in trace.events()
        if isinstance(one, PinToppled)
    ]
    lies = {
        pin: (stance.foot[0], sign * stance.foot[1], stance.tilt)
        for pin, stance in trace.pins.stances(inf).items()
    }
    return found, lies


def alike(one, two):
    assert [(pin, by) for pin, by, _ in one[0]] == [(pin, by) for pin, by, _ in two[0]]
    assert [time for *_, time in one[0]] == pytest.approx([t for *_, t in two[0]], abs=1e-9)
    assert set(one[1]) == set(two[1])
    for pin, stance in one[1].items():
        assert stance == pytest.approx(two[1][pin], abs=1e-8)


def test_names_and_their_order_decide_nothing():
    rng = np.random.default_rng(5)
    met = 0
    for world, layout, strike in shots(31, 40):
        trace = simulate(world, layout, "b0", strike)
        other = simulate(renamed(world, rng), layout, "b0", strike)
        assert trace.duration == other.duration
        alike(told(trace), told(other))
        assert trace.final == other.final
        met += len(felled(trace))
    assert met > 20


def test_a_mirrored_table_gives_the_mirrored_shot():
    swap = {"l": "r", "r": "l"}
    met = 0
    for world, layout, strike in shots(12, 40):
        mirrored = {ball: (x, -y) for ball, (x, y) in layout.items()}
        there = replace(strike, heading=-strike.heading, side=-strike.side)
        trace = simulate(world, layout, "b0", strike)
        other = simulate(world, mirrored, "b0", there)
        if any(isinstance(one, BallsCollided) for one in trace.events()):
            continue  # long shots grow what rounding does beyond any bound
        found, lies = told(other, -1.0)
        found = [
            (swap.get(pin, pin), tuple(sorted(swap.get(b, b) for b in by)), time)
            for pin, by, time in found
        ]
        early = [one for one in found if one[-1] < 1.5]
        mine, my_lies = told(trace)
        alike(
            ([one for one in mine if one[-1] < 1.5], {}),
            (early, {}),
        )
        met += len(early)
        if len(mine) == len(early) == len(found):
            alike(([], my_lies), ([], {swap.get(pin, pin): stance for pin, stance in lies.items()}))
    assert met > 10


def test_a_shot_down_the_middle_is_symmetric():
    world = cross(0.066, profile=SHORT, n=1)
    trace = throw(world, {"b0": (-0.5, 0.0)}, {"b0": rolling(2.0, 0.0)})
    assert set(felled(trace)) >= {"h", "c", "f"}
    assert ("l" in felled(trace)) == ("r" in felled(trace))
    assert trace.final["b0"][1] == 0.0


def test_balls_of_two_sizes_meet_pins_where_their_own_radius_says():
    world = with_pins({"a": (0.0, 0.0)}, profile=SHORT, n=2)
    large = Ball(BallId("b1"), 1.2 * R, 0.3)
    world = replace(world, balls=(world.balls[0], large))
    trace = throw(world, {"b1": (-0.4, 0.0)}, {"b1": ((1.0, 0.0), STILL)})
    (event,) = [one for one in trace.events() if isinstance(one, PinToppled)]
    place = trace.positions([event.time])[0, 0]
    assert hypot(place[0], place[1]) == pytest.approx(meeting(SHORT, 1.2 * R)[0], abs=1e-9)


@pytest.mark.parametrize("turn", [0.0, 0.3, pi / 2, 2.4])
def test_a_hard_driven_pin_stays_on_the_bed(turn):
    world = with_pins({"a": (0.3 * cos(turn), 0.3 * sin(turn))}, n=1)
    start = {"b0": (0.1 * cos(turn), 0.1 * sin(turn))}
    trace = throw(world, start, {"b0": rolling(9.0 * cos(turn), 9.0 * sin(turn))})
    lying = trace.pins.stances(inf)["a"]
    head = [lying.foot[k] + 0.12 * lying.way[k] for k in (0, 1)]
    assert abs(head[0]) <= world.table.length / 2
    assert abs(head[1]) <= world.table.width / 2


def flying(profile=TALL):
    world = with_pins({"a": (0.0, 0.0), "b": (0.09, 0.0)}, profile, n=1)
    return replace(world, models=replace(world.models, flight="ballistic"))


@pytest.mark.parametrize("speed", [2.0, 3.5, 5.0, 7.0])
@pytest.mark.parametrize("elevation", [0.15, 0.3, 0.6, 1.0])
@pytest.mark.parametrize("profile", [TALL, SHORT])
def test_a_flying_ball_fells_the_pins_it_meets_and_clears_those_it_passes_over(
    speed, elevation, profile
):
    world = flying(profile)
    layout = {"b0": (-0.25, 0.001)}
    trace = simulate(world, layout, "b0", Strike(speed, 0.0, elevation))
    assert not examine(trace, world).faults()
    down = {one.pin: one.time for one in trace.events() if isinstance(one, PinToppled)}
    for pin in world.table.pins:
        first = min((one.time for one in trace.events()), default=0.0)
        times = np.linspace(0.0, down.get(pin.id, max(first, 0.4)), 4000)
        x, y, z = trace.positions(times)[:, 0].T
        away = np.hypot(x - pin.at[0], y - pin.at[1]) - (meeting(profile, R)[0] - R)
        over = np.maximum(z - max(pin.height, R), 0.0)
        assert (np.hypot(np.maximum(away, 0.0), over) > R - 1e-6).all()


def test_a_ball_that_comes_down_on_a_pin_fells_it_and_stays_in_the_game():
    world = flying()
    felled_from_above = 0
    for speed in np.linspace(1.2, 3.0, 60):
        trace = simulate(world, {"b0": (-0.3, 0.0)}, "b0", Strike(float(speed), 0.0, 1.0))
        assert not examine(trace, world).faults()
        for one in trace.events():
            if isinstance(one, PinToppled):
                felled_from_above += trace.positions([one.time])[0, 0, 2] > 0.1
        assert "b0" in trace.final
    assert felled_from_above


def test_a_pin_felled_by_another_ball_is_out_of_the_way_of_a_flying_one():
    world = replace(with_pins({"a": (0.0, 0.0)}, n=2))
    world = replace(world, models=replace(world.models, flight="ballistic"))
    layout = {"b0": (-0.45, 0.0), "b1": (0.0, -0.09)}
    alone = simulate(world, layout, "b0", Strike(4.0, 0.0, 0.2))
    assert [one.by for one in alone.events() if isinstance(one, PinToppled)] == [("b0",)]
    chunked, until = Simulation(world, layout, "b0", Strike(4.0, 0.0, 0.2)), 0.0
    while not chunked.finished:
        until += 1 / 300
        chunked.advance(until)
    assert chunked.trace().hash() == alone.hash()


@pytest.mark.parametrize("profile", [TALL, SHORT])
def test_a_pin_that_stands_is_met_by_whatever_ball_lies_beside_it(profile):
    small, large = Ball(BallId("b0"), 0.024, 0.1), Ball(BallId("b1"), 0.034, 0.28)
    world = replace(with_pins({"a": (0.0, 0.0)}, profile, n=2), balls=(small, large))
    stood = 0
    for away in np.linspace(0.02, 0.04, 60):
        layout = {"b0": (-float(away), 0.0), "b1": (1.0, 0.4)}
        trace = simulate(world, layout, "b0", Strike(1.0, 0.0))
        there = bool(trace.pins.standing)
        stood += there
        assert ("a" in felled(trace)) == there
    assert 10 < stood < 50
