"""How fast shots are simulated, beside the goals and, on request, beside the open peer.

One idea: what is timed is `simulate` as a user calls it, from layout and strike to a trace, in
processor time of one thread; `times_small` is the median over that of the two-ball stroke, a ratio
that a slow machine keeps. Invariant: all rows of a table, the peer's too, are from one run.
"""

from __future__ import annotations

from time import perf_counter, thread_time
from typing import TYPE_CHECKING

import numpy as np

from engine.physics.batch import simulate_batch
from engine.physics.simulate import simulate, warm_up
from tools.bench.peer import PeerMissingError, ask_peer, first_shot
from tools.bench.process import measure_starts
from tools.bench.shots import Work, breaks, crowds, few, random_breaks

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable, Iterator

    from engine.physics.trace import Trace
    from tools.bench.peer import Played
    from tools.bench.process import Spent

SHOTS = 60
PEER_SHOTS = 9
BATCHES = 5
AGAIN = 20
"""The slowest of many are timed again, since one time in many is the machine's and not ours."""

Row = dict[str, object]


def add_options(parser: argparse.ArgumentParser) -> None:
    """Name the options of this table."""
    parser.add_argument("--peer-python", metavar="PATH", help="an interpreter that has pooltool")
    parser.add_argument("--breaks", type=int, default=0, metavar="N", help="of N random breaks")
    parser.add_argument("--batch", type=int, default=0, metavar="N", help="N shots on 1, 2 workers")
    parser.add_argument("--no-starts", action="store_true", help="start no processes")


def rows(chosen: argparse.Namespace) -> Iterator[Row]:
    """Yield a row for each kind of work; times in ms a shot, of the processor."""
    small, *others = (*few(SHOTS), *breaks(SHOTS), *crowds(SHOTS))
    works = [small, *others]
    peer, played = ("", {}) if not chosen.peer_python else _asked(chosen.peer_python, works)
    warm_up()
    smallest, broken = 0.0, None
    for work in works:
        times, traces = measure(work)
        smallest = smallest or float(np.median(times))
        yield _row(work, times, _events(traces), smallest, played.get(work.name))
        broken = traces[0] if "8-ball" in work.name else broken
    if broken is not None:
        yield _sampling(broken, smallest)
    if chosen.breaks:
        yield _slowest(random_breaks(chosen.breaks), smallest)
    if chosen.batch:
        yield from _batch(random_breaks(chosen.batch))
    if not chosen.no_starts:
        yield from _starts(chosen.peer_python, next(one for one in works if "8-ball" in one.name))
    if peer:
        yield _blank(f"(peer: {peer})")


def _asked(python: str, works: list[Work]) -> tuple[str, dict[str, Played]]:
    try:
        return ask_peer(python, works, PEER_SHOTS)
    except PeerMissingError as missing:
        raise SystemExit(f"no peer: {missing}") from None


def measure(work: Work, repeats: int = 3) -> tuple[list[float], list[Trace]]:
    """Return the time of each shot (ms, the least of some repeats) and its trace."""
    times, traces = [], []
    for layout, strike in work.shots:
        best = np.inf
        for _ in range(repeats):
            start = thread_time()
            trace = simulate(work.world, layout, work.ball, strike)
            best = min(best, thread_time() - start)
        times.append(float(best) * 1000.0)
        traces.append(trace)
    return times, traces


def _events(traces: list[Trace]) -> list[int]:
    return [len(trace.events()) for trace in traces]


def _blank(name: str) -> Row:
    columns = "median_ms p95_ms slowest_ms events us_event times_small goal met"
    columns += " peer_ms peer_events peer_times"
    return {"work": name, **dict.fromkeys(columns.split(), "")}


def _row(
    work: Work, times: list[float], events: list[int], smallest: float, peer: Played | None
) -> Row:
    middle = float(np.median(times))
    each = 1000.0 * sum(times) / max(sum(events), 1)
    row = _blank(work.name) | _spread(times, smallest)
    row |= {"events": round(float(np.median(events))), "us_event": round(each, 2)}
    if work.goal is not None:
        row |= _goal(middle, work.goal, "ms")
    elif "16 balls" in work.name:
        row |= _goal(each, 4.0, "us/ev")
    if peer is not None and peer.error:
        row["peer_ms"] = peer.error
    elif peer is not None:
        theirs = float(np.median(peer.times))
        row |= {"peer_ms": round(theirs, 2), "peer_times": round(theirs / middle)}
        row["peer_events"] = round(float(np.median(peer.events)))
    return row


def _spread(times: list[float], smallest: float) -> Row:
    middle = float(np.median(times))
    return {
        "median_ms": round(middle, 4),
        "p95_ms": round(float(np.percentile(times, 95)), 4),
        "slowest_ms": round(max(times), 3),
        "times_small": round(middle / smallest, 1),
    }


def _goal(value: float, goal: float, unit: str) -> Row:
    return {"goal": f"<= {goal:g} {unit}", "met": "yes" if value <= goal else "no"}


def _sampling(trace: Trace, smallest: float) -> Row:
    """Return the row of all balls' places 60 times a second for a whole shot."""
    times, frames = [], np.arange(0.0, trace.duration, 1 / 60)
    for _ in range(SHOTS):
        start = thread_time()
        trace.positions(frames)
        times.append((thread_time() - start) * 1000.0)
    name = f"positions at 60 frames a second, {len(frames)} frames"
    return _blank(name) | _spread(times, smallest) | _goal(float(np.median(times)), 1.0, "ms")


def _slowest(work: Work, smallest: float) -> Row:
    """Return the row of many random breaks; the slowest are timed again, more carefully."""
    times, events = [], []
    for layout, strike in work.shots:
        start = thread_time()
        trace = simulate(work.world, layout, work.ball, strike)
        times.append((thread_time() - start) * 1000.0)
        events.append(len(trace.log))
    late = np.argsort(times)[-AGAIN:]
    again = Work(work.name, work.world, work.ball, tuple(work.shots[k] for k in late))
    for k, time in zip(late, measure(again, 7)[0], strict=True):
        times[k] = min(times[k], time)
    row = _blank(f"slowest of {len(times)} random breaks") | _spread(times, smallest)
    each = 1000.0 * sum(times) / max(sum(events), 1)
    row |= {"events": max(events), "us_event": round(each, 2)}
    far = float(np.percentile(times, 99)), float(np.percentile(times, 99.9))
    row["work"] = f"{row['work']} (99%: {far[0]:.2f}, 99.9%: {far[1]:.2f})"
    return row | _goal(max(times), work.goal or 10.0, "ms")


def _batch(work: Work) -> Iterator[Row]:
    """Yield the rows of a batch on one worker and on two, by the clock; a busy machine shows."""
    shots = [(layout, work.ball, strike) for layout, strike in work.shots]
    ways: dict[str, tuple[int, Callable[[Trace], int] | None]] = {
        "1 worker": (1, _count),
        "2 workers, traces kept there": (2, _count),
        "2 workers, traces sent back": (2, None),
    }
    spent: dict[str, list[float]] = {name: [] for name in ways}
    simulate_batch(work.world, shots[:8], 2, _count)
    for _ in range(BATCHES):
        for name, (workers, keep) in ways.items():
            start = perf_counter()
            if keep is None:
                simulate_batch(work.world, shots, workers)
            else:
                simulate_batch(work.world, shots, workers, keep)
            spent[name].append(perf_counter() - start)
    one = min(spent["1 worker"])
    for name, (workers, keep) in ways.items():
        row = _blank(f"batch of {len(shots)} breaks, {name}, by the clock")
        row["median_ms"] = round(1000.0 * min(spent[name]) / len(shots), 4)
        times = one / min(spent[name])
        if workers > 1:
            row["times_small"] = f"{times:.2f} x"
        if workers > 1 and keep is not None:
            row |= {"goal": ">= 1.9 x", "met": "yes" if times >= 1.9 else "no"}
        yield row


def _count(trace: Trace) -> int:
    return len(trace.log)


def _starts(peer: str | None, work: Work) -> Iterator[Row]:
    """Yield the rows of processes: the first on a machine, later ones, and what they hold."""
    told = measure_starts()
    theirs = first_shot(peer, work) if peer else None
    row = _blank("first shot of all, start to result, compiling, by the clock")
    row["median_ms"] = round(1000.0 * told.first.clock)
    yield row | _goal(told.first.clock, 8.0, "s") | _beside(theirs, 0, told.first)
    row = _blank("an empty cached kernel, start to result")
    yield row | {"median_ms": round(1000.0 * told.empty.processor)}
    row = _blank("a later process, start to result")
    row["median_ms"] = round(1000.0 * told.later.processor)
    more = told.later.processor - told.empty.processor
    yield row | _goal(more, 0.3, "s more") | _beside(theirs, 1, told.later)
    row = _blank("the same with a variant and its rules loaded")
    yield row | {"median_ms": round(1000.0 * told.game.processor)}
    more = told.later.memory - told.empty.memory
    row = _blank(f"memory: {told.later.memory:.0f} MB, an empty kernel {told.empty.memory:.0f} MB")
    yield row | _goal(more, 60.0, "MB more") | {"times_small": f"{more:.0f} MB more"}


def _beside(theirs: tuple[float, float] | None, turn: int, ours: Spent) -> Row:
    """Return the peer's seconds by the clock, and how often they hold ours."""
    if theirs is None:
        return {}
    times = round(theirs[turn] / ours.clock, 1)
    return {"peer_ms": round(1000.0 * theirs[turn]), "peer_times": times}


__all__ = ["add_options", "measure", "rows"]
