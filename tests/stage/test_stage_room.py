"""Closes the hole between a table and the room: wood with grain, legs, shadow, wall and floor."""

from math import pi
from pathlib import Path

import numpy as np
import pytest
from stands import TABLES, make_stage

from engine.scene.camera import Camera, project
from engine.scene.shape import Mesh
from engine.stage import plan
from engine.stage.cameras import above_camera, cue_camera, orbit_camera
from engine.stage.dimensions import APRON, measure
from engine.stage.rails import build_rails
from engine.stage.room import FLOOR, FLOOR_FAR, WALL, backdrop, build_legs, build_shadow, leg_places
from engine.stage.wood import GRAIN, grained, toned
from engine.table.region import on_bed
from engine.variant.load import read_draft
from tools.bench.table_scene import TableScene

OUTLINES = Path(__file__).parents[1] / "variant" / "tables"
WOOD, LINER = (100, 60, 30), (9, 9, 9)


def tops_of(table):
    """Return (polygon corners, colour) of every face of the wood that looks up."""
    found = []
    for mesh in build_rails(table, measure(table), WOOD, LINER):
        for face, colour in enumerate(mesh.colours):
            corners = mesh.positions[mesh.triangles[mesh.faces == face]].astype(float)
            if mesh.face_normals[face, 2] > 0.9:
                one, two = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
                area = 0.5 * (one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0]).sum()
                found.append((corners, tuple(int(c) for c in colour), area))
    return found


def test_wood_in_strips_fills_the_frame_between_bed_and_edge():
    table = TABLES["plain"]()
    frame = measure(table)
    (ix, iy), (ox, oy) = frame.inner, frame.outer
    tops = tops_of(table)
    assert sum(area for *_, area in tops) == pytest.approx(4.0 * (ox * oy - ix * iy), rel=1e-5)
    assert {colour for _, colour, _ in tops} == {toned(WOOD, tone) for _, tone in GRAIN}


@pytest.mark.parametrize("table", TABLES)
def test_the_same_tone_goes_all_round_the_table(table):
    """At an equal way from the edge the wood is of one tone, mitred at the corners."""
    furniture = TABLES[table]()
    frame = measure(furniture)
    for corners, colour, _ in tops_of(furniture):
        if colour == LINER:
            continue
        x, y = np.abs(corners.mean(axis=(0, 1))[:2])
        width = frame.outer[0] - frame.inner[0]
        share = max(x - frame.inner[0], y - frame.inner[1]) / width
        tone = [tone for start, tone in GRAIN if start < share + 1e-9][-1]
        assert colour == toned(WOOD, tone)


def test_strips_fill_a_polygon_and_do_not_overlap():
    polygon = [(0.0, 0.0), (1.0, 0.0), (1.2, 1.0), (0.1, 1.0)]
    cuts = [((0.0, share), (0.0, 1.0)) for share, _ in GRAIN[1:]]
    strips = grained(polygon, WOOD, cuts)
    assert sum(plan.area(strip) for strip, _ in strips) == pytest.approx(plan.area(polygon))
    assert len(strips) == len(GRAIN)


@pytest.mark.parametrize("table", TABLES)
def test_legs_reach_from_the_apron_to_the_floor_under_the_table(table):
    furniture = TABLES[table]()
    frame = measure(furniture)
    legs = build_legs(furniture, frame, WOOD)
    assert len(legs) in (4, 8)
    for leg in legs:
        assert leg.layer == 0
        assert leg.positions[:, 2].min() == pytest.approx(FLOOR)
        assert leg.positions[:, 2].max() == pytest.approx(-APRON)
        assert (np.abs(leg.positions[:, :2]) < frame.outer).all()


@pytest.mark.parametrize("name", ["ell", "posts"])
def test_legs_of_any_outline_stand_under_its_bed(name):
    draft, _ = read_draft(OUTLINES / f"{name}.toml")
    table = draft.world.table
    places = leg_places(table, measure(table))
    assert len(places) >= 3
    assert all(on_bed(table, place) or not table.outline for place in places)


@pytest.mark.parametrize("table", TABLES)
def test_the_shadow_fills_its_border_once_and_fades_outwards(table):
    furniture = TABLES[table]()
    sheets = build_shadow(furniture, measure(furniture))
    area = 0.0
    for sheet in sheets:
        corners = sheet.positions[sheet.triangles].astype(float)
        one, two = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        part = 0.5 * (one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0])
        assert (part > 0.0).all()
        area += part.sum()
    x, y = np.abs(sheets[-1].positions[:, :2]).max(axis=0)
    assert area == pytest.approx(4.0 * x * y, rel=1e-5)
    darkness = [sheet.alpha for sheet in sheets]
    assert darkness == sorted(darkness, reverse=True)
    assert darkness[-1] < 0.15


def test_the_shadow_of_an_outline_follows_it():
    draft, _ = read_draft(OUTLINES / "ell.toml")
    table = draft.world.table
    frame = measure(table)
    darkest = build_shadow(table, frame)[0].positions[:, :2]
    x, y = frame.outer
    notch = [
        (a * x, b * y)
        for a in (-0.97, 0.97)
        for b in (-0.97, 0.97)
        if np.hypot(*(darkest - (a * x, b * y)).T).min() > 0.4
    ]
    assert len(notch) == 1


def test_lines_alone_show_neither_legs_nor_shadow_through_the_bed():
    table = TABLES["pockets"]()
    frame = measure(table)
    for mesh in (*build_legs(table, frame, WOOD), *build_shadow(table, frame)):
        assert len(mesh.triangles)
        assert not len(mesh.edges)


@pytest.mark.parametrize("size", [(1280, 720), (600, 900)])
@pytest.mark.parametrize("steep", [0.05, 0.3, 0.9])
def test_the_floor_ends_at_the_horizon(size, steep):
    table = TABLES["pockets"]()
    camera = orbit_camera(table, 2.0, steep)
    stops = backdrop(camera)
    shares = [share for share, _ in stops]
    assert shares == sorted(shares)
    level = (-1e6 * np.cos(2.0), -1e6 * np.sin(2.0), camera.eye[2])
    _, row = project(camera, size, level)
    horizon = next(share for share, colour in stops if colour == FLOOR_FAR)
    assert horizon == pytest.approx(row / size[1], abs=1e-4)
    assert next(colour for share, colour in reversed(stops) if share < horizon) == WALL[1]


def test_every_camera_has_a_backdrop_in_order():
    table = TABLES["plain"]()
    cameras = [above_camera(table, 1.5), above_camera(table, 0.6), cue_camera(table, (0, 0), 0.7)]
    cameras.append(Camera((0.0, 0.0, 0.3), (2.0, 0.0, 1.0)))
    for camera in cameras:
        shares = [share for share, _ in backdrop(camera)]
        assert shares == sorted(shares)
        assert np.isfinite(shares).all()


def test_a_resting_camera_asks_for_the_same_backdrop():
    stage = make_stage(TABLES["pockets"]())
    one, two = (
        stage.scene({}, orbit_camera(stage.table, 0.2 * pi, 0.5)).background for _ in range(2)
    )
    assert one == two


def test_the_table_of_the_speed_tables_has_few_triangles():
    furniture = TableScene().stage.furniture
    assert sum(len(m.triangles) for m in furniture.shapes if isinstance(m, Mesh)) < 4650
