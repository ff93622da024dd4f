"""pytest collects shot records where it is told to, and only there."""

from importlib.metadata import entry_points
from pathlib import Path

import pytest

pytest_plugins = "pytester"

KNOWN = any(one.name == "headstring" for one in entry_points(group="pytest11"))
PLUGIN = ("-p", "headstring" if KNOWN else "engine.proving.pytest_plugin")
ALONE = ("-p", "no:randomly", "-p", "no:xdist", "-p", "no:cacheprovider")
RECORD = """\
format = 1
variant = "nine_ball"
title = "A dry shot"

[before]
phase = "open"
on_table = ["cue", "3", "9"]

[[shot]]
events = ["cue hits 3", "3 hits cushion foot"]

[shot.expect]
next = 2
"""


@pytest.fixture
def records(pytester, monkeypatch):
    monkeypatch.setenv("PYTHONPATH", str(Path(__file__).resolve().parents[2]))
    folder = pytester.mkdir("records")
    (folder / "dry.toml").write_text(RECORD)
    (pytester.path / "other.toml").write_text("[tool]\nname = 1\n")
    return folder


@pytest.mark.usefixtures("records")
def test_a_record_is_a_test(pytester):
    done = pytester.runpytest_subprocess(*PLUGIN, *ALONE, "--shot-records", "records", "-v")
    done.assert_outcomes(passed=1)
    done.stdout.fnmatch_lines(["*dry.toml::dry PASSED*"])


@pytest.mark.usefixtures("records")
def test_the_setting_does_what_the_option_does(pytester):
    pytester.makeini("[pytest]\nshot_records = records\n")
    pytester.runpytest_subprocess(*PLUGIN, *ALONE).assert_outcomes(passed=1)


@pytest.mark.usefixtures("records")
def test_nothing_is_collected_unasked(pytester):
    pytester.runpytest_subprocess(*PLUGIN, *ALONE).assert_outcomes(passed=0)


def test_what_differs_is_told(pytester, records):
    (records / "wrong.toml").write_text(RECORD.replace("next = 2", "next = 1"))
    done = pytester.runpytest_subprocess(*PLUGIN, *ALONE, "--shot-records", "records")
    done.assert_outcomes(passed=1, failed=1)
    done.stdout.fnmatch_lines(["*shot 1: next: expected 1, got 2*"])
    done.stdout.no_fnmatch_line("*Traceback*")


def test_a_file_that_is_no_record_fails_with_its_mistakes(pytester, records):
    (records / "wrong.toml").write_text(RECORD.replace("cue hits 3", "cue meets 3"))
    done = pytester.runpytest_subprocess(*PLUGIN, *ALONE, "--shot-records", "records/wrong.toml")
    done.assert_outcomes(failed=1)
    done.stdout.fnmatch_lines(["*wrong.toml:10:*T316*"])
