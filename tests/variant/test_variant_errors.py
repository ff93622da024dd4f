"""Closes the hole between a mistake in a file and the line, code and words that tell it.

Each file in `errors/` says on the failing line what is to be found there:
`# expect: CODE "part of the message or of the mend"`.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from engine.variant.codes import CODES
from engine.variant.load import read_draft
from rulelang.diagnostics import render

ERRORS = Path(__file__).parent / "errors"
FILES = sorted(ERRORS.glob("*.toml"))
CIRCLE = {
    "extends-in-a-circle": "extends-in-a-circle-too",
    "extends-in-a-circle-too": "extends-in-a-circle",
}
EXPECT = re.compile(r'# expect: (V\d+) "(.*)"$')


def expected_in(path):
    found = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        match = EXPECT.search(line)
        if match:
            found.append((number, match.group(1), match.group(2)))
    return found


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_every_mistake_is_told_on_its_line(path):
    _, diagnostics = read_draft(path)
    told = "\n".join(render(one) for one in diagnostics)
    expected = expected_in(path)
    if path.stem in CIRCLE:
        assert [(one.code, Path(one.file).stem) for one in diagnostics] == [
            ("V202", CIRCLE[path.stem])
        ]
        return
    assert expected, "the file expects nothing"
    assert sorted((one.line, one.code) for one in diagnostics) == sorted(
        (line, code) for line, code, _ in expected
    ), told
    for line, code, words in expected:
        texts = [
            one.message + " " + one.mend
            for one in diagnostics
            if (one.line, one.code) == (line, code)
        ]
        assert any(words in text for text in texts), told


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_every_mistake_points_into_its_line(path):
    for one in read_draft(path)[1]:
        assert one.code in CODES
        assert one.message
        if one.snippet:
            lines = Path(one.file).read_text(encoding="utf-8").split("\n")
            assert lines[one.line - 1] == one.snippet
            assert 1 <= one.column <= len(one.snippet) + 1
            assert one.column + one.width - 1 <= len(one.snippet) + 1


def test_the_codes_are_proved():
    proved = {code for path in FILES for _, code, _ in expected_in(path)}
    elsewhere = {"V001", "V002", "V204"}
    assert proved | elsewhere == set(CODES)
