"""Every mistake in a record is told at its line, all at once, with a mend."""

import re
from functools import cache
from pathlib import Path

import pytest

from engine.records.read import read_record
from engine.records.record import RecordError
from engine.variant.load import load_variant

HERE = Path(__file__).resolve().parent
FILES = sorted((HERE / "errors").glob("*.toml"))
EXPECTED = re.compile(r'# expect: (\w+) "(.*)"')
ELSEWHERE = re.compile(r"# expect-line: (\d+) (\w+)")


def expectations(text):
    for number, line in enumerate(text.splitlines(), 1):
        if found := EXPECTED.search(line):
            yield number, found[1], found[2]
        if found := ELSEWHERE.search(line):
            yield int(found[1]), found[2], ""


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_mistakes_are_told_where_they_stand(path):
    wanted = list(expectations(path.read_text(encoding="utf-8")))
    assert wanted
    with pytest.raises(RecordError) as caught:
        read_record(path, cache(load_variant))
    told = caught.value.diagnostics
    assert [(one.line, one.code) for one in sorted(told, key=lambda one: one.line)] == [
        (line, code) for line, code, _ in wanted
    ]
    by_place = {(one.line, one.code): f"{one.message} {one.mend}" for one in told}
    for line, code, text in wanted:
        assert text in by_place[line, code]


def test_a_missing_file_is_told():
    with pytest.raises(RecordError) as caught:
        read_record(HERE / "nowhere.toml", load_variant)
    assert caught.value.diagnostics[0].code == "V001"
