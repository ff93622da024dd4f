"""Files saved while a game is played are taken up between shots, or refused with their mistakes."""

import os
import shutil
from dataclasses import replace

import pytest

from engine.app import commands
from engine.app.before import begin
from engine.app.keeping import Keeper
from engine.app.loop import Loop
from engine.app.session import Mode
from engine.app.showing import Showing
from engine.app.startup import Startup
from engine.app.steps import act
from engine.app.watching import watch_variant
from engine.app.window import close_window, open_window
from engine.game.match import start_match
from engine.stage.stage import build_stage
from engine.variant.library import shipped_folder
from engine.variant.load import load_variant

pytestmark = pytest.mark.xdist_group("window")


@pytest.fixture
def own_game(tmp_path):
    """Return a copy of a shipped game in a folder of its own."""
    for name in ("three_cushion.toml", "three_cushion.rules"):
        shutil.copy(shipped_folder() / name, tmp_path / name)
    return tmp_path / "three_cushion.toml"


@pytest.fixture
def loop(own_game, tmp_path):
    variant = load_variant(own_game)
    match = start_match(variant, None, {}, 3)
    startup = Startup("wireframe")
    startup.begin()
    startup.join()
    keeper = Keeper(tmp_path / "kept" / "journal.toml", tmp_path / "shots")
    keeper.start(match)
    yield Loop(
        window=open_window((900, 600), "test"),
        session=begin(match),
        showing=Showing(build_stage(variant)),
        startup=startup,
        keeper=keeper,
        watch=watch_variant(variant, 0.0),
        renderer="wireframe",
    )
    close_window()


def save(path, before, after):
    """Write a changed file as an editor does, at a later time."""
    text = path.read_text(encoding="utf-8")
    assert before in text
    stamp = path.stat().st_mtime_ns + 10_000_000
    path.write_text(text.replace(before, after), encoding="utf-8")
    os.utime(path, ns=(stamp, stamp))


def played(loop):
    """Play one stroke to its verdict."""
    session = loop.session
    while session.mode is not Mode.AIMING:
        session = act(session, commands.Confirm())
    session = act(act(session, commands.Confirm()), commands.Skip())
    loop.enter(session)
    assert len(loop.session.match.played) == 1


def test_nothing_happens_while_no_file_changes(loop):
    before = loop.session.variant
    loop.frame([], 0.1)
    assert loop.session.variant is before


def test_a_changed_table_is_shown(loop, own_game):
    save(own_game, 'title = "', 'title = "New ')
    loop.frame([], 0.1)
    assert loop.session.variant.title.startswith("New ")
    assert "taken up" in loop.session.note


def test_the_last_shot_is_judged_by_the_changed_rules(loop, own_game):
    played(loop)
    rule = '\nfouls:\n    rule "Always" [99]: foul never-good\n'
    save(own_game.with_suffix(".rules"), 'uses "carom-common"\n', f'uses "carom-common"\n{rule}')
    loop.frame([], 0.1)
    assert loop.session.trouble == ""
    assert "never-good" in str(loop.session.match.played[0].verdict.fouls)


def test_a_mistake_is_told_and_the_old_game_goes_on(loop, own_game):
    before = loop.session
    script = own_game.with_suffix(".rules")
    save(script, "language 1", "langage 1")
    loop.frame([], 0.1)
    assert "three_cushion.rules" in loop.session.trouble
    assert loop.session.match is before.match
    save(script, "langage 1", "language 1")
    loop.frame([], 0.1)
    assert loop.session.trouble == ""


def test_a_file_is_not_taken_up_while_balls_roll(loop, own_game):
    session = loop.session
    while session.mode is not Mode.AIMING:
        session = act(session, commands.Confirm())
    loop.enter(act(session, commands.Confirm()))
    save(own_game, 'title = "', 'title = "New ')
    loop.frame([], 0.0)
    assert not loop.session.variant.title.startswith("New ")
    loop.enter(act(loop.session, commands.Skip()))
    loop.frame([], 0.0)
    assert loop.session.variant.title.startswith("New ")


def test_a_shot_with_balls_that_are_gone_is_refused(loop, own_game):
    played(loop)
    match = loop.session.match
    one = replace(match.played[0], before=replace(match.played[0].before, on_table=frozenset("z")))
    loop.session = replace(loop.session, match=replace(match, played=(one,)))
    save(own_game, 'title = "', 'title = "New ')
    loop.frame([], 0.0)
    assert "does not fit" in loop.session.trouble
