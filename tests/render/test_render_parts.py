"""The renderers' small parts: the picture's memory, bands, what is kept, surfaces."""

import threading

import numpy as np
import pytest
from stands import TABLES, make_stage

from engine.render.bands import Bands
from engine.render.groups import by_face, by_surface
from engine.render.image import Canvas
from engine.render.keep import Kept
from engine.render.packer import Packer
from tools.render_scenes import random_scene


def test_a_box_of_a_window_is_drawn_into_where_it_lies():
    window = np.zeros((40, 60), np.uint32)
    box = window[5:35, 0:50]
    canvas = Canvas()
    target = canvas.open(box)
    assert (target.size, target.rows.flags.c_contiguous) == ((50, 30), True)
    target.rows[0, 0] = 7
    canvas.close(target, box)
    assert window[5, 0] == 7


def test_another_form_is_copied_at_the_end():
    picture = np.zeros((30, 50), np.uint32).T
    canvas = Canvas()
    target = canvas.open(picture)
    target.rows[2, 3] = 9
    assert not picture.any()
    canvas.close(target, picture)
    assert picture[2, 3] == 9


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_bands_are_all_rows_once(threads):
    seen, lock = [], threading.Lock()

    def draw(top, bottom):
        with lock:
            seen.extend(range(top, bottom))

    Bands(threads).run(draw, 3, 60)
    assert sorted(seen) == list(range(3, 60))


def test_a_bands_trouble_is_told():
    def draw(top, _bottom):
        if top:
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        Bands(2).run(draw, 0, 60)


def test_a_picture_is_kept_the_second_time_and_known_the_third():
    pack, kept = object(), Kept()
    key = (pack, "camera", (4, 3))
    assert (kept.knows(key), kept.wants_picture) == (False, False)
    assert (kept.knows(key), kept.wants_picture) == (False, True)
    assert kept.pixels.shape == (3, 4)
    assert (kept.knows(key), kept.wants_picture) == (True, False)
    assert not kept.knows((object(), *key[1:]))
    assert not kept.knows(key)
    assert not kept.knows(key)
    kept.drop()
    assert (kept.knows(key), kept.wants_picture) == (False, True)
    never = Kept(on=False)
    assert [never.knows(key) or never.wants_picture for _ in range(4)] == [False] * 4


def test_nothing_is_kept_of_a_shape_that_is_gone():
    stage, packer = make_stage(TABLES["plain"]()), Packer()
    scene = random_scene(stage, 1)
    for _ in range(3):
        packer.moving(scene)
    from engine.stage.marks import tint_zone
    from engine.table.furniture import Area, HalfPlane

    zone = Area((HalfPlane((0.0, 0.0), (-1.0, 0.0), closed=True),))
    for _ in range(5):
        tint = tint_zone(zone, stage.table, (9, 9, 9))
        packer.moving(stage.scene({}, scene.camera, aids=[tint]))
    assert len(packer._meshes) == 1


def test_a_surfaces_border_has_no_edge_between_its_triangles():
    pack, _ = Packer().fixed(random_scene(make_stage(TABLES["plain"]()), 1))
    surfaces, faces = by_surface(pack), by_face(pack)
    assert sorted(surfaces.order.tolist()) == sorted(faces.order.tolist())
    assert len(surfaces.starts) < len(faces.starts)
    bed = next(
        k
        for k in range(len(surfaces.starts) - 1)
        if (pack.points[pack.triangles[surfaces.order[surfaces.starts[k]]], 2] == 0.0).all()
    )
    edges = surfaces.edges[surfaces.edge_starts[bed] : surfaces.edge_starts[bed + 1]]
    middles = np.abs(pack.points[edges, :2]).mean(axis=1)
    reach = np.abs(pack.points[edges.reshape(-1), :2]).max(axis=0)
    assert (np.isclose(middles, reach, atol=1e-6).any(axis=1)).all()
    assert sorted(edges[:, 0]) == sorted(edges[:, 1])
