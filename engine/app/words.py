"""Names in words: balls, players, zones, sections, who is next; made from values, drawn elsewhere.

One idea: the words are the game's own (names of balls, phases, fouls, options, rules), with
hyphens read as spaces; the sentences about them are in board, telling, choices and prompts.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from engine.game.situation import cue_ball_of

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from engine.game.situation import Situation
    from engine.table.furniture import BallId
    from engine.variant.variant import Variant


@dataclass(frozen=True, slots=True)
class Line:
    """A line of a panel; `tone` is "head", "good", "bad", "plain" or "faint"."""

    text: str
    tone: str = "plain"


def spoken(name: str) -> str:
    """Return a name as it is read aloud."""
    return name.replace("-", " ")


def capital(text: str) -> str:
    """Return a text that begins with a capital letter."""
    return text[:1].upper() + text[1:]


def zone_name(zone: str) -> str:
    """Return what a zone is called; a single letter is a capital, as players write it."""
    return zone.upper() if len(zone) == 1 else spoken(zone)


def ball_name(variant: Variant, ball: str) -> str:
    """Return what a ball is called; the one cue ball of a game is "cue ball"."""
    return "cue ball" if variant.cue_balls == (ball,) else spoken(ball)


def player_name(player: int, names: Sequence[str] = ()) -> str:
    """Return what a player is called: by his name where he has one."""
    own = names[player - 1] if 0 < player <= len(names) else ""
    return own or f"Player {player}"


def tracked_words(situation: Situation, player: int) -> list[str]:
    """Return what the game tracks of a player, as far as there is anything to tell."""
    said = []
    for name, value in situation.state.items():
        if isinstance(value, tuple) and len(value) == situation.players:
            own = value[player - 1]
            if own not in (False, 0, "none", "", None):
                said.append(spoken(name) if own is True else f"{spoken(name)}: {spoken(str(own))}")
    return [*said, "out"] if player in situation.eliminated else said


def turn_words(variant: Variant, situation: Situation) -> list[str]:
    """Return the numbers that the game counts for the turn, as far as they are not 0."""
    counted = [one.name for one in variant.program.tracked.values() if one.scope == "turn"]
    values = {name: situation.state.get(name) for name in counted}
    return [
        f"{spoken(name)}: {value}"
        for name, value in values.items()
        if isinstance(value, int) and not isinstance(value, bool) and value
    ]


def counts_points(variant: Variant) -> bool:
    """Whether any rule of the game gives or takes points."""
    return any(re.search(r"\b(award|deduct)\b", rule.text) for rule in variant.program.rules)


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


def result_words(situation: Situation, names: Sequence[str] = ()) -> str:
    """Return who has won; empty while the game goes on."""
    unit = "match" if situation.match_over else "game"
    if situation.winner is None:
        return ""
    if situation.winner == 0:
        return f"The {unit} is a draw"
    return f"{player_name(situation.winner, names)} wins the {unit}"


def cited(cites: Iterable[str]) -> str:
    """Return sections in brackets; empty where there is none."""
    joined = ", ".join(cites)
    return f" [{joined}]" if joined else ""


def next_words(variant: Variant, after: Situation, names: Sequence[str] = ()) -> str:
    """Return who is next and with what."""
    if after.over:
        return result_words(after, names)
    who = player_name(after.shooter, names)
    if after.offers:
        return f"{who} chooses: {', '.join(spoken(one) for one in after.options)}"
    ball = ball_name(variant, cue_ball_of(variant, after.shooter))
    hand = f", {ball} in hand ({zone_name(after.in_hand)})" if after.in_hand else ""
    return f"Next: {who}{hand}"
