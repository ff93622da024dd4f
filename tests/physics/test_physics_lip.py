"""A pocket with lip and rim: what becomes of balls that come to it."""

from math import acos, cos, degrees, hypot, radians, sqrt

import numpy as np
import pytest
from physics_cases import CORNER, SIDE, R, make_world, throw

from engine.physics import entered, state
from engine.physics.entered import BACK, CAPTURED, OVER
from engine.physics.events import BallPocketed
from engine.physics.lip import fall, leaving_angle
from engine.table.build import PocketCut

G, HOLE = 9.81, 0.065


@pytest.mark.parametrize("rho", [R, 0.035])
@pytest.mark.parametrize("speed", [0.0, 0.1, 0.3, 0.5])
def test_a_rolling_ball_leaves_the_lip_where_nothing_presses(rho, speed):
    expected = acos((10.0 + 7.0 * speed**2 / (G * rho)) / 17.0)
    assert degrees(leaving_angle(speed, G, rho)) == pytest.approx(degrees(expected), abs=1e-9)


def test_at_once_from_the_speed_at_which_gravity_holds_it_no_more():
    assert leaving_angle(sqrt(G * R) * (1.0 + 1e-12), G, R) == 0.0
    assert 0.0 < leaving_angle(sqrt(G * R) * (1.0 - 1e-6), G, R) < 0.01


def enter(speed, *, beside=0.0, inside=0.0, rim=0.05, e=0.2, rolls=True, edge=0.0, half=60.0):
    """What comes of a ball that crosses the edge along +x, `beside` the middle (drop radii)."""
    hole = np.zeros(entered.HOLE)
    hole[[entered.H_RADIUS, entered.H_LIP, entered.H_RIM, entered.H_E, entered.H_RUB]] = (
        HOLE,
        edge,
        rim,
        e,
        0.2,
    )
    hole[[entered.H_BED_X, entered.H_BED_Y, entered.H_BED_COS]] = -1.0, 0.0, cos(radians(half))
    hole[[entered.H_BALL, entered.H_GRAVITY]] = R, G
    body = np.zeros(entered.BODY)
    y = beside * HOLE
    body[:3] = -sqrt((HOLE - inside) ** 2 - y * y), y, R
    body[entered.B_VX] = speed
    body[entered.B_WY] = speed / R if rolls else 0.0
    way, before = np.zeros((300, 1 + entered.BODY)), energy(body)
    outcome, time, count = fall(body, hole, way)
    assert energy(body) <= before
    assert way[count - 1, 0] == time
    assert (np.diff(way[:count, 0]) >= 0.0).all()
    return outcome, time, body


def energy(body):
    return 0.5 * (body[3:6] ** 2).sum() + 0.2 * R**2 * (body[6:] ** 2).sum() + G * body[entered.B_Z]


@pytest.mark.parametrize("speed", [1e-9, 1e-3, 0.05, 0.3, 0.6, 1.0, 1.5])
@pytest.mark.parametrize("rolls", [True, False])
@pytest.mark.parametrize("edge", [0.0, 0.004])
def test_a_slow_ball_falls_in(speed, rolls, edge):
    outcome, time, body = enter(speed, rolls=rolls, edge=edge)
    assert outcome == CAPTURED
    assert 0.05 < time < 3.0
    assert body[entered.B_Z] <= -R


def test_the_slower_the_longer():
    times = [enter(speed)[1] for speed in (1e-6, 1e-3, 0.03, 0.3)]
    assert times == sorted(times, reverse=True)


def test_one_that_cuts_the_edge_comes_back_up_and_goes_on():
    outcome, _, body = enter(1.0, beside=0.97, half=180.0)
    assert outcome == BACK
    assert body[entered.B_Z] == pytest.approx(R, abs=1e-9)
    assert body[entered.B_Y] > 0.9 * HOLE
    assert hypot(body[entered.B_VX], body[entered.B_VY]) == pytest.approx(1.0, abs=1e-9)
    assert abs(body[entered.B_VY]) < 0.1


def test_a_lively_pocket_spits_a_fast_ball_out():
    assert enter(6.0, e=0.8)[0] == BACK
    assert enter(2.0, e=0.0)[0] == CAPTURED


def test_a_fast_ball_leaps_over_a_low_rim():
    outcome, _, body = enter(6.0, rim=0.0)
    assert outcome == OVER
    assert body[entered.B_X] > 0.0


def test_a_hole_in_the_bed_is_crossed_by_a_fast_ball():
    outcome, _, body = enter(6.0, rim=0.0, half=180.0)
    assert outcome == BACK
    assert body[entered.B_X] > 0.9 * HOLE
    assert enter(0.5, rim=0.0, half=180.0)[0] == CAPTURED


def test_a_ball_at_rest_within_the_edge_falls():
    assert enter(0.0, inside=1e-9)[0] == CAPTURED
    assert enter(0.0, inside=0.01)[1] < enter(0.0, inside=1e-6)[1]


def pocketed(place, speed=(0.0, 0.0), **options):
    cut = {"rim": 0.05, "restitution": 0.2}
    corner, side = (
        PocketCut(one.mouth, one.angle, one.shelf, one.jaw_radius, one.radius, **cut)
        for one in (CORNER, SIDE)
    )
    world = make_world(2, pockets=True, cuts=(corner, side), pocket="rim-lip", **options)
    spin = (-speed[1] / R, speed[0] / R, 0.0)
    return world, throw(world, {"b0": place, "b1": (0.5, 0.5)}, {"b0": (speed, spin)})


def edge_of(world, offset):
    """A place on the bed side of the first pocket's edge, `offset` (m) outside it."""
    (x, y), radius = world.table.pockets[0].centre, world.table.pockets[0].radius
    return x - (radius + offset) * sqrt(0.5), y - (radius + offset) * sqrt(0.5)


def test_at_rest_a_nanometre_inside_falls_and_outside_stays():
    world, _ = pocketed((0.0, 0.0))
    _, out = pocketed(edge_of(world, 1e-9))
    assert not out.pocketed
    _, within = pocketed(edge_of(world, -1e-9))
    assert within.pocketed == {"b0": world.table.pockets[0].id}
    assert within.duration > 0.5


def test_a_shot_into_a_pocket_tells_when_the_ball_is_down():
    world, _ = pocketed((0.0, 0.0))
    _, trace = pocketed(edge_of(world, 0.3), (0.7, 0.7))
    (event,) = [one for one in trace.events() if isinstance(one, BallPocketed)]
    pocket = world.table.pockets[0]
    way = trace.positions(np.linspace(0.0, event.time, 50))[:, 0]
    assert way[-1, 2] == pytest.approx(-R, abs=2e-3)
    assert hypot(way[-1, 0] - pocket.centre[0], way[-1, 1] - pocket.centre[1]) < pocket.radius
    assert (np.diff(trace.pieces[trace.pieces[:, state.P_BALL] == 0][:, state.P_T0]) >= 0).all()


def test_chunks_of_time_change_no_bit():
    from engine.physics.simulate import Simulation, simulate
    from engine.physics.world import Strike

    world = make_world(3, pockets=True, pocket="rim-lip", ball_ball="mathavan-2014")
    layout = {"b0": (0.0, 0.0), "b1": (0.9, 0.42), "b2": (-0.5, 0.3)}
    strike = Strike(4.0, 0.44)
    shot = Simulation(world, layout, "b0", strike)
    time = 0.0
    while not shot.finished:
        time += 1.0 / 60.0
        shot.advance(time)
    assert shot.trace().hash() == simulate(world, layout, "b0", strike).hash()
