"""Pins in a shot: which stand, how the felled ones lie, and the answers to what the loop asks.

One idea: to the loop a standing pin is a nose that goes when it falls. What it does from then on
is kept here as falls, and an alarm wakes whenever a falling pin reaches a standing one.
Invariant: what is kept follows from the shot alone; pins that are reached at the same moment by
several are felled by all of them, so that no order of names decides.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache
from math import hypot, inf
from typing import TYPE_CHECKING

from engine.physics import state
from engine.physics.asked import clear_nose
from engine.physics.pins import (
    Aim,
    Blow,
    Body,
    Fall,
    aim,
    body_of,
    knock,
    meets_at,
    rests_at,
    slid,
    start_fall,
    strike_pin,
    tilt_at,
)
from engine.table.pin import Stance, standing
from engine.table.region import on_bed

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from engine.physics.asked import Asked
    from engine.physics.world import Layout, World
    from engine.table.furniture import Pin, PinId, Point, Table

    Floats = NDArray[np.float64]

MEMORY = "pins"
"""Under this name the pins of a shot are kept in its memory."""
AT_ONCE = 1e-9
"""What happens within so many seconds, or metres, happens at once."""
STEP = 0.02
"""Steps (m) in which the way to the edge of the bed is looked for."""


@dataclass(frozen=True, slots=True)
class PinTrace:
    """How the pins stood and fell: those `standing` at first, and the falls in order of time."""

    names: tuple[PinId, ...] = ()
    bodies: tuple[Body, ...] = ()
    standing: tuple[int, ...] = ()
    falls: tuple[Fall, ...] = ()

    def stances(self, time: float) -> dict[PinId, Stance]:
        """Return how each pin that was there at first stands or lies at a time, s."""
        found = {self.names[pin]: Stance(self.bodies[pin].at) for pin in self.standing}
        for fall in self.falls:
            if fall.begin <= time:
                found[self.names[fall.pin]] = _stance(self.bodies[fall.pin], fall, time)
        return found


def _stance(body: Body, fall: Fall, time: float) -> Stance:
    far = slid(body, fall, time)
    foot = fall.foot[0] + far * fall.way[0], fall.foot[1] + far * fall.way[1]
    return Stance(foot, fall.way, tilt_at(body, fall, time))


NO_PINS = PinTrace()


@dataclass(slots=True)
class Hit:
    """A falling pin that will reach a standing one."""

    time: float
    by: int
    pin: int
    aim: Aim


@dataclass(slots=True)
class Felling:
    """The pins of one shot as they are now."""

    table: Table
    names: tuple[PinId, ...]
    bodies: tuple[Body, ...]
    at_first: tuple[int, ...]
    standing: set[int]
    falls: list[Fall] = field(default_factory=list)
    latest: dict[int, Fall] = field(default_factory=dict)
    met: set[tuple[int, int]] = field(default_factory=set)

    def trace(self) -> PinTrace:
        """Return what has happened to the pins so far."""
        return PinTrace(self.names, self.bodies, self.at_first, tuple(self.falls))

    def fell(self, fall: Fall) -> None:
        """Let a pin fall, or go on falling in another way."""
        self.standing.discard(fall.pin)
        self.latest[fall.pin] = fall
        self.falls.append(fall)

    def clear_fallen(self, noses: Floats) -> None:
        """Take the pins that do not stand off the bed before a shot begins, in place."""
        for row in noses:
            if row[state.N_PIN] >= 0.0 and int(row[state.N_PIN]) not in self.standing:
                clear_nose(row)

    def hits(self) -> list[Hit]:
        """Return which falling pins will reach which standing ones, the earliest first."""
        found = []
        for by, fall in self.latest.items():
            for pin in self.standing:
                ahead = aim(self.bodies[by], fall, self.bodies[pin])
                if ahead is None or (by, pin) in self.met:
                    continue
                time = meets_at(self.bodies[by], fall, ahead.far)
                if time < inf:
                    found.append(Hit(time, by, pin, ahead))
        return sorted(found, key=lambda hit: (hit.time, hit.pin, hit.by))

    def wakes_at(self, now: float) -> float:
        """Return when the pins want to be looked at again: at a hit, or when all lie still."""
        hits = self.hits()
        if hits:
            return hits[0].time
        rest = max((rests_at(self.bodies[pin], one) for pin, one in self.latest.items()), default=0)
        return rest if rest > now else inf


def set_up(world: World, layout: Layout, fallen: frozenset[PinId]) -> Felling:
    """Return the pins at the start of a shot: all but the fallen and those without air."""
    pins = world.table.pins
    radius = max((ball.radius for ball in world.balls), default=0.0)
    radii = {ball.id: ball.radius for ball in world.balls}
    free = standing(pins, layout, radii)
    up = tuple(k for k, pin in enumerate(pins) if free[k] and pin.id not in fallen)
    return Felling(
        world.table,
        tuple(pin.id for pin in pins),
        _bodies(pins, radius, world.cloth.gravity),
        up,
        set(up),
    )


@lru_cache(maxsize=16)
def _bodies(pins: tuple[Pin, ...], radius: float, gravity: float) -> tuple[Body, ...]:
    return tuple(body_of(pin, radius, gravity) for pin in pins)


def meet_pin(asked: Asked) -> None:
    """Let a ball meet a standing pin, together with all others that meet it just then."""
    pins = _pins(asked)
    pin = int(asked.noses[asked.other, state.N_PIN])
    body, nose = pins.bodies[pin], asked.noses[asked.other]
    blows: dict[int, tuple[Blow, Point]] = {}
    for ball in _strikers(asked, nose):
        row = asked.rows[ball]
        way, speed = _approach(row, nose)
        blow = _blow(asked, ball, body, speed)
        if blow is not None:
            blows[ball] = blow, way
            asked.note(state.TOPPLED, ball, pin, blow.impulse)
            _push_back(row, way, blow.impulse)
        else:
            asked.note(state.LEANT, ball, pin, speed)
            _push_back(row, way, (1.0 + body.restitution) * speed * float(row[state.MASS]))
    if blows:
        _fall(asked, pins, pin, list(blows.values()))
    asked.wake(pins.wakes_at(asked.time))


def _blow(asked: Asked, ball: int, body: Body, speed: float) -> Blow | None:
    """Return what a ball does to a pin; a flying one meets it at the height of its centre.

    One that comes down on the head fells the pin and loses nothing.
    """
    row = asked.rows[ball]
    if asked.kinds[ball] != state.FLY:
        return strike_pin(body, float(row[state.MASS]), speed, body.level)
    if speed < state.SOFT:
        return Blow(0.0, 0.0, 0.0)
    height = min(float(row[state.Z]), body.height)
    return strike_pin(body, float(row[state.MASS]), speed, height)


def go_on(asked: Asked) -> None:
    """Let the falling pins that reach standing ones at this moment fell them, or lean on them."""
    pins = _pins(asked)
    now = asked.time
    due = [hit for hit in pins.hits() if hit.time <= now + AT_ONCE]
    for pin in dict.fromkeys(hit.pin for hit in due):
        blows = []
        for hit in due:
            if hit.pin != pin:
                continue
            pins.met.add((hit.by, pin))
            before, other = pins.latest[hit.by], pins.bodies[pin]
            blow, after = knock(pins.bodies[hit.by], before, other, hit.aim, now)
            pins.fell(after)
            kind = state.LEANT if blow is None else state.TOPPLED
            asked.note(kind, -1 - hit.by, pin, 0.0 if blow is None else blow.impulse)
            if blow is not None:
                blows.append((blow, hit.aim.push))
        if blows:
            _fall(asked, pins, pin, blows)
    asked.wake(pins.wakes_at(now))


def _pins(asked: Asked) -> Felling:
    pins = asked.memory[MEMORY]
    if not isinstance(pins, Felling):
        raise TypeError("the pins of a shot are set up when it begins")
    return pins


def _fall(asked: Asked, pins: Felling, pin: int, blows: list[tuple[Blow, Point]]) -> None:
    """Take a pin off its place and let it fall as all blows together push it."""
    body = pins.bodies[pin]
    x = sum(blow.impulse * way[0] for blow, way in blows)
    y = sum(blow.impulse * way[1] for blow, way in blows)
    size = hypot(x, y)
    least = 1e-9 * max(blow.impulse for blow, _ in blows)
    way = (x / size, y / size) if size > least else min(way for _, way in blows)
    slide = sum(blow.speed * (to[0] * way[0] + to[1] * way[1]) for blow, to in blows)
    impulse = max(blow.impulse for blow, _ in blows)
    whole = Blow(impulse, max(slide, 0.0), max(blow.rate for blow, _ in blows))
    room = _room(pins.table, body, way)
    pins.fell(start_fall(body, pin, asked.time, way, whole, room))
    for nose in range(len(asked.noses)):
        if asked.noses[nose, state.N_PIN] == pin:
            asked.clear(nose)


def _room(table: Table, body: Body, way: Point) -> float:
    """Return how far (m) a pin can slide until its head lies at the edge of the bed."""
    far, longest = 0.0, hypot(table.length, table.width)

    def inside(away: float) -> bool:
        return on_bed(table, (body.at[0] + away * way[0], body.at[1] + away * way[1]))

    while far < longest and inside(far + STEP):
        far += STEP
    low, high = far, far + STEP
    for _ in range(40):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if inside(middle) else (low, middle)
    return max(low - body.height - body.belly, 0.0)


def _strikers(asked: Asked, nose: Floats) -> list[int]:
    """Return the balls that meet a pin now, brought to this moment, in order of their rows."""
    found = [asked.who]
    for ball, row in enumerate(asked.rows):
        if ball == asked.who or asked.kinds[ball] in (state.GONE, state.FLY, state.REST):
            continue
        s = asked.time - row[state.T0]
        x = row[state.X] + s * (row[state.VX] + 0.5 * s * row[state.AX])
        y = row[state.Y] + s * (row[state.VY] + 0.5 * s * row[state.AY])
        away = hypot(x - nose[state.N_X], y - nose[state.N_Y])
        if away - row[state.RADIUS] - nose[state.N_SIZE] <= AT_ONCE:
            asked.touch(ball)
            if _approach(row, nose)[1] >= state.SOFT:
                found.append(ball)
    return sorted(found)


def _approach(row: Floats, nose: Floats) -> tuple[Point, float]:
    """Return the unit vector from a ball to a pin, and how fast (m/s) the ball comes."""
    x = float(nose[state.N_X] - row[state.X])
    y = float(nose[state.N_Y] - row[state.Y])
    size = hypot(x, y)
    way = (x / size, y / size) if size > 0.0 else (1.0, 0.0)
    return way, float(row[state.VX]) * way[0] + float(row[state.VY]) * way[1]


def _push_back(row: Floats, way: Point, impulse: float) -> None:
    mass = float(row[state.MASS])
    row[state.VX] -= impulse * way[0] / mass
    row[state.VY] -= impulse * way[1] / mass


__all__ = ["MEMORY", "Felling", "PinTrace", "go_on", "meet_pin", "set_up"]
