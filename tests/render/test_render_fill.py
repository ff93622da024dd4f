"""The fill rule: every pixel inside an outline is hit once, by whatever triangles fill it."""

import numpy as np
import pytest

from engine.render import raster

WIDTH, HEIGHT = 160, 120


def hits(triangles):
    """Count how often each pixel is filled."""
    total = np.zeros((HEIGHT, WIDTH), int)
    for triangle in triangles:
        image = np.zeros((HEIGHT, WIDTH), np.uint32)
        corners = tuple(float(v) for c in triangle for v in np.round(np.array(c) * 256) / 256)
        raster.fill_flat(image, (0, 0, WIDTH, HEIGHT), corners, np.uint32(1), 1.0)
        total += image
    return total


@pytest.mark.parametrize("seed", range(6))
def test_a_fan_hits_each_pixel_of_its_square_once(seed):
    dice = np.random.default_rng(seed)
    middle = dice.uniform([20, 20], [140, 100])
    rim = [(-5, -5), (60, -5), (165, -5), (165, 50), (165, 125), (30, 125), (-5, 125), (-5, 33)]
    fan = [(middle, a, b) for a, b in zip(rim, [*rim[1:], rim[0]], strict=True)]
    assert (hits(fan) == 1).all()


@pytest.mark.parametrize("seed", range(4))
def test_a_crumpled_grid_hits_each_pixel_once(seed):
    dice = np.random.default_rng(seed)
    xs, ys = np.linspace(-1, WIDTH + 1, 14), np.linspace(-1, HEIGHT + 1, 11)
    grid = np.stack(np.meshgrid(xs, ys), axis=-1)
    grid[1:-1, 1:-1] += dice.uniform(-3, 3, grid[1:-1, 1:-1].shape)
    if seed == 0:
        grid = np.round(grid) + 0.5  # corners and edges right through the pixels' middles
    triangles = []
    for i in range(10):
        for j in range(13):
            a, b, c, d = grid[i, j], grid[i, j + 1], grid[i + 1, j + 1], grid[i + 1, j]
            triangles += [(a, b, c), (c, a, d)]
    count = hits(triangles)
    inside = count[2:-2, 2:-2]
    assert (inside == 1).all()


def test_a_band_of_rows_is_not_left():
    image = np.zeros((HEIGHT, WIDTH), np.uint32)
    corners = (-50.0, -50.0, 300.0, -20.0, 20.0, 400.0)
    raster.fill_flat(image, (0, 30, WIDTH, 50), corners, np.uint32(7), 1.0)
    assert not image[:30].any()
    assert not image[50:].any()
    assert image[30:50].any()


def test_half_a_share_mixes_half():
    image = np.full((8, 8), 0x204060, np.uint32)
    corners = (-9.0, -9.0, 30.0, -9.0, -9.0, 30.0)
    raster.fill_flat(image, (0, 0, 8, 8), corners, np.uint32(0x6080A0), 0.5)
    assert image[0, 0] == 0x406080


def test_a_triangle_through_the_near_plane_is_cut_there():
    points = np.array([[0.0, 0.0, 1.0], [0.1, 0.0, -1.0], [-0.1, 0.1, 1.0]])
    seen, screen, corner = np.zeros((3, 3)), np.zeros((3, 3)), np.zeros((4, 3))
    raster.project_points(points, np.zeros(3), np.eye(3), 100.0, 0.1, 160.0, 120.0, seen, screen)
    count = raster.corners_of(seen, screen, 0, 1, 2, 100.0, 0.1, 160.0, 120.0, corner)
    assert count == 4
    assert corner[:, 2].min() > 0.0
    assert corner[:, 2].max() == pytest.approx(10.0)
    swapped = np.zeros((4, 3))
    raster.corners_of(seen, screen, 2, 1, 0, 100.0, 0.1, 160.0, 120.0, swapped)
    assert {tuple(c) for c in corner} == {tuple(c) for c in swapped}


def test_a_corner_right_on_a_pixels_middle_is_hit_once():
    corners = [(-1.5, 188.5), (19.5, 189.5), (40.5, 202.5), (44.5, 213.5), (21.5, 213.5)]
    rim = [(x, y - 150) for x, y in [*corners, (-1.5, 201.5)]]
    middle = (23.5, 49.5)
    fan = [(middle, a, b) for a, b in zip(rim, [*rim[1:], rim[0]], strict=True)]
    assert hits(fan)[49, 23] == 1
