"""What must be announced before a stroke, and the steps through what may be.

One idea: the rules say in words what they require; a Wanted is those words taken apart.
Invariant: a call never names a ball that is not on the table.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from engine.game.situation import cue_ball_of

if TYPE_CHECKING:
    from engine.game.situation import Situation
    from engine.table.furniture import BallId
    from engine.variant.variant import Variant
    from rulelang.evaluate import Admission
    from rulelang.facts import Call


@dataclass(frozen=True, slots=True)
class Wanted:
    """What the shooter has to announce, or may."""

    ball: bool = False
    pocket: bool = False
    safety: bool = False
    group: bool = False
    obliged: bool = False

    @property
    def anything(self) -> bool:
        """Whether there is anything to announce."""
        return self.ball or self.pocket or self.safety or self.group

    @property
    def in_words(self) -> str:
        """What has to be announced, in words."""
        asked = (("a ball", self.ball), ("a pocket", self.pocket))
        ways = [word for word, due in asked if due]
        main = [" and ".join(ways)] if ways else []
        said = ", or ".join([*main, *(["a safety"] if self.safety else [])])
        return ", if you like ".join(w for w in (said, "a group" if self.group else "") if w)

    def is_met(self, call: Call) -> bool:
        """Whether a call says all that must be said."""
        if not self.obliged or (self.safety and call.safety):
            return True
        return (call.ball is not None or not self.ball) and (
            call.pocket is not None or not self.pocket
        )


MAY = "may "
"""How what is only allowed begins."""


def wanted_of(admission: Admission, shooter: int) -> Wanted:
    """Return what `shooter` has to announce or may, from what the rules said."""
    said = [one.what for one in admission.required if one.player == shooter]
    words = {word for what in said for word in re.split(r"[^a-z]+", what.removeprefix(MAY))}
    return Wanted(
        ball="ball" in words,
        pocket="pocket" in words,
        safety="safety" in words,
        group="group" in words,
        obliged=any(not what.startswith(MAY) for what in said),
    )


def callable_balls(
    variant: Variant, situation: Situation, admission: Admission
) -> tuple[BallId, ...]:
    """Return the balls that can be called, first those that are on.

    `admission` is the one without a call, so that the order does not change with the call.
    """
    cue = cue_ball_of(variant, situation.shooter)
    lying = [kind.id for kind in variant.balls if kind.id in situation.on_table and kind.id != cue]
    return tuple(sorted(lying, key=lambda ball: ball not in admission.on))


def callable_groups(variant: Variant) -> tuple[str, ...]:
    """Return the groups that balls belong to and that do not hold every object ball."""
    names = dict.fromkeys(group for kind in variant.balls for group in kind.groups)
    return tuple(names)


def _next(options: tuple[str | None, ...], now: str | None, by: int) -> str | None:
    if not options:
        return None
    if now not in options:
        return options[0 if by > 0 else -1]
    return options[(options.index(now) + by) % len(options)]


def next_ball(call: Call, balls: tuple[BallId, ...], by: int) -> Call:
    """Return the call with the ball `by` places further."""
    return replace(call, ball=_next(balls, call.ball, by), safety=False)


def next_pocket(call: Call, variant: Variant, by: int) -> Call:
    """Return the call with the pocket `by` places further round the table."""
    pockets = tuple(str(pocket.id) for pocket in variant.world.table.pockets)
    return replace(call, pocket=_next(pockets, call.pocket, by), safety=False)


def next_group(call: Call, groups: tuple[str, ...]) -> Call:
    """Return the call with the next group, none after the last."""
    return replace(call, group=_next((None, *groups), call.group, 1))
