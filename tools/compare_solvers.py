"""The three solvers on the same shots: how far they stray, what energy they invent, what they cost.

One idea: motion, impacts and shots are the same for all, so every difference from `stepwise` is
the solver's own. Run `python -m tools.compare_solvers`; it prints the table that stands in
docs/physics.md.
"""

from __future__ import annotations

import random
import sys
from dataclasses import dataclass, replace
from math import inf, radians, sqrt
from statistics import mean, median
from time import thread_time
from typing import TYPE_CHECKING

import numpy as np

from engine.physics.events import BallLeftTable
from engine.physics.simulate import Simulation
from engine.physics.world import Ball, Cloth, Contact, Cue, Models, Rubber, Strike, World
from engine.table.build import PocketCut, build_table
from engine.table.furniture import BallId

if TYPE_CHECKING:
    from collections.abc import Iterator

    from engine.physics.trace import Trace
    from engine.physics.world import Layout

RADIUS = 0.028575
RATES = (24, 60, 1000)
SHOTS = 40


@dataclass(frozen=True, slots=True)
class Shot:
    """One shot: where the balls lie and how the first is struck."""

    layout: Layout
    strike: Strike


@dataclass(frozen=True, slots=True)
class Outcome:
    """One solver's answer to one shot, beside the exact one."""

    early: float
    late: float
    invented: float
    escaped: int
    seconds: float


def make_world() -> World:
    """Return a table of 2.54 x 1.27 m with six pockets and sixteen balls."""
    table = build_table(
        2.54,
        1.27,
        0.0363,
        PocketCut(0.1159, radians(142), 0.04, 0.003, 0.062),
        PocketCut(0.1286, radians(104), 0.005, 0.003, 0.0645),
        0.12,
    )
    return World(
        table=table,
        balls=tuple(Ball(BallId(f"ball-{k}"), RADIUS, 0.17) for k in range(16)),
        cloth=Cloth(0.2, 0.01, 10.0),
        contact=Contact(0.95, 0.009951, 0.108, 1.088),
        rubber=Rubber(0.97, 0.035, 1.0, 0.14),
        cue=Cue(0.54, 0.73, 0.6, 25.0),
        models=Models(),
    )


def few_balls(count: int = 3) -> Iterator[Shot]:
    """Yield random shots among a few balls."""
    chance = random.Random(11)
    for _ in range(SHOTS):
        layout: dict[BallId, tuple[float, float]] = {}
        while len(layout) < count:
            x, y = chance.uniform(-1.1, 1.1), chance.uniform(-0.5, 0.5)
            if all((x - u) ** 2 + (y - v) ** 2 > 0.01 for u, v in layout.values()):
                layout[BallId(f"ball-{len(layout)}")] = (x, y)
        (x, y), (u, v) = list(layout.values())[:2]
        aim = float(np.arctan2(v - y, u - x)) + chance.uniform(-0.03, 0.03)
        yield Shot(layout, Strike(chance.uniform(0.5, 4.0), aim, 0.0, 0.1, 0.1))


def breaks() -> Iterator[Shot]:
    """Yield fast shots into a triangle of fifteen balls with gaps of 0.1 mm."""
    chance = random.Random(12)
    pitch = RADIUS + 5e-5
    places = [
        (0.635 + row * sqrt(3.0) * pitch, (row - 2 * k) * pitch)
        for row in range(5)
        for k in range(row + 1)
    ]
    for _ in range(SHOTS // 4):
        layout = {BallId("ball-0"): (-0.635, chance.uniform(-0.05, 0.05))}
        layout |= {BallId(f"ball-{k + 1}"): place for k, place in enumerate(places)}
        yield Shot(layout, Strike(chance.uniform(4.0, 6.0), chance.uniform(-0.02, 0.02)))


def solved_by(world: World, solver: str) -> World:
    """Return the world with another solver; kept by the caller, since it is packed but once."""
    return replace(world, models=replace(world.models, solver=solver))


def play(world: World, shot: Shot, rate: int) -> tuple[Trace, float]:
    """Return the trace and the seconds (of the processor) it took."""
    struck = next(iter(shot.layout))
    start = thread_time()
    simulation = Simulation(world, shot.layout, struck, shot.strike, step=1.0 / rate)
    simulation.advance(inf)
    return simulation.trace(), thread_time() - start


def judge(exact: Trace, trace: Trace, rate: int, seconds: float) -> Outcome:
    """Measure a trace against the exact one.

    `preemptive` moves the balls of one step at different times, so energy counts as invented only
    where it exceeds that just before and just after the last step.
    """
    times = np.arange(1, int(trace.duration * rate) + 1) / rate
    ending = trace.kinetic_energy(times - 1e-9)
    known = np.maximum(ending, trace.kinetic_energy(times))
    gains = ending[1:] - known[:-1]
    invented = float(gains[gains > 1e-12].sum()) if len(gains) else 0.0
    escaped = sum(isinstance(event, BallLeftTable) for event in trace.events())
    return Outcome(
        stray(exact, trace, 1.0),
        stray(exact, trace, max(exact.duration, trace.duration)),
        invented / float(exact.kinetic_energy([0.0])[0]),
        escaped,
        seconds,
    )


def stray(exact: Trace, trace: Trace, time: float) -> float:
    """Return the mean distance (m) of the balls from where they belong at `time`."""
    apart = exact.positions([time])[0, :, :2] - trace.positions([time])[0, :, :2]
    return float(np.hypot(apart[:, 0], apart[:, 1]).mean())


def compare(world: World, shots: list[Shot], solver: str, rate: int) -> list[Outcome]:
    """Play all shots with one solver at one rate."""
    exactly, tried = solved_by(world, "stepwise"), solved_by(world, solver)
    play(tried, shots[0], rate)
    outcomes = []
    for shot in shots:
        exact, _ = play(exactly, shot, rate)
        trace, seconds = play(tried, shot, rate)
        outcomes.append(judge(exact, trace, rate, seconds))
    return outcomes


def render(name: str, world: World, shots: list[Shot]) -> Iterator[str]:
    """Yield the lines of one markdown table."""
    yield f"{name} ({len(shots)} shots)"
    yield ""
    yield (
        "| solver | steps a second | off after 1 s, mean (mm) | off at the end, mean (mm) "
        "| energy invented, worst (%) | balls off the bed | cost, median (ms) |"
    )
    yield "|---|---|---|---|---|---|---|"
    runs = [("stepwise", RATES[-1])]
    runs += [(solver, rate) for solver in ("preemptive", "corrective") for rate in RATES]
    for solver, rate in runs:
        done = compare(world, shots, solver, rate)
        yield (
            f"| {solver} | {'any' if solver == 'stepwise' else rate} "
            f"| {1e3 * mean(o.early for o in done):.2f} "
            f"| {1e3 * mean(o.late for o in done):.2f} "
            f"| {100 * max(o.invented for o in done):.1f} "
            f"| {sum(o.escaped for o in done)} "
            f"| {1e3 * median(o.seconds for o in done):.2f} |"
        )
    yield ""


def main() -> int:
    """Print both tables."""
    world = make_world()
    for name, shots in (("Three balls", few_balls()), ("Breaks of 16 balls", breaks())):
        for line in render(name, world, list(shots)):
            print(line)
    return 0


if __name__ == "__main__":
    sys.exit(main())
