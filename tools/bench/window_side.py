"""The window's side of the renderers' speed table: a process with a real window.

One idea: a frame is timed from its start to the next one's, with all that the window's loop does
for a picture: events read, scene made, drawn into the window's memory, brought to the screen.
It prints a JSON line for every measurement; `python -m tools.bench render` reads them.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from time import perf_counter
from typing import TYPE_CHECKING

from tools.bench.table_scene import SIZES, TableScene

if TYPE_CHECKING:
    from engine.app.window import Window
    from engine.render.renderer import Renderer

LEAD = 12
"""Frames that are not timed."""


def main() -> int:
    """Measure every renderer at every size."""
    parser = argparse.ArgumentParser(prog="python -m tools.bench.window_side", description=__doc__)
    parser.add_argument("--frames", type=int, default=240)
    parser.add_argument("--only", default="", help="one renderer's name")
    asked = parser.parse_args()
    os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "hide")
    from engine.app.window import close_window, open_window  # noqa: PLC0415  pygame is slow
    from engine.render.renderer import RENDERERS, make_renderer  # noqa: PLC0415

    table = TableScene()
    names = [name for name in RENDERERS if name.startswith(asked.only)]
    renderers = {name: make_renderer(name) for name in names}
    for renderer in renderers.values():
        renderer.warm_up(None)
    for size in SIZES:
        window = open_window(size, "speed")
        for name, renderer in renderers.items():
            for resting in (False, True):
                found = _measure(window, renderer, table, asked.frames, resting=resting)
                loop, draw, work = found
                told = {"renderer": name, "size": size, "resting": resting}
                print(json.dumps({**told, "loop": loop, "draw": draw, "work": work}), flush=True)
        close_window()
    return 0


def _measure(
    window: Window, renderer: Renderer, table: TableScene, frames: int, *, resting: bool
) -> tuple[list[float], list[float], float]:
    """Return the ms of each loop and of drawing alone, and processor ms a frame on the mean."""
    loops, draws, busy = [], [], 0.0
    box = (0, 0, *window.size)
    before = perf_counter()
    for frame in range(frames + LEAD):
        if frame == LEAD:
            busy = _processor()
        window.read()
        scene = table.at(frame, resting=resting)
        start = perf_counter()
        renderer.render(scene, window.part(box))
        draws.append(1000.0 * (perf_counter() - start))
        window.show()
        now = perf_counter()
        loops.append(1000.0 * (now - before))
        before = now
    return loops[LEAD:], draws[LEAD:], 1000.0 * (_processor() - busy) / frames


def _processor() -> float:
    spent = os.times()
    return spent.user + spent.system


if __name__ == "__main__":
    sys.exit(main())
