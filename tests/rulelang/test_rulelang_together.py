"""Several zones under one name: who lies together in one of them, and who stayed there."""

from __future__ import annotations

from dataclasses import replace

import pytest
from rule_cases import CAROM, nothing_to_use, parse_event, situation_of

from rulelang.compile import compile_script
from rulelang.evaluate import judge
from rulelang.facts import Shot

TABLE = replace(CAROM, zones=("west", "middle", "east"))
HERE = {"red": "west", "yellow": "west"}
ASTRIDE = {"red": ["west", "middle"], "yellow": ["middle", "east"]}
CASES = [
    ("object balls are together in sides", "", HERE, True),
    ("object balls are together in sides", "", {"red": "west", "yellow": "east"}, False),
    ("object balls are together in sides", "", {"red": "middle", "yellow": "middle"}, False),
    ("object balls are not together in sides", "", {"red": "west", "yellow": "east"}, True),
    ("object balls are together in sides", "", {"red": "west"}, False),
    ("object balls are together in all", "", ASTRIDE, True),
    ("object balls are together in sides", "", ASTRIDE, False),
    ("balls are together in sides", "", HERE, False),
    ("object balls are together in west", "", HERE, True),
    ("object balls are together in east", "red enters east; yellow enters east", HERE, True),
    ("object balls are together in sides", "red leaves west; red enters west", HERE, True),
    ("object balls are together in sides", "red leaves table", HERE, False),
    ("object balls stayed together in sides", "white hits red", HERE, True),
    ("object balls stayed together in sides", "red leaves west; red enters west", HERE, False),
    ("object balls stayed together in sides", "white leaves west", HERE, True),
    ("object balls stayed together in sides", "yellow enters west", {"red": "west"}, False),
    ("object balls stayed together in sides", "yellow leaves table", HERE, False),
    ("object balls stayed together in sides", "yellow hits outside", HERE, False),
    ("object balls stayed together in all", "red leaves west", ASTRIDE, True),
    ("object balls stayed together in all", "red leaves middle", ASTRIDE, False),
    ("not object balls stayed together in sides", "white hits red", HERE, False),
]


@pytest.mark.parametrize(("condition", "events", "zones", "wanted"), CASES)
def test_together(condition, events, zones, wanted):
    script = (
        "zones sides are (west, east)\n"
        "zones all are (west, middle, east)\n"
        f"fouls: if {condition}: foul told"
    )
    program = compile_script(script, "script.rules", TABLE, nothing_to_use)
    situation = situation_of(TABLE, program, {"zones": zones}, {})
    shot = Shot("white", tuple(parse_event(text) for text in events.split("; ") if text))
    assert bool(judge(program, situation, shot).fouls) == wanted


def test_only_the_zones_that_balls_stay_in_are_watched():
    script = (
        "zones sides are (west, east)\n"
        "fouls: if object balls stayed together in sides and balls are together in middle: foul x"
    )
    program = compile_script(script, "script.rules", TABLE, nothing_to_use)
    assert program.asks == {"west", "east"}


def test_the_start_is_what_is_frozen_before_the_shot():
    script = (
        "zones sides are (west, east)\n"
        "define paired before shot when object balls are together in sides\n"
        "fouls: if paired: foul told"
    )
    program = compile_script(script, "script.rules", TABLE, nothing_to_use)
    situation = situation_of(TABLE, program, {"zones": HERE}, {})
    shot = Shot("white", (parse_event("red leaves west"),))
    assert judge(program, situation, shot).fouls
