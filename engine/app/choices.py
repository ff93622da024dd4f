"""What a choice means, in a player's words.

One idea: the script is asked what would follow, and the difference is told: who plays, from
where, what is racked, put back or on.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING

from engine.app.trouble import ScriptTrouble
from engine.app.words import (
    ball_name,
    capital,
    named_balls,
    player_name,
    result_words,
    spoken,
    zone_name,
)
from engine.game.referee import look_ahead, take_choice
from engine.game.shot import NO_CALL, Shot
from engine.game.situation import cue_ball_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from engine.game.situation import Situation
    from engine.game.verdict import Verdict
    from engine.table.furniture import BallId
    from engine.variant.variant import Variant


def choosable_balls(variant: Variant, situation: Situation, option: str) -> tuple[BallId, ...]:
    """Return the balls that an option may be taken with; none where no ball changes it.

    The rules are asked what follows with each of two balls: where that differs, any may be named.
    """
    return _choosable(_Moment(variant, situation), option)


@dataclass(frozen=True, slots=True, eq=False)
class _Moment:
    """A moment of a match as a key: one and the same, since comparing two takes long."""

    variant: Variant
    situation: Situation

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, _Moment)
            and self.variant is other.variant
            and self.situation is other.situation
        )

    def __hash__(self) -> int:
        return hash((id(self.variant), id(self.situation)))


@lru_cache(maxsize=32)
def _choosable(moment: _Moment, option: str) -> tuple[BallId, ...]:
    variant, situation = moment.variant, moment.situation
    lying = [kind.id for kind in variant.balls if kind.id in situation.rest.positions]
    cue = cue_ball_of(variant, situation.shooter)
    lying = [ball for ball in lying if ball != cue]
    try:
        first, second = (
            take_choice(variant, situation, _with_ball(option, ball), explain=False).after.on_table
            for ball in lying[:2]
        )
    except (*ScriptTrouble, ValueError):
        return ()
    return tuple(lying) if first != second else ()


def _with_ball(option: str, ball: str | None) -> Shot:
    return Shot(choice=option, call=replace(NO_CALL, ball=ball))


def choice_words(
    variant: Variant,
    situation: Situation,
    option: str,
    ball: str | None = None,
    names: Sequence[str] = (),
) -> str:
    """Return what follows when an option is taken; empty where the rules cannot tell."""
    return _words(_Moment(variant, situation), option, ball, tuple(names))


@lru_cache(maxsize=32)
def _words(moment: _Moment, option: str, ball: str | None, names: tuple[str, ...]) -> str:
    variant, situation = moment.variant, moment.situation
    try:
        chosen = take_choice(variant, situation, _with_ball(option, ball), explain=False)
        after = chosen.after
        if after.over:
            return capital(result_words(after, names))
        said = [_who_plays(variant, after, names), *_table_words(variant, situation, chosen)]
        now, then = look_ahead(variant, situation).on, look_ahead(variant, after).on
    except ScriptTrouble:
        return ""
    there = after.on_table - {cue_ball_of(variant, after.shooter)}
    if then != now and not chosen.reracked:
        on = [kind.id for kind in variant.balls if kind.id in then and kind.id in there]
        said += [f"on: {named_balls(variant, on, there)}"]
    return capital("; ".join(said))


def _who_plays(variant: Variant, after: Situation, names: Sequence[str]) -> str:
    who = player_name(after.shooter, names)
    if after.in_hand is None:
        return f"{who} plays from where the balls lie"
    ball = ball_name(variant, cue_ball_of(variant, after.shooter))
    return f"{who} plays, {ball} in hand ({zone_name(after.in_hand)})"


def _table_words(variant: Variant, before: Situation, chosen: Verdict) -> list[str]:
    """Return what is done to the balls."""
    if chosen.reracked:
        return ["the balls are racked again"]
    back = [ball_name(variant, one.ball) for one in chosen.spotted]
    back = [f"{_told_apart(ball)} back on the table" for ball in back]
    gone = before.on_table - chosen.after.on_table
    back += [
        f"{_told_apart(ball_name(variant, kind.id))} off the table"
        for kind in variant.balls
        if kind.id in gone
    ]
    moved = {
        ball
        for ball, at in chosen.after.rest.positions.items()
        if before.rest.positions.get(ball) != at
    } - {one.ball for one in chosen.spotted}
    if moved - {cue_ball_of(variant, chosen.after.shooter)}:
        back.append("the balls go back to where they lay before the stroke")
    return back


def _told_apart(ball: str) -> str:
    """Return a ball's name that is not taken for a count."""
    return f"ball {ball}" if ball.isdigit() else ball


def option_name(option: str) -> str:
    """Return an option as a player reads it."""
    return capital(spoken(option))
