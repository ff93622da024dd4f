"""Ball and nose: group E, with the nose along X and the bed at Y < 0."""

from math import cos, degrees, radians, sin, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from physics_cases import NOSE, REACH, M, R, make_world, throw
from test_physics_collide import ball, energy

from engine.physics.events import CushionHit
from engine.physics.pack import nose_reach, pack_rubber, pack_world
from engine.physics.rebound import bounce
from engine.physics.state import REACH as REACH_COLUMN
from engine.physics.state import VX, VY, WX, WY, WZ
from engine.physics.world import Rubber


def hit(v, w=(0.0, 0.0, 0.0), rubber=None, model="han-2005", into=(0.0, 1.0)):
    row = ball(v, w)
    row[REACH_COLUMN] = REACH
    rubber = rubber or Rubber(0.85, 0.0, 0.0, 0.2)
    world = make_world(rubber=rubber, ball_cushion=model)
    bounce(row, pack_world(world), pack_rubber(world), *into)
    return row


def scaled(row):
    return [row[VX], row[VY], R * row[WX], R * row[WY], R * row[WZ]]


def test_contact_distance():
    assert nose_reach(R, NOSE) == pytest.approx(0.027513734, abs=1e-9)
    assert nose_reach(0.02625, 0.03675) == pytest.approx(0.02625 * sqrt(1 - 0.16), abs=1e-15)
    with pytest.raises(ValueError, match="never meets"):
        nose_reach(0.02, 0.05)


def test_frictionless_limits():
    smooth = Rubber(0.85, 0.0, 0.0, 0.0)
    assert hit((0.0, 1.0), rubber=smooth)[VY] == pytest.approx(-0.715135, abs=1e-9)
    plain = hit((0.5, 0.866), rubber=smooth, model="restitution")
    assert plain[VY] == pytest.approx(-0.85 * 0.866, abs=1e-12)
    assert plain[VX] == 0.5


GRID = {
    (15, "stun"): (0.87395975, -0.18688698, 0.016633509, -0.062077102, 0.22137622),
    (15, "roll"): (0.87686125, -0.19153405, -0.19915709, 0.90580723, 0.21439188),
    (15, "run"): (0.88156005, -0.19513675, -0.16579876, 0.90897893, 0.70308114),
    (15, "rev"): (0.87538056, -0.18979493, -0.21526002, 0.90480777, -0.28204389),
    (30, "stun"): (0.69002185, -0.36497528, 0.068590596, -0.1188024, 0.42366709),
    (30, "roll"): (0.71176103, -0.38161494, -0.27733855, 0.76189695, 0.37133762),
    (30, "run"): (0.74174585, -0.39202249, -0.18097228, 0.7821367, 0.79915963),
    (30, "rev"): (0.70072643, -0.37548998, -0.33405108, 0.7544486, -0.10210045),
    (45, "stun"): (0.50507627, -0.52040483, 0.13637059, -0.13637059, 0.4863179),
    (45, "roll"): (0.52897762, -0.55377168, -0.26178388, 0.5868696, 0.42878375),
    (45, "run"): (0.60109574, -0.56737736, -0.13580534, 0.63554933, 0.75518457),
    (45, "rev"): (0.49598872, -0.54278503, -0.36351218, 0.56460209, 0.0081930051),
    (60, "stun"): (0.35714286, -0.63736315, 0.16701919, -0.096428571, 0.34387869),
    (60, "roll"): (0.34573562, -0.69146739, -0.19804106, 0.39587155, 0.37133762),
    (75, "run"): (0.30133436, -0.78296769, -0.11221916, 0.28751689, 0.39765922),
    (75, "rev"): (0.069183609, -0.76829845, -0.24804542, 0.13081513, -0.043518908),
    (90, "stun"): (0.0, -0.73596357, 0.19285714, 0.0, 0.0),
    (90, "roll"): (0.0, -0.81132475, -0.1093542, 0.0, 0.0),
    (90, "run"): (0.12628111, -0.80507908, -0.16718447, 0.085239747, 0.19602233),
    (90, "rev"): (-0.12628111, -0.80507908, -0.16718447, -0.085239747, -0.19602233),
}


@pytest.mark.parametrize(("case", "expected"), GRID.items())
def test_han_grid(case, expected):
    angle, kind = case
    v = (cos(radians(angle)), sin(radians(angle)))
    roll = 0.0 if kind == "stun" else 1.0
    side = {"run": 0.5, "rev": -0.5}.get(kind, 0.0)
    w = (-roll * v[1] / R, roll * v[0] / R, side / R)
    assert scaled(hit(v, w)) == pytest.approx(expected, abs=6e-9)


@pytest.mark.parametrize("into", [(1.0, 0.0), (0.0, -1.0), (0.6, 0.8)])
def test_rebound_does_not_depend_on_where_the_nose_lies(into):
    ix, iy = into
    v, w = (0.7, 0.6), (10.0, -20.0, 30.0)

    def turned(x, y):
        return x * iy + y * ix, -x * ix + y * iy

    base = hit(v, w)
    there = hit(turned(*v), (*turned(*w[:2]), w[2]), into=into)
    assert there[[VX, VY]] == pytest.approx(turned(base[VX], base[VY]), abs=1e-12)
    assert there[[WX, WY]] == pytest.approx(turned(base[WX], base[WY]), abs=1e-10)
    assert there[WZ] == pytest.approx(base[WZ], abs=1e-10)


speeds = st.floats(-8.0, 8.0)
turns = st.floats(-250.0, 250.0)


@settings(max_examples=300, deadline=None)
@given(
    speeds,
    st.floats(2e-3, 8.0),
    turns,
    turns,
    turns,
    st.sampled_from(["restitution", "han-2005", "mathavan-2010"]),
)
def test_no_gain_mirror_and_scale(vx, vy, wx, wy, wz, model):
    start = ball((vx, vy), (wx, wy, wz))
    row = hit((vx, vy), (wx, wy, wz), model=model)
    assert energy(row) <= energy(start) + 1e-12
    assert row[VY] <= 1e-12
    mirrored = hit((-vx, vy), (wx, -wy, -wz), model=model)
    assert scaled(mirrored) == pytest.approx(np.array(scaled(row)) * [-1, 1, 1, -1, -1], abs=1e-12)
    doubled = hit((2 * vx, 2 * vy), (2 * wx, 2 * wy, 2 * wz), model=model)
    assert scaled(doubled) == pytest.approx(2 * np.array(scaled(row)), abs=1e-9)


def test_roll_reaches_the_nose_at_reach_not_at_radius():
    world = make_world(1, rubber=Rubber(0.85, 0.0, 0.0, 0.2))
    trace = throw(world, {"b0": (0.0, 0.0)}, {"b0": ((0.0, 1.0), (-1.0 / R, 0.0, 0.0))})
    event = next(e for e in trace.events() if isinstance(e, CushionHit))
    assert event.cushion == "left"
    assert event.time == pytest.approx(0.62675412, abs=1e-8)
    assert trace.positions([event.time])[0, 0, 1] == pytest.approx(0.60748627, abs=1e-8)


@pytest.mark.parametrize(("angle", "expected"), [(30, 35.817526), (60, 65.208719)])
def test_rebound_angle_by_restitution_alone(angle, expected):
    v = (sin(radians(angle)), cos(radians(angle)))
    row = hit(v, rubber=Rubber(0.8, 0.0, 0.0, 0.0), model="restitution")
    assert degrees(np.arctan2(row[VX], -row[VY])) == pytest.approx(expected, abs=1e-6)
    assert energy(row) < M
