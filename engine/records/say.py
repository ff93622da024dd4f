"""A verdict in the words of a record's `expect`.

One idea: the words that are written are the words that are compared.
"""

from __future__ import annotations

from types import MappingProxyType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from engine.game.situation import Situation
    from engine.game.verdict import Spotted, Verdict
    from rulelang.vocabulary import Tracked


def spotted_of(spotted: Spotted) -> str:
    """Return `9 at foot-spot` or `9 near foot-spot`; the ball alone where no spot is meant."""
    if spotted.spot is None:
        return spotted.ball
    return f"{spotted.ball} {'at' if spotted.on else 'near'} {spotted.spot}"


def in_hand_of(verdict: Verdict) -> str:
    """Return the zone of the ball in hand, or "none"."""
    return verdict.after.in_hand or "none"


def points_of(verdict: Verdict, before: Situation) -> list[int]:
    """Return the change of each player's score."""
    return [now - was for now, was in zip(verdict.after.scores, before.scores, strict=True)]


def state_of(verdict: Verdict, names: Mapping[str, object]) -> dict[str, object]:
    """Return the tracked values of these names, lists for values per player."""
    return {name: plain(verdict.after.state[name]) for name in names}


def plain(value: Tracked) -> object:
    """Return a tracked value as TOML has it."""
    return list(value) if isinstance(value, tuple) else value


SAYINGS: Mapping[str, Callable[[Verdict], object]] = MappingProxyType(
    {
        "fouls": lambda verdict: list(dict.fromkeys(foul.name for foul in verdict.fouls)),
        "options": lambda verdict: list(verdict.after.options),
        "next": lambda verdict: None if verdict.after.over else verdict.after.shooter,
        "phase": lambda verdict: verdict.after.phase,
        "over": lambda verdict: verdict.after.over,
        "winner": lambda verdict: verdict.after.winner,
        "rerack": lambda verdict: verdict.reracked,
    }
)


def expectation(verdict: Verdict, before: Situation) -> dict[str, object]:
    """Return a whole `expect` table for the verdict, as a record written by the program has it."""
    told: dict[str, object] = {
        "fouls": SAYINGS["fouls"](verdict),
        "points": points_of(verdict, before),
        "spotted": [spotted_of(one) for one in verdict.spotted],
    }
    if verdict.reracked:
        told["rerack"] = verdict.reracked
    if verdict.after.over:
        told |= {"over": True, "winner": verdict.after.winner}
    else:
        told |= {
            "next": verdict.after.shooter,
            "options": SAYINGS["options"](verdict),
            "in_hand": in_hand_of(verdict),
        }
        if verdict.after.phase:
            told["phase"] = verdict.after.phase
    state = state_of(verdict, verdict.after.state)
    return told | ({"state": state} if state else {})
