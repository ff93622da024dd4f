"""How balls lie turned while they roll, cheap enough for every frame.

One idea: the spin is followed in steps, short ones from frame to frame, coarser ones after a jump
in time. Invariant: only pictures depend on it.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import ceil
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from engine.physics.trace import Trace

    Floats = NDArray[np.float64]

STEP = 0.004
"""Seconds of the steps in which spin is followed."""
MOST = 320
"""Steps at a time: a jump is followed in coarser ones, so that no frame waits for it."""


@dataclass(slots=True)
class Turning:
    """The rotations (n, 3, 3) of a trace's balls since its start, at the time asked last."""

    trace: Trace
    _time: float = 0.0
    _turned: Floats = field(init=False)

    def __post_init__(self) -> None:
        self._turned = np.tile(np.eye(3), (len(self.trace.balls), 1, 1))

    def at(self, time: float) -> Floats:
        """Return the rotations (n, 3, 3) at `time` (s)."""
        ahead = time - self._time
        if ahead < 0.0:
            self._turned = np.tile(np.eye(3), (len(self.trace.balls), 1, 1))
            self._time, ahead = 0.0, max(time, 0.0)
        if ahead > 0.0:
            count = min(ceil(ahead / STEP), MOST)
            middles = self._time + (np.arange(count) + 0.5) * (ahead / count)
            spins = self.trace.spins(middles) * (ahead / count)
            for turn in rotations(spins.reshape(-1, 3)).reshape(*spins.shape, 3):
                self._turned = turn @ self._turned
        self._time = time
        return self._turned


def rotations(vectors: Floats) -> Floats:
    """Return the rotations (n, 3, 3) about vectors (n, 3) by their lengths (rad).

    Rodrigues' formula; the sines of small angles come from numpy's sinc, without a division.
    """
    angle = np.linalg.norm(vectors, axis=1)
    first = np.sinc(angle / np.pi)
    second = 0.5 * np.sinc(angle / (2.0 * np.pi)) ** 2
    cross = np.zeros((len(vectors), 3, 3))
    x, y, z = vectors.T
    cross[:, 0, 1], cross[:, 0, 2], cross[:, 1, 2] = -z, y, -x
    cross[:, 1, 0], cross[:, 2, 0], cross[:, 2, 1] = z, -y, x
    turned: Floats = (
        np.eye(3) + first[:, None, None] * cross + second[:, None, None] * (cross @ cross)
    )
    return turned
