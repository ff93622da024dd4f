"""What meets a ball in three dimensions: the bed, a nose, another ball.

One idea: restitution along the true normal and Coulomb friction across it, at most what stops the
slip (2/7 of mass times slip); a ball that lies on the bed and is pressed onto it cannot sink, so
the bed gives back the vertical part. Invariant: energy is never gained, the momentum of two balls
along the bed is exact, and spin about the vertical is unchanged by the bed.
"""

from __future__ import annotations

from math import sqrt
from typing import TYPE_CHECKING

from engine.geometry.kernel import kernel
from engine.physics.collide import friction, grip, kick, restitution, scale_spin, spin_energy
from engine.physics.rebound import bounce, restitution_at
from engine.physics.state import (
    ELASTIC,
    FLY,
    G_BALL_BALL,
    G_BED,
    G_GRAVITY,
    G_NOSE,
    HOP,
    KICK,
    MASS,
    N_RUB,
    RADIUS,
    SLIDING,
    SOFT,
    VX,
    VY,
    VZ,
    WX,
    WY,
    WZ,
    X,
    Y,
    Z,
)

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

LIGHT = 0.02
"""An approach (m/s) in the air below which a contact loses nothing: bounces do not pile up."""

UPRIGHT = 1e-9
"""A line of centres whose sine is less than this short of one stands upright."""

SKIM = 5e-3
"""A ball less than this (m) above the bed meets a nose by the bed's own model."""


@kernel
def meet_bed(ball: Floats, world: Floats) -> float:
    """Resolve a fall onto the bed; return its speed (m/s). V_z is zero where the ball stays down.

    Restitution and friction as Alciatore TP B.10 has them: the slip loses at most
    min(mu (1 + e) w, 2/7 |u|), and the end of a slide stays what it was.
    """
    down = max(-ball[VZ], 0.0)
    rise = world[G_BED] * down
    if rise * rise <= 2.0 * world[G_GRAVITY] * HOP:
        rise = 0.0
    ball[VZ], ball[Z] = rise, ball[RADIUS]
    ux, uy = ball[VX] - ball[RADIUS] * ball[WY], ball[VY] + ball[RADIUS] * ball[WX]
    slip = sqrt(ux * ux + uy * uy)
    if slip > 0.0:
        change = min(ball[SLIDING] * (down + rise), slip / 3.5)
        ux, uy = ux / slip, uy / slip
        ball[VX] -= change * ux
        ball[VY] -= change * uy
        ball[WX] -= 2.5 * change / ball[RADIUS] * uy
        ball[WY] += 2.5 * change / ball[RADIUS] * ux
    return down


@kernel
def _turn(ball: Floats, nx: float, ny: float, nz: float, jx: float, jy: float, jz: float) -> None:
    """Turn a ball by the impulse j (N s) at its surface in the direction n."""
    lever = 2.5 / (ball[MASS] * ball[RADIUS])
    ball[WX] += lever * (ny * jz - nz * jy)
    ball[WY] += lever * (nz * jx - nx * jz)
    ball[WZ] += lever * (nx * jy - ny * jx)


@kernel
def _push(ball: Floats, jx: float, jy: float, jz: float) -> None:
    ball[VX] += jx / ball[MASS]
    ball[VY] += jy / ball[MASS]
    ball[VZ] += jz / ball[MASS]


@kernel
def meet_nose(ball: Floats, world: Floats, nose: Floats, px: float, py: float) -> float:
    """Resolve a hit on the nose's point above (px, py); return the closing speed, m/s."""
    dx, dy, dz = px - ball[X], py - ball[Y], world[G_NOSE] - ball[Z]
    level = sqrt(dx * dx + dy * dy)
    reach = sqrt(level * level + dz * dz)
    nx, ny, nz = dx / reach, dy / reach, dz / reach
    speed = ball[VX] * nx + ball[VY] * ny + ball[VZ] * nz
    if ball[Z] < ball[RADIUS] + SKIM and level > 0.0:
        ix, iy = dx / level, dy / level
        if ball[VX] * ix + ball[VY] * iy >= SOFT:
            bounce(ball, world, nose, ix, iy)
    left = ball[VX] * nx + ball[VY] * ny + ball[VZ] * nz
    if left > 0.0:
        _off_nose(ball, nose, nx, ny, nz, left)
    return speed


@kernel
def _off_nose(ball: Floats, nose: Floats, nx: float, ny: float, nz: float, speed: float) -> None:
    lively = restitution_at(nose, speed) if speed >= LIGHT else 1.0
    mass, radius = ball[MASS], ball[RADIUS]
    pressed = (1.0 + lively) * speed * mass
    sx = ball[VX] + radius * (ball[WY] * nz - ball[WZ] * ny) - speed * nx
    sy = ball[VY] + radius * (ball[WZ] * nx - ball[WX] * nz) - speed * ny
    sz = ball[VZ] + radius * (ball[WX] * ny - ball[WY] * nx) - speed * nz
    _push(ball, -pressed * nx, -pressed * ny, -pressed * nz)
    slip = sqrt(sx * sx + sy * sy + sz * sz)
    if slip > 1e-15:
        rub = -min(nose[N_RUB] * pressed, mass * slip / 3.5) / slip
        _push(ball, rub * sx, rub * sy, rub * sz)
        _turn(ball, nx, ny, nz, rub * sx, rub * sy, rub * sz)


@kernel
def nearing(one: Floats, two: Floats) -> float:
    """Return how fast two balls near each other along their line of centres, m/s."""
    nx, ny, nz = two[X] - one[X], two[Y] - one[Y], two[Z] - one[Z]
    along = (one[VX] - two[VX]) * nx + (one[VY] - two[VY]) * ny + (one[VZ] - two[VZ]) * nz
    return along / sqrt(nx * nx + ny * ny + nz * nz)


@kernel
def meet_ball(one: Floats, two: Floats, kind_one: int, kind_two: int, world: Floats) -> float:
    """Resolve a meeting of which at least one flies; return the speed of approach, m/s.

    The kinds are those of both before; a ball that lies on the bed leaves it only upwards.
    """
    nx, ny, nz = two[X] - one[X], two[Y] - one[Y], two[Z] - one[Z]
    reach = sqrt(nx * nx + ny * ny + nz * nz)
    nx, ny, nz = nx / reach, ny / reach, nz / reach
    speed = nearing(one, two)
    light = (1.0 - (nz * nz if kind_one != FLY and nz > 0.0 else 0.0)) / one[MASS]
    light += (1.0 - (nz * nz if kind_two != FLY and nz < 0.0 else 0.0)) / two[MASS]
    leaving = restitution(one, two, world, speed) * speed if speed >= LIGHT else speed
    if speed < KICK:
        leaving, factor = kick(speed, 1.0 / light, spin_energy(one) + spin_energy(two))
        scale_spin(one, factor)
        scale_spin(two, factor)
    if speed < LIGHT and 1.0 - abs(nz) < UPRIGHT:
        leaving = _topple(one, two, leaving, light)
    impulse = (speed + leaving) / light
    sx, sy, sz = _slip(one, two, nx, ny, nz, speed)
    _push(one, -impulse * nx, -impulse * ny, -impulse * nz)
    _push(two, impulse * nx, impulse * ny, impulse * nz)
    slip = sqrt(sx * sx + sy * sy + sz * sz)
    if world[G_BALL_BALL] != ELASTIC and slip > 1e-15:
        reduced = one[MASS] * two[MASS] / (one[MASS] + two[MASS])
        rubbed = grip(one, two) * friction(world, slip) * impulse
        rub = -min(rubbed, reduced * slip / 3.5) / slip
        _push(one, rub * sx, rub * sy, rub * sz)
        _push(two, -rub * sx, -rub * sy, -rub * sz)
        _turn(one, nx, ny, nz, rub * sx, rub * sy, rub * sz)
        _turn(two, nx, ny, nz, rub * sx, rub * sy, rub * sz)
    _keep_down(one, kind_one, world)
    _keep_down(two, kind_two, world)
    return speed


@kernel
def _topple(one: Floats, two: Floats, leaving: float, light: float) -> float:
    """Push two balls of which one stands on the other apart along x; return what speed is left.

    Nothing else would ever end such a stack. The push costs a hundredth of the bounce's energy.
    """
    reduced = one[MASS] * two[MASS] / (one[MASS] + two[MASS])
    push = 0.1 * leaving / sqrt(reduced * light)
    along = one[VX] - two[VX]
    if abs(along) > leaving:
        return leaving
    push = push if along >= 0.0 else -push
    cost = reduced * light * ((along + push) ** 2 - along * along)
    one[VX] += reduced * push / one[MASS]
    two[VX] -= reduced * push / two[MASS]
    return sqrt(max(leaving * leaving - cost, 0.0))


@kernel
def _slip(
    one: Floats, two: Floats, nx: float, ny: float, nz: float, speed: float
) -> tuple[float, float, float]:
    """Return the velocity (m/s) of the first ball's surface against the second's."""
    wx = one[RADIUS] * one[WX] + two[RADIUS] * two[WX]
    wy = one[RADIUS] * one[WY] + two[RADIUS] * two[WY]
    wz = one[RADIUS] * one[WZ] + two[RADIUS] * two[WZ]
    return (
        one[VX] - two[VX] + wy * nz - wz * ny - speed * nx,
        one[VY] - two[VY] + wz * nx - wx * nz - speed * ny,
        one[VZ] - two[VZ] + wx * ny - wy * nx - speed * nz,
    )


@kernel
def _keep_down(ball: Floats, kind: int, world: Floats) -> None:
    """Let a ball on the bed rise only where it is worth it."""
    if kind != FLY and (ball[VZ] <= 0.0 or ball[VZ] ** 2 <= 2.0 * world[G_GRAVITY] * HOP):
        ball[VZ] = 0.0


__all__ = ["meet_ball", "meet_bed", "meet_nose", "nearing"]
