"""Closes the hole between an outline, posts and holes and what is drawn of them."""

from __future__ import annotations

from math import hypot
from pathlib import Path

import numpy as np
import pytest
from stands import bare, draw

from engine.render.renderer import make_renderer
from engine.scene.camera import project
from engine.stage import plan
from engine.stage.bed import build_bed
from engine.stage.bodies import build_hole_rims, build_posts
from engine.stage.cameras import above_camera, cue_camera, orbit_camera
from engine.stage.cushions import build_cushions
from engine.stage.dimensions import measure
from engine.stage.marks import build_lines, build_sights, tint_zone
from engine.stage.rails import build_rails
from engine.stage.region import clip, convex_pieces, stations, tidy
from engine.stage.stage import stage_of
from engine.table.furniture import Area
from engine.table.region import distance_to, is_inside, on_bed, posts_of, trace
from engine.variant.load import read_draft

TABLES = Path(__file__).parents[1] / "variant" / "tables"
NAMES = sorted(path.stem for path in TABLES.glob("*.toml"))
OUTLINED = [name for name in NAMES if name != "posts"]
CLOTH = (0, 90, 70)


def table_of(name):
    draft, mistakes = read_draft(TABLES / f"{name}.toml")
    assert not mistakes
    return draft.world.table


def stage_and_places(name):
    draft, _ = read_draft(TABLES / f"{name}.toml")
    world = draft.world
    stage = stage_of(world.table, world.balls, draft.balls, draft.look)
    return stage, {ball: (*at, world.balls[0].radius) for ball, at in draft.rack.fixed.items()}


def area_of(mesh):
    corners = mesh.positions[mesh.triangles].astype(float)
    one, two = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return 0.5 * (one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0]).sum()


@pytest.mark.parametrize("name", OUTLINED)
def test_the_bed_fills_the_outline_less_pockets_and_holes(name):
    table = table_of(name)
    frame = measure(table)
    border = tidy([one.behind(frame.cushion_depth) for one in stations(table.outline)])
    whole = plan.area(border)
    pieces = convex_pieces(border)
    assert sum(plan.area(piece) for piece in pieces) == pytest.approx(whole, abs=1e-9)
    holes = sum(
        plan.area(part)
        for pocket in table.pockets
        for piece in pieces
        if (part := clip(plan.circle(pocket.centre, pocket.radius, 28), piece))
    )
    assert area_of(build_bed(table, frame, CLOTH)) == pytest.approx(whole - holes, abs=2e-5)


@pytest.mark.parametrize("name", NAMES)
def test_no_wood_and_no_rubber_stands_over_the_bed(name):
    """A point half a ball inside of the noses is outside of every part."""
    table = table_of(name)
    frame = measure(table)
    parts = build_cushions(table, frame, CLOTH) + build_rails(table, frame, CLOTH, CLOTH)
    outline = table.outline or [shape for c in table.cushions[:4] for shape in c.shapes]
    dice = np.random.default_rng(3)
    seen = 0
    while seen < 150:
        x, y = dice.uniform(-0.5, 0.5, 2) * (table.length, table.width)
        if not on_bed(table, (x, y)) or min(distance_to(s, (x, y)) for s in outline) < 0.014:
            continue
        seen += 1
        for part in parts:
            gaps = part.planes[:, :3] @ np.array([x, y, frame.nose]) - part.planes[:, 3]
            assert gaps.max() > 0.0


@pytest.mark.parametrize("name", OUTLINED)
def test_the_noses_are_drawn_where_balls_meet_them(name):
    table = table_of(name)
    parts = build_cushions(table, measure(table), CLOTH)
    posts = {post.id for post in posts_of(table)}
    shapes = [s for c in table.cushions if c.id not in posts for s in c.shapes]
    for shape in shapes:
        x, y = trace([shape], 10.0)[-1]
        point = np.array([x, y, table.nose_height])
        nearest = min((p.planes[:, :3] @ point - p.planes[:, 3]).max() for p in parts)
        assert abs(nearest) < 2.5e-3


@pytest.mark.parametrize("name", NAMES)
def test_cushions_and_wood_are_hulls_with_their_faces_outside(name):
    table = table_of(name)
    frame = measure(table)
    for part in [
        *build_cushions(table, frame, CLOTH),
        *build_rails(table, frame, CLOTH, CLOTH),
        *build_posts(table, frame, CLOTH, CLOTH),
    ]:
        inner = part.positions.mean(axis=0)
        for centre, normal in zip(part.face_centres, part.face_normals, strict=True):
            assert (centre - inner) @ normal > -1e-6


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("size", [(1280, 720), (720, 1280), (1000, 1000)])
def test_the_camera_above_shows_all_the_wood(name, size):
    table = table_of(name)
    frame = measure(table)
    camera = above_camera(table, size[0] / size[1])
    places = np.concatenate([part.positions for part in build_rails(table, frame, CLOTH, CLOTH)])
    seen = np.array([project(camera, size, tuple(map(float, p))) for p in places])
    assert (seen >= 0).all()
    assert (seen <= size).all()
    share = (seen.max(axis=0) - seen.min(axis=0)) / size
    assert share.max() > 0.9


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("view", ["above", "cue", "orbit"])
def test_painter_and_scanline_agree_on_what_is_in_front(name, view):
    stage, places = stage_and_places(name)
    camera = {
        "above": above_camera(stage.table, 16 / 9),
        "cue": cue_camera(stage.table, places["cue"][:2], 0.3),
        "orbit": orbit_camera(stage.table, 2.5, 0.5),
    }[view]
    scene = bare(stage.scene(places, camera))
    one, two = (draw(make_renderer(name), scene) for name in ("painter", "scanline"))
    lit = [np.stack([(p >> s) & 255 for s in (0, 8, 16)], -1).astype(int) for p in (one, two)]
    assert (np.abs(lit[0] - lit[1]).max(-1) > 90).mean() < 0.004


def test_posts_stand_as_high_as_the_noses_and_holes_have_a_rim():
    table = table_of("posts")
    frame = measure(table)
    posts = build_posts(table, frame, CLOTH, (90, 50, 30))
    assert len(posts) == 3
    for mesh, post in zip(posts, posts_of(table), strict=True):
        away = np.hypot(
            mesh.positions[:, 0] - post.centre[0], mesh.positions[:, 1] - post.centre[1]
        )
        widest = mesh.positions[away > post.radius - 1e-6]
        heights = [0.0, table.nose_height, frame.top] if post.upright else [table.nose_height]
        assert sorted(set(widest[:, 2])) == pytest.approx(heights)
        assert mesh.positions[:, 2].min() == 0.0
    assert len(build_hole_rims(table, CLOTH)) == 2


def test_lines_and_tints_stay_on_the_bed():
    table = table_of("ell")
    for line in build_lines(table, CLOTH):
        for x, y, _ in line.points:
            assert on_bed(table, (float(x), float(y)), 1e-5)
    tint = tint_zone(Area(), table, CLOTH)
    assert area_of(tint) == pytest.approx(2.8 * 1.8 - 1.3 * 0.7, abs=1e-3)
    arm = tint_zone(table.zones["arm"], table, CLOTH)
    assert area_of(arm) == pytest.approx(1.5 * 0.7, abs=1e-3)


def test_sights_lie_on_the_wood():
    table = table_of("hexagon")
    frame = measure(table)
    sights = build_sights(table, frame, CLOTH)
    assert len(sights) == 18
    for sight in sights:
        x, y, _ = sight.positions.mean(axis=0)
        assert not is_inside(table.outline, (x, y))
        away = min(distance_to(shape, (x, y)) for shape in table.outline)
        assert frame.cushion_depth < away < frame.rail


def test_concave_polygons_fall_into_few_convex_ones():
    star = [
        (
            (1.0 if k % 2 else 0.45) * np.cos(k * np.pi / 5),
            (1.0 if k % 2 else 0.45) * np.sin(k * np.pi / 5),
        )
        for k in range(10)
    ]
    star = [(float(x), float(y)) for x, y in star]
    pieces = convex_pieces(star)
    assert len(pieces) <= 6
    assert sum(plan.area(piece) for piece in pieces) == pytest.approx(plan.area(star))
    for piece in pieces:
        for k, a in enumerate(piece):
            b, c = piece[(k + 1) % len(piece)], piece[(k + 2) % len(piece)]
            assert (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]) >= -1e-9
    assert hypot(*star[0]) == pytest.approx(0.45)
