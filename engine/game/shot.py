"""One shot as a player makes it, or as a record tells it; and why one is refused.

One idea: what the player does is a value, and a mistake of the player is a Refusal value.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from math import degrees, radians
from typing import TYPE_CHECKING

from engine.game.situation import Rest, empty
from rulelang.facts import Call

if TYPE_CHECKING:
    from collections.abc import Mapping

    from engine.physics.world import Strike
    from engine.table.furniture import BallId, Point
    from engine.variant.variant import Value
    from rulelang.events import Event

NO_CALL = Call()
UNKNOWN = Rest()


@dataclass(frozen=True, slots=True)
class Shot:
    """A choice, a stroke, or both.

    `choice` is the option chosen before the shot. `struck` is the ball the tip struck, None
    for the shooter's own cue ball. `placement` is where the ball in hand was put (m). `facts`
    is what an eye at the table judged. `strike` is the stroke to be played, `events` what
    happened where no stroke is played, `after` the table at rest then.
    """

    choice: str | None = None
    call: Call = NO_CALL
    struck: BallId | None = None
    placement: Point | None = None
    facts: Mapping[str, Value] = field(default_factory=empty)
    strike: Strike | None = None
    events: tuple[Event, ...] | None = None
    after: Rest = UNKNOWN

    @property
    def is_only_choice(self) -> bool:
        """Whether nothing is struck."""
        return self.strike is None and self.events is None


def as_written(strike: Strike) -> Strike:
    """Return the stroke as a record can say it, its angles whole billionths of a degree.

    Every stroke is played so, and a record of it therefore plays the same bits again.
    """
    return replace(
        strike,
        heading=radians(round(degrees(strike.heading), 9)),
        elevation=radians(round(degrees(strike.elevation), 9)),
    )


@dataclass(frozen=True, slots=True)
class Refusal:
    """Why a shot cannot be played as it stands, and what would make it playable."""

    reason: str
    mend: str
