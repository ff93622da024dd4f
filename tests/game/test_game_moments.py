"""Games that follow each other in a match, and clocks that run out."""

from __future__ import annotations

import pytest

from engine.game.clock import rewind, run, time_out, wind
from engine.game.match import advance, next_game, start_match
from engine.game.phrases import parse_event
from engine.game.referee import judge_shot
from engine.game.shot import Shot
from engine.variant.load import load_variant

RULES = """
language 1
game "Race"
timer shot-clock lasts 35 seconds
timer turn-clock lasts 60 seconds per turn
timer rack-clock lasts 600 seconds per game
track racks per match per player
track shots-played per game
at match start: award 1 to opponent
at game start:
    give breaker cue ball in hand in kitchen
    remove 8-ball
when shot-clock expires: foul slow
points: add 1 to shots-played
ending: if 9-ball pocketed: shooter wins game
at game end:
    add 1 to racks of winner
    if racks of winner is 2: winner wins match
"""


@pytest.fixture
def variant(tmp_path):
    (tmp_path / "race.toml").write_text('extends = "nine_ball"\n')
    (tmp_path / "race.rules").write_text(RULES)
    return load_variant(tmp_path / "race.toml")


def played(match, *events):
    shot = Shot(events=tuple(map(parse_event, events)))
    return advance(match, shot, judge_shot(match.variant, match.situation, shot))


def test_a_match_of_games(variant):
    match = start_match(variant)
    assert match.situation.scores == (0, 1)
    assert "8" not in match.situation.on_table
    with pytest.raises(ValueError, match="not over yet"):
        next_game(match)
    match = played(match, "cue hits 9", "9 pocketed foot-left")
    assert (match.situation.winner, match.situation.match_over) == (1, False)
    match = next_game(match)
    now = match.situation
    assert (now.games, now.won_last, now.breaker, now.shooter) == (1, 1, 2, 2)
    assert (now.state["racks"], now.state["shots-played"], now.scores) == ((1, 0), 0, (0, 0))
    assert "9" in now.on_table
    match = played(next_game(played(match, "cue hits 9", "9 pocketed foot-left")))
    match = played(match, "cue hits 9", "9 pocketed foot-left")
    assert match.situation.match_over
    with pytest.raises(ValueError, match="match is over"):
        next_game(match)


def test_racks_of_a_match_differ(variant):
    match = played(start_match(variant, seed=3), "9 pocketed foot-left")
    first = start_match(variant, seed=3).situation.rest.positions
    assert next_game(match).situation.rest.positions != first


def test_a_clock_runs_out_once_and_is_wound_up_again(variant):
    clock = wind(variant.program.timers)
    clock, out = run(clock, 34.0)
    assert (out, clock.left["shot-clock"]) == ((), 1.0)
    clock, out = run(clock, 2.0)
    assert (out, clock.left["shot-clock"]) == (("shot-clock",), 0.0)
    assert run(clock, 2.0)[1] == ()
    match = start_match(variant)
    shot = time_out(*out)
    verdict = judge_shot(variant, match.situation, shot)
    assert [foul.name for foul in verdict.fouls] == ["slow"]
    clock = rewind(clock, match.situation, verdict.after)
    assert dict(clock.left) == {"shot-clock": 35.0, "turn-clock": 60.0, "rack-clock": 564.0}
