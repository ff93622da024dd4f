"""What positions tell and a script may ask for: what hides a ball, and clear paths.

One idea: a predicate is a function of the balls asked about; where a position that it needs is
not known it answers None, and the referee's stated fact or the game's default stands.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import hypot
from typing import TYPE_CHECKING

from engine.game.noses import lies_in_a_mouth, noses_of
from engine.game.sight import View, path_to, snookering_balls
from engine.game.situation import Rest, Situation, ball_to_strike
from engine.game.spotting import Board, carry_out
from engine.table.furniture import BallId, Places, ZoneId
from engine.table.marks import away_from, contains
from engine.table.region import nose_reach
from rulelang.events import LeftTable, Pocketed, Settled, StrokeOmitted

if TYPE_CHECKING:
    from collections.abc import Mapping

    from engine.game.shot import Shot
    from engine.table.furniture import Point, Table
    from engine.variant.variant import Value, Variant
    from rulelang.decisions import TableAction

Predicate = Callable[..., "Value | None"]
STEPS = 12
"""A zone is looked at from a grid of this many places each way."""


def predicates_of(
    variant: Variant, before: Situation, shot: Shot, after: Rest
) -> Mapping[str, Predicate]:
    """Return the predicates of one shot by the names that scripts use."""

    def path(
        targets: frozenset[str], _done: tuple[TableAction, ...], _zone: str | None = None
    ) -> Value | None:
        struck = shot.struck or ball_to_strike(variant, before)
        origin = shot.placement or before.rest.positions.get(struck)
        view = _view(variant, before.rest, before.on_table, struck, origin)
        return None if view is None else path_to(view, map(BallId, targets))

    def snookering(
        targets: frozenset[str], done: tuple[TableAction, ...], zone: str | None = None
    ) -> Value | None:
        if not (done or after.positions):
            return None
        struck = shot.struck or ball_to_strike(variant, before)
        board = carry_out(variant, Board(after, frozenset(after.positions)), done, {}, before)
        first: tuple[BallId, ...] = ()
        for view in _views(variant, board, struck, zone if _off(before, shot, struck) else None):
            hiding = snookering_balls(view, map(BallId, targets))
            if not hiding:
                return None
            first = first or hiding
        return _one_of(first, shot.call.ball) if first else None

    def nearest(
        targets: frozenset[str], done: tuple[TableAction, ...], zone: str | None = None
    ) -> Value | None:
        board = carry_out(variant, Board(after, frozenset(after.positions)), done, {}, before)
        return _nearest(variant, board.rest.positions, targets, zone)

    return {"path": path, "snookering-ball": snookering, "nearest": nearest}


def _off(before: Situation, shot: Shot, ball: BallId) -> bool:
    """Return whether the ball is in hand or off the bed, and not merely at an unknown place."""
    events = shot.events or ()
    if before.in_hand and any(isinstance(one, StrokeOmitted) for one in events):
        return True
    return ball not in before.on_table or any(
        isinstance(one, Pocketed | Settled | LeftTable) and one.ball == ball for one in events
    )


def _nearest(
    variant: Variant, lying: Mapping[BallId, Point], targets: frozenset[str], zone: str | None
) -> Value | None:
    """Return which of the balls lies nearest to a zone; of two as near the last in the variant."""
    area = None if zone is None else variant.world.table.zones[ZoneId(zone)]
    if area is None or not lying.keys() >= targets or not targets:
        return None
    order = [kind.id for kind in reversed(variant.balls) if kind.id in targets]
    return min(order, key=lambda ball: round(away_from(area, lying[ball]), 9))


def _one_of(hiding: tuple[BallId, ...], called: str | None) -> BallId:
    """Return the ball that snookers; where no one ball does it, one that was not called."""
    return next((ball for ball in hiding if ball != called), hiding[0])


def _view(
    variant: Variant, rest: Rest, on_table: frozenset[BallId], ball: BallId, origin: Point | None
) -> View | None:
    if origin is None or not rest.positions.keys() >= on_table - {ball}:
        return None
    radii = {one.id: one.radius for one in variant.world.balls}
    others = {other: at for other, at in rest.positions.items() if other != ball}
    table, touch = variant.world.table, nose_reach(radii[ball], variant.world.table.nose_height)
    hidden = any(lies_in_a_mouth(table, at, touch) for at in (origin, *others.values()))
    return View(origin, radii[ball], others, radii, noses_of(table) if hidden else (), touch)


def _views(variant: Variant, board: Board, ball: BallId, zone: str | None) -> Iterator[View]:
    """Yield what the cue ball sees from where it lies, or from places it may be put at."""
    lies = board.rest.positions.get(ball)
    for origin in _origins(variant, board, ball, zone) if lies is None else [lies]:
        view = _view(variant, board.rest, board.on_table, ball, origin)
        if view is not None:
            yield view


def _origins(variant: Variant, board: Board, ball: BallId, zone: str | None) -> Iterator[Point]:
    """Yield the free places of the zone that a ball off the table is played from."""
    table = variant.world.table
    if zone is None or not board.rest.positions:
        return
    area = table.zones[ZoneId(zone)]
    radii = {one.id: one.radius for one in variant.world.balls}
    for x, y in area.points if isinstance(area, Places) else _grid(table):
        if contains(area, (x, y), table) and all(
            hypot(x - u, y - v) > radii[ball] + radii[other]
            for other, (u, v) in board.rest.positions.items()
        ):
            yield x, y


def _grid(table: Table) -> Iterator[Point]:
    for i in range(-STEPS * 4, STEPS * 4 + 1):
        for j in range(-STEPS, STEPS + 1):
            yield i * table.length / (8 * STEPS + 1), j * table.width / (2 * STEPS + 1)
