"""What records prove is counted right, and a wrong rule is noticed exactly where it can be."""

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from engine.__main__ import main
from engine.proving.coverage import coverage_of
from engine.proving.games import load_game, records_by_game
from engine.proving.mutate import joined, mutate, mutate_all
from engine.variant.load import load_variant

RULES = """\
language 1
game "Tiny" cites "Book"

phases early, late

define made when any object ball pocketed

at game start:
    rule "First" [1]: go to phase early

points:
    rule "Score" [2.1, 2.2]:
        if made and not cue ball pocketed: award 1 to shooter
        otherwise if cue ball pocketed: deduct 2 from shooter

turn:
    rule "Go on" [3]:
        if made: turn continues
        otherwise: turn passes
    rule "Two" [3]: if 8-ball pocketed: go to phase late

next shot:
    rule "Choose" [4]:
        if phase is late:
            offer opponent:
                play: nothing happens
                change: go to phase early

ending:
    rule "Never" [9]: if 9-ball pocketed: shooter wins game
"""
RECORD = """\
format = 1
variant = "{variant}"
title = "A pot"

[before]
phase = "{phase}"

[[shot]]
events = [{events}]

[shot.expect]
{expect}
"""


@pytest.fixture
def tiny(tmp_path):
    (tmp_path / "tiny.toml").write_text('extends = "eight_ball"\ntitle = "Tiny"\nrules = "tiny"\n')
    (tmp_path / "tiny.rules").write_text(RULES)
    (tmp_path / "shots").mkdir()
    return tmp_path


def record(folder, name, events, expect, phase="early"):
    told = ", ".join(f'"{one}"' for one in events)
    text = RECORD.format(variant=folder / "tiny.toml", phase=phase, events=told, expect=expect)
    (folder / "shots" / f"{name}.toml").write_text(text)


def proved(folder):
    return load_game(str(folder / "tiny.toml"), sorted((folder / "shots").glob("*.toml")))


def missing(folder):
    return {(one.what, one.text) for one in coverage_of(proved(folder)).missing}


def test_what_one_pot_proves(tiny):
    record(tiny, "pot", ["cue hits 1", "1 pocketed foot-left"], "points = [1, 0]\nnext = 1")
    found = coverage_of(proved(tiny))
    assert (found.rules, found.rules_fired) == (6, 3)
    assert found.sections == ("1", "2.1", "2.2", "3", "4", "9")
    assert found.proved == ("1", "2.1", "2.2", "3")
    assert (found.toml_lines, found.rule_lines, found.records) == (3, 30, 1)
    assert missing(tiny) == {
        ("rule never fires", "Two"),
        ("rule never fires", "Choose"),
        ("rule never fires", "Never"),
        ("never false", "made"),
        ("never true", "cue ball pocketed"),
        ("never false", "cue ball pocketed"),
        ("never false", "made and not cue ball pocketed"),
        ("never true", "8-ball pocketed"),
        ("never true", "9-ball pocketed"),
        ("never true", "phase is late"),
        ("otherwise never taken", "turn passes"),
        ("option never taken", "play"),
        ("option never taken", "change"),
    }


def test_a_part_of_a_sequence_is_no_condition_of_its_own(tiny):
    text = RULES.replace("if 8-ball pocketed", "if cue ball hit 8-ball before 8-ball pocketed")
    (tiny / "tiny.rules").write_text(text)
    record(tiny, "eight", ["cue hits 8", "8 pocketed foot-left"], 'phase = "late"')
    sites = [site.text for site in proved(tiny).probe.sites]
    assert "cue ball hit 8-ball before 8-ball pocketed" in sites
    assert "cue ball hit 8-ball" not in sites


def test_an_option_taken_is_seen(tiny):
    record(tiny, "choice", [], "next = 1", "late")
    path = tiny / "shots" / "choice.toml"
    text = path.read_text().replace("events = []", 'choose = "change"')
    path.write_text(text.replace('"late"\n', '"late"\noptions = ["play", "change"]\n', 1))
    assert ("option never taken", "change") not in missing(tiny)
    assert ("option never taken", "play") in missing(tiny)


def test_a_record_that_expects_more_catches_more(tiny):
    events = ["cue hits 1", "1 pocketed foot-left"]
    record(tiny, "pot", events, "next = 1")
    loose = {(one.kind, one.text) for one in mutate(proved(tiny)).survivors}
    record(tiny, "pot", events, "next = 1\npoints = [1, 0]")
    tight = {(one.kind, one.text) for one in mutate(proved(tiny)).survivors}
    assert loose - tight == {
        ("rule", "Score"),
        ("number", "1"),
        ("condition", "made and not cue ball pocketed"),
        ("condition", "made"),
    }
    assert ("number", "2") in tight


def test_a_record_without_a_before_proves_the_start(tiny):
    record(tiny, "start", ["cue hits 1"], 'phase = "early"')
    text = (tiny / "shots" / "start.toml").read_text()
    assert ("rule", "First") in {(one.kind, one.text) for one in mutate(proved(tiny)).survivors}
    (tiny / "tiny.rules").write_text(RULES.replace("phases early, late", "phases late, early"))
    (tiny / "shots" / "start.toml").write_text(text.replace('[before]\nphase = "early"\n', ""))
    assert ("rule", "First") not in {(one.kind, one.text) for one in mutate(proved(tiny)).survivors}


def test_a_record_that_does_not_pass_is_told_and_proves_nothing_wrong(tiny):
    record(tiny, "pot", ["cue hits 1", "1 pocketed foot-left"], "points = [7, 0]")
    assert len(coverage_of(proved(tiny)).failing) == 1
    found = mutate(proved(tiny))
    assert found.caught == 0


def test_processes_find_what_one_finds(tiny):
    record(tiny, "pot", ["cue hits 1", "1 pocketed foot-left"], "points = [1, 0]\nnext = 1")
    game = str(tiny / "tiny.toml")
    paths = sorted((tiny / "shots").glob("*.toml"))
    alone = joined([mutate(load_game(game, paths))])
    assert joined(list(mutate_all({game: paths}, 2))) == alone


def test_a_probe_changes_no_verdict():
    paths = sorted(Path(__file__).parent.parent.joinpath("golden", "nine_ball").glob("*.toml"))
    assert all(case.passed for case in load_game("nine_ball", paths).cases)


def test_a_program_without_a_probe_has_no_counters():
    probed = load_game("nine_ball", []).variant.program
    plain = load_variant("nine_ball").program
    for program, expected in ((plain, True), (probed, False)):
        rules = [rule for found in program.compiled.values() for rule in found]
        assert any(rule.asked or rule.any for rule in rules) is expected


def run(*words):
    return CliRunner().invoke(main, ["golden", *map(str, words)])


def test_the_command_tells_what_is_missing(tiny):
    record(tiny, "pot", ["cue hits 1", "1 pocketed foot-left"], "points = [1, 0]")
    done = run("--coverage", tiny / "shots")
    assert done.exit_code == 1
    assert "3 of 6, 50.0 %" in done.output
    assert f"{tiny / 'tiny.rules'}:30: rule never fires: Never" in done.output
    told = json.loads(run("--coverage", "--json", tiny / "shots").output)
    assert told[0]["rules_fired"] == 3


def test_the_command_tells_survivors(tiny):
    record(tiny, "pot", ["cue hits 1", "1 pocketed foot-left"], "points = [1, 0]")
    done = run("--mutate", "--jobs", "1", tiny / "shots")
    assert done.exit_code == 1
    assert "rule dropped: Never (no record passes)" in done.output
    told = json.loads(run("--mutate", "--json", "--jobs", "1", tiny / "shots").output)
    assert told[0]["caught"] + len(told[0]["survivors"]) == told[0]["tried"]


def test_a_game_is_named_where_its_records_lie(tiny):
    record(tiny, "pot", ["cue hits 1"], "points = [0, 0]")
    games, trouble = records_by_game([Path("shots")], tiny)
    assert [len(paths) for paths in games.values()] == [1]
    assert not trouble


def test_what_cannot_be_used_is_told(tiny):
    assert run("--coverage", tiny / "nowhere").exit_code == 2
    (tiny / "shots" / "bad.toml").write_text("format = 2\n")
    assert run("--mutate", "--jobs", "1", tiny / "shots").exit_code == 2
