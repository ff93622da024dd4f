"""Closes the hole between the walk of docs/authoring.md and a game that really plays."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "authoring.md").read_text(encoding="utf-8")
FILES = {
    "wrong-ball.toml" if name == "record" else name: text
    for name, text in re.findall(r"```(?:toml|rules) ([\w.]+)\n(.*?)```", PAGE, re.DOTALL)
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name, text in FILES.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    return tmp_path


def engine(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    """Run a command as an author does: in the folder of the game."""
    return subprocess.run(
        [sys.executable, "-m", "engine", *words],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )


def test_the_page_holds_a_game_and_a_record() -> None:
    assert set(FILES) == {"three_balls.toml", "three_balls.rules", "wrong-ball.toml"}


def test_the_game_is_sound_without_even_a_warning(folder: Path) -> None:
    told = engine(folder, "check", "./three_balls.toml")
    assert (told.returncode, told.stderr) == (0, "")
    assert "no mistakes" in told.stdout


def test_the_mistake_is_told_in_the_words_of_the_page(folder: Path) -> None:
    script = folder / "three_balls.rules"
    text = script.read_text(encoding="utf-8")
    script.write_text(text.replace("if cue ball pocketed or", "if cue ball is pocketed or"))
    told = engine(folder, "check", "./three_balls.toml")
    assert told.returncode == 1
    assert told.stderr.strip() in PAGE


def test_the_game_is_played_and_the_record_judged(folder: Path) -> None:
    played = engine(folder, "simulate", "./three_balls.toml", "--speed", "4")
    assert played.returncode == 0
    assert "cue hits 1 at" in played.stdout
    assert "phase: open" in played.stdout
    judged = engine(folder, "golden", "wrong-ball.toml")
    assert (judged.returncode, judged.stdout.strip()) == (0, "1 passed, 0 differ, 0 unusable")
    explained = engine(folder, "explain", "wrong-ball.toml")
    assert "foul: wrong-ball [3] (Wrong ball)" in explained.stdout
