"""The player's own keys, and the buttons that carry them."""

import pytest

from engine.app import commands
from engine.app.inputs import Input, KeyPressed
from engine.app.keyboard import Keyboard
from engine.app.keymap import Keymap, KeyTroubleError, keymap_of
from engine.app.prompts import buttons_of, hint_of
from engine.app.screen import Screen
from engine.app.session import Mode
from engine.app.settings import read_settings
from engine.app.steps import act
from engine.app.view import View, camera_of
from engine.app.wishes import wishes_of


def pressed(session, keymap, key):
    hands = Input()
    hands.feed([KeyPressed(key)])
    table = session.variant.world.table
    camera = camera_of(View("above"), table, (900, 500), session.cue_place, 0.0)
    screen = Screen((0, 0, 900, 500), camera, "above", {})
    return Keyboard(keymap).read(hands, session, screen, 0.0)


def test_a_key_of_the_players_own_does_what_it_was_given_for(start):
    session = act(start("snooker"), commands.Confirm())
    keymap = keymap_of({"turn": ["j", "l"], "confirm": "return"})
    assert pressed(session, keymap, "j") == [commands.Turn(1.0)]
    assert pressed(session, keymap, "l") == [commands.Turn(-1.0)]
    assert pressed(session, keymap, "left") == []
    assert pressed(session, keymap, "return") == [commands.Confirm()]
    assert pressed(session, keymap, "space") == []


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"strike": "space"}, "there is no action strike"),
        ({"confrim": "space"}, "did you mean 'confirm'"),
        ({"confirm": "f13"}, "there is no key 'f13'"),
        ({"confirm": []}, "at least one key"),
        ({"turn": ["j"]}, "2 keys are needed"),
        ({"turn": ["j", "j"]}, "twice"),
        ({"confirm": "x"}, "'x' is already centre"),
        ({"turn": ["a", "d"]}, "'a' is already spin"),
        ({"why": "left"}, "'left' is already turn"),
    ],
)
def test_keys_that_cannot_be_used_are_told(given, words):
    with pytest.raises(KeyTroubleError, match=words):
        keymap_of(given)


def test_keys_may_be_exchanged():
    keymap = keymap_of({"undo": "y", "redo": "u"})
    assert (keymap.shown("undo"), keymap.shown("redo")) == ("Y", "U")


def test_keys_of_different_moments_may_be_the_same():
    keymap = keymap_of({"move": ["a", "d", "w", "s"], "pick": ["w", "s"]})
    assert keymap.place("move", "d") == 1


def test_a_key_that_does_not_fit_is_told_with_its_line(tmp_path):
    path = tmp_path / "settings.toml"
    path.write_text('rate = 30\n[keys]\nundo = "l"\nwhy = "ö"\n', encoding="utf-8")
    (told,) = read_settings(path).troubles
    assert "settings.toml:4:7: keys.why: there is no key 'ö'" in told
    path.write_text('[keys]\nundo = "l"\n', encoding="utf-8")
    assert read_settings(path).settings.keymap.shown("undo") == "L"


def struck(session):
    for command in (commands.Confirm(), commands.SetSpeed(1.0), commands.Confirm()):
        session = act(session, command)
    return act(session, commands.Skip())


def test_every_moment_can_be_left_with_the_first_button(start):
    session = start("eight_ball")
    seen = []
    while session.mode not in seen:
        seen.append(session.mode)
        first = buttons_of(session, Keymap())[0]
        assert first.is_main
        session = act(session, wishes_of(first.action)[0])
    assert {Mode.PLACING, Mode.AIMING, Mode.STRIKING, Mode.VERDICT} <= set(seen)


def test_every_button_asks_for_something_and_carries_its_key(start):
    keymap = keymap_of({"confirm": "return"})
    for session in (start("eight_ball"), struck(start("eight_ball"))):
        for button in buttons_of(session, keymap):
            assert wishes_of(button.action)
        assert buttons_of(session, keymap)[0].key == "Enter"
        assert "None" not in hint_of(session)
