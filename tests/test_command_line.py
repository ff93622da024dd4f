"""The command line: answers, exit statuses, and errors that show a way out."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from engine.__main__ import main
from rulelang.parse import GRAMMAR
from rulelang.tables import kept_tables

ROOT = Path(__file__).resolve().parent.parent
GOLDEN = ROOT / "tests" / "golden"


def run(*words):
    return CliRunner().invoke(main, [str(word) for word in words])


@pytest.mark.parametrize("command", ["", *main.commands])
def test_help(command):
    answer = run(*[command] if command else [], "--help")
    assert answer.exit_code == 0
    assert "Usage" in answer.output


def test_list_names_every_variant_file():
    names = [line.split()[0] for line in run("list").output.splitlines()]
    assert names == sorted(path.stem for path in (ROOT / "variants").glob("*.toml"))
    assert [row["name"] for row in json.loads(run("list", "--json").output)] == names


def test_check_finds_no_mistake_in_what_ships():
    answer = run("check")
    assert answer.exit_code == 0
    assert "no mistakes" in answer.output


def test_check_tells_an_unknown_game():
    answer = run("check", "snoker")
    assert answer.exit_code == 2
    assert "snooker" in answer.output


def test_golden_passes():
    answer = run("golden", GOLDEN)
    assert answer.exit_code == 0
    assert " 0 differ, 0 unusable" in answer.output


def test_golden_as_json_is_one_list(tmp_path):
    good = next((GOLDEN / "snooker").glob("*.toml"))
    wrong = tmp_path / "wrong.toml"
    text = (GOLDEN / "snooker" / "sn-03-one-red-potted.toml").read_text(encoding="utf-8")
    wrong.write_text(text.replace("points = [1, 0]", "points = [2, 0]"), encoding="utf-8")
    broken = tmp_path / "broken.toml"
    broken.write_text("format = 1\n", encoding="utf-8")
    answer = run("golden", "--json", good, wrong)
    assert answer.exit_code == 1
    rows = json.loads(answer.output)
    assert [row["passed"] for row in rows] == [True, False]
    assert rows[1]["differences"] == [
        {"shot": 1, "key": "points", "expected": [2, 0], "got": [1, 0]}
    ]
    answer = run("golden", "--json", broken, wrong, tmp_path / "nowhere")
    assert answer.exit_code == 2
    rows = json.loads(answer.output)
    assert [row["passed"] for row in rows] == [False, False, False]
    assert ["error" in row for row in rows] == [True, False, True]


def test_golden_update_rewrites_and_keeps_comments(tmp_path):
    path = tmp_path / "record.toml"
    text = (GOLDEN / "snooker" / "sn-03-one-red-potted.toml").read_text(encoding="utf-8")
    path.write_text(
        "# why\n" + text.replace("points = [1, 0]", "points = [2, 0]"), encoding="utf-8"
    )
    assert run("golden", "--update", path).exit_code == 0
    assert path.read_text(encoding="utf-8") == "# why\n" + text


def test_explain_names_rule_section_and_reason():
    path = GOLDEN / "snooker" / "sn-54-several-fouls-only-dearest-counts.toml"
    answer = run("explain", path)
    assert answer.exit_code == 0
    assert "Ball not on struck first" in answer.output
    assert "S3 R11(b)" in answer.output
    told = json.loads(run("explain", "--json", path).output)
    assert {rule["outcome"] for rule in told["shots"][0]["rules"]} >= {"fired", "silent"}


def test_simulate_keeps_a_record_that_passes(tmp_path):
    path = tmp_path / "break.toml"
    answer = run("simulate", "eight_ball", "--speed", "6", "--record", path)
    assert answer.exit_code == 0
    assert "cue hits" in answer.output
    assert run("golden", path).exit_code == 0


def test_simulate_refuses_what_cannot_be_played():
    assert run("simulate", "eight_ball", "--speed", "-1").exit_code == 2
    assert "Traceback" not in run("simulate", "eight_ball", "--speed", "nan").output
    assert "at most 100 m/s" in run("simulate", "eight_ball", "--speed", "1e308").output
    answer = run("simulate", "eight_ball", "--speed", "1", "--place", "60", "0")
    assert answer.exit_code == 2
    assert "not on the bed" in answer.output


def test_render_draws_without_a_window(tmp_path):
    path = tmp_path / "table.png"
    answer = run("render", "snooker", "--renderer", "wireframe", "--size", "320x200", "-o", path)
    assert answer.exit_code == 0
    assert path.read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("words", "heavy"),
    [
        (("--help",), {"numba", "pygame", "numpy", "pydantic", "lark"}),
        (("list",), {"numba", "pygame", "numpy", "pydantic", "lark"}),
        (("check", "snooker"), {"numba", "pygame", "numpy", "pydantic", "lark", "tomlkit", "PIL"}),
        (("golden", str(GOLDEN / "eight_ball")), {"numba", "pygame"}),
    ],
)
def test_commands_that_move_no_ball_stay_light(words, heavy, tmp_path):
    code = (
        "import sys\nfrom engine.__main__ import main\n"
        f"try:\n    main({list(words)!r})\nexcept SystemExit as end:\n    assert not end.code\n"
        f"print(sorted(set(sys.modules) & {heavy!r}))"
    )
    around = {**os.environ, "XDG_CACHE_HOME": str(tmp_path)}
    kept_tables(GRAMMAR, tmp_path / "headstring")
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        cwd=ROOT,
        check=True,
        env=around,
    )
    assert done.stdout.splitlines()[-1] == "[]"
