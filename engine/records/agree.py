"""What a record tells twice must agree: positions with zones, contacts and taken spots.

One idea: positions are measured; a word about a ball that is more than a millimetre away from what
its position tells is a mistake of the record.
"""

from __future__ import annotations

from math import hypot
from typing import TYPE_CHECKING

from engine.records.compare import WITHIN
from engine.table.furniture import Opposite, Places
from engine.table.marks import away_from
from engine.table.region import distance_to

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    from engine.game.situation import Pair
    from engine.physics.world import World
    from engine.table.furniture import BallId, Point, SpotId, ZoneId


def strange_zones(
    world: World, positions: Mapping[BallId, Point], zones: Mapping[BallId, Iterable[ZoneId]]
) -> Iterator[tuple[BallId, str]]:
    """Yield each ball that is said to stand in a zone that its position (m) is not in."""
    for ball, named in zones.items():
        for name in named:
            zone = world.table.zones.get(name)
            if ball not in positions or zone is None or isinstance(zone, Places | Opposite):
                continue
            if away_from(zone, positions[ball]) > WITHIN:
                yield ball, f"{ball} does not stand in {name}, by its position"


def strange_contacts(
    world: World, positions: Mapping[BallId, Point], pairs: Iterable[Pair]
) -> Iterator[str]:
    """Yield each contact of things that lie apart by their positions (m), seen from above."""
    for one, other in sorted(pairs):
        gap = _gap(world, positions, one, other)
        if gap is not None and gap > WITHIN:
            yield f"{one} and {other} are {gap * 1000:.0f} mm apart, by their positions"


def strange_covers(
    world: World, positions: Mapping[BallId, Point], covered: Mapping[SpotId, BallId]
) -> Iterator[tuple[SpotId, str]]:
    """Yield each spot that is said to be taken by a ball that leaves room there (m)."""
    radii = {ball.id: ball.radius for ball in world.balls}
    widest = max(radii.values())
    for spot, ball in covered.items():
        at = world.table.spots.get(spot)
        if at is None or ball not in positions:
            continue
        x, y = positions[ball]
        if hypot(x - at[0], y - at[1]) > radii[ball] + widest + WITHIN:
            yield spot, f"{ball} does not cover {spot}, by its position"


def _gap(world: World, positions: Mapping[BallId, Point], one: str, other: str) -> float | None:
    """Return how far (m) two things lie apart; None where that is not known."""
    places = {str(ball): at for ball, at in positions.items()}
    radii = {str(ball.id): ball.radius for ball in world.balls}
    if one not in places:
        return None
    if other in places:
        (x, y), (u, v) = places[one], places[other]
        return hypot(x - u, y - v) - radii[one] - radii[other]
    noses = [
        nose
        for cushion in world.table.cushions
        if other == f"cushion {cushion.id}"
        for nose in cushion.shapes
    ]
    return min((distance_to(nose, places[one]) - radii[one] for nose in noses), default=None)
