"""Hands to commands, without a window: the screen is a value."""

from dataclasses import replace
from math import atan2, hypot

import pytest

from engine.app import commands
from engine.app.before import begin
from engine.app.controls import Controls
from engine.app.inputs import (
    ButtonPressed,
    ButtonReleased,
    Input,
    KeyPressed,
    KeyReleased,
    MouseMoved,
    Wheeled,
)
from engine.app.screen import Screen
from engine.app.session import Mode
from engine.app.steps import act
from engine.app.stroke import FASTEST
from engine.app.view import View, camera_of
from engine.app.wishes import Ask
from engine.scene.camera import project

BOX = (0, 50, 900, 500)


def screen_of(session, name="above", hot=None):
    camera = camera_of(View(name), session.variant.world.table, BOX[2:], session.cue_place, 0.0)
    return Screen(BOX, camera, name, hot or {})


class Hands:
    """Feeds frames of events to the controls and obeys what they ask of the session."""

    def __init__(self, session, name="above", hot=None):
        self.session, self.name, self.hot = session, name, hot
        self.input, self.controls, self.asks = Input(), Controls(), []

    def frame(self, *events, seconds=1.0 / 60.0):
        self.input.feed(events)
        screen = screen_of(self.session, self.name, self.hot)
        for wish in self.controls.read(self.input, events, self.session, screen, seconds):
            if isinstance(wish, Ask):
                self.asks.append(wish)
            else:
                self.session = act(self.session, wish)
        return self

    def click(self, place, button=1):
        return self.frame(MouseMoved(place), ButtonPressed(button, place)).frame(
            ButtonReleased(button, place)
        )

    def at(self, point, height=0.0):
        x, y = project(screen_of(self.session, self.name).camera, BOX[2:], (*point, height))
        return round(x + BOX[0]), round(y + BOX[1])


@pytest.fixture
def aiming(start):
    session = start("three_cushion")
    return act(session, commands.Confirm()) if session.mode is Mode.PLACING else session


def test_a_click_on_the_cloth_aims_there(aiming):
    hands = Hands(aiming)
    hands.click(hands.at((0.2, 0.3), 0.03))
    x, y = aiming.cue_place
    way = hands.session.stroke.strike().heading

    assert way == pytest.approx(atan2(0.3 - y, 0.2 - x), abs=0.01)


def test_dragging_behind_the_cue_turns_the_aim_and_shift_turns_it_less(aiming):
    turned = []
    for shift in (False, True):
        hands = Hands(aiming, "cue")
        if shift:
            hands.frame(KeyPressed("left shift"))
        hands.frame(MouseMoved((450, 300)), ButtonPressed(1, (450, 300)))
        hands.frame(MouseMoved((500, 300))).frame(ButtonReleased(1, (500, 300)))
        turned.append(aiming.stroke.heading - hands.session.stroke.heading)
    assert turned[0] > 5 * turned[1] > 0.0


def test_drawing_back_and_letting_go_strikes_as_hard_as_was_drawn(aiming):
    hands = Hands(aiming)
    hands.frame(MouseMoved((450, 300)), ButtonPressed(3, (450, 300)))
    hands.frame(MouseMoved((450, 430)))
    assert hands.session.stroke.speed == pytest.approx(FASTEST / 2.0)
    hands.frame(ButtonReleased(3, (450, 430)))
    assert hands.session.mode is Mode.STRIKING


def test_pushing_back_to_where_it_began_does_not_strike(aiming):
    hands = Hands(aiming)
    hands.frame(MouseMoved((450, 300)), ButtonPressed(3, (450, 300)))
    hands.frame(MouseMoved((450, 400))).frame(MouseMoved((450, 300)))
    hands.frame(ButtonReleased(3, (450, 300)))
    assert hands.session.mode is Mode.AIMING
    assert hands.session.stroke.speed == aiming.stroke.speed


def test_the_gauges_are_set_by_clicking_them(aiming):
    hot = {"tip": (0, 600, 100, 100), "power": (200, 600, 100, 10), "elevation": (400, 600, 80, 10)}
    hands = Hands(aiming, hot=hot).click((75, 625)).click((225, 605)).click((440, 605))
    stroke = hands.session.stroke
    assert hypot(stroke.side, stroke.follow) <= hands.session.tip_limit
    assert stroke.side > 0.2
    assert stroke.follow > 0.2
    assert stroke.speed == pytest.approx(FASTEST / 4.0)
    assert stroke.elevation == pytest.approx(40.0)


def test_two_keys_at_once_move_the_tip_both_ways(aiming):
    hands = Hands(aiming).frame(KeyPressed("w"), KeyPressed("d"))
    assert hands.session.stroke.side > 0.0
    assert hands.session.stroke.follow > 0.0


def test_shift_makes_a_step_fine(aiming):
    coarse = Hands(aiming).frame(KeyPressed("left"), KeyReleased("left"))
    fine = Hands(aiming).frame(KeyPressed("left shift"), KeyPressed("left"), KeyReleased("left"))
    assert coarse.session.stroke == aiming.stroke.turned(1.0)
    assert fine.session.stroke == aiming.stroke.turned(0.01)


def test_a_held_key_repeats_after_a_moment_only(aiming):
    hands = Hands(aiming).frame(KeyPressed("up"))
    for _ in range(12):
        hands.frame()
    assert hands.session.stroke.speed == pytest.approx(aiming.stroke.speed + 0.1)
    for _ in range(30):
        hands.frame()
    assert hands.session.stroke.speed > aiming.stroke.speed + 0.5


def test_the_ball_in_hand_follows_the_mouse_within_its_zone(start):
    hands = Hands(start("eight_ball"))
    hands.frame(MouseMoved((1, 60)), ButtonPressed(1, hands.at((-0.9, 0.2), 0.03)))
    assert hands.session.place == pytest.approx((-0.9, 0.2), abs=0.01)
    hands.frame(MouseMoved(hands.at((0.9, 0.2), 0.03)))
    assert hands.session.place[0] < -0.6
    hands.frame(ButtonReleased(1, (1, 60)))
    assert hands.session.mode is Mode.PLACING


def test_arrows_move_the_ball_as_the_screen_lies(start):
    session = start("eight_ball")
    session = act(session, commands.PutBall((-0.9, 0.0)))
    right = Hands(session).frame(KeyPressed("right"), KeyReleased("right")).session.place
    up = Hands(session).frame(KeyPressed("up"), KeyReleased("up")).session.place
    assert right == pytest.approx((-0.89, 0.0), abs=1e-5)
    assert up == pytest.approx((-0.9, 0.01), abs=1e-5)


@pytest.fixture
def nominating(start):
    session = start("eight_ball")
    situation = replace(session.match.situation, phase="open", in_hand=None)
    lying = {**situation.rest.positions, "cue": (-0.6, 0.3)}
    situation = replace(situation, rest=replace(situation.rest, positions=lying))
    return begin(replace(session.match, situation=situation))


def test_a_ball_and_a_pocket_are_called_by_clicking_them(nominating):
    assert nominating.mode is Mode.CALLING
    hands = Hands(nominating)
    pocket = nominating.variant.world.table.pockets[0]
    hands.click(hands.at(nominating.layout["1"], 0.028)).click(hands.at(pocket.centre))
    assert (hands.session.call.ball, hands.session.call.pocket) == ("1", pocket.id)


def test_the_cue_ball_cannot_be_called(nominating):
    hands = Hands(nominating)
    assert hands.click(hands.at(nominating.layout["cue"], 0.028)).session.call.ball is None


def test_a_choice_is_taken_by_click_and_by_number(start):
    session = start("eight_ball")
    for command in (commands.Confirm(), commands.SetSpeed(1.0), commands.Confirm()):
        session = act(session, command)
    session = act(act(session, commands.Skip()), commands.Confirm())
    assert session.mode is Mode.CHOOSING
    by_click = Hands(session, hot={"option:1": (950, 100, 200, 30)}).click((1000, 110))
    by_key = Hands(session).frame(KeyPressed("left shift"), KeyPressed("2"))
    assert by_click.session.mode is not Mode.CHOOSING
    assert by_key.session.choice == by_click.session.choice
    assert by_key.asks == []


def test_numbers_without_shift_are_renderers_in_every_mode(start, aiming):
    for session in (start("eight_ball"), aiming):
        hands = Hands(session).frame(KeyPressed("2"))
        assert [ask.action for ask in hands.asks] == ["painter"]


def test_the_wheel_zooms_and_the_middle_button_turns_the_view(aiming):
    hands = Hands(aiming).frame(Wheeled(2))
    assert hands.asks == [Ask("zoom", 2.0)]
    hands.frame(MouseMoved((300, 300)), ButtonPressed(2, (300, 300))).frame(MouseMoved((320, 310)))
    assert {ask.action for ask in hands.asks[1:]} == {"orbit", "tilt"}
