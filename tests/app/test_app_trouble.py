"""Trouble of a script while it is played, and offers that are made before a shot."""

import re
from textwrap import dedent

import pytest

from engine.app import commands
from engine.app.before import begin
from engine.app.choices import choice_words
from engine.app.play import play
from engine.app.session import Mode
from engine.app.steps import act
from engine.game.match import start_match
from engine.variant.load import load_variant

TABLE = """\
title = "Two rules"
rulebook = "House rules"
table = "wpa-9ft"
balls = "pool"
cloth = "worsted-pool"
cue_balls = ["cue"]
players = 2

[cue]
mass = "540 g"
tip_restitution = 0.73
tip_friction = 0.6
end_mass_ratio = 25.0

[rack.places]
cue = "head-spot"
1 = "foot-spot"
"""
CLASH = """\
turn:
    rule "Stays": if cue ball hit 1-ball: turn continues
    rule "Leaves": if not 1-ball pocketed: turn passes
"""


@pytest.fixture
def written(tmp_path):
    """Return a function that writes a variant of a script and starts a session of it."""

    def made(script: str):
        (tmp_path / "two.toml").write_text(TABLE, encoding="utf-8")
        (tmp_path / "two.rules").write_text(dedent(script), encoding="utf-8")
        return begin(start_match(load_variant(tmp_path / "two.toml"), seed=1))

    return made


def struck(session, speed=3.0):
    return act(act(session, commands.SetSpeed(speed)), commands.Confirm())


def test_two_rules_at_odds_are_told_with_both_places_and_the_match_stays(written):
    session = written(CLASH)
    after = struck(session)
    assert re.search(r'"Stays" \(\S*two.rules:2\) and "Leaves" \(\S*two.rules:3\)', after.trouble)
    assert after.match is session.match
    assert after.mode is Mode.AIMING


def test_after_trouble_another_stroke_can_be_played(written):
    session = act(struck(written(CLASH)), commands.Turn(90.0))
    assert session.trouble == ""
    after = struck(session, 0.5)
    assert after.trouble == ""
    assert len(after.match.played) == 1


def test_a_script_that_never_ends_is_told(written, monkeypatch):
    monkeypatch.setattr("rulelang.watch.FUEL", 0)
    session = written("table:\n    for each of (object balls on table): spot it at foot-spot\n")
    after = struck(session)
    assert "turns of loops" in after.trouble
    assert after.match is session.match


OFFERED = """\
phases ready, playing
before shot in phase ready:
    offer shooter:
        play: go to phase playing
        pass:
            go to phase playing
            opponent of chooser plays
"""


def test_what_is_offered_before_the_first_shot_is_asked(written):
    session = written(OFFERED)
    assert session.mode is Mode.CHOOSING
    assert session.match.situation.options == ("play", "pass")


def test_every_choice_is_told_by_what_follows(written):
    session = written(OFFERED)
    situation = session.match.situation
    told = [choice_words(session.variant, situation, option) for option in situation.options]
    assert told == [
        "Player 1 plays from where the balls lie",
        "Player 2 plays from where the balls lie",
    ]


def test_a_choice_before_the_shot_is_played_and_journalled_with_it(written):
    session = act(written(OFFERED), commands.Choose(0))
    assert session.mode is Mode.AIMING
    after = struck(session, 1.0)
    assert [played.shot.choice for played in after.match.played] == ["play"]
    assert after.match.situation.phase == "playing"


def test_a_choice_that_gives_the_table_away_lets_the_other_play(written):
    session = act(written(OFFERED), commands.Choose(1))
    assert session.mode is Mode.AIMING
    assert session.ahead.shooter == 2


@pytest.mark.usefixtures("own_folders")
def test_a_script_at_odds_from_the_start_is_one_line_on_stderr(written, tmp_path, capsys):
    written("")
    script = "game start:\n    go to phase a\n    go to phase b\n"
    (tmp_path / "two.rules").write_text(f"phases a, b\n{script}", encoding="utf-8")
    assert play(tmp_path / "two.toml") == 2
    told = capsys.readouterr().err
    assert "Traceback" not in told
    assert told.count("\n") < 12
