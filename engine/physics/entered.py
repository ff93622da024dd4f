"""A ball inside a pocket, as numbers: what the kernels of `lip` and `hole` share.

One idea: the pocket is the frame, its middle at the height of the bed the origin.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from engine.geometry.kernel import kernel_with_arrays

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Ints = NDArray[np.int64]

CAPTURED, BACK, OVER = range(3)
"""What becomes of a ball at a pocket: it falls in, is back on the bed, or leaps over the rim."""

B_X, B_Y, B_Z, B_VX, B_VY, B_VZ, B_WX, B_WY, B_WZ = range(9)
BODY = 9
"""A ball's centre from the pocket's at the height of the bed, velocity and spin: m, m/s, rad/s."""

(H_RADIUS, H_LIP, H_RIM, H_E, H_RUB, H_BED_X, H_BED_Y, H_BED_COS, H_BALL, H_GRAVITY) = range(10)
HOLE = 10
"""Radius of the drop, of its lip, height of the rim; restitution and friction in the hole; the
direction in which the bed lies and the cosine of the half angle that the lip takes up; the ball's
radius and gravity."""

STEP = 2e-4
"""Time step (s); the ends of a stage are found within one."""

LEAN = 1e-9
"""The least angle (rad) by which a ball that falls of itself is taken to lean."""

SLIPS = 0.05
"""Slip over speed from which on a ball is taken to slide over the lip without friction."""

SLOW = 0.05
"""An approach (m/s) in the hole that does not bounce: a ball settles instead of trembling."""

NUDGE = 1e-9
"""By how much (m, s) a ball is moved off a jaw, so that it is seen to be off."""

LONGEST = 20.0
"""Time (s) after which a ball that has found no way out of a hole is taken to lie in it."""


NODE = 5e-3
"""The longest time (s) between two places noted on the way, save in free flight."""


@kernel_with_arrays
def node(body: Floats, time: float, way: Floats, counts: Ints) -> None:
    """Note a place of the ball's way, as long as there is room for it and the last."""
    if counts[0] < way.shape[0] - 1:
        way[counts[0], 0] = time
        way[counts[0], 1:] = body
        counts[0] += 1


@kernel_with_arrays
def energy(body: Floats, hole: Floats) -> float:
    """Return a ball's energy over its mass."""
    speed = body[B_VX] ** 2 + body[B_VY] ** 2 + body[B_VZ] ** 2
    spin = body[B_WX] ** 2 + body[B_WY] ** 2 + body[B_WZ] ** 2
    return 0.5 * speed + 0.2 * hole[H_BALL] ** 2 * spin + hole[H_GRAVITY] * body[B_Z]
