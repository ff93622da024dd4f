"""Pins in the language: which fell, by what, which stand, and which are set up again."""

from __future__ import annotations

from dataclasses import replace

import pytest
from rule_cases import POOL, Situation, nothing_to_use, parse_event

from rulelang.compile import compile_script
from rulelang.decisions import Decisions, SetUp
from rulelang.evaluate import judge
from rulelang.facts import Shot

TABLE = replace(POOL, pins=("left-pin", "right-pin"))
BALLS = frozenset(ball.name for ball in TABLE.balls)


def play(script: str, *events: str, fallen: frozenset[str] = frozenset()) -> Decisions:
    program = compile_script(script, "pins", TABLE, nothing_to_use)
    before = Situation(2, 1, "", (0, 0), BALLS, {}, fallen=fallen)
    return judge(program, before, Shot("cue", tuple(map(parse_event, events))))


def told(condition: str, *events: str, fallen: frozenset[str] = frozenset()) -> bool:
    return bool(play(f"if {condition}: foul told", *events, fallen=fallen).fouls)


@pytest.mark.parametrize(
    ("condition", "events"),
    [
        ("every pin is standing", []),
        ("no pin is standing", ["1 topples left-pin", "2 topples right-pin"]),
        ("number of pins standing is 1", ["left-pin leans on 1"]),
        ("pins standing is right-pin", ["1 and cue topple left-pin"]),
        ("any pin toppled by cue ball", ["1 and cue topple left-pin"]),
        ("only left-pin toppled", ["1 topples left-pin", "cue hits 1"]),
        ("only pins toppled by object balls is left-pin", ["1 topples left-pin"]),
        ("any pin toppled by pins", ["1 topples left-pin", "left-pin topples right-pin"]),
        ("left-pin toppled any pin", ["1 topples left-pin", "left-pin topples right-pin"]),
        ("cue ball touched any pin", ["cue touches left-pin"]),
        ("any pin leaned on 1-ball", ["left-pin leans on 1"]),
    ],
)
def test_pins_are_told(condition: str, events: list[str]) -> None:
    assert told(condition, *events)


@pytest.mark.parametrize(
    ("condition", "events"),
    [
        ("every pin is standing", ["1 topples left-pin"]),
        ("no pin is standing", ["1 topples left-pin", "cue touches right-pin"]),
        ("left-pin is standing", ["left-pin leans on 1"]),
        ("any pin toppled by cue ball", ["1 topples left-pin"]),
        ("only left-pin toppled", ["1 topples left-pin", "cue topples right-pin"]),
        ("any pin toppled by pins", ["1 topples left-pin"]),
        ("any pin toppled", ["left-pin leans on 1"]),
    ],
)
def test_pins_are_not_told(condition: str, events: list[str]) -> None:
    assert not told(condition, *events)


def test_a_pin_that_fell_before_the_shot_does_not_stand() -> None:
    assert told("pins standing is right-pin", fallen=frozenset({"left-pin"}))
    frozen = "define upright before shot as number of pins standing\nif upright is 1: foul told"
    assert play(frozen, "1 topples right-pin", fallen=frozenset({"left-pin"})).fouls


def test_pins_are_set_up_in_the_order_of_the_table() -> None:
    assert play("table: set up pins").table == (SetUp(("left-pin", "right-pin")),)
    assert play("table: set up right-pin", "1 topples left-pin").table == (SetUp(("right-pin",)),)


def test_each_pin_is_asked_for_itself() -> None:
    script = """
fouls:
    for each of pins toppled:
        if it toppled any pin after cue ball touched it: foul driven
"""
    first = ["1 topples left-pin", "cue touches left-pin"]
    assert play(script, *first, "left-pin topples right-pin").fouls
    assert not play(script, "1 topples left-pin", "left-pin topples right-pin").fouls
