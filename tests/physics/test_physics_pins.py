"""Closes the hole between the law of standing pins and what a blow does to them."""

from __future__ import annotations

from dataclasses import replace
from math import asin, cos, hypot, inf, radians, sin, sqrt

import numpy as np
import pytest

from engine.physics.pins import (
    LYING,
    aim,
    body_of,
    energy_given,
    knock,
    lies_at,
    meets_at,
    rate_at,
    rests_at,
    slid,
    speed_at,
    start_fall,
    strike_pin,
    tilt_at,
    tip_end,
)
from engine.table.furniture import Pin, PinId
from engine.table.pin import meeting, solid_of

G = 9.81
SHORT = ((0.0, 0.0035), (0.013, 0.005), (0.025, 0.003))
TALL = ((0.0, 0.007), (0.036, 0.010), (0.12, 0.0055))
CAPPED = ((0.0, 0.004), (0.03, 0.004), (0.04, 0.015))
MASS = {SHORT: 0.0018, TALL: 0.0105, CAPPED: 0.02}
BALL, RADIUS = 0.21, 0.03075


def body(profile=TALL, at=(0.0, 0.0), **changes):
    return body_of(Pin(PinId("a"), at, profile, MASS[profile], **changes), RADIUS, G)


def test_a_rod_and_a_cone_have_the_weight_they_have_in_books():
    rod = solid_of(((0.0, 0.01), (0.05, 0.01), (0.1, 0.01)))
    assert rod.centre == pytest.approx(0.05)
    assert rod.spread == pytest.approx(0.1**2 / 12 + 0.01**2 / 4)
    cone = solid_of(((0.0, 0.04), (0.03, 0.02), (0.06, 1e-12)))
    assert cone.centre == pytest.approx(0.06 / 4)
    assert cone.spread == pytest.approx(3 / 80 * (0.06**2 + 4 * 0.04**2))


@pytest.mark.parametrize("profile", [SHORT, TALL, CAPPED])
@pytest.mark.parametrize("radius", [0.0238, 0.03075, 0.034])
def test_ball_and_pin_touch_where_a_fine_search_finds_it(profile, radius):
    heights = np.linspace(0.0, min(profile[-1][0], 2 * radius), 400001)
    radii = np.interp(heights, *zip(*profile, strict=True))
    wide = radii + np.sqrt(np.maximum(radius**2 - (radius - heights) ** 2, 0.0))
    distance, level = meeting(profile, radius)
    assert distance == pytest.approx(wide.max(), abs=1e-8)
    assert level == pytest.approx(heights[wide.argmax()], abs=3e-4)


def test_a_pin_goes_over_exactly_where_the_ball_can_lift_it_onto_its_edge():
    one = body()
    rise = MASS[TALL] * G * (hypot(0.007, one.centre) - one.centre)
    assert one.climb == pytest.approx(rise)
    least = sqrt(2 * rise / BALL)
    assert strike_pin(one, BALL, least * (1 - 1e-9), one.level) is None
    assert strike_pin(one, BALL, least * (1 + 1e-9), one.level) is not None


def test_a_threshold_that_is_given_counts():
    given = body(threshold=0.01)
    assert given.climb == pytest.approx((0.01 * given.level) ** 2 / (2 * given.swing))
    easy, hard = body(threshold=1e-4), body(threshold=1e-2)
    assert strike_pin(easy, BALL, 0.02, easy.level)
    assert strike_pin(hard, BALL, 0.02, hard.level) is None


@pytest.mark.parametrize("profile", [SHORT, TALL, CAPPED])
@pytest.mark.parametrize("restitution", [0.0, 0.5, 1.0])
@pytest.mark.parametrize("mass", [0.001, 0.0105, 0.21, 0.3])
def test_a_pin_never_has_more_energy_than_its_striker_lost(profile, restitution, mass):
    one = body(profile, restitution=restitution)
    felled = 0
    for speed in np.geomspace(1e-4, 12.0, 300):
        for height in (0.2, 0.5, 1.0):
            blow = strike_pin(one, mass, float(speed), height * one.height)
            if blow is None:
                continue
            felled += 1
            lost = blow.impulse * speed - blow.impulse**2 / (2 * mass)
            assert energy_given(one, blow) <= lost * (1 + 1e-12)
            assert energy_given(one, blow) >= one.climb * (1 - 1e-12)
            assert blow.impulse >= one.mass * blow.speed
    assert felled > 100


def test_a_mere_push_takes_just_what_fells_the_pin():
    one = body()
    blow = strike_pin(one, BALL, 0.04, one.level)
    after = 0.04 - blow.impulse / BALL
    assert BALL / 2 * (0.04**2 - after**2) == pytest.approx(one.climb)
    assert blow.speed == 0.0


def test_a_hard_blow_is_that_on_a_free_body():
    one = body(restitution=0.5)
    blow = strike_pin(one, BALL, 5.0, one.level)
    free = 1 / (1 / one.mass + (one.level - one.centre) ** 2 / one.inertia)
    assert blow.impulse == pytest.approx(1.5 * 5.0 * BALL * free / (BALL + free))


def fall_of(one, speed, way=(1.0, 0.0), room=inf):
    return start_fall(one, 0, 0.0, way, strike_pin(one, BALL, speed, one.level), room)


@pytest.mark.parametrize("profile", [SHORT, TALL])
@pytest.mark.parametrize("speed", [0.03, 0.3, 3.0])
def test_a_felled_pin_goes_on_falling_until_it_lies(profile, speed):
    one = body(profile)
    fall = fall_of(one, speed)
    times = np.linspace(0.0, rests_at(one, fall) + 0.1, 500)
    tilts = [tilt_at(one, fall, t) for t in times]
    assert tilts[0] == 0.0
    assert (np.diff(tilts) >= 0.0).all()
    assert tilts[-1] == LYING
    lies = lies_at(one, fall)
    assert tilt_at(one, fall, lies * (1 - 1e-6)) < LYING
    assert tilt_at(one, fall, lies) == pytest.approx(LYING)
    ends = [tip_end(one, fall, t) for t in times]
    assert (np.diff(ends) >= 0.0).all()


@pytest.mark.parametrize("speed", [0.1, 0.3, 1.0])
def test_the_time_of_a_fall_is_near_that_of_the_whole_law(speed):
    """Integrated finely: I x'' = m g l sin x about the edge of the foot."""
    one = body()
    fall = fall_of(one, speed)
    x, rate, t, step = -one.lean, fall.rate, 0.0, 1e-5
    while x < LYING - one.lean:
        rate += step * one.growth**2 * sin(x)
        x += step * rate
        t += step
    assert lies_at(one, fall) <= t
    assert lies_at(one, fall) == pytest.approx(t, rel=0.08)
    half = one.lean + asin(0.5)
    when = next(s for s in np.arange(0.0, 1.0, 1e-4) if tilt_at(one, fall, s) >= half)
    gained = 2 * one.growth**2 * (cos(one.lean) - cos(half - one.lean))
    assert rate_at(one, fall, when) == pytest.approx(sqrt(fall.rate**2 + gained), rel=1e-2)


def test_a_sliding_pin_stops_as_friction_says_and_no_farther_than_its_room():
    one = body(friction=0.4)
    fall = fall_of(one, 2.0)
    stop = fall.speed / (0.4 * G)
    assert slid(one, fall, stop + 1.0) == pytest.approx(fall.speed**2 / (2 * 0.4 * G))
    assert speed_at(one, fall, stop / 2) == pytest.approx(fall.speed / 2)
    short = replace(fall, room=0.01)
    assert slid(one, short, 9.0) == 0.01
    assert speed_at(one, short, 9.0) == 0.0


def test_a_tall_pin_reaches_its_neighbour_and_a_short_one_pushed_over_does_not():
    tall, beside = body(), body(at=(0.082, 0.0))
    met = aim(tall, fall_of(tall, 0.03), beside)
    assert met.far == pytest.approx(0.082 - 0.02)
    assert meets_at(tall, fall_of(tall, 0.03), met.far) < lies_at(tall, fall_of(tall, 0.03))
    short, away = body(SHORT), body(SHORT, at=(0.07, 0.0))
    gentle, hard = fall_of(short, 0.1), fall_of(short, 6.0)
    far = aim(short, gentle, away).far
    assert meets_at(short, gentle, far) == inf
    assert meets_at(short, hard, far) < 0.1


def test_a_pin_beside_or_behind_a_fall_is_not_met():
    one = body()
    fall = fall_of(one, 1.0, (cos(0.5), sin(0.5)))
    assert aim(one, fall, body(at=(-0.08, 0.0))) is None
    wide = 0.1 * sin(0.5)
    assert wide > 0.02
    assert aim(one, fall, body(at=(0.1, 0.0))) is None
    assert aim(one, fall, body(at=(0.1 * cos(0.4), 0.1 * sin(0.4)))) is not None


def test_what_a_falling_pin_gives_it_loses_and_the_push_goes_from_end_to_axis():
    one, other = body(), body(at=(0.08, 0.006))
    fall = fall_of(one, 1.5)
    met = aim(one, fall, other)
    assert hypot(*met.push) == pytest.approx(1.0)
    assert met.push[1] == pytest.approx(0.006 / 0.02)
    time = meets_at(one, fall, met.far)
    blow, after = knock(one, fall, other, met, time)
    before = one.mass * speed_at(one, fall, time)
    assert one.mass * after.speed == pytest.approx(max(before - blow.impulse * met.push[0], 0.0))
    turning = one.swing * rate_at(one, fall, time) ** 2 / 2
    had = turning + one.mass * speed_at(one, fall, time) ** 2 / 2
    has = one.swing * after.rate**2 / 2 + one.mass * after.speed**2 / 2
    assert energy_given(other, blow) <= had - has + 1e-12
    assert tilt_at(one, after, time) == pytest.approx(tilt_at(one, fall, time))


@pytest.mark.parametrize("turn", [30, 90, 141])
def test_a_turned_fall_is_the_same_fall_turned(turn):
    c, s = cos(radians(turn)), sin(radians(turn))
    one, other = body(), body(at=(0.08, 0.006))
    there = body(at=(0.08 * c - 0.006 * s, 0.08 * s + 0.006 * c))
    straight = aim(one, fall_of(one, 1.0), other)
    turned = aim(one, fall_of(one, 1.0, (c, s)), there)
    assert turned.far == pytest.approx(straight.far)
    x, y = straight.push
    assert turned.push == pytest.approx((c * x - s * y, s * x + c * y))
