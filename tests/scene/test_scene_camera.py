"""The way from the world to the window and back."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine.scene.camera import Camera, ground_point, orbit, project, ray

SIZE = (1280, 720)
angles = st.floats(0.05, 1.5)


@given(st.floats(-3.0, 3.0), angles, st.floats(0.5, 6.0), st.floats(1, 1279), st.floats(1, 719))
@settings(max_examples=200, deadline=None)
def test_a_pixel_goes_to_the_cloth_and_back(azimuth, elevation, distance, x, y):
    camera = orbit((0.1, -0.2, 0.0), azimuth, elevation, distance)
    ground = ground_point(camera, SIZE, (x, y))
    if ground is None or math.hypot(*ground) > 50.0:
        return
    back = project(camera, SIZE, (*ground, 0.0))
    assert back == pytest.approx((x, y), abs=1e-6)


def test_the_target_is_in_the_middle():
    camera = Camera((1.0, 2.0, 3.0), (0.0, 0.5, 0.1))
    assert project(camera, SIZE, camera.target) == pytest.approx((640.0, 360.0))


def test_up_is_up_and_right_is_right():
    camera = Camera((-2.0, 0.0, 1.0), (0.0, 0.0, 0.0))
    x, y = project(camera, SIZE, (0.0, -0.5, 0.5))
    assert x > 640.0
    assert y < 360.0


def test_what_is_behind_has_no_pixel_and_the_sky_no_ground():
    camera = Camera((-2.0, 0.0, 1.0), (0.0, 0.0, 0.9))
    assert project(camera, SIZE, (-3.0, 0.0, 1.0)) is None
    assert ground_point(camera, SIZE, (640.0, 0.0)) is None


def test_the_basis_is_a_rotation_of_right_down_ahead():
    basis = orbit((0.0, 0.0, 0.0), 1.0, 0.5, 2.0).basis()
    assert basis @ basis.T == pytest.approx(np.eye(3), abs=1e-12)
    assert np.linalg.det(basis) == pytest.approx(1.0)


def test_rays_have_unit_length_and_lead_through_their_pixel():
    camera = orbit((0.0, 0.0, 0.0), 2.0, 0.4, 2.0)
    way = np.array(ray(camera, SIZE, (100.5, 650.25)))
    assert np.linalg.norm(way) == pytest.approx(1.0)
    point = np.array(camera.eye) + 1.7 * way
    assert project(camera, SIZE, tuple(point)) == pytest.approx((100.5, 650.25))


def test_a_camera_that_looks_nowhere_is_refused():
    with pytest.raises(ValueError, match="looks somewhere"):
        Camera((0.0, 0.0, 1.0), (0.0, 0.0, 1.0)).basis()
    with pytest.raises(ValueError, match="looks somewhere"):
        Camera((0.0, 0.0, 1.0), (0.0, 0.0, 0.0)).basis()
