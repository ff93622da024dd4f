"""The session before a stroke: choose, place, call, aim, in the order in which a player does it.

One idea: what comes first is what the rules still ask for; the aim starts on a ball that is on.
"""

from __future__ import annotations

from dataclasses import replace
from math import hypot, radians
from typing import TYPE_CHECKING

from engine.app import placing
from engine.app.choices import choosable_balls
from engine.app.session import Aid, Mode, Session
from engine.app.stroke import Stroke, heading_to
from engine.app.timing import (
    timed_back,
    timed_on,
    timing_of,
)
from engine.game.match import advance
from engine.game.referee import look_ahead, take_choice
from engine.game.shot import NO_CALL, Shot
from engine.game.sight import View, first_met

if TYPE_CHECKING:
    from engine.app.timing import Timing
    from engine.game.match import Match


def begin(
    match: Match,
    stroke: Stroke = Stroke(),  # noqa: B008
    aid: Aid = Aid.OBJECT,
    timing: Timing | None = None,
) -> Session:
    """Return the session of a match at the shot it has come to; all its time is left by default."""
    ahead = match.situation
    admission, timing = look_ahead(match.variant, ahead), timing or timing_of(match)
    fresh = Session(match, Mode.AIMING, ahead, admission, stroke, timing, aid=aid)
    if ahead.over:
        return replace(fresh, mode=Mode.OVER)
    if ahead.offers:
        return replace(fresh, mode=Mode.CHOOSING)
    return prepare(fresh)


def prepare(session: Session) -> Session:
    """Return the session at the first thing to be done before a stroke."""
    ready = placing.placing_of(session.variant, session.ahead)
    place = placing.first_place(ready) if ready else None
    kept = session.call if session.choice and session.mode is Mode.CHOOSING else NO_CALL
    ahead = replace(session, placing=ready, place=place, call=kept, struck=None)
    ahead = replace(
        look(ahead), stroke=_levelled(session.stroke), mode=Mode.PLACING if ready else Mode.CALLING
    )
    ahead = face_balls(ahead)
    return ahead if ready else after_placing(ahead)


def _levelled(stroke: Stroke) -> Stroke:
    return replace(stroke, side=0.0, follow=0.0, elevation=0.0)


def face_balls(session: Session) -> Session:
    """Return the session with the aim on a ball that is on, the nearest that can be hit full."""
    start, cue = session.cue_place, session.cue_ball
    lying = {ball: at for ball, at in session.ahead.rest.positions.items() if ball != cue}
    if start is None or not lying:
        return session
    radii = {ball.id: ball.radius for ball in session.variant.world.balls}
    view = View(start, radii[cue], lying, radii)
    targets = [ball for ball in lying if ball in session.admission.on] or list(lying)
    targets.sort(key=lambda ball: hypot(lying[ball][0] - start[0], lying[ball][1] - start[1]))
    headings = [heading_to(start, lying[ball]) for ball in targets]
    clear = (way for way in headings if first_met(view, radians(way)) in targets)
    return replace(session, stroke=session.stroke.headed(next(clear, headings[0])))


def look(session: Session) -> Session:
    """Return the session with what the rules say about the call as it stands."""
    call = None if session.call == NO_CALL else session.call
    return replace(session, admission=look_ahead(session.variant, session.ahead, call))


def after_placing(session: Session) -> Session:
    """Return the session at the call that is still owed, else at the aim."""
    wanted = session.wanted
    missing = wanted.obliged and not wanted.is_met(session.call)
    return replace(session, mode=Mode.CALLING if missing else Mode.AIMING, note="")


def take(session: Session, option: str) -> Session:
    """Return the session after a choice: kept for the stroke, or played where it ends the turn."""
    situation = session.match.situation
    named = session.call.ball in choosable_balls(session.variant, situation, option)
    call = session.call if named else NO_CALL
    shot = Shot(choice=option, call=call)
    chosen = take_choice(session.variant, situation, shot)
    after = chosen.after
    settled = (
        after.over
        or after.shooter != situation.shooter
        or not set(after.options) <= set(situation.options)
    )
    if not settled:
        ahead = replace(after, offers=())
        return prepare(replace(session, choice=option, call=call, ahead=ahead, note=""))
    match = advance(session.match, shot, chosen)
    timing = timed_on(session.timing, match)
    begun = begin(match, session.stroke, session.aid, timing)
    return replace(begun, trace=session.trace, note=f"chosen: {option.replace('-', ' ')}")


def back_at(session: Session, match: Match) -> Session:
    """Return the session at a moment of its match where it was before."""
    return begin(match, session.stroke, session.aid, timed_back(session.timing, match))
