"""What happens in one stroke, as it is made up.

One idea: a tale grows by one event at a time and knows which balls are still on the bed, which
move, which zones they are in and which pins stand; so what it tells could have happened.
Invariant: a ball that is down makes no more events; a pin that lies does not fall.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from engine.game.contacts import zones_by_ball
from engine.game.phrases import RESERVED
from engine.game.situation import ball_to_strike
from engine.table.furniture import BallId
from rulelang import events as e

if TYPE_CHECKING:
    from random import Random

    from engine.game.situation import Situation
    from engine.variant.variant import Variant
    from rulelang.events import Event


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


def begin_tale(variant: Variant, situation: Situation, rng: Random) -> Tale | None:
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
    lying = zones_by_ball(variant.world.table, situation.rest)
    zones = {ball: set(map(str, at)) for ball, at in lying.items()}
    standing = [pin for pin in words.pins if pin not in situation.rest.fallen]
    return Tale(variant, rng, cue, live, zones, standing, moving=[cue])
