"""A game being played, as a value: what has happened, what is set, what the game waits for.

One idea: all that a player sees and sets is one frozen value; `steps` makes the next one of it.
Invariant: a session is complete, so a game can be driven and tested without a window.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING

from engine.app import calling, placing
from engine.app.choices import choosable_balls
from engine.app.stroke import Stroke, miscue_limit
from engine.game.shot import NO_CALL, Shot
from engine.game.situation import ball_to_strike

if TYPE_CHECKING:
    from engine.app.timing import Timing
    from engine.game.match import Match, Played
    from engine.game.situation import Situation
    from engine.game.verdict import Verdict
    from engine.physics.trace import Trace
    from engine.table.furniture import BallId, Point
    from engine.variant.variant import Variant
    from rulelang.evaluate import Admission
    from rulelang.facts import Call

SWING = 0.3
"""Seconds that the cue is seen to come forward."""


class Mode(Enum):
    """What the game waits for."""

    CHOOSING = "choose"
    PLACING = "place the ball"
    CALLING = "call"
    AIMING = "aim"
    STRIKING = "strike"
    ROLLING = "balls rolling"
    VERDICT = "verdict"
    OVER = "game over"
    ARRANGING = "arrange the balls"


class Aid(Enum):
    """How much of the shot is shown before it is played."""

    OFF = "off"
    LINE = "line"
    GHOST = "ghost"
    OBJECT = "object"
    ALL = "all"


BEFORE_STROKE = (Mode.PLACING, Mode.CALLING, Mode.AIMING)
SHOWING = (Mode.STRIKING, Mode.ROLLING)


@dataclass(frozen=True, slots=True)
class Session:
    """All that a player sees and sets.

    `ahead` is the situation that the stroke is played from: the match's own, after the choice.
    `struck` is the ball to strike where it is not the usual one, `held` the one that is moved while
    the balls are arranged. `place` is where the ball in
    hand is held. `trace` is the last stroke's, shown up to `clock`
    (s, below zero while the cue comes forward), `pace` times as fast as it was, or `halted`;
    `back_to` is where a replay leads back to. `note` is said to the player, `trouble` is the
    script's, `later` holds what was undone. `timing` is the time left on the timers of the script.
    """

    match: Match
    mode: Mode
    ahead: Situation
    admission: Admission
    stroke: Stroke
    timing: Timing
    choice: str | None = None
    picked: int = 0
    struck: BallId | None = None
    held: BallId | None = None
    place: Point | None = None
    placing: placing.Placing | None = None
    call: Call = NO_CALL
    trace: Trace | None = None
    clock: float = 0.0
    pace: float = 1.0
    halted: bool = False
    back_to: Mode | None = None
    note: str = ""
    trouble: str = ""
    later: tuple[Match, ...] = ()
    aid: Aid = Aid.OBJECT

    @property
    def variant(self) -> Variant:
        """The game being played."""
        return self.match.variant

    @property
    def names(self) -> tuple[str, ...]:
        """What the players are called, as far as they have names."""
        return self.match.names

    @property
    def last(self) -> Played | None:
        """The shot played last."""
        return self.match.played[-1] if self.match.played else None

    @property
    def last_stroke(self) -> Played | None:
        """The shot played last that was more than a choice."""
        strokes = (one for one in reversed(self.match.played) if one.shot.strike is not None)
        return next(strokes, None)

    @property
    def last_judged(self) -> Played | None:
        """The shot judged last that was more than a choice, a stroke left out as well."""
        judged = (one for one in reversed(self.match.played) if not one.shot.is_only_choice)
        return next(judged, None)

    @property
    def verdict(self) -> Verdict | None:
        """What the referee said last."""
        return self.last.verdict if self.last else None

    @property
    def is_showing(self) -> bool:
        """Whether the table shown is that of the last stroke, not the one to come."""
        return self.mode in (*SHOWING, Mode.VERDICT) and self.trace is not None

    @property
    def shown(self) -> Situation:
        """The situation that the display tells about."""
        if self.mode in SHOWING and self.back_to is None and self.last:
            return self.last.before
        return self.ahead if self.mode in (*BEFORE_STROKE, Mode.ARRANGING) else self.match.situation

    @property
    def cue_ball(self) -> BallId:
        """The ball that the coming stroke strikes."""
        return self.struck or ball_to_strike(self.variant, self.ahead)

    @property
    def strikable(self) -> tuple[BallId, ...]:
        """The balls on the bed that the coming stroke may strike, where there is a choice."""
        allowed, lying = self.ahead.strikable, self.ahead.rest.positions
        usual = ball_to_strike(self.variant, self.ahead)
        found = (ball.id for ball in self.variant.balls if ball.id in allowed or ball.id == usual)
        return tuple(ball for ball in found if ball in lying) if allowed and not self.place else ()

    @property
    def cue_place(self) -> Point | None:
        """Where the cue ball of the coming stroke is, as far as it is on the table."""
        return self.place or self.ahead.rest.positions.get(self.cue_ball)

    @property
    def layout(self) -> dict[BallId, Point]:
        """Where the balls lie before the stroke, the ball in hand where it is held."""
        lying = dict(self.ahead.rest.positions)
        if self.place is not None:
            lying[self.cue_ball] = self.place
        return lying

    @property
    def wanted(self) -> calling.Wanted:
        """What must or may be announced."""
        return calling.wanted_of(self.admission, self.ahead.shooter)

    @property
    def choosable(self) -> tuple[BallId, ...]:
        """The balls that the choice marked may be taken with, where it is about a ball."""
        situation = self.match.situation
        if self.mode is not Mode.CHOOSING:
            return ()
        return choosable_balls(self.variant, situation, situation.options[self.picked])

    @property
    def shot(self) -> Shot:
        """The shot as it would be played now."""
        return Shot(
            choice=self.choice,
            struck=self.struck,
            call=self.call,
            placement=self.place,
            strike=self.stroke.strike(),
        )

    @property
    def tip_limit(self) -> float:
        """How far off centre the tip may strike, in ball radii."""
        return miscue_limit(self.variant.world.cue.tip_friction)
