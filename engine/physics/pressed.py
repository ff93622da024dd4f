"""The ball-ball model `mathavan-2014`: two balls that rub on each other and on the cloth.

One idea: while two balls push each other, friction between them presses one of them onto the bed,
where it rubs too. The slips at all three contacts are followed along the normal impulse p
(Mathavan, Jackson & Parkin 2014, eqs. 6 to 17): compression ends when the balls no longer near,
restitution when they have given back e^2 of the work they took. Only a ball that is pressed down
meets the bed; neither leaves it. A slip between the balls that has died stays dead, since nothing
but friction drives it. Invariant: homogeneous in speed where friction is constant, no energy is
gained, momentum changes by no more than the bed's friction, swapping the balls changes no bit.
"""

from __future__ import annotations

from math import exp, sqrt
from typing import TYPE_CHECKING

import numpy as np

from engine.geometry.kernel import kernel_with_arrays
from engine.physics.collide import grip, restitution
from engine.physics.state import (
    G_DECAY,
    G_FLOOR,
    G_RISE,
    MASS,
    RADIUS,
    SLIDING,
    VX,
    VY,
    WX,
    WY,
    WZ,
    X,
    Y,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

ERROR = 1e-8
"""Error of one step, in parts of the speed of approach."""

DEAD = 1e-10
"""A slip between the balls that is none, in parts of the speed of approach."""

LEAST = 1e-7
"""The shortest step, in parts of the whole impulse."""

STEPS = 4000
"""Steps after which an impact that does not end is given up; none is known."""

(RUB_X, RUB_Z, ONE_X, ONE_Y, TWO_X, TWO_Y, NEARING) = range(7)
(ACROSS, UP, BED1_X, BED1_Y, BED2_X, BED2_Y, WORK, PUSH) = range(7, 15)
SIZE = 15
"""The state in the frame Y from the first ball to the second, X right of it, Z up: slip between
the balls across and upwards, slips of both on the bed, speed of approach; then the impulses of
friction on the first ball by the second and by the bed on each, the work and the impulse p."""

P_LIGHT1, P_LIGHT2, P_FLOOR, P_RISE, P_DECAY, P_BED1, P_BED2, P_SPEED = range(8)
PLACE = 8
"""One over each mass, the law of friction, the bed's friction under each, the speed of approach."""


@kernel_with_arrays
def meet_pressed(one: Floats, two: Floats, world: Floats) -> float:
    """Resolve one meeting of balls that near each other; return the speed of approach, m/s."""
    if (two[X], two[Y]) < (one[X], one[Y]):
        one, two = two, one
    nx, ny = two[X] - one[X], two[Y] - one[Y]
    gap = sqrt(nx * nx + ny * ny)
    nx, ny = nx / gap, ny / gap
    speed = (one[VX] - two[VX]) * nx + (one[VY] - two[VY]) * ny
    before = _energy(one) + _energy(two)
    place, y = np.empty(PLACE), np.zeros(SIZE)
    place[P_LIGHT1], place[P_LIGHT2] = 1.0 / one[MASS], 1.0 / two[MASS]
    more = grip(one, two)
    place[P_FLOOR], place[P_RISE] = more * world[G_FLOOR], more * world[G_RISE]
    place[P_DECAY], place[P_SPEED] = world[G_DECAY], speed
    place[P_BED1], place[P_BED2] = one[SLIDING], two[SLIDING]
    y[RUB_X] = _across(one, nx, ny) - _across(two, nx, ny)
    y[RUB_X] -= one[RADIUS] * one[WZ] + two[RADIUS] * two[WZ]
    y[RUB_Z] = one[RADIUS] * (one[WX] * ny - one[WY] * nx)
    y[RUB_Z] += two[RADIUS] * (two[WX] * ny - two[WY] * nx)
    y[ONE_X], y[ONE_Y] = _slide(one, nx, ny)
    y[TWO_X], y[TWO_Y] = _slide(two, nx, ny)
    y[NEARING] = speed
    _follow(y, place, restitution(one, two, world, speed))
    _give(one, nx, ny, -y[PUSH], y[ACROSS], y[UP], y[BED1_X], y[BED1_Y])
    _give(two, -nx, -ny, -y[PUSH], y[ACROSS], -y[UP], -y[BED2_X], -y[BED2_Y])
    _forbid_gain(one, two, before)
    return speed


@kernel_with_arrays
def _across(ball: Floats, nx: float, ny: float) -> float:
    return ball[VX] * ny - ball[VY] * nx


@kernel_with_arrays
def _slide(ball: Floats, nx: float, ny: float) -> tuple[float, float]:
    """Return the slip on the bed across and along the line of centres."""
    ux = ball[VX] - ball[RADIUS] * ball[WY]
    uy = ball[VY] + ball[RADIUS] * ball[WX]
    return ux * ny - uy * nx, ux * nx + uy * ny


@kernel_with_arrays
def _give(
    ball: Floats,
    nx: float,
    ny: float,
    along: float,
    across: float,
    up: float,
    bed_x: float,
    bed_y: float,
) -> None:
    """Apply impulses (N s) of the other ball in the direction n and of the bed.

    `across` is to the right of n, as are `bed_x` and, along n, `bed_y`.
    """
    light, lever = 1.0 / ball[MASS], 2.5 / (ball[MASS] * ball[RADIUS])
    side, ahead = across + bed_x, along + bed_y
    ball[VX] += light * (side * ny + ahead * nx)
    ball[VY] += light * (ahead * ny - side * nx)
    # about X: up at the other ball and the bed's push along; about Y: the bed's push across
    turn_x, turn_y = lever * (up + bed_y), -lever * bed_x
    ball[WX] += turn_x * ny + turn_y * nx
    ball[WY] += turn_y * ny - turn_x * nx
    ball[WZ] -= lever * across


@kernel_with_arrays
def _rate(y: Floats, place: Floats, d: Floats) -> None:
    """Fill `d` with how the state changes with p."""
    light1, light2 = place[P_LIGHT1], place[P_LIGHT2]
    both = light1 + light2
    slip = sqrt(y[RUB_X] * y[RUB_X] + y[RUB_Z] * y[RUB_Z])
    across = up = 0.0
    if slip > DEAD * place[P_SPEED]:
        mu = place[P_FLOOR] + place[P_RISE] * exp(-place[P_DECAY] * slip)
        across, up = -mu * y[RUB_X] / slip, -mu * y[RUB_Z] / slip
    b1x = b1y = b2x = b2y = 0.0
    if up < 0.0:
        driven_x, driven_y = light1 * across, light1 * (2.5 * up - 1.0)
        b1x, b1y = _bed(y[ONE_X], y[ONE_Y], driven_x, driven_y, -place[P_BED1] * up, place[P_SPEED])
    elif up > 0.0:
        driven_x, driven_y = -light2 * across, light2 * (2.5 * up + 1.0)
        b2x, b2y = _bed(y[TWO_X], y[TWO_Y], driven_x, driven_y, place[P_BED2] * up, place[P_SPEED])
    d[RUB_X] = 3.5 * across * both + light1 * b1x - light2 * b2x
    d[RUB_Z] = 2.5 * (up * both + light1 * b1y + light2 * b2y)
    d[ONE_X], d[ONE_Y] = light1 * (across + 3.5 * b1x), light1 * (2.5 * up - 1.0 + 3.5 * b1y)
    d[TWO_X], d[TWO_Y] = light2 * (3.5 * b2x - across), light2 * (2.5 * up + 1.0 + 3.5 * b2y)
    d[NEARING] = light1 * (b1y - 1.0) - light2 * (1.0 + b2y)
    d[ACROSS], d[UP] = across, up
    d[BED1_X], d[BED1_Y], d[BED2_X], d[BED2_Y] = b1x, b1y, b2x, b2y
    d[WORK], d[PUSH] = y[NEARING], 1.0


@kernel_with_arrays
def _bed(
    ux: float, uy: float, driven_x: float, driven_y: float, most: float, speed: float
) -> tuple[float, float]:
    """Return the bed's friction against a slip, or against the slip that begins."""
    slip = sqrt(ux * ux + uy * uy)
    if slip <= DEAD * speed:
        ux, uy = driven_x, driven_y
        slip = sqrt(ux * ux + uy * uy)
    return -most * ux / slip, -most * uy / slip


@kernel_with_arrays
def _follow(y: Floats, place: Floats, e: float) -> None:
    """Run compression and restitution."""
    speed = place[P_SPEED]
    whole = speed / (place[P_LIGHT1] + place[P_LIGHT2])
    stages, trial = np.empty((6, SIZE)), np.empty(SIZE)
    step, goal, returning = 0.1 * whole, 0.0, 0.0
    for _ in range(STEPS):
        h = min(step, _life(y, place, stages, whole))
        error = _attempt(y, place, h, stages, trial)
        if error > ERROR * speed and h > LEAST * whole:
            step = h * max(0.2, 0.8 * sqrt(sqrt(ERROR * speed / error)))
            continue
        over = (trial[WORK] <= goal) if returning > 0.0 else (trial[NEARING] <= 0.0)
        if over:
            _arrive(y, place, h, stages, trial, goal, returning)
        for k in range(SIZE):
            y[k] = trial[k]
        if y[RUB_X] * y[RUB_X] + y[RUB_Z] * y[RUB_Z] <= (DEAD * speed) ** 2:
            y[RUB_X] = y[RUB_Z] = 0.0
        if over:
            if returning > 0.0 or e == 0.0:
                return
            returning, goal = 1.0, (1.0 - e * e) * y[WORK]
        step = h * min(4.0, 0.8 * sqrt(sqrt(ERROR * speed / max(error, 1e-300))))


@kernel_with_arrays
def _life(y: Floats, place: Floats, stages: Floats, whole: float) -> float:
    """Return the longest step: a slip between the balls never dies within one, it nears death."""
    _rate(y, place, stages[0])
    square = y[RUB_X] * y[RUB_X] + y[RUB_Z] * y[RUB_Z]
    falls = -(y[RUB_X] * stages[0, RUB_X] + y[RUB_Z] * stages[0, RUB_Z])
    if square == 0.0 or falls <= 0.0:
        return whole
    life = square / falls
    if life * falls <= (3.0 * DEAD * place[P_SPEED]) ** 2:
        return life
    return max(0.7 * life, LEAST * whole * 1e-4)


@kernel_with_arrays
def _attempt(y: Floats, place: Floats, h: float, k: Floats, trial: Floats) -> float:
    """Fill `trial` with the state after h more of p; return an estimate of its error.

    Merson's method of order four; the first stage is there already.
    """
    for i in range(SIZE):
        trial[i] = y[i] + h / 3.0 * k[0, i]
    _rate(trial, place, k[1])
    for i in range(SIZE):
        trial[i] = y[i] + h / 6.0 * (k[0, i] + k[1, i])
    _rate(trial, place, k[2])
    for i in range(SIZE):
        trial[i] = y[i] + h / 8.0 * (k[0, i] + 3.0 * k[2, i])
    _rate(trial, place, k[3])
    for i in range(SIZE):
        k[5, i] = y[i] + h * (0.5 * k[0, i] - 1.5 * k[2, i] + 2.0 * k[3, i])
        trial[i] = k[5, i]
    _rate(trial, place, k[4])
    error = 0.0
    for i in range(SIZE):
        trial[i] = y[i] + h / 6.0 * (k[0, i] + 4.0 * k[3, i] + k[4, i])
        if i <= NEARING:
            error = max(error, 0.2 * abs(trial[i] - k[5, i]))
    return error


@kernel_with_arrays
def _arrive(
    y: Floats, place: Floats, h: float, k: Floats, trial: Floats, goal: float, returning: float
) -> None:
    """Fill `trial` with the state in which the phase ends, within a step h: Newton's method."""
    low, high = 0.0, h
    for _ in range(40):
        left = trial[WORK] - goal if returning > 0.0 else trial[NEARING]
        scale = place[P_SPEED] if returning == 0.0 else max(y[WORK], goal)
        if abs(left) <= 1e-13 * scale:
            return
        if left > 0.0:
            low = h
        else:
            high = h
        slope = trial[NEARING] if returning > 0.0 else -(place[P_LIGHT1] + place[P_LIGHT2])
        h -= left / slope if slope < 0.0 else 0.0
        if not low < h < high:
            h = 0.5 * (low + high)
        _attempt(y, place, h, k, trial)


@kernel_with_arrays
def _energy(ball: Floats) -> float:
    spin = ball[WX] * ball[WX] + ball[WY] * ball[WY] + ball[WZ] * ball[WZ]
    speed = ball[VX] * ball[VX] + ball[VY] * ball[VY]
    return ball[MASS] * (0.5 * speed + 0.2 * ball[RADIUS] * ball[RADIUS] * spin)


@kernel_with_arrays
def _forbid_gain(one: Floats, two: Floats, before: float) -> None:
    """Take back what rounding gained, from the motion relative to the centre of mass."""
    gain = _energy(one) + _energy(two) - before
    if gain <= 0.0:
        return
    mass = one[MASS] + two[MASS]
    cx = (one[MASS] * one[VX] + two[MASS] * two[VX]) / mass
    cy = (one[MASS] * one[VY] + two[MASS] * two[VY]) / mass
    dx, dy = one[VX] - two[VX], one[VY] - two[VY]
    inner = 0.5 * one[MASS] * two[MASS] / mass * (dx * dx + dy * dy)
    if inner <= gain:
        return
    part = sqrt(1.0 - gain / inner) * (1.0 - 1e-15)
    for ball in (one, two):
        ball[VX] = cx + part * (ball[VX] - cx)
        ball[VY] = cy + part * (ball[VY] - cy)


__all__ = ["meet_pressed"]
