"""Every golden record of every game passes; a changed expectation does not."""

from functools import cache
from pathlib import Path

import pytest

from engine.records.read import read_record, read_record_text
from engine.records.run import run_record
from engine.records.update import update_text
from engine.variant.load import load_variant

GOLDEN = Path(__file__).resolve().parent.parent / "golden"
RECORDS = sorted(GOLDEN.rglob("*.toml"))
load = cache(load_variant)


@pytest.mark.parametrize("path", RECORDS, ids=lambda path: path.stem)
def test_record(path):
    outcome = run_record(read_record(path, load))
    assert [str(one) for one in outcome.differences] == []


@pytest.mark.parametrize("game", sorted(path.name for path in GOLDEN.iterdir()))
def test_every_game_has_records(game):
    assert list((GOLDEN / game).glob("*.toml"))


def altered(path, old, new):
    text = path.read_text(encoding="utf-8")
    assert text.count(old) == 1
    return text.replace(old, new)


CASES = [
    ("eight_ball/8b-33-8-pocketed-with-scratch.toml", 'fouls = ["scratch"]', "fouls = []", "fouls"),
    ("eight_ball/8b-33-8-pocketed-with-scratch.toml", "winner = 2", "winner = 1", "winner"),
    (
        "snooker/sn-42-two-colours-to-spot-with-their-own.toml",
        "blue at green-spot",
        "blue at pink-spot",
        "spotted",
    ),
    ("snooker/sn-43-all-spots-occupied.toml", "black near", "black at", "spotted"),
    (
        "snooker/sn-06-nominated-blue-pink-struck-first.toml",
        "points = [0, 6]",
        "points = [0, 5]",
        "points",
    ),
    ("snooker/sn-07-nominated-yellow-in-off.toml", 'in_hand = "d"', 'in_hand = "none"', "in_hand"),
    (
        "three_cushion/tc-18-cue-ball-frozen-to-red-respot-those.toml",
        '["play", "respot"]',
        "[]",
        "options",
    ),
]


@pytest.mark.parametrize(("name", "old", "new", "key"), CASES)
def test_a_wrong_expectation_is_a_difference_and_can_be_rewritten(name, old, new, key):
    path = GOLDEN / name
    text = altered(path, old, new)
    outcome = run_record(read_record_text(text, path, load))
    assert [one.key for one in outcome.differences] == [key]
    mended = update_text(text, outcome)
    again = run_record(read_record_text(mended, path, load))
    assert again.passed
    comments = [line for line in text.splitlines() if line.startswith("#")]
    assert [line for line in mended.splitlines() if line.startswith("#")] == comments
