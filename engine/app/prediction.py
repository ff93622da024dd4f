"""What a stroke would do, for the aiming aid: the physics itself, looked at beforehand.

One idea: no second, simpler physics; the aid shows parts of a real trace.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot
from typing import TYPE_CHECKING

import numpy as np

from engine.app.session import Aid
from engine.game.observe import simulate_shot
from engine.physics.events import BallsCollided, CushionHit, JawHit, PinToppled, PinTouched
from engine.physics.prepare import flies_at_once

if TYPE_CHECKING:
    from engine.app.session import Session
    from engine.physics.trace import Trace
    from engine.table.furniture import BallId, Point

STEP = 0.02
"""Seconds between the points of a way."""
SHORT = 0.35
"""How much (m) of an object ball's way is shown with the ghost ball."""


SOON = 1.5
"""Seconds of an object ball's way that are looked at for it."""


@dataclass(frozen=True, slots=True)
class Prediction:
    """Ways on the cloth (m): the cue ball's to its first contact, and on from there.

    `contact` is where the cue ball then is, None where it meets no ball; `object_way` is the
    beginning of the ball's way that it meets; `ways` are all balls' whole ways, where asked for.
    """

    to_contact: tuple[Point, ...]
    contact: Point | None
    radius: float
    object_way: tuple[Point, ...]
    ways: tuple[tuple[Point, ...], ...]


def predict(session: Session) -> Prediction | None:
    """Return what the stroke of a session would do, None where nothing can be struck.

    None too while what a raised cue needs is still being compiled: the window would stand still.
    """
    if session.cue_place is None:
        return None
    if session.stroke.elevation > 0.0 and not flies_at_once():
        return None
    trace = simulate_shot(session.variant, session.ahead, session.shot)
    return read_prediction(trace, session.cue_ball, whole=session.aid is Aid.ALL)


def read_prediction(trace: Trace, ball: BallId, *, whole: bool = True) -> Prediction:
    """Return the prediction that a trace holds for the ball struck, `whole` with all ways."""
    meeting = _first_meeting(trace, ball)
    end = meeting[0] if meeting else _first_rail(trace, ball)
    to_contact = _way(trace, ball, 0.0, end)
    radius = next(one.radius for one in trace.balls if one.id == ball)
    soon = min(end + SOON, trace.duration)
    seen = trace.events() if whole else ()
    moved = {one.ball for one in seen if not isinstance(one, PinToppled | PinTouched)}
    return Prediction(
        to_contact=to_contact,
        contact=to_contact[-1] if meeting else None,
        radius=radius,
        object_way=_cut(_way(trace, meeting[1], end, soon)) if meeting else (),
        ways=tuple(
            _way(trace, one.id, end if one.id == ball else 0.0, trace.duration)
            for one in trace.balls
            if one.id in moved
        ),
    )


def _first_meeting(trace: Trace, ball: BallId) -> tuple[float, BallId] | None:
    for event in trace.events():
        if isinstance(event, BallsCollided) and ball in (event.ball, event.other):
            return event.time, event.other if event.ball == ball else event.ball
    return None


def _first_rail(trace: Trace, ball: BallId) -> float:
    for event in trace.events():
        if isinstance(event, CushionHit | JawHit) and event.ball == ball:
            return event.time
    return trace.duration


def _way(trace: Trace, ball: BallId, start: float, end: float) -> tuple[Point, ...]:
    """Return the points of a ball's way, thinned where it stands still."""
    index = next(i for i, one in enumerate(trace.balls) if one.id == ball)
    times = np.linspace(start, end, max(2, int((end - start) / STEP) + 2))
    rows = trace.positions(times)[:, index, :]
    points: list[Point] = []
    for x, y, z in rows.tolist():
        if z < 0.0:
            break
        if not points or hypot(x - points[-1][0], y - points[-1][1]) > 0.004:
            points.append((x, y))
    return tuple(points)


def _cut(way: tuple[Point, ...]) -> tuple[Point, ...]:
    """Return the first `SHORT` metres of a way."""
    kept: list[Point] = []
    gone = 0.0
    for point in way:
        if kept:
            gone += hypot(point[0] - kept[-1][0], point[1] - kept[-1][1])
        kept.append(point)
        if gone > SHORT:
            break
    return tuple(kept)
