"""A trace read at its events and between: what the monitor looks at, as plain arrays.

One idea: at every moment at which a piece begins or ends, each ball has a state just before and
one just after; between two such moments all follow one piece each. Invariant: everything is read
off the pieces, nothing is asked of the solver.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from engine.physics import state

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from engine.physics.trace import Trace

    Floats = NDArray[np.float64]
    Ints = NDArray[np.int64]
    Bools = NDArray[np.bool_]

FINEST = 2000
"""Into no more parts than this is the time between two events cut."""

DEPARTURES = (state.DROPPED, state.LEFT)


@dataclass(frozen=True, slots=True, eq=False)
class States:
    """The balls at some moments (t, n): centre and velocity (t, n, 3), spin (t, n, 3), in SI."""

    places: Floats
    velocity: Floats
    spin: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Reading:
    """A trace with its pieces by column, its moments (k,), and what ends when.

    `before` and `after` (k, n) are the numbers of the pieces that hold just before and just after
    each moment; `gone` (n,) is when a ball drops or leaves, infinite for never.
    """

    trace: Trace
    columns: Floats
    radii: Floats
    masses: Floats
    knots: Floats
    before: Ints
    after: Ints
    gone: Floats

    def states(self, pieces: Ints, times: Floats) -> States:
        """Return the balls' states (t, n) by the pieces with these numbers (t, n)."""
        column, flies = self.columns, self.trace.flies
        s, at_end = self._into(pieces, times)
        still = times[:, None] > at_end
        shape = (*pieces.shape, 3)
        places, velocity, spin = np.empty(shape), np.zeros(shape), np.zeros(shape)
        for k in (0, 1):
            v, a = column[state.P_VX + k][pieces], column[state.P_AX + k][pieces]
            places[..., k] = column[state.P_X + k][pieces] + s * (v + 0.5 * s * a)
            velocity[..., k] = v + s * a
            rate = column[state.P_BX + k][pieces]
            spin[..., k] = column[state.P_WX + k][pieces] + s * rate
        places[..., 2] = self.radii
        lost = self.trace.spin_rates * s
        if flies:
            aloft = column[state.P_KIND][pieces] == state.FLY
            v = column[state.P_VZ][pieces]
            fallen = self.trace.gravity * s
            rise = column[state.P_Z][pieces] + s * (v - 0.5 * fallen)
            places[..., 2] = np.where(aloft, rise, self.radii)
            velocity[..., 2] = np.where(aloft, v - fallen, 0.0)
            lost = np.where(aloft, 0.0, lost)
        side = column[state.P_WZ][pieces]
        spin[..., 2] = np.sign(side) * np.maximum(np.abs(side) - lost, 0.0)
        velocity[still], spin[still] = 0.0, 0.0
        return States(places, velocity, spin)

    def centres(self, pieces: Ints, times: Floats) -> Floats:
        """Return the centres (3, t, n) by the pieces with these numbers (t, n)."""
        column = self.columns
        s, _ = self._into(pieces, times)
        out = np.empty((3, *pieces.shape))
        for k in (0, 1):
            v, a = column[state.P_VX + k][pieces], column[state.P_AX + k][pieces]
            out[k] = column[state.P_X + k][pieces] + s * (v + 0.5 * s * a)
        out[2] = self.radii
        if self.trace.flies:
            aloft = column[state.P_KIND][pieces] == state.FLY
            v = column[state.P_VZ][pieces] - 0.5 * self.trace.gravity * s
            out[2] = np.where(aloft, column[state.P_Z][pieces] + s * v, self.radii)
        return out

    def _into(self, pieces: Ints, times: Floats) -> tuple[Floats, Floats]:
        start, end = self.columns[state.P_T0][pieces], self.columns[state.P_T1][pieces]
        return np.clip(times[:, None], start, end) - start, end

    def between(self) -> tuple[Floats, Ints]:
        """Return moments (t,) at and between the knots, and the pieces (t, n) that hold there.

        They lie so close that no ball goes farther than its radius from one to the next.
        """
        if len(self.knots) < 2 or not np.isfinite(self.columns).all():
            return self.knots, self.after
        length = np.diff(self.knots)
        speeds = [
            np.sqrt((self.states(pieces, times).velocity ** 2).sum(-1)).max(-1, initial=0.0)
            for pieces, times in (
                (self.after[:-1], self.knots[:-1]),
                (self.before[1:], self.knots[1:]),
            )
        ]
        fastest = np.maximum(*speeds)
        parts = np.ceil(length * fastest / self.radii.min())
        parts = np.clip(parts, 2, FINEST).astype(np.int64)
        place = np.arange(parts.sum()) - np.repeat(np.cumsum(parts) - parts, parts)
        times = np.repeat(self.knots[:-1], parts) + place * np.repeat(length / parts, parts)
        pieces = np.repeat(self.after[:-1], parts, axis=0)
        return np.append(times, self.knots[-1]), np.append(pieces, self.after[-1:], axis=0)


def read(trace: Trace) -> Reading:
    """Return a trace as it is looked at."""
    columns = np.ascontiguousarray(trace.pieces.T)
    knots = np.unique(columns[[state.P_T0, state.P_T1]])
    n = len(trace.balls)
    starts = np.searchsorted(columns[state.P_BALL], np.arange(n + 1))
    before = np.empty((len(knots), n), dtype=np.int64)
    after = np.empty_like(before)
    for i in range(n):
        own = columns[state.P_T0, starts[i] : starts[i + 1]]
        before[:, i] = starts[i] + np.maximum(np.searchsorted(own, knots, side="left") - 1, 0)
        after[:, i] = starts[i] + np.maximum(np.searchsorted(own, knots, side="right") - 1, 0)
    gone = np.full(n, np.inf)
    for row in trace.log[np.isin(trace.log[:, state.E_KIND], DEPARTURES)]:
        gone[int(row[state.E_FIRST])] = row[state.E_TIME]
    radii = np.array([ball.radius for ball in trace.balls])
    masses = np.array([ball.mass for ball in trace.balls])
    return Reading(trace, columns, radii, masses, knots, before, after, gone)


__all__ = ["Reading", "States", "read"]
