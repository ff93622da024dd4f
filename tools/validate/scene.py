"""Groups H and I: when things meet, and whole scenes against independent computations."""

from __future__ import annotations

import re
from math import hypot
from typing import TYPE_CHECKING

import numpy as np

from engine.physics.airborne import closes_in_space
from engine.physics.events import BallsCollided, CushionHit
from engine.physics.pack import nose_reach
from engine.physics.predict import NEVER, closes
from engine.physics.strike import Motion
from engine.physics.world import Rubber, World
from engine.table.build import build_table
from tools.validate.check import NotApplicableError
from tools.validate.lab import (
    OPEN,
    REST,
    ball_name,
    cloth_of,
    contact_of,
    radius_of,
    throw,
    world_of,
)
from tools.validate.prose import spoken

if TYPE_CHECKING:
    from collections.abc import Sequence

    from engine.physics.trace import Trace
    from engine.table.furniture import Point
    from tools.validate.check import Check, Wanted

LONG = 1e3


def _contact_time(check: Check, _: Wanted) -> object:
    """Return when a pair with this relative place, velocity and half acceleration meets, s."""
    place, speed = check.numbers("rel_pos"), check.numbers("rel_vel")
    pull: tuple[float, ...] = (0.0, 0.0, 0.0)
    if check.has("rel_acc_half"):
        pull = check.numbers("rel_acc_half")
    elif "rolling" in check.words.lower():
        pull = _slows(check, speed)
    last, apart = check.number("window", default=LONG), 2.0 * radius_of(check)
    c, b, a = place, speed, pull
    if any(vector[2] for vector in (c, b, a)):
        parts = (*c, *b, *a, apart, last)
        found = float(closes_in_space(*parts))
    else:
        found = float(closes(c[0], c[1], b[0], b[1], a[0], a[1], apart, last))
    return None if found == NEVER else found


def _slows(check: Check, speed: Sequence[float]) -> tuple[float, float, float]:
    """Return half the acceleration (m/s^2) of a pair of which one rolls and one rests."""
    cloth, total = cloth_of(check), hypot(*speed)
    half = -0.5 * cloth.rolling * cloth.gravity / total
    return half * speed[0], half * speed[1], half * speed[2]


def _pressing(check: Check) -> tuple[World, tuple[Point, ...], Motion]:
    """Return a ball that spins up towards another which it touches."""
    if check.has("w"):
        w = check.numbers("w")
        spin = (w[0], w[1], w[2])
    else:
        spin = (0.0, spoken(check, "w", r"w_y=# rad/s"), 0.0)
    places = ((0.0, 0.0), (2.0 * radius_of(check), 0.0))
    return world_of(check), places, Motion((0.0, 0.0), spin)


def _second_derivative(check: Check, _wanted: Wanted) -> object:
    """Return the second derivative of the squared distance at the start: 2 a . c, both at rest."""
    world, places, motion = _pressing(check)
    alone = throw(world, places[:1], {0: motion}, until=1e-3)
    pull = alone.pieces_of(ball_name(0))[0][4]
    return 2.0 * (-pull[0] * places[1][0] - pull[1] * places[1][1])


def _depth(check: Check, wanted: Wanted) -> object:
    """Return how deep (m) the two lie in each other at the worst moment."""
    seconds = re.search(r"next ([\d.]+) s", wanted.quantity)
    until = float(seconds[1]) if seconds else check.number("until")
    world, places, motion = _pressing(check)
    trace = throw(world, places, {0: motion}, until=until)
    times = np.unique([*np.linspace(0.0, until, 20001), *trace.pieces[:, [1, 2]].ravel()])
    centres = trace.positions(times[times <= until])
    apart = np.hypot(*(centres[:, 1, :2] - centres[:, 0, :2]).T)
    return max(0.0, float(2.0 * radius_of(check) - apart.min()))


def _to_nose(check: Check) -> tuple[float, Trace]:
    line = spoken(check, "y_nose", r"y=# m")
    speed, radius = spoken(check, "v", r"# m/s"), radius_of(check)
    table = build_table(OPEN, 2.0 * line, check.number("h"), None, None, 0.1)
    world = world_of(check, 1, table=table)
    trace = throw(world, [(0.0, 0.0)], {0: Motion((0.0, speed), (-speed / radius, 0.0, 0.0))})
    return next(e.time for e in trace.events() if isinstance(e, CushionHit)), trace


def _nose_time(check: Check, _: Wanted) -> object:
    return _to_nose(check)[0]


def _nose_place(check: Check, _: Wanted) -> object:
    time, trace = _to_nose(check)
    return float(trace.positions([time])[0, 0, 1])


def _box(check: Check) -> tuple[World, Point, int]:
    """Return the scene's world, the middle of its bed, and how many balls it has."""
    balls = check.parameters["balls"]
    size, radius = len(balls) if isinstance(balls, list) else 0, radius_of(check)
    contact, sides = contact_of(check), check.parameters.get("cushions")
    if not isinstance(sides, list):
        return world_of(check, size, contact=contact), (0.0, 0.0), size
    low, high = {"x": -OPEN, "y": -OPEN}, {"x": OPEN, "y": OPEN}
    for axis, limit, way in sides:
        if way > 0:
            high[axis] = min(high[axis], limit)
        else:
            low[axis] = max(low[axis], -abs(limit) if limit > 0 else limit)
    middle = (low["x"] + high["x"]) / 2.0, (low["y"] + high["y"]) / 2.0
    reach = nose_reach(radius, check.number("h", default=radius))
    length, width = (high[axis] - low[axis] + 2.0 * reach for axis in "xy")
    table = build_table(length, width, check.number("h", default=radius), None, None, 0.1)
    rubber = Rubber(check.number("e_c"), 0.0, 0.0, 0.0)
    model = check.text("model", "restitution")
    world = world_of(check, size, contact=contact, rubber=rubber, table=table, ball_cushion=model)
    return world, middle, size


def _play(check: Check) -> tuple[Trace, Point]:
    if not isinstance(check.parameters.get("balls"), list):
        raise NotApplicableError("input only in prose: balls")
    world, middle, _ = _box(check)
    balls: list[dict[str, list[float]]] = check.parameters["balls"]  # type: ignore[assignment]
    places = [(one["r"][0] - middle[0], one["r"][1] - middle[1]) for one in balls]
    motions = {}
    for i, one in enumerate(balls):
        v, w = one.get("v", [0.0] * 3), one.get("w", [0.0] * 3)
        if any(v) or any(w):
            motions[i] = Motion((v[0], v[1]), (w[0], w[1], w[2]), *v[2:])
    return throw(world, places, motions or {0: REST}), middle


def _end(check: Check, _: Wanted) -> object:
    return _play(check)[0].duration


def _final(check: Check, wanted: Wanted) -> object:
    trace, middle = _play(check)
    x, y = trace.final[ball_name(int(wanted.quantity.split()[-1]))]
    return [x + middle[0], y + middle[1]]


def _meetings(check: Check) -> list[list[object]]:
    trace, _ = _play(check)
    index = {ball.id: i for i, ball in enumerate(trace.balls)}
    told: list[list[object]] = []
    for e in trace.events():
        if isinstance(e, BallsCollided):
            told.append([e.time, "bb", *sorted((index[e.ball], index[e.other]))])
        elif isinstance(e, CushionHit):
            side = {"foot": "+x", "head": "-x", "left": "+y", "right": "-y"}[e.cushion]
            told.append([e.time, "cush", index[e.ball], side])
    return told


def _count(check: Check, _: Wanted) -> object:
    return len(_meetings(check))


def _list(check: Check, _: Wanted) -> object:
    return _meetings(check)


KINDS = (
    (r"t_contact", _contact_time),
    (r"f''\(0\)", _second_derivative),
    (r"max interpenetration.*", _depth),
    (r"y_contact", _nose_place),
    (r"t", _nose_time),
    (r"t_end", _end),
    (r"final xy ball \d+", _final),
    (r"n_collision_events", _count),
    (r"collision_events", _list),
)
"""Which quantity is answered by what."""
