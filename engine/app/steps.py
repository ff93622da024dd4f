"""From one session to the next: what each command does, and what time does.

One idea: a shot is simulated, judged and entered in the match at the moment of the strike; what
is seen afterwards is only a showing of it. Invariant: no clock, no window and no file is read
here, so the outcome is the same at any frame rate.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from engine.app import calling, commands, replaying
from engine.app.before import after_placing, back_at, begin, take
from engine.app.practising import arrange, arranging, repeat
from engine.app.session import BEFORE_STROKE, SHOWING, SWING, Aid, Mode, Session
from engine.app.setting import aimed, called, move_ball, strike_next
from engine.app.timing import (
    counting_of,
    run_down,
    timed_anew,
    timed_on,
    timed_out,
)
from engine.app.trouble import ScriptTrouble, told
from engine.game.match import advance, rejudge, start_match, undo
from engine.game.match import next_game as game_after
from engine.game.observe import observe, simulate_shot
from engine.game.placing import refuse_place
from engine.game.referee import judge_shot
from engine.game.shot import NO_CALL

if TYPE_CHECKING:
    from engine.variant.variant import Variant


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
            return replaying.replay(session, pace)
        case commands.StepShown(by):
            return replaying.step(session, by)
        case commands.ChangePace(by):
            return replaying.change_pace(session, by)
        case commands.Skip():
            return replaying.finish(session) if session.mode in SHOWING else session
        case commands.NextGame():
            return next_game(session)
        case commands.Confirm():
            return _confirm(session)
        case commands.Arrange():
            return arrange(session)
        case commands.Repeat():
            return repeat(session)
        case _:
            return _set(session, command)


def _set(session: Session, command: commands.Command) -> Session:
    if session.mode is Mode.CHOOSING:
        return _choosing(session, command)
    if session.mode is Mode.ARRANGING:
        return arranging(session, command)
    if session.mode not in BEFORE_STROKE:
        return session
    match command:
        case commands.Back():
            return _back(session)
        case commands.MoveBall() | commands.PutBall():
            return move_ball(session, command)
        case commands.Turn() | commands.AimAt() | commands.SetSpeed():
            return replace(session, stroke=aimed(session, command))
        case commands.SetTip() | commands.MoveTip() | commands.SetElevation():
            return replace(session, stroke=aimed(session, command))
        case commands.StrikeNextBall(by):
            return strike_next(session, by)
        case _:
            return called(session, command)


def _choosing(session: Session, command: commands.Command) -> Session:
    situation = session.match.situation
    options = situation.options
    match command:
        case commands.Pick(by):
            picked = (session.picked + by) % len(options)
            return replace(session, picked=picked, call=NO_CALL)
        case commands.Choose(index) if 0 <= index < len(options):
            return take(session, options[index])
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


def _back(session: Session) -> Session:
    if session.mode is Mode.AIMING and session.wanted.anything:
        return replace(session, mode=Mode.CALLING)
    if session.placing is not None:
        return replace(session, mode=Mode.PLACING)
    return session


def _confirm(session: Session) -> Session:
    match session.mode:
        case Mode.CHOOSING:
            return take(session, session.match.situation.options[session.picked])
        case Mode.PLACING:
            return after_placing(session)
        case Mode.CALLING:
            return _accept_call(session)
        case Mode.AIMING:
            return _strike(session)
        case Mode.STRIKING | Mode.ROLLING:
            return replaying.halt(session)
        case Mode.VERDICT:
            return begin_next(session)
        case Mode.OVER:
            return next_game(session)
        case Mode.ARRANGING:
            return arrange(session)


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
        halted=False,
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
    shown = replaying.show(session, seconds)
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


def _undo(session: Session) -> Session:
    if not session.match.played:
        return replace(session, note="there is no shot to take back")
    back = back_at(session, undo(session.match))
    return replace(back, later=(session.match, *session.later), note="the last shot is taken back")


def _redo(session: Session) -> Session:
    if not session.later or session.mode in SHOWING:
        return replace(session, note="there is no shot to play again")
    match, *rest = session.later
    return replace(back_at(session, match), later=tuple(rest))


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
    return begin(replace(again, names=old.names), session.stroke, session.aid)
