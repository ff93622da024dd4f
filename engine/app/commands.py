"""What a player asks of the game, as values: the only way to change a session.

One idea: keys, mouse and scripts all speak these words, so that a game can be driven without a
window.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from engine.table.furniture import BallId, PocketId, Point


@dataclass(frozen=True, slots=True)
class Turn:
    """Turn the aim counter-clockwise by degrees."""

    by: float


@dataclass(frozen=True, slots=True)
class AimAt:
    """Aim from the cue ball over a point of the cloth (m)."""

    point: Point


@dataclass(frozen=True, slots=True)
class SetSpeed:
    """Set the speed of the cue, m/s."""

    speed: float


@dataclass(frozen=True, slots=True)
class SetTip:
    """Set where the tip strikes, in ball radii right of and above the centre."""

    side: float
    follow: float


@dataclass(frozen=True, slots=True)
class MoveTip:
    """Move the tip by ball radii to the right and upward."""

    side: float
    follow: float


@dataclass(frozen=True, slots=True)
class SetElevation:
    """Set how far the butt is raised, degrees."""

    elevation: float


@dataclass(frozen=True, slots=True)
class MoveBall:
    """Move the ball in hand by metres."""

    dx: float
    dy: float


@dataclass(frozen=True, slots=True)
class PutBall:
    """Put the ball in hand at a point (m), or as near as it may be."""

    point: Point


@dataclass(frozen=True, slots=True)
class Pick:
    """Go `by` places down the list of choices."""

    by: int


@dataclass(frozen=True, slots=True)
class Choose:
    """Take the choice with this place in the list, from 0."""

    index: int


@dataclass(frozen=True, slots=True)
class CallNextBall:
    """Call the ball `by` places further in the list of balls."""

    by: int


@dataclass(frozen=True, slots=True)
class CallBall:
    """Call this ball."""

    ball: BallId


@dataclass(frozen=True, slots=True)
class CallNextPocket:
    """Call the pocket `by` places further round the table."""

    by: int


@dataclass(frozen=True, slots=True)
class CallPocket:
    """Call this pocket."""

    pocket: PocketId


@dataclass(frozen=True, slots=True)
class CallSafety:
    """Call a safety, or take it back."""


@dataclass(frozen=True, slots=True)
class CallNextGroup:
    """Call a group, the next one, or none."""


@dataclass(frozen=True, slots=True)
class StrikeNextBall:
    """Strike the ball `by` places further among those that may be struck."""

    by: int


@dataclass(frozen=True, slots=True)
class Arrange:
    """Begin to arrange the balls, or end it."""


@dataclass(frozen=True, slots=True)
class TakeOff:
    """Take the ball that is held off the table, or bring one back."""


@dataclass(frozen=True, slots=True)
class Repeat:
    """Go back to before the last stroke, with that stroke set."""


@dataclass(frozen=True, slots=True)
class Confirm:
    """Accept: the place, the call, the stroke, the verdict."""


@dataclass(frozen=True, slots=True)
class Back:
    """Go back to the call or the placing before the stroke."""


@dataclass(frozen=True, slots=True)
class Undo:
    """Take the last shot back."""


@dataclass(frozen=True, slots=True)
class Redo:
    """Play the shot that was taken back again."""


@dataclass(frozen=True, slots=True)
class Replay:
    """Show the last shot again, `pace` times as fast as it was."""

    pace: float = 1.0


@dataclass(frozen=True, slots=True)
class StepShown:
    """Halt the showing so many single steps further."""

    by: int


@dataclass(frozen=True, slots=True)
class ChangePace:
    """Show the shot so many degrees faster, or slower."""

    by: int


@dataclass(frozen=True, slots=True)
class Skip:
    """Show the end of the shot at once."""


@dataclass(frozen=True, slots=True)
class NextGame:
    """Start another game, when this one is over."""


@dataclass(frozen=True, slots=True)
class ChangeAid:
    """Go to the next aiming aid."""


Command = (
    Turn
    | AimAt
    | SetSpeed
    | SetTip
    | MoveTip
    | SetElevation
    | MoveBall
    | PutBall
    | Pick
    | Choose
    | CallNextBall
    | CallBall
    | CallNextPocket
    | CallPocket
    | CallSafety
    | CallNextGroup
    | StrikeNextBall
    | Arrange
    | TakeOff
    | Repeat
    | Confirm
    | Back
    | Undo
    | Redo
    | Replay
    | StepShown
    | ChangePace
    | Skip
    | NextGame
    | ChangeAid
)
