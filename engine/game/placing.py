"""Where a ball in hand may be put.

One idea: a place is lawful in its zone, on the bed and clear of every other ball; the usual
place is the lawful one nearest to the middle of the zone's edge towards the foot.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import hypot
from typing import TYPE_CHECKING

from engine.game.match import start_match
from engine.game.referee import look_ahead
from engine.game.shot import Refusal
from engine.game.sight import View, has_full_path
from engine.game.situation import Situation, cue_ball_of
from engine.table.furniture import Area, BallId, Opposite, Places
from engine.table.marks import contains
from engine.table.region import has_room

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from engine.table.furniture import Point, Table, Zone, ZoneId
    from engine.variant.variant import Variant

GRID = 160
CLEAR = 1e-6
TRIED = 200


def refuse_place(variant: Variant, situation: Situation, at: Point) -> Refusal | None:
    """Return why the ball in hand cannot be put at `at` (m), None where it can."""
    zone = situation.in_hand
    if zone is None:
        return Refusal("the cue ball is not in hand", "play it from where it lies")
    table = variant.world.table
    ball = cue_ball_of(variant, situation.shooter)
    refused = refuse_spot(variant, situation.rest.positions, ball, at)
    if refused is not None:
        return refused
    if not contains(zone_in_hand(variant, situation, zone), at, table):
        return Refusal(f"that is outside {zone}", f"the ball is in hand in {zone}")
    return None


def refuse_spot(
    variant: Variant, lying: Mapping[BallId, Point], ball: BallId, at: Point, clear: float = CLEAR
) -> Refusal | None:
    """Return why a ball cannot lie at `at` (m) among those `lying`, None where it can.

    `clear` (m) is the air it needs to the others; a little below none, it may touch them.
    """
    radii = {one.id: one.radius for one in variant.world.balls}
    for other, (x, y) in lying.items():
        if other != ball and hypot(at[0] - x, at[1] - y) < radii[ball] + radii[other] + clear:
            return Refusal(f"there is no room beside {other}", "move it clear of the other balls")
    if not has_room(variant.world.table, at, radii[ball]):
        return Refusal("the ball does not lie on the bed", "move it away from the cushion")
    return None


def zone_in_hand(variant: Variant, situation: Situation, zone: ZoneId) -> Zone:
    """Return where the ball in hand may be put: the zone, or that of several that is open.

    Where a ball on stands between them, the whole bed is.
    """
    table = variant.world.table
    whole = table.zones[zone]
    if not isinstance(whole, Opposite):
        return whole
    lying = situation.rest.positions
    on = [lying[BallId(ball)] for ball in look_ahead(variant, situation).on if ball in lying]
    free = [area for area in whole.areas if not any(contains(area, at, table) for at in on)]
    return free[0] if len(free) == 1 else Area()


def usual_place(variant: Variant, situation: Situation) -> Point | None:
    """Return a lawful place (m) for the ball in hand, near the middle and towards the foot.

    The first of them from which a ball on can be hit full is taken, where there is one.
    """
    if situation.in_hand is None:
        return None
    table = variant.world.table
    zone = zone_in_hand(variant, situation, situation.in_hand)
    places = _ordered(_Bed(table), situation.in_hand, zone)
    on = frozenset(map(BallId, look_ahead(variant, situation).on))
    ball = cue_ball_of(variant, situation.shooter)
    radii = {one.id: one.radius for one in variant.world.balls}
    lawful = [
        at
        for at in places[:: max(1, len(places) // TRIED)]
        if refuse_place(variant, situation, at) is None
    ]
    for at in lawful:
        if has_full_path(View(at, radii[ball], situation.rest.positions, radii), on):
            return at
    free = (at for at in places if refuse_place(variant, situation, at) is None)
    return next(iter(lawful), None) or next(free, None)


@dataclass(frozen=True, slots=True, eq=False)
class _Bed:
    """A table as a key: one and the same table, since comparing two takes longer than looking."""

    table: Table

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Bed) and self.table is other.table

    def __hash__(self) -> int:
        return hash(id(self.table))


@lru_cache(maxsize=64)
def _ordered(bed: _Bed, name: ZoneId, zone: Zone) -> tuple[Point, ...]:
    """Return the places (m) of a zone, the usual ones first."""
    inside = (at for at in _places(bed.table, name) if contains(zone, at, bed.table))
    return tuple(sorted(inside, key=lambda at: (round(abs(at[1]), 6), -at[0])))


def prepare_places(variant: Variant) -> None:
    """Work out the usual places of every zone beforehand, so that none is waited for."""
    table = variant.world.table
    for name, zone in table.zones.items():
        for area in zone.areas if isinstance(zone, Opposite) else (zone,):
            _ordered(_Bed(table), name, area)


def _places(table: Table, zone: ZoneId) -> Iterator[Point]:
    area = table.zones[zone]
    if isinstance(area, Places):
        yield from area.points
        return
    for i in range(GRID + 1):
        for j in range(GRID // 2 + 1):
            yield (
                table.length * (i / GRID - 0.5),
                table.width * (j / (GRID // 2) - 0.5),
            )


def opening_layout(variant: Variant, seed: int = 0) -> dict[BallId, Point]:
    """Return where balls lie (m) when a game opens, the ball in hand at its usual place."""
    situation = start_match(variant, seed=seed).situation
    layout = dict(situation.rest.positions)
    place = usual_place(variant, situation)
    if place is not None:
        layout[cue_ball_of(variant, situation.shooter)] = place
    return layout
