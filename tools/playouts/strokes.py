"""A shot that nobody would play but that can be told: choice, call, events, facts.

One idea: only the vocabulary is known; a ball that is down makes no more events, a ball enters a
zone that it is not in, and a pin that lies does not fall.
Invariant: the same Random and the same situation make the same shot.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import hypot
from typing import TYPE_CHECKING

from engine.game.phrases import RESERVED
from engine.game.referee import look_ahead
from engine.game.shot import NO_CALL, Shot
from engine.game.situation import Rest, ball_to_strike
from engine.table.furniture import BallId
from rulelang import events as e
from rulelang.facts import Call

if TYPE_CHECKING:
    from random import Random

    from engine.game.situation import Situation
    from engine.table.furniture import Point
    from engine.variant.variant import Value, Variant
    from rulelang.evaluate import Admission
    from rulelang.events import Event

RARE = (
    (lambda tale: e.TipHitAgain(tale.cue)),
    (lambda tale: e.TipFollowed(tale.cue)),
    (lambda tale: e.PlayerTouched(tale.one())),
    (lambda _tale: e.FootLifted()),
    (lambda _tale: e.PlayedTooSoon()),
)
"""What an eye at the table sees now and then, besides the balls."""


@dataclass(slots=True)
class Tale:
    """The events of one stroke as they are made up; `live` are the balls still on the bed."""

    variant: Variant
    rng: Random
    cue: BallId
    live: list[BallId]
    zones: dict[BallId, set[str]]
    standing: list[str]
    events: list[Event] = field(default_factory=list)
    moving: list[BallId] = field(default_factory=list)
    down: dict[BallId, str] = field(default_factory=dict)

    def one(self) -> BallId:
        """Return a ball that lies on the bed."""
        return self.rng.choice(self.live)

    def mover(self) -> BallId | None:
        """Return a ball that moves and is still on the bed, the struck one more often."""
        if self.cue in self.moving and self.rng.random() < 0.4:
            return self.cue
        return self.rng.choice(self.moving) if self.moving else None

    def hit(self, ball: BallId, others: list[BallId]) -> None:
        """Let a ball touch others, which move from then on."""
        self.events.append(e.BallsHit(ball, tuple(others)))
        self.moving += [other for other in others if other not in self.moving]

    def cushion(self, ball: BallId) -> None:
        """Let a ball touch a cushion."""
        cushions = self.variant.program.vocabulary.cushions
        if cushions:
            self.events.append(e.CushionHit(ball, self.rng.choice(cushions)))

    def pocket(self, ball: BallId, pocket: str) -> None:
        """Let a ball fall."""
        self.events.append(e.Pocketed(ball, pocket))
        self.down[ball] = pocket
        self._gone(ball)

    def off(self, ball: BallId) -> None:
        """Let a ball leave the table."""
        self.events.append(e.LeftTable(ball))
        self._gone(ball)

    def back(self, ball: BallId) -> None:
        """Let a ball that fell come back."""
        self.events.append(e.Rebounded(ball, self.down.pop(ball)))
        self.live.append(ball)
        self.moving.append(ball)

    def settle(self, ball: BallId) -> None:
        """Let a ball fall after all have stopped."""
        pocket = self.rng.choice(self.variant.program.vocabulary.pockets)
        delay = float(self.rng.randint(1, 9))
        self.events.append(e.Settled(ball, pocket, delay))
        self._gone(ball)

    def zone(self, ball: BallId) -> None:
        """Let a ball enter a zone, or leave one that it is in."""
        known = self.variant.program.vocabulary.zones
        names = [zone for zone in known if zone not in RESERVED]
        if not names:
            return
        name, inside = self.rng.choice(names), self.zones.setdefault(ball, set())
        self.events.append(e.ZoneLeft(ball, name) if name in inside else e.ZoneEntered(ball, name))
        inside ^= {name}

    def topple(self, ball: BallId) -> None:
        """Let a ball make a pin fall, or touch it, or the pin lean on the ball."""
        if not self.standing:
            return
        pin = self.rng.choice(self.standing)
        draw = self.rng.random()
        if draw < 0.1:
            self.events.append(e.PinTouched(ball, pin))
            return
        self.standing.remove(pin)
        self.events.append(e.PinLeaned(pin, ball) if draw < 0.2 else e.PinToppled((ball,), pin))

    def _gone(self, ball: BallId) -> None:
        self.live.remove(ball)
        if ball in self.moving:
            self.moving.remove(ball)


def silly_shot(
    variant: Variant, situation: Situation, rng: Random, *, places: bool, choice: str | None = None
) -> Shot:
    """Return any stroke that can be told; `places` says where the balls come to rest."""
    ahead = look_ahead(variant, situation)
    call = _any_call(variant, situation, ahead, rng)
    if rng.random() < 0.01:
        event = rng.choice((e.StrokeOmitted(), e.TimeCalled()))
        return Shot(choice=choice, call=call, events=(event,))
    tale = _begun(variant, situation, rng)
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
    variant: Variant, situation: Situation, rng: Random, *, places: bool, choice: str | None = None
) -> Shot:
    """Return a stroke of the kind that scores in some game: on first, cushions, a called pot."""
    ahead = look_ahead(variant, situation)
    tale = _begun(variant, situation, rng)
    if tale is None:
        return Shot(choice=choice, events=(e.StrokeOmitted(),))
    on = sorted(BallId(ball) for ball in ahead.on if ball in tale.live and ball != tale.cue)
    others = [ball for ball in tale.live if ball != tale.cue]
    if not others:
        return Shot(choice=choice, events=(e.StrokeOmitted(),))
    target = rng.choice(on or others)
    pockets = variant.program.vocabulary.pockets
    pocket = rng.choice(pockets) if pockets else None
    words = " ".join(one.what for one in ahead.required)
    call = Call(
        target if "ball" in words else None,
        pocket if "pocket" in words else None,
        group=_group_of(variant, target) if "group" in words and rng.random() < 0.5 else None,
    )
    for _ in range(rng.choice((0, 0, 1, 3))):
        tale.cushion(tale.cue)
    tale.hit(tale.cue, [target])
    for _ in range(rng.choice((0, 1, 3, 4))):
        tale.cushion(tale.cue)
    for other in rng.sample(others, min(len(others), rng.choice((0, 1, 1, 2)))):
        if other != target:
            tale.hit(rng.choice((tale.cue, target)), [other])
    for ball in rng.sample(tale.live, min(len(tale.live), rng.choice((0, 1, 4)))):
        tale.cushion(ball)
    if tale.standing:
        for _ in range(rng.randint(0, 3)):
            tale.topple(rng.choice([ball for ball in tale.live if ball != tale.cue]))
    falls = rng.random()
    if pocket is not None and falls < 0.85:
        tale.pocket(target, pocket)
    if pocket is not None and 0.75 < falls < 0.92:
        tale.pocket(tale.cue, rng.choice(pockets))
    return _told(variant, situation, tale, call, choice, places=places)


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


def _begun(variant: Variant, situation: Situation, rng: Random) -> Tale | None:
    """Return a tale in which the ball was just struck, None where there is none to strike."""
    words = variant.program.vocabulary
    order = [ball.name for ball in words.balls]
    live = [BallId(ball) for ball in order if ball in situation.on_table]
    cue = ball_to_strike(variant, situation)
    if situation.strikable:
        cue = rng.choice(sorted(situation.strikable & set(live)) or [cue])
    elif rng.random() < 0.01:
        cue = rng.choice([ball for ball in variant.cue_balls if ball in live] or [cue])
    if cue not in live:
        return None
    zones = {ball: set(map(str, at)) for ball, at in situation.rest.zones.items()}
    standing = [pin for pin in words.pins if pin not in situation.rest.fallen]
    return Tale(variant, rng, cue, live, zones, standing, moving=[cue])


def _told(
    variant: Variant,
    situation: Situation,
    tale: Tale,
    call: Call,
    choice: str | None,
    *,
    places: bool,
) -> Shot:
    after = _anywhere(variant, tale.live, tale.rng) if places else None
    struck = None if tale.cue == ball_to_strike(variant, situation) else tale.cue
    return Shot(
        choice=choice,
        call=call,
        struck=struck,
        events=tuple(tale.events),
        facts=_facts(variant, tale.rng),
        after=Rest() if after is None else Rest(positions=after),
    )


def _anywhere(variant: Variant, balls: list[BallId], rng: Random) -> dict[BallId, Point] | None:
    """Return places (m) on the bed for the balls, none over another; None where there is no room.

    Now and then a ball lies on one of the spots.
    """
    table = variant.world.table
    radii = {one.id: one.radius for one in variant.world.balls}
    spots = list(table.spots.values())
    lying: dict[BallId, Point] = {}
    for ball in balls:
        radius = radii[ball]
        wide, high = table.length / 2 - 2 * radius, table.width / 2 - 2 * radius
        for _ in range(50):
            at = (rng.uniform(-wide, wide), rng.uniform(-high, high))
            if spots and rng.random() < 0.2:
                at = rng.choice(spots)
            if all(
                hypot(at[0] - x, at[1] - y) > radius + radii[other] + 1e-4
                for other, (x, y) in lying.items()
            ):
                lying[ball] = at
                break
        else:
            return None
    return lying


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
    """Return what an eye told: some declared facts, each with a value that it may have."""
    balls = [ball.name for ball in variant.program.vocabulary.balls]
    told: dict[str, Value] = {}
    for name, fact in variant.program.facts.items():
        if rng.random() < 0.85:
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
