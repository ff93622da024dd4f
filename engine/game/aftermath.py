"""The table at rest after a stroke, before the referee touches a ball.

One idea: what positions tell is read off them; without positions, a ball that no event names
lies as before, and zones follow the events that enter and leave them.
"""

from __future__ import annotations

from dataclasses import fields
from typing import TYPE_CHECKING

from engine.game.contacts import frozen_pairs
from engine.game.situation import Rest, Situation, zones_of
from engine.table.furniture import BallId, PinId, ZoneId
from rulelang.events import (
    Event,
    LeftTable,
    PinLeaned,
    PinToppled,
    Pocketed,
    Rebounded,
    Settled,
    ZoneEntered,
    ZoneLeft,
)

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from engine.game.shot import Shot
    from engine.table.furniture import Point, SpotId
    from engine.variant.variant import Variant

NAMES_OF_BALLS = frozenset({"ball", "other", "others", "bodies", "body"})


def fallen(events: Iterable[Event], settled_within: float) -> frozenset[BallId]:
    """Return the balls that a stroke's events took off the bed."""
    down: set[BallId] = set()
    for event in events:
        match event:
            case Pocketed(ball) | LeftTable(ball):
                down.add(BallId(ball))
            case Settled(ball, _, delay) if delay <= settled_within:
                down.add(BallId(ball))
            case Rebounded(ball):
                down.discard(BallId(ball))
            case _:
                pass
    return frozenset(down)


def pins_down(events: Iterable[Event]) -> frozenset[PinId]:
    """Return the pins that a stroke's events made fall, those that lean on a ball too."""
    return frozenset(
        PinId(event.pin) for event in events if isinstance(event, PinToppled | PinLeaned)
    )


def moved(events: Iterable[Event]) -> frozenset[BallId]:
    """Return every ball that an event names."""
    found: set[BallId] = set()
    for event in events:
        for one in fields(event):
            if one.name in NAMES_OF_BALLS:
                value = getattr(event, one.name)
                found.update(value if isinstance(value, tuple) else (value,))
    return frozenset(found)


def rest_after(variant: Variant, before: Situation, shot: Shot, down: frozenset[BallId]) -> Rest:
    """Return what is known of the balls at rest after the shot, `down` being off the bed."""
    events = shot.events or ()
    stirred = moved(events) | down
    told = shot.after
    positions = {**_unmoved(before.rest.positions, stirred), **told.positions}
    positions = {ball: at for ball, at in positions.items() if ball not in down}
    zones = _zones_by_events(before.rest.zones, events, down)
    zones.update({ball: zones_of(variant.world.table, at) for ball, at in positions.items()})
    still = frozenset(pair for pair in before.rest.frozen if not stirred & set(pair))
    kept = frozenset() if told.positions else still
    return Rest(
        positions=positions,
        zones={**zones, **told.zones},
        frozen=told.frozen | kept | frozen_pairs(variant.world, positions),
        covered={**_unmoved_covers(before, stirred), **told.covered},
        fallen=before.rest.fallen | pins_down(events),
    )


def _unmoved(known: Mapping[BallId, Point], stirred: frozenset[BallId]) -> dict[BallId, Point]:
    return {ball: at for ball, at in known.items() if ball not in stirred}


def _unmoved_covers(before: Situation, stirred: frozenset[BallId]) -> dict[SpotId, BallId]:
    covered = before.rest.covered.items()
    return {spot: ball for spot, ball in covered if ball not in stirred}


def _zones_by_events(
    before: Mapping[BallId, frozenset[ZoneId]], events: Iterable[Event], down: frozenset[BallId]
) -> dict[BallId, frozenset[ZoneId]]:
    zones = dict(before)
    for event in events:
        match event:
            case ZoneEntered(ball, zone):
                standing = zones.get(BallId(ball), frozenset())
                zones[BallId(ball)] = standing | {ZoneId(zone)}
            case ZoneLeft(ball, zone):
                standing = zones.get(BallId(ball), frozenset())
                zones[BallId(ball)] = standing - {ZoneId(zone)}
            case _:
                pass
    return {ball: standing for ball, standing in zones.items() if ball not in down}
