"""What a saved shot leaves out: settings and tracked values as they are at a start."""

import tomllib
from functools import cache

import pytest

from engine.game.match import advance, start_match
from engine.game.phrases import parse_event
from engine.game.referee import judge_shot
from engine.game.shot import Shot
from engine.records.read import read_record
from engine.records.run import run_record
from engine.records.write import record_text
from engine.variant.load import load_variant

load = cache(load_variant)


def after(match, *events):
    shot = Shot(events=tuple(map(parse_event, events)))
    return advance(match, shot, judge_shot(match.variant, match.situation, shot))


def saved(match, tmp_path, index=-1):
    text = record_text(match, index)
    path = tmp_path / "shot.toml"
    path.write_text(text, encoding="utf-8")
    assert run_record(read_record(path, load)).differences == ()
    return tomllib.loads(text)


def test_nothing_is_said_of_settings_and_values_of_a_start(tmp_path):
    match = after(start_match(load("english_billiards")), "white hits red")
    record = saved(match, tmp_path)
    assert "settings" not in record
    assert "state" not in record["before"]
    assert "state" not in record["shot"][0]["expect"]


def test_a_setting_of_ones_own_is_said(tmp_path):
    start = start_match(load("english_billiards"), settings={"target": 40})
    record = saved(after(start, "white hits red"), tmp_path)
    assert record["settings"] == {"target": 40}


@pytest.mark.parametrize(("index", "before", "later"), [(0, None, 1), (1, 1, 2), (2, 2, 0)])
def test_a_value_that_moved_is_said_and_its_way_back_too(tmp_path, index, before, later):
    match = start_match(load("english_billiards"))
    match = after(match, "white hits red", "red pocketed foot-left")
    match = after(match, "white hits red", "red pocketed foot-left")
    match = after(match, "white hits red")
    record = saved(match, tmp_path, index)
    name = "hazards-in-a-row"
    assert record["before"].get("state", {}).get(name) == before
    assert record["shot"][0]["expect"]["state"][name] == later
