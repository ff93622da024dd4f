"""What the referee says after a shot.

One idea: a verdict is a value made once; the situation that follows is made from it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rulelang.frozen import value

if TYPE_CHECKING:
    from engine.game.situation import Situation
    from engine.table.furniture import BallId, SpotId
    from rulelang.decisions import Foul, RuleOutcome
    from rulelang.events import Event


@value
class Spotted:
    """A ball put back: `on` its `spot`, or as near to it as the game allows; no spot: anywhere."""

    ball: BallId
    spot: SpotId | None
    on: bool


@value
class Verdict:
    """The referee's words on one shot.

    `points` is the change of each player's score, `reracked` the number of balls racked,
    `explanation` how every rule fared, `events` what was judged.
    """

    fouls: tuple[Foul, ...]
    points: tuple[int, ...]
    spotted: tuple[Spotted, ...]
    removed: tuple[BallId, ...]
    reracked: int
    explanation: tuple[RuleOutcome, ...]
    events: tuple[Event, ...]
    after: Situation
    """The situation before the next shot."""

    @property
    def is_foul(self) -> bool:
        """Whether the shot was a foul."""
        return bool(self.fouls)
