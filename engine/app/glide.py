"""From one look at the table to another, smoothly.

One idea: where the eye should be is asked anew in every frame; after a change of view what is shown
goes from where the eye was to where it should be, by the time that has passed. Invariant: outside
such a change the two are the same, so nothing lags behind the hand.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import acos, cos, sin, sqrt
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Hashable

    from numpy.typing import NDArray

    from engine.scene.camera import Camera, Vector

    Matrix = NDArray[np.float64]

TIME = 0.45
"""Seconds that a change of view takes."""


@dataclass(slots=True)
class Glide:
    """The eye between two views; with a `time` of 0 it jumps."""

    time: float = TIME
    _view: Hashable = None
    _from: Camera | None = None
    _gone: float = 0.0
    _shown: Camera | None = None

    def look(self, wanted: Camera, view: Hashable, seconds: float) -> Camera:
        """Return the camera to be shown `seconds` later; a new `view` begins a change."""
        if view != self._view:
            self._view, self._from, self._gone = view, self._shown, 0.0
        else:
            self._gone += seconds
        if self._from is None or self._gone >= self.time:
            self._from, self._shown = None, wanted
        else:
            self._shown = between(self._from, wanted, eased(self._gone / self.time))
        return self._shown

    @property
    def is_moving(self) -> bool:
        """Whether a change of view is going on."""
        return self._from is not None


def eased(share: float) -> float:
    """Return how far a change has come (0 to 1) that begins and ends gently."""
    share = min(max(share, 0.0), 1.0)
    return share * share * (3.0 - 2.0 * share)


def between(one: Camera, two: Camera, share: float) -> Camera:
    """Return a camera between two: 0 is the first, 1 the second; it turns the shorter way."""
    if share <= 0.0 or share >= 1.0:
        return two if share >= 1.0 else one
    eye = mixed(one.eye, two.eye, share)
    turned = partly_turned(one.basis(), two.basis(), share)
    far = (1.0 - share) * _reach(one) + share * _reach(two)
    ahead, up = turned[2], -turned[1]
    target = tuple(float(e + far * a) for e, a in zip(eye, ahead, strict=True))
    return replace(
        two,
        eye=eye,
        target=(target[0], target[1], target[2]),
        up=(float(up[0]), float(up[1]), float(up[2])),
        field=(1.0 - share) * one.field + share * two.field,
    )


def mixed(one: Vector, two: Vector, share: float) -> Vector:
    """Return a point between two."""
    x, y, z = ((1.0 - share) * a + share * b for a, b in zip(one, two, strict=True))
    return x, y, z


def _reach(camera: Camera) -> float:
    return sqrt(sum((a - b) ** 2 for a, b in zip(camera.target, camera.eye, strict=True)))


def partly_turned(one: Matrix, two: Matrix, share: float) -> Matrix:
    """Return the rotation (3, 3) that lies `share` of the way from one to another.

    Rodrigues' formula about the axis of the rotation between them.
    """
    turn = two @ one.T
    angle = acos(min(max((float(np.trace(turn)) - 1.0) / 2.0, -1.0), 1.0))
    if angle < 1e-9:
        return two
    axis = _axis(turn)
    part = share * angle
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    rotation = np.eye(3) + sin(part) * cross + (1.0 - cos(part)) * (cross @ cross)
    turned: Matrix = rotation @ one
    return turned


def _axis(turn: Matrix) -> Matrix:
    """Return the axis of a rotation, half a turn included."""
    off = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
    size = float(np.linalg.norm(off))
    if size > 1e-6:
        axis: Matrix = off / size
        return axis
    outer = (turn + np.eye(3)) / 2.0
    column = int(np.argmax(np.diag(outer)))
    half: Matrix = outer[:, column] / np.linalg.norm(outer[:, column])
    return half
