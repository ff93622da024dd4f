"""What can be heard of a shot: which noises fall into a stretch of time, and how loud.

One idea: every noise is an event of the trace, its loudness a matter of its speed. Invariant:
cutting a shot's time into stretches neither loses a noise nor doubles one.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING

from engine.physics import events as seen

if TYPE_CHECKING:
    from collections.abc import Iterable

POCKETED_SPEED = 1.0
"""What a ball that drops sounds like, m/s; the trace does not say how fast it falls."""

FULL = 6.0
"""A speed (m/s) from which on a noise gets no louder."""

FAINTEST = 0.02
"""A share of the full loudness that is not worth hearing."""


class Kind(Enum):
    """What makes the noise."""

    TIP = "tip"
    BALL = "ball"
    CUSHION = "cushion"
    POCKET = "pocket"
    BED = "bed"
    PIN = "pin"


@dataclass(frozen=True, slots=True)
class Noise:
    """A noise at `time` (s), of a loudness from 0 to 1."""

    time: float
    kind: Kind
    loudness: float


def noises_of(events: Iterable[seen.Event], tip_speed: float) -> tuple[Noise, ...]:
    """Return a shot's noises in their order; the tip's (cue at `tip_speed`, m/s) comes first."""
    found = [_noise(0.0, Kind.TIP, tip_speed)]
    for event in events:
        match event:
            case seen.BallsCollided(time, _, _, speed):
                found.append(_noise(time, Kind.BALL, speed))
            case seen.CushionHit(time, _, _, speed) | seen.JawHit(time, _, _, speed):
                found.append(_noise(time, Kind.CUSHION, speed))
            case seen.BallPocketed(time):
                found.append(_noise(time, Kind.POCKET, POCKETED_SPEED))
            case seen.BallLanded(time, _, speed):
                found.append(_noise(time, Kind.BED, speed))
            case seen.PinToppled(time) | seen.PinTouched(time):
                found.append(_noise(time, Kind.PIN, POCKETED_SPEED))
    return tuple(one for one in found if one.loudness >= FAINTEST)


def _noise(time: float, kind: Kind, speed: float) -> Noise:
    """Loudness grows with the root of the speed, as hearing makes small things large."""
    return Noise(time, kind, min(max(speed, 0.0) / FULL, 1.0) ** 0.5)


def between(noises: Iterable[Noise], start: float, end: float) -> list[Noise]:
    """Return the noises after `start` up to `end` (s); the tip's belongs to the first stretch."""
    return [one for one in noises if start < one.time <= end]
