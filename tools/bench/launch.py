"""From starting the game to its first picture: the first launch of all, and later ones.

One idea: the real window is opened in a process with its own folder for compiled kernels,
empty the first time; beside it a process that imports numpy, numba and pygame and calls one cached
empty kernel. Invariant: what a launch took is told by the process itself, by the clock that all
processes share, when its first picture of a table has been brought to the screen.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from time import monotonic

ROOT = Path(__file__).resolve().parents[2]
REPEATS = 5
GAME = """
import os, sys
from time import monotonic
from engine.app.play import play
seen = []
def each(loop):
    if loop.startup.playable:
        seen.append(loop.frames)
    ready = len(loop.startup.renderers)
    if len(seen) == 2:
        print(monotonic(), flush=True)
    if len(seen) > 1 and ready >= int(sys.argv[1]):
        print(monotonic(), flush=True)
        os._exit(0)
play("snooker", size=(1280, 720), rate=1000, seed=1, journal=sys.argv[2], each=each)
"""
EMPTY = """
import numpy as np
import pygame
from numba import njit
from time import monotonic
@njit(cache=True)
def empty(row):
    return 0
empty(np.zeros(1))
print(monotonic(), flush=True)
"""


@dataclass(frozen=True, slots=True)
class Launches:
    """Seconds: the first launch until one can play, and until all renderers are there; later ones.

    `later` and `empty` are medians, of the game and of the process that does nothing.
    """

    first: float
    first_all: float
    later: float
    empty: float


def measure_launches(display: str, repeats: int = REPEATS) -> Launches:
    """Start the game and the empty process on a display and return what they took."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in {"game": GAME, "empty": EMPTY}.items():
            Path(folder, f"{name}.py").write_text(text, encoding="utf-8")
        first, first_all = _start(folder, "game", display, renderers=3)
        _start(folder, "empty", display)
        _start(folder, "game", display, renderers=3)
        later, empty = [], []
        for _ in range(repeats):  # turn and turn about, since the machine's speed drifts
            later.append(_start(folder, "game", display)[0])
            empty.append(_start(folder, "empty", display)[0])
    return Launches(first, first_all, median(later), median(empty))


def _start(folder: str, name: str, display: str, renderers: int = 1) -> list[float]:
    """Return the seconds from a program's start to each time that it tells.

    The game ends when so many `renderers` are ready.
    """
    env = {
        **os.environ,
        "DISPLAY": display,
        "NUMBA_CACHE_DIR": str(Path(folder, "kernels")),
        "PYTHONPATH": str(ROOT),
        "PYGAME_HIDE_SUPPORT_PROMPT": "hide",
        "SDL_AUDIODRIVER": "dummy",
        "XDG_DATA_HOME": folder,
        "XDG_CONFIG_HOME": folder,
    }
    journal = str(Path(folder, "journal.toml"))
    began = monotonic()
    done = subprocess.run(
        [sys.executable, str(Path(folder, f"{name}.py")), str(renderers), journal],
        env=env,
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode or not done.stdout.strip():
        raise RuntimeError(f"the launch failed: {done.stderr.strip()[-500:]}")
    return [float(line) - began for line in done.stdout.splitlines()]


__all__ = ["Launches", "measure_launches"]
