import pytest

from engine.app.settings import Settings, SettingsError, read_settings


def read(tmp_path, text):
    path = tmp_path / "settings.toml"
    path.write_text(text, encoding="utf-8")
    return read_settings(path)


def test_no_file_means_the_defaults(tmp_path):
    assert read_settings(tmp_path / "none.toml") == Settings.model_validate({})
    assert read_settings(tmp_path / "none.toml").rate == 60


def test_the_rate_of_the_films_is_possible(tmp_path):
    assert read(tmp_path, "rate = 24\n").rate == 24


def test_a_whole_number_does_for_the_size_of_the_text(tmp_path):
    assert read(tmp_path, "text = 2\n").text == 2.0


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        ('\nrenderer = "oil"\n', 2, ("renderer", "'wireframe'", "'scanline'")),
        ("rate = 0\n", 1, ("rate", "greater than or equal to 1")),
        ("width = 1280\nheigth = 720\n", 2, ("heigth", "no such setting", "height")),
        ("rate = true\n", 1, ("rate", "whole number")),
    ],
)
def test_a_bad_value_is_told_with_place_and_mend(tmp_path, text, line, words):
    with pytest.raises(SettingsError) as told:
        read(tmp_path, text)
    message = str(told.value)
    assert f"settings.toml:{line}:" in message
    assert all(word in message for word in words), message


def test_all_mistakes_are_told_at_once(tmp_path):
    with pytest.raises(SettingsError) as told:
        read(tmp_path, 'rate = 0\nrenderer = "oil"\n')
    assert len(str(told.value).splitlines()) == 2


def test_broken_toml_is_told_with_its_line(tmp_path):
    with pytest.raises(SettingsError, match=r"not TOML.*line 1"):
        read(tmp_path, "rate = = 3\n")
