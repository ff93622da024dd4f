"""What a process costs from its start to a shot's result: the first on a machine, and later ones.

One idea: small programs that a user might write are started anew, beside one that imports
numpy and numba and calls one cached empty kernel; time is processor time of the whole process,
which other work on the machine disturbs least, and memory its greatest. Invariant: compiled code
is kept in a folder of its own, so the first really is the first.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from time import perf_counter

ROOT = Path(__file__).resolve().parents[2]
REPEATS = 7
PHYSICS = """
from math import radians
from engine.physics.simulate import simulate
from engine.physics.world import Ball, Cloth, Contact, Cue, Models, Rubber, Strike, World
from engine.table.build import PocketCut, build_table
corner = PocketCut(0.1159, radians(142), 0.04, 0.003, 0.062)
side = PocketCut(0.1286, radians(104), 0.005, 0.003, 0.0645)
radius, pitch = 0.028575, 0.028605
world = World(
    table=build_table(2.54, 1.27, 0.0363, corner, side, 0.12),
    balls=tuple(Ball(str(number), radius, 0.17) for number in range(16)),
    cloth=Cloth(0.2, 0.01, 10.0),
    contact=Contact(0.95, 0.009951, 0.108, 1.088),
    rubber=Rubber(0.97, 0.035, 1.0, 0.14),
    cue=Cue(0.54, 0.73, 0.6, 25.0),
    models=Models(ball_cushion="mathavan-2010"),
)
places = [(row, row - 2 * k) for row in range(5) for k in range(row + 1)]
layout = {str(n + 1): (0.6 + 3**0.5 * pitch * x, pitch * y) for n, (x, y) in enumerate(places)}
simulate(world, {"0": (-0.6, 0.0), **layout}, "0", Strike(8.0, 0.004)).final
"""
GAME = """
from engine.game.placing import opening_layout
from engine.physics.simulate import simulate
from engine.physics.world import Strike
from engine.variant.load import load_variant
variant = load_variant("eight_ball")
layout = opening_layout(variant)
simulate(variant.world, layout, variant.cue_balls[0], Strike(8.0, 0.004)).final
"""
EMPTY = """
import numpy as np
from numba import njit
@njit(cache=True)
def empty(row):
    return 0
empty(np.zeros(1))
"""
TELL = """
from pathlib import Path
status = Path("/proc/self/status")
told = status.read_text() if status.exists() else ""
print(next((line.split()[1] for line in told.splitlines() if line.startswith("VmHWM")), 0))
"""
"""A child's own greatest memory (kB); what the system tells its parent counts the parent's too."""


@dataclass(frozen=True, slots=True)
class Spent:
    """What a process took: seconds by the clock and of the processor, and memory in MB."""

    clock: float
    processor: float
    memory: float


@dataclass(frozen=True, slots=True)
class Starts:
    """A first shot with nothing compiled; medians of later ones, of a game's, of empty kernels."""

    first: Spent
    later: Spent
    game: Spent
    empty: Spent


def measure_starts() -> Starts:
    """Start the processes and return what they took."""
    with tempfile.TemporaryDirectory() as cache:
        programs = {"physics": PHYSICS, "game": GAME, "empty": EMPTY}
        paths = {name: Path(cache, f"start_{name}.py") for name in programs}
        for name, program in programs.items():
            paths[name].write_text(program + TELL, encoding="utf-8")
        first = _start(paths["physics"], cache)
        _start(paths["empty"], cache)
        spent: dict[str, list[Spent]] = {name: [] for name in programs}
        for _ in range(REPEATS):  # turn and turn about, since the machine's speed drifts
            for name, path in paths.items():
                spent[name].append(_start(path, cache))
    return Starts(first, *(_middle(spent[name]) for name in programs))


def _start(program: Path, cache: str) -> Spent:
    env = {**os.environ, "NUMBA_CACHE_DIR": cache, "PYTHONPATH": str(ROOT)}
    start, before = perf_counter(), _children()
    command = [sys.executable, str(program)]
    done = subprocess.run(command, env=env, capture_output=True, text=True, check=True)
    return Spent(perf_counter() - start, _children() - before, int(done.stdout) / 1000.0)


def _children() -> float:
    """Return the processor time (s) of all processes started here that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def _middle(spent: list[Spent]) -> Spent:
    return Spent(
        median(one.clock for one in spent),
        median(one.processor for one in spent),
        median(one.memory for one in spent),
    )


__all__ = ["Spent", "Starts", "measure_starts"]
