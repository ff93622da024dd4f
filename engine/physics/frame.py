"""A ball's motion in the frame of a nose: along it, into it, and its spins as speeds at the rim.

One idea: every model of a cushion works in this frame, X along the nose and Y into it, so that
each says its impulses alone. Invariant: going in and out again changes rounding at most.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from engine.geometry.kernel import kernel
from engine.physics.state import RADIUS, VX, VY, WX, WY, WZ

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


@kernel
def enter(ball: Floats, ix: float, iy: float) -> tuple[float, float, float, float, float]:
    """Return speed along and into a nose in the direction (ix, iy), and R times the spins, m/s."""
    radius = ball[RADIUS]
    ax, ay = iy, -ix
    along, into = ball[VX] * ax + ball[VY] * ay, ball[VX] * ix + ball[VY] * iy
    spin_x = radius * (ball[WX] * ax + ball[WY] * ay)
    spin_y = radius * (ball[WX] * ix + ball[WY] * iy)
    return along, into, spin_x, spin_y, radius * ball[WZ]


@kernel
def leave(
    ball: Floats,
    ix: float,
    iy: float,
    along: float,
    into: float,
    spin_x: float,
    spin_y: float,
    spin_z: float,
) -> None:
    """Give the ball the motion that it has in a nose's frame."""
    radius = ball[RADIUS]
    ax, ay = iy, -ix
    ball[VX], ball[VY] = along * ax + into * ix, along * ay + into * iy
    ball[WX] = (spin_x * ax + spin_y * ix) / radius
    ball[WY] = (spin_x * ay + spin_y * iy) / radius
    ball[WZ] = spin_z / radius


__all__ = ["enter", "leave"]
