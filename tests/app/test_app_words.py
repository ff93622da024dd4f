from dataclasses import replace

import pytest

from engine.app import commands
from engine.app.board import board_of, call_words
from engine.app.session import Mode
from engine.app.steps import act
from engine.app.telling import explanation_lines, verdict_lines
from engine.app.words import named_balls, next_words, result_words, spoken
from rulelang.facts import Call


def played(session, speed, turn=0.0):
    if session.mode is Mode.PLACING:
        session = act(session, commands.Confirm())
    for command in (commands.Turn(turn), commands.SetSpeed(speed), commands.Confirm()):
        session = act(session, command)
    return act(session, commands.Skip())


def test_the_board_tells_players_scores_phase_and_what_is_on(start):
    board = board_of(start("snooker"))
    assert board.title == "Snooker"
    assert board.phase == "phase: red"
    assert [(line.name, line.score) for line in board.players] == [
        ("Player 1", "0"),
        ("Player 2", "0"),
    ]
    assert [line.is_shooting for line in board.players] == [True, False]
    assert board.on_words == "reds"
    assert "in hand" in board.ask


def test_a_game_without_points_shows_no_score(start):
    assert board_of(start("eight_ball")).players[0].score == ""


def test_each_player_of_a_game_with_two_cue_balls_is_told_his(start):
    board = board_of(start("three_cushion"))
    assert [line.notes for line in board.players] == [("plays white",), ("plays yellow",)]


def test_values_tracked_for_a_player_stand_under_his_name(start):
    session = start("eight_ball")
    situation = replace(session.match.situation, state={"group": ("solids", "none")})
    session = replace(session, match=replace(session.match, situation=situation), ahead=situation)
    assert [line.notes for line in board_of(session).players] == [("group: solids",), ()]


def test_a_whole_group_is_told_by_its_name(start):
    variant = start("eight_ball").variant
    balls = [kind.id for kind in variant.balls if "solids" in kind.groups]
    there = [kind.id for kind in variant.balls]
    assert named_balls(variant, balls, there) == "solids"
    assert named_balls(variant, balls[:2], there) == f"{balls[0]}, {balls[1]}"
    assert named_balls(variant, balls[:2], balls[:2]) == "solids"


def test_a_foul_is_told_with_section_points_and_who_is_next(start):
    session = played(start("snooker"), 1.0, turn=180.0)
    lines = verdict_lines(session.variant, session.last)
    said = "\n".join(line.text for line in lines)
    assert "Foul: no contact, 4 points [S3 R11(a)]" in said
    assert "Player 2: +4 points" in said
    assert lines[-1].text.startswith("Player 2 chooses: play")
    assert lines[0].tone == "bad"


def test_a_lawful_shot_is_told_as_such(start):
    session = played(start("eight_ball"), 9.0)
    assert verdict_lines(session.variant, session.last)[0].text == "No foul"


def test_a_choice_is_told_as_a_choice(start):
    session = act(played(start("eight_ball"), 1.0), commands.Confirm())
    index = session.match.situation.options.index("rerack-offender-breaks")
    session = act(session, commands.Choose(index))
    said = [line.text for line in verdict_lines(session.variant, session.last)]
    assert said[0] == "Chosen: rerack offender breaks"
    assert "15 balls are racked" in said
    assert said[-1] == "Next: Player 1, cue ball in hand (kitchen)"


def test_the_explanation_has_every_rule_under_its_section(start):
    session = played(start("snooker"), 1.0, turn=180.0)
    lines = explanation_lines(session.verdict.explanation)
    heads = [line.text for line in lines if line.tone == "head"]
    assert heads == list(dict.fromkeys(heads))
    assert "fouls" in heads
    assert any(line.text == "+ All balls missed [S3 R11(a)]" for line in lines)
    assert sum(line.text[:2] in ("+ ", "- ", "x ") for line in lines) == len(
        session.verdict.explanation
    )


def test_no_explanation_yet_is_said():
    assert explanation_lines(())[0].text


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (Call(), ""),
        (Call(ball="8", pocket="foot-left"), "8 in foot left"),
        (Call(ball="red-1"), "red 1"),
        (Call(safety=True), "safety"),
        (Call(safety=True, group="solids"), "safety, claims solids"),
    ],
)
def test_a_call_in_words(call, said):
    assert call_words(call) == said


@pytest.mark.parametrize(
    ("winner", "match_over", "said"),
    [
        (None, False, ""),
        (0, False, "The game is a draw"),
        (2, False, "Player 2 wins the game"),
        (1, True, "Player 1 wins the match"),
    ],
)
def test_the_result_in_words(start, winner, match_over, said):
    situation = replace(start("snooker").match.situation, winner=winner, match_over=match_over)
    assert result_words(situation) == said


def test_who_is_next_is_told_with_the_ball_in_hand(start):
    session = start("snooker")
    assert (
        next_words(session.variant, session.match.situation)
        == "Next: Player 1, cue ball in hand (D)"
    )


def test_hyphens_are_read_as_spaces():
    assert spoken("rerack-offender-breaks") == "rerack offender breaks"


def test_while_balls_roll_the_board_does_not_tell_the_outcome(start):
    session = act(start("snooker"), commands.Confirm())
    for command in (commands.Turn(180.0), commands.SetSpeed(1.0), commands.Confirm()):
        session = act(session, command)
    assert session.mode is Mode.STRIKING
    assert [line.score for line in board_of(session).players] == ["0", "0"]
    over = board_of(act(session, commands.Skip()))
    assert [line.score for line in over.players] == ["0", "4"]
