"""The score board and what is asked of the player, as values.

One idea: all that the display says at one moment is one value; where it stands is decided
elsewhere.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace
from math import ceil
from typing import TYPE_CHECKING

from engine.app.replaying import showing_words
from engine.app.session import Mode
from engine.app.units import Units
from engine.app.words import (
    ball_name,
    counts_points,
    named_balls,
    next_words,
    player_name,
    result_words,
    spoken,
    tracked_words,
    turn_words,
    zone_name,
)
from engine.game.situation import cue_ball_of

if TYPE_CHECKING:
    from collections.abc import Container, Sequence

    from engine.app.session import Session
    from engine.game.situation import Situation
    from engine.table.furniture import BallId
    from engine.variant.variant import Variant
    from rulelang.facts import Call

SHORT = 5.0
"""Seconds below which the time left is shown as short."""
MINUTE = 60


@dataclass(frozen=True, slots=True)
class PlayerLine:
    """One player as the score board shows him."""

    name: str
    score: str
    is_shooting: bool
    notes: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class TimeLine:
    """One timer as the display shows it; `is_short` where hardly any time is left."""

    name: str
    left: str
    is_short: bool


@dataclass(frozen=True, slots=True)
class Board:
    """All that the display says at one moment; `on` are the balls to be marked.

    `own_time` is the shooter's, for a shot or a turn, `time` that of the game or the match; `turn`
    is what is counted for the turn.
    """

    title: str
    phase: str
    players: tuple[PlayerLine, ...]
    on: tuple[BallId, ...]
    on_words: str
    ask: str
    note: str
    call: str
    own_time: tuple[TimeLine, ...] = ()
    time: tuple[TimeLine, ...] = ()
    turn: tuple[str, ...] = ()


def board_of(session: Session, units: Units = Units.METRIC) -> Board:
    """Return all that the display says about a session."""
    now = session.shown
    variant = session.variant
    before = session.mode in (Mode.CHOOSING, Mode.PLACING, Mode.CALLING, Mode.AIMING)
    cue = cue_ball_of(variant, now.shooter)
    on = session.admission.on if before else frozenset()
    marked = tuple(
        k.id for k in variant.balls if k.id in on and k.id in now.on_table and k.id != cue
    )
    return Board(
        title=variant.title,
        phase=", ".join([*phase_words(now), *settings_words(now)]),
        players=_player_lines(session, now),
        on=marked,
        on_words=named_balls(variant, marked, now.on_table - {cue}),
        ask=asked(session, units),
        note=session.note,
        call=call_words(session.call) if before else "",
        own_time=time_lines(session, ("shot", "turn")) if before else (),
        time=() if now.over else time_lines(session, ("game", "match")),
        turn=() if now.over else tuple(turn_words(variant, now)),
    )


def time_lines(session: Session, units: Container[str]) -> tuple[TimeLine, ...]:
    """Return the timers per one of `units` that still run and mean something to the referee."""
    clock, counting = session.timing.clock, session.timing.counting or ()
    return tuple(
        TimeLine(spoken(name), time_words(left), left < SHORT)
        for name, left in clock.left.items()
        if clock.timers[name].per in units
        and (name in counting or clock.timers[name].per in ("game", "match"))
        and left > 0
    )


def time_words(seconds: float) -> str:
    """Return seconds, rounded up, as a clock shows them; minutes where there are any."""
    whole = ceil(seconds)
    return f"{whole // 60}:{whole % 60:02}" if whole >= MINUTE else str(whole)


def _player_lines(session: Session, now: Situation) -> tuple[PlayerLine, ...]:
    """Return the players; with the games that each has won, once one is over in this match."""
    lines = [
        player_line(session.variant, now, player, session.names)
        for player in range(1, now.players + 1)
    ]
    ended = [one.verdict.after for one in session.match.played if one.verdict.after.over]
    if not (ended and now.games):
        return tuple(lines)
    won = Counter(one.winner for one in ended)
    return tuple(
        replace(line, notes=(f"games: {won[player]}", *line.notes))
        for player, line in enumerate(lines, start=1)
    )


def player_line(
    variant: Variant, situation: Situation, player: int, names: Sequence[str] = ()
) -> PlayerLine:
    """Return a player's name, score and what the game tracks of him."""
    notes = []
    if len(variant.cue_balls) > 1:
        notes.append(f"plays {spoken(cue_ball_of(variant, player))}")
    notes += tracked_words(situation, player)
    return PlayerLine(
        player_name(player, names),
        str(situation.scores[player - 1]) if counts_points(variant) else "",
        player == situation.shooter and not situation.over,
        tuple(notes),
    )


def phase_words(situation: Situation) -> list[str]:
    """Return the phase in words; nothing for a game without phases."""
    return [f"phase: {spoken(situation.phase)}"] if situation.phase else []


def settings_words(situation: Situation) -> list[str]:
    """Return the house rules of a match that are a number or a name, in words."""
    return [
        f"{spoken(name)}: {spoken(str(value))}"
        for name, value in situation.settings.items()
        if not isinstance(value, bool)
    ]


def asked(session: Session, units: Units = Units.METRIC) -> str:
    """Return what the player is asked to do now, places in his units."""
    who = player_name(session.ahead.shooter, session.names)
    match session.mode:
        case Mode.CHOOSING:
            return f"{who}: choose what happens next"
        case Mode.PLACING:
            zone = zone_name(session.ahead.in_hand or "")
            ball = ball_name(session.variant, session.cue_ball)
            at = f", at {units.place(session.place)}" if session.place else ""
            return f"{who}: place the {ball}, in hand ({zone}){at}"
        case Mode.CALLING:
            return f"{who}: call {session.wanted.in_words}"
        case Mode.AIMING:
            return f"{who}: aim and strike"
        case Mode.STRIKING | Mode.ROLLING:
            return showing_words(session)
        case Mode.VERDICT:
            return next_words(session.variant, session.match.situation, session.names)
        case Mode.ARRANGING:
            held = session.held
            name = ball_name(session.variant, held) if held else "none"
            place = session.ahead.rest.positions.get(held) if held else None
            return f"Arrange the balls: {name}" + (f" at {units.place(place)}" if place else "")
        case Mode.OVER:
            return result_words(session.match.situation, session.names)


def call_words(call: Call) -> str:
    """Return a call as it would be announced; empty for no call."""
    if call.safety:
        said = "safety"
    else:
        said = " in ".join(spoken(part) for part in (call.ball, call.pocket) if part)
    group = f"claims {spoken(call.group)}" if call.group else ""
    return ", ".join(part for part in (said, group) if part)
