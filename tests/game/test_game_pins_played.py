"""Closes the hole between pins in a stroke that is played and what the referee is told of them."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import hypot

import pytest

from engine.game.match import advance, start_match
from engine.game.observe import observe, play, simulate_shot
from engine.game.phrases import format_event, parse_event
from engine.game.referee import judge_shot
from engine.game.shot import Shot
from engine.game.situation import Rest
from engine.game.spotting import set_up
from engine.physics.world import Strike
from engine.table.furniture import BallId, PinId
from engine.table.pin import meeting
from engine.variant.load import load_variant
from rulelang.events import PinToppled, PinTouched

load = cache(load_variant)
WHITE, YELLOW, RED = BallId("white"), BallId("yellow"), BallId("red")
PLACES = {WHITE: (-0.95, -0.31), YELLOW: (-0.55, -0.155), RED: (0.71, 0.0)}
STRIKE = Strike(3.4, 0.3874631)


def before(fallen=()):
    situation = start_match(load("five_pins"), seed=3).situation
    rest = Rest(positions=PLACES, fallen=frozenset(map(PinId, fallen)))
    return replace(situation, rest=rest, phase="open", in_hand=None)


def test_the_referee_is_told_what_fell_and_who_felled_it():
    variant = load("five_pins")
    shot = play(variant, before(), Shot(strike=STRIKE))
    told = {one.pin: one.bodies for one in shot.events if isinstance(one, PinToppled)}
    assert told["head-pin"] == ("yellow",)
    assert told["centre-pin"] == ("yellow",)
    assert ("head-pin",) in told.values()
    words = [format_event(one) for one in shot.events]
    assert any(one.startswith("yellow topples head-pin at 0.2") for one in words)
    assert any(one.startswith("head-pin topples") for one in words)
    for sentence in words:
        assert format_event(parse_event(sentence, variant.program.vocabulary)) == sentence
    times = [one.time for one in shot.events]
    assert times == sorted(times)


def test_pins_score_and_stand_again_before_the_next_stroke():
    variant = load("five_pins")
    match = start_match(variant, seed=3)
    situation = before()
    shot = play(variant, situation, Shot(strike=STRIKE))
    verdict = judge_shot(variant, situation, shot)
    pins = {one.pin for one in shot.events if isinstance(one, PinToppled)}
    whites = len(pins - {"centre-pin"})
    assert verdict.points[0] >= 2 * whites + 4
    assert verdict.after.rest.fallen == frozenset()
    assert advance(match, shot, verdict).situation.rest.fallen == frozenset()


def test_a_pin_that_lies_is_not_in_the_next_stroke():
    variant = load("five_pins")
    situation = before(fallen=["head-pin", "centre-pin"])
    trace = simulate_shot(variant, situation, Shot(strike=STRIKE))
    assert set(trace.pins.stances(0.0)) == {"foot-pin", "left-pin", "right-pin"}
    shot = observe(variant, situation, Shot(strike=STRIKE), trace)
    assert not [one for one in shot.events if getattr(one, "pin", "") in {"head-pin", "centre-pin"}]


@pytest.mark.parametrize(("share", "stands"), [(1.01, True), (0.99, False)])
def test_a_pin_is_put_up_where_a_ball_leaves_it_air(share, stands):
    variant = load("danish_pins")
    pin = next(one for one in variant.world.table.pins if one.id == "foot-pin")
    ball = variant.world.balls[0]
    reach = meeting(pin.profile, ball.radius)[0]
    place = (pin.at[0] + share * reach, pin.at[1])
    lying = frozenset({PinId("foot-pin"), PinId("left-pin")})
    rest = set_up(variant, Rest(positions={ball.id: place}, fallen=lying), frozenset(lying))
    assert rest.fallen == (frozenset() if stands else {"foot-pin"})
    assert hypot(place[0] - pin.at[0], place[1]) == pytest.approx(share * reach)


def test_a_pin_that_stands_a_touch_is_told_as_touched():
    variant = load("danish_pins")
    pin = next(one for one in variant.world.table.pins if one.id == "head-pin")
    red = BallId("red")
    reach = meeting(pin.profile, variant.world.balls[0].radius)[0]
    rest = Rest(positions={red: (pin.at[0] - reach - 0.001, pin.at[1])})
    situation = replace(start_match(variant, seed=1).situation, rest=rest, in_hand=None)
    shot = play(variant, situation, Shot(strike=Strike(0.02, 0.0)))
    assert not [one for one in shot.events if isinstance(one, PinToppled)]
    touched = [one for one in shot.events if isinstance(one, PinTouched)]
    assert {(one.body, one.pin) for one in touched} == {("red", "head-pin")}
    assert format_event(touched[0]).startswith("red touches head-pin at ")
