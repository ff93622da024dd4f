"""Random matches are the same by the same seed, and find what is wrong with a game's rules."""

import random
from dataclasses import replace

import pytest

from engine.game.match import next_game, start_match
from engine.game.phrases import format_event, parse_event
from engine.game.placing import refuse_place
from engine.game.referee import judge_shot, look_ahead
from engine.game.shot import Shot
from engine.records.read import read_record_text
from engine.records.record import RecordError
from engine.records.run import run_record
from engine.variant.load import load_variant
from tools.playouts import play
from tools.playouts.__main__ import main, play_share
from tools.playouts.places import placement
from tools.playouts.play import playout
from tools.playouts.players import HALF, PATIENCE, TRIES, Mix, Players, gains, mix_of
from tools.playouts.strokes import silly_shot
from tools.playouts.watch import faults, same, shuffled

GOOD = """\
language 1
game "Tiny"

points: if any object ball pocketed: award 1 to shooter
ending: if score of shooter is at least 3: shooter wins game
next shot: if not cue ball is on table: give next player cue ball in hand in table
"""


def tiny(folder, script):
    (folder / "tiny.toml").write_text('extends = "nine_ball"\ntitle = "Tiny"\nrules = "tiny"\n')
    (folder / "tiny.rules").write_text(script)
    return load_variant(folder / "tiny.toml")


def found(variant, matches=6, most=400):
    return [one for k in range(matches) for one in playout(variant, k, 1, most).findings]


def test_a_seed_plays_the_same_matches():
    once, again = (play_share("nine_ball", 0, 3, 7, 300)[1] for _ in range(2))
    assert once == again
    assert once != play_share("nine_ball", 0, 3, 8, 300)[1]


@pytest.mark.parametrize("game", ["eight_ball", "snooker", "three_cushion", "five_pins"])
def test_no_finding_in_a_shipped_game(game):
    tally = play_share(game, 0, 6, 3, 150)[1]
    assert tally.findings == []
    assert tally.shots > 10


def test_two_rules_that_clash_are_found_and_kept_as_a_record(tmp_path):
    clash = (
        "turn: if cue ball hit any cushion: turn continues\n"
        "turn: if any object ball pocketed: turn passes\n"
    )
    variant = tiny(tmp_path, GOOD + clash)
    finding = found(variant)[0]
    assert "two rules decide the turn differently" in finding.what
    record = read_record_text(finding.record, tmp_path / "shot.toml", lambda _: variant)
    with pytest.raises(RecordError, match="two rules decide the turn"):
        run_record(record)


def test_a_match_in_which_nobody_can_move_is_found(tmp_path):
    script = GOOD.replace(
        "next shot: if not cue ball is on table", "next shot: if cue ball hit 9-ball"
    )
    stuck = tiny(
        tmp_path, script.replace("score of shooter is at least 3", "score of shooter is 99")
    )
    assert any("no ball left" in one.what or "no cue ball" in one.what for one in found(stuck))


def test_every_shot_that_is_made_up_can_be_told():
    variant = load_variant("eight_ball")
    situation = start_match(variant).situation
    ahead = look_ahead(variant, situation)
    for number in range(200):
        shot = silly_shot(variant, situation, ahead, random.Random(number), places=number % 2 == 0)
        down = set()
        for event in shot.events or ():
            assert parse_event(format_event(event), variant.program.vocabulary) == event
            name = type(event).__name__
            assert name not in {"Pocketed", "LeftTable", "CushionHit"} or event.ball not in down
            if name in {"Pocketed", "LeftTable"}:
                down.add(event.ball)
            if name == "Rebounded":
                down.discard(event.ball)


def verdict_of(variant, *events):
    situation = start_match(variant).situation
    shot = Shot(events=tuple(map(parse_event, events)))
    return situation, shot, judge_shot(variant, situation, shot)


def test_a_lost_ball_is_noticed():
    variant = load_variant("eight_ball")
    situation, shot, verdict = verdict_of(variant, "cue hits 1", "1 hits cushion foot")
    assert list(faults(variant, situation, shot, verdict)) == []
    lost = replace(verdict.after, on_table=verdict.after.on_table - {"5"})
    told = list(faults(variant, situation, shot, replace(verdict, after=lost)))
    assert "gone without a trace: 5" in told


def test_balls_in_one_another_are_noticed():
    variant = load_variant("eight_ball")
    situation, shot, verdict = verdict_of(variant, "cue hits 1", "1 hits cushion foot")
    places = {**verdict.after.rest.positions, "7": (0.0, 0.0), "8": (0.01, 0.0)}
    after = replace(verdict.after, rest=replace(verdict.after.rest, positions=places))
    told = list(faults(variant, situation, shot, replace(verdict, after=after)))
    assert "8 lies in 7" in told or "7 lies in 8" in told


def test_verdicts_that_differ_are_told_apart():
    variant = load_variant("eight_ball")
    _, _, one = verdict_of(variant, "cue hits 1", "1 hits cushion foot")
    _, _, other = verdict_of(variant, "cue hits 1", "cue pocketed foot-left")
    assert list(same(one, one)) == []
    assert any("fouls" in told for told in same(one, other))


def test_the_rules_are_in_another_order_and_all_there():
    program = load_variant("snooker").program
    mixed = shuffled(program, random.Random(1))
    before = [rule.number for rule in program.compiled["fouls"]]
    after = [rule.number for rule in mixed.compiled["fouls"]]
    assert before != after
    assert sorted(before) == sorted(after)


def players(variant, mix, seed=1):
    return Players(variant, random.Random(seed), mix, places=False)


def test_matches_differ_in_how_silly_they_are_and_how_much_scores():
    rng = random.Random(5)
    mixes = [mix_of(rng, half=False) for _ in range(400)]
    wholly = [one for one in mixes if one.silly == 1]
    assert 5 < len(wholly) < 40
    others = [one for one in mixes if one.silly < 1]
    assert all(0.1 <= one.silly <= 0.5 and 0.2 <= one.scoring <= 0.5 for one in others)
    assert max(one.silly for one in others) - min(one.silly for one in others) > 0.3
    assert mix_of(rng, half=True) == HALF


def test_a_stroke_that_is_to_score_scores_where_one_of_its_tries_does(tmp_path):
    variant = tiny(tmp_path, GOOD)
    situation = start_match(variant).situation
    trying = players(variant, Mix(0, 1))
    for _ in range(20):
        shot, verdict = trying.shot(situation)
        if verdict is not None:
            again = judge_shot(variant, situation, shot, explain=False)
            assert list(same(verdict, again)) == []
    assert trying.scored >= 15
    assert players(variant, Mix(1, 0)).shot(situation)[1] is None


def test_what_scored_is_remembered_for_the_player_who_played_it(tmp_path):
    variant = tiny(tmp_path, GOOD)
    situation = start_match(variant).situation
    trying = players(variant, Mix(0, 1))
    for _ in range(10):
        trying.shot(situation)
    assert trying.known[1]
    assert 2 not in trying.known


def test_a_match_that_lasts_is_played_in_earnest(tmp_path):
    never = GOOD.replace("score of shooter is at least 3", "score of shooter is 1000000")
    variant = tiny(tmp_path, never)
    match = players(variant, Mix(1, 0))
    situation = start_match(variant).situation
    for _ in range(PATIENCE):
        match.shot(situation)
    assert match.scored == 0
    for _ in range(20):
        match.shot(situation)
    assert match.scored > 3


def test_tries_become_fewer_where_nothing_scores(tmp_path):
    script = 'language 1\ngame "Tiny"\n\nturn: turn passes\n'
    variant = tiny(tmp_path, script)
    match = players(variant, Mix(0, 1))
    situation = start_match(variant).situation
    for _ in range(5):
        _, verdict = match.shot(situation)
        assert verdict is None or not gains(situation, verdict)
    assert match.scored == 0
    assert TRIES >> match.in_vain < 4


def test_timers_run_out_in_random_matches():
    variant = load_variant("shoot_out")
    told = [dict(players(variant, HALF, seed)._unplayed().facts) for seed in range(40)]
    assert any(told)
    assert {name for one in told for name in one} == set(variant.program.timers)


def test_a_ball_in_hand_is_put_where_the_referee_lets_it_be():
    variant = load_variant("snooker")
    situation = start_match(variant).situation
    rng = random.Random(2)
    at = [one for _ in range(60) if (one := placement(variant, situation, rng))]
    assert len(at) > 5
    assert all(refuse_place(variant, situation, one) is None for one in at)
    assert placement(variant, replace(situation, in_hand=None), rng) is None


def test_no_game_lasts_long_where_half_the_shots_score():
    for game in ("cowboy", "straight_pool", "kaisa"):
        tally = play_share(game, 0, 1, 4, 5000)[1]
        assert (tally.keen_ended, tally.findings) == (1, [])


EMPTY = (
    "ending: if score of shooter is fewer than 3 and no object ball is on table:"
    " opponent wins game\n"
)
"""What ends a game in which nobody has scored enough."""


def games_of(variant, matches, monkeypatch):
    """Return how many games each match was made of."""
    begun = []
    monkeypatch.setattr(play, "next_game", lambda match: begun.append(match) or next_game(match))
    found = []
    for number in range(matches):
        begun.clear()
        assert playout(variant, number, 1, 4000).findings == []
        found.append(1 + len(begun))
    return found


def test_some_matches_are_of_several_games(tmp_path, monkeypatch):
    found = games_of(tiny(tmp_path, GOOD + EMPTY), 40, monkeypatch)
    assert found.count(1) > 25
    assert set(found) == {1, 2, 3}


def test_a_script_that_says_when_the_match_ends_is_played_to_it(tmp_path, monkeypatch):
    race = (
        "track wins-so-far per match per player\n"
        "at game end: add 1 to wins-so-far of winner\n"
        "at game end: if wins-so-far of winner is 4: winner wins match\n"
    )
    found = games_of(tiny(tmp_path, GOOD + EMPTY + race), 8, monkeypatch)
    assert min(found) >= 4
    assert max(found) <= 7


def test_the_command_tells_its_pace_and_a_total(capsys):
    main(["nine_ball", "kaisa", "--matches", "2", "--shots", "200", "--jobs", "1"])
    told = capsys.readouterr().out
    total = next(line.split() for line in told.splitlines() if line.startswith("2 games"))
    assert total[2] == "4"
    assert "shots a second" in told


def test_the_command_plays_and_tells(capsys):
    assert main(["nine_ball", "--matches", "2", "--shots", "200", "--jobs", "1"]) in {0, 1}
    assert "nine_ball" in capsys.readouterr().out
