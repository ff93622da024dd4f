from math import hypot, radians

import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.app.stroke import FASTEST, SLOWEST, STEEPEST, Stroke, heading_to, miscue_limit


@given(st.floats(-3, 3), st.floats(-3, 3), st.floats(0.1, 0.9))
def test_the_tip_never_leaves_the_miscue_limit(side, follow, limit):
    stroke = Stroke().tipped(side, follow, limit)
    assert hypot(stroke.side, stroke.follow) <= limit + 1e-3


def test_the_miscue_limit_of_the_usual_tip_is_half_a_radius():
    assert miscue_limit(0.6) == pytest.approx(0.5145, abs=1e-4)
    assert miscue_limit(0.0) == 0.0


@given(st.integers(-100000, 100000))
def test_fine_turns_there_and_back_lead_to_the_same_heading(steps):
    stroke = Stroke(heading=12.34)
    assert stroke.turned(steps * 0.01).turned(-steps * 0.01) == stroke


@given(st.floats(-1000, 1000))
def test_a_heading_stays_within_half_a_turn(heading):
    assert -180.0 <= Stroke().headed(heading).heading <= 180.0


def test_speed_and_elevation_stay_within_reason():
    assert Stroke().at(-1.0).speed == SLOWEST
    assert Stroke().at(99.0).speed == FASTEST
    assert Stroke().raised(95.0).elevation == STEEPEST
    assert Stroke().raised(-5.0).elevation == 0.0


def test_a_stroke_is_handed_to_the_physics_in_radians():
    strike = Stroke(90.0, 2.5, 10.0, 0.1, -0.2).strike()
    assert (strike.heading, strike.elevation) == (radians(90.0), radians(10.0))
    assert (strike.speed, strike.side, strike.follow) == (2.5, 0.1, -0.2)


def test_heading_to_counts_counter_clockwise_from_the_foot():
    assert heading_to((0.0, 0.0), (0.0, 1.0)) == pytest.approx(90.0)
    assert heading_to((1.0, 1.0), (0.0, 1.0)) == pytest.approx(180.0)
