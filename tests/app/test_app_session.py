from dataclasses import replace
from math import cos, hypot, sin

import pytest

from engine.app import commands
from engine.app.before import begin
from engine.app.session import Aid, Mode
from engine.app.steps import act, pass_time
from engine.app.stroke import FASTEST
from engine.game.match import start_match
from engine.game.placing import refuse_place


def do(session, *asked):
    for command in asked:
        session = act(session, command)
    return session


def struck(session, speed=8.0, heading=None):
    """Return the session with all that must be done before the stroke done, and the stroke."""
    if session.mode is Mode.PLACING:
        session = do(session, commands.Confirm())
    if session.mode is Mode.CALLING:
        session = do(session, commands.CallNextBall(1), commands.CallNextPocket(1))
        session = do(session, commands.Confirm())
    if heading is not None:
        session = do(session, commands.Turn(heading - session.stroke.heading))
    return do(session, commands.SetSpeed(speed), commands.Confirm())


def ended(session):
    return do(session, commands.Skip())


def test_a_game_begins_with_the_cue_ball_in_hand(start):
    session = start("eight_ball")
    assert session.mode is Mode.PLACING
    assert session.place is not None
    assert refuse_place(session.variant, session.ahead, session.place) is None


def test_the_ball_in_hand_stays_in_its_zone_and_off_other_balls(start):
    session = start("snooker")
    for wish in [(0.0, 0.0), (-9.0, 9.0), (1.3, 0.0), *session.layout.values()]:
        moved = do(session, commands.PutBall(wish))
        assert refuse_place(moved.variant, moved.ahead, moved.place) is None, wish


def test_the_ball_in_hand_goes_where_it_may(start):
    session = start("eight_ball")
    x, y = session.place
    moved = do(session, commands.MoveBall(-0.05, 0.02))
    assert moved.place == pytest.approx((x - 0.05, y + 0.02), abs=1e-6)


def test_aiming_does_not_move_a_ball_that_is_put_down(start):
    session = do(start("eight_ball"), commands.Confirm())
    assert session.mode is Mode.AIMING
    assert do(session, commands.PutBall((-1.0, 0.1))).place == session.place


def test_back_leads_to_the_placing(start):
    session = do(start("eight_ball"), commands.Confirm(), commands.Back())
    assert session.mode is Mode.PLACING


def test_the_aim_points_where_the_cloth_was_clicked(start):
    session = do(start("three_cushion"), commands.AimAt((0.0, 0.0)))
    x, y = session.cue_place
    way = session.stroke.strike().heading
    away = hypot(x, y)
    assert (x + away * cos(way), y + away * sin(way)) == pytest.approx((0.0, 0.0), abs=1e-3)


def test_the_tip_is_clamped_at_the_miscue_limit(start):
    session = do(start("three_cushion"), commands.SetTip(1.0, -1.0))
    assert hypot(session.stroke.side, session.stroke.follow) <= session.tip_limit
    assert session.stroke.side > 0 > session.stroke.follow


def test_a_strike_is_judged_and_entered_before_it_is_seen(start):
    session = struck(start("eight_ball"))
    assert session.mode is Mode.STRIKING
    assert len(session.match.played) == 1
    assert session.shown is session.match.played[0].before


@pytest.mark.parametrize("step", [1.0 / 24.0, 1.0 / 60.0, 3.7])
def test_the_frame_rate_changes_nothing_in_the_outcome(start, step):
    struck_one = struck(start("eight_ball"))
    shown = struck_one
    for _ in range(3000):
        shown = pass_time(shown, step)
    assert shown.mode is Mode.VERDICT
    assert shown.match is struck_one.match


def test_time_goes_from_the_cue_to_the_balls_to_the_verdict(start):
    session = struck(start("eight_ball"))
    seen = [session.mode]
    while session.mode is not Mode.VERDICT:
        session = pass_time(session, 0.05)
        seen.append(session.mode)
    assert list(dict.fromkeys(seen)) == [Mode.STRIKING, Mode.ROLLING, Mode.VERDICT]


def test_a_slow_break_leaves_the_opponent_a_choice_and_the_choice_is_his(start):
    session = do(ended(struck(start("eight_ball"), speed=1.0)), commands.Confirm())
    assert session.mode is Mode.CHOOSING
    options = session.match.situation.options
    assert session.match.situation.shooter == 2
    chosen = do(session, commands.Choose(options.index("rerack-offender-breaks")))
    assert chosen.match.situation.shooter == 1
    assert chosen.mode is Mode.PLACING
    assert len(chosen.match.played) == 2


def test_a_choice_that_keeps_the_turn_goes_with_the_stroke(start):
    session = do(ended(struck(start("eight_ball"), speed=1.0)), commands.Confirm())
    index = session.match.situation.options.index("play")
    session = do(session, commands.Choose(index))
    assert session.choice == "play"
    session = struck(session, speed=3.0)
    assert session.last.shot.choice == "play"
    assert session.last.shot.strike is not None


def test_choices_are_picked_by_going_down_the_list(start):
    session = do(ended(struck(start("eight_ball"), speed=1.0)), commands.Confirm())
    count = len(session.match.situation.options)
    assert do(session, commands.Pick(1)).picked == 1
    assert do(session, commands.Pick(-1)).picked == count - 1
    assert do(session, commands.Choose(99)) == session


def missed_break(start):
    """Return a session that must call: the table is open."""
    session = do(ended(struck(start("eight_ball"), speed=9.0)), commands.Confirm())
    while session.mode is Mode.CHOOSING:
        session = do(session, commands.Choose(0))
    if session.mode is Mode.PLACING:
        session = do(session, commands.Confirm())
    return session


def test_a_missing_call_is_asked_for_and_not_let_through(start):
    session = missed_break(start)
    assert session.mode is Mode.CALLING
    assert (session.wanted.ball, session.wanted.pocket, session.wanted.safety) == (True,) * 3
    refused = do(session, commands.Confirm())
    assert refused.mode is Mode.CALLING
    assert "a ball and a pocket, or a safety" in refused.note


def test_a_call_is_made_by_steps_and_replaced_by_a_safety(start):
    session = do(missed_break(start), commands.CallNextBall(1), commands.CallNextPocket(1))
    assert session.call.ball in session.ahead.on_table
    assert session.call.pocket is not None
    assert do(session, commands.Confirm()).mode is Mode.AIMING
    safe = do(session, commands.CallSafety())
    assert (safe.call.safety, safe.call.ball) == (True, None)
    assert do(safe, commands.CallSafety()).call.safety is False


def test_steps_through_the_balls_come_round(start):
    session = missed_break(start)
    balls = len(session.ahead.on_table) - 1
    first = do(session, commands.CallNextBall(1)).call
    assert do(session, *[commands.CallNextBall(1)] * (balls + 1)).call == first


def test_every_ball_can_be_nominated_where_a_call_changes_what_is_on(start):
    session = start("snooker")
    situation = replace(session.match.situation, phase="colour", in_hand=None)
    lying = {**situation.rest.positions, "cue": (0.0, 0.3)}
    situation = replace(situation, rest=replace(situation.rest, positions=lying))
    session = begin(replace(session.match, situation=situation))
    assert session.mode is Mode.CALLING
    called = []
    for _ in range(len(situation.on_table) - 1):
        session = do(session, commands.CallNextBall(1))
        called.append(session.call.ball)
    assert len(set(called)) == len(called)
    assert all(not ball.startswith("red") for ball in called[:6])


def test_undo_and_redo_lead_there_and_back(start):
    session = do(ended(struck(start("three_cushion"))), commands.Confirm())
    back = do(session, commands.Undo())
    assert back.match.played == ()
    assert do(back, commands.Redo()).match is session.match
    assert do(do(back, commands.Undo()), commands.Redo()).match is session.match


def test_undo_of_nothing_says_so(start):
    assert "no shot" in do(start("three_cushion"), commands.Undo()).note


def test_a_new_stroke_after_undo_forgets_what_was_undone(start):
    session = do(ended(struck(start("three_cushion"))), commands.Undo())
    assert struck(session, speed=2.0).later == ()


def test_a_replay_leads_back_to_where_it_was_called(start):
    session = do(ended(struck(start("three_cushion"))), commands.Confirm(), commands.Replay(0.25))
    assert session.mode is Mode.STRIKING
    assert session.pace == 0.25
    assert len(session.match.played) == 1
    assert ended(session).mode is Mode.AIMING


def test_a_stroke_can_be_seen_again_after_undo_and_redo(start):
    session = ended(struck(start("eight_ball")))
    again = do(session, commands.Undo(), commands.Redo())
    assert again.trace is None
    again = do(again, commands.Replay())
    assert again.mode is Mode.STRIKING
    assert again.trace.hash() == session.trace.hash()


def test_before_the_first_stroke_there_is_nothing_to_see_again(start):
    session = start("three_cushion")
    assert do(session, commands.Replay()) == session


def test_the_aids_come_round(start):
    session = start("three_cushion")
    seen = []
    for _ in range(len(Aid)):
        session = do(session, commands.ChangeAid())
        seen.append(session.aid)
    assert set(seen) == set(Aid)
    assert len(seen) == 5


def test_keys_of_another_mode_change_nothing(start):
    session = start("three_cushion")
    for command in (commands.Choose(0), commands.Pick(1), commands.CallSafety(), commands.Skip()):
        assert do(session, command) == session


def test_while_balls_roll_nothing_can_be_set(start):
    session = struck(start("three_cushion"))
    for command in (commands.Turn(5.0), commands.SetSpeed(1.0), commands.MoveTip(0.1, 0.0)):
        assert do(session, command) == session
    assert not do(session, commands.Confirm()).match.played[1:]


def test_power_cannot_exceed_an_arm(start):
    assert do(start("three_cushion"), commands.SetSpeed(1e9)).stroke.speed == FASTEST


@pytest.mark.parametrize("match_over", [False, True])
def test_the_next_game_has_the_same_players_and_settings(start, match_over):
    session = start("three_cushion", target=5)
    over = replace(session.match.situation, winner=1, match_over=match_over)
    session = begin(replace(session.match, situation=over))
    assert session.mode is Mode.OVER
    again = do(session, commands.NextGame())
    assert again.mode is not Mode.OVER
    assert again.match.settings == session.match.settings
    assert again.match.seed == session.match.seed + (1 if match_over else 0)
    assert again.match.situation.games == (0 if match_over else 1)
    assert again.match.situation.shooter == (1 if match_over else 2)


def test_the_same_commands_give_the_same_match(start):
    one, two = (ended(struck(start("snooker"), heading=3.0)) for _ in range(2))
    ends = [replace(each.match.situation, judged=None) for each in (one, two)]
    assert ends[0] == ends[1]
    assert one.trace.hash() == two.trace.hash()


def test_starting_a_match_reads_no_clock(start):
    session = start("snooker")
    other = begin(start_match(session.variant, None, {}, 1))
    assert other.match.situation == session.match.situation
