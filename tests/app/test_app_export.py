"""Pictures of a shot: moving, its ways, and what is seen."""

from dataclasses import replace

import pytest
from click.testing import CliRunner
from PIL import Image

from engine.__main__ import main
from engine.app import commands
from engine.app.clip import NoStrokeError, write_clip
from engine.app.exporting import Exporter
from engine.app.session import SHOWING
from engine.app.steps import act
from engine.records.write import save_shot_record


@pytest.fixture
def played(start):
    session = start("three_cushion")
    while session.mode not in SHOWING:
        session = act(session, commands.Confirm())
    return act(session, commands.Skip())


def frames(path):
    with Image.open(path) as image:
        return image.n_frames, image.size, image.info["duration"]


def test_a_clip_lasts_as_long_as_the_shot(played, tmp_path):
    last = played.last
    path = tmp_path / "shot.gif"
    write_clip(path, played.variant, last.before, last.shot, size=(160, 90), renderer="wireframe")
    count, size, duration = frames(path)
    assert size == (160, 90)
    assert count * duration / 1000 == pytest.approx(played.trace.duration, abs=0.3)
    with Image.open(path) as image:
        first = image.convert("RGB").tobytes()
        image.seek(count - 1)
        assert image.convert("RGB").tobytes() != first


def test_a_shot_without_a_stroke_is_refused(played, tmp_path):
    bare = replace(played.last.shot, strike=None)
    with pytest.raises(NoStrokeError, match="stroke"):
        write_clip(tmp_path / "no.gif", played.variant, played.last.before, bare)


@pytest.mark.parametrize(("kind", "ending"), [("clip", ".gif"), ("paths", ".png")])
def test_pictures_are_made_beside_the_game_and_told(played, tmp_path, monkeypatch, kind, ending):
    monkeypatch.setattr("engine.app.clip.SIZE", (160, 90))
    exporter = Exporter(tmp_path / "pictures")
    assert "being made" in exporter.begin(kind, played.match)
    exporter.join()
    told = exporter.take()
    assert told.startswith("saved ")
    assert exporter.take() == ""
    (path,) = (tmp_path / "pictures").iterdir()
    assert path.suffix == ending
    assert Image.open(path).size[0] > 0


def test_before_the_first_stroke_there_is_nothing_to_make(start, tmp_path):
    exporter = Exporter(tmp_path)
    assert "no stroke" in exporter.begin("clip", start("three_cushion").match)


def test_a_place_that_cannot_be_written_is_told(played, tmp_path):
    (tmp_path / "file").write_text("", encoding="utf-8")
    exporter = Exporter(tmp_path / "file" / "pictures")
    exporter.begin("paths", played.match)
    exporter.join()
    assert "could not be made" in exporter.take()


def test_a_record_is_made_into_pictures_on_the_command_line(played, tmp_path):
    record = tmp_path / "shot.toml"
    save_shot_record(record, played.match)
    gif, png = tmp_path / "shot.gif", tmp_path / "ways.png"
    words = ["export", str(record), "--gif", str(gif), "--paths", str(png), "--size", "160x90"]
    done = CliRunner().invoke(main, words)
    assert done.exit_code == 0, done.output
    assert frames(gif)[0] > 3
    assert Image.open(png).size[0] > 100


@pytest.mark.parametrize(
    ("words", "status", "told"),
    [
        ((), 2, "which picture"),
        (("--gif", "x.gif", "--shot", "9"), 2, "has 1 shots"),
    ],
)
def test_what_cannot_be_made_is_told_on_the_command_line(played, tmp_path, words, status, told):
    record = tmp_path / "shot.toml"
    save_shot_record(record, played.match)
    done = CliRunner().invoke(main, ["export", str(record), *words])
    assert done.exit_code == status
    assert told in done.output
