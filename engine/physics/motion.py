"""How a ball moves between events: slide, roll, spin and rest, each a closed form.

One idea: on flat cloth every piece is a parabola with constant angular acceleration (Coriolis
1835; Leckie & Greenspan 2006), so a piece is its starting values and two constant rates. `begin`
chooses the piece and snaps rolling exactly: w = (z x v) / R. Invariant: the row's END is where
its formula ceases to hold, and no one evaluates it beyond.
"""

from __future__ import annotations

from math import inf, sqrt
from typing import TYPE_CHECKING

from engine.geometry.kernel import kernel
from engine.physics.state import (
    AX,
    AY,
    BX,
    BY,
    CEASE,
    END,
    FAST,
    G_GRAVITY,
    G_MOTION,
    G_THRESHOLD,
    RADIUS,
    REST,
    ROLL,
    ROLLING_MU,
    SLIDE,
    SLIDING,
    SLOWING,
    SPIN,
    STILL,
    T0,
    TWO_SPEED,
    VX,
    VY,
    WX,
    WY,
    WZ,
    X,
    Y,
)

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


@kernel
def side_spin(ball: Floats, t: float) -> float:
    """Return w_z at absolute time `t`: a linear decay that ends at zero."""
    spin: float = ball[WZ]
    if spin == 0.0 or t >= ball[CEASE]:
        return 0.0
    lost = ball[SLOWING] * (t - ball[T0])
    return max(spin - lost, 0.0) if spin > 0.0 else min(spin + lost, 0.0)


@kernel
def place_at(ball: Floats, t: float) -> tuple[float, float]:
    """Return where the ball is at absolute time `t`, by its own formula."""
    s = t - ball[T0]
    x = ball[X] + s * (ball[VX] + 0.5 * s * ball[AX])
    return x, ball[Y] + s * (ball[VY] + 0.5 * s * ball[AY])


@kernel
def carry(ball: Floats, t: float) -> None:
    """Move the row's origin to absolute time `t`, by its own formula; the kind stays."""
    s = t - ball[T0]
    ball[WZ] = side_spin(ball, t)
    ball[X] += s * (ball[VX] + 0.5 * s * ball[AX])
    ball[Y] += s * (ball[VY] + 0.5 * s * ball[AY])
    ball[VX] += s * ball[AX]
    ball[VY] += s * ball[AY]
    ball[WX] += s * ball[BX]
    ball[WY] += s * ball[BY]
    ball[T0] = t


@kernel
def begin(ball: Floats, world: Floats) -> int:
    """Choose the piece that starts from the row's r, v, w at T0; fill rates and END."""
    radius, rate = ball[RADIUS], ball[SLOWING]
    ball[CEASE] = ball[T0] + abs(ball[WZ]) / rate
    speed = sqrt(ball[VX] * ball[VX] + ball[VY] * ball[VY])
    if world[G_MOTION] == TWO_SPEED:
        if speed > STILL:
            return _two_speed(ball, world, speed)
        return _stand(ball)
    ux, uy = ball[VX] - radius * ball[WY], ball[VY] + radius * ball[WX]
    slip = sqrt(ux * ux + uy * uy)
    if slip > STILL:
        push = ball[SLIDING] * world[G_GRAVITY]
        ball[AX], ball[AY] = -push * ux / slip, -push * uy / slip
        twist = 2.5 * push / radius
        ball[BX], ball[BY] = -twist * uy / slip, twist * ux / slip
        ball[END] = ball[T0] + slip / (3.5 * push)
        return SLIDE
    if speed > STILL:
        return _roll(ball, ball[ROLLING_MU] * world[G_GRAVITY], speed, 0.0)
    return _stand(ball)


@kernel
def _roll(ball: Floats, push: float, speed: float, until: float) -> int:
    radius = ball[RADIUS]
    ball[WX], ball[WY] = -ball[VY] / radius, ball[VX] / radius
    ball[AX], ball[AY] = -push * ball[VX] / speed, -push * ball[VY] / speed
    ball[BX], ball[BY] = -ball[AY] / radius, ball[AX] / radius
    ball[END] = ball[T0] + (speed - until) / push
    return ROLL if until == 0.0 else FAST


@kernel
def _two_speed(ball: Floats, world: Floats, speed: float) -> int:
    """Choose the 2012 report's branch: full friction above the threshold, rolling below."""
    if speed > world[G_THRESHOLD] + STILL:
        return _roll(ball, ball[SLIDING] * world[G_GRAVITY], speed, world[G_THRESHOLD])
    return _roll(ball, ball[ROLLING_MU] * world[G_GRAVITY], speed, 0.0)


@kernel
def _stand(ball: Floats) -> int:
    ball[VX] = ball[VY] = ball[WX] = ball[WY] = 0.0
    ball[AX] = ball[AY] = ball[BX] = ball[BY] = 0.0
    if ball[WZ] != 0.0:
        ball[END] = ball[CEASE]
        return SPIN
    ball[END] = inf
    return REST


@kernel
def finish(ball: Floats, world: Floats, kind: int) -> int:
    """Begin the piece that follows `kind` at its END, constructing the state exactly."""
    radius, end = ball[RADIUS], ball[END]
    if kind == SLIDE:
        # Coriolis: the end of slip depends on the start alone, not on the cloth
        vx = (5.0 * ball[VX] + 2.0 * radius * ball[WY]) / 7.0
        vy = (5.0 * ball[VY] - 2.0 * radius * ball[WX]) / 7.0
        carry(ball, end)
        ball[VX], ball[VY] = vx, vy
        ball[WX], ball[WY] = -vy / radius, vx / radius
    elif kind == FAST:
        speed = sqrt(ball[VX] * ball[VX] + ball[VY] * ball[VY])
        vx, vy = ball[VX] / speed, ball[VY] / speed
        carry(ball, end)
        ball[VX], ball[VY] = vx * world[G_THRESHOLD], vy * world[G_THRESHOLD]
    elif kind == ROLL:
        carry(ball, end)
        ball[VX] = ball[VY] = ball[WX] = ball[WY] = 0.0
    else:
        carry(ball, end)
        ball[WZ] = 0.0
    return begin(ball, world)


__all__ = ["begin", "carry", "finish", "place_at", "side_spin"]
