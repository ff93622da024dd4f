"""The referee's words on a shot, and how every rule fared.

One idea: what the verdict holds is said in the order in which a player asks: was it a foul, what
fell, how many points, what was put back, why, who is next.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from engine.app.words import (
    Line,
    ball_name,
    capital,
    cited,
    counts_points,
    next_words,
    player_name,
    spoken,
    tracked_words,
)
from rulelang.events import LeftTable, PinToppled, Pocketed
from rulelang.program import by_section

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from engine.game.match import Played
    from engine.game.verdict import Spotted, Verdict
    from engine.variant.variant import Variant
    from rulelang.decisions import RuleOutcome
    from rulelang.program import RuleInfo


def verdict_lines(variant: Variant, played: Played, names: Sequence[str] = ()) -> list[Line]:
    """Return the referee's words on a shot."""
    verdict, after = played.verdict, played.verdict.after
    if played.shot.is_only_choice:
        lines = [Line(f"Chosen: {spoken(played.shot.choice or '')}", "good")]
    else:
        lines = _fouls(verdict) or [Line("No foul", "good")]
    timers = variant.program.timers
    ran_out = [name for name, told in played.shot.facts.items() if told and name in timers]
    lines += [Line(capital(f"{spoken(name)} ran out")) for name in ran_out]
    lines += _happened(variant, verdict)
    for player, points in enumerate(verdict.points, start=1):
        if points:
            unit = "point" if abs(points) == 1 else "points"
            said = f"{player_name(player, names)}: {points:+d} {unit}"
            lines.append(Line(said, "head"))
    lines += _counted(variant, played, names)
    lines += _put_back(variant, verdict)
    lines += [Line(one, "faint") for one in _reasons(verdict)]
    lines.append(Line(next_words(variant, after, names), "head"))
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
            lines.append(
                Line(f"{ball_name(variant, event.ball)} pocketed ({spoken(event.pocket)})")
            )
        elif isinstance(event, LeftTable):
            lines.append(Line(f"{ball_name(variant, event.ball)} left the table"))
    fell = [spoken(event.pin) for event in verdict.events if isinstance(event, PinToppled)]
    return [*lines, Line(capital(f"{', '.join(fell)} fell"))] if fell else lines


def _counted(variant: Variant, played: Played, names: Sequence[str]) -> list[Line]:
    """Return what is new of each player where the game counts no points: lives, groups, fouls."""
    if counts_points(variant):
        return []
    lines = []
    for player in range(1, played.before.players + 1):
        before = tracked_words(played.before, player)
        new = [one for one in tracked_words(played.verdict.after, player) if one not in before]
        if new:
            lines.append(Line(f"{player_name(player, names)}: {', '.join(new)}", "head"))
    return lines


def _put_back(variant: Variant, verdict: Verdict) -> list[Line]:
    lines = [Line(f"{ball_name(variant, one.ball)} back {_where(one)}") for one in verdict.spotted]
    lines += [Line(f"{ball_name(variant, ball)} stays off the table") for ball in verdict.removed]
    if verdict.reracked:
        lines.append(Line(f"{verdict.reracked} balls are racked"))
    return lines


def _reasons(verdict: Verdict) -> list[str]:
    """Return the rules that decided, fouls apart: they are told already."""
    told = [
        f"{one.rule}{cited(one.cites)}"
        for one in verdict.explanation
        if one.outcome == "fired"
        and one.section not in ("fouls", "before shot")
        and any(not said.startswith(BOOKKEEPING) for said in one.said)
    ]
    return list(dict.fromkeys(told))


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


MOMENTS = {
    "before shot": "Before a shot",
    "fouls": "Fouls",
    "points": "Points",
    "turn": "Whose turn it is",
    "table": "What comes back or goes",
    "next shot": "The next shot",
    "ending": "How it ends",
}
"""The sections of a script in a player's words; others are said as the script has them."""


def rules_lines(variant: Variant) -> list[Line]:
    """Return a game's rules by section, each with what it cites and the script's own words."""
    lines = [Line(f"{variant.title}, by the {variant.rulebook}", "good")]
    section = ""
    for rule in by_section(variant.program.rules):
        if rule.section != section:
            section = rule.section
            lines += [Line(""), Line(MOMENTS.get(section, capital(section)), "head")]
        lines.append(Line(f"  {rule.name}{cited(rule.cites)}", "good"))
        lines += [Line(f"      {text}", "faint") for text in _body(rule)]
    return lines


def _body(rule: RuleInfo) -> list[str]:
    """Return a rule's words after its name and sections, one line for each of the script's."""
    head, _, body = rule.text.removeprefix(f'"{rule.name}"').partition(":")
    _, overrides, others = head.partition("overrides")
    first = [f"in place of {others.strip()}"] if overrides else []
    return [*first, *(line.strip() for line in body.splitlines() if line.strip())]
