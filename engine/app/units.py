"""Lengths and speeds as the player wants to read them.

One idea: the program counts in metres and seconds; what is shown is turned into the player's units
at the last moment. Invariant: what is played never depends on them.
"""

from __future__ import annotations

from enum import Enum

INCH = 0.0254
MILE_AN_HOUR = 0.44704
LONG = 3.0
"""Metres from which a length is told in the greater unit."""


class Units(Enum):
    """What the display counts in."""

    METRIC = "metric"
    IMPERIAL = "imperial"

    def speed(self, metres_a_second: float) -> str:
        """Return a speed in words."""
        if self is Units.IMPERIAL:
            return f"{metres_a_second / MILE_AN_HOUR:.2f} mph"
        return f"{metres_a_second:.2f} m/s"

    def length(self, metres: float) -> str:
        """Return a length in words: centimetres or inches; metres or feet where it is long."""
        if metres >= LONG:
            is_metric = self is not Units.IMPERIAL
            return f"{metres:.2f} m" if is_metric else f"{metres / (12 * INCH):.1f} ft"
        if self is Units.IMPERIAL:
            return f"{metres / INCH:.2f} in"
        return f"{100.0 * metres:.1f} cm"

    def place(self, point: tuple[float, float]) -> str:
        """Return a place on the table: along it and across it, from its middle."""
        return f"{self.length(point[0])}, {self.length(point[1])}"
