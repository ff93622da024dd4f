"""Who touches whom at rest: balls, and balls and cushions, read off positions.

One idea: closer than a fixed small distance is frozen. Contacts that were declared are kept.
"""

from __future__ import annotations

from itertools import combinations
from math import hypot, sqrt
from typing import TYPE_CHECKING

from engine.game.situation import TOUCHING, Pair
from engine.table.region import distance_to

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from engine.physics.world import World
    from engine.table.furniture import BallId, CushionId, Point


def frozen_pairs(world: World, positions: Mapping[BallId, Point]) -> frozenset[Pair]:
    """Return every contact that the positions (m) show, balls in the order of the world."""
    return frozenset((*_balls(world, positions), *_cushions(world, positions)))


def _balls(world: World, positions: Mapping[BallId, Point]) -> Iterator[Pair]:
    lying = [ball for ball in world.balls if ball.id in positions]
    for one, other in combinations(lying, 2):
        (x, y), (u, v) = positions[one.id], positions[other.id]
        if hypot(x - u, y - v) <= one.radius + other.radius + TOUCHING:
            yield one.id, other.id


def _cushions(world: World, positions: Mapping[BallId, Point]) -> Iterator[Pair]:
    for ball in world.balls:
        place = positions.get(ball.id)
        if place is None:
            continue
        reach = nose_reach(ball.radius, world.table.nose_height) + TOUCHING
        for cushion in world.table.cushions:
            if any(distance_to(nose, place) <= reach for nose in cushion.shapes):
                yield ball.id, as_cushion(cushion.id)


def as_cushion(cushion: CushionId | str) -> str:
    """Return a cushion's name as one half of a contact."""
    return f"cushion {cushion}"


def nose_reach(radius: float, nose_height: float) -> float:
    """Return how far (m) over the bed a ball's centre is from a nose that it touches."""
    return sqrt(max(radius**2 - (nose_height - radius) ** 2, 0.0))
