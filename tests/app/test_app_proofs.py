"""The proofs of the window as tools: a match to its end, killed at random, watched for long."""

import json
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from random import Random
from types import SimpleNamespace

import pytest
from PIL import Image

from engine.app.keeping import Keeper
from engine.app.session import Mode
from tools.kill_test import Tally, Told, _judge, digest
from tools.long_play import GROWTH, Slow, Watcher, findings, told
from tools.scripted.player import Player

pytestmark = pytest.mark.xdist_group("window")


def run(tool, *words, seconds=240):
    command = [sys.executable, "-m", f"tools.{tool}", *words]
    root = Path(__file__).parents[2]
    return subprocess.run(
        command, cwd=root, capture_output=True, text=True, timeout=seconds, check=False
    )


def test_a_match_is_played_from_the_start_screen_to_its_end_by_keyboard_alone(tmp_path):
    words = ["--games", "three_cushion", "--set", "target=1", "--size", "900x600", "--keyboard"]
    words += ["--name", "Ann"]
    done = run("scripted_play", *words, "--display", "headless", "--out", str(tmp_path))
    assert done.returncode == 0, done.stdout + done.stderr
    pictures = sorted((tmp_path / "three_cushion").glob("*.png"))
    names = {path.stem.partition("-")[2] for path in pictures}
    assert {"start", "found", "set", "keys", "menu", "rules", "aim", "verdict", "end"} <= names
    assert Image.open(pictures[0]).size == (900, 600)
    kept = list((tmp_path / "three_cushion" / "data").rglob("three_cushion-*.toml"))
    text = "".join(path.read_text(encoding="utf-8") for path in kept)
    assert "target = 1\n" in text
    assert '"Ann"' in text


def test_a_match_that_is_killed_is_gone_on_with():
    done = run("kill_test", "--moments", "6", "--seed", "5", "--display", "headless")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "killed at 6 moments" in done.stdout
    assert "nothing was lost" in done.stdout


@pytest.fixture
def kept(start, tmp_path):
    match = start("three_cushion").match
    path = tmp_path / "kept.toml"
    Keeper(path, tmp_path).start(match)
    return path, digest(match)


def test_what_was_told_as_saved_and_is_not_there_is_lost(kept):
    path, _ = kept
    tally = Tally()
    _judge(tally, path, Told("saving", first="one", kept="two"), "one")
    assert len(tally.lost) == 1
    assert "two" in tally.lost[0]


def test_what_is_there_is_not_lost_and_a_window_that_failed_is_told(kept):
    path, state = kept
    tally = Tally()
    assert _judge(tally, path, Told("waiting", first=state, coming="later"), state) == state
    assert tally.lost == []
    _judge(tally, path, Told("physics", first=state, died="KeyError"), state)
    assert "KeyError" in tally.lost[0]
    _judge(tally, path, Told("starting", first="other", kept=state), state)
    assert "began at other" in tally.lost[1]


def watched(times, sizes, slow=()):
    player = Player(Path(), Random(1))
    watcher = Watcher(player, 100.0)
    watcher.times, watcher.slow = times, list(slow)
    watcher.memory = [(100.0 * k / len(sizes), size) for k, size in enumerate(sizes)]
    return findings("a", watcher)


def test_growth_and_slow_frames_are_found():
    steady = [200.0 + k % 2 for k in range(50)]
    assert watched([0.01] * 500, steady).passed
    growing = [200.0 + k * GROWTH / 25.0 for k in range(50)]
    assert not watched([0.01] * 500, growing).passed
    late = watched([0.01] * 500, steady, [Slow(3.0, 0.08, "rolling -> verdict; keys: f")])
    assert not late.passed
    assert "80 ms at 3 s: rolling -> verdict" in told(late)
    assert late.percentiles["worst"] == 10.0
    with pytest.raises(ValueError, match="too short"):
        watched([0.01] * 5, steady)


def test_a_watcher_notes_each_frame_and_its_cause(start):
    session = start("three_cushion")
    loop = SimpleNamespace(
        startup=SimpleNamespace(saying="", playable=True),
        session=session,
        renderer="painter",
        view=SimpleNamespace(camera="cue"),
        hands=SimpleNamespace(pressed=["space"]),
        busy=0.2,
        worked=0.01,
        running=True,
    )
    player = Player(Path(), Random(1), looks=False)
    watcher = Watcher(player, 100.0, _script=iter(range(100)))
    watcher.each(loop)
    loop.session = replace(session, mode=Mode.ROLLING)
    watcher.each(loop)
    assert watcher.times == [0.2]
    assert "painter, cue -> balls rolling" in watcher.slow[0].cause.replace(
        "rolling;", "balls rolling;"
    )
    assert "keys: space" in watcher.slow[0].cause


def test_long_play_tells_frames_and_memory():
    words = ["--minutes", "0.12", "--games", "three_cushion", "--size", "640x400", "--json"]
    done = run("long_play", *words, "--display", "headless")
    assert done.returncode in (0, 1), done.stdout + done.stderr
    (found,) = json.loads(done.stdout.splitlines()[-1])
    assert found["frames"] > 100
    assert found["memory_now"] > 50.0
    assert found["percentiles"]["p50"] <= found["percentiles"]["worst"]
