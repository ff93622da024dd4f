"""What a player sets for a stroke: the ball in hand, the aim, the ball struck, the call.

One idea: each command answers a new session, and one that does not fit the moment the same.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from engine.app import calling, commands
from engine.app.before import face_balls, look
from engine.app.session import Mode, Session
from engine.app.stroke import Stroke, heading_to
from engine.app.words import ball_name
from engine.game.referee import look_ahead
from engine.game.shot import NO_CALL
from engine.table.furniture import BallId

if TYPE_CHECKING:
    from rulelang.facts import Call


def strike_next(session: Session, by: int) -> Session:
    """Return the session with another ball to strike, where the rules leave the choice."""
    balls = session.strikable
    if session.mode is not Mode.AIMING:
        return session
    if len(balls) < 2:
        name = ball_name(session.variant, session.cue_ball)
        return replace(session, note=f"the rules let you strike no other ball than the {name}")
    struck = balls[(balls.index(session.cue_ball) + by) % len(balls)]
    return face_balls(replace(session, struck=struck, note=""))


def move_ball(session: Session, command: commands.MoveBall | commands.PutBall) -> Session:
    """Return the session with the ball in hand moved, as near as its zone allows."""
    if session.mode is not Mode.PLACING or session.placing is None or session.place is None:
        return session
    if isinstance(command, commands.PutBall):
        wish = command.point
    else:
        wish = session.place[0] + command.dx, session.place[1] + command.dy
    return face_balls(replace(session, place=session.placing.nearest(wish)))


def aimed(session: Session, command: commands.Command) -> Stroke:
    """Return the stroke after a command about aim, speed, tip or butt."""
    stroke = session.stroke
    match command:
        case commands.Turn(by):
            return stroke.turned(by)
        case commands.AimAt(point) if session.cue_place is not None:
            return stroke.headed(heading_to(session.cue_place, point))
        case commands.SetSpeed(speed):
            return stroke.at(speed)
        case commands.SetTip(side, follow):
            return stroke.tipped(side, follow, session.tip_limit)
        case commands.MoveTip(side, follow):
            limit = session.tip_limit
            return stroke.tipped(stroke.side + side, stroke.follow + follow, limit)
        case commands.SetElevation(elevation):
            return stroke.raised(elevation)
    return stroke


def called(session: Session, command: commands.Command) -> Session:
    """Return the session with a new call, the aim on the ball called."""
    call = _new_call(session, command)
    if call is None or session.mode is Mode.PLACING:
        return session
    said = look(replace(session, call=call, note=""))
    return _face_called(said) if call.ball != session.call.ball else said


def _face_called(session: Session) -> Session:
    """Return the session with the aim on the ball that is called."""
    start, ball, lying = session.cue_place, session.call.ball, session.ahead.rest.positions
    if start is None or ball is None or ball not in lying:
        return session
    heading = heading_to(start, lying[BallId(ball)])
    return replace(session, stroke=session.stroke.headed(heading))


def _new_call(session: Session, command: commands.Command) -> Call | None:
    wanted, call, variant = session.wanted, session.call, session.variant
    uncalled = look_ahead(variant, session.ahead)
    balls = calling.callable_balls(variant, session.ahead, uncalled)
    match command:
        case commands.CallNextBall(by) if wanted.ball:
            return calling.next_ball(call, balls, by)
        case commands.CallBall(ball) if wanted.ball and ball in balls:
            return replace(call, ball=ball, safety=False)
        case commands.CallNextPocket(by) if wanted.pocket:
            return calling.next_pocket(call, variant, by)
        case commands.CallPocket(pocket) if wanted.pocket:
            return replace(call, pocket=pocket, safety=False)
        case commands.CallSafety() if wanted.safety:
            return replace(NO_CALL, safety=not call.safety, group=call.group)
        case commands.CallNextGroup() if wanted.group:
            return calling.next_group(call, calling.callable_groups(variant))
    return None
