"""One match from its first shot to its end, or as long as it may last.

One idea: match number k of a variant and a seed is always the same, whatever else is played.
Invariant: a finding is a record of the shot, which `python -m engine golden` judges again.
"""

from __future__ import annotations

import random
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import tomli_w

from engine.game.match import Match, next_game, start_match
from engine.game.referee import judge_shot, take_choice
from engine.records.say import expectation
from engine.records.write import before_table, shot_table
from rulelang.evaluate import OutOfFuel, RuleClash
from tools.playouts.players import Players, mix_of
from tools.playouts.watch import faults, same, shuffled

if TYPE_CHECKING:
    from engine.game.shot import Shot
    from engine.game.situation import Situation
    from engine.game.verdict import Verdict
    from engine.variant.variant import Value, Variant

EXPLAINED = 0.01
USUAL = 0.05
PLACES = 0.2
SEVERAL = 0.1
"""The share of shots that are explained, of matches by the usual house rules, of matches in which
it is told where the balls lie, and of matches of two or three games."""


@dataclass(frozen=True, slots=True)
class Finding:
    """What is wrong, and the shot as a record."""

    variant: str
    match: int
    shot: int
    what: str
    record: str


@dataclass(slots=True)
class Tally:
    """What came of the matches played; `keen` are those in which half the shots score."""

    matches: int = 0
    shots: int = 0
    ended: int = 0
    keen: int = 0
    keen_ended: int = 0
    scored: int = 0
    longest: int = 0
    findings: list[Finding] = field(default_factory=list)

    def add(self, other: Tally) -> None:
        """Add what came of other matches."""
        for name in ("matches", "shots", "ended", "keen", "keen_ended", "scored"):
            setattr(self, name, getattr(self, name) + getattr(other, name))
        self.longest = max(self.longest, other.longest)
        self.findings += other.findings


def playout(variant: Variant, number: int, seed: int, most: int) -> Tally:
    """Play one match of at most `most` shots."""
    rng = random.Random(f"{seed} {variant.name} {number}")
    half = number % 2 == 0
    players = Players(variant, rng, mix_of(rng, half=half), places=rng.random() < PLACES)
    mixed = replace(variant, program=shuffled(variant.program, rng))
    fewest, fullest, _ = variant.players
    match = start_match(
        variant, rng.randint(fewest, fullest), _settings(variant, rng), rng.randrange(10**6)
    )
    games = rng.randint(2, 3) if rng.random() < SEVERAL else 1
    tally = Tally(matches=1, keen=int(half))
    while players.shots < most:
        situation = match.situation
        shot, known = players.shot(situation)
        verdict, wrong = _judged(variant, mixed, situation, shot, known, rng)
        if wrong:
            what = "; ".join(wrong)
            record = _record(match, shot, verdict, what)
            tally.findings.append(Finding(variant.name, number, players.shots, what, record))
        if verdict is None or wrong:
            break
        match = replace(match, situation=verdict.after)
        if verdict.after.over:
            games -= 1
            if verdict.after.match_over or (games <= 0 and not _goes_on(variant)):
                tally.ended, tally.keen_ended = 1, int(half)
                break
            match = next_game(match)
    tally.shots = tally.longest = players.shots
    tally.scored = players.scored
    return tally


def _judged(
    variant: Variant,
    mixed: Variant,
    situation: Situation,
    shot: Shot,
    known: Verdict | None,
    rng: random.Random,
) -> tuple[Verdict | None, list[str]]:
    """Return the verdict, the one `known` where it is, and what is wrong with it."""
    explain = rng.random() < EXPLAINED
    try:
        verdict = known
        if verdict is None or explain:
            verdict = judge_shot(variant, situation, shot, explain=explain)
        chosen = situation
        if situation.offers and not shot.is_only_choice:
            chosen = take_choice(variant, situation, shot, explain=False).after
        wrong = list(faults(variant, chosen, shot, verdict))
        wrong += same(verdict, judge_shot(mixed, situation, shot, explain=False))
        tuple(verdict.explanation)
    except (RuleClash, OutOfFuel) as error:
        return None, [str(error) or type(error).__name__]
    except Exception as error:  # noqa: BLE001 - a bug is a finding, told with its shot
        return None, [f"{type(error).__name__}: {error}"]
    return verdict, wrong


def _goes_on(variant: Variant) -> bool:
    """Tell whether the script says when a match of several games is over."""
    return any(rule.late for rule in variant.program.compiled.get("game end", ()))


def _settings(variant: Variant, rng: random.Random) -> dict[str, Value]:
    """Return house rules by lot: some as usual, numbers low enough to come to an end."""
    chosen: dict[str, Value] = {}
    usual = rng.random() < USUAL
    for name, setting in variant.settings.items():
        default = setting.default
        if usual:
            chosen[name] = default
        elif setting.choices:
            chosen[name] = rng.choice(setting.choices)
        elif isinstance(default, bool):
            chosen[name] = rng.random() < 0.5
        elif isinstance(default, int):
            low = 0 if setting.least is None else setting.least
            chosen[name] = rng.randint(low, max(low, min(default, low + 20)))
    return chosen


def _record(match: Match, shot: Shot, verdict: Verdict | None, what: str) -> str:
    """Return the shot as a record that expects what the referee said, if he said anything."""
    expect = {} if verdict is None else expectation(verdict, match.situation)
    record: dict[str, object] = {
        "format": 1,
        "variant": match.variant.name,
        "title": what[:200].replace("\n", " "),
        "settings": dict(match.settings),
        "before": before_table(match.variant, match.situation),
        "shot": [{**shot_table(shot), "expect": expect}],
    }
    return tomli_w.dumps({key: value for key, value in record.items() if value != {}})
