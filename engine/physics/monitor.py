"""The monitor: whether a shot's trace keeps the rules that hold for every shot.

One idea: the trace is read as it stands, at every event and between them, without asking the
solver: no ball in another or in a nose, no energy gained (height counts), momentum along the bed
kept where balls meet, all numbers finite, nobody gone without a pocket or a flight. Invariant:
reading changes nothing, and a finding is a figure, so that the worst of many shots can be told.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING

import numpy as np

from engine.physics import state
from engine.physics.pack import nose_reach, pack_noses

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray

    from engine.physics.trace import Trace
    from engine.table.furniture import Table

    Floats = NDArray[np.float64]

OVERLAP = 1e-9
"""How far (m) two balls, or a ball and a nose, may lie in each other."""

GAIN = 1e-12
"""How much energy (J) rounding may add from one moment to the next."""

MOMENTUM = 1e-12
"""By how much (kg m/s) rounding may change the momentum of balls that meet."""

FINEST = 2000
"""Into no more parts than this is the time between two events cut."""

MOMENTS = 512
"""So many moments are looked at together, which bounds the memory."""


@dataclass(frozen=True, slots=True)
class Findings:
    """What the monitor found in one shot, in SI units; all zero and finite is the best.

    `overlap` counts from how deep a pair lay at the start; `gap` is the smallest distance of two
    balls' surfaces, below zero in an overlap; `sunk` is how deep a ball lay in a nose; `gain` is
    of energy; `momentum` the worst error of a meeting; `lost` how many balls left the table
    without flying.
    """

    finite: bool
    gap: float
    overlap: float
    sunk: float
    gain: float
    momentum: float
    lost: int

    def faults(self) -> tuple[str, ...]:
        """Return which rules are broken, in words; none for a sound shot."""
        broken = {
            "a number is not finite": not self.finite,
            f"balls overlap by {self.overlap:.3g} m": self.overlap > OVERLAP,
            f"a ball lies {self.sunk:.3g} m in a nose": self.sunk > OVERLAP,
            f"energy grows by {self.gain:.3g} J": self.gain > GAIN,
            f"momentum is off by {self.momentum:.3g} kg m/s": self.momentum > MOMENTUM,
            f"{self.lost} balls left the table": self.lost > 0,
        }
        return tuple(words for words, holds in broken.items() if holds)


def examine(trace: Trace, table: Table | None = None) -> Findings:
    """Return what is found at every event of a trace and between; noses with a table."""
    times = _moments(trace)
    gap, overlap = _gaps(trace, times)
    energy = trace.kinetic_energy(times) + _potential(trace, times)
    gain = float(np.diff(energy).max(initial=0.0))
    left = trace.log[trace.log[:, state.E_KIND] == state.LEFT, state.E_FIRST]
    flown = trace.pieces[trace.pieces[:, state.P_KIND] == state.FLY, state.P_BALL]
    lost = int((~np.isin(left, flown)).sum())
    finite = bool(np.isfinite(trace.pieces).all() and np.isfinite(trace.log).all())
    return Findings(
        finite=finite and bool(np.isfinite(energy).all()),
        gap=gap,
        overlap=overlap,
        sunk=0.0 if table is None else _sunk(trace, table, times),
        gain=gain,
        momentum=_momentum(trace),
        lost=lost,
    )


def _moments(trace: Trace) -> Floats:
    """Return all times at which a piece begins or ends, and times between (T,).

    They lie so close that no ball goes farther than its radius from one to the next.
    """
    knots = np.unique(trace.pieces[:, [state.P_T0, state.P_T1]])
    if len(knots) < 2 or not np.isfinite(trace.pieces).all():
        return knots
    speeds = np.sqrt((trace.velocities(knots) ** 2).sum(-1)).max(-1)
    fastest = np.maximum(speeds[1:], speeds[:-1])
    radius = min(ball.radius for ball in trace.balls)
    parts = np.clip(np.ceil(np.diff(knots) * fastest / radius), 2, FINEST).astype(np.int64)
    start, length = np.repeat(knots[:-1], parts), np.repeat(np.diff(knots) / parts, parts)
    place = np.arange(parts.sum()) - np.repeat(np.cumsum(parts) - parts, parts)
    return np.unique(np.concatenate([start + place * length, knots]))


def _potential(trace: Trace, times: Floats) -> Floats:
    """Return the energy (T,) of height above the bed, J."""
    total = np.zeros(len(times))
    if not trace.flies:
        return total
    mass = np.array([ball.mass for ball in trace.balls])
    radius = np.array([ball.radius for ball in trace.balls])
    for first in range(0, len(times), MOMENTS):
        above = trace.positions(times[first : first + MOMENTS])[..., 2] - radius
        total[first : first + MOMENTS] = (trace.gravity * mass * np.maximum(above, 0.0)).sum(-1)
    return total


def _runs(trace: Trace, times: Floats) -> Iterator[tuple[Floats, NDArray[np.bool_]]]:
    """Yield centres (t, n, 3) and who is on or above the bed (t, n), for runs of moments."""
    for first in range(0, len(times), MOMENTS):
        places = trace.positions(times[first : first + MOMENTS])
        yield places, places[..., 2] > 0.0


def _gaps(trace: Trace, times: Floats) -> tuple[float, float]:
    """Return the smallest gap of two balls and the greatest overlap beyond that at the start."""
    radii = np.array([ball.radius for ball in trace.balls])
    need = radii[:, None] + radii if trace.flies else 2.0 * np.sqrt(radii[:, None] * radii)
    space = 3 if trace.flies else 2
    first, second = np.triu_indices(len(radii), 1)
    worst, overlap, start = inf, 0.0, None
    for places, here in _runs(trace, times):
        apart = (places[:, first] - places[:, second])[..., :space]
        gap = np.sqrt((apart**2).sum(-1)) - need[first, second]
        if start is None:
            start = np.minimum(gap[0], 0.0)
        gap = np.where(here[:, first] & here[:, second], gap, inf)
        worst = min(worst, float(gap.min(initial=inf)))
        overlap = max(overlap, float((start - gap).max(initial=0.0)))
    return worst, overlap


def _sunk(trace: Trace, table: Table, times: Floats) -> float:
    """Return how deep (m) a ball's centre comes within its reach of a nose."""
    noses, _ = pack_noses(table)
    radii = np.array([ball.radius for ball in trace.balls])
    flat = np.array([nose_reach(ball.radius, table.nose_height) for ball in trace.balls])
    far = 4.0 * max((ball.radius for ball in trace.balls), default=0.0)
    deepest = 0.0
    for places, here in _runs(trace, times):
        reaches = flat
        if trace.flies:
            square = radii**2 - (places[..., 2] - table.nose_height) ** 2
            reaches = np.where(
                square > 2.0 * OVERLAP * radii, np.sqrt(np.maximum(square, 0.0)), -np.inf
            )
        for nose in noses:
            depth = np.where(here, _depths(nose, places, reaches), 0.0)
            depth = np.where(depth < far, depth, 0.0)
            deepest = max(deepest, float(depth.max(initial=0.0)))
    return deepest


def _depths(nose: Floats, places: Floats, reaches: Floats) -> Floats:
    """Return how deep balls (t, n) lie in one nose, m; at most zero where they do not."""
    x, y = places[..., 0] - nose[state.N_X], places[..., 1] - nose[state.N_Y]
    dx, dy, size = nose[state.N_DX], nose[state.N_DY], nose[state.N_SIZE]
    if nose[state.N_CURVED] == 0.0:
        along = x * dx + y * dy
        beside = (along >= 0.0) & (along <= size)
        return np.where(beside, reaches - (y * dx - x * dy), 0.0)
    away = np.hypot(x, y)
    facing = x * dx + y * dy >= away * nose[state.N_SPAN]
    depth = away - (-size - reaches) if size < 0.0 else size + reaches - away
    return np.where(facing, depth, 0.0)


def _momentum(trace: Trace) -> float:
    """Return the worst change of momentum (kg m/s) where balls met and touched nothing else."""
    before, after = _velocities(trace)
    mass = [ball.mass for ball in trace.balls]
    worst = 0.0
    for time, members in _meetings(trace):
        px = py = 0.0
        for ball in members:
            old, new = before.get((ball, time)), after.get((ball, time))
            if old is None or new is None:  # what was before the first moment is not told
                break
            px += mass[ball] * (new[0] - old[0])
            py += mass[ball] * (new[1] - old[1])
        else:
            worst = max(worst, abs(px), abs(py))
    return worst


_Velocity = tuple[float, float]


def _velocities(
    trace: Trace,
) -> tuple[dict[tuple[int, float], _Velocity], dict[tuple[int, float], _Velocity]]:
    """Return by ball and time the velocities just before and just after each change of piece."""
    rows, before, after = trace.pieces, {}, {}
    spent = rows[:, state.P_T1] - rows[:, state.P_T0]
    ends = rows[:, [state.P_VX, state.P_VY]] + spent[:, None] * rows[:, [state.P_AX, state.P_AY]]
    columns = (state.P_BALL, state.P_T0, state.P_T1, state.P_VX, state.P_VY)
    told = zip(rows[:, columns].tolist(), ends.tolist(), spent.tolist(), strict=True)
    for (ball, t0, t1, vx, vy), (ux, uy), length in told:
        after[int(ball), t0] = (vx, vy)
        if length > 0.0 or (int(ball), t1) not in before:
            before[int(ball), t1] = (ux, uy)
    return before, after


def _meetings(trace: Trace) -> Iterator[tuple[float, set[int]]]:
    """Yield time and balls of each moment at which balls meet and none of them anything else."""
    log, first = trace.log, 0
    times = log[:, state.E_TIME]
    while first < len(log):
        last = first + 1
        while last < len(log) and times[last] == times[first]:
            last += 1
        rows = log[first:last]
        kinds = rows[:, state.E_KIND]
        meets = rows[kinds == state.TOUCHING]
        members = {int(ball) for ball in meets[:, [state.E_FIRST, state.E_SECOND]].ravel()}
        others = np.isin(kinds, (state.NOSE, state.DROPPED, state.LEFT, state.LANDED))
        if members and not members & {int(ball) for ball in rows[others, state.E_FIRST]}:
            yield float(times[first]), members
        first = last


__all__ = ["GAIN", "MOMENTUM", "OVERLAP", "Findings", "examine"]
