"""Group G, and what else leaves the bed: drops, bounces, jump shots, meetings in space.

One idea: a ball is let fall, struck by a raised cue, or handed to the function that resolves its
meeting in the air, and heights and times are read off the trace. Invariant: a bounce too low for
the engine is asked for in a larger drop of the same shape, since bounces have no scale of their
own.
"""

from __future__ import annotations

import re
from dataclasses import replace
from math import degrees, radians, sqrt
from typing import TYPE_CHECKING

from engine.physics import state
from engine.physics.events import BallLanded
from engine.physics.impact import meet_ball, meet_bed
from engine.physics.lip import leaving_angle
from engine.physics.pack import packed
from engine.physics.strike import Motion, strike_ball, tip_blow
from engine.physics.world import Cue, Strike
from engine.table.build import build_table
from tools.validate.balls import KINDS as ON_THE_BED
from tools.validate.cue import GRIP, STRAIGHT
from tools.validate.lab import OPEN, cloth_of, contact_of, radius_of, throw, world_of
from tools.validate.prose import need, spoken

if TYPE_CHECKING:
    from engine.physics.trace import Trace
    from engine.physics.world import World
    from tools.validate.check import Check, Wanted
    from tools.validate.lab import Floats

LARGER = (1.0, 100.0, 10000.0, 1e6)
"""By how much a drop is made higher until it bounces often enough."""

AXES = [state.VX, state.VY, state.VZ]
TURNS = [state.WX, state.WY, state.WZ]


def _world(check: Check, n: int = 1) -> World:
    """Return balls that may fly over a bed with the check's restitution `e_t`."""
    cloth = replace(cloth_of(check), bounce=spoken(check, "e_t", "e_t ?= ?#"))
    # `h` is a height to fall from here, not that of the noses
    table = build_table(OPEN, OPEN, 1.27 * radius_of(check), None, None, 0.1)
    return world_of(check, n, cloth=cloth, table=table, flight="ballistic")


def _landings(check: Check, count: int) -> tuple[Trace, list[float], float]:
    """Return the trace of a drop, when it lands, and how much larger than asked for it is."""
    height = spoken(check, "h", r"R ?\+ ?# m")
    for larger in LARGER:
        start = Motion((0.0, 0.0), (0.0, 0.0, 0.0), height=height * larger)
        trace = throw(_world(check), [(0.0, 0.0)], {0: start})
        times = [event.time for event in trace.events() if isinstance(event, BallLanded)]
        if len(times) >= count:
            break
    return trace, times, larger


def _number_of(wanted: Wanted) -> int:
    return int(wanted.quantity.split()[-1])


def _impact(check: Check, wanted: Wanted) -> object:
    """Return the time of the landing with this number, s."""
    number = _number_of(wanted)
    _, times, larger = _landings(check, number)
    return times[number - 1] / sqrt(larger)


def _ever(check: Check, _: Wanted) -> object:
    """Return where the times of landing run to, s: the limit of their geometric series."""
    _trace, times, larger = _landings(check, 3)
    first, second, third = times[:3]
    share = (third - second) / (second - first)
    return (first + (second - first) / (1.0 - share)) / sqrt(larger)


def _top(check: Check, wanted: Wanted) -> object:
    """Return how high the ball comes after the landing with this number, m."""
    number = _number_of(wanted)
    trace, times, larger = _landings(check, number + 1)
    middle = 0.5 * (times[number - 1] + times[number])
    return float(trace.positions([middle])[0, 0, 2] - trace.balls[0].radius) / larger


def _bounce(check: Check, wanted: Wanted) -> object:
    """Return velocity or spin after a fall onto the bed with the motion that the check names."""
    name, what = wanted.quantity.split(": ")
    world = _world(check)
    row = packed(world).rows[0].copy()
    row[AXES], row[TURNS] = check.numbers(f"{name}_v"), check.numbers(f"{name}_w")
    meet_bed(row, packed(world).numbers)
    return [float(x) for x in row[AXES if what == "v" else TURNS]]


def _jump(check: Check) -> tuple[World, Cue, Strike]:
    """Return what a jump shot is played with, and its strike."""
    cue = Cue(check.number("M"), spoken(check, "e_tip", "e_tip ?= ?#"), GRIP, STRAIGHT)
    raised = radians(spoken(check, "theta_deg", "# deg"))
    side, follow = check.number("a", default=0.0), check.number("b", default=0.0)
    return _world(check), cue, Strike(check.number("V"), 0.0, raised, side, follow)


def _three(motion: Motion) -> list[float]:
    return [*motion.velocity, motion.rise]


def _after_tip(check: Check, wanted: Wanted) -> object:
    world, cue, strike = _jump(check)
    motion = tip_blow(world.balls[0], cue, strike)
    return _three(motion) if wanted.quantity.startswith("v") else list(motion.spin)


def _after_slate(check: Check, wanted: Wanted) -> object:
    world, cue, strike = _jump(check)
    motion = strike_ball(world.balls[0], cue, world.cloth, strike)
    return _three(motion) if wanted.quantity.startswith("v") else list(motion.spin)


def _flight(check: Check, wanted: Wanted) -> object:
    """Return duration (s), length (m) or height gained (m) of the first flight of a jump shot."""
    world, cue, strike = _jump(check)
    motion = strike_ball(world.balls[0], cue, world.cloth, strike)
    trace = throw(world, [(0.0, 0.0)], {0: motion})
    landing = next(event.time for event in trace.events() if isinstance(event, BallLanded))
    if wanted.quantity == "flight time":
        return landing
    if wanted.quantity == "flight range":
        return float(trace.positions([landing])[0, 0, 0])
    top = trace.velocities([0.0])[0, 0, 2] / world.cloth.gravity
    return float(trace.positions([top])[0, 0, 2] - world.balls[0].radius)


def _met(check: Check) -> tuple[Floats, Floats]:
    """Return the rows of two balls after a head-on meeting in space, before the bed answers."""
    world = world_of(check, 2, contact=contact_of(check), flight="ballistic")
    one, two = (row.copy() for row in packed(world).rows)
    speed, radius = check.number("v"), world.balls[0].radius
    one[state.VX], two[state.X] = speed, 2.0 * radius
    rolls = re.search(r"\broll", check.text("motion", check.description))
    one[state.WY] = check.number("R_omega", default=speed if rolls else 0.0) / radius
    meet_ball(one, two, state.FLY, state.FLY, packed(world).numbers)
    return one, two


def _met_velocity(check: Check, wanted: Wanted) -> object:
    chosen = _met(check)[wanted.quantity == "v_OB"]
    return [float(x) for x in chosen[AXES]]


def _met_spin(check: Check, wanted: Wanted) -> object:
    chosen = _met(check)[wanted.quantity.startswith("R w_OB")]
    axis = "xyz".index(wanted.quantity[-1])
    return float(chosen[TURNS[axis]] * chosen[state.RADIUS])


def is_spatial(check: Check) -> bool:
    """Say whether a check wants velocities of balls with their vertical part."""
    return any(isinstance(one.value, list) and len(one.value) == 3 for one in check.wanted)


def _leaves_lip(check: Check, wanted: Wanted) -> object:
    """Return the angle (degrees) at which a ball that rolls over a lip leaves it."""
    return degrees(_lip(check, need(check, wanted, "v0")))


def _lip(check: Check, speed: float) -> float:
    return float(leaving_angle(speed, cloth_of(check).gravity, check.number("rho", "R")))


def _leaves_at_once(check: Check, _: Wanted) -> object:
    """Return the least speed (m/s) at which a ball leaves a lip at once, by bisection."""
    low, high = 0.0, 100.0
    for _step in range(60):
        middle = (low + high) / 2.0
        low, high = (low, middle) if _lip(check, middle) == 0.0 else (middle, high)
    return high


KINDS = (
    (r"impact \d+", _impact),
    (r"accumulation time", _ever),
    (r"apex \d+", _top),
    (r"\w+: [vw]", _bounce),
    (r"[vw] after tip", _after_tip),
    (r"[vw] after slate", _after_slate),
    (r"psi v0=.*", _leaves_lip),
    (r"v0 immediate", _leaves_at_once),
    (r"apex height gain|flight time|flight range", _flight),
)
MEETINGS = (
    (r"v_CB|v_OB", _met_velocity),
    (r"R w_(CB|OB),[xyz]", _met_spin),
    *ON_THE_BED,
)
"""Which quantity is answered by what: flights, and meetings in space."""

__all__ = ["KINDS", "MEETINGS", "is_spatial"]
