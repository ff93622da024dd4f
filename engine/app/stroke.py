"""The stroke as the player sets it: degrees and steps that read well on the screen.

One idea: every quantity moves in whole steps of its own, so that a number shown is the number
played. Invariant: the tip never goes beyond the miscue limit.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import atan2, cos, degrees, hypot, pi, radians, sin, sqrt

from engine.physics.world import Strike

SLOWEST, FASTEST = 0.05, 12.0
"""Speeds of the cue, m/s."""
STEEPEST = 80.0
"""Degrees."""


def miscue_limit(tip_friction: float) -> float:
    """Return how far off centre, in ball radii, a tip of this friction still grips.

    The contact's normal leans by asin(offset); it grips while tan of that is below friction.
    """
    return tip_friction / sqrt(1.0 + tip_friction * tip_friction)


@dataclass(frozen=True, slots=True)
class Stroke:
    """Heading in degrees, counter-clockwise from +x; speed in m/s; tip offsets in radii."""

    heading: float = 0.0
    speed: float = 2.0
    elevation: float = 0.0
    side: float = 0.0
    follow: float = 0.0

    def strike(self) -> Strike:
        """Return the stroke in the units of the physics."""
        return Strike(
            speed=self.speed,
            heading=radians(self.heading),
            elevation=radians(self.elevation),
            side=self.side,
            follow=self.follow,
        )

    def turned(self, by: float) -> Stroke:
        """Return the stroke turned counter-clockwise by degrees."""
        return self.headed(self.heading + by)

    def headed(self, heading: float) -> Stroke:
        """Return the stroke with a new heading, within -180 to 180, in steps of 0.01 as shown."""
        whole = round(heading, 2)
        return replace(self, heading=round((whole + 180.0) % 360.0 - 180.0, 2))

    def at(self, speed: float) -> Stroke:
        """Return the stroke with a new speed, within what an arm can do."""
        return replace(self, speed=round(min(max(speed, SLOWEST), FASTEST), 2))

    def raised(self, elevation: float) -> Stroke:
        """Return the stroke with the butt raised to degrees."""
        return replace(self, elevation=round(min(max(elevation, 0.0), STEEPEST), 1))

    def tipped(self, side: float, follow: float, limit: float) -> Stroke:
        """Return the stroke with the tip at an offset, clamped to `limit` radii off centre."""
        side, follow = round(side, 3), round(follow, 3)
        off = hypot(side, follow)
        if off > limit:
            side = int(side / off * limit * 1000.0) / 1000.0
            follow = int(follow / off * limit * 1000.0) / 1000.0
        return replace(self, side=side, follow=follow)


def stroke_of(strike: Strike) -> Stroke:
    """Return the stroke that is played by a strike, to a billionth of a degree."""
    return Stroke(
        round(degrees(strike.heading), 9),
        strike.speed,
        round(degrees(strike.elevation), 9),
        strike.side,
        strike.follow,
    )


def heading_to(start: tuple[float, float], end: tuple[float, float]) -> float:
    """Return the heading in degrees from one place (m) to another."""
    return degrees(atan2(end[1] - start[1], end[0] - start[0]))


def direction(heading: float) -> tuple[float, float]:
    """Return the unit vector of a heading in degrees."""
    turn = heading * pi / 180.0
    return cos(turn), sin(turn)
