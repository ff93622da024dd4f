import tomllib

import pytest

from engine.app.pen import TONES
from engine.app.settings import Settings, read_settings
from engine.app.theme import BUTTON, GOLD, LIGHT, MARKED, PANEL, PICKED, TEXT, contrast
from engine.app.units import Units


def found(tmp_path, text):
    path = tmp_path / "settings.toml"
    path.write_text(text, encoding="utf-8")
    return read_settings(path)


def read(tmp_path, text):
    there = found(tmp_path, text)
    assert there.troubles == ()
    return there.settings


def test_no_file_means_the_defaults(tmp_path):
    assert read_settings(tmp_path / "none.toml").settings == Settings.model_validate({})
    assert read_settings(tmp_path / "none.toml").settings.rate == 60


def test_the_rate_of_the_films_is_possible(tmp_path):
    assert read(tmp_path, "rate = 24\n").rate == 24


def test_a_whole_number_does_for_the_size_of_the_text(tmp_path):
    assert read(tmp_path, "text = 2\n").text == 2.0


@pytest.mark.parametrize(
    ("text", "place", "words"),
    [
        (
            '\nrenderer = "oil"\n',
            "2:12",
            ("renderer", "scanline", 'renderer = "scanline" is taken'),
        ),
        ("rate = 0\n", "1:8", ("rate", "1 or more", "rate = 60 is taken")),
        ("width = 1280\nheigth = 720\n", "2:1", ("heigth", "did you mean `height`", "left out")),
        ("rate = true\n", "1:8", ("rate", "whole number", "rate = 60 is taken")),
        ('names = ["Ann", 7]\n', "1:17", ("names", "in quotes", "names = [] is taken")),
        ("smooth = 1\n", "1:10", ("smooth", "smooth = true is taken")),
        ('[keys]\nundo = "dance"\n', "2:8", ("keys.undo", "no key 'dance'", "usual keys")),
        ("rate = = 3\n", "1:8", ("the defaults are taken",)),
    ],
)
def test_a_bad_value_is_told_with_place_and_mend_and_its_default_is_taken(
    tmp_path, text, place, words
):
    there = found(tmp_path, text)
    assert there.settings == Settings.model_validate({"width": 1280})
    (told,) = there.troubles
    assert f"settings.toml:{place}: " in told
    assert all(word in told for word in words), told
    assert "\n" not in told


def test_what_is_right_beside_what_is_wrong_is_taken(tmp_path):
    there = found(tmp_path, 'rate = 0\nrenderer = "oil"\nvolume = 0.2\n[keys]\nundo = "l"\n')
    assert len(there.troubles) == 2
    assert there.settings.volume == 0.2
    assert there.settings.keymap.shown("undo") == "L"


def test_the_documentation_has_every_setting_with_its_default():
    from pathlib import Path

    text = (Path(__file__).parents[2] / "docs" / "playing.md").read_text(encoding="utf-8")
    block = text.split("## Settings")[1].split("```toml\n")[1].split("```")[0]
    written = tomllib.loads(block)
    keys = written.pop("keys")
    usual = Settings.model_validate({}).model_dump()
    assert set(written) | {"keys"} == set(usual)
    assert {**written, "names": []} == {key: usual[key] for key in written}
    assert Settings.model_validate({"keys": keys}).keymap


@pytest.mark.parametrize("colour", [*TONES.values(), GOLD])
def test_every_text_can_be_read_in_both_themes(colour):
    for ground in (PANEL, BUTTON, MARKED, PICKED):
        if (colour, ground) == (TONES["faint"], PICKED):
            continue
        assert contrast(colour, ground) >= 4.5
        assert contrast(LIGHT[colour], LIGHT[ground]) >= 4.5


def test_contrast_is_that_of_the_guideline():
    assert contrast((255, 255, 255), (0, 0, 0)) == pytest.approx(21.0)
    assert contrast((119, 119, 119), (255, 255, 255)) == pytest.approx(4.48, abs=0.01)
    assert contrast(TEXT, TEXT) == 1.0


def test_lengths_and_speeds_are_shown_in_the_players_units():
    assert Units.METRIC.speed(4.4704) == "4.47 m/s"
    assert Units.IMPERIAL.speed(4.4704) == "10.00 mph"
    assert Units.METRIC.place((0.254, -0.0127)) == "25.4 cm, -1.3 cm"
    assert Units.IMPERIAL.place((0.254, -0.0127)) == "10.00 in, -0.50 in"
