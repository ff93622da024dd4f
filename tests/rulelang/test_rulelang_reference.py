"""docs/language.md says what is so: its examples compile, its phrases tell their events."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest
from rule_cases import POOL, ROOT, Situation, nothing_to_use, parse_event

from rulelang.codes import CODES
from rulelang.compile import check_script, compile_script
from rulelang.evaluate import judge
from rulelang.facts import Shot

TEXT = (ROOT / "docs" / "language.md").read_text(encoding="utf-8")
EXAMPLES = re.findall(r"```rules\n(.*?)```", TEXT, re.DOTALL)
EVENTS = TEXT.split("## Events")[1].split("\nMore phrases")[0]
PHRASES = re.findall(r"^\| `(.+?)` \| `(.+?)` \|$", EVENTS, re.MULTILINE)
ALSO = {
    ("cue hits 8", "cue hits 8 and 9"),
    ("8 topples left-pin", "8 and 9 topple left-pin"),
}
TABLE = replace(
    POOL, pins=("left-pin", "right-pin"), zones=(*POOL.zones, "foot-end"), players=(2, 4)
)


@pytest.mark.parametrize("example", EXAMPLES)
def test_example_compiles_without_a_mistake(example: str) -> None:
    assert check_script(example, "example", TABLE, nothing_to_use) == ()


def test_every_event_of_the_contract_has_a_phrase() -> None:
    assert len(PHRASES) == 25


@pytest.mark.parametrize(("event", "phrase"), PHRASES)
def test_phrase_tells_its_event_and_no_other(event: str, phrase: str) -> None:
    program = compile_script(f"if {phrase}: foul told", "phrase", TABLE, nothing_to_use)
    situation = Situation(
        2, 1, "", (0, 0), frozenset(ball.name for ball in TABLE.balls), {}, frozen=frozenset()
    )
    for other, _ in PHRASES:
        shot = Shot("cue", (parse_event(other),))
        told = bool(judge(program, situation, shot).fouls)
        assert told == (other == event or (event, other) in ALSO), other


def test_every_code_is_listed() -> None:
    listed = dict(re.findall(r"^\| (R\d{3}) \| (.*?) \|$", TEXT, re.MULTILINE))
    assert listed == CODES


NOTIONS = re.findall(
    r"^\| (.+?) \| `(.+?)` \| `(\w+)` \|$",
    TEXT.split("## What it says, and where")[1].split("## Limits")[0],
    re.MULTILINE,
)


def source_with_used(name: str) -> str:
    """Return a shipped script with those it uses."""
    for folder in (ROOT / "variants" / "rules", ROOT / "variants"):
        path = folder / f"{name}.rules"
        if path.exists():
            text = path.read_text(encoding="utf-8")
            return text + "".join(
                source_with_used(used) for used in re.findall(r'^uses "(.+?)"', text, re.MULTILINE)
            )
    return ""


@pytest.mark.parametrize(("notion", "piece", "game"), NOTIONS)
def test_each_notion_is_where_the_page_says(notion: str, piece: str, game: str) -> None:
    assert piece in source_with_used(game), notion


def test_the_notions_are_many() -> None:
    assert len(NOTIONS) > 40
