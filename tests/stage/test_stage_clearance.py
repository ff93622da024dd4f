"""Closes the hole between a cue and the cushion behind its ball: it is drawn above the wood."""

from math import cos, pi, radians, sin
from pathlib import Path

import numpy as np
import pytest
from stands import RADIUS, TABLES, make_stage

from engine.scene.camera import Camera
from engine.stage.cameras import cue_camera
from engine.stage.clearance import borders_of, raise_cue
from engine.stage.cue import CuePose, cue_meshes, place_cue
from engine.stage.dimensions import measure
from engine.table.region import on_bed, posts_of
from engine.variant.load import read_draft

OUTLINES = Path(__file__).parents[1] / "variant" / "tables"


def points_of(cue):
    """Return places all along the cue's surface, in the world."""
    found = []
    for mesh in cue.shapes:
        front, rear = np.split(mesh.positions.astype(float), 2)
        found += [front + (rear - front) * share for share in np.linspace(0.0, 1.0, 60)]
    return np.concatenate(found) @ cue.rotation.T + np.array(cue.position)


def pose_at(x, y, heading, **more):
    return CuePose((x, y, RADIUS), RADIUS, heading, **more)


def over_wood(table, points):
    frame = measure(table)
    beyond = (np.abs(points[:, 0]) > frame.inner[0]) | (np.abs(points[:, 1]) > frame.inner[1])
    within = (np.abs(points[:, 0]) < frame.outer[0]) & (np.abs(points[:, 1]) < frame.outer[1])
    return points[beyond & within]


@pytest.mark.parametrize("table", TABLES)
@pytest.mark.parametrize("turn", [0.0, 0.35, 2.1, pi, 4.4])
@pytest.mark.parametrize("away", [1.02, 2.0, 6.0, 15.0])
@pytest.mark.parametrize(("side", "follow"), [(0.0, 0.0), (0.3, 0.2), (-0.2, -0.4)])
def test_a_cue_is_drawn_above_cushion_and_wood(table, turn, away, side, follow):
    furniture = TABLES[table]()
    x = away * RADIUS - furniture.length / 2.0
    pose = pose_at(x, 0.03, turn, side=side, follow=follow, gap=0.0)
    raised = raise_cue(borders_of(furniture), pose)
    points = points_of(place_cue(cue_meshes(), raised))
    seen = over_wood(furniture, points)
    assert (seen[:, 2] > measure(furniture).top).all()
    beyond = points[np.abs(points[:, 0]) > furniture.length / 2.0 + 1e-4]
    assert (beyond[:, 2] > furniture.nose_height).all()


@pytest.mark.parametrize("table", TABLES)
def test_it_is_raised_no_more_than_it_must(table):
    furniture = TABLES[table]()
    pose = pose_at(0.12 - furniture.length / 2.0, 0.0, 0.0, gap=0.0)
    raised = raise_cue(borders_of(furniture), pose)
    assert raised.elevation > 0.02
    seen = over_wood(furniture, points_of(place_cue(cue_meshes(), raised)))
    assert seen[:, 2].min() < measure(furniture).top + 0.006


def test_in_the_open_and_when_raised_by_the_player_it_is_as_the_player_holds_it():
    table = TABLES["pockets"]()
    borders = borders_of(table)
    assert raise_cue(borders, pose_at(1.1, 0.0, 0.0, elevation=0.07)).elevation == 0.07
    near = pose_at(0.1 - table.length / 2.0, 0.0, 0.0, elevation=radians(40.0))
    assert raise_cue(borders, near) is near


@pytest.mark.parametrize("name", ["ell", "posts"])
@pytest.mark.parametrize("away", [0.1, 0.3])
def test_it_is_raised_over_posts_and_any_outline(name, away):
    draft, mistakes = read_draft(OUTLINES / f"{name}.toml")
    assert not mistakes
    table = draft.world.table
    frame, posts = measure(table), posts_of(table)
    raised = []
    for turn in np.linspace(0.0, 2.0 * pi, 16, endpoint=False):
        x, y = posts[0].centre if posts else (-0.9, -0.35)
        x, y = x + away * cos(turn), y + away * sin(turn)
        if not on_bed(table, (x, y)):
            continue
        pose = raise_cue(borders_of(table), pose_at(x, y, turn, gap=0.0))
        points = points_of(place_cue(cue_meshes(), pose))
        first = np.array([not on_bed(table, (px, py)) for px, py, _ in points])
        for post in posts:
            first |= np.hypot(*(points[:, :2] - post.centre).T) < post.radius
        assert (points[first][:, 2] > frame.nose).all()
        raised.append(pose.elevation)
    assert max(raised) > 0.03


def test_the_stage_draws_the_raised_cue():
    stage = make_stage(TABLES["pockets"]())
    pose = pose_at(0.1 - stage.table.length / 2.0, 0.0, 0.0, elevation=0.02)
    scene = stage.scene({}, Camera((0.0, 0.0, 2.0), (0.0, 0.1, 0.0)), cue=pose)
    cue = next(one for one in scene.objects if one.shapes is stage.cue)
    assert (over_wood(stage.table, points_of(cue))[:, 2] > measure(stage.table).top).all()


@pytest.mark.parametrize("table", TABLES)
@pytest.mark.parametrize("elevation", [0.0, 0.3, 0.7, 1.3])
@pytest.mark.parametrize("x", [0.0, 1.05])
def test_the_eye_behind_the_ball_looks_over_the_cue(table, elevation, x):
    furniture = TABLES[table]()
    place = (x * RADIUS - furniture.length / 2.0, 0.0) if x else (1.0, 0.0)
    camera = cue_camera(furniture, place, 0.0, elevation=elevation)
    pose = raise_cue(borders_of(furniture), pose_at(*place, 0.0, elevation=elevation))
    away = np.linalg.norm(points_of(place_cue(cue_meshes(), pose)) - camera.eye, axis=1)
    assert away.min() > 0.12
    steep = np.arctan2(camera.eye[2] - RADIUS, place[0] - camera.eye[0])
    assert steep > pose.elevation + radians(5.0)


def test_with_a_level_cue_in_the_open_the_eye_is_where_it_was_asked_for():
    table = TABLES["pockets"]()
    camera = cue_camera(table, (1.0, 0.2), 0.0, back=0.85, height=0.42)
    assert camera.eye == pytest.approx((0.15, 0.2, 0.42 + table.nose_height))
