"""What a stroke would do, for the aiming aid: the physics itself, looked at beforehand.

One idea: no second, simpler physics; the aid shows parts of a real trace, which is made and read in
slices of time, so that no frame waits for it. Invariant: how it is sliced changes nothing in what
is told.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import inf
from time import perf_counter
from typing import TYPE_CHECKING

import numpy as np

from engine.app.session import Aid
from engine.game.observe import layout_of
from engine.game.shot import as_written
from engine.physics.events import BallsCollided, CushionHit, JawHit, PinToppled, PinTouched
from engine.physics.prepare import flies_at_once
from engine.physics.simulate import Simulation

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray

    from engine.app.session import Session
    from engine.physics.trace import Trace
    from engine.table.furniture import BallId, Point

    Floats = NDArray[np.float64]

STEP = 0.02
"""Seconds between the points of a way; the moments of contacts come between them."""
NEAR = 0.004
"""Metres below which two points of a way are one."""
SLICE = 0.02
"""Seconds of the stroke that are played at a time, at first; more where that goes fast."""
QUICK = 0.0005
"""Seconds of work that are hardly anything."""


@dataclass(frozen=True, slots=True)
class Prediction:
    """Ways on the cloth (m): the cue ball's to its first contact, and on from there.

    `contact` is where the cue ball then is, None where it meets no ball; `object_way` is the
    way of the ball that it meets; `ways` are all balls' whole ways. What an aid does not show is
    empty.
    """

    to_contact: tuple[Point, ...]
    contact: Point | None
    radius: float
    object_way: tuple[Point, ...] = ()
    ways: tuple[tuple[Point, ...], ...] = ()


@dataclass(slots=True)
class Foretelling:
    """The prediction of one stroke while it is made; `answer` is None until it is `done`."""

    session: Session
    answer: Prediction | None = None
    done: bool = False
    _work: Iterator[None] = field(init=False)

    def __post_init__(self) -> None:
        self._work = self._worked()

    def go_on(self, seconds: float = inf) -> None:
        """Work for about so long, or until it is done."""
        end = perf_counter() + seconds
        for _ in self._work:
            if perf_counter() >= end:
                return
        self.done = True

    def _worked(self) -> Iterator[None]:
        session = self.session
        if session.cue_place is None or session.aid is Aid.OFF:
            return
        if session.stroke.elevation > 0.0 and not flies_at_once():
            return
        simulation = _begun(session)
        ball, soon = session.cue_ball, session.aid in (Aid.LINE, Aid.GHOST)
        now, step = 0.0, SLICE
        while not simulation.finished:
            began = perf_counter()
            now += step
            simulation.advance(now)
            if perf_counter() - began < QUICK:
                step *= 1.5
            if soon and first_met(simulation.trace(), ball) is not None:
                break
            yield
        trace = simulation.trace()
        simulation.give_back()
        yield
        self.answer = read_prediction(trace, ball, session.aid)


def _begun(session: Session) -> Simulation:
    """Return the stroke of a session, struck and not yet gone on with."""
    shot, ahead = session.shot, session.ahead
    if shot.strike is None:
        raise ValueError("there is nothing to foretell of a shot without a stroke")
    layout = layout_of(session.variant, ahead, shot)
    strike = as_written(shot.strike)
    return Simulation(
        session.variant.world, layout, session.cue_ball, strike, fallen=ahead.rest.fallen
    )


def predict(session: Session) -> Prediction | None:
    """Return what the stroke of a session would do, None where nothing can be struck.

    None too while what a raised cue needs is still being compiled: the window would stand still.
    """
    whole = Foretelling(session)
    whole.go_on()
    return whole.answer


def read_prediction(trace: Trace, ball: BallId, aid: Aid = Aid.ALL) -> Prediction:
    """Return what an aid shows of a trace in which `ball` was struck."""
    meeting = first_met(trace, ball)
    end, met = meeting or (_first_rail(trace, ball), None)
    ways = Ways(trace, end)
    to_contact = ways.of(ball, 0.0, end)
    radius = next(one.radius for one in trace.balls if one.id == ball)
    contact = to_contact[-1] if met is not None else None
    if aid in (Aid.LINE, Aid.GHOST):
        return Prediction(to_contact, contact, radius)
    object_way = ways.of(met, end, trace.duration) if met is not None else ()
    if aid is Aid.OBJECT:
        return Prediction(to_contact, contact, radius, object_way)
    moved = {one.ball for one in trace.events() if not isinstance(one, PinToppled | PinTouched)}
    others = (one.id for one in trace.balls if one.id in moved and one.id != met)
    rest = (ways.of(one, end if one == ball else 0.0, trace.duration) for one in others)
    return Prediction(to_contact, contact, radius, object_way, tuple(rest))


def first_met(trace: Trace, ball: BallId) -> tuple[float, BallId] | None:
    """Return when (s) a ball first meets another, and which; None where it meets none."""
    for event in trace.events():
        if isinstance(event, BallsCollided) and ball in (event.ball, event.other):
            return event.time, event.other if event.ball == ball else event.ball
    return None


def _first_rail(trace: Trace, ball: BallId) -> float:
    for event in trace.events():
        if isinstance(event, CushionHit | JawHit) and event.ball == ball:
            return event.time
    return trace.duration


@dataclass(slots=True)
class Ways:
    """The ways of a trace's balls, read at steps of time and at every contact."""

    trace: Trace
    also: float
    _times: Floats = field(init=False)
    _places: Floats = field(init=False)

    def __post_init__(self) -> None:
        trace = self.trace
        steps = np.arange(0.0, trace.duration, STEP)
        contacts = [event.time for event in trace.events()]
        self._times = np.unique(np.concatenate([steps, contacts, [self.also, trace.duration]]))
        self._places = trace.positions(self._times)

    def of(self, ball: BallId, start: float, end: float) -> tuple[Point, ...]:
        """Return the points of a ball's way, thinned where it hardly moves."""
        index = next(i for i, one in enumerate(self.trace.balls) if one.id == ball)
        first, last = np.searchsorted(self._times, [start, end])
        rows = self._places[first : last + 1, index, :]
        below = np.flatnonzero(rows[:, 2] < 0.0)
        rows = rows[: below[0]] if len(below) else rows
        if not len(rows):
            return ()
        gone = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(rows[:, :2], axis=0).T))])
        kept = np.flatnonzero(np.diff(np.floor(gone / NEAR))) + 1
        kept = np.unique(np.concatenate([[0], kept, [len(rows) - 1] if gone[-1] > NEAR else []]))
        return tuple((x, y) for x, y in rows[kept.astype(int), :2].tolist())


__all__ = ["Foretelling", "Prediction", "Ways", "first_met", "predict", "read_prediction"]
