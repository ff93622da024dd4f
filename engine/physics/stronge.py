"""The nose model `stronge`: an impact with springs along and across the line of contact.

One idea: nose and ball touch through a spring along the normal and one across it, so that the
contact may stick and the stored push across may throw the slip back (Stronge, Impact Mechanics,
chapter 5: collinear impact of compliant bodies). The normal spring unloads with e^2 of its
stiffness's work; its force is a half sine, slower by e on the way out, so the slip and the spring
across follow in closed form piece by piece: sliding where friction is at its limit, swinging where
it sticks. A ball is as heavy across in every direction (2/7 of its mass), so in space the slip
keeps its line and the planar answer is exact. As in Han 2005 the ball is free while the nose pushes
and its vertical velocity is dropped. Invariant: homogeneous in speed, no energy is gained.
"""

from __future__ import annotations

from math import acos, cos, pi, sin, sqrt
from typing import TYPE_CHECKING

from engine.geometry.kernel import kernel
from engine.physics.frame import enter, leave

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

ACROSS = 3.5
"""How much easier a solid ball's surface moves across than its centre along: 1 + 5/2."""

FREQUENCY_RATIO = 1.7
"""Of the springs across and along, for solids of Poisson's ratio 0.3: Stronge's eta^2 = 1.21."""

SCAN = 0.03
"""Step of time, in the normal spring's radians, within which a stick does not end twice."""

TURNS = 40
"""Changes between slip and stick after which no more are looked for; three are usual."""


@kernel
def _force(time: float, e: float) -> float:
    """Return the normal force at a time, both made dimensionless: 1 at most, 0 at the ends."""
    if time <= 0.5 * pi:
        return sin(time)
    return sin(time / e + 0.5 * pi * (1.0 - 1.0 / e))


@kernel
def _pushed(time: float, e: float) -> float:
    """Return the normal impulse up to a time: 1 when compression ends, 1 + e at the end."""
    if time <= 0.5 * pi:
        return 1.0 - cos(time)
    return 1.0 - e * cos(time / e + 0.5 * pi * (1.0 - 1.0 / e))


@kernel
def _slip_ends(time: float, speed: float, grip: float, e: float, square: float) -> float:
    """Return when a slip that goes on at `time` with the ball's `speed` ends, or the impact's end.

    `speed` counts along the slip. In each half of the impact the slip is a constant and a cosine.
    """
    end = 0.5 * pi * (1.0 + e)
    rest = speed + grip * (_pushed(time, e) - 1.0)
    if time < 0.5 * pi:
        swing = grip * (1.0 - 1.0 / square)
        if swing > 0.0 and -swing < rest < 0.0:
            found = acos(-rest / swing)
            if found > time:
                return found
        if rest < 0.0:
            return 0.5 * pi
    if e > 0.0:
        swing = grip * (e - 1.0 / (e * square))
        if swing > 0.0 and 0.0 <= rest < swing:
            found = e * (acos(-rest / swing) - 0.5 * pi * (1.0 - 1.0 / e))
            if found > time:
                return min(found, end)
    return end


@kernel
def _spare(time: float, start: float, y: float, v: float, grip: float, e: float, w: float) -> float:
    """Return how much more friction could hold while the contact sticks since `start`."""
    angle = w * (time - start)
    return grip * _force(time, e) - abs(w * w * y * cos(angle) + w * v * sin(angle))


@kernel
def _stick_ends(start: float, y: float, v: float, grip: float, e: float, w: float) -> float:
    """Return when friction no longer holds the spring, or the impact's end."""
    end = 0.5 * pi * (1.0 + e)
    low = start
    while low < end:
        high = min(low + SCAN, end)
        if _spare(high, start, y, v, grip, e, w) < 0.0:
            break
        low = high
    else:
        return end
    if low == start and _spare(0.5 * (low + high), start, y, v, grip, e, w) < 0.0:
        return start
    for _ in range(60):
        middle = 0.5 * (low + high)
        if not low < middle < high:
            break
        if _spare(middle, start, y, v, grip, e, w) < 0.0:
            high = middle
        else:
            low = middle
    return low


@kernel
def slip_after(slip: float, speed: float, e: float, friction: float, ratio: float) -> float:
    """Return the slip (m/s) after an impact with this slip and normal speed (m/s, above zero).

    `ratio` is the frequency of the spring across over that along; the normal speed becomes `e`
    times its own. The answer is negative where the slip is thrown back.
    """
    grip, square = ACROSS * friction, ratio * ratio
    sign = 1.0 if slip >= 0.0 else -1.0
    v, y, time, end = abs(slip) / speed, 0.0, 0.0, 0.5 * pi * (1.0 + e)
    way = 1.0
    slips = v * square >= grip
    for _ in range(TURNS):
        if slips:
            until = _slip_ends(time, way * v, grip, e, square)
            v -= way * grip * (_pushed(until, e) - _pushed(time, e))
            y = way * grip * _force(until, e) / square
        else:
            until = _stick_ends(time, y, v, grip, e, ratio)
            angle = ratio * (until - time)
            y, v = (
                y * cos(angle) + v / ratio * sin(angle),
                v * cos(angle) - y * ratio * sin(angle),
            )
            way = 1.0 if y >= 0.0 else -1.0
        if until >= end:
            break
        slips, time = not slips, until
    return sign * v * speed


@kernel
def stronge(
    ball: Floats,
    place: tuple[float, float],
    friction: float,
    ix: float,
    iy: float,
    e: float,
    ratio: float,
) -> None:
    """Resolve a hit on a nose in the direction (ix, iy).

    `place` is sine and cosine of the angle above its centre at which it touches the ball.
    """
    rise, level = place
    along, into, spin_x, spin_y, spin_z = enter(ball, ix, iy)
    slip_x = along + spin_y * rise - spin_z * level
    slip_t = spin_x - into * rise
    slip, speed = sqrt(slip_x * slip_x + slip_t * slip_t), into * level
    px = pt = 0.0
    if slip > 0.0:
        push = (slip_after(slip, speed, e, friction, ratio) - slip) / ACROSS
        px, pt = push * slip_x / slip, push * slip_t / slip
    along += px
    into = min(into - (1.0 + e) * speed * level - pt * rise, 0.0)
    spin_x += 2.5 * pt
    spin_y += 2.5 * rise * px
    spin_z -= 2.5 * level * px
    leave(ball, ix, iy, along, into, spin_x, spin_y, spin_z)


__all__ = ["FREQUENCY_RATIO", "slip_after", "stronge"]
