"""What positions tell of balls at rest: who touches whom, and who lies in which zone.

One idea: it is read off the positions when somebody asks, and of one thing asked about no more is
worked out. Closer than a fixed small distance is touching. What was told beside positions is kept.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from collections.abc import Set as AbstractSet
from itertools import combinations
from math import hypot
from typing import TYPE_CHECKING, TypeVar, cast

from engine.game.situation import TOUCHING, Pair, Rest
from engine.table.furniture import BallId, ZoneId
from engine.table.marks import contains
from engine.table.region import distance_to, nose_reach

if TYPE_CHECKING:
    from collections.abc import Iterator

    from engine.physics.world import World
    from engine.table.furniture import Cushion, CushionId, Point, Table

K = TypeVar("K")
V = TypeVar("V")


class Later(Mapping[K, V]):
    """A mapping that is made when it is first read."""

    __slots__ = ("_made", "_make")

    def __init__(self, make: Callable[[], Mapping[K, V]]) -> None:
        self._make = make
        self._made: Mapping[K, V] | None = None

    def _all(self) -> Mapping[K, V]:
        if self._made is None:
            self._made = self._make()
        return self._made

    def __getitem__(self, key: K) -> V:
        return self._all()[key]

    def __iter__(self) -> Iterator[K]:
        return iter(self._all())

    def __len__(self) -> int:
        return len(self._all())


class ZonesAt(AbstractSet[ZoneId]):
    """The zones of a table that hold a point (m)."""

    __slots__ = ("_known", "_point", "_table")

    def __init__(self, table: Table, point: Point) -> None:
        self._table = table
        self._point = point
        self._known: dict[object, bool] = {}

    @classmethod
    def _from_iterable(cls, found: Iterator[ZoneId]) -> frozenset[ZoneId]:  # type: ignore[override]
        return frozenset(found)

    def __contains__(self, zone: object) -> bool:
        if zone not in self._known:
            area = self._table.zones.get(zone)  # type: ignore[call-overload]
            self._known[zone] = area is not None and contains(area, self._point, self._table)
        return self._known[zone]

    def __iter__(self) -> Iterator[ZoneId]:
        return (zone for zone in self._table.zones if zone in self)

    def __len__(self) -> int:
        return sum(1 for _ in self)


class Contacts(AbstractSet[Pair]):
    """Every contact of balls at rest: those told, and those that positions (m) show.

    Two balls stand in the order of the world.
    """

    __slots__ = ("_all", "_bodies", "_positions", "_told", "_world")

    def __init__(
        self, world: World, positions: Mapping[BallId, Point], told: AbstractSet[Pair] = frozenset()
    ) -> None:
        self._world = world
        self._positions = positions
        self._told = told
        self._all: frozenset[Pair] | None = None
        self._bodies: dict[str, tuple[int, float]] = {}

    @classmethod
    def _from_iterable(cls, found: Iterator[Pair]) -> frozenset[Pair]:  # type: ignore[override]
        return frozenset(found)

    def _found(self) -> frozenset[Pair]:
        if self._all is None:
            self._all = frozenset((*self._told, *_shown(self._world, self._positions)))
        return self._all

    def __contains__(self, pair: object) -> bool:
        if pair in self._told:
            return True
        if self._all is not None:
            return pair in self._all
        one, other = cast("tuple[BallId, BallId]", pair)
        place = self._positions.get(one)
        if place is None:
            return False
        if other in self._positions:
            return self._touch(one, other)
        return any(
            as_cushion(cushion.id) == other
            and _meets(self._world, cushion, self._body(one)[1], place)
            for cushion in self._world.table.cushions
        )

    def _touch(self, one: BallId, other: BallId) -> bool:
        """Tell whether two balls touch, `one` standing before the other in the world."""
        (x, y), (u, v) = self._positions[one], self._positions[other]
        (rank, radius), (later, size) = self._body(one), self._body(other)
        return rank < later and hypot(x - u, y - v) <= radius + size + TOUCHING

    def _body(self, ball: BallId) -> tuple[int, float]:
        """Return which ball of the world it is, and its radius (m)."""
        if not self._bodies:
            self._bodies = {b.id: (rank, b.radius) for rank, b in enumerate(self._world.balls)}
        return self._bodies[ball]

    def __iter__(self) -> Iterator[Pair]:
        return iter(self._found())

    def __len__(self) -> int:
        return len(self._found())

    def __bool__(self) -> bool:
        return bool(self._told or self._positions)


def contacts_of(world: World, rest: Rest) -> AbstractSet[Pair]:
    """Return who touches whom: what was told, and what positions show."""
    return Contacts(world, rest.positions, rest.frozen) if rest.positions else rest.frozen


def zones_by_ball(table: Table, rest: Rest) -> Mapping[BallId, AbstractSet[ZoneId]]:
    """Return the zones that balls stand in: by their places where those are known, else as told."""
    told, at = rest.zones, rest.positions
    return (
        Later(lambda: {**told, **{ball: ZonesAt(table, at[ball]) for ball in at}}) if at else told
    )


def _shown(world: World, positions: Mapping[BallId, Point]) -> Iterator[Pair]:
    yield from _balls(world, positions)
    yield from _cushions(world, positions)


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
        for cushion in world.table.cushions:
            if _meets(world, cushion, ball.radius, place):
                yield ball.id, as_cushion(cushion.id)


def _meets(world: World, cushion: Cushion, radius: float, place: Point) -> bool:
    """Tell whether a ball of `radius` (m) at a place touches a nose of a cushion."""
    nosed = radius if cushion.upright else nose_reach(radius, world.table.nose_height)
    reach = nosed + TOUCHING
    return any(distance_to(nose, place) <= reach for nose in cushion.shapes)


def as_cushion(cushion: CushionId | str) -> str:
    """Return a cushion's name as one half of a contact."""
    return f"cushion {cushion}"
