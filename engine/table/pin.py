"""The shape of a pin: where a ball meets it, where its weight is, how hard it is to turn.

One idea: a pin is a turned body of even density, straight between the heights of its profile, so
all of it follows from a few radii. Invariant: pure functions of plain numbers, in SI units.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import sqrt
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from engine.table.furniture import BallId, Pin, Point

    Profile = Sequence[tuple[float, float]]

AIR = 1e-5
"""A ball nearer to a pin's place than touching by this (m) leaves no room to put the pin up."""

_GAUSS = ((-sqrt(0.6), 5.0 / 9.0), (0.0, 8.0 / 9.0), (sqrt(0.6), 5.0 / 9.0))
"""Places and weights of a rule that is exact up to the fifth degree."""


@dataclass(frozen=True, slots=True)
class Stance:
    """How a pin stands or lies: where its foot is (m), and its tilt (rad) along `way`."""

    foot: Point
    way: Point = (1.0, 0.0)
    tilt: float = 0.0


@dataclass(frozen=True, slots=True)
class Solid:
    """Height of the centre of mass (m), and the inertia about a level axis there over the mass."""

    centre: float
    spread: float


def solid_of(profile: Profile) -> Solid:
    """Return how the mass of a pin is spread over its height."""
    volume = _integral(profile, lambda _, r: r * r)
    centre = _integral(profile, lambda z, r: r * r * z) / volume
    turning = _integral(profile, lambda z, r: r * r * (0.25 * r * r + (z - centre) ** 2))
    return Solid(centre, turning / volume)


def _integral(profile: Profile, value: Callable[[float, float], float]) -> float:
    total = 0.0
    for (low, narrow), (high, wide) in pairwise(profile):
        middle, half = 0.5 * (low + high), 0.5 * (high - low)
        for place, weight in _GAUSS:
            share = 0.5 * (1.0 + place)
            radius = narrow + share * (wide - narrow)
            total += half * weight * value(middle + half * place, radius)
    return total


def meeting(profile: Profile, radius: float) -> tuple[float, float]:
    """Return how far apart the axes are when a ball on the bed touches a pin, and how high (m).

    At height z the ball is sqrt(R^2 - (R - z)^2) wide; the two touch where this and the pin's
    radius make the most together.
    """
    best = (0.0, 0.0)
    for (low, narrow), (high, wide) in pairwise(profile):
        slope = (wide - narrow) / (high - low)
        peak = radius + radius * slope / sqrt(1.0 + slope * slope)
        z = min(max(peak, low), high, 2.0 * radius)
        if z >= low:
            half = sqrt(max(radius * radius - (radius - z) ** 2, 0.0))
            best = max(best, (narrow + slope * (z - low) + half, z))
    return best


def standing(
    pins: Sequence[Pin], balls: Mapping[BallId, Point], radii: Mapping[BallId, float]
) -> tuple[bool, ...]:
    """Return which pins can be put up beside balls at these places: those with air around them.

    `radii` (m) has all balls that there are; a pin keeps as far from a small ball as from the
    surface of the largest one. Source: DDBU, a pin whose place is blocked waits.
    """
    largest = max(radii.values(), default=0.0)

    def has_air(pin: Pin, at: Point, radius: float) -> bool:
        square = _square(pin.at, at)
        if square > (radius + pin.belly + AIR) ** 2:
            return True
        own = meeting(pin.profile, radius)[0]
        need = max(own, meeting(pin.profile, largest)[0] - largest + radius) + AIR
        return square >= need * need

    return tuple(all(has_air(pin, at, radii[ball]) for ball, at in balls.items()) for pin in pins)


def _square(a: Point, b: Point) -> float:
    return (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2


__all__ = ["AIR", "Solid", "Stance", "meeting", "solid_of", "standing"]
