"""What players are called, and the time they have left: kept in the journal."""

from dataclasses import replace

import pytest

from engine.app import commands
from engine.app.before import begin
from engine.app.board import board_of
from engine.app.keeping import Keeper
from engine.app.labels import labelled, labels_of
from engine.app.play import Sitting, play
from engine.app.steps import act, pass_time
from engine.app.telling import verdict_lines
from engine.app.timing import timing_of
from engine.records.blocks import names_of
from engine.records.journal import resume, times_of
from engine.variant.load import list_variants, load_variant

NAMES = ('Änne "Ace"', "Bo")


def named(session):
    return begin(replace(session.match, names=NAMES))


def struck(session):
    while session.mode.name not in ("STRIKING", "VERDICT"):
        session = act(session, commands.Confirm())
    return act(act(session, commands.Skip()), commands.Confirm())


def test_names_stand_wherever_a_player_is_told_of(start):
    session = struck(named(start("three_cushion")))
    board = board_of(session)
    assert [line.name for line in board.players] == list(NAMES)
    assert any(name in board.ask for name in NAMES)
    lines = verdict_lines(session.variant, session.last, session.names)
    assert any(name in line.text for line in lines for name in NAMES)
    assert not any("Player" in line.text for line in lines)


def test_names_live_through_undo_the_next_game_and_the_journal(start, tmp_path):
    session = named(start("three_cushion"))
    keeper = Keeper(tmp_path / "kept.toml", tmp_path)
    keeper.start(session.match)
    session = struck(session)
    keeper.follow(session.match)
    assert resume(tmp_path / "kept.toml", load_variant).names == NAMES
    assert act(session, commands.Undo()).names == NAMES
    assert act(act(session, commands.Arrange()), commands.Arrange()).names == NAMES


def test_a_record_has_no_names():
    assert names_of("# seed 3\n") == ()


def test_a_match_that_is_gone_on_with_has_its_clocks(start, tmp_path):
    session = start("shoot_out")
    path = tmp_path / "kept.toml"
    keeper = Keeper(path, tmp_path)
    keeper.start(session.match)
    for seconds in (3.0, 2.0):
        session = struck(pass_time(session, seconds))
        keeper.follow(session.match, session.timing.clock.left)
    left = dict(session.timing.clock.left)
    assert any(left[name] < timer.seconds for name, timer in session.timing.clock.timers.items())
    match = resume(path, load_variant)
    assert dict(timing_of(match, times_of(path)).clock.left) == pytest.approx(left, abs=0.001)
    back = act(session, commands.Undo())
    keeper.follow(back.match, back.timing.clock.left)
    match = resume(path, load_variant)
    assert len(match.played) == len(back.match.played)
    now = timing_of(match, times_of(path)).clock.left
    assert dict(now) == pytest.approx(dict(back.timing.clock.left), abs=0.001)
    later = act(begin(match, timing=timing_of(match, times_of(path))), commands.Undo())
    assert later.timing.clock.left != now


def test_time_that_goes_by_before_the_player_leaves_is_gone(start, tmp_path):
    session = start("shoot_out")
    keeper = Keeper(tmp_path / "kept.toml", tmp_path)
    keeper.start(session.match)
    session = pass_time(session, 4.0)
    keeper.leave(session.timing.clock.left)
    match = resume(tmp_path / "kept.toml", load_variant)
    left = timing_of(match, times_of(tmp_path / "kept.toml")).clock.left
    assert dict(left) == pytest.approx(dict(session.timing.clock.left), abs=0.001)


def test_a_game_without_timers_has_no_line_of_time(start, tmp_path):
    session = start("three_cushion")
    keeper = Keeper(tmp_path / "kept.toml", tmp_path)
    keeper.start(session.match)
    keeper.follow(struck(session).match, session.timing.clock.left)
    keeper.leave(session.timing.clock.left)
    assert "# left" not in (tmp_path / "kept.toml").read_text(encoding="utf-8")


@pytest.mark.xdist_group("window")
def test_names_are_given_on_the_command_line_and_come_back(own_folders):
    path, seen = own_folders / "match.toml", []

    def look(loop):
        seen.append(loop.session.names)
        loop.running = False

    assert play("three_cushion", names=NAMES, journal=path, each=look) == 0
    assert play("three_cushion", resume=True, journal=path, each=look) == 0
    assert seen == [NAMES, NAMES]
    assert Sitting


@pytest.mark.parametrize("name", [one.name for one in list_variants()])
def test_every_ball_has_a_label_that_no_other_colour_has(name):
    variant = labelled(load_variant(name))
    labels = {}
    for kind in variant.balls:
        assert 1 <= len(kind.label) <= 3
        labels.setdefault(kind.label, set()).add((kind.colour, kind.pattern))
    assert all(len(looks) == 1 for looks in labels.values()), labels
    assert labels_of(variant) == {kind.id: kind.label for kind in variant.balls}
