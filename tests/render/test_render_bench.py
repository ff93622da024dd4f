"""The renderers' speed table: its window's side measures, and what is missing is said."""

import argparse
import json
import os
import subprocess
import sys

from tools.bench import display, render
from tools.bench.table_scene import TableScene


def test_the_windows_side_measures_every_size():
    command = [sys.executable, "-m", "tools.bench.window_side", "--frames", "2", "--only", "wire"]
    env = {**os.environ, "SDL_VIDEODRIVER": "dummy"}
    done = subprocess.run(command, env=env, capture_output=True, text=True, check=True)
    rows = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    assert [(row["size"], row["resting"]) for row in rows] == [
        ([1280, 720], False),
        ([1280, 720], True),
        ([1920, 1080], False),
        ([1920, 1080], True),
    ]
    assert all(len(row["loop"]) == 2 and min(row["loop"]) > 0.0 for row in rows)


def test_without_a_display_the_table_says_what_to_install(monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.setattr(display.shutil, "which", lambda _name: None)
    asked = argparse.Namespace(frames=2, only="window")
    (row,) = render.rows(asked)
    assert "install Xvfb" in row["work"]


def test_a_row_says_what_is_missing_for_llvmpipe(monkeypatch):
    monkeypatch.setattr(render, "_ask", lambda *_: iter([{"missing": "no moderngl"}]))
    (row,) = render._pipe_rows({})
    assert row["work"] == "llvmpipe: not installed: no moderngl"


def test_a_row_of_the_window_tells_its_goal_and_whether_it_is_met(monkeypatch):
    found = {"renderer": "painter", "size": [1280, 720], "resting": False}
    times = {"loop": [4.0, 4.1, 9.0], "draw": [3.0, 3.0, 3.0]}
    monkeypatch.setattr(render, "_ask", lambda *_: iter([{**found, **times}]))
    (row,) = render._window_rows(":0", 3)
    assert (row["median_ms"], row["draw_ms"], row["fps"]) == (4.1, 3.0, 244)
    assert (row["goal"], row["met"]) == (">= 240", True)


def test_the_scene_has_the_triangles_it_is_said_to_have():
    table = TableScene()
    assert 30_000 < table.triangles() < 45_000
    assert table.camera(3, resting=True) == table.camera(9, resting=True)
    assert table.camera(3, resting=False) != table.camera(9, resting=False)
