"""Closes the hole between the documents' pictures of shots and the shots that are played."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from engine.physics.events import BallJumpedOver, BallsCollided, CushionHit, PinToppled
from engine.physics.monitor import examine
from engine.table.region import posts_of
from engine.variant.load import read_draft
from tools.shot_pictures import PICTURES, draw, play

DOCS = Path(__file__).parents[2] / "docs"


def shot(name):
    draft, mistakes = read_draft(PICTURES[name].table)
    assert not mistakes
    return draft, play(draft, PICTURES[name])


@pytest.mark.parametrize("name", PICTURES)
def test_every_picture_stands_in_the_documents_and_its_shot_is_sound(name):
    pages = "".join(page.read_text(encoding="utf-8") for page in DOCS.glob("*.md"))
    assert f"images/{name}.png" in re.findall(r"\]\((images/[^)]*)\)", pages)
    assert (DOCS / "images" / f"{name}.png").is_file()
    draft, trace = shot(name)
    assert not examine(trace, draft.world).faults()


def test_the_pictures_show_what_the_page_says_of_them():
    _, trace = shot("five-pins-shot")
    felled = {
        one.pin: one.by
        for one in trace.events()
        if isinstance(one, PinToppled) and one.time < PICTURES["five-pins-shot"].moments[-1]
    }
    assert felled == {
        "head-pin": ("yellow",),
        "centre-pin": ("yellow",),
        "foot-pin": ("yellow",),
        "left-pin": ("head-pin",),
    }
    _, trace = shot("pins-falling")
    assert ("centre-pin",) in [one.by for one in trace.events() if isinstance(one, PinToppled)]
    draft, trace = shot("bumpers-shot")
    posts = {post.id for post in posts_of(draft.world.table)}
    met = [one for one in trace.events() if isinstance(one, CushionHit) and one.cushion in posts]
    assert len(met) >= 3
    _, trace = shot("ell-shot")
    met = [one.cushion for one in trace.events() if isinstance(one, CushionHit)]
    assert "inner-end" in met


def test_the_jump_clears_its_ball_and_the_masse_goes_round_one():
    _, trace = shot("jump")
    met = [one for one in trace.events() if isinstance(one, BallJumpedOver | BallsCollided)]
    first, second = met[:2]
    assert (first.ball, first.other) == ("cue", "8")
    assert (second.ball, second.other) == ("cue", "1")
    _, trace = shot("masse")
    meets = [one.other for one in trace.events() if isinstance(one, BallsCollided)]
    assert meets[:1] == ["red"]
    assert not [one for one in trace.events() if isinstance(one, BallJumpedOver)]


def test_a_picture_has_its_moments_side_by_side_and_each_is_another():
    small = replace(PICTURES["pins-falling"], size=(160, 120))
    pixels = draw(small)
    assert pixels.shape == (120, 480, 3)
    one, two, three = (pixels[:, k * 160 : (k + 1) * 160].astype(int) for k in range(3))
    assert np.abs(one - two).max(-1).mean() > 0.5
    assert np.abs(two - three).max(-1).mean() > 0.5
