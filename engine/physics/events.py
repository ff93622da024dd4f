"""What happened in a shot, as the solver saw it: one class per event, in the past tense.

Times are seconds after the tip's contact. Whoever is named first in a meeting of two balls is
the faster along the line of centres at that moment.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from engine.table.furniture import BallId, CushionId, PinId, PocketId


@dataclass(frozen=True, slots=True)
class BallsCollided:
    """Two balls met; `speed` is the closing speed along the line of centres, m/s."""

    time: float
    ball: BallId
    other: BallId
    speed: float


@dataclass(frozen=True, slots=True)
class CushionHit:
    """A ball met a cushion's nose with normal speed `speed`, m/s."""

    time: float
    ball: BallId
    cushion: CushionId
    speed: float


@dataclass(frozen=True, slots=True)
class JawHit:
    """A ball met a jaw of a pocket with normal speed `speed`, m/s."""

    time: float
    ball: BallId
    pocket: PocketId
    speed: float


@dataclass(frozen=True, slots=True)
class BallPocketed:
    """A ball dropped into a pocket."""

    time: float
    ball: BallId
    pocket: PocketId


@dataclass(frozen=True, slots=True)
class BallLeftTable:
    """A ball left the bed for good."""

    time: float
    ball: BallId


@dataclass(frozen=True, slots=True)
class BallLanded:
    """A flying ball came down on the bed, or on the `rail`, with vertical speed `speed`, m/s."""

    time: float
    ball: BallId
    speed: float
    rail: bool = False


@dataclass(frozen=True, slots=True)
class BallLeftBed:
    """A ball began to fly; bounces of one that flies are not told again."""

    time: float
    ball: BallId


@dataclass(frozen=True, slots=True)
class BallJumpedOver:
    """A flying ball passed over another: told when their centres were nearest, seen from above."""

    time: float
    ball: BallId
    other: BallId


@dataclass(frozen=True, slots=True)
class PinToppled:
    """A pin began to fall; `by` are the balls or the falling pins that felled it, all at once."""

    time: float
    pin: PinId
    by: tuple[BallId | PinId, ...]


@dataclass(frozen=True, slots=True)
class PinTouched:
    """A ball or a falling pin met a pin that stood it."""

    time: float
    pin: PinId
    by: BallId | PinId


@dataclass(frozen=True, slots=True)
class RollingBegan:
    """A sliding ball's slip ended."""

    time: float
    ball: BallId


@dataclass(frozen=True, slots=True)
class BallStopped:
    """A ball came to rest, spin included."""

    time: float
    ball: BallId


Event = (
    BallsCollided
    | CushionHit
    | JawHit
    | BallPocketed
    | BallLeftTable
    | BallLanded
    | BallLeftBed
    | BallJumpedOver
    | PinToppled
    | PinTouched
    | RollingBegan
    | BallStopped
)
