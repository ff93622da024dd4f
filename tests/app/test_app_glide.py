"""The eye on its way from one view to another."""

from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.app.glide import Glide, between, eased, partly_turned
from engine.scene.camera import Camera, orbit

ABOVE = Camera((0.0, 0.0, 4.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0), 0.4)
LOW = Camera((-2.0, 0.3, 0.5), (0.4, 0.0, 0.0), field=0.8)


def test_it_begins_and_ends_where_it_should():
    assert between(ABOVE, LOW, 0.0) == ABOVE
    assert between(ABOVE, LOW, 1.0) == LOW


@given(st.floats(0.001, 0.999), st.floats(-pi, pi), st.floats(0.1, 1.5))
def test_on_its_way_the_camera_is_always_one_that_can_look(share, azimuth, elevation):
    there = orbit((0.1, 0.2, 0.0), azimuth, elevation, 3.0)
    basis = between(ABOVE, there, share).basis()
    assert basis @ basis.T == pytest.approx(np.eye(3), abs=1e-9)


def test_a_turn_goes_the_shorter_way_also_by_half_a_turn():
    one, two = np.eye(3), np.diag([-1.0, -1.0, 1.0])
    half = partly_turned(one, two, 0.5)
    assert np.linalg.det(half) == pytest.approx(1.0)
    assert half[2] == pytest.approx([0.0, 0.0, 1.0])
    assert abs(half[0, 1]) == pytest.approx(1.0)


def test_it_is_gentle_at_both_ends():
    assert eased(0.01) < 0.001
    assert eased(0.5) == pytest.approx(0.5)
    assert 1.0 - eased(0.99) < 0.001


def test_a_new_view_is_reached_in_its_time_and_nothing_lags_after_that():
    glide = Glide(0.4)
    assert glide.look(ABOVE, "above", 0.1) == ABOVE
    assert glide.look(LOW, "cue", 0.1) == ABOVE
    seen = [glide.look(LOW, "cue", 0.1) for _ in range(4)]
    assert ABOVE.eye[2] > seen[0].eye[2] > seen[1].eye[2] > seen[2].eye[2] > LOW.eye[2]
    assert seen[3] == LOW
    moved = orbit((0.0, 0.0, 0.0), 1.0, 0.5, 2.0)
    assert glide.look(moved, "cue", 0.01) == moved


def test_without_time_it_jumps():
    glide = Glide(0.0)
    glide.look(ABOVE, "above", 0.1)
    assert glide.look(LOW, "cue", 0.1) == LOW
