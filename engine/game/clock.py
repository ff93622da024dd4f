"""The timers of a match: how much time is left, and the shot that is no shot because it ran out.

One idea: a clock is a value that is handed the seconds that went by; whoever has a real clock,
a window or a test, winds it. Invariant: no timer falls below zero, and one that ran out tells so
once.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from engine.game.shot import Shot
from rulelang.events import StrokeOmitted

if TYPE_CHECKING:
    from collections.abc import Mapping

    from engine.game.situation import Situation
    from rulelang.program import Timer


@dataclass(frozen=True, slots=True)
class Clock:
    """Seconds left for each timer of a script."""

    timers: Mapping[str, Timer]
    left: Mapping[str, float]


def wind(timers: Mapping[str, Timer]) -> Clock:
    """Return a clock on which every timer has all its time."""
    return Clock(timers, {name: timer.seconds for name, timer in timers.items()})


def run(clock: Clock, seconds: float) -> tuple[Clock, tuple[str, ...]]:
    """Return the clock `seconds` later, and the timers that ran out meanwhile."""
    left = {name: max(0.0, time - seconds) for name, time in clock.left.items()}
    out = tuple(name for name, time in left.items() if time == 0 < clock.left[name])
    return Clock(clock.timers, left), out


def rewind(clock: Clock, before: Situation, after: Situation) -> Clock:
    """Return the clock for the shot after one: timers whose time begins anew have all of it."""
    anew = {"shot"}
    if after.shooter != before.shooter or after.over:
        anew.add("turn")
    if after.over:
        anew.add("game")
    left = {
        name: timer.seconds if timer.per in anew else clock.left[name]
        for name, timer in clock.timers.items()
    }
    return Clock(clock.timers, left)


def time_out(*timers: str) -> Shot:
    """Return the shot to be judged when timers ran out before a stroke was played."""
    return Shot(events=(StrokeOmitted(),), facts=dict.fromkeys(timers, True))
