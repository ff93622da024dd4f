"""Balls come back to the table: the referee's hands.

One idea: the decided actions are done one after the other on a value of what lies where; a
place that is covered sends the ball to the next place its rule names.
Invariant: no ball is put where another is known to lie.
"""

from __future__ import annotations

from dataclasses import replace
from math import hypot
from typing import TYPE_CHECKING

from engine.game.situation import Rest, Situation
from engine.game.verdict import Spotted
from engine.table.furniture import BallId, SpotId
from engine.table.pin import standing
from engine.table.room import free_place, nearest_place, nearest_room
from engine.variant.rack import lay_rack
from rulelang.decisions import Place, Remove, Rerack, Restore, SetUp, Spot, TableAction
from rulelang.frozen import value

if TYPE_CHECKING:
    from collections.abc import Mapping

    from engine.physics.world import Layout
    from engine.table.furniture import PinId, Point
    from engine.variant.variant import Variant

GAP = 1e-4
"""Room (m) left between a ball put near its spot and its neighbour."""


@value
class Board:
    """What lies where while the referee works, and what he has done so far."""

    rest: Rest
    on_table: frozenset[BallId]
    spotted: tuple[Spotted, ...] = ()
    removed: tuple[BallId, ...] = ()
    reracked: int = 0
    restored: bool = False


def carry_out(
    variant: Variant,
    board: Board,
    actions: tuple[TableAction, ...],
    homes: Mapping[str, str],
    before: Situation,
) -> Board:
    """Return the board after the actions; `before` is the situation to restore."""
    if not actions:
        return board
    lifted = frozenset(
        BallId(one.ball) for one in actions if isinstance(one, Spot) and not _stays(one)
    )
    board = replace(board, rest=lift(board.rest, lifted))
    for action in actions:
        match action:
            case Spot():
                board = _spot(variant, board, action, homes)
            case Remove(ball):
                board = _remove(board, BallId(ball))
            case SetUp(pins):
                board = replace(board, rest=set_up(variant, board.rest, frozenset(pins)))
            case Rerack(keeping):
                board = _rerack(variant, board, frozenset(map(BallId, keeping)), before)
            case Restore():
                board = replace(board, rest=before.rest, on_table=before.on_table, restored=True)
    return board


def lift(rest: Rest, balls: frozenset[BallId]) -> Rest:
    """Return what lies where after `balls` were taken up."""
    return Rest(
        {ball: at for ball, at in rest.positions.items() if ball not in balls},
        {ball: zones for ball, zones in rest.zones.items() if ball not in balls},
        frozenset(pair for pair in rest.frozen if balls.isdisjoint(pair)),
        {spot: ball for spot, ball in rest.covered.items() if ball not in balls},
        rest.fallen,
    )


def place_ball(rest: Rest, ball: BallId, at: Point) -> Rest:
    """Return what lies where after `ball` was put at `at` (m)."""
    lifted = lift(rest, frozenset({ball}))
    return replace(lifted, positions={**lifted.positions, ball: at})


def set_up(variant: Variant, rest: Rest, pins: frozenset[str]) -> Rest:
    """Return what lies where after `pins` were set up; one without air to every ball waits."""
    waiting = _without_air(variant, rest.positions) & pins
    return replace(rest, fallen=(rest.fallen - pins) | (rest.fallen & waiting))


def _without_air(variant: Variant, positions: Mapping[BallId, Point]) -> frozenset[PinId]:
    """Return the pins that cannot stand beside balls at these places (m)."""
    radii = {one.id: one.radius for one in variant.world.balls}
    pins = variant.world.table.pins
    free = standing(pins, positions, radii)
    return frozenset(pin.id for pin, has_air in zip(pins, free, strict=True) if not has_air)


def take_up_positions(variant: Variant, rest: Rest, positions: Mapping[BallId, Point]) -> Rest:
    """Return what is known with `positions` (m) added: what lies there, pins that have no room."""
    if not positions:
        return rest
    fallen = rest.fallen | _without_air(variant, positions)
    return replace(rest, positions=dict(positions), fallen=fallen)


def _spot(variant: Variant, board: Board, action: Spot, homes: Mapping[str, str]) -> Board:
    ball = BallId(action.ball)
    if _stays(action):
        put = Spotted(ball, None, on=False)
        return replace(board, on_table=board.on_table | {ball}, spotted=(*board.spotted, put))
    covering: BallId | None = None
    for place in action.places:
        if place.kind == "later":
            return board
        spot = _spot_of(variant, board, place, ball, covering, homes)
        if spot is None:
            continue
        if place.kind == "near":
            near = _put_near(variant, board, ball, spot, place.toward)
            if near is not None:
                return near
            continue
        covering = coverer(variant, board.rest, spot, ball)
        if covering is None:
            return _put_on(variant, board, ball, spot)
    at = starting_place(variant, board.rest, ball)
    return replace(
        board,
        rest=board.rest if at is None else place_ball(board.rest, ball, at),
        on_table=board.on_table | {ball},
        spotted=(*board.spotted, Spotted(ball, None, on=False)),
    )


def _stays(action: Spot) -> bool:
    """Return whether the ball is put back where it lay."""
    return any(place.kind == "lay" for place in action.places)


def starting_place(variant: Variant, rest: Rest, ball: BallId) -> Point | None:
    """Return where a ball that no rule has a place for is put (m); None where there is no room.

    That is its own spot, its fixed place in the rack, or the middle of the head string, or the
    nearest place to it that has room.
    """
    table = variant.world.table
    own = _own_spot(variant, ball)
    start = table.spots[own] if own else variant.rack.fixed.get(ball, (-table.length / 4, 0.0))
    radii = {one.id: one.radius for one in variant.world.balls}
    others = [(at, radii[other]) for other, at in rest.positions.items() if other != ball]
    at = free_place(table, start, ((-1.0, 0.0), (1.0, 0.0)), radii[ball], others, GAP)
    if at is None and table.outline:
        return nearest_room(table, start, radii[ball], others, GAP)
    return at


def _spot_of(
    variant: Variant,
    board: Board,
    place: Place,
    ball: BallId,
    covering: BallId | None,
    homes: Mapping[str, str],
) -> SpotId | None:
    if place.kind == "highest-free":
        return _highest_free(variant, board, ball)
    if place.kind == "occupant":
        home = homes.get(covering or "") or _own_spot(variant, covering)
        return SpotId(home) if home else None
    named = place.spot or homes.get(ball) or _own_spot(variant, ball)
    return SpotId(named) if named else None


def _own_spot(variant: Variant, ball: BallId | None) -> SpotId | None:
    return next((kind.spot for kind in variant.balls if kind.id == ball), None)


def _highest_free(variant: Variant, board: Board, ball: BallId) -> SpotId | None:
    kinds = sorted(variant.balls, key=lambda kind: -kind.value)
    spots = dict.fromkeys(kind.spot for kind in kinds if kind.spot is not None and kind.value > 0)
    free = (spot for spot in spots if coverer(variant, board.rest, spot, ball) is None)
    return next(free, None)


def coverer(variant: Variant, rest: Rest, spot: SpotId, ball: BallId) -> BallId | None:
    """Return the ball known to lie so that `ball` cannot be put on `spot`, or None."""
    if spot in rest.covered and rest.covered[spot] != ball:
        return rest.covered[spot]
    radius = next(one.radius for one in variant.world.balls if one.id == ball)
    return _in_the_way(variant, rest, spot, radius, ball)


def covers(variant: Variant, rest: Rest) -> dict[str, str]:
    """Return every spot that is taken, by the ball known to stand there or too near to it."""
    owners = {kind.spot: kind.id for kind in variant.balls}
    found: dict[str, str] = {}
    for spot in variant.world.table.spots:
        owner = owners.get(spot)
        radius = next(one.radius for one in variant.world.balls if owner in (None, one.id))
        taken = rest.covered.get(spot) or _in_the_way(variant, rest, spot, radius, owner)
        if taken is not None:
            found[spot] = taken
    return found


def _in_the_way(
    variant: Variant, rest: Rest, spot: SpotId, radius: float, leave_out: BallId | None
) -> BallId | None:
    x, y = variant.world.table.spots[spot]
    radii = {one.id: one.radius for one in variant.world.balls}
    for other, (u, v) in sorted(rest.positions.items()):
        if other != leave_out and hypot(u - x, v - y) <= radii[other] + radius:
            return other
    return None


def _put_on(variant: Variant, board: Board, ball: BallId, spot: SpotId) -> Board:
    at = variant.world.table.spots[spot]
    return replace(
        board,
        rest=place_ball(board.rest, ball, at),
        on_table=board.on_table | {ball},
        spotted=(*board.spotted, Spotted(ball, spot, on=True)),
    )


def _put_near(
    variant: Variant, board: Board, ball: BallId, spot: SpotId, toward: str
) -> Board | None:
    """Return the board with the ball near the spot; None where that way has no room."""
    rest = board.rest
    blocker = coverer(variant, rest, spot, ball)
    if blocker in rest.positions or rest.positions.keys() >= board.on_table - {ball}:
        radii = {one.id: one.radius for one in variant.world.balls}
        others = [(at, radii[other]) for other, at in rest.positions.items() if other != ball]
        way = (1.0, 0.0) if toward == "foot" else (-1.0, 0.0)
        table = variant.world.table
        at = nearest_place(table, table.spots[spot], way, radii[ball], others, GAP)
        if at is None:
            return None
        rest = place_ball(rest, ball, at)
    return replace(
        board,
        rest=rest,
        on_table=board.on_table | {ball},
        spotted=(*board.spotted, Spotted(ball, spot, on=False)),
    )


def _remove(board: Board, ball: BallId) -> Board:
    return replace(
        board,
        rest=lift(board.rest, frozenset({ball})),
        on_table=board.on_table - {ball},
        removed=(*board.removed, ball),
    )


def _rerack(variant: Variant, board: Board, keeping: frozenset[BallId], before: Situation) -> Board:
    racked = _front_left_empty(lay_rack(variant.rack, before.seed + before.shots + 1), keeping)
    rest = lift(board.rest, frozenset(board.rest.positions) - keeping)
    for ball, at in racked.items():
        rest = place_ball(rest, ball, at)
    return replace(
        board,
        rest=rest,
        on_table=frozenset(racked) | (board.on_table & keeping) | frozenset(variant.cue_balls),
        reracked=len(racked),
        spotted=tuple(one for one in board.spotted if one.ball not in racked),
    )


def _front_left_empty(layout: Layout, keeping: frozenset[BallId]) -> Layout:
    """Return the rack without the balls kept: the places nearest to the head stay empty."""
    kept = [ball for ball in layout if ball in keeping]
    front = sorted(layout.values(), key=lambda at: (at[0], -at[1]))[: len(kept)]
    vacant = [layout[ball] for ball in kept if layout[ball] not in front]
    movers = [ball for ball in layout if ball not in keeping and layout[ball] in front]
    staying = {ball: at for ball, at in layout.items() if ball not in keeping}
    return {**staying, **dict(zip(movers, vacant, strict=True))}
