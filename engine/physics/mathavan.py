"""The nose model `mathavan-2010`: an impact followed along its own impulse.

One idea: while the nose pushes, the ball slips or sticks at the nose and on the bed at once, so
both slips are integrated over the normal impulse p per mass (Mathavan, Jackson & Parkin 2010);
compression ends when the ball no longer nears, restitution when the nose has given back e^2 of
the work it took. The rates depend on the directions of the slips alone, so a fourth-order step
with error control is long where they hold still and short where one turns as it dies; a slip that
has died is made zero and stays so while friction can hold it. Invariant: homogeneous in speed,
the ball stays on the bed, no energy is gained.
"""

from __future__ import annotations

from math import inf, sqrt
from typing import TYPE_CHECKING

from engine.geometry.kernel import kernel
from engine.physics.frame import enter
from engine.physics.state import (
    RADIUS,
    SLIDING,
    VX,
    VY,
    WX,
    WY,
    WZ,
)

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Four = tuple[float, float, float, float]
    Five = tuple[float, float, float, float, float]
    Ten = tuple[float, float, float, float, float, float, float, float, float, float]

ERROR = 1e-5
"""Error of one step, in parts of the normal speed."""

DEAD = 2e-5
"""A slip that is none, in parts of the normal speed."""

NEAR = 1e-10
"""How near to its end a phase ends, in parts of the speed or its square."""

STEPS = 1000
"""Steps after which an impact that does not end is given up; none is known."""

P_RISE, P_LEVEL, P_NOSE, P_BED, P_DEAD = range(5)
"""Sine and cosine of the nose's height, friction of nose and bed, and DEAD as a speed."""

NOSE_X, NOSE_T, BED_X, BED_Y, FX, FT, TX, TY, WORK, PUSH = range(10)
"""The state: slip at the nose, along and upwards, and on the bed; the impulses of friction at both
so far, the nose's work and its push p. The frame is X along the nose, Y into it."""


@kernel
def mathavan(
    ball: Floats,
    where: tuple[float, float],
    friction: float,
    ix: float,
    iy: float,
    restitution: float,
) -> None:
    """Resolve a hit on a nose in the direction (ix, iy), touched at `where` (sine, cosine)."""
    radius = ball[RADIUS]
    rise, level = where
    ax, ay = iy, -ix
    along, into, spin_x, spin_y, spin_z = enter(ball, ix, iy)
    before = along**2 + into**2 + 0.4 * (spin_x**2 + spin_y**2 + spin_z**2)
    place = (rise, level, friction, ball[SLIDING], DEAD * into)
    nose_x, nose_t = along + spin_y * rise - spin_z * level, spin_x - into * rise
    y = (nose_x, nose_t, along - spin_y, into + spin_x, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    y = _follow(y, place, into, restitution)
    along += y[FX] + y[TX]
    into += y[TY] - rise * y[FT] - level * y[PUSH]
    spin_x += 2.5 * (y[FT] + y[TY])
    spin_y += 2.5 * (rise * y[FX] - y[TX])
    spin_z -= 2.5 * level * y[FX]
    after = along**2 + into**2 + 0.4 * (spin_x**2 + spin_y**2 + spin_z**2)
    part = sqrt(before / after) if after > before else 1.0
    into = min(into, 0.0)
    ball[VX], ball[VY] = part * (along * ax + into * ix), part * (along * ay + into * iy)
    ball[WX] = part * (spin_x * ax + spin_y * ix) / radius
    ball[WY] = part * (spin_x * ay + spin_y * iy) / radius
    ball[WZ] = part * spin_z / radius


@kernel
def _follow(y: Ten, place: Five, speed: float, restitution: float) -> Ten:
    """Return the state after compression and restitution; `speed` is the ball's into the nose."""
    part, goal, returning = 0.5, 0.0, 0.0
    first = _friction(y[NOSE_X], y[NOSE_T], y[BED_X], y[BED_Y], place)
    for _ in range(STEPS):
        # a step is a part of the slips' remaining life, so that it shrinks as they do
        life = min(speed, _life(y, first, place))
        trial, error = _attempt(y, first, place, part * life)
        allowed = min(ERROR * speed, 0.02 * _least(y, place[P_DEAD]))
        ease = min(2.0, 0.8 * sqrt(sqrt(allowed / max(error, 1e-300))))
        if error > allowed:
            part *= max(0.2, ease)
            continue
        over = _left(trial, place, goal, returning) <= 0.0
        if over:
            trial = _arrive(y, first, place, part * life, trial, goal, speed, returning)
        y = _still(trial, place)
        if over:
            if returning > 0.0 or restitution == 0.0:
                return y
            returning, goal = 1.0, (1.0 - restitution * restitution) * y[WORK]
        part = min(1.0, part * ease)
        first = _friction(y[NOSE_X], y[NOSE_T], y[BED_X], y[BED_Y], place)
    return y


@kernel
def _least(y: Ten, dead: float) -> float:
    """Return the lesser of the slips that have not died."""
    nose = y[NOSE_X] ** 2 + y[NOSE_T] ** 2
    bed = y[BED_X] ** 2 + y[BED_Y] ** 2
    nose = nose if nose > dead * dead else inf
    bed = bed if bed > dead * dead else inf
    return sqrt(min(nose, bed))


@kernel
def _into(y: Ten, place: Five) -> float:
    """Return the speed into the nose, which both upward slips tell."""
    return (y[BED_Y] - y[NOSE_T]) / (1.0 + place[P_RISE])


@kernel
def _left(y: Ten, place: Five, goal: float, returning: float) -> float:
    """Return what is left of the phase: speed into the nose, or work to give back."""
    return y[WORK] - goal if returning > 0.0 else _into(y, place)


@kernel
def _arrive(
    y: Ten,
    first: Four,
    place: Five,
    h: float,
    trial: Ten,
    goal: float,
    speed: float,
    returning: float,
) -> Ten:
    """Return the state in which the phase ends, within a step h to `trial`.

    What is left is a quadratic or cubic of h but for the turning of the slips; its root is the
    first guess, its slope that of Newton's method.
    """
    _, dt, _, dy = _drift(first, place)
    slowing = (dy - dt) / (1.0 + place[P_RISE])
    q0, end = _left(y, place, goal, returning), _left(trial, place, goal, returning)
    if returning > 0.0:
        q1, q2 = _into(y, place), 0.5 * slowing
        q3 = (end - q0 - h * (q1 + h * q2)) / (h * h * h)
    else:
        q1, q2, q3 = slowing, (end - q0 - h * slowing) / (h * h), 0.0
    low, high, guess = 0.0, h, h * q0 / (q0 - end)
    for _ in range(4):
        slope = q1 + guess * (2.0 * q2 + guess * 3.0 * q3)
        following = guess - (q0 + guess * (q1 + guess * (q2 + guess * q3))) / slope
        if not low < following < high:
            break
        guess = following
    scale = speed * speed if returning > 0.0 else speed
    for _ in range(50):
        trial, _ = _attempt(y, first, place, guess)
        left = _left(trial, place, goal, returning)
        if abs(left) <= NEAR * scale:
            break
        if left > 0.0:
            low = guess
        else:
            high = guess
        slope = q1 + guess * (2.0 * q2 + guess * 3.0 * q3)
        guess -= left / slope if slope != 0.0 else 0.0
        if not low < guess < high:
            guess = 0.5 * (low + high)
    return trial


@kernel
def _drift(f: Four, place: Five) -> Four:
    """Return how the slips change with p under the friction f."""
    fx, ft, tx, ty = f
    rise, level = place[P_RISE], place[P_LEVEL]
    return (
        3.5 * fx + (1.0 - 2.5 * rise) * tx,
        (2.5 + rise * rise) * ft + (2.5 - rise) * ty + rise * level,
        (1.0 - 2.5 * rise) * fx + 3.5 * tx,
        (2.5 - rise) * ft + 3.5 * ty - level,
    )


@kernel
def _attempt(y: Ten, first: Four, place: Five, h: float) -> tuple[Ten, float]:
    """Return the state after the impulse h and an estimate of its error.

    Merson's method of order four: five stages, of which `first` is the friction in the first.
    """
    sx, st, ux, uy = y[NOSE_X], y[NOSE_T], y[BED_X], y[BED_Y]
    a0, a1, a2, a3 = _drift(first, place)
    g = h / 3.0
    f = _friction(sx + g * a0, st + g * a1, ux + g * a2, uy + g * a3, place)
    b0, b1, b2, b3 = _drift(f, place)
    g = h / 6.0
    b0, b1, b2, b3 = a0 + b0, a1 + b1, a2 + b2, a3 + b3
    f = _friction(sx + g * b0, st + g * b1, ux + g * b2, uy + g * b3, place)
    c0, c1, c2, c3 = _drift(f, place)
    g = h / 8.0
    b0, b1, b2, b3 = a0 + 3.0 * c0, a1 + 3.0 * c1, a2 + 3.0 * c2, a3 + 3.0 * c3
    third = _friction(sx + g * b0, st + g * b1, ux + g * b2, uy + g * b3, place)
    d0, d1, d2, d3 = _drift(third, place)
    g = h / 2.0
    b0 = sx + g * (a0 - 3.0 * c0 + 4.0 * d0)
    b1 = st + g * (a1 - 3.0 * c1 + 4.0 * d1)
    b2 = ux + g * (a2 - 3.0 * c2 + 4.0 * d2)
    b3 = uy + g * (a3 - 3.0 * c3 + 4.0 * d3)
    last = _friction(b0, b1, b2, b3, place)
    c0, c1, c2, c3 = _drift(last, place)
    g = h / 6.0
    nx = sx + g * (a0 + 4.0 * d0 + c0)
    nt = st + g * (a1 + 4.0 * d1 + c1)
    bx = ux + g * (a2 + 4.0 * d2 + c2)
    by = uy + g * (a3 + 4.0 * d3 + c3)
    # Simpson's rule, with Hermite's middle
    ends = uy - st + by - nt
    middle = 0.5 * ends + h / 8.0 * ((a3 - a1) - (c3 - c1))
    trial = (
        nx,
        nt,
        bx,
        by,
        y[FX] + g * (first[0] + 4.0 * third[0] + last[0]),
        y[FT] + g * (first[1] + 4.0 * third[1] + last[1]),
        y[TX] + g * (first[2] + 4.0 * third[2] + last[2]),
        y[TY] + g * (first[3] + 4.0 * third[3] + last[3]),
        y[WORK] + g * (ends + 4.0 * middle) / (1.0 + place[P_RISE]),
        y[PUSH] + h,
    )
    return trial, 0.2 * (abs(nx - b0) + abs(nt - b1) + abs(bx - b2) + abs(by - b3))


@kernel
def _life(y: Ten, friction: Four, place: Five) -> float:
    """Return the impulse after which the first of the slips that lessen would be gone."""
    dead = place[P_DEAD]
    sx, st, ux, uy = _drift(friction, place)
    nose = _ceases(y[NOSE_X], y[NOSE_T], sx, st, dead)
    return min(nose, _ceases(y[BED_X], y[BED_Y], ux, uy, dead))


@kernel
def _ceases(x: float, y: float, dx: float, dy: float, dead: float) -> float:
    square, slope = x * x + y * y, x * dx + y * dy
    return -square / slope if slope < 0.0 and square > dead * dead else inf


@kernel
def _still(y: Ten, place: Five) -> Ten:
    """Return the state with a slip that has died made exactly zero, as friction would at once."""
    rise, dead = place[P_RISE], place[P_DEAD]
    nx, nt, bx, by, fx, ft, tx, ty, work, push = y
    if bx**2 + by**2 <= dead * dead:
        px, py = -bx / 3.5, -by / 3.5
        tx += px
        ty += py
        nx += (1.0 - 2.5 * rise) * px
        nt += (2.5 - rise) * py
        bx = by = 0.0
    if nx**2 + nt**2 <= dead * dead:
        px, pt = -nx / 3.5, -nt / (2.5 + rise * rise)
        fx += px
        ft += pt
        bx += (1.0 - 2.5 * rise) * px
        by += (2.5 - rise) * pt
        nx = nt = 0.0
    return nx, nt, bx, by, fx, ft, tx, ty, work, push


@kernel
def _friction(sx: float, st: float, ux: float, uy: float, place: Five) -> Four:
    """Return the friction per p at the nose, along and upwards, and on the bed."""
    slip, slide = sx * sx + st * st, ux * ux + uy * uy
    dead = place[P_DEAD] * place[P_DEAD]
    if slip <= dead or slide <= dead:
        return _hold(sx, st, ux, uy, place)
    # both roots at once: the second waits for nothing
    over, under = 1.0 / sqrt(slip), 1.0 / sqrt(slide)
    part = -place[P_NOSE] * over
    fx, ft = part * sx, part * st
    part = -place[P_BED] * max(0.0, place[P_RISE] - ft * place[P_LEVEL]) * under
    return fx, ft, part * ux, part * uy


@kernel
def _within(x: float, y: float, size: float) -> tuple[float, float]:
    """Return (x, y), or where it is longer than `size`, its part of that length."""
    square = x * x + y * y
    if square <= size * size:
        return x, y
    part = size / sqrt(square)
    return part * x, part * y


@kernel
def _hold(sx: float, st: float, ux: float, uy: float, place: Five) -> Four:
    """Return the friction where a slip is zero.

    It holds the slip if it can; if not, it opposes the slip that begins: both are the fixed point
    of a projection onto what friction can do.
    """
    rise, level, bed = place[P_RISE], place[P_LEVEL], place[P_BED]
    slip, slide = sqrt(sx * sx + st * st), sqrt(ux * ux + uy * uy)
    slips, slides = slip > place[P_DEAD], slide > place[P_DEAD]
    fx = ft = tx = ty = 0.0
    if slips:
        fx, ft = -place[P_NOSE] * sx / slip, -place[P_NOSE] * st / slip
    elif slides:
        # were it to hold, the bed's push would follow from its own lift
        part = (2.5 - rise) * bed * uy / slide
        ft = (part - level) * rise / (2.5 + rise * rise + part * level)
        fx = (1.0 - 2.5 * rise) * bed * (rise - ft * level) * ux / slide / 3.5
        fx, ft = _within(fx, ft, place[P_NOSE])
    for _ in range(60):
        old_x, old_t = fx, ft
        pressed = bed * max(0.0, rise - ft * level)
        if slides:
            tx, ty = -pressed * ux / slide, -pressed * uy / slide
        else:
            _, _, dx, dy = _drift((fx, ft, 0.0, 0.0), place)
            tx, ty = _within(-dx / 3.5, -dy / 3.5, pressed)
        if slips:
            break
        dx, dt, _, _ = _drift((fx, ft, tx, ty), place)
        fx, ft = _within(fx - dx / 3.5, ft - dt / 3.5, place[P_NOSE])
        if abs(fx - old_x) + abs(ft - old_t) <= 1e-12:
            break
    return fx, ft, tx, ty


__all__ = ["mathavan"]
