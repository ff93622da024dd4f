"""Practice at the table: balls put anywhere, a layout laid out, a stroke played again.

One idea: what is tried begins a match of its own, so the one before it stays as it was.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from engine.app import commands
from engine.app.arranging import arranged_match, with_ball, without_ball
from engine.app.before import back_at, begin, look, take
from engine.app.session import BEFORE_STROKE, SHOWING, Mode, Session
from engine.app.stroke import stroke_of
from engine.game.match import undo
from engine.game.shot import NO_CALL

if TYPE_CHECKING:
    from engine.game.situation import Situation

KEPT = "all as it was before"


def arrange(session: Session) -> Session:
    """Return the session in which balls can be moved, or the match that begins so."""
    if session.mode is Mode.ARRANGING:
        match = arranged_match(session.match, session.ahead)
        return replace(begin(match, session.stroke, session.aid), note="from here on")
    if session.mode in SHOWING:
        return session
    ahead = session.match.situation
    if session.place is not None:
        ahead = with_ball(session.variant, ahead, session.cue_ball, session.place)
    held = next((ball.id for ball in session.variant.balls if ball.id in ahead.on_table), None)
    shown = replace(ahead, in_hand=None, offers=(), winner=None)
    return replace(
        session,
        mode=Mode.ARRANGING,
        ahead=shown,
        held=held,
        place=None,
        placing=None,
        call=NO_CALL,
        note="",
    )


def arranging(session: Session, command: commands.Command) -> Session:
    """Return the session with the ball held another one, elsewhere, off or back, or the match."""
    ahead, held, variant = session.ahead, session.held, session.variant
    balls = [kind.id for kind in variant.balls]
    lying = ahead.rest.positions
    match command:
        case commands.Back():
            return replace(
                begin(session.match, session.stroke, session.aid, session.timing), note=KEPT
            )
        case commands.CallNextBall(by):
            place = balls.index(held) if held in balls else -by
            return replace(session, held=balls[(place + by) % len(balls)])
        case commands.CallBall(ball):
            return replace(session, held=ball)
        case commands.PutBall(point) if held is not None:
            return replace(session, ahead=with_ball(variant, ahead, held, point))
        case commands.MoveBall(dx, dy) if held is not None and held in lying:
            x, y = lying[held]
            return replace(session, ahead=with_ball(variant, ahead, held, (x + dx, y + dy)))
        case commands.TakeOff() if held is not None and held in lying:
            return replace(session, ahead=without_ball(ahead, held))
        case commands.TakeOff() if held is not None:
            return replace(session, ahead=with_ball(variant, ahead, held, (0.0, 0.0)))
    return session


def lay(session: Session, situation: Situation) -> Session:
    """Return the session of the match that begins with a layout that was kept."""
    match = arranged_match(session.match, replace(situation, in_hand=None))
    return begin(match, session.stroke, session.aid)


def repeat(session: Session) -> Session:
    """Return the session before the last stroke, which is set as it was played."""
    last = session.last_stroke
    if last is None or last.shot.strike is None or session.mode in SHOWING:
        return replace(session, note="there is no stroke to play again")
    match = session.match
    later = match
    while match.played and match.played[-1] is not last:
        match = undo(match)
    back = back_at(session, undo(match))
    if back.mode is Mode.CHOOSING and last.shot.choice is not None:
        back = take(back, last.shot.choice)
    if back.mode not in BEFORE_STROKE:
        return replace(back, later=(later,))
    back = look(replace(back, call=last.shot.call, struck=last.shot.struck))
    place = last.shot.placement if back.placing else None
    strike = stroke_of(last.shot.strike)
    note = "the last stroke once more: strike, or change it"
    return replace(back, mode=Mode.AIMING, place=place, stroke=strike, later=(later,), note=note)
