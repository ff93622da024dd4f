"""From one session to the next: what each command does, and what time does.

One idea: a shot is simulated, judged and entered in the match at the moment of the strike; what
is seen afterwards is only a showing of it. Invariant: no clock, no window and no file is read
here, so the outcome is the same at any frame rate.
"""

from __future__ import annotations

from dataclasses import replace
from math import hypot, radians
from typing import TYPE_CHECKING

from engine.app import calling, commands, placing
from engine.app.arranging import arranged_match, with_ball, without_ball
from engine.app.choices import choosable_balls
from engine.app.session import BEFORE_STROKE, SHOWING, SWING, Aid, Mode, Session
from engine.app.stroke import Stroke, heading_to, stroke_of
from engine.app.timing import (
    counting_of,
    run_down,
    timed_anew,
    timed_back,
    timed_on,
    timed_out,
    timing_of,
)
from engine.app.trouble import ScriptTrouble, told
from engine.game.match import advance, rejudge, start_match, undo
from engine.game.match import next_game as game_after
from engine.game.observe import observe, simulate_shot
from engine.game.placing import refuse_place
from engine.game.referee import judge_shot, look_ahead, take_choice
from engine.game.shot import NO_CALL, Shot
from engine.game.sight import View, first_met
from engine.table.furniture import BallId

if TYPE_CHECKING:
    from engine.app.timing import Timing
    from engine.game.match import Match
    from engine.game.situation import Situation
    from engine.variant.variant import Variant
    from rulelang.facts import Call


def begin(
    match: Match,
    stroke: Stroke = Stroke(),  # noqa: B008
    aid: Aid = Aid.GHOST,
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
    return _prepare(fresh)


def _prepare(session: Session) -> Session:
    """Return the session at the first thing to be done before a stroke."""
    ready = placing.placing_of(session.variant, session.ahead)
    place = placing.first_place(ready) if ready else None
    kept = session.call if session.choice and session.mode is Mode.CHOOSING else NO_CALL
    ahead = replace(session, placing=ready, place=place, call=kept, struck=None)
    ahead = replace(
        _look(ahead), stroke=_levelled(session.stroke), mode=Mode.PLACING if ready else Mode.CALLING
    )
    ahead = _face_balls(ahead)
    return ahead if ready else _after_placing(ahead)


def _levelled(stroke: Stroke) -> Stroke:
    return replace(stroke, side=0.0, follow=0.0, elevation=0.0)


def _face_balls(session: Session) -> Session:
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


def _look(session: Session) -> Session:
    """Return the session with what the rules say about the call as it stands."""
    call = None if session.call == NO_CALL else session.call
    return replace(session, admission=look_ahead(session.variant, session.ahead, call))


def _after_placing(session: Session) -> Session:
    wanted = session.wanted
    missing = wanted.obliged and not wanted.is_met(session.call)
    return replace(session, mode=Mode.CALLING if missing else Mode.AIMING, note="")


def act(session: Session, command: commands.Command) -> Session:
    """Return the session after a command; one that does not fit the moment changes nothing.

    Where the script fails, the session stays as it was and its `trouble` says what is wrong.
    """
    try:
        return _act(replace(session, trouble="") if session.trouble else session, command)
    except ScriptTrouble as trouble:
        return replace(session, trouble=told(trouble, session.variant))


def _act(session: Session, command: commands.Command) -> Session:
    match command:
        case commands.Undo():
            return _undo(session)
        case commands.Redo():
            return _redo(session)
        case commands.ChangeAid():
            aids = list(Aid)
            return replace(session, aid=aids[(aids.index(session.aid) + 1) % len(aids)])
        case commands.Replay(pace):
            return _replay(session, pace)
        case commands.Skip():
            return _finish(session) if session.mode in SHOWING else session
        case commands.NextGame():
            return next_game(session)
        case commands.Confirm():
            return _confirm(session)
        case commands.Arrange():
            return _arrange(session)
        case commands.Repeat():
            return _repeat(session)
        case _:
            return _set(session, command)


def _set(session: Session, command: commands.Command) -> Session:
    if session.mode is Mode.CHOOSING:
        return _choosing(session, command)
    if session.mode is Mode.ARRANGING:
        return _arranging(session, command)
    if session.mode not in BEFORE_STROKE:
        return session
    match command:
        case commands.Back():
            return _back(session)
        case commands.MoveBall() | commands.PutBall():
            return _move_ball(session, command)
        case commands.Turn() | commands.AimAt() | commands.SetSpeed():
            return replace(session, stroke=_aimed(session, command))
        case commands.SetTip() | commands.MoveTip() | commands.SetElevation():
            return replace(session, stroke=_aimed(session, command))
        case commands.StrikeNextBall(by):
            return _strike_next(session, by)
        case _:
            return _called(session, command)


def _choosing(session: Session, command: commands.Command) -> Session:
    situation = session.match.situation
    options = situation.options
    match command:
        case commands.Pick(by):
            picked = (session.picked + by) % len(options)
            return replace(session, picked=picked, call=NO_CALL)
        case commands.Choose(index) if 0 <= index < len(options):
            return _take(session, options[index])
        case commands.CallNextBall() | commands.CallBall():
            return _name_ball(session, command)
    return session


def _name_ball(session: Session, command: commands.CallNextBall | commands.CallBall) -> Session:
    """Return the session with the ball that the choice marked is to be about."""
    balls = session.choosable
    if isinstance(command, commands.CallNextBall):
        return replace(session, call=calling.next_ball(session.call, balls, command.by))
    known = command.ball in balls
    return replace(session, call=replace(NO_CALL, ball=command.ball)) if known else session


def _take(session: Session, option: str) -> Session:
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
        return _prepare(replace(session, choice=option, call=call, ahead=ahead, note=""))
    match = advance(session.match, shot, chosen)
    timing = timed_on(session.timing, match)
    begun = begin(match, session.stroke, session.aid, timing)
    return replace(begun, trace=session.trace, note=f"chosen: {option.replace('-', ' ')}")


def _strike_next(session: Session, by: int) -> Session:
    """Return the session with another ball to strike, where the rules leave the choice."""
    balls = session.strikable
    if session.mode is not Mode.AIMING or len(balls) < 2:
        return session
    struck = balls[(balls.index(session.cue_ball) + by) % len(balls)]
    return _face_balls(replace(session, struck=struck, note=""))


def _move_ball(session: Session, command: commands.MoveBall | commands.PutBall) -> Session:
    if session.mode is not Mode.PLACING or session.placing is None or session.place is None:
        return session
    if isinstance(command, commands.PutBall):
        wish = command.point
    else:
        wish = session.place[0] + command.dx, session.place[1] + command.dy
    return _face_balls(replace(session, place=session.placing.nearest(wish)))


def _aimed(session: Session, command: commands.Command) -> Stroke:
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


def _called(session: Session, command: commands.Command) -> Session:
    call = _new_call(session, command)
    if call is None or session.mode is Mode.PLACING:
        return session
    called = _look(replace(session, call=call, note=""))
    return _face_called(called) if call.ball != session.call.ball else called


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


def _back(session: Session) -> Session:
    if session.mode is Mode.AIMING and session.wanted.anything:
        return replace(session, mode=Mode.CALLING)
    if session.placing is not None:
        return replace(session, mode=Mode.PLACING)
    return session


def _confirm(session: Session) -> Session:
    match session.mode:
        case Mode.CHOOSING:
            return _take(session, session.match.situation.options[session.picked])
        case Mode.PLACING:
            return _after_placing(session)
        case Mode.CALLING:
            return _accept_call(session)
        case Mode.AIMING:
            return _strike(session)
        case Mode.STRIKING | Mode.ROLLING:
            return session
        case Mode.VERDICT:
            return begin_next(session)
        case Mode.OVER:
            return next_game(session)
        case Mode.ARRANGING:
            return _arrange(session)


def _accept_call(session: Session) -> Session:
    if session.wanted.is_met(session.call):
        return replace(session, mode=Mode.AIMING, note="")
    return replace(session, note=f"the rules ask for {session.wanted.in_words}")


def begin_next(session: Session) -> Session:
    """Return the session before the next shot."""
    after = begin(session.match, session.stroke, session.aid, session.timing)
    return replace(after, later=session.later, trace=session.trace)


def _strike(session: Session) -> Session:
    """Return the session with the shot played, judged, entered, and about to be seen."""
    variant, situation = session.variant, session.match.situation
    shot = replace(session.shot, facts=dict.fromkeys(session.timing.ran_out, True))
    refusal = _refusal(session)
    if refusal:
        return replace(session, note=refusal)
    trace = simulate_shot(variant, session.ahead, shot)
    seen = observe(variant, session.ahead, shot, trace)
    verdict = judge_shot(variant, situation, seen)
    match = advance(session.match, seen, verdict)
    return replace(
        session,
        match=match,
        timing=timed_on(session.timing, match),
        mode=Mode.STRIKING,
        trace=trace,
        clock=-SWING,
        pace=1.0,
        back_to=None,
        note="",
        later=(),
    )


def _refusal(session: Session) -> str:
    """Return why the stroke cannot be played as it is; empty where it can."""
    if session.cue_place is None:
        return "there is no cue ball on the table"
    if not session.wanted.is_met(session.call):
        return f"first call {session.wanted.in_words}"
    if session.place is None:
        return ""
    refused = refuse_place(session.variant, session.ahead, session.place)
    return f"{refused.reason}: {refused.mend}" if refused else ""


def pass_time(session: Session, seconds: float, *, at_table: bool = True) -> Session:
    """Return the session `seconds` of the player's time later.

    The showing moves and the timers run, those of a shot or a turn only while the shooter is
    `at_table`.
    """
    shown = _show(session, seconds)
    playing = shown.mode not in (Mode.OVER, Mode.ARRANGING) and not shown.match.situation.over
    if not shown.timing.clock.timers or not playing:
        return shown
    ready = at_table and shown.mode in BEFORE_STROKE
    units = ("shot", "turn", "game", "match") if ready else ("game", "match")
    timed = replace(shown, timing=run_down(shown.timing, seconds, units))
    return _watch_time(timed) if ready else timed


def _watch_time(session: Session) -> Session:
    """Return the session in which the referee speaks where a timer that counts ran out."""
    timing = session.timing
    try:
        if timing.counting is None:
            timing = replace(timing, counting=counting_of(session))
        if timing.counting and timing.counting.intersection(timing.ran_out):
            return _time_out(session)
    except ScriptTrouble as trouble:
        timing = replace(timing, counting=frozenset())
        return replace(session, timing=timing, trouble=told(trouble, session.variant))
    return replace(session, timing=timing)


def _time_out(session: Session) -> Session:
    """Return the session after a stroke that was not played in time."""
    shot = timed_out(session, session.timing.ran_out)
    verdict = judge_shot(session.variant, session.match.situation, shot)
    match = advance(session.match, shot, verdict)
    timing = timed_on(session.timing, match)
    ended = begin(match, session.stroke, session.aid, timing)
    return replace(ended, mode=Mode.VERDICT, note="time is up", later=())


def _show(session: Session, seconds: float) -> Session:
    """Return the session in which the showing has moved on."""
    if session.mode not in SHOWING or session.trace is None:
        return session
    clock = session.clock + seconds * session.pace
    if clock >= session.trace.duration:
        return _finish(session)
    return replace(session, clock=clock, mode=Mode.ROLLING if clock >= 0.0 else Mode.STRIKING)


def _finish(session: Session) -> Session:
    end = session.trace.duration if session.trace else 0.0
    if session.back_to is not None:
        return replace(session, clock=end, mode=session.back_to, back_to=None)
    return replace(session, clock=end, mode=Mode.VERDICT)


def _replay(session: Session, pace: float) -> Session:
    last = session.last_stroke
    if last is None or session.mode in SHOWING:
        return session
    trace = session.trace
    if trace is None:
        before = take_choice(session.variant, last.before, last.shot).after
        trace = simulate_shot(session.variant, before, last.shot)
    return replace(
        session,
        trace=trace,
        mode=Mode.STRIKING,
        clock=-SWING,
        pace=pace,
        back_to=session.mode,
        note="",
    )


def _arrange(session: Session) -> Session:
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


def _arranging(session: Session, command: commands.Command) -> Session:
    """Return the session with the ball held another one, somewhere else, off or back."""
    ahead, held, variant = session.ahead, session.held, session.variant
    balls = [kind.id for kind in variant.balls]
    lying = ahead.rest.positions
    match command:
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


def _repeat(session: Session) -> Session:
    """Return the session before the last stroke, which is set as it was played."""
    last = session.last_stroke
    if last is None or last.shot.strike is None or session.mode in SHOWING:
        return replace(session, note="there is no stroke to play again")
    match = session.match
    later = match
    while match.played and match.played[-1] is not last:
        match = undo(match)
    back = _back_at(session, undo(match))
    if back.mode is Mode.CHOOSING and last.shot.choice is not None:
        back = _take(back, last.shot.choice)
    if back.mode not in BEFORE_STROKE:
        return replace(back, later=(later,))
    back = _look(replace(back, call=last.shot.call, struck=last.shot.struck))
    place = last.shot.placement if back.placing else None
    strike = stroke_of(last.shot.strike)
    note = "the last stroke once more: strike, or change it"
    return replace(back, mode=Mode.AIMING, place=place, stroke=strike, later=(later,), note=note)


def _undo(session: Session) -> Session:
    if not session.match.played:
        return replace(session, note="there is no shot to take back")
    back = _back_at(session, undo(session.match))
    return replace(back, later=(session.match, *session.later), note="the last shot is taken back")


def _redo(session: Session) -> Session:
    if not session.later or session.mode in SHOWING:
        return replace(session, note="there is no shot to play again")
    match, *rest = session.later
    return replace(_back_at(session, match), later=tuple(rest))


def _back_at(session: Session, match: Match) -> Session:
    """Return the session at a moment of its match where it was before."""
    return begin(match, session.stroke, session.aid, timed_back(session.timing, match))


def take_up(session: Session, variant: Variant) -> Session:
    """Return the session with its shots judged by another text of its game.

    Where that cannot be, the game goes on as it was and the trouble is told.
    """
    try:
        match = rejudge(session.match, variant)
        again = begin(match, session.stroke, session.aid, timed_anew(session.timing, match))
    except ScriptTrouble as trouble:
        return replace(session, trouble=told(trouble, variant))
    except ValueError as trouble:
        return replace(session, trouble=f"{variant.path.name} does not fit this match: {trouble}")
    return replace(again, note="the game's files have changed and are taken up")


def next_game(session: Session) -> Session:
    """Return the session of the next game of the match, or of a new match where it is over."""
    if session.mode is not Mode.OVER:
        return session
    old = session.match
    if not old.situation.match_over:
        again = game_after(old)
        timing = timed_anew(session.timing, again)
        return begin(again, session.stroke, session.aid, timing)
    again = start_match(session.variant, old.situation.players, old.settings, seed=old.seed + 1)
    return begin(again, session.stroke, session.aid)
