"""Every construct of the language is used by a shipped game, and explained by a tested example."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import pytest
from rule_cases import ROOT

sys.path.insert(0, str(ROOT))
sys.path.insert(0, str(Path(__file__).parent))

from test_rulelang_automaton import Indentation

from rulelang.making import lark_of
from tools.phrases import EVENT_PHRASES, PHRASES

SCRIPTS = sorted((ROOT / "variants").rglob("*.rules"))

TWINS = {
    "safety_called": "safety_not_called",
    "state_standing": "standing",
    "placed_in": "placed_outside",
}
"""Constructs that are one idea: `was [not] called`, `PIN is standing` and `PINS standing`."""

OF_RECORDS = {
    "left_cushion": "A leaves cushion C",
    "rebounded": "A rebounds from P",
}
"""Phrases that are there because every event of a record has one."""


def used_by(texts):
    """Return the grammar's constructs that occur in the trees of `texts`, by name."""
    parser = lark_of(postlex=Indentation())
    callbacks = parser.parser.parser.parser.callbacks
    used = set()

    def noting(rule, make):
        def made(children):
            used.add(name_of(rule))
            return make(children)

        return made

    every = {name_of(rule) for rule in parser.rules}
    for rule in parser.rules:
        callbacks[rule] = noting(rule, callbacks[rule])
    for text in texts:
        parser.parse(text if text.endswith("\n") else text + "\n")
    return {name for name in every if "__" not in name}, used


def name_of(rule):
    return str(rule.alias or rule.origin.name)


def test_every_construct_is_used_by_a_shipped_game():
    every, used = used_by(path.read_text(encoding="utf-8") for path in SCRIPTS)
    assert set(TWINS.values()) <= used
    assert every - used == set(TWINS) | set(OF_RECORDS)


def test_every_construct_is_in_an_example_of_the_reference():
    examples = [one.needs + one.example for one in PHRASES]
    examples += [f"if {told}: foul x" for _, told in EVENT_PHRASES]
    page = (ROOT / "docs" / "language.md").read_text(encoding="utf-8")
    examples += re.findall(r"```rules\n(.*?)```", page, re.DOTALL)
    every, used = used_by(examples)
    assert every - used == set()


@pytest.mark.parametrize("event", OF_RECORDS.values())
def test_what_no_game_uses_is_an_event_of_records(event):
    told = [left for left, _ in EVENT_PHRASES]
    verb = event.split()[1]
    assert any(f" {verb} " in left for left in told)
