"""Small reference pictures, one feature each; the name of the file is the feature.

`python tests/render/test_render_pictures.py` draws them anew; the difference is the review.
"""

import sys
from pathlib import Path

import numpy as np
import pytest

if __name__ == "__main__":
    sys.path[:0] = [str(Path(__file__).parent), str(Path(__file__).parents[2])]

from PIL import Image
from stands import RADIUS, make_stage, plain_table, pocket_table, round_jaw_table

from engine.render.renderer import RENDERERS, make_renderer
from engine.scene.camera import Camera
from engine.scene.shape import Disc
from engine.stage.cameras import above_camera, cue_camera
from engine.stage.cue import CuePose
from engine.stage.marks import flat_path, flat_ring, tint_zone
from engine.table.furniture import Area, HalfPlane

FOLDER = Path(__file__).parent / "pictures"
SIZE = (256, 144)


def jaw_hides_ball():
    stage = make_stage(pocket_table())
    names = list(stage.spheres)
    places = {names[1]: (1.262, 0.615, RADIUS), names[2]: (1.16, 0.59, RADIUS)}
    return stage.scene(places, Camera((0.98, 0.75, 0.13), (1.26, 0.62, 0.02)))


def ball_drops_into_pocket():
    stage = make_stage(pocket_table())
    names = list(stage.spheres)
    places = {names[3]: (0.0, 0.7, -0.012), names[4]: (0.0, 0.58, RADIUS)}
    return stage.scene(places, Camera((0.05, 0.2, 0.3), (0.0, 0.65, 0.0)))


def label_band_and_shadow():
    stage = make_stage(plain_table())
    names = list(stage.spheres)
    places = {names[k]: (0.075 * (k - 2), 0.0, RADIUS) for k in range(5)}
    return stage.scene(places, Camera((-0.2, -0.4, 0.2), (0.0, 0.0, 0.02)))


def cue_behind_ball_and_aids():
    stage = make_stage(round_jaw_table())
    names = list(stage.spheres)
    places = {names[0]: (-0.8, 0.1, RADIUS), names[5]: (-0.2, 0.1, RADIUS)}
    pose = CuePose(places[names[0]], RADIUS, 0.0, 0.1, side=0.3, follow=0.3, gap=0.02)
    zone = Area((HalfPlane((-0.5, 0.0), (-1.0, 0.0), closed=True),))
    aids = [
        tint_zone(zone, stage.table, (255, 255, 120)),
        flat_path([(-0.8, 0.1), (-0.25, 0.1)], (255, 255, 255)),
        flat_ring((-0.25, 0.1), RADIUS, (255, 255, 255)),
    ]
    camera = cue_camera(stage.table, (-0.8, 0.1), 0.0)
    disc = Disc((-0.5, -0.2, 0.001), 0.05, (240, 40, 40), 0.8, 0.01)
    return stage.scene(places, camera, cue=pose, aids=aids, discs=[disc])


def whole_table_above():
    stage = make_stage(round_jaw_table())
    names = list(stage.spheres)
    places = {name: (0.2 * k - 1.5, 0.1 * (k % 5) - 0.2, RADIUS) for k, name in enumerate(names)}
    return stage.scene(places, above_camera(stage.table, SIZE[0] / SIZE[1]))


SCENES = {
    make.__name__: make
    for make in (
        jaw_hides_ball,
        ball_drops_into_pocket,
        label_band_and_shadow,
        cue_behind_ball_and_aids,
        whole_table_above,
    )
}


def picture(scene, renderer):
    image = np.zeros((SIZE[1], SIZE[0], 3), np.uint8)
    make_renderer(renderer).render(SCENES[scene](), image)
    return image


@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("renderer", RENDERERS)
def test_the_picture_is_as_it_was_reviewed(scene, renderer):
    reviewed = np.asarray(Image.open(FOLDER / f"{scene}-{renderer}.png"))
    away = np.abs(picture(scene, renderer).astype(int) - reviewed).max(axis=2)
    assert (away > 6).mean() < 0.002


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    for scene in SCENES:
        for renderer in RENDERERS:
            Image.fromarray(picture(scene, renderer)).save(FOLDER / f"{scene}-{renderer}.png")
