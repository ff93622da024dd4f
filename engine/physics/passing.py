"""Who left the bed, and who jumped over whom: read off the flights of a trace.

One idea: flights are pieces like all others, so what happens in them can be told afterwards. A
ball has passed over another when their centres, seen from above, come nearest to each other at
less than the sum of the radii while it flies above; so one that comes down on the near side has
not passed. Invariant: reading changes nothing, and a passage is told once.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from engine.physics import state
from engine.physics.events import BallJumpedOver, BallLeftBed

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray

    from engine.physics.trace import Trace

    Floats = NDArray[np.float64]

LEVEL = 1e-9
"""A ball no higher than this (m) above the bed lies on it."""


def jumps(trace: Trace) -> list[BallJumpedOver]:
    """Return who passed over whom, in order of time."""
    found = [
        BallJumpedOver(time, trace.balls[int(row[state.P_BALL])].id, trace.balls[other].id)
        for row in trace.pieces[trace.pieces[:, state.P_KIND] == state.FLY]
        for time, other in _passages(trace, row)
    ]
    return sorted(found, key=lambda event: event.time)


def liftoffs(trace: Trace) -> list[BallLeftBed]:
    """Return who left the bed and when, in order of time; a bounce in a flight is no new one."""
    rows, found = trace.pieces, []
    flies = rows[:, state.P_KIND] == state.FLY
    for k in np.flatnonzero(flies):
        ball = int(rows[k, state.P_BALL])
        bounced = k > 0 and flies[k - 1] and rows[k - 1, state.P_BALL] == ball
        low = rows[k, state.P_Z] <= trace.balls[ball].radius + LEVEL
        if low and not bounced and rows[k, state.P_VZ] > 0.0:
            found.append(BallLeftBed(float(rows[k, state.P_T0]), trace.balls[ball].id))
    return sorted(found, key=lambda event: event.time)


def _passages(trace: Trace, row: Floats) -> Iterator[tuple[float, int]]:
    """Yield when one flight passes over other balls, and which."""
    gone, pieces = _gone(trace), trace.pieces
    early = pieces[:, state.P_T0] < row[state.P_T1]
    for piece in pieces[early & (pieces[:, state.P_T1] > row[state.P_T0])]:
        me, other = int(row[state.P_BALL]), int(piece[state.P_BALL])
        start = max(row[state.P_T0], piece[state.P_T0])
        end = min(row[state.P_T1], gone.get(other, np.inf), piece[state.P_T1])
        if other == me or start >= end:
            continue
        time = _nearest(row, piece, start, end)
        if time is None:
            continue
        apart = _place(trace, row, time) - _place(trace, piece, time)
        reach = trace.balls[me].radius + trace.balls[other].radius
        if apart[0] ** 2 + apart[1] ** 2 < reach**2 and apart[2] > 0.0:
            yield float(time), other


def _gone(trace: Trace) -> dict[int, float]:
    leaving = np.isin(trace.log[:, state.E_KIND], (state.DROPPED, state.LEFT))
    return {int(row[state.E_FIRST]): float(row[state.E_TIME]) for row in trace.log[leaving]}


def _nearest(row: Floats, piece: Floats, low: float, high: float) -> float | None:
    """Return when two pieces are nearest from above, strictly inside the times, or None."""
    if not (_drift(row, piece, low) < 0.0 <= _drift(row, piece, high)):
        return None
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _drift(row, piece, middle) < 0.0 else (low, middle)
    return high


def _drift(row: Floats, piece: Floats, time: float) -> float:
    """Return half the rate of the squared distance from above, m^2/s."""
    s, u = time - row[state.P_T0], time - piece[state.P_T0]
    total = 0.0
    for r, v, a in ((state.P_X, state.P_VX, state.P_AX), (state.P_Y, state.P_VY, state.P_AY)):
        apart = row[r] + s * row[v] - piece[r] - u * (piece[v] + 0.5 * u * piece[a])
        total += float(apart * (row[v] - piece[v] - u * piece[a]))
    return total


def _place(trace: Trace, row: Floats, time: float) -> Floats:
    s = time - row[state.P_T0]
    place = np.empty(3)
    for k, r, v, a in (
        (0, state.P_X, state.P_VX, state.P_AX),
        (1, state.P_Y, state.P_VY, state.P_AY),
    ):
        place[k] = row[r] + s * (row[v] + 0.5 * s * row[a])
    bend = trace.gravity if row[state.P_KIND] == state.FLY else 0.0
    place[2] = row[state.P_Z] + s * (row[state.P_VZ] - 0.5 * bend * s)
    return place


__all__ = ["jumps", "liftoffs"]
