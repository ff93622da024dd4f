"""How the simulator is asked: balls thrown on an open bed, two balls that meet, one at a nose.

One idea: everything goes through the public API of `engine.physics`; a check's fields become a
World and motions, and the trace or the model's own function gives the answer. Invariant: no
figure of a check is computed here by its formula.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, degrees, inf, radians, sin
from typing import TYPE_CHECKING

import numpy as np

from engine.physics import state
from engine.physics.events import RollingBegan
from engine.physics.pack import nose_reach, pack_rubber, pack_world
from engine.physics.rare import part
from engine.physics.rare import rebound as bounce
from engine.physics.strike import Motion
from engine.physics.throw import throw_balls
from engine.physics.world import MODEL_NAMES, Ball, Cloth, Contact, Cue, Models, Rubber, World
from engine.table.build import build_table
from engine.table.furniture import BallId
from tools.validate.check import NotApplicableError

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from numpy.typing import NDArray

    from engine.physics.trace import Trace
    from engine.table.furniture import Point, Table
    from tools.validate.check import Check

    Floats = NDArray[np.float64]

RADIUS, MASS = 0.028575, 0.170097
"""Of a ball where a check gives none, since its figures depend on neither."""

CLOTH = Cloth(0.2, 0.01, 10.0)
RUBBER = Rubber(0.85, 0.0, 0.0, 0.2)
CUE = Cue(0.5386, 1.0, 0.6, 25.0)
OPEN = 2000.0
"""Side (m) of a bed on which nothing reaches a nose."""


def ball_name(index: int) -> BallId:
    """Return the name of the ball with this number."""
    return BallId(f"ball-{index}")


def cloth_of(check: Check) -> Cloth:
    """Return the check's cloth; what it does not give is not asked for."""
    return Cloth(
        sliding=check.number("mu_s", default=CLOTH.sliding),
        rolling=check.number("mu_r", default=CLOTH.rolling),
        spin_deceleration=check.number("alpha_sp", default=CLOTH.spin_deceleration),
        gravity=check.number("g", default=CLOTH.gravity),
    )


def contact_of(check: Check, restitution: float | None = None) -> Contact:
    """Return how balls meet: `e` or `e_b`, and `mu_b` as a number or the law of the file.

    Where the check has no `mu_b`, the law holds in group C, which is about it, and nowhere else.
    """
    e = check.number("e", "e_b", default=1.0) if restitution is None else restitution
    law = check.parameters.get("mu_b", "law" if check.group.startswith("C") else 0.0)
    try:
        return Contact(e, float(str(law)))
    except ValueError:
        given = check.parameters if check.has("b") and check.has("c") else check.laws
        if not given:
            raise NotApplicableError("input only in prose: mu_b") from None
        a, b, c = (float(str(given[name])) for name in ("a", "b", "c"))
        return Contact(e, a, b, c)


def radius_of(check: Check) -> float:
    """Return the balls' radius (m)."""
    return check.number("R", default=RADIUS)


def world_of(
    check: Check,
    n: int = 2,
    *,
    contact: Contact | None = None,
    cloth: Cloth | None = None,
    rubber: Rubber = RUBBER,
    table: Table | None = None,
    masses: Sequence[float] = (),
    **models: str,
) -> World:
    """Return a world of `n` balls as the check has them, on an open bed."""
    for field, name in models.items():
        if name not in MODEL_NAMES[field]:
            raise NotApplicableError(f"needs the model {name}")
    radius, mass = radius_of(check), check.number("m", "M", default=MASS)
    nose = check.number("h", default=1.27 * radius)
    weights = masses or [mass] * n
    return World(
        table=table or build_table(OPEN, OPEN, nose, None, None, 0.1),
        balls=tuple(Ball(ball_name(i), radius, weight) for i, weight in enumerate(weights)),
        cloth=cloth or cloth_of(check),
        contact=contact or Contact(1.0, 0.0),
        rubber=rubber,
        cue=CUE,
        models=Models(**models),
    )


def throw(
    world: World, places: Sequence[Point], motions: Mapping[int, Motion], until: float = inf
) -> Trace:
    """Return the trace of balls that start at `places` with motions by number."""
    layout = {ball_name(i): place for i, place in enumerate(places)}
    moves = {ball_name(i): motion for i, motion in motions.items()}
    return throw_balls(world, layout, moves, until)


def rolls_at(trace: Trace, ball: int, after: float = -1.0) -> float:
    """Return when a ball begins to roll, s; `after` or 0 where it rolls without a slide."""
    name = ball_name(ball)
    times = [e.time for e in trace.events() if isinstance(e, RollingBegan) and e.ball == name]
    return next((time for time in times if time > after), max(after, 0.0))


def velocity(trace: Trace, ball: int, time: float) -> Floats:
    """Return a ball's velocity (2,) just after an event at `time`, m/s."""
    found: Floats = trace.velocities([time])[0, ball, :2]
    return found


def direction(v: Sequence[float] | Floats) -> float:
    """Return the angle of a vector from +x, degrees."""
    return degrees(atan2(float(v[1]), float(v[0])))


def row_of(ball: Ball, motion: Motion, at: Point = (0.0, 0.0), nose: float | None = None) -> Floats:
    """Return a ball as the models' functions take it."""
    row = np.zeros(state.BALL_WIDTH)
    row[[state.X, state.Y]] = at
    row[[state.VX, state.VY]] = motion.velocity
    row[[state.WX, state.WY, state.WZ]] = motion.spin
    row[state.RADIUS], row[state.MASS] = ball.radius, ball.mass
    row[state.REACH] = nose_reach(ball.radius, nose) if nose is not None else ball.radius
    return row


REST = Motion((0.0, 0.0), (0.0, 0.0, 0.0))


@dataclass(frozen=True, slots=True, eq=False)
class Met:
    """Two balls just after they met: velocities (2,), spins times radius (3,), in m/s."""

    v: tuple[Floats, Floats]
    rw: tuple[Floats, Floats]


def meet(world: World, phi: float, speed: float, rw: Sequence[float] = (0.0, 0.0, 0.0)) -> Met:
    """Return what the model does to a ball at `speed` along +x that meets one at rest.

    `phi` (degrees) is the cut angle, the ball at rest lying below the other's way, so that it
    goes to -phi; `rw` is the moving ball's spin times its radius, m/s.
    """
    one, two = world.balls[0], world.balls[1]
    turn = tuple(part / one.radius for part in rw)
    first = row_of(one, Motion((speed, 0.0), (turn[0], turn[1], turn[2])))
    second = row_of(two, REST, _below(phi, one.radius + two.radius))
    for row in (first, second):
        row[state.SLIDING] = world.cloth.sliding
    part(first, second, pack_world(world))
    return Met(
        v=(first[[state.VX, state.VY]], second[[state.VX, state.VY]]),
        rw=tuple(
            row[[state.WX, state.WY, state.WZ]] * row[state.RADIUS] for row in (first, second)
        ),
    )


def _below(phi: float, distance: float) -> Point:
    return distance * cos(radians(phi)), -distance * sin(radians(phi))


def play_cut(
    world: World, phi: float, speed: float, rw: Sequence[float] = (0.0, 0.0, 0.0)
) -> Trace:
    """Return the whole trace of the meeting of `meet`, which happens at time 0."""
    radius = world.balls[0].radius
    spin = (rw[0] / radius, rw[1] / radius, rw[2] / radius)
    places = [(0.0, 0.0), _below(phi, 2.0 * radius)]
    return throw(world, places, {0: Motion((speed, 0.0), spin)})


def rebound(world: World, v: Sequence[float], rw: Sequence[float]) -> tuple[float, ...]:
    """Return vX, vY, RwX, RwY, RwZ (m/s) after a nose along X whose bed lies at Y < 0."""
    ball = world.balls[0]
    turn = (rw[0] / ball.radius, rw[1] / ball.radius, rw[2] / ball.radius)
    row = row_of(ball, Motion((v[0], v[1]), turn), nose=world.table.nose_height)
    row[state.SLIDING] = world.cloth.sliding
    bounce(row, pack_world(world), pack_rubber(world), 0.0, 1.0)
    spin = row[[state.WX, state.WY, state.WZ]] * ball.radius
    return tuple(float(x) for x in (row[state.VX], row[state.VY], *spin))


def spin_energy_of(rw: Sequence[float]) -> float:
    """Return a ball's energy of rotation over its mass, from spin times radius, m2/s2."""
    return 0.2 * sum(part * part for part in rw)
