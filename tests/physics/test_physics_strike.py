"""The cue: group F."""

from math import atan2, degrees, hypot, radians

import pytest
from physics_cases import M, R

from engine.physics.strike import miscue_limit, squirt_angle, strike_ball
from engine.physics.world import Ball, Cloth, Cue, Strike

CLOTH = Cloth(0.2, 0.01, 10.0)
BALL = Ball("b0", R, M)


def struck(strike, e=1.0, mass=3 * M, ratio=1e12, friction=0.9):
    return strike_ball(BALL, Cue(mass, e, friction, ratio), CLOTH, strike)


@pytest.mark.parametrize(
    ("follow", "e", "mass", "speed"),
    [(0.0, 1.0, 3 * M, 3.0), (0.5, 1.0, 3 * M, 2.0425532), (0.0, 0.73, 0.5386, 2.6295525)],
)
def test_ball_speed_from_cue_speed(follow, e, mass, speed):
    motion = struck(Strike(2.0, 0.0, follow=follow), e, mass)
    assert motion.velocity[0] == pytest.approx(speed, abs=1e-7)
    assert R * motion.spin[1] == pytest.approx(2.5 * follow * speed, abs=1e-6)


def test_elastic_strike_keeps_energy():
    motion = struck(Strike(2.0, 0.0, follow=0.4), mass=0.5386)
    v = motion.velocity[0]
    cue = 2.0 - M * v / 0.5386
    assert v == pytest.approx(2.3312561, abs=1e-7)
    assert cue == pytest.approx(1.2637585, abs=1e-7)
    total = 0.5 * 0.5386 * cue**2 + 0.5 * M * v**2 + 0.2 * M * (R * motion.spin[1]) ** 2
    assert total == pytest.approx(0.5 * 0.5386 * 4.0, rel=1e-12)


@pytest.mark.parametrize(
    ("ratio", "side", "expected"),
    [(12, 0.1, 0.92089938), (15, 0.5, 3.4656693), (30, 0.25, 1.0397434), (50, 0.5, 1.1728763)],
)
def test_squirt(ratio, side, expected):
    assert degrees(squirt_angle(side, ratio)) == pytest.approx(expected, abs=1e-6)
    assert squirt_angle(-side, ratio) == -squirt_angle(side, ratio)
    motion = struck(Strike(2.0, 0.3, side=side), ratio=ratio)
    assert degrees(atan2(motion.velocity[1], motion.velocity[0]) - 0.3) == pytest.approx(expected)


def test_raised_cue_before_the_bed_answers():
    cloth = Cloth(1e-300, 0.01, 10.0)
    cue = Cue(0.567, 1.0, 0.9, 1e12)
    motion = strike_ball(BALL, cue, cloth, Strike(3.0, 0.0, radians(20), 0.3, -0.2))
    assert motion.velocity == pytest.approx((3.4696456, 0.0), abs=1e-6)
    assert motion.spin == pytest.approx((33.145609, -64.607519, 91.066813), abs=1e-4)


@pytest.mark.parametrize(
    ("elevation", "side", "follow", "expected"),
    [
        (20, 0.3, 0.0, -6.2315003),
        (60, 0.35, -0.2, -45.295344),
        (80, 0.4, -0.1, -79.410192),
        (45, 0.3, -0.4, -34.634528),
    ],
)
def test_masse_aiming_rule_of_coriolis(elevation, side, follow, expected):
    motion = struck(Strike(3.0, 0.0, radians(elevation), side, follow))
    vx = 5.0 * motion.velocity[0] + 2.0 * R * motion.spin[1]
    vy = 5.0 * motion.velocity[1] - 2.0 * R * motion.spin[0]
    assert degrees(atan2(vy, vx)) == pytest.approx(expected, abs=1e-6)


def test_miscue_limit():
    assert miscue_limit(Cue(0.5, 0.7, 0.6, 25.0)) == pytest.approx(0.51449576, abs=1e-8)
    assert miscue_limit(Cue(0.5, 0.7, 0.7, 25.0)) == pytest.approx(0.57346234, abs=1e-8)


def test_beyond_the_limit_the_tip_slips():
    inside = struck(Strike(2.0, 0.0, side=0.51), ratio=25.0, friction=0.6)
    beyond = struck(Strike(2.0, 0.0, side=0.9), ratio=25.0, friction=0.6)
    assert hypot(*beyond.velocity) < hypot(*inside.velocity)
    assert atan2(beyond.velocity[1], beyond.velocity[0]) > radians(20)


@pytest.mark.parametrize(
    "strike",
    [
        Strike(-1.0, 0.0),
        Strike(float("nan"), 0.0),
        Strike(1.0, 0.0, side=0.8, follow=0.7),
        Strike(1.0, 0.0, elevation=2.0),
        Strike(1.0, 0.0, elevation=-0.1),
    ],
)
def test_impossible_strikes_are_refused(strike):
    with pytest.raises(ValueError, match=r"strike|tip|elevation"):
        struck(strike)
