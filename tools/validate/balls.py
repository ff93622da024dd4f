"""Groups B, C and D: two balls that meet, and what becomes of them when they roll again."""

from __future__ import annotations

import re
from dataclasses import replace
from math import cos, radians, sin, sqrt
from typing import TYPE_CHECKING

import numpy as np

from engine.physics.collide import friction
from engine.physics.events import BallsCollided
from engine.physics.pack import pack_world
from engine.physics.world import Contact
from tools.validate.check import NotApplicableError
from tools.validate.cluster import blow
from tools.validate.lab import (
    contact_of,
    direction,
    meet,
    play_cut,
    radius_of,
    rolls_at,
    velocity,
    world_of,
)
from tools.validate.prose import motion_of, need, told

if TYPE_CHECKING:
    from collections.abc import Callable

    from engine.physics.trace import Trace
    from engine.physics.world import World
    from tools.validate.check import Check, Wanted
    from tools.validate.lab import Floats, Met

DEPTH_OF_SEARCH = 80


def _world(check: Check, wanted: Wanted, model: str = "frictional") -> World:
    e = told(wanted, "e")
    return world_of(check, contact=contact_of(check, e), ball_ball=model)


def _speed(check: Check, wanted: Wanted) -> float:
    """Return the speed at impact; 1 m/s where figures do not depend on it."""
    for name in ("v", "V0"):
        value = told(wanted, name)
        if value is not None:
            return value
    return check.number("v", default=1.0)


def _follow(check: Check, wanted: Wanted, speed: float) -> float:
    """Return spin times radius about the level axis, m/s: fields, `k` of the name, or words."""
    k = told(wanted, "k")
    if k is not None:
        return -k * speed
    if check.has("R_omega"):
        return check.number("R_omega")
    if told(wanted, "cut") is not None and not check.has("motion"):
        return speed  # the published tables are of rolling balls
    return speed if motion_of(check, wanted) == "roll" else 0.0


def _side(check: Check, speed: float, phi: float) -> float:
    """Return side spin times radius, m/s; a `gearing` one makes the surfaces roll off."""
    if check.has("R_wz"):
        return check.number("R_wz")
    if "gearing" in check.text("spin", check.description.lower()):
        # the other ball lies below the way, so outside English turns clockwise
        return -speed * sin(radians(phi))
    return 0.0


def _meeting(check: Check, wanted: Wanted) -> tuple[float, Met]:
    """Return the cut angle (degrees) and the two balls just after they met."""
    phi = told(wanted, "phi")
    phi = check.number("phi", default=0.0) if phi is None else phi
    speed = _speed(check, wanted)
    side = _side(check, speed, phi)
    follow = 0.0 if side else _follow(check, wanted, speed)
    return phi, meet(_world(check, wanted), phi, speed, (0.0, follow, side))


def _between(check: Check, wanted: Wanted) -> object:
    _, met = _meeting(check, wanted)
    return direction(met.v[0]) - direction(met.v[1])


def _speeds(check: Check, wanted: Wanted) -> object:
    _, met = _meeting(check, wanted)
    return [float(np.hypot(*v)) for v in met.v]


def _object_throw(check: Check, wanted: Wanted) -> object:
    """Return how far (degrees) the other ball leaves the line of centres, with the way."""
    phi, met = _meeting(check, wanted)
    return direction(met.v[1]) + phi


def _off_tangent(check: Check, wanted: Wanted) -> object:
    phi, met = _meeting(check, wanted)
    return 90.0 - phi - direction(met.v[0])


def _after_slip(trace: Trace, ball: int) -> Floats:
    """Return a ball's velocity (2,) when it rolls again after the meeting at time 0."""
    return velocity(trace, ball, rolls_at(trace, ball, 0.0))


def _cut_play(
    check: Check, wanted: Wanted, phi: float | None = None, model: str = "frictional"
) -> Trace:
    speed, world = _speed(check, wanted), _world(check, wanted, model)
    angle = (told(wanted, "phi") or told(wanted, "cut") or 0.0) if phi is None else phi
    return play_cut(world, angle, speed, (0.0, _follow(check, wanted, speed), 0.0))


def _deflection(check: Check, wanted: Wanted) -> object:
    v = _after_slip(_cut_play(check, wanted), 0)
    return [direction(v), float(np.hypot(*v)) / _speed(check, wanted)]


def _most_deflected(check: Check, wanted: Wanted) -> object:
    """Return the greatest deflection (degrees) over all cut angles, by golden section."""
    golden = (sqrt(5.0) - 1.0) / 2.0

    def ask(phi: float) -> float:
        return direction(_after_slip(_cut_play(check, wanted, phi), 0))

    low, high = 1.0, 89.0
    for _ in range(DEPTH_OF_SEARCH):
        one, two = high - golden * (high - low), low + golden * (high - low)
        low, high = (low, two) if ask(one) >= ask(two) else (one, high)
    return ask((low + high) / 2.0)


def _head_on(ball: int) -> Callable[[Check, Wanted], object]:
    def answer(check: Check, wanted: Wanted) -> object:
        return float(_after_slip(_cut_play(check, wanted), ball)[0])

    return answer


def _draw_distance(check: Check, wanted: Wanted) -> object:
    trace = _cut_play(check, wanted)
    return abs(float(trace.positions([trace.duration])[0, 0, 0]))


def _square_draw(check: Check, wanted: Wanted) -> object:
    """Return the spin over speed with which the ball leaves square to its old way.

    The final way is linear in the spin, so two shots lead to it and a third one checks.
    """
    phi, world = need(check, wanted, "phi"), _world(check, wanted)

    def onward(k: float) -> float:
        return float(_after_slip(play_cut(world, phi, 1.0, (0.0, k, 0.0)), 0)[0])

    first, second = onward(0.0), onward(-1.0)
    k = first / (second - first)
    if abs(onward(k)) > 1e-9:
        raise AssertionError("the way after a draw is not linear in its spin")
    return k


def _shot_of_table(check: Check, wanted: Wanted) -> object:
    """Return [CB, OB, CB angle, OB angle] after the slip, as many as the quantity names."""
    usual = "mathavan-2014" if check.group.startswith("D") else "frictional"
    trace = _cut_play(check, wanted, model=check.text("model", usual))
    one, two = (_after_slip(trace, ball) for ball in (0, 1))
    if wanted.quantity.endswith("CB exit angle"):
        return direction(one)
    all_four = [float(np.hypot(*one)), float(np.hypot(*two)), direction(one), -direction(two)]
    size = len(wanted.value) if isinstance(wanted.value, list) else 4
    return all_four[:size]


def _unequal(ball: int) -> Callable[[Check, Wanted], object]:
    def answer(check: Check, wanted: Wanted) -> object:
        if isinstance(wanted.value, list):
            raise NotApplicableError("needs flight: vertical velocities are dropped on the bed")
        masses = [check.number("m1"), check.number("m2")]
        world = world_of(check, contact=Contact(check.number("e"), 0.0), masses=masses)
        return float(meet(world, 0.0, _speed(check, wanted)).v[ball][0])

    return answer


def _cradle(check: Check, wanted: Wanted) -> object:
    """Return the last ball's speed when the blow is handed on, pair by pair."""
    n, gap = int(need(check, wanted, "n")), 2.0 * radius_of(check)
    contact = contact_of(check, need(check, wanted, "e"))
    contact = replace(contact, friction_floor=0.0, friction_rise=0.0)
    places = [(i * gap, 0.0) for i in range(n)]
    return float(blow(check, places, [check.number("v")], contact=contact)[-1, 0])


def _double_hit(check: Check, wanted: Wanted) -> tuple[Trace, list[BallsCollided]]:
    trace = _cut_play(check, wanted, 0.0)
    hits = [e for e in trace.events() if isinstance(e, BallsCollided)]
    if len(hits) < 2:
        return trace, []
    return trace, hits


def _second_time(check: Check, wanted: Wanted) -> object:
    _, hits = _double_hit(check, wanted)
    return hits[1].time - hits[0].time if hits else None


def _second_way(check: Check, wanted: Wanted) -> object:
    trace, hits = _double_hit(check, wanted)
    if not hits:
        return None
    places = trace.positions([hits[0].time, hits[1].time])[:, 0, 0]
    return float(places[1] - places[0])


def _second_speed(check: Check, wanted: Wanted) -> object:
    _, hits = _double_hit(check, wanted)
    return hits[1].speed if hits else None


def _friction(check: Check, wanted: Wanted) -> object:
    """Return the friction coefficient at the slip in `mu(slip)`, or at the meeting's slip."""
    world = world_of(check, contact=contact_of(check))
    inside = wanted.quantity.removeprefix("mu").strip("() ")
    slip = float(inside) if inside else _speed(check, wanted)
    return float(friction(pack_world(world), slip))


def _spin_after(ball: int, axis: int) -> Callable[[Check, Wanted], object]:
    def answer(check: Check, wanted: Wanted) -> object:
        return float(_meeting(check, wanted)[1].rw[ball][axis])

    return answer


def _stick_limit(check: Check, wanted: Wanted) -> object:
    """Return the share of side spin that goes over when the surfaces do not slip at all."""
    contact = Contact(check.number("e"), 1e6)
    side = check.number("R_wz")
    met = meet(world_of(check, contact=contact), 0.0, _speed(check, wanted), (0.0, 0.0, side))
    return abs(float(met.rw[1][2]) / side)


def _measured_throw(check: Check, speed: float, phi: float) -> float:
    contact = contact_of(check, check.number("e", default=0.95))
    met = meet(world_of(check, contact=contact), phi, speed)
    return direction(met.v[1]) + phi


def _named_speed(check: Check, name: str) -> float:
    """Return what `slow` and `fast` mean: a field, else as another check of the file says."""
    said = check.laws.get(name)
    return check.number(name, default=None if said is None else float(str(said)))


def _at_angle(wanted: Wanted) -> float:
    found = re.search(r"at ([\d.]+) deg", wanted.quantity)
    return float(found[1]) if found else 0.0


def _throw_anywhere(check: Check, wanted: Wanted) -> object:
    return _measured_throw(check, _named_speed(check, "v_slow"), _at_angle(wanted))


def _most_throw(check: Check, _: Wanted) -> object:
    return max(
        _measured_throw(check, _named_speed(check, "v_slow"), phi)
        for phi in np.linspace(1.0, 89.0, 353)
    )


def _throw_ratio(check: Check, wanted: Wanted) -> object:
    phi = _at_angle(wanted)
    fast = _measured_throw(check, _named_speed(check, "v_fast"), phi)
    return fast / _measured_throw(check, _named_speed(check, "v_slow"), phi)


def _on_two(check: Check, wanted: Wanted) -> Floats:
    """Return the velocities (3, 2) of a ball that met two frozen ones, one on each side."""
    a, gap = radians(check.number("half_angle", default=30.0)), 2.0 * radius_of(check)
    places = [(0.0, 0.0), (gap * cos(a), gap * sin(a)), (gap * cos(a), -gap * sin(a))]
    return blow(check, places, [_speed(check, wanted)])


def _both_ways(check: Check, wanted: Wanted) -> object:
    v = _on_two(check, wanted)
    return [direction(v[1]), direction(v[2])]


def _at_once(ball: int) -> Callable[[Check, Wanted], object]:
    def answer(check: Check, wanted: Wanted) -> object:
        v = _on_two(check, wanted)[ball]
        return float(v[0]) if ball == 0 else float(np.hypot(*v))

    return answer


def _all_of_it(check: Check, wanted: Wanted) -> object:
    return _on_two(check, wanted)[0].tolist()


KINDS = (
    (r"angle_between phi=.*|separation( phi=.*)?", _between),
    (r"\[\|vCB\|,\|vOB\|\] phi=.*", _speeds),
    (r"\[deflection, v_final/v\] phi=.*", _deflection),
    (r"max deflection.*", _most_deflected),
    (r"CB [ek]=[-\d.]+", _head_on(0)),
    (r"OB [ek]=[-\d.]+", _head_on(1)),
    (r"draw distance to rest.*", _draw_distance),
    (r"k phi=.*", _square_draw),
    (r"V0=.* cut=.* (\[.*\]|CB exit angle)", _shot_of_table),
    (r"v_CB_x", _at_once(0)),
    (r"\|v_OB\||first-processed OB speed", _at_once(1)),
    (r"second OB speed", _at_once(2)),
    (r"OB angles", _both_ways),
    (r"CB velocity", _all_of_it),
    (r"v_CB", _unequal(0)),
    (r"v_OB", _unequal(1)),
    (r"n=\d+ balls e=.*: last ball speed", _cradle),
    (r"t_second_contact after first", _second_time),
    (r"CB travel", _second_way),
    (r"closing speed", _second_speed),
    (r"mu(\(.*\))?", _friction),
    (r"(v=[-\d.]+ )?phi=[-\d.]+|OB throw", _object_throw),
    (r"CB angle off tangent line", _off_tangent),
    (r"CB R wz", _spin_after(0, 2)),
    (r"OB R wz", _spin_after(1, 2)),
    (r"R w_CB,y", _spin_after(0, 1)),
    (r"R w_OB,y", _spin_after(1, 1)),
    (r"stick-limit fraction.*", _stick_limit),
    (r"throw at .* deg", _throw_anywhere),
    (r"max slow stun throw", _most_throw),
    (r"fast/slow throw ratio at .* deg", _throw_ratio),
)
"""Which quantity is answered by what."""
