"""What a game looks like: furniture, cameras, skins, marks."""

from dataclasses import replace
from math import hypot, pi

import numpy as np
import pytest
from stands import RADIUS, TABLES, make_stage

from engine.scene.camera import project
from engine.scene.shape import Mesh, skin_directions
from engine.stage import plan
from engine.stage.bed import build_bed
from engine.stage.cameras import above_camera, cue_camera, orbit_camera
from engine.stage.cue import CuePose, cue_meshes, place_cue
from engine.stage.cushions import build_cushions
from engine.stage.dimensions import measure
from engine.stage.marks import build_lines, tint_zone
from engine.stage.rails import build_rails
from engine.stage.skin import facing, paint_skin
from engine.table.furniture import (
    Area,
    Curve,
    Cushion,
    CushionId,
    Disc,
    HalfPlane,
    Line,
    LineId,
    Places,
    ZoneId,
)

SIZES = [(1280, 720), (1920, 1080), (720, 1280), (1000, 1000), (3440, 1440), (500, 1400)]


@pytest.mark.parametrize("table", TABLES)
@pytest.mark.parametrize("size", SIZES)
def test_the_camera_above_shows_all_four_corners_and_wastes_little(table, size):
    furniture = TABLES[table]()
    camera = above_camera(furniture, size[0] / size[1])
    frame = measure(furniture)
    x, y = frame.outer
    corners = [project(camera, size, (a * x, b * y, frame.top)) for a in (-1, 1) for b in (-1, 1)]
    for px, py in corners:
        assert 0 <= px <= size[0]
        assert 0 <= py <= size[1]
    across = max(c[0] for c in corners) - min(c[0] for c in corners)
    along = max(c[1] for c in corners) - min(c[1] for c in corners)
    assert max(across / size[0], along / size[1]) > 0.9


@pytest.mark.parametrize("table", TABLES)
def test_the_camera_on_an_orbit_shows_the_table(table):
    furniture = TABLES[table]()
    x, y = measure(furniture).outer
    for azimuth in np.linspace(0.0, 2.0 * pi, 9):
        camera = orbit_camera(furniture, float(azimuth), 0.55)
        for a, b in ((-1, -1), (-1, 1), (1, -1), (1, 1)):
            px, py = project(camera, (1280, 720), (a * x, b * y, 0.0))
            assert -60 < px < 1340
            assert -60 < py < 780


def test_the_camera_at_the_cue_has_the_ball_below_the_middle():
    furniture = TABLES["pockets"]()
    camera = cue_camera(furniture, (-0.6, 0.1), 0.7)
    x, y = project(camera, (1280, 720), (-0.6, 0.1, RADIUS))
    assert x == pytest.approx(640.0, abs=1e-6)
    assert 360 < y < 700


@pytest.mark.parametrize("table", TABLES)
def test_the_bed_is_whole_but_for_its_pockets(table):
    furniture = TABLES[table]()
    frame = measure(furniture)
    bed = build_bed(furniture, frame, (0, 90, 70))
    corners = bed.positions[bed.triangles].astype(float)
    one, two = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    total = 0.5 * (one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0]).sum()
    holes = 0.0
    whole = plan.rectangle(-frame.inner[0], -frame.inner[1], *frame.inner)
    for pocket in furniture.pockets:
        rim = plan.circle(pocket.centre, pocket.radius, 28)
        for k, a in enumerate(whole):
            b = whole[(k + 1) % 4]
            rim = rim and plan.cut(rim, a, (b[1] - a[1], a[0] - b[0]))
        holes += plan.area(rim) if rim else 0.0
    assert total == pytest.approx(4.0 * frame.inner[0] * frame.inner[1] - holes, abs=1e-5)
    assert bool(holes) == bool(furniture.pockets)


@pytest.mark.parametrize("table", TABLES)
def test_no_crack_in_the_bed(table):
    """Inner edges have a face on both sides, so snapping cannot open them."""
    furniture = TABLES[table]()
    frame = measure(furniture)
    bed = build_bed(furniture, frame, (0, 90, 70))
    for a, b, _, other in bed.edges:
        if other >= 0:
            continue
        p, q = bed.positions[a], bed.positions[b]
        on_border = any(
            abs(abs(p[k]) - frame.inner[k]) < 1e-5 and abs(abs(q[k]) - frame.inner[k]) < 1e-5
            for k in (0, 1)
        )
        on_rim = any(
            max(hypot(v[0] - k.centre[0], v[1] - k.centre[1]) for v in (p, q)) < k.radius + 1e-5
            for k in furniture.pockets
        )
        assert on_border or on_rim


@pytest.mark.parametrize("table", TABLES)
def test_cushions_and_wood_leave_the_noses_free(table):
    furniture = TABLES[table]()
    frame = measure(furniture)
    parts = build_cushions(furniture, frame, (0, 90, 70))
    parts += build_rails(furniture, frame, (90, 50, 30), (20, 20, 20))
    inside = np.array([0.0, 0.0, RADIUS])
    for part in parts:
        gaps = part.planes[:, :3] @ inside - part.planes[:, 3]
        assert gaps.max() > 0.3
    for cushion, part in zip(furniture.cushions, parts, strict=False):
        start, end = cushion.shapes[0].start, cushion.shapes[0].end
        middle = [(a + b) / 2 for a, b in zip(start, end, strict=True)]
        nose = np.array([*middle, furniture.nose_height])
        assert (part.planes[:, :3] @ nose - part.planes[:, 3]).max() == pytest.approx(0, abs=2e-3)


def test_a_round_table_has_cushions_too():
    ring = Cushion(CushionId("ring"), (Curve((0.0, 0.0), 0.6, 0.0, 2.0 * pi),))
    furniture = replace(TABLES["plain"](), length=1.2, width=1.2, cushions=(ring,))
    parts = build_cushions(furniture, measure(furniture), (0, 90, 70))
    assert len(parts) > 20
    for part in parts:
        assert np.hypot(part.positions[:, 0], part.positions[:, 1]).min() > 0.59


def test_a_label_looks_out_along_x_and_a_band_runs_round_z():
    skin = paint_skin((10, 20, 200), "stripe", "7")
    own = skin_directions(len(skin.texels))
    assert tuple(
        skin.texels[own[..., 2].argmax() // len(own), own[..., 2].argmax() % len(own)]
    ) == (
        246,
        241,
        226,
    )
    band = (np.abs(own[..., 2]) < 0.1) & (np.abs(own[..., 1]) > 0.9)
    assert (skin.texels[band] == (10, 20, 200)).all()
    face = own[..., 0] > 0.93
    assert (skin.texels[face].max(axis=1) < 60).any()
    assert (skin.texels[face].min(axis=1) > 200).any()


def test_a_plain_ball_without_a_label_needs_no_skin():
    assert paint_skin((1, 2, 3), "plain", "") is None
    with pytest.raises(ValueError, match="stripe or dots"):
        paint_skin((1, 2, 3), "checks", "")


def test_different_labels_look_different():
    skins = [paint_skin((10, 20, 200), "plain", label).texels for label in ("1", "7", "6", "9")]
    for i, one in enumerate(skins):
        for two in skins[i + 1 :]:
            assert (one != two).any()


def test_the_rest_pose_is_a_rotation_that_looks_up_to_the_head():
    turn = facing()
    assert turn @ turn.T == pytest.approx(np.eye(3), abs=1e-12)
    assert np.linalg.det(turn) == pytest.approx(1.0)
    assert turn[0, 0] < 0.0 < turn[2, 0]


def test_the_tip_points_at_the_spot_on_the_ball():
    pose = CuePose((0.2, 0.1, RADIUS), RADIUS, heading=0.0, side=0.5, follow=0.2, gap=0.03)
    cue = place_cue(cue_meshes(), pose)
    tip = np.array(cue.position)
    assert tip[1] == pytest.approx(0.1 - 0.5 * RADIUS)
    assert tip[2] == pytest.approx(RADIUS + 0.2 * RADIUS)
    contact = tip + 0.03 * cue.rotation[:, 0]
    assert np.linalg.norm(contact - np.array(pose.ball)) == pytest.approx(RADIUS)
    raised = place_cue(cue_meshes(), replace(pose, elevation=0.5))
    assert raised.rotation[2, 0] < 0.0


def test_lines_and_round_zones_are_drawn_once():
    table = replace(
        TABLES["plain"](),
        lines={LineId("a"): Line((-0.7, -0.7), (-0.7, 0.7))},
        zones={
            ZoneId("half"): Area(
                (
                    HalfPlane((-0.7, 0.0), (-1.0, 0.0), closed=True),
                    Disc((-0.7, 0.0), 0.3, closed=True),
                )
            ),
            ZoneId("same"): Area((Disc((-0.7, 0.0), 0.3, closed=True),)),
            ZoneId("two"): Places(((0.0, 0.0), (0.1, 0.0))),
        },
    )
    lines = build_lines(table, (255, 255, 255))
    assert len(lines) == 2
    arc = lines[1].points
    assert (arc[:, 0] <= -0.7 + 1e-6).all()
    assert len(arc) > 20


def test_a_zone_is_tinted_where_it_is():
    table = TABLES["plain"]()
    zone = Area((HalfPlane((-0.7, 0.0), (-1.0, 0.0), closed=True),))
    tint = tint_zone(zone, table, (255, 255, 0))
    assert isinstance(tint, Mesh)
    assert tint.positions[:, 0].max() == pytest.approx(-0.7)
    assert tint.positions[:, 0].min() == pytest.approx(-table.length / 2)
    beyond = Area((HalfPlane((5.0, 0.0), (1.0, 0.0), closed=True),))
    assert tint_zone(beyond, table, (255, 255, 0)) is None


def test_the_furniture_is_the_same_object_every_frame():
    stage = make_stage(TABLES["plain"]())
    camera = above_camera(stage.table, 1.5)
    one, two = stage.scene({}, camera), stage.scene({}, camera)
    assert one.objects[0] is two.objects[0]


def test_shadows_fall_away_from_the_lamps_and_not_from_what_has_dropped():
    stage = make_stage(TABLES["plain"]())
    ball = next(iter(stage.spheres))
    camera = above_camera(stage.table, 1.5)
    edge = stage.scene({ball: (0.0, 0.6, RADIUS)}, camera).shadows
    assert any(shadow.centre[1] > 0.6 + 0.2 * RADIUS for shadow in edge)
    assert stage.scene({ball: (0.0, 0.6, -0.1)}, camera).shadows == ()
