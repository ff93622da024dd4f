"""What the cue does to the ball: the model `point`.

One idea: one impulse at the tip's point of contact, along the cue (Leckie & Greenspan 2006;
Alciatore TP A.30), turned aside by squirt (TP A.31). Where the cue is raised, the bed answers the
downward part at once, with restitution and friction, and the ball flies where that is worth it.
Invariant: the tip's grip is never exceeded; beyond the miscue limit the tip slips off and the
impulse turns away from the cue's line.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import asin, atan2, cos, hypot, isfinite, pi, sin, sqrt
from typing import TYPE_CHECKING

from engine.physics.state import HOP

if TYPE_CHECKING:
    from engine.physics.world import Ball, Cloth, Cue, Strike


@dataclass(frozen=True, slots=True)
class Motion:
    """A ball's velocity (m/s) along the bed and its spin (rad/s).

    `rise` is its speed upwards (m/s), and `height` (m) how high above the bed it is.
    """

    velocity: tuple[float, float]
    spin: tuple[float, float, float]
    rise: float = 0.0
    height: float = 0.0


def miscue_limit(cue: Cue) -> float:
    """Return the greatest offset (ball radii) at which the tip grips: mu / sqrt(1 + mu^2)."""
    return cue.tip_friction / sqrt(1.0 + cue.tip_friction**2)


def axis_offset(offset: float, radius: float, tip_radius: float) -> float:
    """Return how far beside the ball's centre (ball radii) the axis of a cue runs.

    A round tip touches at `offset` radii nearer to the centre than its axis, since the two
    spheres touch on the line of their centres: axis / contact = (R + r) / R.
    """
    return offset * (radius + tip_radius) / radius


def squirt_angle(side: float, end_mass_ratio: float) -> float:
    """Return the angle (rad, counter-clockwise) by which side spin turns the ball's way.

    TP A.31: tan(alpha) = (5/2) a sqrt(1 - a^2) / (1 + m_r + (5/2)(1 - a^2)), away from the side.
    """
    left = 1.0 - side * side
    return atan2(2.5 * side * sqrt(left), 1.0 + end_mass_ratio + 2.5 * left)


def strike_ball(
    ball: Ball, cue: Cue, cloth: Cloth, strike: Strike, *, flies: bool = True
) -> Motion:
    """Return how the ball starts; raises ValueError where the tip cannot meet the ball.

    Unless it `flies`, the bed takes all of the downward speed.
    """
    return _press(ball, cloth, tip_blow(ball, cue, strike), flies=flies)


def tip_blow(ball: Ball, cue: Cue, strike: Strike) -> Motion:
    """Return what the tip alone gives to the ball, before the bed answers: `rise` is not above 0.

    Raises ValueError where the tip cannot meet the ball.
    """
    _check(strike)
    offset, miss = hypot(strike.side, strike.follow), 0.0
    side, follow = strike.side, strike.follow
    limit = miscue_limit(cue)
    if offset > limit:
        miss = asin(offset) - asin(limit)
        side, follow = side * limit / offset, follow * limit / offset
    arm = 2.5 * (side * side + follow * follow)
    pushed = (1.0 + cue.tip_restitution) * strike.speed * cos(miss)
    speed = pushed / (1.0 + ball.mass / cue.mass + arm)
    level, down = cos(strike.elevation), sin(strike.elevation)
    aside = squirt_angle(side, cue.end_mass_ratio)
    if offset > limit:
        aside += miss * strike.side / offset
    way = strike.heading + aside
    velocity = (speed * level * cos(way), speed * level * sin(way))
    turn = 2.5 * speed / ball.radius
    ahead, right, up = side * down * turn, -follow * turn, side * level * turn
    c, s = cos(strike.heading), sin(strike.heading)
    # the cue's right-hand side is (sin, -cos); follow turns the ball about its left-hand side
    spin = (ahead * c + right * s, ahead * s - right * c, up)
    return Motion(velocity, spin, 0.0 - speed * down)


def _check(strike: Strike) -> None:
    total = strike.speed + strike.heading + strike.elevation + strike.side + strike.follow
    if not isfinite(total) or strike.speed < 0.0:
        message = f"a strike needs finite numbers and no negative speed: {strike}"
        raise ValueError(message)
    if hypot(strike.side, strike.follow) >= 1.0:
        message = f"the tip misses the ball: offset ({strike.side}, {strike.follow}) radii"
        raise ValueError(message)
    if not 0.0 <= strike.elevation <= pi / 2:
        message = f"the cue's elevation lies between 0 and pi/2, not at {strike.elevation}"
        raise ValueError(message)


def _press(ball: Ball, cloth: Cloth, given: Motion, *, flies: bool) -> Motion:
    """Return the motion after the bed has answered the downward speed."""
    if given.rise == 0.0:
        return given
    pressed, velocity, spin = -given.rise, given.velocity, given.spin
    rise = cloth.bounce * pressed if flies else 0.0
    if rise * rise <= 2.0 * cloth.gravity * HOP:
        rise = 0.0
    slip = (
        velocity[0] - ball.radius * spin[1],
        velocity[1] + ball.radius * spin[0],
    )
    total = hypot(*slip)
    if total == 0.0:
        return Motion(velocity, spin, rise)
    sliding = cloth.sliding if ball.sliding is None else ball.sliding
    change = min(sliding * (pressed + rise), total / 3.5)
    ux, uy = slip[0] / total, slip[1] / total
    twist = 2.5 * change / ball.radius
    return Motion(
        (velocity[0] - change * ux, velocity[1] - change * uy),
        (spin[0] - twist * uy, spin[1] + twist * ux, spin[2]),
        rise,
    )


__all__ = ["Motion", "axis_offset", "miscue_limit", "squirt_angle", "strike_ball", "tip_blow"]
