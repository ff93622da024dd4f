"""What a nose does to a ball: models `restitution`, `han-2005` and `mathavan-2010`.

One idea: in the frame X along the nose, Y into it, Z up, the nose touches the ball at height h,
so at the angle theta above its centre, sin(theta) = (h - R) / R. Invariant: the ball leaves with
no speed into the nose, stays on the bed and gains no energy.
"""

from __future__ import annotations

from math import atan2, sqrt
from typing import TYPE_CHECKING

from engine.geometry.kernel import kernel
from engine.physics.collide import kick, scale_spin, spin_energy
from engine.physics.frame import enter, leave
from engine.physics.mathavan import mathavan
from engine.physics.state import (
    G_NOSE,
    HAN,
    KICK,
    MASS,
    N_BEND,
    N_E,
    N_KNEE,
    N_LEAST,
    N_MODEL,
    N_RUB,
    N_RUB_SLOPE,
    N_SIZE,
    N_SLOPE,
    N_UPRIGHT,
    RADIUS,
    REACH,
    RESTITUTION,
    SOFT,
    VX,
    VY,
)

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

HUG = 0.01
"""The speed of a hop along a nose that curves round the bed, as a share of the speed along it."""


@kernel
def bounce(ball: Floats, world: Floats, nose: Floats, ix: float, iy: float) -> float:
    """Resolve a hit on a nose that lies in the direction (ix, iy); return the normal speed."""
    speed = ball[VX] * ix + ball[VY] * iy
    if speed < SOFT:
        leaving = _rest(ball, speed)
        ball[VX] -= (speed + leaving) * ix
        ball[VY] -= (speed + leaving) * iy
        return speed
    restitution = restitution_at(nose, speed)
    mu = friction_at(nose, speed, ball[VX] * iy - ball[VY] * ix)
    if nose[N_MODEL] == RESTITUTION:
        ball[VX] -= (1.0 + restitution) * speed * ix
        ball[VY] -= (1.0 + restitution) * speed * iy
    elif nose[N_MODEL] == HAN:
        _han(ball, lean(ball, world, nose), mu, ix, iy, restitution)
    else:
        mathavan(ball, lean(ball, world, nose), mu, ix, iy, restitution)
    return speed


@kernel
def restitution_at(nose: Floats, speed: float) -> float:
    """Return a nose's restitution at a normal speed (m/s)."""
    over = max(0.0, speed - nose[N_KNEE])
    restitution: float = nose[N_E] - nose[N_SLOPE] * over
    if nose[N_BEND] != 0.0:
        restitution -= nose[N_BEND] * over * over
    return min(max(restitution, nose[N_LEAST]), 1.0)


@kernel
def friction_at(nose: Floats, speed: float, along: float) -> float:
    """Return a nose's friction for speeds into and along it, which falls with the incidence."""
    mu: float = nose[N_RUB]
    if nose[N_RUB_SLOPE] == 0.0:
        return mu
    return max(mu - nose[N_RUB_SLOPE] * atan2(abs(along), speed), 0.0)


@kernel
def meet_nose(ball: Floats, world: Floats, nose: Floats, ix: float, iy: float) -> float:
    """Resolve a hit on a nose as `bounce` does, save that a ball may run along one round the bed.

    Such a ball would come to thousands of ever smaller bounces. It is carried by hops whose speed
    off the nose is `HUG` of its speed along it, which pays for it; they are no hits.
    """
    speed = ball[VX] * ix + ball[VY] * iy
    along = ball[VX] * iy - ball[VY] * ix
    hop = HUG * abs(along)
    if nose[N_SIZE] < 0.0 and hop > KICK and speed < 2.0 * hop:
        share = sqrt(min(along * along + speed * speed - hop * hop, along * along)) / abs(along)
        ball[VX] = share * along * iy - hop * ix
        ball[VY] = -share * along * ix - hop * iy
        return 0.0
    return bounce(ball, world, nose, ix, iy)


@kernel
def lean(ball: Floats, world: Floats, nose: Floats) -> tuple[float, float]:
    """Return sine and cosine of the angle above its centre at which a nose touches the ball."""
    if nose[N_UPRIGHT] != 0.0:
        return 0.0, 1.0
    return (world[G_NOSE] - ball[RADIUS]) / ball[RADIUS], ball[REACH] / ball[RADIUS]


@kernel
def _rest(ball: Floats, speed: float) -> float:
    """Return the leaving speed of a resting contact, taking any gain from the ball's spin."""
    if speed >= KICK:
        return speed
    leaving, factor = kick(speed, ball[MASS], spin_energy(ball))
    scale_spin(ball, factor)
    return leaving


@kernel
def _han(
    ball: Floats,
    place: tuple[float, float],
    friction: float,
    ix: float,
    iy: float,
    restitution: float,
) -> None:
    """Han 2005 with the corrected equations: one free-body impulse, stick or slip as a whole."""
    rise, level = place
    along, into, spin_x, spin_y, spin_z = enter(ball, ix, iy)
    slip_x = along + spin_y * rise - spin_z * level
    slip_t = spin_x - into * rise
    slip = sqrt(slip_x * slip_x + slip_t * slip_t)
    pressed = (1.0 + restitution) * into * level
    push = min(friction * pressed, slip / 3.5)
    px = -push * slip_x / slip if slip > 0.0 else 0.0
    pt = -push * slip_t / slip if slip > 0.0 else 0.0
    along += px
    into -= pressed * level + pt * rise
    spin_x += 2.5 * pt
    spin_y += 2.5 * rise * px
    spin_z -= 2.5 * level * px
    leave(ball, ix, iy, along, into, spin_x, spin_y, spin_z)


__all__ = ["HUG", "bounce", "friction_at", "lean", "meet_nose", "restitution_at"]
