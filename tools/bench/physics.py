"""How fast strokes are simulated: opening breaks and small shots, medians and the slowest.

One idea: the work is strokes of the shipped games, each a little turned so that none is special;
`times_small` is the median over that of the smallest row, a ratio that a slow machine keeps.
"""

from __future__ import annotations

from dataclasses import replace
from time import perf_counter
from typing import TYPE_CHECKING

import numpy as np

from engine.game.placing import opening_layout
from engine.physics.simulate import simulate, warm_up
from engine.physics.world import Strike
from engine.variant.load import load_variant

if TYPE_CHECKING:
    from collections.abc import Iterator

    from engine.physics.trace import Trace
    from engine.physics.world import Layout
    from engine.variant.variant import Variant

SHOTS = 60
GAPS = 5.7e-5
"""Balls of a loosened rack stand up to this far (m) from each other."""


def rows() -> Iterator[dict[str, object]]:
    """Yield a row for each kind of work; times in ms a stroke."""
    warm_up()
    pool, red, carom = map(load_variant, ("eight_ball", "snooker", "three_cushion"))
    loose = _loosened(pool, opening_layout(pool))
    work = (
        ("three-ball stroke, 4 m/s", carom, opening_layout(carom), 4.0),
        ("break of 15, 8 m/s, small gaps", pool, loose, 8.0),
        ("break of 15, 8 m/s, frozen rack", pool, opening_layout(pool), 8.0),
        ("break of 21, 4 m/s", red, opening_layout(red), 4.0),
    )
    smallest = None
    for name, variant, layout, speed in work:
        times, traces = _measure(variant, layout, speed)
        median = float(np.median(times))
        smallest = smallest or median
        yield _row(name, times, traces, median / smallest)
    yield _sampling(traces[-1], smallest or 1.0)


def _loosened(variant: Variant, layout: Layout) -> Layout:
    chance = np.random.default_rng(2012)
    apex = min(x for ball, (x, _) in layout.items() if ball not in variant.cue_balls)
    spread = 1.0 + GAPS / (2.0 * max(one.radius for one in variant.world.balls))
    jitter = {ball: chance.uniform(-GAPS / 4, GAPS / 4, 2) for ball in layout}
    return {
        ball: (x, y)
        if ball in variant.cue_balls
        else (
            apex + (x - apex) * spread + float(jitter[ball][0]),
            y * spread + float(jitter[ball][1]),
        )
        for ball, (x, y) in layout.items()
    }


def _measure(variant: Variant, layout: Layout, speed: float) -> tuple[list[float], list[Trace]]:
    ball = variant.cue_balls[0]
    strike = Strike(speed, 0.0)
    times, traces = [], []
    for number in range(SHOTS + 5):
        turned = replace(strike, heading=0.004 + 0.0003 * number)
        start = perf_counter()
        traces.append(simulate(variant.world, layout, ball, turned))
        times.append((perf_counter() - start) * 1000.0)
    return times[5:], traces[5:]


def _row(name: str, times: list[float], traces: list[Trace], ratio: float) -> dict[str, object]:
    events = float(np.median([len(trace.events()) for trace in traces]))
    median = float(np.median(times))
    return {
        "work": name,
        "median_ms": round(median, 3),
        "p95_ms": round(float(np.percentile(times, 95)), 3),
        "slowest_ms": round(max(times), 3),
        "events": round(events),
        "us_event": round(median * 1000.0 / max(events, 1.0), 2),
        "times_small": round(ratio, 1),
    }


def _sampling(trace: Trace, smallest: float) -> dict[str, object]:
    times = []
    frames = np.arange(0.0, trace.duration, 1 / 60)
    for _ in range(20):
        start = perf_counter()
        trace.positions(frames)
        times.append((perf_counter() - start) * 1000.0)
    median = float(np.median(times))
    return {
        "work": f"positions at 60 frames a second, {len(frames)} frames",
        "median_ms": round(median, 3),
        "p95_ms": round(float(np.percentile(times, 95)), 3),
        "slowest_ms": round(max(times), 3),
        "events": 0,
        "us_event": 0.0,
        "times_small": round(median / smallest, 1),
    }
