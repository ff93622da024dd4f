"""How fast the renderers are, with everything that a window's loop does for a picture.

One idea: 22 balls on a twelve-foot table are drawn in a real window, on a virtual X display where
there is no screen, and a frame is timed from its start to the next one's, bringing it to the screen
included. Beside it stands drawing alone, here and by OpenGL on the processor (llvmpipe) where that
is installed; then how long a launch takes. The goals of each row are in `goal`.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from typing import TYPE_CHECKING, Any

import numpy as np

from tools.bench.display import NoDisplayError, display
from tools.bench.launch import measure_launches

if TYPE_CHECKING:
    import argparse
    from collections.abc import Iterator

Row = dict[str, object]
MOVING_GOALS = {
    ("wireframe", 720): 300,
    ("wireframe", 1080): 200,
    ("painter", 720): 240,
    ("painter", 1080): 160,
    ("scanline", 720): 160,
    ("scanline", 1080): 90,
}
RESTING_GOALS = {720: 500, 1080: 300}
"""Frames a second."""
LATER_GOAL = 0.6
"""Seconds that a later launch may take more than a process that does nothing."""


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add this table's options."""
    parser.add_argument("--frames", type=int, default=240, help="frames a measurement")
    parser.add_argument("--only", choices=["window", "llvmpipe", "launch"], help="one part")


def rows(asked: argparse.Namespace) -> Iterator[Row]:
    """Yield the rows of the window, of llvmpipe and of the launches."""
    drawn: dict[int, float] = {}
    try:
        with display() as (name, _whose):
            if asked.only in (None, "window"):
                for row in _window_rows(name, asked.frames):
                    if row["work"] == "scanline, camera moves":
                        drawn[int(str(row["size"]).split("x")[1])] = float(str(row["draw_ms"]))
                    yield row
            if asked.only in (None, "llvmpipe"):
                yield from _pipe_rows(drawn)
            if asked.only in (None, "launch"):
                yield from _launch_rows(name)
    except NoDisplayError as trouble:
        yield _row(f"{trouble}")


def _row(work: str, **given: object) -> Row:
    blank: Row = dict.fromkeys(("size", "median_ms", "p95_ms", "draw_ms", "fps", "goal", "met"), "")
    return {"work": work, **blank, **given}


def _window_rows(name: str, frames: int) -> Iterator[Row]:
    command = ["-m", "tools.bench.window_side", "--frames", str(frames)]
    for found in _ask(command, {"DISPLAY": name}):
        wide, tall = found["size"]
        resting, renderer = found["resting"], found["renderer"]
        goal = RESTING_GOALS[tall] if resting else MOVING_GOALS[renderer, tall]
        middle = float(np.median(found["loop"]))
        yield _row(
            f"{renderer}, camera {'rests' if resting else 'moves'}",
            size=f"{wide}x{tall}",
            median_ms=round(middle, 2),
            p95_ms=round(float(np.percentile(found["loop"], 95)), 2),
            draw_ms=round(float(np.median(found["draw"])), 2),
            fps=round(1000.0 / middle),
            goal=f">= {goal}",
            met=1000.0 / middle >= goal,
        )


def _pipe_rows(drawn: dict[int, float]) -> Iterator[Row]:
    """Yield what llvmpipe takes to draw the scene; the goal is that ours takes less."""
    for found in _ask(["-m", "tools.bench.pipe_side"], {}):
        if "missing" in found:
            yield _row(f"llvmpipe: not installed: {found['missing']}")
            continue
        wide, tall = found["size"]
        middle = float(np.median(found["draw"]))
        yield _row(
            str(found["name"]),
            size=f"{wide}x{tall}",
            draw_ms=round(middle, 2),
            fps=round(1000.0 / middle),
            goal="slower",
            met=middle > drawn[tall] if tall in drawn else "",
        )


def _launch_rows(name: str) -> Iterator[Row]:
    """Yield seconds from starting the game to its first picture, as `median_ms`."""
    found = measure_launches(name)
    more = found.later - found.empty
    yield _row("first launch, until playable", median_ms=round(1000.0 * found.first))
    yield _row("first launch, all renderers ready", median_ms=round(1000.0 * found.first_all))
    yield _row("numpy, numba, pygame, an empty kernel", median_ms=round(1000.0 * found.empty))
    yield _row(
        "second launch, above that",
        median_ms=round(1000.0 * more),
        goal=f"<= {1000.0 * LATER_GOAL:.0f}",
        met=more <= LATER_GOAL,
    )


def _ask(command: list[str], env: dict[str, str]) -> Iterator[dict[str, Any]]:
    """Yield the JSON lines of a process as they come; raises RuntimeError where it fails."""
    process = subprocess.Popen(
        [sys.executable, *command],
        env={**os.environ, **env},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    for line in process.stdout or ():
        if line.startswith("{"):
            yield json.loads(line)
    _, told = process.communicate()
    if process.returncode:
        raise RuntimeError(told.strip()[-500:])
