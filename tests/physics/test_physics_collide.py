"""Ball and ball: groups B and C of the closed forms, and invariants over random meetings."""

from math import cos, degrees, pi, radians, sin, tan

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from physics_cases import ALCIATORE, IDEAL, M, R, make_world

from engine.physics.collide import friction, strike_apart
from engine.physics.pack import pack_world
from engine.physics.state import BALL_WIDTH, MASS, RADIUS, SLIDING, VX, VY, WX, WY, WZ, X, Y
from engine.physics.world import Contact


def ball(v=(0.0, 0.0), w=(0.0, 0.0, 0.0), at=(0.0, 0.0), radius=R, mass=M):
    row = np.zeros(BALL_WIDTH)
    row[[X, Y]], row[[VX, VY]], row[[WX, WY, WZ]] = at, v, w
    row[RADIUS], row[MASS], row[SLIDING] = radius, mass, 0.2
    return row


def cut(v, phi, w=(0.0, 0.0, 0.0), contact=IDEAL, model="frictional"):
    """Ball one at speed v along +x, line of centres at angle phi (deg) below its way."""
    a = radians(phi)
    one, two = ball((v, 0.0), w), ball(at=(2 * R * cos(a), -2 * R * sin(a)))
    strike_apart(one, two, pack_world(make_world(contact=contact, ball_ball=model)))
    return one, two


def energy(*balls):
    return sum(
        0.5 * b[MASS] * (b[VX] ** 2 + b[VY] ** 2)
        + 0.2 * b[MASS] * b[RADIUS] ** 2 * (b[WX] ** 2 + b[WY] ** 2 + b[WZ] ** 2)
        for b in balls
    )


@pytest.mark.parametrize("phi", [10.0, 30.0, 45.0, 60.0])
@pytest.mark.parametrize("model", ["elastic", "frictional"])
def test_ninety_degree_rule(phi, model):
    one, two = cut(1.5, phi, model=model)
    assert np.hypot(*one[[VX, VY]]) == pytest.approx(1.5 * sin(radians(phi)), abs=1e-12)
    assert np.hypot(*two[[VX, VY]]) == pytest.approx(1.5 * cos(radians(phi)), abs=1e-12)
    assert one[[VX, VY]] @ two[[VX, VY]] == pytest.approx(0.0, abs=1e-12)


def test_unequal_masses():
    one, two = ball((1.0, 0.0), mass=0.2), ball(at=(2 * R, 0.0), mass=0.17)
    strike_apart(one, two, pack_world(make_world(contact=Contact(0.95, 0.0))))
    assert one[VX] == pytest.approx(0.10405405, abs=1e-8)
    assert two[VX] == pytest.approx(1.0540541, abs=1e-7)


@pytest.mark.parametrize(
    ("slip", "mu"),
    [(0.0, 0.117951), (0.5, 0.072636567), (1.0, 0.046335077), (5.0, 0.010419664)],
)
def test_friction_law(slip, mu):
    assert friction(pack_world(make_world()), slip) == pytest.approx(mu, abs=1e-9)


def throw_angle(v, phi, w=(0.0, 0.0, 0.0), e=1.0):
    contact = Contact(e, ALCIATORE.friction_floor, ALCIATORE.friction_rise, 1.088)
    _, two = cut(v, phi, w, contact)
    return degrees(np.arctan2(two[VY], two[VX])) + phi


@pytest.mark.parametrize(
    ("v", "phi", "expected"),
    [
        (0.447, 5, 0.71606717),
        (0.447, 30, 4.715004),
        (0.447, 45, 4.9451233),
        (1.341, 20, 2.9764565),
        (1.341, 30, 3.5491094),
        (1.341, 75, 2.0810474),
        (3.129, 15, 2.1921237),
        (3.129, 30, 1.6976316),
        (3.129, 60, 0.89451835),
    ],
)
def test_cut_induced_throw_of_a_stun_ball(v, phi, expected):
    assert throw_angle(v, phi) == pytest.approx(expected, abs=1e-4)


@pytest.mark.parametrize(
    ("v", "phi", "expected"),
    [
        (0.447, 15, 1.1321765),
        (0.447, 60, 3.7833214),
        (1.341, 30, 1.004218),
        (1.341, 45, 1.4200333),
        (3.129, 60, 0.6718018),
    ],
)
def test_throw_of_a_rolling_ball(v, phi, expected):
    assert throw_angle(v, phi, (0.0, v / R, 0.0)) == pytest.approx(expected, abs=1e-4)
    assert throw_angle(v, phi, (0.0, -v / R, 0.0)) == pytest.approx(expected, abs=1e-4)


@pytest.mark.parametrize("phi", [15, 30, 45, 60])
def test_gearing_spin_throws_nothing(phi):
    spin = -sin(radians(phi)) / R
    assert throw_angle(1.0, phi, (0.0, 0.0, spin)) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(
    ("v", "phi", "expected"),
    [
        (0.447, 10, 1.4799333),
        (0.447, 30, 4.8353354),
        (1.341, 30, 3.5491094),
        (3.129, 45, 1.1273127),
    ],
)
def test_throw_with_restitution(v, phi, expected):
    assert throw_angle(v, phi, e=0.95) == pytest.approx(expected, abs=1e-4)


def test_half_ball_throw_of_tp_a5():
    one, two = cut(1.0, 30, contact=Contact(0.94, 0.06))
    assert degrees(np.arctan2(two[VY], two[VX])) + 30 == pytest.approx(3.4336304, abs=1e-4)
    assert 60 - degrees(np.arctan2(one[VY], one[VX])) == pytest.approx(3.3072581, abs=1e-4)


def test_spin_transfer():
    one, two = cut(0.5, 0.0, (0.0, 0.0, 0.5 / R), ALCIATORE)
    assert R * two[WZ] == pytest.approx(-0.088525816, abs=1e-6)
    assert R * one[WZ] == pytest.approx(0.41147418, abs=1e-6)


def test_rolling_head_on_turns_the_object_ball_back():
    one, two = cut(1.0, 0.0, (0.0, 1.0 / R, 0.0), ALCIATORE)
    assert one[VX] == pytest.approx(0.025, abs=1e-9)
    assert two[VX] == pytest.approx(0.975, abs=1e-9)
    assert R * one[WY] == pytest.approx(0.88705825, abs=1e-6)
    assert R * two[WY] == pytest.approx(-0.11294175, abs=1e-6)


speeds = st.floats(-10.0, 10.0)
turns = st.floats(-300.0, 300.0)


@settings(max_examples=300, deadline=None)
@given(
    st.tuples(speeds, speeds),
    st.tuples(speeds, speeds),
    st.tuples(turns, turns, turns),
    st.tuples(turns, turns, turns),
    st.floats(0.0, 2 * pi),
    st.floats(0.02, 0.04),
    st.floats(0.1, 0.4),
)
def test_momentum_exact_energy_never_gained_and_order_free(v, u, w, q, angle, radius, mass):
    reach = 2.0 * np.sqrt(R * radius)
    at = (reach * cos(angle), reach * sin(angle))
    one, two = ball(v, w), ball(u, q, at, radius, mass)
    if (v[0] - u[0]) * at[0] + (v[1] - u[1]) * at[1] <= 0.0:
        return
    world = pack_world(make_world(contact=Contact(0.95, 0.01, 0.1, 1.0)))
    before = energy(one, two)
    px, py = M * v[0] + mass * u[0], M * v[1] + mass * u[1]
    swapped = one.copy(), two.copy()
    strike_apart(one, two, world)
    strike_apart(swapped[1], swapped[0], world)
    assert M * one[VX] + mass * two[VX] == pytest.approx(px, abs=1e-12)
    assert M * one[VY] + mass * two[VY] == pytest.approx(py, abs=1e-12)
    assert energy(one, two) <= before + 1e-12
    assert (one == swapped[0]).all()
    assert (two == swapped[1]).all()


def test_stick_limit_share():
    _, two = cut(0.3, 1.0, contact=Contact(1.0, 5.0))
    assert degrees(np.arctan2(two[VY], two[VX])) + 1.0 == pytest.approx(
        degrees(np.arctan(tan(radians(1.0)) / 7.0)), abs=1e-9
    )
