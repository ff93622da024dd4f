"""A record that differs is drawn: the balls where they lay, their ways, what was expected."""

import numpy as np
import pytest
from click.testing import CliRunner
from PIL import Image

from engine.__main__ import main
from engine.proving.pictures import BED, DIFFERS, draw_outcome
from engine.records.read import read_record_text
from engine.records.run import run_record
from engine.variant.load import load_variant

RECORD = """\
format = 1
variant = "nine_ball"
title = "A dry shot"

[before]
phase = "open"
{before}

[[shot]]
events = ["cue hits 3", "3 hits cushion foot"]

{after}

[shot.expect]
next = {player}
{expect}
"""
BEFORE = "[before.positions]\ncue = [-0.6, 0.0]\n3 = [0.2, 0.0]\n9 = [0.5, 0.3]"
AFTER = "[shot.after.positions]\ncue = [0.1, 0.0]\n3 = [0.9, 0.2]\n9 = [0.5, 0.3]"


def outcome(tmp_path, before=BEFORE, after=AFTER, player=1, expect=""):
    text = RECORD.format(before=before, after=after, player=player, expect=expect)
    (tmp_path / "shot.toml").write_text(text)
    return run_record(read_record_text(text, tmp_path / "shot.toml", load_variant))


def drawn(tmp_path, **told):
    assert draw_outcome(outcome(tmp_path, **told), tmp_path / "shot.png")
    return np.asarray(Image.open(tmp_path / "shot.png"))


def count(picture, colour):
    return int((picture == colour).all(axis=2).sum())


def test_the_way_of_a_ball_is_drawn_in_its_colour(tmp_path):
    red = next(kind.colour for kind in load_variant("nine_ball").balls if kind.id == "3")
    moved = drawn(tmp_path)
    lying = drawn(tmp_path, after=BEFORE.replace("before", "shot.after"))
    assert count(moved, red) > count(lying, red) + 300
    assert count(moved, BED) > 100_000


def test_what_differs_is_red_and_what_agrees_is_not(tmp_path):
    assert count(drawn(tmp_path, player=2), DIFFERS) == 0
    assert count(drawn(tmp_path), DIFFERS) > 0


def test_a_place_that_was_expected_is_crossed(tmp_path):
    told = {"player": 2, "expect": 'positions = { "3" = [0.9, -0.2] }'}
    picture = drawn(tmp_path, **told)
    middle = 40 + round((0.9 + 1.27) * 880 / 2.54), 80 + round((0.635 + 0.2) * 880 / 2.54)
    near = picture[middle[1] - 8 : middle[1] + 9, middle[0] - 8 : middle[0] + 9]
    assert count(near, DIFFERS) > 20


@pytest.mark.parametrize("before", ['on_table = ["cue", "3", "9"]'])
def test_without_positions_there_is_no_picture(tmp_path, before):
    assert not draw_outcome(outcome(tmp_path, before=before, after=""), tmp_path / "none.png")
    assert not (tmp_path / "none.png").exists()


def test_a_stroke_that_can_be_played_has_its_bent_way(tmp_path):
    done = CliRunner().invoke(
        main, ["simulate", "nine_ball", "--speed", "3", "--record", str(tmp_path / "a.toml")]
    )
    assert done.exit_code == 0
    text = (tmp_path / "a.toml").read_text()
    (tmp_path / "a.toml").write_text(text.replace("[shot.expect]\n", "[shot.expect]\nrerack = 5\n"))
    words = ["golden", str(tmp_path / "a.toml"), "--pictures", str(tmp_path / "out")]
    assert CliRunner().invoke(main, words).exit_code == 1
    assert len(list((tmp_path / "out").glob("*.png"))) == 1
