"""The nose model `mathavan-2010`: published figures, a fine integration, and its limits."""

from math import cos, radians, sin, sqrt

import numpy as np
import pytest
from physics_cases import REACH, R, make_world
from test_physics_collide import ball, energy

from engine.physics.mathavan import mathavan
from engine.physics.pack import nose_reach, pack_rubber, pack_world
from engine.physics.rebound import bounce
from engine.physics.state import G_NOSE, SLIDING, VX, VY, WX, WY, WZ
from engine.physics.state import REACH as REACH_COLUMN
from engine.physics.world import Rubber

GRID = {
    (0.98, 0.14, 15, "stun"): (0.86366978, -0.25047929, 4.0365929e-05, 0.020672744, 0.17814233),
    (0.98, 0.14, 15, "roll"): (0.89087501, -0.25264779, -0.155528, 0.91097478, 0.18391245),
    (0.98, 0.14, 15, "run"): (0.893673, -0.25213838, -0.13921984, 0.91313745, 0.6769695),
    (0.98, 0.14, 15, "rev"): (0.88992906, -0.25290956, -0.16305618, 0.91023789, -0.31373592),
    (0.98, 0.14, 30, "stun"): (0.67282684, -0.47606181, -0.003427687, 0.035289419, 0.33943253),
    (0.98, 0.14, 30, "roll"): (0.73159279, -0.48651578, -0.24650364, 0.76799635, 0.32912431),
    (0.98, 0.14, 30, "run"): (0.75050419, -0.48567873, -0.18954278, 0.7823289, 0.78241341),
    (0.98, 0.14, 30, "rev"): (0.72508167, -0.48729442, -0.27586608, 0.76299685, -0.15474416),
    (0.98, 0.14, 45, "stun"): (0.4583669, -0.65486001, -0.047188301, 0.048247851, 0.43488068),
    (0.98, 0.14, 45, "roll"): (0.54215046, -0.68687582, -0.2718637, 0.58755057, 0.40329975),
    (0.98, 0.14, 45, "run"): (0.59527334, -0.68681009, -0.18209832, 0.62694705, 0.77274219),
    (0.98, 0.14, 45, "rev"): (0.52122244, -0.68769742, -0.33286093, 0.57170458, -0.04501964),
    (0.98, 0.14, 60, "stun"): (0.29484249, -0.78101958, -0.13680922, 0.078620855, 0.32924738),
    (0.98, 0.14, 60, "roll"): (0.34388883, -0.84139288, -0.24605834, 0.38776585, 0.38098341),
    (0.98, 0.14, 60, "run"): (0.45668941, -0.83226301, -0.2139247, 0.46878844, 0.60575392),
    (0.98, 0.14, 60, "rev"): (0.29689026, -0.84126515, -0.33560934, 0.35276127, -0.003396766),
    (0.98, 0.14, 75, "stun"): (0.14280206, -0.86243854, -0.16588984, 0.068670423, 0.16783492),
    (0.98, 0.14, 75, "roll"): (0.16607287, -0.93122282, -0.24102968, 0.19213801, 0.22634532),
    (0.98, 0.14, 75, "run"): (0.30189123, -0.92805022, -0.23834551, 0.28986415, 0.39482413),
    (0.98, 0.14, 75, "rev"): (0.071391223, -0.93832327, -0.29501732, 0.12379888, -0.042383783),
    (0.98, 0.14, 90, "stun"): (
        2.7652043e-17,
        -0.88976573,
        -0.15558487,
        3.3513649e-17,
        3.8239263e-17,
    ),
    (0.98, 0.14, 90, "roll"): (
        -1.003386e-15,
        -0.95992541,
        -0.24559189,
        3.0042031e-15,
        -2.1336446e-16,
    ),
    (0.98, 0.14, 90, "run"): (0.13554047, -0.96846775, -0.25082124, 0.09713694, 0.16945224),
    (0.98, 0.14, 90, "rev"): (-0.13554047, -0.96846775, -0.25082124, -0.09713694, -0.16945224),
    (0.85, 0.2, 15, "stun"): (0.84084162, -0.21720386, -0.0006230291, -0.00068545151, 0.23760358),
    (0.85, 0.2, 15, "roll"): (0.86651809, -0.21886599, -0.15014781, 0.89323008, 0.2435317),
    (0.85, 0.2, 15, "run"): (0.87084837, -0.218314, -0.12751136, 0.8966136, 0.73275887),
    (0.85, 0.2, 15, "rev"): (0.86501914, -0.2191584, -0.16058909, 0.89204818, -0.25273112),
    (0.85, 0.2, 30, "stun"): (0.62911221, -0.41133661, -0.015956997, -0.0021153076, 0.45064767),
    (0.85, 0.2, 30, "roll"): (0.69018874, -0.42115517, -0.21526975, 0.73819326, 0.43019676),
    (0.85, 0.2, 30, "run"): (0.7181876, -0.42028499, -0.13861372, 0.75952538, 0.86095474),
    (0.85, 0.2, 30, "rev"): (0.68025914, -0.42196296, -0.25592577, 0.7304974, -0.045148068),
    (0.85, 0.2, 45, "stun"): (0.44160259, -0.55563904, -0.14090805, 0.042718281, 0.47084795),
    (0.85, 0.2, 45, "roll"): (0.49574888, -0.59441695, -0.20092311, 0.55477246, 0.51610001),
    (0.85, 0.2, 45, "run"): (0.5897411, -0.58029991, -0.15668097, 0.62206939, 0.78692601),
    (0.85, 0.2, 45, "rev"): (0.46482295, -0.5952675, -0.28277033, 0.53124035, 0.092557898),
    (0.85, 0.2, 60, "stun"): (0.29533787, -0.67198367, -0.18143559, 0.078170515, 0.32864986),
    (0.85, 0.2, 60, "roll"): (0.32096194, -0.71595204, -0.19330705, 0.37078253, 0.43731496),
    (0.85, 0.2, 60, "run"): (0.45679435, -0.70112776, -0.18930449, 0.46848612, 0.60578423),
    (0.85, 0.2, 60, "rev"): (0.23957809, -0.72803869, -0.24950152, 0.31225093, 0.13594562),
    (0.85, 0.2, 75, "stun"): (0.14311027, -0.74060812, -0.19996419, 0.068058257, 0.16771487),
    (0.85, 0.2, 75, "roll"): (0.16630773, -0.78499039, -0.2119474, 0.19146333, 0.22641168),
    (0.85, 0.2, 75, "run"): (0.30178719, -0.78177464, -0.21107915, 0.29016401, 0.39479399),
    (0.85, 0.2, 75, "rev"): (0.030235261, -0.804161, -0.21292333, 0.094462665, 0.05786447),
    (0.85, 0.2, 90, "stun"): (
        -2.1832477e-16,
        -0.76345228,
        -0.20613211,
        7.2851644e-16,
        -2.2459464e-17,
    ),
    (0.85, 0.2, 90, "roll"): (
        -6.7781212e-16,
        -0.80841635,
        -0.21827241,
        2.0712679e-15,
        -1.231433e-16,
    ),
    (0.85, 0.2, 90, "run"): (0.1355646, -0.81677417, -0.22052902, 0.098460154, 0.16840329),
    (0.85, 0.2, 90, "rev"): (-0.1355646, -0.81677417, -0.22052902, -0.098460154, -0.16840329),
}


def hit(v, w, rubber, *, nose=None, sliding=0.2, radius=R):
    """R w and v after a hit on a nose along X, for a ball of any size."""
    world = make_world(rubber=rubber, ball_cushion="mathavan-2010")
    numbers = pack_world(world)
    row = ball(v, w)
    row[SLIDING] = sliding
    row[REACH_COLUMN] = REACH
    if nose is not None:
        numbers[G_NOSE] = nose
        row[REACH_COLUMN] = nose_reach(radius, nose)
    bounce(row, numbers, pack_rubber(world), 0.0, 1.0)
    return row


def scaled(row):
    return [row[VX], row[VY], R * row[WX], R * row[WY], R * row[WZ]]


@pytest.mark.parametrize(("case", "expected"), GRID.items())
def test_grid(case, expected):
    e, mu, angle, kind = case
    v = (cos(radians(angle)), sin(radians(angle)))
    roll = 0.0 if kind == "stun" else 1.0
    side = {"run": 0.5, "rev": -0.5}.get(kind, 0.0)
    w = (-roll * v[1] / R, roll * v[0] / R, side / R)
    assert scaled(hit(v, w, Rubber(e, 0.0, 0.0, mu))) == pytest.approx(expected, abs=5e-6)


@pytest.mark.parametrize("speed", [0.3, 1.0, 3.0])
def test_a_rolling_ball_keeps_nine_tenths_on_a_high_nose(speed):
    row = hit(
        (0.0, speed),
        (-speed / R, 0.0, 0.0),
        Rubber(0.98, 0.0, 0.0, 0.14),
        nose=1.4 * R,
        sliding=0.212,
    )
    assert -row[VY] / speed == pytest.approx(0.910657741751, abs=1e-5)
    assert R * row[WX] / speed == pytest.approx(-0.235172965212, abs=1e-5)


def test_without_friction_it_is_restitution():
    row = hit((0.4, 1.0), (0.0, 0.0, 0.0), Rubber(0.85, 0.0, 0.0, 0.0), sliding=0.0)
    assert row[[VX, VY]] == pytest.approx((0.4, -0.85), abs=1e-9)


def smoothed(start, rise, nose, bed, e, soft, steps=6000):
    """Midpoint rule with friction smoothed over slips of `soft`; rows are (5,) states at v_y = 1.

    Returns the states when e^2 of the work has been given back.
    """
    level = sqrt(1.0 - rise * rise)
    h = 3.0 / steps

    def rates(y):
        vx, vy, sx, sy, sz, _ = y
        a, b = vx + sy * rise - sz * level, sx - vy * rise
        c, d = vx - sy, vy + sx
        slip, slide = np.sqrt(a * a + b * b + soft**2), np.sqrt(c * c + d * d + soft**2)
        fx, ft = -nose * a / slip, -nose * b / slip
        pressed = bed * np.maximum(0.0, rise - ft * level)
        tx, ty = -pressed * c / slide, -pressed * d / slide
        return np.array(
            [
                fx + tx,
                ty - rise * ft - level,
                2.5 * (ft + ty),
                2.5 * (rise * fx - tx),
                -2.5 * level * fx,
                vy,
            ]
        )

    y = np.vstack([start.T, np.zeros(len(start))])
    top = np.zeros(len(start))
    out = np.full((5, len(start)), np.nan)
    for _ in range(steps):
        before = y
        y = y + h * rates(y + 0.5 * h * rates(y))
        top = np.maximum(top, y[5])
        goal = (1.0 - e * e) * top
        ends = np.isnan(out[0]) & (y[1] < 0.0) & (y[5] <= goal)
        part = np.where(ends, (before[5] - goal) / np.where(ends, before[5] - y[5], 1.0), 0.0)
        out = np.where(ends, before[:5] + part * (y[:5] - before[:5]), out)
    return out.T


@pytest.mark.parametrize(
    ("nose", "bed", "e", "rise"),
    [(0.14, 0.2, 0.9, 0.27), (0.2, 0.2, 0.7, 0.27), (0.5, 0.3, 0.85, 0.2), (0.14, 0.21, 0.98, 0.4)],
)
def test_any_hit_agrees_with_a_fine_integration(nose, bed, e, rise):
    rng = np.random.default_rng(5)
    start = rng.uniform(-2.0, 2.0, (60, 5))
    start[:20, 2], start[:20, 3] = -1.0, start[:20, 0]
    start[:, 1] = 1.0
    soft = [smoothed(start, rise, nose, bed, e, soft) for soft in (2e-3, 1e-3)]
    expected = 2.0 * soft[1] - soft[0]
    off = []
    for before, after in zip(start, expected, strict=True):
        row = ball(before[:2], before[2:] / R)
        row[SLIDING] = bed
        mathavan(row, (rise, sqrt(1.0 - rise * rise)), nose, 0.0, 1.0, e)
        off.append(np.abs(np.array(scaled(row)) - after).max())
    # where a slip nearly dies and turns, smoothing itself is off by more
    assert np.median(off) < 1e-5
    assert np.quantile(off, 0.9) < 3e-4
    assert max(off) < 3e-3


@pytest.mark.parametrize("friction", [0.3, 0.6, 1.0])
@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
def test_rough_noses_and_glancing_hits(friction, e):
    rubber = Rubber(e, 0.0, 0.0, friction)
    rng = np.random.default_rng(8)
    for _ in range(60):
        v = (rng.uniform(-9.0, 9.0), 10.0 ** rng.uniform(-2.9, 1.0))
        w = tuple(rng.uniform(-300.0, 300.0, 3))
        row = hit(v, w, rubber)
        assert np.isfinite(row).all()
        assert energy(row) <= energy(ball(v, w)) + 1e-12
        assert -v[1] - 9.0 * friction <= row[VY] <= 0.0
