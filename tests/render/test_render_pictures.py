"""The reference pictures of `tools.reference_pictures` are as they were reviewed."""

import numpy as np
import pytest
from PIL import Image

from engine.render.renderer import RENDERERS
from tools import reference_pictures
from tools.reference_pictures import FOLDER, compare, differing, file_of, main, picture_of
from tools.reference_scenes import SCENES, SIZE


@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("renderer", RENDERERS)
def test_the_picture_is_as_it_was_reviewed(scene, renderer, tmp_path):
    found = differing([scene], [renderer], tmp_path)
    assert {name: str(one) for name, one in found.items()} == {}, f"see {tmp_path}"


def test_every_picture_kept_is_of_a_scene():
    kept = {path.name for path in FOLDER.iterdir()}
    assert kept == {file_of(scene, renderer).name for scene in SCENES for renderer in RENDERERS}


def test_a_difference_says_where_it_is_and_shows_it():
    reviewed = np.full((144, 256, 3), 40, np.uint8)
    drawn = reviewed.copy()
    drawn[20:40, 30:60] += 9
    drawn[100, 100] += 5
    found = compare(reviewed, drawn)
    assert found.matters
    assert (found.pixels, found.worst, found.box) == (600, 9, (30, 20, 59, 39))
    assert str(found) == (
        "600 of 36864 pixels differ, by up to 9 levels, between (30, 20) and (59, 39)"
    )
    assert (found.picture[20:40, 30:60] == 255).all()
    assert (found.picture[100, 100] == 10).all()
    assert not compare(reviewed, reviewed).matters


def test_a_changed_picture_is_told_and_drawn_and_updated(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(reference_pictures, "FOLDER", tmp_path)
    monkeypatch.setattr(reference_pictures, "ROOT", tmp_path)
    monkeypatch.setattr(
        reference_pictures, "file_of", lambda scene, renderer: tmp_path / f"{scene}-{renderer}.png"
    )
    assert main(["highlights", "--update"]) == 0
    assert "3 pictures" in capsys.readouterr().out
    assert main(["highlights"]) == 0
    changed = picture_of("highlights", "scanline")
    changed[:50] = 0
    Image.fromarray(changed).save(tmp_path / "highlights-scanline.png")
    capsys.readouterr()
    assert main(["highlights", "--out", str(tmp_path / "out")]) == 1
    assert "highlights-scanline.png: " in capsys.readouterr().out
    shown = np.asarray(Image.open(tmp_path / "out" / "highlights-scanline.png"))
    assert shown.shape == (SIZE[1], SIZE[0], 3)
    assert main(["highlights", "--update"]) == 0
    assert "1 pictures" in capsys.readouterr().out
