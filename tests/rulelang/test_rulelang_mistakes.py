"""An author's mistakes: each expectation stands on the failing line of mistakes.txt."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from rule_cases import POOL, nothing_to_use

from rulelang.codes import CODES
from rulelang.compile import check_script, compile_script
from rulelang.diagnostics import Diagnostic, ScriptError, render

CHUNKS = Path(__file__).with_name("mistakes.txt").read_text(encoding="utf-8").split("\n---\n")
EXPECT = re.compile(r"  # expect: (R\d{3}) (\d+) (.*?) -> (.*?)(?=  # expect: |$)")


def check(source: str) -> tuple[Diagnostic, ...]:
    return check_script(source, "t.rules", POOL, nothing_to_use)


@pytest.mark.parametrize("chunk", CHUNKS, ids=lambda chunk: chunk.split("  #")[0][:40])
def test_mistake(chunk: str) -> None:
    wanted = [
        (code, number, int(column), message, mend)
        for number, line in enumerate(chunk.strip("\n").split("\n"), 1)
        for code, column, message, mend in EXPECT.findall(line)
    ]
    found = [(d.code, d.line, d.column, d.message, d.mend) for d in check(chunk)]
    assert found == wanted


def test_mistakes_are_many() -> None:
    assert len(CHUNKS) >= 50


def test_open_string_and_cite_and_tab() -> None:
    assert [d.code for d in check('if cue ball pocketed: foul "scratch\n')] == ["R108"]
    assert [d.code for d in check('rule "A" [3.1: if cue ball pocketed: foul x\n')] == ["R108"]
    assert [d.code for d in check("fouls:\n\tif cue ball pocketed: foul x\n")] == ["R105"]


def test_all_mistakes_come_at_once() -> None:
    source = (
        "points:\n"
        '    rule "A": if 8-ball is pocketed: award 1 to shooter\n'
        '    rule "B": if 9-ball pocketed award 1 to shooter\n'
        '    rule "C":\n'
        "        if 7-ball pocketed and 6-ball pocketed or 5-ball pocketed:\n"
        "            award 1 to shooter\n"
        '    rule "D": if 99-ball pocketed: award 1 to shooter\n'
        "turn:\n"
        "    if contact: turn continues\n"
    )
    found = {(d.line, d.code) for d in check(source)}
    assert found == {(2, "R107"), (3, "R102"), (5, "R103"), (7, "R201"), (9, "R201")}


def test_a_define_that_cannot_be_read_makes_no_second_mistake() -> None:
    source = "define good when 8-ball is pocketed\nturn: if good: turn continues\n"
    assert [d.code for d in check(source)] == ["R107"]


def test_compile_raises_with_all_of_them() -> None:
    with pytest.raises(ScriptError) as caught:
        compile_script("spot 8-ball at fot-spot\nif x: turn continues\n", "t", POOL, nothing_to_use)
    assert [d.code for d in caught.value.diagnostics] == ["R203", "R201"]


def test_rendered_with_caret_and_mend() -> None:
    told = render(check("spot 8-ball at fot-spot")[0])
    assert told.split("\n") == [
        't.rules:1:16: error R203: "fot-spot" is not a spot',
        "    1 | spot 8-ball at fot-spot",
        "      |                ^^^^^^^^",
        "        mend: did you mean `foot-spot`?",
    ]


def test_every_code_told_is_in_the_table() -> None:
    told = {code for chunk in CHUNKS for code, *_ in EXPECT.findall(chunk)}
    assert told <= set(CODES)


@pytest.mark.parametrize(
    "source",
    [
        "(" * 3000,
        "if " + "not " * 20000 + "cue ball pocketed: foul x",
        "if " + "(" * 20 + "cue ball pocketed" + ")" * 20 + ": foul x",
        "x" * 300_000,
        "\x00\x01 foul",
        "\n".join(" " * n + "if cue ball pocketed:" for n in range(0, 400, 4)),
        "define a1 as " + " plus ".join(["1"] * 5000),
        "",
        "\n\n#only a comment\n",
        "é",
    ],
)
def test_hostile_text_is_answered(source: str) -> None:
    assert isinstance(check(source), tuple)
