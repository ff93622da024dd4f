"""A stroke looked at again: slower, faster, halted, step by step."""

import pytest

from engine.app import commands
from engine.app.board import asked
from engine.app.replaying import PACES, STEP
from engine.app.session import SHOWING, SWING, Mode
from engine.app.steps import act, pass_time


def do(session, *asked_for):
    for command in asked_for:
        session = act(session, command)
    return session


@pytest.fixture
def rolling(start):
    session = start("three_cushion")
    while session.mode not in SHOWING:
        session = act(session, commands.Confirm())
    return pass_time(session, SWING + 0.5)


def test_a_showing_halts_and_goes_on(rolling):
    halted = do(rolling, commands.Confirm())
    assert pass_time(halted, 1.0).clock == rolling.clock
    assert "halted at 0.50 s" in asked(halted)
    assert pass_time(do(halted, commands.Confirm()), 1.0).clock == pytest.approx(1.5)


def test_steps_go_both_ways_and_halt(rolling):
    on = do(rolling, commands.StepShown(1), commands.StepShown(1))
    assert on.clock == pytest.approx(rolling.clock + 2.0 * STEP)
    assert on.halted
    back = do(on, *[commands.StepShown(-1)] * 500)
    assert back.clock == -SWING
    assert back.mode is Mode.STRIKING
    end = do(on, *[commands.StepShown(1)] * 5000)
    assert end.clock == end.trace.duration
    assert end.mode is Mode.ROLLING
    assert do(end, commands.Skip()).mode is Mode.VERDICT


def test_the_pace_has_steps_and_ends(rolling):
    slow = do(rolling, *[commands.ChangePace(-1)] * 9)
    assert slow.pace == PACES[0]
    assert pass_time(slow, 1.0).clock == pytest.approx(rolling.clock + PACES[0])
    assert "0.1 times as fast" in asked(slow)
    assert do(slow, *[commands.ChangePace(1)] * 9).pace == PACES[-1]


def test_again_begins_anew_also_while_it_is_shown(rolling):
    again = do(rolling, commands.Replay(0.25))
    assert (again.clock, again.pace) == (-SWING, 0.25)
    assert again.back_to is None
    over = do(again, commands.Skip())
    assert over.mode is Mode.VERDICT
    later = do(over, commands.Replay(), commands.Replay(0.5), commands.Skip())
    assert later.mode is Mode.VERDICT


def test_nothing_of_it_does_anything_where_nothing_is_shown(start):
    session = start("three_cushion")
    assert do(session, commands.StepShown(1), commands.ChangePace(1)) == session


def test_looking_changes_nothing_in_the_match(rolling):
    seen = do(
        rolling, commands.Confirm(), commands.StepShown(3), commands.Replay(), commands.Skip()
    )
    assert seen.match is rolling.match
