from dataclasses import replace

import pytest

from engine.app import commands
from engine.app.before import begin
from engine.app.choices import choice_words
from engine.app.keymap import Keymap
from engine.app.prompts import buttons_of, hint_of
from engine.app.session import Mode
from engine.app.steps import act
from engine.game.match import advance, start_match
from engine.game.observe import observe, simulate_shot
from engine.game.referee import judge_shot
from engine.game.shot import Shot
from engine.physics.world import Strike
from engine.variant.load import load_variant


@pytest.fixture
def opened():
    """Return the session after a legal break from which any ball may be struck."""
    variant = load_variant("free_pyramid")
    match = start_match(variant, None, {}, 1)
    for strike in (Strike(6.0, 0.02), Strike(2.0, 2.0)):
        ahead = match.situation
        shot = Shot(
            choice="play" if "play" in ahead.options else None,
            placement=(-1.0, 0.1) if ahead.in_hand else None,
            strike=strike,
        )
        seen = observe(variant, ahead, shot, simulate_shot(variant, ahead, shot))
        match = advance(match, seen, judge_shot(variant, ahead, seen))
        if match.situation.phase == "open" and match.situation.strikable:
            break
    return begin(match)


def _aiming(session):
    while session.mode is not Mode.AIMING:
        session = act(session, commands.Confirm())
    return session


def test_another_ball_can_be_struck_where_the_rules_allow_it(opened):
    session = _aiming(opened)
    usual = session.cue_ball
    other = act(session, commands.StrikeNextBall(1))
    assert other.cue_ball != usual
    assert other.cue_place == other.ahead.rest.positions[other.cue_ball]
    assert "struck" in [one.action for one in buttons_of(other, Keymap())]
    played = act(other, commands.Confirm())
    assert played.last.shot.struck == other.cue_ball
    assert act(other, commands.StrikeNextBall(-1)).cue_ball == usual


def test_the_round_of_strikable_balls_comes_back_to_the_first(opened):
    session = _aiming(opened)
    seen = [session.cue_ball]
    for _ in range(len(session.strikable) - 1):
        session = act(session, commands.StrikeNextBall(1))
        seen.append(session.cue_ball)
    assert sorted(seen) == sorted(session.strikable)
    assert act(session, commands.StrikeNextBall(1)).cue_ball == seen[0]


def test_only_the_cue_ball_can_be_struck_elsewhere(start):
    session = _aiming(start("eight_ball"))
    refused = act(session, commands.StrikeNextBall(1))
    assert refused.note == "the rules let you strike no other ball than the cue ball"
    assert replace(refused, note="") == session
    assert "struck" not in [one.action for one in buttons_of(session, Keymap())]


def _choosing(opened):
    """Return the session in which a ball is to be taken off after a foul."""
    session = _aiming(opened)
    session = replace(session, stroke=session.stroke.at(0.02))
    session = act(act(session, commands.Confirm()), commands.Skip())
    session = act(session, commands.Confirm())
    assert session.mode is Mode.CHOOSING
    assert "remove-ball" in session.match.situation.options
    return session


def test_a_choice_about_a_ball_names_it(opened):
    session = _choosing(opened)
    assert "click the ball" in hint_of(session)
    ball = session.choosable[3]
    named = act(session, commands.CallBall(ball))
    words = choice_words(named.variant, named.match.situation, "remove-ball", ball)
    assert "off the table" in words
    taken = act(named, commands.Confirm())
    assert ball not in taken.ahead.on_table
    assert taken.shot.call.ball == ball
    assert taken.shot.choice == "remove-ball"


def test_tab_goes_through_the_balls_of_a_choice(opened):
    session = _choosing(opened)
    first = act(session, commands.CallNextBall(1))
    second = act(first, commands.CallNextBall(1))
    assert (first.call.ball, second.call.ball) == session.choosable[:2]


def test_a_choice_about_no_ball_takes_none(start):
    session = start("nine_ball")
    session = replace(session, mode=Mode.CHOOSING) if session.mode is Mode.CHOOSING else session
    assert session.choosable == ()
