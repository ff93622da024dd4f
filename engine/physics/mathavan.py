"""The nose model `mathavan-2010`: an impact followed along its own impulse.

One idea: while the nose pushes, the ball slips or sticks at the nose and on the bed at once, so
velocities are integrated over the normal impulse p per mass (Mathavan, Jackson & Parkin 2010);
compression ends when the ball no longer nears, restitution when the nose has given back e^2 of
the work it took. Friction is capped at what stops the slip, which makes sticking exact, and steps
are Heun's. Invariant: homogeneous in speed, the ball stays on the bed, no energy is gained.
"""

from __future__ import annotations

from math import sqrt
from typing import TYPE_CHECKING

import numpy as np
from numba import njit

from engine.physics.state import (
    G_FRICTION,
    G_NOSE,
    G_SLIDING,
    RADIUS,
    REACH,
    VX,
    VY,
    WX,
    WY,
    WZ,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

STEPS = 400
"""Steps of one compression; the error falls with the square."""


@njit(cache=True, error_model="numpy")
def mathavan(ball: Floats, world: Floats, ix: float, iy: float, restitution: float) -> None:
    """Resolve a hit on a nose in the direction (ix, iy)."""
    radius = ball[RADIUS]
    rise = (world[G_NOSE] - radius) / radius
    level = ball[REACH] / radius
    ax, ay = iy, -ix
    y = np.empty(5)
    y[0] = ball[VX] * ax + ball[VY] * ay
    y[1] = ball[VX] * ix + ball[VY] * iy
    y[2] = radius * (ball[WX] * ax + ball[WY] * ay)
    y[3] = radius * (ball[WX] * ix + ball[WY] * iy)
    y[4] = radius * ball[WZ]
    before = _energy(y)
    _integrate(y, rise, level, world[G_FRICTION], world[G_SLIDING], restitution)
    after = _energy(y)
    if after > before:
        for k in range(5):
            y[k] *= sqrt(before / after)
    ball[VX], ball[VY] = y[0] * ax + y[1] * ix, y[0] * ay + y[1] * iy
    ball[WX] = (y[2] * ax + y[3] * ix) / radius
    ball[WY] = (y[2] * ay + y[3] * iy) / radius
    ball[WZ] = y[4] / radius


@njit(cache=True, error_model="numpy")
def _copy(source: Floats, target: Floats) -> None:
    for k in range(5):
        target[k] = source[k]


@njit(cache=True, error_model="numpy")
def _energy(y: Floats) -> float:
    return y[0] ** 2 + y[1] ** 2 + 0.4 * (y[2] ** 2 + y[3] ** 2 + y[4] ** 2)


@njit(cache=True, error_model="numpy")
def _integrate(
    y: Floats, rise: float, level: float, nose: float, bed: float, restitution: float
) -> None:
    """Run compression and restitution; `y` is v_x, v_y and R w in the nose's frame."""
    h = y[1] / STEPS
    one, two, last = np.empty(5), np.empty(5), np.empty(5)
    work, aim, returning = 0.0, 0.0, False
    for _ in range(60 * STEPS):
        _copy(y, last)
        _heun(y, one, two, h, rise, level, nose, bed)
        if not returning and y[1] <= 0.0:
            part = last[1] / (last[1] - y[1])
            _copy(last, y)
            _heun(y, one, two, part * h, rise, level, nose, bed)
            work += 0.5 * part * h * (last[1] + y[1])
            aim, returning, work = restitution * restitution * work, True, 0.0
            y[1] = 0.0
            continue
        done = 0.5 * h * (last[1] + y[1])
        if returning and work - done >= aim:
            part = _part_of_step(aim - work, last[1], y[1], h)
            _copy(last, y)
            _heun(y, one, two, part * h, rise, level, nose, bed)
            return
        work += -done if returning else done


@njit(cache=True, error_model="numpy")
def _part_of_step(need: float, first: float, final: float, h: float) -> float:
    """Return the part of a step in which the nose gives back `need`; v_y is linear in it."""
    slope = final - first
    if need <= 0.0:
        return 0.0
    # -h (first s + slope s^2 / 2) = need
    inside = first * first - 2.0 * slope * need / h
    root = sqrt(max(inside, 0.0)) - first
    return min(2.0 * (need / h) / root, 1.0) if root > 0.0 else 1.0


@njit(cache=True, error_model="numpy")
def _heun(
    y: Floats,
    one: Floats,
    two: Floats,
    h: float,
    rise: float,
    level: float,
    nose: float,
    bed: float,
) -> None:
    if h <= 0.0:
        return
    _copy(y, one)
    _step(one, h, rise, level, nose, bed)
    _copy(one, two)
    _step(two, h, rise, level, nose, bed)
    for k in range(5):
        y[k] = 0.5 * (y[k] + two[k])


@njit(cache=True, error_model="numpy")
def _step(y: Floats, h: float, rise: float, level: float, nose: float, bed: float) -> None:
    """Advance by the impulse h: the nose's push, its friction, and the bed's answer.

    Where a surface slips, friction has the direction of the slip at the start, as Heun's method
    asks; where it could stop the slip within the step, it does just that.
    """
    slip_x = y[0] + y[3] * rise - y[4] * level
    slip_t = y[2] - y[1] * rise
    ux, uy = y[0] - y[3], y[1] + y[2]
    y[1] -= h * level
    fx = ft = tx = ty = 0.0
    slip, slide = sqrt(slip_x * slip_x + slip_t * slip_t), sqrt(ux * ux + uy * uy)
    for _ in range(4):
        fx = -(y[0] + tx + (y[3] - 2.5 * tx) * rise - y[4] * level) / 3.5
        ft = -(y[2] + 2.5 * ty - (y[1] + ty) * rise) / (2.5 + rise * rise)
        size = sqrt(fx * fx + ft * ft)
        if size > nose * h:
            part = nose * h / (slip if slip > 0.0 else size)
            fx, ft = (-part * slip_x, -part * slip_t) if slip > 0.0 else (part * fx, part * ft)
        pressed = bed * max(0.0, h * rise - ft * level)
        tx = -(y[0] + fx - y[3] - 2.5 * rise * fx) / 3.5
        ty = -(y[1] - rise * ft + y[2] + 2.5 * ft) / 3.5
        size = sqrt(tx * tx + ty * ty)
        if size > pressed:
            part = pressed / (slide if slide > 0.0 else size)
            tx, ty = (-part * ux, -part * uy) if slide > 0.0 else (part * tx, part * ty)
    y[0] += fx + tx
    y[1] += ty - rise * ft
    y[2] += 2.5 * (ft + ty)
    y[3] += 2.5 * (rise * fx - tx)
    y[4] -= 2.5 * level * fx


__all__ = ["mathavan"]
