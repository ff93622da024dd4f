"""The three renderers draw the same scenes, each in its manner, and always the same pixels."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from stands import RADIUS, TABLES, bare, draw, make_stage, scatter

from engine.render.painter import Painter
from engine.render.renderer import RENDERERS, make_renderer
from engine.render.scanline import Scanline
from engine.render.wireframe import Wireframe
from engine.scene.camera import Camera
from engine.scene.scene import GameObject, Scene
from engine.scene.shape import Sphere, make_mesh
from engine.stage.cameras import above_camera, cue_camera, orbit_camera
from engine.stage.cue import CuePose

SIZE = (1280, 720)


@pytest.fixture(scope="module")
def stages():
    return {name: make_stage(build()) for name, build in TABLES.items()}


def standard_scene(stage, camera_name, seed=1):
    places = scatter(stage, seed)
    ball, place = next(iter(places.items()))
    cue = None
    if camera_name == "cue":
        camera = cue_camera(stage.table, place[:2], 0.3)
        cue = CuePose(place, RADIUS, 0.3, 0.08)
    elif camera_name == "above":
        camera = above_camera(stage.table, 16 / 9)
    else:
        camera = orbit_camera(stage.table, 2.4, 0.5)
    assert ball in stage.spheres
    return stage.scene(places, camera, cue=cue)


@pytest.mark.parametrize("table", TABLES)
@pytest.mark.parametrize("camera", ["cue", "above", "orbit"])
def test_painter_differs_from_depth_in_few_pixels(stages, table, camera):
    scene = bare(standard_scene(stages[table], camera))
    painted = draw(Painter(1), scene, SIZE)
    exact = draw(Scanline(1, flat=True, keeps=False), scene, SIZE)
    assert (painted != exact).mean() <= 1e-4


def test_painter_stays_right_with_balls_in_jaws_and_on_cushions(stages):
    painter, depth = Painter(1), Scanline(1, flat=True, keeps=False)
    worst = 0.0
    for seed in range(24):
        stage = stages["pockets" if seed % 2 else "round jaws"]
        camera = orbit_camera(stage.table, seed * 0.7, 0.15 + 0.05 * (seed % 20), 2.0)
        scene = bare(stage.scene(scatter(stage, seed), camera))
        different = (draw(painter, scene) != draw(depth, scene)).mean()
        worst = max(worst, float(different))
    assert worst <= 5e-4


@pytest.mark.parametrize("name", RENDERERS)
def test_a_second_picture_is_the_same_and_so_is_another_renderers(stages, name):
    scene = standard_scene(stages["pockets"], "orbit")
    one, two = make_renderer(name), make_renderer(name)
    first = draw(one, scene)
    for _ in range(3):
        assert (draw(one, scene) == first).all()
    assert (draw(two, scene) == first).all()


@pytest.mark.parametrize("kind", [Wireframe, Painter, Scanline])
def test_one_thread_and_more_give_the_same_pixels(stages, kind):
    scene = standard_scene(stages["round jaws"], "cue")
    one = draw(kind(1), scene)
    for threads in (2, 3):
        assert (draw(kind(threads), scene) == one).all()


def test_a_kept_table_gives_the_pixels_of_a_full_redraw(stages):
    stage = stages["pockets"]
    camera = orbit_camera(stage.table, 2.0, 0.6)
    keeping, fresh = Scanline(1), Scanline(1, keeps=False)
    for seed in range(4):
        scene = stage.scene(scatter(stage, seed), camera)
        assert (draw(keeping, scene) == draw(fresh, scene)).all()
    moved = stage.scene(scatter(stage, 1), orbit_camera(stage.table, 2.1, 0.6))
    assert (draw(keeping, moved) == draw(fresh, moved)).all()


@pytest.mark.parametrize("name", RENDERERS)
def test_every_form_of_picture_gets_the_same_colours(stages, name):
    scene = standard_scene(stages["plain"], "above")
    renderer = make_renderer(name)
    pixels = draw(renderer, scene, (320, 180))
    three, four = np.zeros((180, 320, 3), np.uint8), np.zeros((180, 320, 4), np.uint8)
    strided = np.zeros((180, 330), np.uint32)[:, :320]
    turned = np.zeros((320, 180, 3), np.uint8).transpose(1, 0, 2)
    for picture in (three, four, strided, turned):
        renderer.render(scene, picture)
    assert (strided == pixels).all()
    assert (three == turned).all()
    assert (three[..., 0] == (pixels >> 16)).all()
    assert (four[..., 2] == (pixels >> 16)).all()
    assert (three[..., 2] == (pixels & 255)).all()


def test_a_picture_of_another_form_is_refused(stages):
    scene = standard_scene(stages["plain"], "above")
    with pytest.raises(ValueError, match="a picture is"):
        make_renderer("wireframe").render(scene, np.zeros((10, 10), np.float32))


def test_an_unknown_renderer_is_refused_with_the_names():
    with pytest.raises(ValueError, match="wireframe, painter, scanline"):
        make_renderer("raytracer")


@pytest.mark.parametrize("name", ["painter", "scanline"])
def test_a_ball_behind_a_cushion_is_hidden(stages, name):
    stage = stages["plain"]
    y = stage.table.width / 2.0 - RADIUS
    camera = Camera((0.0, y + 1.2, 0.12), (0.0, y, 0.03))
    ball = next(iter(stage.spheres))
    alone = draw(make_renderer(name), stage.scene({}, camera))
    with_ball = draw(make_renderer(name), stage.scene({ball: (0.0, y, RADIUS)}, camera))
    changed = np.argwhere(alone != with_ball)
    assert len(changed) > 0
    full = 2.0 * RADIUS * camera.focal(360) / 1.2
    seen = changed[:, 0].max() - changed[:, 0].min() + 1
    assert seen < 0.8 * full


def test_a_sphere_covers_its_disc():
    camera = Camera((0.0, -2.0, 0.0), (0.0, 0.0, 0.0))
    scene = Scene(
        (GameObject((Sphere(0.3, (255, 255, 255)),)),),
        (),
        camera,
        background=((0.0, (0, 0, 0)),),
    )
    focal = camera.focal(360)
    radius = focal * 0.3 / np.sqrt(4.0 - 0.09)
    for renderer, slack in ((Scanline(1), 0.02), (Painter(1), 0.03)):
        covered = (draw(renderer, scene) != 0).sum()
        assert covered == pytest.approx(pi * radius**2, rel=slack)


def test_a_skin_turns_with_its_sphere(stages):
    stage = stages["plain"]
    camera = above_camera(stage.table, 16 / 9)
    ball = list(stage.spheres)[1]
    quarter = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    place = {ball: (0.0, 0.0, RADIUS)}
    for name in ("painter", "scanline"):
        one = draw(make_renderer(name), stage.scene(place, camera, orientations={ball: np.eye(3)}))
        two = draw(make_renderer(name), stage.scene(place, camera, orientations={ball: quarter}))
        assert (one != two).any()


def test_nearer_wins_whatever_the_order():
    square = np.array([[-1, 0, -1], [1, 0, -1], [1, 0, 1], [-1, 0, 1]], float)
    near = make_mesh(square * 0.5 - [0, 0.5, 0], [(0, 1, 2, 3)], (255, 0, 0), kind="sheet")
    far = make_mesh(square, [(0, 1, 2, 3)], (0, 0, 255), kind="sheet")
    camera = Camera((0.0, -3.0, 0.0), (0.0, 0.0, 0.0))
    for shapes in ((near, far), (far, near)):
        scene = Scene((GameObject(shapes, fixed=True),), (), camera, ambient=1.0)
        for name in ("painter", "scanline"):
            middle = int(draw(make_renderer(name), scene)[180, 320])
            assert middle >> 16 > 0
            assert middle & 255 == 0


def test_what_is_not_visible_is_not_drawn(stages):
    scene = standard_scene(stages["plain"], "orbit")
    hidden = replace(
        scene, objects=tuple(replace(o, visible=False) for o in scene.objects), marks=(), shadows=()
    )
    for name in RENDERERS:
        pixels = draw(make_renderer(name), hidden)
        assert (pixels == pixels[:, :1]).all()


@pytest.mark.parametrize("name", RENDERERS)
def test_warming_up_tells_its_progress(name):
    heard = []
    make_renderer(name).warm_up(lambda what, share: heard.append((what, share)))
    shares = [share for _, share in heard]
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
