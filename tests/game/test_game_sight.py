"""Snookers and clear paths on layouts drawn by hand; radius 1 makes the figures plain."""

from math import asin, atan2, pi, sqrt

import pytest

from engine.game.sight import View, first_met, path_to, snookering_ball


def view(**others):
    return View((0.0, 0.0), 1.0, others, dict.fromkeys(others, 1.0))


def test_nothing_in_the_way_is_a_full_path():
    seen = view(red=(20.0, 0.0))
    assert path_to(seen, ["red"]) == "full"
    assert snookering_ball(seen, ["red"]) is None


def test_a_ball_on_the_line_leaves_part_of_the_target():
    seen = view(red=(20.0, 0.0), blue=(10.0, 1.5))
    assert path_to(seen, ["red"]) == "partial"
    assert snookering_ball(seen, ["red"]) == "blue"


def test_a_ball_close_ahead_hides_everything():
    seen = view(red=(20.0, 0.0), blue=(3.0, 0.0))
    assert path_to(seen, ["red"]) == "none"
    assert snookering_ball(seen, ["red"]) == "blue"


def test_a_target_in_front_of_a_target_hides_nothing():
    seen = view(one=(20.0, 0.0), two=(10.0, 0.0))
    assert path_to(seen, ["one", "two"]) == "full"
    assert snookering_ball(seen, ["one", "two"]) is None


def test_a_ball_behind_the_target_is_not_in_the_way():
    assert snookering_ball(view(red=(10.0, 0.0), blue=(14.0, 0.0)), ["red"]) is None


def test_one_free_target_is_enough():
    seen = view(red=(20.0, 0.0), blue=(3.0, 0.0), free=(0.0, 12.0))
    assert snookering_ball(seen, ["red", "free"]) is None


def test_the_nearest_snookering_ball_is_named():
    seen = view(red=(20.0, 0.0), far=(12.0, 1.9), near=(6.0, -1.9))
    assert snookering_ball(seen, ["red"]) == "near"


@pytest.mark.parametrize("offset", [-0.99, -0.5, 0.0, 0.5, 0.99])
def test_the_first_ball_met_is_the_one_aimed_at(offset):
    heading = atan2(3.0, 4.0) + asin(offset * 2.0 / 5.0)
    assert first_met(view(red=(4.0, 3.0)), heading) == "red"
    assert first_met(view(red=(4.0, 3.0)), heading + pi) is None


def test_just_past_the_edge_is_a_miss():
    edge = asin(2.0 / sqrt(20.0**2))
    assert first_met(view(red=(20.0, 0.0)), edge * (1 - 1e-9)) == "red"
    assert first_met(view(red=(20.0, 0.0)), edge * (1 + 1e-9)) is None
