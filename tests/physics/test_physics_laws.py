"""Restitution by speed and friction by incidence, as the models use them."""

from math import atan2, hypot

import numpy as np
import pytest
from physics_cases import M, R, make_world

from engine.physics import state
from engine.physics.pack import pack_rubber, pack_world
from engine.physics.rare import part, rebound
from engine.physics.world import Contact, Rubber

HAN = Rubber(0.39, -0.257, 0.0, 0.471, 0.044, 0.3, 0.241)


def row(v, at=(0.0, 0.0)):
    one = np.zeros(state.BALL_WIDTH)
    one[[state.VX, state.VY]], one[[state.X, state.Y]] = v, at
    one[state.RADIUS], one[state.MASS], one[state.REACH] = R, M, R
    one[state.SLIDING] = 0.2
    return one


@pytest.mark.parametrize("model", ["elastic", "frictional", "mathavan-2014"])
@pytest.mark.parametrize(("speed", "e"), [(0.5, 0.95), (1.0, 0.95), (3.0, 0.91), (60.0, 0.0)])
def test_balls_give_back_less_of_a_faster_blow(model, speed, e):
    contact = Contact(0.95, 0.0, restitution_slope=0.02, restitution_knee=1.0)
    one, two = row((speed, 0.0)), row((0.0, 0.0), (2.0 * R, 0.0))
    part(one, two, pack_world(make_world(2, contact=contact, ball_ball=model)))
    assert (two[state.VX] - one[state.VX]) / speed == pytest.approx(e, abs=1e-12)


def level(v, rubber, model):
    world = make_world(1, rubber=rubber, ball_cushion=model, nose=R)
    ball = row(v)
    ball[state.WZ] = -1000.0
    rebound(ball, pack_world(world), pack_rubber(world), 0.0, 1.0)
    return ball


@pytest.mark.parametrize("model", ["restitution", "han-2005", "stronge"])
@pytest.mark.parametrize(("speed", "e"), [(0.5, 0.5075), (2.0, 0.728), (3.0, 0.765), (9.0, 0.3)])
def test_rubber_by_the_square_of_speed_and_its_least(model, speed, e):
    ball = level((0.0, speed), HAN, model)
    assert -ball[state.VY] / speed == pytest.approx(e, abs=1e-12)


@pytest.mark.parametrize("model", ["han-2005", "stronge"])
@pytest.mark.parametrize("along", [0.0, 0.5, -1.5])
def test_friction_falls_with_the_incidence(model, along):
    ball = level((along, 1.0), HAN, model)
    mu = 0.471 - 0.241 * atan2(abs(along), 1.0)
    pushed = hypot(ball[state.VX] - along, 0.0) / (1.0 - ball[state.VY])
    assert pushed == pytest.approx(mu, abs=1e-12)
