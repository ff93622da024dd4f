"""Closes the hole between the tutorial and what happens to somebody who follows it to the word."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

from engine.game.match import advance, start_match
from engine.game.observe import play
from engine.game.referee import judge_shot
from engine.game.shot import Shot
from engine.physics.world import Strike
from engine.variant.load import load_variant

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "tutorial.md").read_text(encoding="utf-8")
STEPS = re.findall(r"^```(\w+)(?: ([^\n]*))?\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)


def run(folder: Path, command: str) -> str:
    words = shlex.split(command)
    assert words[:3] == ["python", "-m", "engine"]
    done = subprocess.run(
        [sys.executable, *words[1:]],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert "Traceback" not in done.stderr
    return done.stdout + done.stderr


def write(folder: Path, target: str, text: str) -> None:
    """Write a file, add to it (`+`), or change a line of it (`= old -> new`)."""
    name, _, how = target.partition(" ")
    path = folder / name
    path.parent.mkdir(exist_ok=True)
    if how == "+":
        path.write_text(path.read_text(encoding="utf-8") + text, encoding="utf-8")
    elif how.startswith("= "):
        old, new = how[2:].split(" -> ")
        before = path.read_text(encoding="utf-8")
        assert old in before
        path.write_text(before.replace(old, new.replace("\\n", "\n")), encoding="utf-8")
    else:
        path.write_text(text, encoding="utf-8")


@pytest.fixture(scope="module")
def followed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Follow the page from top to bottom; what a command prints must be what the page says."""
    folder = tmp_path_factory.mktemp("tutorial")
    for kind, target, text in STEPS:
        if kind == "console":
            for part in re.split(r"^\$ ", text, flags=re.MULTILINE)[1:]:
                command, _, wanted = part.partition("\n")
                told = run(folder, command)
                assert wanted.strip() in told, command
        elif target:
            write(folder, target, text)
    return folder


def test_the_page_is_followed_word_for_word(followed: Path) -> None:
    assert len(STEPS) > 15
    assert "no mistakes" in run(followed, "python -m engine check ./six_ball.toml")


def test_every_rule_of_the_house_is_cited(followed: Path) -> None:
    rules = (followed / "six_ball.rules").read_text(encoding="utf-8")
    cited = {int(one) for one in re.findall(r'" \[(\d)\]', rules)}
    assert cited == set(range(1, 8))


def test_the_game_is_played_without_a_window(followed: Path) -> None:
    match = start_match(load_variant(followed / "six_ball.toml"), seed=5)
    for number in range(12):
        situation = match.situation
        if situation.over:
            break
        choice = situation.options[0] if situation.options else None
        place = (-0.8, 0.1) if situation.in_hand or choice == "in-hand" else None
        strike = Strike(speed=4.0, heading=0.4 * number)
        shot = play(match.variant, situation, Shot(choice=choice, placement=place, strike=strike))
        match = advance(match, shot, judge_shot(match.variant, situation, shot))
    assert len(match.played) > 3
    assert match.situation.phase == "open"
