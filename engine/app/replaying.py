"""Looking at a stroke: again, slower or faster, halted, a step on or back.

One idea: a stroke that is shown is a moment of its trace; only that moment moves. Invariant:
nothing that is looked at changes the match.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from engine.app.session import SHOWING, SWING, Mode, Session
from engine.game.observe import simulate_shot
from engine.game.referee import take_choice

if TYPE_CHECKING:
    from engine.physics.trace import Trace

PACES = (0.1, 0.25, 0.5, 1.0, 2.0, 4.0)
"""How many times as fast as it was a stroke can be shown."""
STEP = 0.02
"""Seconds of a single step."""


def replay(session: Session, pace: float) -> Session:
    """Return the session in which the last stroke is shown, from its beginning.

    While one is shown, that one begins anew.
    """
    if session.mode in SHOWING:
        return replace(session, clock=-SWING, mode=Mode.STRIKING, pace=pace, halted=False)
    trace = _trace(session)
    if trace is None:
        return session
    return replace(
        session,
        trace=trace,
        mode=Mode.STRIKING,
        clock=-SWING,
        pace=pace,
        halted=False,
        back_to=session.mode,
        note="",
    )


def _trace(session: Session) -> Trace | None:
    """Return the last stroke's trace, played again where it is not at hand."""
    last = session.last_stroke
    if last is None or session.trace is not None:
        return session.trace if last is not None else None
    before = take_choice(session.variant, last.before, last.shot).after
    return simulate_shot(session.variant, before, last.shot)


def show(session: Session, seconds: float) -> Session:
    """Return the session in which the showing has moved on by `seconds` of the player's time."""
    if session.mode not in SHOWING or session.trace is None or session.halted:
        return session
    clock = session.clock + seconds * session.pace
    if clock >= session.trace.duration:
        return finish(session)
    return replace(session, clock=clock, mode=_mode_at(clock))


def finish(session: Session) -> Session:
    """Return the session at the end of what is shown."""
    end = session.trace.duration if session.trace else 0.0
    after = replace(session, clock=end, halted=False)
    if session.back_to is not None:
        return replace(after, mode=session.back_to, back_to=None)
    return replace(after, mode=Mode.VERDICT)


def halt(session: Session) -> Session:
    """Return the session in which the showing halts, or goes on."""
    return replace(session, halted=not session.halted) if session.mode in SHOWING else session


def step(session: Session, by: int) -> Session:
    """Return the session in which the showing has halted `by` steps further."""
    if session.mode not in SHOWING or session.trace is None:
        return session
    clock = min(max(session.clock + by * STEP, -SWING), session.trace.duration)
    return replace(session, clock=clock, mode=_mode_at(clock), halted=True)


def change_pace(session: Session, by: int) -> Session:
    """Return the session in which the showing is so many degrees faster."""
    if session.mode not in SHOWING:
        return session
    nearest = min(range(len(PACES)), key=lambda k: abs(PACES[k] - session.pace))
    return replace(session, pace=PACES[min(max(nearest + by, 0), len(PACES) - 1)])


def _mode_at(clock: float) -> Mode:
    return Mode.ROLLING if clock >= 0.0 else Mode.STRIKING


def showing_words(session: Session) -> str:
    """Return what is shown and how."""
    what = "The last shot again" if session.back_to else "The balls are rolling"
    pace = "" if session.pace == 1.0 else f", {session.pace:g} times as fast"
    halted = f", halted at {max(session.clock, 0.0):.2f} s" if session.halted else ""
    return f"{what}{pace}{halted}"
