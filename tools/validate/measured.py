"""Measured figures against the shipped games: their cloths, balls, tips and cushions.

One idea: a check says which kind of table it was measured on, and a shipped variant stands for
each kind. Invariant: nothing here is tuned; the variant is read as players get it.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import numpy as np

from engine.physics.collide import friction
from engine.physics.events import BallLanded, CushionHit, RollingBegan
from engine.physics.pack import pack_world
from engine.physics.strike import Motion
from engine.physics.throw import throw_balls
from engine.variant.load import load_variant
from tools.validate.check import NotApplicableError
from tools.validate.prose import need

if TYPE_CHECKING:
    from collections.abc import Callable

    from engine.physics.world import World
    from tools.validate.check import Check, Wanted

VARIANTS = {"pool": "eight_ball", "snooker": "snooker", "carom": "three_cushion"}


def _world(check: Check) -> World:
    """Return the world of the check's `variant`, else of the kind of table its words name."""
    if check.has("variant"):
        return load_variant(check.text("variant")).world
    found = re.search("|".join(VARIANTS), check.description, re.IGNORECASE)
    if not found:
        raise NotApplicableError("input only in prose: variant")
    return load_variant(VARIANTS[found[0].lower()]).world


def _number(ask: Callable[[World], float]) -> Callable[[Check, Wanted], object]:
    def answer(check: Check, _: Wanted) -> object:
        if check.kind == "xref":
            raise NotApplicableError("constants of another program")
        return ask(_world(check))

    return answer


def _friction_mean(world: World) -> float:
    """Return the mean friction of ball on ball over slips of 0.1 to 5 m/s, evenly in their logs."""
    packed = pack_world(world)
    return float(np.mean([friction(packed, slip) for slip in np.geomspace(0.1, 5.0, 50)]))


def _slowing(world: World, speed: float, *, rolling: bool) -> float:
    """Return the deceleration (m/s^2) of a ball just after it starts along the table."""
    ball, table = world.balls[0], world.table
    motion = Motion((speed, 0.0), (0.0, speed / ball.radius if rolling else 0.0, 0.0))
    at = (-0.4 * table.length, 0.1 * table.width)
    trace = throw_balls(world, {ball.id: at}, {ball.id: motion}, until=0.02)
    first, last = trace.velocities([0.0, 0.01])[:, 0, 0]
    return float(first - last) / 0.01


def _rolling_slowing(check: Check, wanted: Wanted) -> object:
    found = re.search(r"([\d.]+)-([\d.]+) m/s", wanted.quantity)
    speed = (float(found[1]) + float(found[2])) / 2.0 if found else 1.0
    return _slowing(_world(check), speed, rolling=True)


def _sliding_slowing(check: Check, _: Wanted) -> object:
    return _slowing(_world(check), 2.0, rolling=False)


def _struck_share(check: Check, _: Wanted) -> object:
    """Return the rolling speed of a ball struck full by another, over its speed at first."""
    world = _world(check)
    one, two = world.balls[:2]
    at, gap = -0.3 * world.table.length, 2.0 * one.radius
    layout = {one.id: (at, 0.0), two.id: (at + gap, 0.0)}
    rolling = Motion((1.0, 0.0), (0.0, 1.0 / one.radius, 0.0))
    trace = throw_balls(world, layout, {one.id: rolling}, until=1.0)
    rolls = next(e.time for e in trace.events() if isinstance(e, RollingBegan) and e.ball == two.id)
    index = [ball.id for ball in trace.balls].index(two.id)
    first, last = trace.velocities([1e-9, rolls])[:, index, 0]
    return float(last / first)


def _reroll(check: Check, wanted: Wanted) -> object:
    """Return rolling speed after over before a square hit on the foot cushion."""
    world, speed = _world(check), need(check, wanted, "v")
    ball, table = world.balls[0], world.table
    at = table.length / 2.0 - 2.0 * ball.radius
    motion = Motion((speed, 0.0), (0.0, speed / ball.radius, 0.0))
    trace = throw_balls(world, {ball.id: (at, 0.1 * table.width)}, {ball.id: motion}, until=3.0)
    hit = next(e.time for e in trace.events() if isinstance(e, CushionHit))
    rolls = next(e.time for e in trace.events() if isinstance(e, RollingBegan) and e.time >= hit)
    before = trace.velocities([hit - 1e-9])[0, 0, 0]
    return float(-trace.velocities([rolls + 1e-9])[0, 0, 0] / before)


def _rail(world: World) -> float:
    """Return the speed after over before a square hit of a rolling ball at 1 m/s."""
    ball, table = world.balls[0], world.table
    at = table.length / 2.0 - 2.0 * ball.radius
    motion = Motion((1.0, 0.0), (0.0, 1.0 / ball.radius, 0.0))
    trace = throw_balls(world, {ball.id: (at, 0.1 * table.width)}, {ball.id: motion}, until=0.2)
    hit = next(e.time for e in trace.events() if isinstance(e, CushionHit))
    before, after = trace.velocities([hit - 1e-9, hit + 1e-9])[:, 0, 0]
    return float(-after / before)


def _bed(world: World) -> float:
    """Return the speed after over before the landing of a ball that falls 10 cm."""
    ball = world.balls[0]
    fall = {ball.id: Motion((0.0, 0.0), (0.0, 0.0, 0.0), height=0.1)}
    trace = throw_balls(world, {ball.id: (0.0, 0.0)}, fall, until=0.2)
    landing = next(e.time for e in trace.events() if isinstance(e, BallLanded))
    before, after = trace.velocities([landing - 1e-9, landing + 1e-9])[:, 0, 2]
    return float(-after / before)


def _none(reason: str) -> Callable[[Check, Wanted], object]:
    def answer(check: Check, wanted: Wanted) -> object:  # noqa: ARG001
        raise NotApplicableError(reason)

    return answer


BLOWS = "blows take no time in this engine"
KINDS = (
    (r"mu ball-ball", _number(_friction_mean)),
    (r"e ball-ball", _number(lambda world: world.contact.restitution)),
    (r"mu_r( .*)?", _number(lambda world: world.cloth.rolling)),
    (r"mu_s", _number(lambda world: world.cloth.sliding)),
    (r"spin decel", _number(lambda world: world.cloth.spin_deceleration)),
    (r"e ball-rail", _number(_rail)),
    (r"e ball-table", _number(_bed)),
    (r"mu tip", _number(lambda world: world.cue.tip_friction)),
    (r"e tip leather", _number(lambda world: world.cue.tip_restitution)),
    (r"e tip phenolic", _none("no shipped cue has a phenolic tip")),
    (r"sliding deceleration.*", _sliding_slowing),
    (r"rolling deceleration.*|[\d.]+-[\d.]+ m/s", _rolling_slowing),
    (r"v_roll/v0 of struck OBs", _struck_share),
    (r"v=[\d.]+( m/s)?", _reroll),
    (r"ball-ball|tip-ball|Hertz prediction.*", _none(BLOWS)),
    (r"mu_sp|mu_bb|rail: .*|wz decay .*|ball mass.*", _none("constants of another program")),
)
"""Which quantity is answered by what."""
