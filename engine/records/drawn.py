"""Contacts with a cushion as a hand draws them: a ball whose edge is at the nose, seen from above.

One idea: a ball that touches a nose stands a little under it, R cos(theta) away and not R, which
is one or two millimetres that nobody who writes a record by hand works out or means as a gap.
Invariant: only a record without a stroke is read so; what was played lies where it was measured.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from engine.game.contacts import as_cushion
from engine.table.region import distance_to

if TYPE_CHECKING:
    from collections.abc import Mapping

    from engine.game.situation import Pair
    from engine.physics.world import World
    from engine.table.furniture import BallId, Point

ON_LINE = 1e-4
"""A centre so near (m) to a line is on the line, as everywhere in a record."""


def drawn_contacts(world: World, positions: Mapping[BallId, Point]) -> frozenset[Pair]:
    """Return which balls lie against which cushions, none further from a nose than R + 0.1 mm."""
    radii = {ball.id: ball.radius for ball in world.balls}
    return frozenset(
        (str(ball), as_cushion(cushion.id))
        for ball, at in positions.items()
        if ball in radii
        for cushion in world.table.cushions
        if any(distance_to(nose, at) <= radii[ball] + ON_LINE for nose in cushion.shapes)
    )


__all__ = ["drawn_contacts"]
