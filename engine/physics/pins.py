"""How a standing pin takes a blow, falls, and what it fells in its turn.

One idea: a blow on an upright body is an impulse; it goes over where the impulse that its striker
can give suffices to lift its centre of mass over the far edge of its foot, and what the striker
loses is what the pin gets. Invariant: momentum given is momentum lost, and a pin never has more
energy than its striker gave. SI units; a pin's tilt is 0 upright, pi / 2 lying.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, cosh, hypot, inf, log, pi, sin, sinh, sqrt
from typing import TYPE_CHECKING

from engine.table.pin import meeting, solid_of

if TYPE_CHECKING:
    from engine.table.furniture import Pin, Point

BARELY = 1.02
"""A pin that is just felled passes its balance at this much more than the least rate."""

LYING = pi / 2.0


@dataclass(frozen=True, slots=True)
class Body:
    """A pin as a blow finds it; lengths in m, inertia about a level axis in kg m^2.

    `reach` is how far the axes of ball and pin are apart when they touch, `level` how high that
    is; `inertia` is about the centre of mass and `swing` about the far edge of the foot, `tip`
    the angular momentum about that edge (N m s) that fells it; `lean` is the tilt of its balance
    and `growth` (1/s) that of a fall.
    """

    at: Point
    mass: float
    height: float
    belly: float
    restitution: float
    slowing: float
    reach: float
    level: float
    centre: float
    inertia: float
    swing: float
    tip: float
    lean: float
    growth: float

    @property
    def climb(self) -> float:
        """Return the energy (J) that fells the pin."""
        return self.tip * self.tip / (2.0 * self.swing)

    def free(self, height: float) -> float:
        """Return the mass (kg) that a blow at a height finds when the foot slides."""
        return 1.0 / (1.0 / self.mass + (height - self.centre) ** 2 / self.inertia)


def body_of(pin: Pin, radius: float, gravity: float) -> Body:
    """Return a pin as balls of `radius` (m) find it.

    To stand on its edge the centre of mass must rise by sqrt(b^2 + c^2) - c, b the radius of the
    foot and c the height of the centre; with that energy in a turn about the edge the angular
    momentum is sqrt(2 I m g (sqrt(b^2 + c^2) - c)).
    """
    solid = solid_of(pin.profile)
    arm = hypot(pin.foot, solid.centre)
    swing = pin.mass * (solid.spread + arm * arm)
    reach, level = meeting(pin.profile, radius)
    rise = pin.mass * gravity * (arm - solid.centre)
    tip = sqrt(2.0 * swing * rise) if pin.threshold is None else pin.threshold * level
    return Body(
        at=pin.at,
        mass=pin.mass,
        height=pin.height,
        belly=pin.belly,
        restitution=pin.restitution,
        slowing=pin.friction * gravity,
        reach=reach,
        level=level,
        centre=solid.centre,
        inertia=pin.mass * solid.spread,
        swing=swing,
        tip=tip,
        lean=atan2(pin.foot, solid.centre),
        growth=sqrt(pin.mass * gravity * arm / swing),
    )


@dataclass(frozen=True, slots=True)
class Blow:
    """What a blow does: `impulse` (N s) to the pin, which slides at `speed` and tips at `rate`."""

    impulse: float
    speed: float
    rate: float


def strike_pin(body: Body, mass: float, speed: float, height: float) -> Blow | None:
    """Return what fells the pin; None where it rocks and stands.

    A `mass` (kg) comes at `speed` (m/s) and meets the pin at a height (m). First the free pin
    gets the impulse (1 + e) m' v with the reduced mass m'; where that does not fell it the
    striker follows and pushes, unless it bounces back. So it falls where the striker's momentum
    m v is sqrt(2 m E) or more, E being what lifts the pin onto its edge; a mere push takes
    m (v - sqrt(v^2 - 2 E / m)).
    What the blow gives beyond sqrt(2 m_free E), which alone would fell it, lets the pin slide.
    """
    climb, free = body.climb, body.free(height)
    rest = speed * speed - 2.0 * climb / mass
    if speed <= 0.0 or rest < 0.0:
        return None
    sudden = (1.0 + body.restitution) * speed * mass * free / (mass + free)
    if sudden > mass * speed and sudden * sudden < 2.0 * free * climb:
        return None
    push = mass * (speed - sqrt(rest))
    slide = max(sudden - sqrt(2.0 * free * climb), 0.0) / body.mass
    energy = max(climb, sudden * sudden / (2.0 * free)) - 0.5 * body.mass * slide * slide
    return Blow(max(sudden, push), slide, sqrt(2.0 * energy / body.swing))


def energy_given(body: Body, blow: Blow) -> float:
    """Return the energy (J) of a pin that slides and tips after a blow."""
    return 0.5 * (body.mass * blow.speed**2 + body.swing * blow.rate**2)


@dataclass(frozen=True, slots=True)
class Fall:
    """A felled pin from `begin` (s) on, until something changes it.

    Its foot slides from `foot` along the unit vector `way`, at first at `speed` (m/s), no farther
    than `room` (m); its axis leans that way, at first by `tilt` and at `rate` (rad/s).
    """

    pin: int
    begin: float
    foot: Point
    way: Point
    speed: float
    tilt: float
    rate: float
    room: float = inf


def start_fall(body: Body, pin: int, now: float, way: Point, blow: Blow, room: float = inf) -> Fall:
    """Return the fall of an upright pin that was struck along the unit vector `way`."""
    rate = max(blow.rate, BARELY * body.growth * body.lean)
    return Fall(pin, now, body.at, way, blow.speed, 0.0, rate, room)


def slid(body: Body, fall: Fall, time: float) -> float:
    """Return how far (m) the foot has slid, slowed by friction as any body that slides."""
    s = min(max(time - fall.begin, 0.0), fall.speed / body.slowing)
    return min(s * (fall.speed - 0.5 * body.slowing * s), fall.room)


def tilt_at(body: Body, fall: Fall, time: float) -> float:
    """Return the tilt (rad): that of a rod on its edge, x'' = k^2 x from its balance on.

    The law is that of small tilts, sin x = x, kept up to the lying pin; it is a little early.
    """
    s, k, start = max(time - fall.begin, 0.0), body.growth, fall.tilt - body.lean
    if fall.tilt >= LYING or s * k > FAR:
        return LYING
    return min(start * cosh(k * s) + fall.rate / k * sinh(k * s) + body.lean, LYING)


FAR = 50.0
"""Growths after which any felled pin lies."""


def lies_at(body: Body, fall: Fall) -> float:
    """Return when (s) the pin lies."""
    if fall.tilt >= LYING:
        return fall.begin
    k, start = body.growth, fall.tilt - body.lean
    up, down = 0.5 * (start + fall.rate / k), 0.5 * (start - fall.rate / k)
    end = LYING - body.lean
    return fall.begin + log((end + sqrt(end * end - 4.0 * up * down)) / (2.0 * up)) / k


def rests_at(body: Body, fall: Fall) -> float:
    """Return when (s) the pin lies and slides no more."""
    return max(lies_at(body, fall), fall.begin + fall.speed / body.slowing)


def speed_at(body: Body, fall: Fall, time: float) -> float:
    """Return how fast (m/s) the foot slides."""
    if slid(body, fall, time) >= fall.room:
        return 0.0
    return max(fall.speed - body.slowing * max(time - fall.begin, 0.0), 0.0)


def rate_at(body: Body, fall: Fall, time: float) -> float:
    """Return how fast (rad/s) the tilt grows; by energy, so that it is never too much."""
    tilt = tilt_at(body, fall, time)
    if tilt >= LYING:
        return 0.0
    fell = cos(fall.tilt - body.lean) - cos(tilt - body.lean)
    return sqrt(max(fall.rate**2 + 2.0 * body.growth**2 * fell, 0.0))


def tip_end(body: Body, fall: Fall, time: float) -> float:
    """Return how far (m) along its way the middle of the pin's round head end has come."""
    return slid(body, fall, time) + (body.height - body.belly) * sin(tilt_at(body, fall, time))


@dataclass(frozen=True, slots=True)
class Aim:
    """Where a falling pin's end meets another pin: its way `far` (m), and the unit vector there.

    `push` leads from the middle of the end to the axis of the pin that is met.
    """

    far: float
    push: Point


def aim(body: Body, fall: Fall, other: Body) -> Aim | None:
    """Return how a falling pin's end meets a standing pin in its way; None for one beside it.

    The end is taken as a round as wide as the belly that goes straight along the fall.
    """
    dx, dy = other.at[0] - fall.foot[0], other.at[1] - fall.foot[1]
    (wx, wy), width = fall.way, body.belly + other.belly
    ahead, aside = dx * wx + dy * wy, dy * wx - dx * wy
    if ahead <= 0.0 or abs(aside) >= width:
        return None
    square, across = sqrt(1.0 - (aside / width) ** 2), aside / width
    return Aim(ahead - width * square, (square * wx - across * wy, square * wy + across * wx))


def meets_at(body: Body, fall: Fall, far: float) -> float:
    """Return when (s) a falling pin's end has come `far` (m), or infinity."""
    low, high = fall.begin, rests_at(body, fall)
    if tip_end(body, fall, high) < far:
        return inf
    for _ in range(80):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        if tip_end(body, fall, middle) < far:
            low = middle
        else:
            high = middle
    return high


def knock(body: Body, fall: Fall, other: Body, met: Aim, time: float) -> tuple[Blow | None, Fall]:
    """Return what a falling pin does to another that it meets, and how it falls on.

    The end has the mass of a body that slides and turns, 1 / (1 / m + l^2 / I); what it gives
    slows both. Where the other pin stands, the end stays there and slides no more.
    """
    tilt, speed = tilt_at(body, fall, time), speed_at(body, fall, time)
    rate = rate_at(body, fall, time)
    lever = (body.height - body.belly) * cos(tilt) if tilt < LYING else 0.0
    mass = 1.0 / (1.0 / body.mass + lever * lever / body.swing)
    square = met.push[0] * fall.way[0] + met.push[1] * fall.way[1]
    height = min(max(body.height * cos(tilt), body.belly), other.height)
    blow = strike_pin(other, mass, (speed + lever * rate) * square, height)
    foot = slid(body, fall, time)
    place = fall.foot[0] + foot * fall.way[0], fall.foot[1] + foot * fall.way[1]
    given = 0.0 if blow is None else blow.impulse * square
    slower = 0.0 if blow is None else max(speed - given / body.mass, 0.0)
    least = min(rate, BARELY * body.growth * max(body.lean - tilt, 0.0) + STIR)
    turning = max(rate - given * lever / body.swing, least)
    left = fall.room - foot
    return blow, Fall(fall.pin, time, place, fall.way, slower, tilt, turning, left)


STIR = 1e-3
"""The least rate (rad/s) at which a felled pin goes on falling."""


__all__ = [
    "LYING",
    "Aim",
    "Blow",
    "Body",
    "Fall",
    "aim",
    "body_of",
    "energy_given",
    "knock",
    "lies_at",
    "meets_at",
    "rate_at",
    "rests_at",
    "slid",
    "speed_at",
    "start_fall",
    "strike_pin",
    "tilt_at",
    "tip_end",
]
