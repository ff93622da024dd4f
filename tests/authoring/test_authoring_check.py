"""Closes the hole between what `check` finds and what a program that calls it learns."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import pytest
from click.testing import CliRunner

from engine.__main__ import main

if TYPE_CHECKING:
    from pathlib import Path

KEYS = {
    "code", "file", "line", "column", "message", "mend", "snippet", "width", "key", "severity",
}  # fmt: skip


@pytest.mark.parametrize(
    ("script", "status", "codes"),
    [
        ("if cue ball pocketed: respot cue\n", 0, []),
        ("define x as 8-ball\nif cue ball pocketed: respot cue\n", 0, ["R407"]),
        ("if cue ball is pocketed: respot cue\ngo to phase x\n", 1, ["R107", "R202"]),
    ],
)
def test_check_as_json(tmp_path: Path, script: str, status: int, codes: list[str]) -> None:
    (tmp_path / "mine.toml").write_text('extends = "eight_ball"\n')
    (tmp_path / "mine.rules").write_text(script)
    told = CliRunner().invoke(main, ["check", "--json", str(tmp_path / "mine.toml")])
    found = json.loads(told.output)
    assert (told.exit_code, [one["code"] for one in found]) == (status, codes)
    assert all(set(one) == KEYS for one in found)


def test_a_variant_that_is_not_there_is_another_status() -> None:
    told = CliRunner().invoke(main, ["check", "--json", "snoker"])
    assert (told.exit_code, json.loads(told.output)[0]["code"]) == (2, "V001")
