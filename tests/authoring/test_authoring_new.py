"""Closes the hole between a game that was just begun and one that checks clean and plays."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
from click.testing import CliRunner

from engine.__main__ import main
from engine.authoring.scaffold import ScaffoldError, scaffold
from engine.game.match import start_match
from engine.variant.load import check_variant, list_variants, load_variant

if TYPE_CHECKING:
    from pathlib import Path

GAMES = [one.name for one in list_variants()]


@pytest.mark.parametrize("base", GAMES)
@pytest.mark.parametrize("extends", [False, True])
def test_a_new_game_is_sound_and_starts(tmp_path: Path, base: str, *, extends: bool) -> None:
    toml, rules = scaffold("my_game", base, tmp_path, extends=extends)
    assert rules.exists()
    assert check_variant(toml) == []
    variant = load_variant(toml)
    assert (variant.name, variant.title) == ("my_game", "My game")
    assert variant.program.title == "My game"
    match = start_match(variant)
    assert match.situation.shooter == 1


def test_the_first_line_leads_an_editor_to_the_schema(tmp_path: Path) -> None:
    toml, _ = scaffold("my_game", "nine_ball", tmp_path, extends=False)
    first = toml.read_text(encoding="utf-8").split("\n")[0]
    assert first.startswith("#:schema ")
    assert (tmp_path / first.removeprefix("#:schema ")).resolve().name == "variant.json"
    assert (tmp_path / first.removeprefix("#:schema ")).exists()


@pytest.mark.parametrize(
    ("name", "base", "told"),
    [
        ("My Game", "nine_ball", "write `my_game`"),
        ("../x", "nine_ball", "write `x`"),
        ("eight_ball", "nine_ball", "already"),
        ("mine", "nine_bal", "nine_ball"),
    ],
)
def test_a_name_that_will_not_do_is_refused(
    tmp_path: Path, name: str, base: str, told: str
) -> None:
    with pytest.raises(ScaffoldError, match=told):
        scaffold(name, base, tmp_path, extends=False)
    assert not list(tmp_path.iterdir())


def test_nothing_is_written_over(tmp_path: Path) -> None:
    (tmp_path / "mine.rules").write_text("# precious\n")
    with pytest.raises(ScaffoldError, match="is there already"):
        scaffold("mine", "nine_ball", tmp_path, extends=False)
    assert (tmp_path / "mine.rules").read_text() == "# precious\n"
    assert not (tmp_path / "mine.toml").exists()


def test_the_command_lists_and_writes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    run = CliRunner().invoke
    listed = run(main, ["new", "--list"]).output
    assert all(game in listed for game in GAMES)
    assert run(main, ["new", "mine"]).exit_code == 2
    assert run(main, ["new", "mine", "--from", "snooker", "--extends"]).exit_code == 0
    assert run(main, ["check", "./mine.toml"]).exit_code == 0
    again = run(main, ["new", "mine", "--from", "snooker"])
    assert (again.exit_code, "is there already" in again.output) == (2, True)
