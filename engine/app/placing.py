"""Where a ball in hand may be put, and the nearest such place to a wish.

One idea: every place is tested by the zone's own rule; for a wish that is not allowed the
nearest of many allowed places is taken. Invariant: a place returned lies in the zone, on the
bed, and touches no ball.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, hypot, pi, sin
from typing import TYPE_CHECKING

import numpy as np

from engine.game.placing import refuse_place, usual_place, zone_in_hand
from engine.game.situation import cue_ball_of
from engine.table.furniture import Area, HalfPlane, Places
from engine.table.region import nose_reach, obstacles

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

    from engine.game.situation import Situation
    from engine.table.furniture import BallId, Point, Zone
    from engine.variant.variant import Variant

    Points = NDArray[np.float64]

CLEAR = 2e-4
"""A ball is put down with at least this much room (m) to the others."""
INSIDE = 1e-6
"""How deep (m) in a zone a place lies that needs no further look."""
STEP = 0.03
ROUND = 72


@dataclass(frozen=True, slots=True, eq=False)
class Placing:
    """The ball in hand: its zone, what is in its way, and many places (n, 2) that are free."""

    variant: Variant
    situation: Situation
    zone: Zone
    radius: float
    others: Points
    reaches: NDArray[np.float64]
    free: Points

    def allows(self, point: Point) -> bool:
        """Whether the ball may be put down at `point` (m)."""
        return refuse_place(self.variant, self.situation, point) is None

    def nearest(self, wish: Point) -> Point:
        """Return `wish` where it is allowed, else the nearest place known to be free."""
        table = self.variant.world.table
        edge = nose_reach(self.radius, table.nose_height) + INSIDE
        half = table.length / 2.0 - edge, table.width / 2.0 - edge
        wish = (
            round(min(max(wish[0], -half[0]), half[0]), 6),
            round(min(max(wish[1], -half[1]), half[1]), 6),
        )
        if self.allows(wish) or not len(self.free):
            return wish
        near = np.concatenate([self.free, self._about(wish)])
        order = np.argsort(((near - np.array(wish)) ** 2).sum(axis=1))
        for i in order[:4000]:
            point = round(float(near[i][0]), 6), round(float(near[i][1]), 6)
            if self.allows(point):
                return point
        return wish

    def _about(self, wish: Point) -> Points:
        """Return places close to a wish: on the zone's border, and against the balls there."""
        turns = np.arange(ROUND) * (2.0 * pi / ROUND)
        circle = np.stack([np.cos(turns), np.sin(turns)], axis=1)
        rings = [
            centre + circle * (reach + CLEAR)
            for centre, reach in zip(self.others, self.reaches, strict=True)
            if hypot(*(centre - wish)) < 2.0 * reach
        ]
        return np.concatenate([*rings, _border(self.zone, wish), np.zeros((0, 2))])


def placing_of(variant: Variant, situation: Situation) -> Placing | None:
    """Return how the ball in hand may be placed; None where no ball is in hand."""
    if situation.in_hand is None:
        return None
    ball = cue_ball_of(variant, situation.shooter)
    radii = {one.id: one.radius for one in variant.world.balls}
    lying: Mapping[BallId, Point] = situation.rest.positions
    others = [name for name in lying if name != ball]
    places = np.array([lying[name] for name in others], dtype=np.float64).reshape(-1, 2)
    reaches = np.array([radii[name] + radii[ball] for name in others])
    zone = zone_in_hand(variant, situation, situation.in_hand)
    bare = Placing(variant, situation, zone, radii[ball], places, reaches, np.zeros((0, 2)))
    wishes = np.array(zone.points) if isinstance(zone, Places) else _grid(variant, radii[ball])
    if isinstance(zone, Area):
        wishes = _within(zone, wishes)
    if len(places) and not isinstance(zone, Places):
        gaps = np.hypot(*(wishes[:, None, :] - places[None, :, :]).transpose(2, 0, 1)) - reaches
        wishes = wishes[gaps.min(axis=1) > CLEAR]
    table = variant.world.table
    if not isinstance(zone, Area) or table.outline or obstacles(table, radii[ball]):
        wishes = np.array([p for p in map(tuple, wishes.tolist()) if bare.allows(p)])
    known = wishes.astype(np.float64).reshape(-1, 2)
    return Placing(variant, situation, zone, radii[ball], places, reaches, known)


def _within(zone: Area, points: Points) -> Points:
    """Return the points that lie well inside a zone."""
    for part in zone.parts:
        if isinstance(part, HalfPlane):
            depth = (points - np.array(part.point)) @ (np.array(part.normal) / hypot(*part.normal))
        else:
            depth = part.radius - np.hypot(*(points - np.array(part.centre)).T)
        points = points[depth > INSIDE]
    return points


def _grid(variant: Variant, radius: float) -> Points:
    table = variant.world.table
    half = table.length / 2.0 - radius - CLEAR, table.width / 2.0 - radius - CLEAR
    xs = np.linspace(-half[0], half[0], max(3, round(2.0 * half[0] / STEP)))
    ys = np.linspace(-half[1], half[1], max(3, round(2.0 * half[1] / STEP) | 1))
    return np.stack(np.meshgrid(xs, ys), axis=-1).reshape(-1, 2)


def _border(zone: Zone, wish: Point) -> Points:
    """Return points on the zone's borders nearest to a wish, just inside."""
    found: list[Point] = []
    inset = CLEAR
    for part in zone.parts if isinstance(zone, Area) else ():
        if isinstance(part, HalfPlane):
            size = hypot(*part.normal)
            nx, ny = part.normal[0] / size, part.normal[1] / size
            depth = (wish[0] - part.point[0]) * nx + (wish[1] - part.point[1]) * ny
            for along in np.linspace(-0.2, 0.2, 81):
                off = inset - depth
                found.append((wish[0] + nx * off - ny * along, wish[1] + ny * off + nx * along))
        else:
            for k in range(4 * ROUND):
                turn = 2.0 * pi * k / (4 * ROUND)
                reach = part.radius - inset
                found.append(
                    (part.centre[0] + reach * cos(turn), part.centre[1] + reach * sin(turn))
                )
    return np.array(found, dtype=np.float64).reshape(-1, 2)


def first_place(placing: Placing) -> Point:
    """Return where the ball is shown first: the usual place, from which a ball on can be hit."""
    usual = usual_place(placing.variant, placing.situation)
    return placing.nearest(usual or (0.0, 0.0))
