"""Practice: any ball anywhere it can lie, layouts kept, a stroke played again."""

from dataclasses import replace
from math import hypot

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine.app import commands
from engine.app.arranging import LayoutError, load_layout, save_layout, with_ball
from engine.app.keeping import Keeper
from engine.app.practising import lay
from engine.app.session import Mode
from engine.app.steps import act
from engine.game.match import start_match
from engine.table.region import has_room
from engine.variant.load import load_variant


def to(session, mode):
    """Return the session at a mode, all that comes before accepted."""
    for _ in range(20):
        if session.mode is mode:
            return session
        skip = session.mode in (Mode.STRIKING, Mode.ROLLING)
        session = act(session, commands.Skip() if skip else commands.Confirm())
    raise AssertionError(session.mode)


def test_a_ball_goes_where_it_is_put_and_the_game_goes_on_from_there(start):
    session = act(start("nine_ball"), commands.Arrange())
    assert session.mode is Mode.ARRANGING
    session = act(act(session, commands.CallBall("9")), commands.PutBall((-0.3, 0.2)))
    assert session.ahead.rest.positions["9"] == (-0.3, 0.2)
    played = act(session, commands.Arrange())
    assert played.match.situation.rest.positions["9"] == (-0.3, 0.2)
    assert played.match.played == ()
    done = to(played, Mode.VERDICT)
    assert done.match.played[0].before.rest.positions["9"] == (-0.3, 0.2)


def test_what_was_arranged_by_mistake_is_left_as_it_was(start):
    before = start("nine_ball")
    arranged = act(act(before, commands.Arrange()), commands.PutBall((0.2, 0.2)))
    after = act(arranged, commands.Back())
    assert after.match is before.match
    assert after.mode is before.mode
    assert after.ahead == before.ahead
    assert after.timing == arranged.timing


def test_what_was_said_before_makes_way_for_the_hint_of_arranging(start):
    told = replace(start("nine_ball"), note="kept somewhere")
    assert act(told, commands.Arrange()).note == ""


def test_a_ball_is_taken_off_and_brought_back(start):
    session = act(act(start("eight_ball"), commands.Arrange()), commands.CallBall("8"))
    off = act(session, commands.TakeOff())
    assert "8" not in off.ahead.on_table
    assert "8" not in off.layout
    back = act(off, commands.TakeOff())
    assert "8" in back.ahead.on_table
    assert "8" in back.layout


def test_tab_goes_through_all_balls_also_those_off_the_table(start):
    session = act(start("three_cushion"), commands.Arrange())
    held = []
    for _ in range(3):
        held.append(session.held)
        session = act(session, commands.CallNextBall(1))
    assert set(held) == {"white", "yellow", "red"}


@settings(max_examples=60, deadline=None)
@given(st.floats(-2.0, 2.0), st.floats(-1.0, 1.0), st.sampled_from(["cue", "1", "9"]))
def test_no_ball_is_put_where_it_cannot_lie(x, y, ball):
    variant = load_variant_once()
    situation = start_match(variant, None, {}, 1).situation
    after = with_ball(variant, situation, ball, (x, y))
    radii = {one.id: one.radius for one in variant.world.balls}
    lying = after.rest.positions
    if after is situation:
        return
    assert has_room(variant.world.table, lying[ball], radii[ball])
    for other, at in lying.items():
        if other != ball:
            apart = hypot(at[0] - lying[ball][0], at[1] - lying[ball][1])
            assert apart >= radii[ball] + radii[other]


_KNOWN = {}


def load_variant_once():
    if "nine" not in _KNOWN:
        _KNOWN["nine"] = load_variant("nine_ball")
    return _KNOWN["nine"]


def test_a_stroke_is_played_again_from_where_the_balls_lay(start):
    session = to(start("three_cushion"), Mode.AIMING)
    session = act(act(session, commands.SetSpeed(3.3)), commands.MoveTip(0.2, 0.1))
    done = to(act(session, commands.Confirm()), Mode.VERDICT)
    again = act(done, commands.Repeat())
    assert again.mode is Mode.AIMING
    assert again.layout == session.layout
    assert again.shot.strike.speed == 3.3
    assert again.shot.strike.side == session.shot.strike.side
    second = to(act(again, commands.Confirm()), Mode.VERDICT)
    assert second.trace.hash() == done.trace.hash()


def test_there_is_nothing_to_repeat_before_the_first_stroke(start):
    assert "no stroke" in act(start("snooker"), commands.Repeat()).note


def test_a_kept_layout_is_laid_out_again(start, tmp_path):
    keeper = Keeper(tmp_path / "journal.toml", tmp_path / "shots")
    session = act(start("nine_ball"), commands.Arrange())
    session = act(act(session, commands.CallBall("9")), commands.PutBall((0.1, 0.4)))
    assert keeper.keep_layout(session).startswith("kept ")
    name, situation = keeper.next_layout(start("nine_ball"))
    assert name == "nine_ball-001"
    again = lay(start("nine_ball"), situation)
    assert again.match.situation.rest.positions == session.layout
    assert again.mode is not Mode.ARRANGING
    assert keeper.next_layout(start("snooker")) is None


@pytest.mark.parametrize(
    ("text", "wrong"),
    [
        ("positions", "cannot be read"),
        ("variant = 'nine_ball'", "no positions"),
        ("[positions]\nqueue = [0.0, 0.0]", "no ball queue"),
        ("[positions]\n9 = [0.0]", "a place is [x, y]"),
        ("[positions]\n9 = [0.0, 9.0]", "does not lie on the bed"),
        ("[positions]\n9 = [0.0, 0.0]\n8 = [0.01, 0.0]", "no room beside"),
    ],
)
def test_a_layout_that_cannot_be_laid_says_why(tmp_path, text, wrong):
    path = tmp_path / "nine_ball-001.toml"
    path.write_text(text, encoding="utf-8")
    variant = load_variant_once()
    with pytest.raises(LayoutError, match=wrong.replace("[", r"\[")):
        load_layout(path, variant, start_match(variant, None, {}, 1).situation)


def test_the_match_before_stays_in_its_own_journal(start, tmp_path):
    session = start("three_cushion")
    keeper = Keeper(tmp_path / "journal.toml", tmp_path / "shots")
    keeper.start(session.match)
    played = to(session, Mode.VERDICT)
    keeper.follow(played.match)
    before = (tmp_path / "journal.toml").read_text(encoding="utf-8")
    arranged = act(act(played, commands.Arrange()), commands.Arrange())
    keeper.follow(arranged.match)
    assert (tmp_path / "journal.toml").read_text(encoding="utf-8") == before
    assert keeper.path != tmp_path / "journal.toml"


def test_layout_files_say_what_they_are_for(start, tmp_path):
    session = start("nine_ball")
    save_layout(tmp_path / "a.toml", session.variant, replace(session.ahead))
    assert 'variant = "nine_ball"' in (tmp_path / "a.toml").read_text(encoding="utf-8")
