"""A shot that can be told, silly or good: call, events, facts, where the cue ball was put.

One idea: only the vocabulary is known; a ball that is down makes no more events, a ball enters a
zone that it is not in, and a pin that lies does not fall. A good shot follows a Recipe, so that
one which scored can be played again.
Invariant: the same Random and the same situation make the same shot.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from engine.game.shot import NO_CALL, Shot
from engine.game.situation import Rest, ball_to_strike
from engine.table.furniture import BallId
from rulelang import events as e
from rulelang.facts import Call
from tools.playouts.places import anywhere, placement
from tools.playouts.tale import Tale, begin_tale

if TYPE_CHECKING:
    from random import Random

    from engine.game.situation import Situation
    from engine.variant.variant import Value, Variant
    from rulelang.evaluate import Admission

RARE = (
    (lambda tale: e.TipHitAgain(tale.cue)),
    (lambda tale: e.TipFollowed(tale.cue)),
    (lambda tale: e.PlayerTouched(tale.one())),
    (lambda _tale: e.FootLifted()),
    (lambda _tale: e.PlayedTooSoon()),
)
"""What an eye at the table sees now and then, besides the balls."""

TARGET, CUE, BOTH, NEITHER = "target", "cue", "both", "neither"
FALLS = (TARGET,) * 12 + (CUE,) * 2 + (BOTH,) * 2 + (NEITHER,) * 4


@dataclass(frozen=True, slots=True)
class Recipe:
    """What a good stroke is made of, whichever balls it is played with.

    `first` and `then` are cushions of the cue ball before and after it hits the target, `bank`
    the target's own, `rails` cushions of any balls. `kisses` says for each further ball hit
    whether the cue ball hits it, else the target does. `falls` says who drops, the target in
    `pocket`, the cue ball there too where `follows`. `claims`: a group is called where one may be.
    """

    first: int
    then: int
    bank: int
    rails: int
    kisses: tuple[bool, ...]
    pins: int
    falls: str
    pocket: str | None
    follows: bool
    claims: bool


def any_recipe(variant: Variant, rng: Random) -> Recipe:
    """Return the recipe of a stroke that scores in some game."""
    words = variant.program.vocabulary
    return Recipe(
        first=rng.choice((0, 0, 1, 3)),
        then=rng.choice((0, 1, 3, 4)),
        bank=rng.choice((0, 0, 0, 1)),
        rails=rng.choice((0, 1, 4)),
        kisses=tuple(rng.random() < 0.5 for _ in range(rng.choice((0, 1, 1, 2)))),
        pins=rng.randint(0, 3) if words.pins else 0,
        falls=rng.choice(FALLS),
        pocket=rng.choice(words.pockets) if words.pockets else None,
        follows=rng.random() < 0.5,
        claims=rng.random() < 0.5,
    )


def silly_shot(
    variant: Variant,
    situation: Situation,
    ahead: Admission,
    rng: Random,
    *,
    places: bool,
    choice: str | None = None,
) -> Shot:
    """Return any stroke that can be told; `places` says where the balls come to rest."""
    call = _any_call(variant, situation, ahead, rng)
    tale = begin_tale(variant, situation, rng)
    if tale is None:
        return Shot(choice=choice, call=call, events=(e.StrokeOmitted(),))
    for make in RARE:
        if rng.random() < 0.01:
            tale.events.append(make(tale))
    for _ in range(min(40, int(rng.expovariate(0.2)))):
        _silly(tale)
    pockets = variant.program.vocabulary.pockets
    if pockets and tale.live and rng.random() < 0.02:
        tale.settle(tale.one())
    return _told(variant, situation, tale, call, choice, places=places)


def good_shot(
    variant: Variant,
    situation: Situation,
    ahead: Admission,
    rng: Random,
    recipe: Recipe,
    *,
    places: bool,
) -> Shot:
    """Return a stroke by a recipe: a ball on first, what is to be called called as it comes."""
    tale = begin_tale(variant, situation, rng)
    if tale is None:
        return Shot(events=(e.StrokeOmitted(),))
    others = [ball for ball in tale.live if ball != tale.cue]
    if not others:
        _alone(recipe, tale)
        return _told(variant, situation, tale, NO_CALL, None, places=places)
    on = sorted(BallId(ball) for ball in ahead.on if ball in tale.live and ball != tale.cue)
    target = rng.choice(on or others)
    words = " ".join(one.what for one in ahead.required)
    call = Call(
        target if "ball" in words else None,
        recipe.pocket if "pocket" in words else None,
        group=_group_of(variant, target) if "group" in words and recipe.claims else None,
    )
    _follow(recipe, tale, target, [ball for ball in others if ball != target])
    return _told(variant, situation, tale, call, None, places=places)


def _alone(recipe: Recipe, tale: Tale) -> None:
    """Let happen what the recipe says of the only ball on the bed."""
    for _ in range(recipe.first):
        tale.cushion(tale.cue)
    if recipe.pocket is not None and recipe.falls != NEITHER:
        tale.pocket(tale.cue, recipe.pocket)


def _follow(recipe: Recipe, tale: Tale, target: BallId, others: list[BallId]) -> None:
    """Let happen what the recipe says."""
    rng = tale.rng
    for _ in range(recipe.first):
        tale.cushion(tale.cue)
    tale.hit(tale.cue, [target])
    for _ in range(recipe.then):
        tale.cushion(tale.cue)
    for _ in range(recipe.bank):
        tale.cushion(target)
    kissed = rng.sample(others, min(len(others), len(recipe.kisses)))
    for other, by_cue in zip(kissed, recipe.kisses, strict=False):
        tale.hit(tale.cue if by_cue else target, [other])
    for ball in rng.sample(tale.live, min(len(tale.live), recipe.rails)):
        tale.cushion(ball)
    for _ in range(recipe.pins if tale.standing else 0):
        tale.topple(rng.choice([target, *others]))
    if recipe.pocket is None:
        return
    if recipe.falls in (TARGET, BOTH):
        tale.pocket(target, recipe.pocket)
    if recipe.falls in (CUE, BOTH):
        pockets = tale.variant.program.vocabulary.pockets
        tale.pocket(tale.cue, recipe.pocket if recipe.follows else rng.choice(pockets))


def _silly(tale: Tale) -> None:
    """Add one event at random."""
    rng, ball = tale.rng, tale.mover()
    pockets = tale.variant.program.vocabulary.pockets
    lines = tale.variant.program.vocabulary.lines
    if tale.down and rng.random() < 0.03:
        tale.back(rng.choice(sorted(tale.down)))
        return
    if ball is None:
        return
    others = [other for other in tale.live if other != ball]
    draw = rng.random()
    if draw < 0.35:
        if others:
            tale.hit(ball, rng.sample(others, 2 if len(others) > 1 and draw < 0.02 else 1))
    elif draw < 0.6:
        tale.cushion(ball)
    elif draw < 0.72:
        if pockets:
            tale.pocket(ball, rng.choice(pockets))
    elif draw < 0.76:
        if pockets:
            tale.events.append(e.JawHit(ball, rng.choice(pockets)))
    elif draw < 0.82:
        if lines:
            tale.events.append(e.LineCrossed(ball, rng.choice(lines)))
    elif draw < 0.92:
        (tale.zone if draw < 0.87 else tale.topple)(ball)
    elif draw < 0.94:
        tale.off(ball)
    elif draw < 0.95:
        tale.events.append(e.OutsideHit(ball))
    elif draw < 0.97 and others:
        tale.events.append(e.JumpedOver(ball, rng.choice(others)))


def _told(
    variant: Variant,
    situation: Situation,
    tale: Tale,
    call: Call,
    choice: str | None,
    *,
    places: bool,
) -> Shot:
    after = anywhere(variant, tale.live, tale.rng) if places else None
    own = tale.cue == ball_to_strike(variant, situation)
    return Shot(
        choice=choice,
        call=call,
        struck=None if own else tale.cue,
        placement=placement(variant, situation, tale.rng) if own else None,
        events=tuple(tale.events),
        facts=_facts(variant, tale.rng),
        after=Rest() if after is None else Rest(positions=after),
    )


def _any_call(variant: Variant, situation: Situation, ahead: Admission, rng: Random) -> Call:
    if not ahead.required and rng.random() < 0.9:
        return NO_CALL
    words = variant.program.vocabulary
    balls = [ball.name for ball in words.balls if ball.name in situation.on_table]
    ball = rng.choice(balls) if balls and rng.random() < 0.8 else None
    return Call(
        ball,
        rng.choice(words.pockets) if words.pockets and rng.random() < 0.8 else None,
        safety=rng.random() < 0.2,
        group=None if ball is None or rng.random() < 0.7 else _group_of(variant, ball),
    )


def _group_of(variant: Variant, ball: str) -> str | None:
    words = variant.program.vocabulary
    return next((one.groups[0] for one in words.balls if one.name == ball and one.groups), None)


def _facts(variant: Variant, rng: Random) -> dict[str, Value]:
    """Return what an eye told: in one shot of twenty, some facts, each with a value it may have.

    More would end the matches of games that can be conceded before they have begun.
    """
    if rng.random() < 0.95:
        return {}
    balls = [ball.name for ball in variant.program.vocabulary.balls]
    told: dict[str, Value] = {}
    for name, fact in variant.program.facts.items():
        if name in variant.program.timers or rng.random() < 0.7:
            continue
        if fact.values:
            told[name] = rng.choice(fact.values)
        elif isinstance(fact.default, bool) or fact.kind == "flag":
            told[name] = rng.random() < 0.5
        elif fact.kind == "number":
            told[name] = rng.randint(0, 3)
        else:
            told[name] = rng.choice([*balls, "none"])
    return told
