"""What one meeting of two balls does to them: models `elastic` and `frictional`.

One idea: an impulse along the line of centres by restitution, and across it by Coulomb friction
that never more than stops the slip (Alciatore TP A.14; limit 2/7 of the reduced mass times slip).
Balls stay on the bed: the vertical part turns spin but lifts nothing. Invariant: momentum in the
plane is exact, energy is never gained, and swapping the two balls changes no bit.
"""

from __future__ import annotations

from math import exp, sqrt
from typing import TYPE_CHECKING

from engine.geometry.kernel import kernel
from engine.physics.state import (
    ELASTIC,
    G_BALL_BALL,
    G_DECAY,
    G_E,
    G_E_KNEE,
    G_E_SLOPE,
    G_FLOOR,
    G_RISE,
    GRIP,
    KICK,
    LIVELY,
    MASS,
    RADIUS,
    SOFT,
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
def friction(world: Floats, slip: float) -> float:
    """Return the friction coefficient at a slip speed (m/s); Alciatore TP A.28 for its form."""
    mu: float = world[G_FLOOR] + world[G_RISE] * exp(-world[G_DECAY] * slip)
    return mu


@kernel
def restitution(one: Floats, two: Floats, world: Floats, speed: float) -> float:
    """Return the restitution of two balls that near at a speed (m/s): the mean of both."""
    e: float = world[G_E] + 0.5 * (one[LIVELY] + two[LIVELY])
    if world[G_E_SLOPE] == 0.0:
        return e
    return min(max(e - world[G_E_SLOPE] * max(0.0, speed - world[G_E_KNEE]), 0.0), 1.0)


@kernel
def grip(one: Floats, two: Floats) -> float:
    """Return by what factor two balls rub more than others: the mean of both."""
    factor: float = 1.0 + 0.5 * (one[GRIP] + two[GRIP])
    return factor


@kernel
def closing_speed(one: Floats, two: Floats) -> float:
    """Return how fast two balls near each other along their line of centres, m/s."""
    nx, ny = two[X] - one[X], two[Y] - one[Y]
    gap = sqrt(nx * nx + ny * ny)
    return ((one[VX] - two[VX]) * nx + (one[VY] - two[VY]) * ny) / gap


@kernel
def spin_energy(ball: Floats) -> float:
    """Return the energy of rotation, J."""
    spin = ball[WX] * ball[WX] + ball[WY] * ball[WY] + ball[WZ] * ball[WZ]
    return 0.2 * ball[MASS] * ball[RADIUS] * ball[RADIUS] * spin


@kernel
def scale_spin(ball: Floats, factor: float) -> None:
    """Multiply all of the ball's spin."""
    ball[WX] *= factor
    ball[WY] *= factor
    ball[WZ] *= factor


@kernel
def find_rub(
    one: Floats, two: Floats, world: Floats, nx: float, ny: float, pressed: float, share: float
) -> tuple[float, float]:
    """Return the friction impulse (N s) across and up that goes with a normal one `pressed`.

    `share` (at most 1) is the part of the stopping impulse that may act.
    """
    reduced = one[MASS] * two[MASS] / (one[MASS] + two[MASS])
    wx = one[RADIUS] * one[WX] + two[RADIUS] * two[WX]
    wy = one[RADIUS] * one[WY] + two[RADIUS] * two[WY]
    wz = one[RADIUS] * one[WZ] + two[RADIUS] * two[WZ]
    along = (one[VY] - two[VY]) * nx - (one[VX] - two[VX]) * ny + wz
    upward = wx * ny - wy * nx
    slip = sqrt(along * along + upward * upward)
    if slip <= 1e-15:
        return 0.0, 0.0
    impulse = grip(one, two) * friction(world, slip) * pressed
    impulse = min(impulse, share * slip * reduced / 3.5)
    return -impulse * along / slip, -impulse * upward / slip


@kernel
def give_rub(one: Floats, two: Floats, nx: float, ny: float, across: float, up: float) -> None:
    """Apply a friction impulse (N s) to both balls; what goes up turns but does not lift."""
    one[VX] -= across * ny / one[MASS]
    one[VY] += across * nx / one[MASS]
    two[VX] += across * ny / two[MASS]
    two[VY] -= across * nx / two[MASS]
    _twist(one, nx, ny, across, up)
    _twist(two, nx, ny, across, up)


@kernel
def _twist(ball: Floats, nx: float, ny: float, across: float, up: float) -> None:
    lever = 2.5 / (ball[MASS] * ball[RADIUS])
    ball[WX] += lever * up * ny
    ball[WY] -= lever * up * nx
    ball[WZ] += lever * across


@kernel
def strike_apart(one: Floats, two: Floats, world: Floats) -> float:
    """Resolve one meeting; return the speed of approach (m/s)."""
    nx, ny = two[X] - one[X], two[Y] - one[Y]
    gap = sqrt(nx * nx + ny * ny)
    nx, ny = nx / gap, ny / gap
    speed = (one[VX] - two[VX]) * nx + (one[VY] - two[VY]) * ny
    reduced = one[MASS] * two[MASS] / (one[MASS] + two[MASS])
    leaving = restitution(one, two, world, speed) * speed
    if speed < SOFT:
        leaving = _rest_apart(one, two, speed, reduced)
    impulse = (speed + leaving) * reduced
    one[VX] -= impulse * nx / one[MASS]
    one[VY] -= impulse * ny / one[MASS]
    two[VX] += impulse * nx / two[MASS]
    two[VY] += impulse * ny / two[MASS]
    if world[G_BALL_BALL] != ELASTIC:
        across, up = find_rub(one, two, world, nx, ny, impulse, 1.0)
        give_rub(one, two, nx, ny, across, up)
    return speed


@kernel
def _rest_apart(one: Floats, two: Floats, speed: float, reduced: float) -> float:
    """Return the leaving speed of a resting contact, taking any gain from the balls' spin."""
    if speed >= KICK:
        return speed
    store = spin_energy(one) + spin_energy(two)
    leaving, factor = kick(speed, reduced, store)
    scale_spin(one, factor)
    scale_spin(two, factor)
    return leaving


@kernel
def kick(speed: float, mass: float, store: float) -> tuple[float, float]:
    """Return the speed of a resting bounce and what is left of the spin that pays for it.

    At most half of the energy `store` (J) is spent; `mass` is the one the speed belongs to.
    """
    gain = 0.5 * mass * (KICK * KICK - speed * speed)
    if 2.0 * gain <= store:
        return KICK, sqrt(1.0 - gain / store)
    square = max(speed, 0.0) ** 2 + store / mass * (1.0 - 1e-12)
    return sqrt(square), sqrt(0.5)


__all__ = [
    "closing_speed",
    "find_rub",
    "friction",
    "give_rub",
    "grip",
    "kick",
    "restitution",
    "scale_spin",
    "spin_energy",
    "strike_apart",
]
