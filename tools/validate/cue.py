"""Group F: what the cue does to the ball."""

from __future__ import annotations

import re
from math import degrees, radians, sqrt
from typing import TYPE_CHECKING

from engine.physics.events import BallLanded, RollingBegan
from engine.physics.strike import (
    axis_offset,
    miscue_limit,
    squirt_angle,
    strike_ball,
    tip_blow,
)
from engine.physics.world import Cloth, Cue, Strike
from tools.validate.lab import (
    MASS,
    cloth_of,
    direction,
    radius_of,
    throw,
    velocity,
    world_of,
)
from tools.validate.prose import NUMBER, need, told

if TYPE_CHECKING:
    from tools.validate.check import Check, Wanted

GRIP = 1e9
"""Friction of a tip that never slips, for figures beyond the miscue limit."""

SMOOTH = Cloth(1e-300, 1e-300, 10.0)
STRAIGHT = 1e18
"""Ball mass over end mass of a cue without squirt."""


def _cue(check: Check, wanted: Wanted) -> Cue:
    """Return the cue of a quantity: its mass from `m/M=` of the name or `M`, its tip's `e`."""
    mass = check.number("m", default=MASS)
    ratio = re.search(rf"m/M=({NUMBER})(?:/({NUMBER}))?", wanted.quantity)
    weight = mass * float(ratio[2] or 1.0) / float(ratio[1]) if ratio else check.number("M")
    e = told(wanted, "e")
    return Cue(weight, check.number("e", default=1.0) if e is None else e, GRIP, STRAIGHT)


def _offset(check: Check, wanted: Wanted) -> float:
    found = re.search(rf"(?:offset|at) ({NUMBER})R", wanted.quantity)
    return float(found[1]) if found else check.number("offset", default=0.0)


def _struck(check: Check, cue: Cue, offset: float) -> tuple[float, float]:
    """Return speed and spin times radius (m/s) after a level strike above the centre."""
    ball = world_of(check, 1).balls[0]
    motion = strike_ball(ball, cue, SMOOTH, Strike(check.number("V"), 0.0, follow=offset))
    return motion.velocity[0], motion.spin[1] * ball.radius


def _ball_speed(check: Check, wanted: Wanted) -> object:
    return _struck(check, _cue(check, wanted), _offset(check, wanted))[0]


def _spin_over_speed(check: Check, wanted: Wanted) -> object:
    speed, spin = _struck(check, _cue(check, wanted), _offset(check, wanted))
    return spin / speed


def _best_offset(check: Check, wanted: Wanted) -> object:
    """Return the offset of greatest spin: offset over spin is even in it and of second degree.

    Two strikes give that parabola and a third one tests it.
    """
    cue = _cue(check, wanted)

    def over(offset: float) -> float:
        return offset / _struck(check, cue, offset)[1]

    bend = (over(0.6) - over(0.2)) / (0.36 - 0.04)
    base = over(0.2) - 0.04 * bend
    if abs(base + 0.16 * bend - over(0.4)) > 1e-12:
        raise AssertionError("spin by offset is not as one impulse gives it")
    return sqrt(base / bend)


def _cue_after(check: Check, wanted: Wanted) -> float:
    """Return the cue's speed after the strike, by momentum, m/s."""
    cue = _cue(check, wanted)
    speed, _ = _struck(check, cue, _offset(check, wanted))
    return check.number("V") - check.number("m") * speed / cue.mass


def _energy_residual(check: Check, wanted: Wanted) -> object:
    cue, mass = _cue(check, wanted), check.number("m")
    speed, spin = _struck(check, cue, _offset(check, wanted))
    before = cue.mass * check.number("V") ** 2 / 2.0
    after = cue.mass * _cue_after(check, wanted) ** 2 / 2.0
    return abs(before - after - mass * (speed**2 / 2.0 + spin**2 / 5.0))


def _squirt(check: Check, wanted: Wanted) -> object:
    return degrees(squirt_angle(need(check, wanted, "a"), need(check, wanted, "m_r")))


def _raised(check: Check, wanted: Wanted) -> object:
    """Return velocity (m/s) or spin (rad/s) that a raised cue's tip gives, before the bed."""
    cue = Cue(check.number("M"), check.number("e", default=1.0), GRIP, STRAIGHT)
    strike = Strike(
        check.number("V"),
        0.0,
        radians(check.number("theta_deg")),
        check.number("a", default=0.0),
        check.number("b", default=0.0),
    )
    motion = tip_blow(world_of(check, 1).balls[0], cue, strike)
    return [*motion.velocity, motion.rise] if wanted.quantity == "v" else list(motion.spin)


def _last_way(check: Check, wanted: Wanted) -> object:
    """Return the direction (degrees) in which a ball struck from above rolls at last."""
    world = world_of(check, 1, cloth=cloth_of(check), flight="ballistic")
    strike = Strike(
        check.number("V", default=2.0),
        0.0,
        radians(need(check, wanted, "elev")),
        need(check, wanted, "a"),
        need(check, wanted, "b"),
    )
    cue = Cue(0.54, check.number("e", default=0.73), GRIP, STRAIGHT)
    motion = strike_ball(world.balls[0], cue, world.cloth, strike)
    trace = throw(world, [(0.0, 0.0)], {0: motion})
    # a high masse hops and lands before it rolls
    times = [e.time for e in trace.events() if isinstance(e, (BallLanded, RollingBegan))]
    return direction(velocity(trace, 0, max(times, default=0.0)))


def _limit(check: Check, wanted: Wanted) -> object:
    return miscue_limit(Cue(0.54, 0.73, need(check, wanted, "mu"), 25.0))


def _tip(check: Check, wanted: Wanted) -> object:
    """Return the offset of the point of contact over that of the cue's axis."""
    return 1.0 / axis_offset(1.0, radius_of(check), need(check, wanted, "r_tip"))


KINDS = (
    (r"centre, .*|offset [\d.]+R.*|v(?= *$)", _ball_speed),
    (r"R w/v at .*", _spin_over_speed),
    (r"offset of maximum spin.*", _best_offset),
    (r"V'", _cue_after),
    (r"energy residual", _energy_residual),
    (r"m_r=.* a=.*", _squirt),
    (r"elev=.* a=.* b=.*", _last_way),
    (r"rho_max mu=.*", _limit),
    (r"contact/axis offset ratio.*", _tip),
)
RAISED = ((r"v|w", _raised),)
"""Which quantity is answered by what; `RAISED` for checks that raise the cue."""
