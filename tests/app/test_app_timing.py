"""Timers of a script in the window; time comes in by the second, no clock is read."""

from dataclasses import replace

from engine.app import commands
from engine.app.before import begin
from engine.app.board import board_of
from engine.app.keeping import Keeper
from engine.app.session import Mode
from engine.app.steps import act, pass_time
from engine.app.telling import verdict_lines
from engine.app.timing import run_down
from engine.records.journal import resume
from engine.records.read import read_record
from engine.records.run import run_record
from engine.records.write import save_shot_record
from engine.variant.load import load_variant


def ready(session):
    """Return the session with the cue ball put down, and a first frame seen."""
    while session.mode in (Mode.PLACING, Mode.CALLING):
        session = act(session, commands.CallNextBall(1))
        session = act(session, commands.Confirm())
    return pass_time(session, 0.0)


def test_a_shot_clock_runs_while_the_player_is_at_the_table(start):
    session = pass_time(ready(start("shoot_out")), 6.0)
    assert session.timing.clock.left["shot-clock"] == 9.0
    away = pass_time(session, 6.0, at_table=False)
    assert away.timing.clock.left["shot-clock"] == 9.0
    assert away.timing.clock.left["frame-clock"] == 588.0


def test_a_shot_clock_that_ran_out_is_a_foul_of_the_script(start):
    session = pass_time(pass_time(ready(start("shoot_out")), 10.5), 4.0)
    assert session.mode is Mode.AIMING
    session = pass_time(session, 1.0)
    assert session.mode is Mode.VERDICT
    assert [foul.name for foul in session.verdict.fouls] == ["time-foul"]
    assert session.match.situation.shooter == 2
    assert session.match.situation.scores == (0, 4)
    after = ready(act(session, commands.Confirm()))
    assert after.mode is Mode.AIMING
    assert after.timing.clock.left["shot-clock"] == 15.0
    assert after.timing.clock.left["frame-clock"] == 584.5


def test_a_timer_without_consequence_does_not_end_the_shot_but_is_told_with_it(start):
    session = ready(start("shoot_out"))
    timing = session.timing
    left = {**timing.clock.left, "first-half": 1.0}
    session = replace(session, timing=replace(timing, clock=replace(timing.clock, left=left)))
    session = pass_time(session, 2.0)
    assert session.mode is Mode.AIMING
    session = act(session, commands.Confirm())
    assert session.match.played[-1].shot.facts == {"first-half": True}
    assert session.match.situation.state["second-half"] is True
    session = act(act(session, commands.Skip()), commands.Confirm())
    session = pass_time(pass_time(ready(session), 9.5), 1.0)
    assert session.mode is Mode.VERDICT
    assert "short-shot-clock" in session.last.shot.facts


def test_the_frame_ends_when_its_time_is_up_also_where_that_was_while_balls_rolled(start):
    session = ready(start("shoot_out"))
    left = {**session.timing.clock.left, "frame-clock": 0.2}
    timing = replace(session.timing, clock=replace(session.timing.clock, left=left))
    session = act(replace(session, timing=timing), commands.Confirm())
    session = pass_time(pass_time(session, 0.1), 0.2)
    assert session.mode is Mode.STRIKING or session.mode is Mode.ROLLING
    assert not session.match.situation.over
    session = pass_time(ready(act(act(session, commands.Skip()), commands.Confirm())), 0.1)
    assert session.match.situation.over
    assert act(session, commands.Confirm()).mode is Mode.OVER


def test_what_is_taken_back_takes_its_time_back(start):
    session = pass_time(ready(start("shoot_out")), 15.5)
    assert session.mode is Mode.VERDICT
    back = act(session, commands.Undo())
    assert back.match.played == ()
    assert back.timing.clock.left["frame-clock"] == 600.0
    assert pass_time(ready(back), 1.0).mode is Mode.AIMING
    again = act(back, commands.Redo())
    assert again.match is session.match
    assert again.timing.clock.left["frame-clock"] == 584.5


def test_no_time_runs_while_a_choice_is_open_balls_are_arranged_or_the_game_is_over(start):
    session = ready(start("shoot_out"))
    arranging = act(session, commands.Arrange())
    assert pass_time(arranging, 99.0) is arranging
    over = begin(replace(session.match, situation=replace(session.match.situation, winner=1)))
    assert pass_time(over, 99.0) is over


def test_a_game_without_timers_is_left_as_it_is(start):
    session = start("snooker")
    assert pass_time(session, 99.0) is session


def test_the_time_left_is_shown_and_marked_when_it_is_short(start):
    board = board_of(pass_time(ready(start("shoot_out")), 1.5))
    assert [(one.left, one.is_short) for one in board.own_time] == [("14", False)]
    assert [one.left for one in board.time] == ["9:59", "4:59"]
    board = board_of(pass_time(ready(start("shoot_out")), 10.5))
    assert [(one.left, one.is_short) for one in board.own_time] == [("5", True)]


def test_a_time_out_is_explained_and_resumed(start, tmp_path):
    session = ready(start("shoot_out"))
    keeper = Keeper(tmp_path / "journal.toml", tmp_path / "shots")
    keeper.start(session.match)
    session = pass_time(session, 15.5)
    keeper.follow(session.match)
    said = [line.text for line in verdict_lines(session.variant, session.last)]
    assert "Shot clock ran out" in said
    assert session.last_judged is session.last
    kept = resume(keeper.path, load_variant)
    assert kept.played[-1].shot == session.last.shot
    assert replace(kept.situation, judged=None) == replace(session.match.situation, judged=None)
    path = tmp_path / "shot.toml"
    save_shot_record(path, session.match)
    assert run_record(read_record(path, load_variant)).passed


def test_a_timer_that_was_told_to_be_out_stays_out_when_the_match_is_resumed(start):
    session = ready(start("shoot_out"))
    timing = run_down(session.timing, 301.0, ("game",))
    session = act(replace(session, timing=timing), commands.Confirm())
    assert begin(session.match).timing.clock.left["first-half"] == 0.0
    assert begin(session.match).timing.ran_out == ()


def lost(session):
    """Return the session after the game was ended by its clock."""
    timing = run_down(ready(session).timing, 601.0, ("game",))
    session = pass_time(replace(ready(session), timing=timing), 0.1)
    return act(session, commands.Confirm())


def test_games_in_a_row_are_one_journal(start, tmp_path):
    session = start("shoot_out")
    keeper = Keeper(tmp_path / "journal.toml", tmp_path / "shots")
    keeper.start(session.match)
    session = pass_time(pass_time(ready(session), 15.5), 0.0)
    keeper.follow(session.match)
    session = lost(act(session, commands.Confirm()))
    keeper.follow(session.match)
    assert session.mode is Mode.OVER
    session = act(session, commands.NextGame())
    keeper.follow(session.match)

    def kept():
        match = resume(keeper.path, load_variant)
        assert len(match.played) == len(session.match.played)
        assert replace(match.situation, judged=None) == replace(
            session.match.situation, judged=None
        )
        return match

    assert kept().situation.games == 1
    assert kept().situation.breaker == 2
    assert session.timing.clock.left["frame-clock"] == 600.0
    session = pass_time(ready(session), 15.5)
    keeper.follow(session.match)
    assert kept().played[-1].before.games == 1
    assert run_record(read_record(keeper.path, load_variant)).passed
    assert any("games: 1" in line.notes for line in board_of(session).players)
    assert [path.name for path in tmp_path.iterdir()] == ["journal.toml"]
    for _ in range(2):
        session = act(session, commands.Undo())
        keeper.follow(session.match)
        kept()
    assert session.match.situation.games == 0
    session = act(session, commands.Redo())
    keeper.follow(session.match)
    kept()
    other = tmp_path / "other.toml"
    Keeper(other, tmp_path).start(session.match)
    assert len(resume(other, load_variant).played) == len(session.match.played)
