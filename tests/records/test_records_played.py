"""Shots that were played: saved, read back, played again to the same bits; the journal."""

import shutil
from functools import cache
from math import pi

import pytest

from engine.game.match import advance, start_match, undo
from engine.game.observe import play, simulate_shot
from engine.game.phrases import parse_event
from engine.game.placing import refuse_place, usual_place
from engine.game.referee import judge_shot, look_ahead
from engine.game.shot import Shot
from engine.game.situation import Rest
from engine.physics.world import Strike
from engine.records.journal import Journal, resume
from engine.records.read import read_record
from engine.records.run import run_record
from engine.records.write import save_shot_record
from engine.variant.load import list_variants, load_variant

load = cache(load_variant)
GAMES = [one.name for one in list_variants()]


def played(match, heading=0.013, speed=5.0):
    """Return the match after one stroke from a usual place, choices and calls made simply."""
    before = match.situation
    choice = before.options[0] if before.options else None
    if choice is not None:
        shot = Shot(choice=choice)
    else:
        place = usual_place(match.variant, before) if before.in_hand else None
        strike = Strike(speed, heading, 0.0, 0.1, -0.1)
        shot = play(match.variant, before, Shot(placement=place, strike=strike))
    return advance(match, shot, judge_shot(match.variant, before, shot))


def a_match(name, shots):
    match = start_match(load(name), seed=5)
    for number in range(shots):
        if match.situation.over:
            break
        match = played(match, heading=0.013 + number * 0.7 * pi)
    return match


@pytest.mark.parametrize("name", GAMES)
def test_a_saved_shot_reads_back_and_plays_again(name, tmp_path):
    match = a_match(name, 4)
    for index, shot in enumerate(match.played):
        path = tmp_path / f"{index}.toml"
        save_shot_record(path, match, index)
        outcome = run_record(read_record(path, load))
        assert [str(one) for one in outcome.differences] == []
        assert outcome.replayed is (None if shot.shot.strike is None else True)


def test_a_saved_shot_knows_the_pin_whose_place_a_ball_has_taken(tmp_path):
    variant = load("danish_pins")
    match = start_match(variant)
    at = {"red": (-0.5, 0.0), "white-1": (0.01, 0.0), "white-2": (0.6, 0.3)}
    toppled = Shot(
        events=tuple(map(parse_event, ("red hits white-1", "white-1 topples centre-pin"))),
        after=Rest(positions=at),
    )
    match = advance(match, toppled, judge_shot(variant, match.situation, toppled))
    assert match.situation.rest.fallen == {"centre-pin"}
    match = played(match, heading=0.0, speed=2.0)
    assert "centre-pin" not in str(match.played[-1].shot.events)
    save_shot_record(tmp_path / "shot.toml", match, 1)
    outcome = run_record(read_record(tmp_path / "shot.toml", load))
    assert outcome.judgements[0].before.rest.fallen == {"centre-pin"}
    assert (outcome.replayed, outcome.differences) == (True, ())


@pytest.mark.parametrize("name", GAMES)
def test_another_physics_is_judged_but_not_replayed(name, tmp_path):
    path = tmp_path / "shot.toml"
    match = a_match(name, 1)
    if match.played[-1].shot.is_only_choice:
        match = a_match(name, 2)
    save_shot_record(path, match)
    text = path.read_text(encoding="utf-8")
    line = next(line for line in text.splitlines() if line.startswith("physics"))
    path.write_text(text.replace(line, 'physics = "0000000000000000"'), encoding="utf-8")
    outcome = run_record(read_record(path, load))
    assert outcome.passed
    assert outcome.replayed is False


@pytest.mark.parametrize("name", GAMES)
def test_a_journal_resumes_where_the_match_stood(name, tmp_path):
    path = tmp_path / "match.toml"
    match = start_match(load(name), seed=5)
    journal = Journal.begin(path, match)
    assert resume(path, load).situation.rest == match.situation.rest
    for number in range(5):
        if match.situation.over:
            break
        match = played(match, heading=0.013 + number)
        journal.append(match.played[-1])
        back = resume(path, load)
        assert back.situation.rest == match.situation.rest
        assert back.situation.scores == match.situation.scores
        assert back.situation.state == match.situation.state
        assert back.situation.options == match.situation.options
        assert back.situation.shooter == match.situation.shooter
    assert run_record(read_record(path, load)).passed


def test_a_journal_cut_off_anywhere_gives_the_shots_that_were_complete(tmp_path):
    path = tmp_path / "match.toml"
    match = start_match(load(GAMES[-1]), seed=5)
    journal = Journal.begin(path, match)
    sizes = [path.stat().st_size]
    for number in range(3):
        match = played(match, heading=0.013 + number)
        journal.append(match.played[-1])
        sizes.append(path.stat().st_size)
    whole = path.read_bytes()
    cut = tmp_path / "cut.toml"
    for size in range(sizes[0], len(whole) + 1, 97):
        cut.write_bytes(whole[:size])
        complete = max(index for index, at in enumerate(sizes) if at <= size)
        assert len(resume(cut, load).played) == complete


def test_an_undone_shot_stays_undone_after_resuming(tmp_path):
    path = tmp_path / "match.toml"
    match = start_match(load(GAMES[0]), seed=5)
    journal = Journal.begin(path, match)
    match = played(match)
    journal.append(match.played[-1])
    match = undo(match)
    journal.undo()
    assert resume(path, load).played == ()
    other = played(match, heading=0.02)
    journal.append(other.played[-1])
    shutil.copy(path, tmp_path / "copy.toml")
    assert resume(tmp_path / "copy.toml", load).situation.rest == other.situation.rest


@pytest.mark.parametrize("name", GAMES)
def test_the_start_of_a_game(name):
    match = start_match(load(name), seed=2)
    ahead = look_ahead(match.variant, match.situation)
    assert ahead.on
    assert not match.situation.over
    place = usual_place(match.variant, match.situation)
    assert (place is None) == (match.situation.in_hand is None)
    if place is not None:
        assert refuse_place(match.variant, match.situation, place) is None
    assert refuse_place(match.variant, match.situation, (9.0, 0.0)) is not None


def test_a_shot_without_a_strike_is_not_played():
    match = start_match(load(GAMES[0]))
    with pytest.raises(ValueError, match="without a strike"):
        simulate_shot(match.variant, match.situation, Shot())


def test_a_match_goes_on_in_a_journal_that_was_cut_off(tmp_path):
    path = tmp_path / "match.toml"
    match = start_match(load(GAMES[0]), seed=5)
    journal = Journal.begin(path, match)
    match = played(match)
    journal.append(match.played[-1])
    whole = path.read_bytes()
    other = played(match, heading=0.5)
    journal.append(other.played[-1])
    longer = path.read_bytes()
    for size in range(len(whole), len(longer), 211):
        path.write_bytes(longer[:size])
        assert len(resume(path, load).played) == 1
        Journal.reopen(path).append(other.played[-1])
        back = resume(path, load)
        assert len(back.played) == 2
        assert back.situation.rest == other.situation.rest


def test_a_journal_with_a_shot_taken_back_is_a_record(tmp_path):
    path = tmp_path / "match.toml"
    match = start_match(load(GAMES[0]), seed=5)
    journal = Journal.begin(path, match)
    for heading in (0.013, 0.02):
        tried = played(match, heading)
        journal.append(tried.played[-1])
        journal.undo()
    journal.append(tried.played[-1])
    outcome = run_record(read_record(path, load))
    assert outcome.passed
    assert len(outcome.judgements) == 1
