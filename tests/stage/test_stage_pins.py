"""Closes the hole between how a pin stands or lies and what is drawn of it."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from math import cos, pi, sin

import numpy as np
import pytest
from stands import RADIUS, bare, draw

from engine.physics.world import Ball
from engine.render.renderer import make_renderer
from engine.scene.camera import Camera, project
from engine.stage.stage import stage_of
from engine.table.furniture import BallId, Pin, PinId
from engine.table.pin import Stance
from engine.variant.variant import BallKind, PinKind
from tools.render_scenes import LOOK, plain_table

TALL = ((0.0, 0.007), (0.036, 0.010), (0.12, 0.0055))
SHORT = ((0.0, 0.0035), (0.013, 0.005), (0.025, 0.003))
CAPPED = ((0.0, 0.006), (0.03, 0.004), (0.05, 0.018))
PROFILES = {"tall": TALL, "short": SHORT, "capped": CAPPED}
COLOUR = (200, 40, 40)
PLACES = [(0.0, 0.0), (-0.09, 0.0), (0.09, 0.0), (0.0, 0.09), (0.0, -0.09)]
SIZE = (640, 360)


def stage(profile):
    pins = tuple(Pin(PinId(f"p{k}"), at, profile, 0.01) for k, at in enumerate(PLACES))
    ball = BallId("b")
    table = replace(plain_table(), pins=pins)
    kinds = [PinKind(pin.id, COLOUR) for pin in pins]
    return stage_of(table, [Ball(ball, RADIUS, 0.2)], [BallKind(ball, (9, 9, 200))], LOOK, kinds)


def placed(objects):
    for thing in objects:
        for mesh in thing.shapes:
            yield mesh, mesh.positions @ thing.rotation.T + np.array(thing.position)


LEANS = [(0.0, 0.0), (0.3, 0.4), (1.2, 2.0), (pi / 2, -2.5)]


@pytest.mark.parametrize("name", PROFILES)
@pytest.mark.parametrize("tilt", [0.0, 0.02, 0.5, 1.3, pi / 2])
@pytest.mark.parametrize("eye", [(0.3, 0.2, 0.3), (-3.0, 0.0, 2.0)])
def test_a_pin_rests_on_the_bed_however_it_leans(name, tilt, eye):
    there = stage(PROFILES[name])
    lean = {PinId("p1"): Stance((0.1, 0.2), (cos(2.0), sin(2.0)), tilt)}
    heights = np.concatenate([points[:, 2] for _, points in placed(there.pins.objects(lean, eye))])
    assert heights.min() >= -1e-9
    assert heights.min() < 2e-3


@pytest.mark.parametrize("name", PROFILES)
@pytest.mark.parametrize("eye", [(0.3, 0.2, 0.3), (-3.0, 0.0, 2.0)])
def test_every_part_is_a_hull_with_its_faces_outside_and_as_wide_as_the_pin(name, eye):
    profile = PROFILES[name]
    widest = 0.0
    for thing in stage(profile).pins.objects({PinId("p0"): Stance((0.0, 0.0))}, eye):
        for mesh in thing.shapes:
            inner = mesh.positions.mean(axis=0)
            for centre, normal in zip(mesh.face_centres, mesh.face_normals, strict=True):
                assert (centre - inner) @ normal > 0.0
            gaps = mesh.positions @ mesh.planes[:, :3].T - mesh.planes[:, 3]
            assert gaps.max() < 1e-6
            widest = max(widest, float(np.hypot(*mesh.positions[:, :2].T).max()))
    assert widest == pytest.approx(max(r for _, r in profile), rel=0.05)


def test_far_pins_are_drawn_with_few_triangles():
    there = stage(TALL)
    upright = {PinId("p0"): Stance((0.0, 0.0))}

    def count(distance):
        shapes = [
            mesh for one in there.pins.objects(upright, (distance, 0.0, 0.0)) for mesh in one.shapes
        ]
        return sum(len(mesh.triangles) for mesh in shapes)

    assert count(6.0) <= 60
    assert count(0.5) < 400
    assert count(6.0) < count(0.5) / 3


def test_a_pin_leans_along_its_way_with_its_foot_where_it_is_said_to_be():
    there = stage(TALL)
    way = (cos(0.7), sin(0.7))
    (one,) = there.pins.objects({PinId("p0"): Stance((0.2, -0.1), way, pi / 2)}, (0.0, 0.0, 1.0))
    (points,) = [points for _, points in placed([one])]
    along = (points[:, :2] - (0.2, -0.1)) @ np.array(way)
    assert along.min() == pytest.approx(0.0, abs=1e-9)
    assert along.max() == pytest.approx(0.12, abs=1e-6)
    assert np.allclose(one.rotation @ one.rotation.T, np.eye(3))
    assert np.linalg.det(one.rotation) == pytest.approx(1.0)


def scene_of(profile, leans=LEANS):
    there = stage(profile)
    stances = dict(there.pins.upright)
    for (tilt, turn), pin in zip(leans, list(stances)[1:], strict=True):
        stances[pin] = replace(stances[pin], tilt=tilt, way=(cos(turn), sin(turn)))
    camera = Camera((-0.45, -0.3, 0.3), (0.0, 0.0, 0.02))
    return there.scene({BallId("b"): (-0.06, 0.05, RADIUS)}, camera, pins=stances)


@pytest.mark.parametrize("name", PROFILES)
def test_painter_and_scanline_agree_on_what_is_in_front(name):
    scene = bare(scene_of(PROFILES[name]))
    one, two = (draw(make_renderer(kind), scene) for kind in ("painter", "scanline"))
    lit = [np.stack([(p >> s) & 255 for s in (0, 8, 16)], -1).astype(int) for p in (one, two)]
    assert (np.abs(lit[0] - lit[1]).max(-1) > 90).mean() < 0.002


@pytest.mark.parametrize("renderer", ["wireframe", "painter", "scanline"])
def test_every_renderer_draws_pins_where_they_stand(renderer):
    scene = scene_of(TALL, [(0.0, 0.0)] * 4)
    without = replace(
        scene, objects=tuple(one for one in scene.objects if one.position[:2] not in PLACES[1:])
    )
    assert len(without.objects) < len(scene.objects)
    picture = np.zeros((SIZE[1], SIZE[0], 3), np.uint8)
    empty = picture.copy()
    make_renderer(renderer).render(scene, picture)
    make_renderer(renderer).render(without, empty)
    changed = np.abs(picture.astype(int) - empty).max(-1) > 12
    for x, y in PLACES[1:]:
        low, high = (project(scene.camera, SIZE, (x, y, z)) for z in (0.0, 0.12))
        band = changed[int(high[1]) : int(low[1]) + 1, int(low[0]) - 6 : int(low[0]) + 7]
        assert band.any(axis=1).mean() > 0.8


def test_shadows_follow_the_pin_to_the_ground():
    there = stage(TALL)
    name = PinId("p0")
    upright = there.pins.shadows({name: Stance((0.3, 0.2))}, there.lamps)
    lying = there.pins.shadows({name: Stance((0.3, 0.2), (1.0, 0.0), pi / 2)}, there.lamps)
    assert upright
    assert lying
    dark = [max(disc.alpha for disc in discs) for discs in (upright, lying)]
    assert min(dark) > 0.2
    reach = max(disc.centre[0] for disc in lying)
    assert 0.3 + 0.1 < reach < 0.3 + 0.15
    strong = [disc for disc in upright if disc.alpha > 0.2]
    assert all(np.hypot(disc.centre[0] - 0.3, disc.centre[1] - 0.2) < 0.02 for disc in strong)


def test_without_a_word_all_pins_stand():
    there = stage(SHORT)
    camera = Camera((-0.45, -0.3, 0.3), (0.0, 0.0, 0.02))
    places = {one.position[:2] for one in there.scene({}, camera).objects}
    assert set(PLACES) <= places
    heights = [z for z, _ in SHORT]
    assert all(a < b for a, b in pairwise(heights))
    none = there.scene({}, camera, pins={})
    assert len(none.objects) == len(there.scene({}, camera).objects) - len(PLACES)
