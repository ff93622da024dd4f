"""What the screen says, as text: made from values, drawn elsewhere.

One idea: the words are the game's own (names of balls, phases, fouls, options, rules), with
hyphens read as spaces; this module only puts them into sentences.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from engine.app.session import Mode
from engine.game.situation import cue_ball_of
from rulelang.events import LeftTable, Pocketed

if TYPE_CHECKING:
    from collections.abc import Iterable

    from engine.app.session import Session
    from engine.game.match import Played
    from engine.game.situation import Situation
    from engine.game.verdict import Spotted, Verdict
    from engine.table.furniture import BallId
    from engine.variant.variant import Variant
    from rulelang.decisions import RuleOutcome
    from rulelang.facts import Call


@dataclass(frozen=True, slots=True)
class PlayerLine:
    """One player as the score board shows him."""

    name: str
    score: str
    is_shooting: bool
    notes: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Board:
    """All that the display says at one moment; `on` are the balls to be marked."""

    title: str
    phase: str
    players: tuple[PlayerLine, ...]
    on: tuple[BallId, ...]
    on_words: str
    ask: str
    hint: str
    note: str
    call: str


@dataclass(frozen=True, slots=True)
class Line:
    """A line of a panel; `tone` is "head", "good", "bad", "plain" or "faint"."""

    text: str
    tone: str = "plain"


def spoken(name: str) -> str:
    """Return a name as it is read aloud."""
    return name.replace("-", " ")


def ball_name(variant: Variant, ball: str) -> str:
    """Return what a ball is called; the one cue ball of a game is "cue ball"."""
    return "cue ball" if variant.cue_balls == (ball,) else spoken(ball)


def player_name(player: int) -> str:
    """Return what a player is called."""
    return f"Player {player}"


def named_balls(variant: Variant, balls: Iterable[BallId], among: Iterable[BallId]) -> str:
    """Return balls in words: a group's name where all of it that is in `among` is meant."""
    wanted, there = set(balls), set(among)
    said: list[str] = []
    groups = dict.fromkeys(group for kind in variant.balls for group in kind.groups)
    members = {
        group: {kind.id for kind in variant.balls if group in kind.groups} & there
        for group in groups
    }
    for group in sorted(members, key=lambda name: -len(members[name])):
        if len(members[group]) > 1 and members[group] <= wanted:
            said.append(spoken(group))
            wanted -= members[group]
    said += [spoken(kind.id) for kind in variant.balls if kind.id in wanted]
    return ", ".join(said)


def board_of(session: Session) -> Board:
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
        phase=", ".join([spoken(now.phase), *settings_words(now)]),
        players=tuple(player_line(variant, now, player) for player in range(1, now.players + 1)),
        on=marked,
        on_words=named_balls(variant, marked, now.on_table - {cue}),
        ask=asked(session),
        hint=hint(session),
        note=session.note,
        call=call_words(session.call) if before else "",
    )


def player_line(variant: Variant, situation: Situation, player: int) -> PlayerLine:
    """Return a player's name, score and what the game tracks of him."""
    notes = []
    if len(variant.cue_balls) > 1:
        notes.append(f"plays {spoken(cue_ball_of(variant, player))}")
    for name, value in situation.state.items():
        if isinstance(value, tuple) and len(value) == situation.players:
            own = value[player - 1]
            if own not in (False, 0, "none", "", None):
                notes.append(spoken(name) if own is True else f"{spoken(name)}: {spoken(str(own))}")
    if player in situation.eliminated:
        notes.append("out")
    return PlayerLine(
        player_name(player),
        str(situation.scores[player - 1]) if counts_points(variant) else "",
        player == situation.shooter and not situation.over,
        tuple(notes),
    )


def settings_words(situation: Situation) -> list[str]:
    """Return the house rules of a match that are a number or a name, in words."""
    return [
        f"{spoken(name)} {spoken(str(value))}"
        for name, value in situation.settings.items()
        if not isinstance(value, bool)
    ]


def counts_points(variant: Variant) -> bool:
    """Whether any rule of the game gives or takes points."""
    return any(re.search(r"\b(award|deduct)\b", rule.text) for rule in variant.program.rules)


def asked(session: Session) -> str:
    """Return what the player is asked to do now."""
    who = player_name(session.ahead.shooter)
    match session.mode:
        case Mode.CHOOSING:
            return f"{who}: choose"
        case Mode.PLACING:
            zone = spoken(session.ahead.in_hand or "")
            ball = ball_name(session.variant, session.cue_ball)
            return f"{who}: ball in hand ({zone}) - place the {ball}"
        case Mode.CALLING:
            return f"{who}: call {session.wanted.in_words}"
        case Mode.AIMING:
            return f"{who} to play"
        case Mode.STRIKING | Mode.ROLLING:
            return "Replay" if session.back_to else ""
        case Mode.VERDICT:
            return ""
        case Mode.OVER:
            return result_words(session.match.situation)


def call_words(call: Call) -> str:
    """Return a call as it would be announced; empty for no call."""
    if call.safety:
        said = "safety"
    else:
        said = " in ".join(spoken(part) for part in (call.ball, call.pocket) if part)
    group = f"claims {spoken(call.group)}" if call.group else ""
    return ", ".join(part for part in (said, group) if part)


def hint(session: Session) -> str:
    """Return the keys that matter now."""
    wanted = session.wanted
    match session.mode:
        case Mode.CHOOSING:
            return "Up / Down and Enter, or click"
        case Mode.PLACING:
            return "mouse or arrows move it (Shift: fine)   Enter puts it down"
        case Mode.CALLING:
            keys = [
                "Tab or click: ball" if wanted.ball else "",
                "P or click: pocket" if wanted.pocket else "",
                "O: safety" if wanted.safety else "",
                "G: group" if wanted.group else "",
                "Enter accepts",
            ]
            return "   ".join(key for key in keys if key)
        case Mode.AIMING:
            back = "   B back" if session.wanted.anything or session.placing else ""
            return f"Space strikes   arrows aim and power   WASD tip   T aid{back}   F1 keys"
        case Mode.STRIKING | Mode.ROLLING:
            return "F skips to the end"
        case Mode.VERDICT:
            return "Enter goes on   H why   R replay   F5 save the shot   U undo"
        case Mode.OVER:
            return "N next game   H why   U undo   Esc menu"


def result_words(situation: Situation) -> str:
    """Return who has won; empty while the game goes on."""
    unit = "match" if situation.match_over else "game"
    if situation.winner is None:
        return ""
    if situation.winner == 0:
        return f"The {unit} is a draw"
    return f"{player_name(situation.winner)} wins the {unit}"


def cited(cites: Iterable[str]) -> str:
    """Return sections in brackets; empty where there is none."""
    joined = ", ".join(cites)
    return f" [{joined}]" if joined else ""


def verdict_lines(variant: Variant, played: Played) -> list[Line]:
    """Return the referee's words on a shot."""
    verdict, after = played.verdict, played.verdict.after
    if played.shot.is_only_choice:
        lines = [Line(f"Chosen: {spoken(played.shot.choice or '')}", "good")]
    else:
        lines = _fouls(verdict) or [Line("No foul", "good")]
    lines += _happened(variant, verdict)
    for player, points in enumerate(verdict.points, start=1):
        if points:
            said = f"{player_name(player)}: {points:+d} {'point' if abs(points) == 1 else 'points'}"
            lines.append(Line(said, "head"))
    lines += _put_back(variant, verdict)
    lines += [Line(one, "faint") for one in _reasons(verdict)]
    lines.append(Line(next_words(variant, after), "head"))
    return lines


def _fouls(verdict: Verdict) -> list[Line]:
    lines = []
    for foul in verdict.fouls:
        worth = f", {foul.worth} points" if foul.worth > 1 else ""
        lines.append(Line(f"Foul: {spoken(foul.name)}{worth}{cited(foul.cites)}", "bad"))
        if foul.rule and foul.rule.lower() != spoken(foul.name):
            lines.append(Line(foul.rule, "faint"))
    return lines


def _happened(variant: Variant, verdict: Verdict) -> list[Line]:
    lines = []
    for event in verdict.events:
        if isinstance(event, Pocketed):
            lines.append(Line(f"{ball_name(variant, event.ball)} pocketed {spoken(event.pocket)}"))
        elif isinstance(event, LeftTable):
            lines.append(Line(f"{ball_name(variant, event.ball)} left the table"))
    return lines


def _put_back(variant: Variant, verdict: Verdict) -> list[Line]:
    lines = [Line(f"{ball_name(variant, one.ball)} back {_where(one)}") for one in verdict.spotted]
    lines += [Line(f"{ball_name(variant, ball)} stays off the table") for ball in verdict.removed]
    if verdict.reracked:
        lines.append(Line(f"{verdict.reracked} balls are racked"))
    return lines


def _reasons(verdict: Verdict) -> list[str]:
    """Return the rules that decided, fouls apart: they are told already."""
    return [
        f"{one.rule}{cited(one.cites)}"
        for one in verdict.explanation
        if one.outcome == "fired"
        and one.section not in ("fouls", "before shot")
        and any(not said.startswith(BOOKKEEPING) for said in one.said)
    ]


def next_words(variant: Variant, after: Situation) -> str:
    """Return who is next and with what."""
    if after.over:
        return result_words(after)
    who = player_name(after.shooter)
    if after.offers:
        return f"{who} chooses: {', '.join(spoken(one) for one in after.options)}"
    ball = ball_name(variant, cue_ball_of(variant, after.shooter))
    hand = f", {ball} in hand ({spoken(after.in_hand)})" if after.in_hand else ""
    return f"Next: {who}{hand}"


BOOKKEEPING = ("reset ", "set ", "add ", "nothing")
"""How the words of a rule begin that only keeps count."""
MARKS = {"fired": "+", "silent": "-", "overridden": "x"}


def explanation_lines(outcomes: Iterable[RuleOutcome]) -> list[Line]:
    """Return how every rule fared: what it said, or why it was silent, section by section."""
    lines: list[Line] = []
    section = ""
    for one in outcomes:
        if one.section != section:
            section = one.section
            lines.append(Line(section, "head"))
        tone = {"fired": "good", "overridden": "bad"}.get(one.outcome, "faint")
        lines.append(Line(f"{MARKS.get(one.outcome, '?')} {one.rule}{cited(one.cites)}", tone))
        lines += [Line(f"    {said}") for said in one.said if one.outcome == "fired"]
        if one.because:
            lines.append(Line(f"    {one.because}", "faint"))
    return lines or [Line("The referee has not spoken yet.", "faint")]


def _where(spotted: Spotted) -> str:
    if spotted.spot is None:
        return "on the table"
    return f"{'on' if spotted.on else 'near'} the {spoken(spotted.spot)}"
