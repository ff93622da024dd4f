"""Pins between two shots: which stand, which wait, and where a ball in hand may lie."""

from __future__ import annotations

from dataclasses import replace

import pytest

from engine.game.match import start_match
from engine.game.phrases import parse_event
from engine.game.placing import refuse_place, usual_place
from engine.game.referee import judge_shot
from engine.game.shot import Shot
from engine.game.situation import Rest
from engine.table.pin import meeting
from engine.variant.load import load_variant

GAME = load_variant("five_pins")


def rest_with(**positions):
    return Rest(positions=dict(positions))


def after(situation, events, **positions):
    shot = Shot(events=tuple(map(parse_event, events)), after=rest_with(**positions))
    return judge_shot(GAME, situation, shot).after


@pytest.fixture
def opening():
    return start_match(GAME).situation


TOPPLED = ["white hits yellow", "yellow topples centre-pin"]


def test_a_pin_is_set_up_where_its_place_is_free(opening):
    then = after(opening, TOPPLED, white=(-0.9, 0.3), yellow=(0.3, 0.2))
    assert then.rest.fallen == frozenset()


def test_a_pin_whose_place_a_ball_takes_waits_until_it_is_free(opening):
    taken = after(opening, TOPPLED, white=(-0.9, 0.3), yellow=(0.02, 0.0))
    assert taken.rest.fallen == {"centre-pin"}
    still = after(taken, ["yellow hits white"], white=(-0.8, 0.3), yellow=(0.02, 0.01))
    assert still.rest.fallen == {"centre-pin"}
    free = after(still, ["white hits yellow"], white=(-0.3, 0.3), yellow=(0.5, 0.01))
    assert free.rest.fallen == frozenset()


def test_a_pin_needs_air_to_the_ball(opening):
    reach = meeting(GAME.world.table.pins[0].profile, 0.0615 / 2)[0]
    for gap, waits in ((-5e-5, True), (5e-5, False)):
        then = after(opening, TOPPLED, white=(-0.9, 0.3), yellow=(reach + gap, 0.0))
        assert bool(then.rest.fallen) == waits


def test_in_hand_opposite_the_ball_to_be_hit(opening):
    foul = ["white hits cushion foot"]
    for x, (open_at, shut_at) in {
        0.5: ((-0.5, 0.2), (0.4, 0.2)),
        -0.5: ((0.4, 0.2), (-0.4, 0.2)),
    }.items():
        then = after(opening, foul, white=(x, 0.0), yellow=(0.9, 0.5))
        assert then.in_hand == "opposite-half"
        assert refuse_place(GAME, then, open_at) is None
        assert "outside" in refuse_place(GAME, then, shut_at).reason
        assert refuse_place(GAME, then, usual_place(GAME, then)) is None


def test_in_hand_anywhere_where_the_ball_is_between(opening):
    then = after(opening, ["white hits cushion foot"], white=(0.0, 0.4), yellow=(0.9, 0.5))
    assert refuse_place(GAME, then, (-0.5, 0.2)) is None
    assert refuse_place(GAME, then, (0.4, 0.2)) is None


def test_the_first_of_the_balls_that_may_be_struck_is_struck():
    from engine.game.situation import ball_to_strike

    game = load_variant("bar_billiards")
    start = start_match(game).situation
    assert ball_to_strike(game, start) == "white-1"
    assert ball_to_strike(game, replace(start, strikable=frozenset({"white-2"}))) == "white-2"
