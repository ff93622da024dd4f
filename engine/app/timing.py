"""The timers of a script as the window runs them.

One idea: time for a shot or a turn runs while the shooter is at the table, time for a game or the
match whenever the game goes on. A timer by which the referee would say something else of a stroke
left out ends the player's time at once; any other is told with the next stroke. Invariant: no real
clock is read here; what is taken back takes its time back.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from engine.app.telling import BOOKKEEPING
from engine.game.clock import Clock, rewind, run, time_out, wind
from engine.game.referee import judge_shot
from engine.game.situation import empty

if TYPE_CHECKING:
    from collections.abc import Container, Iterable, Mapping

    from engine.app.session import Session
    from engine.game.match import Match
    from engine.game.shot import Shot

Moment = tuple[int, int]
"""A moment of a match: games and shots before it."""


@dataclass(frozen=True, slots=True)
class Timing:
    """Time left, and as it was when each shot began.

    `ran_out` are the timers to be told with the next shot, `counting` those by which the time of
    the shooter ends, None before the referee was asked.
    """

    clock: Clock
    began: Mapping[Moment, Clock] = field(default_factory=empty)
    ran_out: tuple[str, ...] = ()
    counting: frozenset[str] | None = None


def timing_of(match: Match, times: Mapping[Moment, Mapping[str, float]] = empty()) -> Timing:
    """Return the timing of a match, from what a journal says of its `times`.

    Without them all of the time is left, but for what was told to be out.
    """
    clock = wind(match.variant.program.timers)
    began = {moment: _clock(clock, left) for moment, left in times.items()}
    if _moment(match) in began:
        return _entered(Timing(began[_moment(match)], began), match)
    out = {name for name in clock.left if _told(match, name)}
    left = {name: 0.0 if name in out else time for name, time in clock.left.items()}
    return _entered(Timing(replace(clock, left=left), began), match)


def _clock(full: Clock, left: Mapping[str, float]) -> Clock:
    """Return a clock with the time left that a journal tells, as far as the script has timers."""
    told = {name: min(left.get(name, time), time) for name, time in full.left.items()}
    return replace(full, left=told)


def _told(match: Match, name: str) -> bool:
    """Whether it was told already, in the time that a timer runs for, that it ran out."""
    per = match.variant.program.timers[name].per
    return per in ("game", "match") and any(
        one.shot.facts.get(name) is True
        for one in match.played
        if per == "match" or one.before.games == match.situation.games
    )


def timed_back(timing: Timing, match: Match) -> Timing:
    """Return the timing as it was when the match was where it is now."""
    known = timing.began.get(_moment(match))
    return timing_of(match) if known is None else Timing(known, timing.began)


def timed_on(timing: Timing, match: Match) -> Timing:
    """Return the timing before the shot that comes after the last one of a match."""
    last = match.played[-1]
    return _entered(
        replace(timing, clock=rewind(timing.clock, last.before, match.situation)), match
    )


def timed_anew(timing: Timing, match: Match) -> Timing:
    """Return the timing at the start of another game of a match, or under another script."""
    same = timing.clock.timers == match.variant.program.timers
    return _entered(timing, match) if same else timing_of(match)


def _entered(timing: Timing, match: Match) -> Timing:
    began = {**timing.began, _moment(match): timing.clock}
    return Timing(timing.clock, began)


def _moment(match: Match) -> Moment:
    return match.situation.games, len(match.played)


def run_down(timing: Timing, seconds: float, units: Container[str]) -> Timing:
    """Return the timing `seconds` later, where the timers per one of `units` run."""
    timers = {name: one for name, one in timing.clock.timers.items() if one.per in units}
    part, out = run(Clock(timers, {name: timing.clock.left[name] for name in timers}), seconds)
    clock = replace(timing.clock, left={**timing.clock.left, **part.left})
    return replace(timing, clock=clock, ran_out=(*timing.ran_out, *out))


def timed_out(session: Session, timers: Iterable[str]) -> Shot:
    """Return the shot that a player did not play before these timers ran out."""
    return replace(time_out(*timers), choice=session.choice, call=session.call)


def counting_of(session: Session) -> frozenset[str]:
    """Return the timers by which the referee would speak otherwise of a stroke left out."""
    without = _said(session, ())
    timers = session.timing.clock.timers
    return frozenset(name for name in timers if _said(session, (name,)) - without)


def _said(session: Session, timers: tuple[str, ...]) -> set[tuple[str, str]]:
    """Return what each rule says, bookkeeping apart, of the stroke left out."""
    verdict = judge_shot(session.variant, session.match.situation, timed_out(session, timers))
    return {
        (one.rule, said)
        for one in verdict.explanation
        if one.outcome == "fired"
        for said in one.said
        if not said.startswith(BOOKKEEPING)
    }
