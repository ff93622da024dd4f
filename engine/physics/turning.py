"""How a ball is turned: rotations true to its spin.

One idea: within a piece w is linear in time, so a fourth-order step (Magnus: the mean of w and
the commutator of its ends) turns the ball with an error far below what can be seen; steps are cut
at piece bounds and where side spin ceases. Invariant: every matrix is a rotation to rounding.
"""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from engine.physics import state

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from engine.physics.trace import Trace

    Floats = NDArray[np.float64]

STEP = 0.5
"""Greatest turn (rad) of one step."""


def orientations(trace: Trace, times: Floats) -> Floats:
    """Return (T, n, 3, 3): the rotation of each ball from its start to each time (s)."""
    out = np.empty((len(times), len(trace.balls), 3, 3))
    for i in range(len(trace.balls)):
        out[:, i] = _turn_ball(trace, i, times)
    return out


def _turn_ball(trace: Trace, ball: int, times: Floats) -> Floats:
    rows = trace.pieces[trace.pieces[:, state.P_BALL] == ball]
    knots, spins = _knots(rows, trace.spin_rates[ball], times)
    steps = _rotations(_step_vectors(knots, spins))
    turned = np.empty((len(knots), 4))
    turned[0] = (1.0, 0.0, 0.0, 0.0)
    for k in range(len(steps)):
        turned[k + 1] = _multiply(steps[k], turned[k])
    last = np.clip(np.searchsorted(knots, times, side="right") - 1, 0, len(knots) - 1)
    return _matrices(turned[last])


def _knots(rows: Floats, rate: float, times: Floats) -> tuple[Floats, Floats]:
    """Return the times (K,) between which w is linear and small, and (K-1, 2, 3) both its ends."""
    cuts = [np.array([rows[0, state.P_T0]])]
    ends = []
    for row in rows:
        own = _cuts(row, rate, times)
        if len(own) < 2:
            continue
        cuts.append(own[1:])
        ends.append(np.stack([_spin(row, rate, own[:-1]), _spin(row, rate, own[1:])], axis=1))
    return np.concatenate(cuts), np.concatenate(ends) if ends else np.empty((0, 2, 3))


def _cuts(row: Floats, rate: float, times: Floats) -> Floats:
    start, end = row[state.P_T0], row[state.P_T1]
    ceased = start + abs(row[state.P_WZ]) / rate if row[state.P_KIND] != state.FLY else end
    inside = [t for t in (ceased,) if start < t < end]
    asked = times[(times > start) & (times < end)]
    base = np.unique(np.concatenate([[start, end], inside, asked]))
    fastest = max(np.linalg.norm(_spin(row, rate, np.array([start, end])), axis=1))
    pieces = [
        np.linspace(a, b, max(int((b - a) * fastest / STEP), 0) + 2)[:-1] for a, b in pairwise(base)
    ]
    return np.concatenate([*pieces, [end]]) if end > start else base[:1]


def _spin(row: Floats, rate: float, times: Floats) -> Floats:
    s = times - row[state.P_T0]
    side = row[state.P_WZ]
    lost = 0.0 if row[state.P_KIND] == state.FLY else rate
    return np.stack(
        [
            row[state.P_WX] + s * row[state.P_BX],
            row[state.P_WY] + s * row[state.P_BY],
            np.sign(side) * np.maximum(np.abs(side) - lost * s, 0.0),
        ],
        axis=-1,
    )


def _step_vectors(knots: Floats, spins: Floats) -> Floats:
    h = np.diff(knots)[:, None]
    first, last = spins[:, 0], spins[:, 1]
    result: Floats = 0.5 * h * (first + last) - h * h / 12.0 * np.cross(first, last)
    return result


def _rotations(vectors: Floats) -> Floats:
    """Return unit quaternions (w, x, y, z) of rotation vectors."""
    angle = np.linalg.norm(vectors, axis=-1, keepdims=True)
    half = 0.5 * angle
    scale = 0.5 * np.sinc(half / np.pi)
    return np.concatenate([np.cos(half), scale * vectors], axis=-1)


def _multiply(one: Floats, two: Floats) -> Floats:
    a, b, c, d = one
    e, f, g, h = two
    product = np.array(
        [
            a * e - b * f - c * g - d * h,
            a * f + b * e + c * h - d * g,
            a * g - b * h + c * e + d * f,
            a * h + b * g - c * f + d * e,
        ]
    )
    unit: Floats = product / np.sqrt(product @ product)
    return unit


def _matrices(q: Floats) -> Floats:
    w, x, y, z = q.T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), -1, 0)


__all__ = ["orientations"]
