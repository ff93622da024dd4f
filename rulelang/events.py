"""What can happen in a shot, as the rules speak of it: one class per event, in the past tense.

One idea: these are the events of a shot record. `time` is seconds after the tip's contact, or
None where nobody measured it. Names are those of the variant.
"""

from __future__ import annotations

from rulelang.frozen import value


@value
class BallsHit:
    """`ball` touched each of `others` at once; the cue ball is named first."""

    ball: str
    others: tuple[str, ...]
    time: float | None = None


@value
class CushionHit:
    """A ball touched a cushion, or was pressed into one that it was frozen to."""

    ball: str
    cushion: str
    time: float | None = None


@value
class CushionLeft:
    """A ball frozen to a cushion at the start came clear of it."""

    ball: str
    cushion: str
    time: float | None = None


@value
class JawHit:
    """A ball touched a jaw of a pocket."""

    ball: str
    pocket: str
    time: float | None = None


@value
class OutsideHit:
    """A ball touched something that is no part of the table and came back."""

    ball: str
    time: float | None = None


@value
class Pocketed:
    """A ball went into a pocket and stayed there."""

    ball: str
    pocket: str
    time: float | None = None


@value
class Rebounded:
    """A ball came back to the bed out of a pocket."""

    ball: str
    pocket: str
    time: float | None = None


@value
class Settled:
    """A ball fell into a pocket `delay` seconds after all balls had stopped."""

    ball: str
    pocket: str
    delay: float
    time: float | None = None


@value
class LeftTable:
    """A ball ended neither on the bed nor in a pocket."""

    ball: str
    time: float | None = None


@value
class LineCrossed:
    """A ball passed a line, either way."""

    ball: str
    line: str
    time: float | None = None


@value
class ZoneEntered:
    """A ball came into a zone."""

    ball: str
    zone: str
    time: float | None = None


@value
class ZoneLeft:
    """A ball went out of a zone."""

    ball: str
    zone: str
    time: float | None = None


@value
class JumpedOver:
    """A ball passed over another in the air."""

    ball: str
    other: str
    time: float | None = None


@value
class PinToppled:
    """One body, or several at once, made a pin fall."""

    bodies: tuple[str, ...]
    pin: str
    time: float | None = None


@value
class PinTouched:
    """A body touched a pin without toppling it, or after it was down."""

    body: str
    pin: str
    time: float | None = None


@value
class PinLeaned:
    """A pin came to rest against a ball."""

    pin: str
    ball: str
    time: float | None = None


@value
class TipHitAgain:
    """The tip touched the ball a second time in the stroke."""

    ball: str
    time: float | None = None


@value
class TipFollowed:
    """The tip stayed with the ball: a push."""

    ball: str
    time: float | None = None


@value
class PlayerTouched:
    """Body, clothes or cue touched a ball, the stroke itself apart."""

    ball: str
    time: float | None = None


@value
class FootLifted:
    """No foot was on the floor at the stroke (`foot off floor`)."""

    time: float | None = None


@value
class PlayedTooSoon:
    """The stroke was played before all balls were at rest (`balls moving`)."""

    time: float | None = None


@value
class StrokeOmitted:
    """The turn ended without a stroke (`no stroke`)."""

    time: float | None = None


@value
class TimeCalled:
    """Time ran out while the shot was going on."""

    time: float | None = None


Event = (
    BallsHit
    | CushionHit
    | CushionLeft
    | JawHit
    | OutsideHit
    | Pocketed
    | Rebounded
    | Settled
    | LeftTable
    | LineCrossed
    | ZoneEntered
    | ZoneLeft
    | JumpedOver
    | PinToppled
    | PinTouched
    | PinLeaned
    | TipHitAgain
    | TipFollowed
    | PlayerTouched
    | FootLifted
    | PlayedTooSoon
    | StrokeOmitted
    | TimeCalled
)
