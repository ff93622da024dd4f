"""Closes the hole between a mistake people make and an answer that helps them mend it."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[2]))

from tools.mistakes import amiss, collection, expected_in, main

FILES = collection()


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_the_answer_has_its_place_its_code_and_a_mend(path: Path) -> None:
    assert expected_in(path), "the file expects nothing"
    assert not list(amiss(path))


def test_the_collection_is_large() -> None:
    assert sum(path.suffix == ".toml" for path in FILES) >= 30
    assert sum(path.suffix == ".rules" for path in FILES) >= 30


def test_the_tool_prints_every_answer_and_a_count(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([]) == 0
    told = capsys.readouterr().out
    assert told.count("        mend: ") == sum(len(expected_in(path)) for path in FILES)
    assert " 0 not as expected" in told.splitlines()[-1]


def test_the_tool_tells_what_is_not_as_expected(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    broken = tmp_path / "broken.rules"
    broken.write_text('if 8-ball pocketed: fowl x  # expect: R101 "say `fool`"\n')
    assert main([str(broken)]) == 1
    assert "NOT AS EXPECTED" in capsys.readouterr().out
