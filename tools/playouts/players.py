"""The players of one match: how silly they are, how hard they try, what they have learnt.

One idea: a stroke that is to score is tried again and again until the referee would give something
for it; what scored is remembered by its recipe and tried first the next time. Matches differ in
their mix, so that a game is seen silly and seen in earnest.
Invariant: the same Random and the same situations make the same shots.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from engine.game.clock import time_out
from engine.game.referee import judge_shot, look_ahead, take_choice
from engine.game.shot import NO_CALL, Shot
from rulelang import events as e
from tools.playouts.strokes import Recipe, any_recipe, good_shot, silly_shot

if TYPE_CHECKING:
    from random import Random

    from engine.game.situation import Situation
    from engine.game.verdict import Verdict
    from engine.variant.variant import Variant
    from rulelang.evaluate import Admission

SILLY = 0.1
"""The share of silly shots in a match where half are to score; the rest mostly fail."""
WHOLLY = 0.05
"""The share of the other matches that are wholly silly, for so many shots:"""
PATIENCE = 150
"""A match that lasts longer is played in earnest from then on, half its shots to score, and an
attempt that would be a foul is given up for another, a few times."""
TRIES, FEWEST = 16, 4
"""So many strokes are made up where one is to score, fewer where that was long in vain."""
REMEMBERED = 8
AGAIN = 0.6
"""How many recipes a player remembers, and how often he plays one of them again."""
UNPLAYED = 0.02
"""The share of strokes that are left out, at times because a timer ran out or time is called."""


@dataclass(frozen=True, slots=True)
class Mix:
    """The shares of shots that are silly, and that are to score; the others are good attempts."""

    silly: float
    scoring: float


HALF = Mix(SILLY, 0.5)


def mix_of(rng: Random, *, half: bool) -> Mix:
    """Return a match's mix by lot: half the shots score, or fewer do, or all shots are silly."""
    if half:
        return HALF
    if rng.random() < WHOLLY:
        return Mix(1.0, 0.0)
    return Mix(rng.uniform(SILLY, 0.5), rng.uniform(0.2, 0.5))


@dataclass(slots=True)
class Players:
    """Everybody at one table; `known` are recipes that scored, by player, the newest last."""

    variant: Variant
    rng: Random
    mix: Mix
    places: bool
    shots: int = 0
    scored: int = 0
    in_vain: int = 0
    known: dict[int, list[Recipe]] = field(default_factory=dict)

    def shot(self, situation: Situation) -> tuple[Shot, Verdict | None]:
        """Return the next shot, with the verdict on it where it was already asked for."""
        self.shots += 1
        earnest = self.shots > PATIENCE
        mix = HALF if earnest else self.mix
        if situation.offers:
            return self._choice(situation), None
        draw = self.rng.random()
        if draw < UNPLAYED:
            return self._unplayed(), None
        ahead = look_ahead(self.variant, situation)
        draw = self.rng.random()
        if draw < mix.silly:
            return self._silly(situation, ahead), None
        if draw < mix.silly + mix.scoring:
            return self._try(situation, ahead)
        return self._attempt(situation, ahead, FEWEST if earnest else 1)

    def _choice(self, situation: Situation) -> Shot:
        """Return a choice alone, or a stroke after the choice."""
        rng, choice = self.rng, self.rng.choice(situation.options)
        balls = sorted(situation.on_table)
        ball = rng.choice(balls) if balls else None
        alone = Shot(choice=choice, call=replace(NO_CALL, ball=ball))
        if rng.random() < 0.7:
            return alone
        chosen = take_choice(self.variant, situation, alone, explain=False).after
        if chosen.over or chosen.offers:
            return alone
        stroke = self._silly(chosen, look_ahead(self.variant, chosen), choice)
        return replace(stroke, call=replace(stroke.call, ball=ball))

    def _unplayed(self) -> Shot:
        timers = sorted(self.variant.program.timers)
        if timers and self.rng.random() < 0.5:
            return time_out(*self.rng.sample(timers, self.rng.choice((1, 1, len(timers)))))
        event = self.rng.choice((e.StrokeOmitted(), e.TimeCalled()))
        return Shot(events=(event,))

    def _silly(self, situation: Situation, ahead: Admission, choice: str | None = None) -> Shot:
        return silly_shot(
            self.variant, situation, ahead, self.rng, places=self.places, choice=choice
        )

    def _good(self, situation: Situation, ahead: Admission, recipe: Recipe) -> Shot:
        return good_shot(self.variant, situation, ahead, self.rng, recipe, places=self.places)

    def _attempt(
        self, situation: Situation, ahead: Admission, tries: int
    ) -> tuple[Shot, Verdict | None]:
        """Return any good stroke, of several the first that is no foul."""
        verdict = None
        for left in reversed(range(tries)):
            shot = self._good(situation, ahead, any_recipe(self.variant, self.rng))
            if left:
                verdict = _judged(self.variant, situation, shot)
                if verdict is None or not verdict.fouls:
                    return shot, verdict
        return shot, None

    def _try(self, situation: Situation, ahead: Admission) -> tuple[Shot, Verdict | None]:
        """Return the first of some strokes that scores, or the last of them."""
        known = self.known.setdefault(situation.shooter, [])
        for _ in range(max(FEWEST, TRIES >> self.in_vain)):
            again = known and self.rng.random() < AGAIN
            recipe = self.rng.choice(known) if again else any_recipe(self.variant, self.rng)
            shot = self._good(situation, ahead, recipe)
            verdict = _judged(self.variant, situation, shot)
            if verdict is None or gains(situation, verdict):
                self._learn(known, recipe)
                return shot, verdict
        self.in_vain += 1
        return shot, verdict

    def _learn(self, known: list[Recipe], recipe: Recipe) -> None:
        self.scored += 1
        self.in_vain = 0
        if recipe in known:
            known.remove(recipe)
        known.append(recipe)
        del known[:-REMEMBERED]


def gains(situation: Situation, verdict: Verdict) -> bool:
    """Tell whether a shot wins, scores or at least keeps the table."""
    if verdict.fouls:
        return False
    me = situation.shooter
    if verdict.after.over:
        return verdict.after.winner == me
    return verdict.points[me - 1] > 0 or verdict.after.shooter == me


def _judged(variant: Variant, situation: Situation, shot: Shot) -> Verdict | None:
    """Return the verdict, None where there is none: the match will meet that, and tell."""
    try:
        return judge_shot(variant, situation, shot, explain=False)
    except Exception:  # noqa: BLE001 - a bug is a finding, told when the shot is played
        return None
