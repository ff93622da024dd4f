"""How balls lie at the start of a game: rows and places from the file, and their drawing by lot.

One idea: a rack is worked out once, at load, into places and lots; a seed alone then decides
which ball lies where, the same on every machine.
Source of the geometry: touching rows along +x are sqrt(3) R apart (the close packing of discs).
"""

from __future__ import annotations

from itertools import combinations
from math import hypot, sqrt
from random import Random
from types import MappingProxyType
from typing import TYPE_CHECKING

from engine.table.furniture import BallId
from engine.variant.ballset import group_members, pick, place_of
from engine.variant.report import nearest
from engine.variant.variant import Lot, Rack

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from engine.physics.world import Ball, Layout
    from engine.table.furniture import Point
    from engine.variant.furnish import Surveyor
    from engine.variant.locate import KeyPath
    from engine.variant.report import Report
    from engine.variant.spec import BallShape, Pattern, RackShape

_TOUCH = 1e-6
_ANY, _NONE = "*", "-"


def lay_rack(rack: Rack, seed: int) -> Layout:
    """Return where every ball of the rack lies; the seed alone decides all that is by lot.

    Only Random.random is drawn from, whose sequence Python promises to keep.
    """
    chance = Random(seed)
    layout = dict(rack.fixed)
    for lot in rack.drawn:
        balls = []
        for pool in lot.pools:
            left = [ball for ball in pool if ball not in layout and ball not in balls]
            balls.append(left[int(chance.random() * len(left))])
        _shuffle(balls, chance)
        layout.update(zip(balls, lot.places, strict=True))
    return layout


def _shuffle(balls: list[BallId], chance: Random) -> None:
    for last in range(len(balls) - 1, 0, -1):
        other = int(chance.random() * (last + 1))
        balls[last], balls[other] = balls[other], balls[last]


class _Racker:
    """Works one rack out; mistakes go to the report."""

    def __init__(
        self, balls: Mapping[str, BallShape], bodies: Sequence[Ball], surveyor: Surveyor
    ) -> None:
        self.balls = balls
        self.radius = {body.id: body.radius for body in bodies}
        self.surveyor = surveyor
        self.report: Report = surveyor.report
        self.fixed: dict[BallId, Point] = {}
        self.drawn: list[Lot] = []
        self.where: dict[BallId, KeyPath] = {}

    def put(self, name: str, point: Point | None, path: KeyPath) -> None:
        ball = BallId(name)
        if name not in self.balls:
            known = self.balls
            self.report.unknown("V302", path, "ball", name, known)
        elif ball in self.where:
            message = f"ball `{name}` has a place already"
            self.report.add("V305", path, message, "name it once in the rack", on_key=True)
        elif point is not None:
            self.fixed[ball] = point
            self.where[ball] = path

    def places(self, rack: RackShape) -> None:
        for name, place in rack.places.items():
            path: KeyPath = ("rack", "places", name)
            self.put(name, self.surveyor.point(place, path), path)
        path = ("rack", "own_spots")
        for name in pick(rack.own_spots, self.balls, path, self.report):
            spot = self.balls[name].spot
            if spot is None:
                mend = f"give it one in the set: spot of ball `{name}`"
                self.report.add("V301", path, f"ball `{name}` has no spot of its own", mend)
            else:
                self.put(name, self.surveyor.done.get(spot), path)

    def pattern(self, pattern: Pattern) -> None:
        path: KeyPath = ("rack", "pattern")
        found = len(self.report.diagnostics)
        apex = self.surveyor.point(pattern.apex, (*path, "apex"))
        taken = pick(pattern.balls, self.balls, (*path, "balls"), self.report)
        radius = max((self.radius[BallId(name)] for name in taken), default=0.0)
        if apex is None or not taken:
            return
        cells = self.cells(pattern, apex, radius, path)
        self.lots(pattern, cells, path)
        if len(self.report.diagnostics) == found:
            free = [point for word, point, _ in cells if word == _ANY]
            self.rest(pattern, free, taken, path)

    def cells(
        self, pattern: Pattern, apex: Point, radius: float, path: KeyPath
    ) -> list[tuple[str, Point, KeyPath]]:
        """Return each word of the rows with its place; balls named there are put down."""
        found: list[tuple[str, Point, KeyPath]] = []
        side = 2 * radius + pattern.gap
        for row, text in enumerate(pattern.rows):
            words = text.split()
            x = apex[0] + (row + 1 - pattern.apex_row) * side * sqrt(3) / 2
            for column, word in enumerate(words):
                y = apex[1] + ((len(words) - 1) / 2 - column) * side
                where: KeyPath = (*path, "rows", row)
                found.append((word, (x, y), where))
                if word not in (_ANY, _NONE) and word not in pattern.lots:
                    self.named(word, (x, y), where, pattern)
        return found

    def named(self, word: str, point: Point, where: KeyPath, pattern: Pattern) -> None:
        if word in self.balls:
            self.put(word, point, where)
            return
        mend = nearest(word, [*self.balls, *pattern.lots]) + " `*` is any ball, `-` none"
        self.report.add("V302", where, f"there is no ball or lot called `{word}`", mend.strip())

    def lots(
        self, pattern: Pattern, cells: list[tuple[str, Point, KeyPath]], path: KeyPath
    ) -> None:
        groups = group_members(self.balls)
        for name, written in pattern.lots.items():
            where: KeyPath = (*path, "lots", name)
            if name in self.balls:
                self.report.add(
                    "V304", where, f"`{name}` is also a ball", "name the lot anew", on_key=True
                )
            points = [point for word, point, _ in cells if word == name]
            if not points and self.inherited(where, (*path, "rows")):
                continue
            if len(points) != len(written):
                message = f"lot `{name}` has {len(points)} places in the rows, {len(written)} balls"
                self.report.add("V407", where, message, "name one ball or group for each place")
                continue
            pools = []
            for index, one in enumerate(written):
                members = groups.get(one) or pick([one], self.balls, (*where, index), self.report)
                pools.append(tuple(BallId(ball) for ball in members))
            if all(self.enough(pool, pools) for pool in pools):
                self.drawn.append(Lot(tuple(points), tuple(pools)))
            elif all(pools):
                self.report.add(
                    "V407",
                    where,
                    f"lot `{name}` has too few balls to draw from",
                    "name more balls or groups",
                )

    def inherited(self, lot: KeyPath, rows: KeyPath) -> bool:
        """Tell whether a lot comes from a file that these rows do not belong to."""
        root = self.report.root
        return root.find(lot)[0].source is not root.find(rows)[0].source

    def enough(self, pool: tuple[BallId, ...], pools: list[tuple[BallId, ...]]) -> bool:
        """Tell whether a pool cannot run dry before its turn."""
        loose = sum(ball not in self.fixed for ball in pool)
        rivals = sum(bool(set(pool) & set(other)) for other in pools)
        earlier = sum(bool(set(pool) & set(other)) for lot in self.drawn for other in lot.pools)
        return loose >= rivals + earlier

    def rest(self, pattern: Pattern, free: list[Point], taken: list[str], path: KeyPath) -> None:
        """Fill the places marked `*` with what is left of the pattern's balls."""
        left = [BallId(name) for name in taken if BallId(name) not in self.fixed]
        drawn = sum(bool(set(left) & set(pool)) for lot in self.drawn for pool in lot.pools)
        if len(left) - drawn != len(free):
            message = f"the rows have {len(free)} places `*` for {len(left) - drawn} balls"
            mend = "add or take away a `*`, or name fewer balls"
            self.report.add("V407", (*path, "rows"), message, mend)
        elif not pattern.by_lot and not drawn:
            for ball, point in zip(left, free, strict=True):
                self.put(ball, point, (*path, "rows"))
        elif free:
            self.drawn.append(Lot(tuple(free), tuple(tuple(left) for _ in free)))

    def check(self) -> None:
        """Report balls that lie off the bed or in one another."""
        largest = max(self.radius.values(), default=0.0)
        rows: KeyPath = ("rack", "pattern", "apex")
        places = [
            (f"ball `{ball}`", point, self.radius[ball], self.where[ball])
            for ball, point in self.fixed.items()
        ]
        places += [
            (f"the place at ({point[0]:.4f}, {point[1]:.4f})", point, largest, rows)
            for lot in self.drawn
            for point in lot.places
        ]
        told: set[KeyPath] = set()
        for what, point, radius, path in places:
            if not self.surveyor.on_bed(point, radius - _TOUCH) and path not in told:
                told.add(path)
                self.report.add(
                    "V403",
                    path,
                    f"{what} does not lie wholly on the bed",
                    "move it towards the middle",
                )
        for first, second in combinations(places, 2):
            gap = hypot(first[1][0] - second[1][0], first[1][1] - second[1][1])
            if gap < first[2] + second[2] - _TOUCH and second[3] not in told:
                told.add(second[3])
                lap = 1000 * (first[2] + second[2] - gap)
                message = f"{second[0]} overlaps {first[0]} by {lap:.2f} mm"
                self.report.add("V402", second[3], message, "move one of them")


def build_rack(
    rack: RackShape,
    balls: Mapping[str, BallShape],
    bodies: Sequence[Ball],
    surveyor: Surveyor,
) -> Rack:
    """Return the rack with all its places in metres; mistakes go to the surveyor's report."""
    racker = _Racker(balls, bodies, surveyor)
    racker.places(rack)
    if rack.pattern is not None:
        racker.pattern(rack.pattern)
    racker.check()
    return Rack(MappingProxyType(racker.fixed), tuple(racker.drawn))


def check_own_spots(balls: Mapping[str, BallShape], surveyor: Surveyor) -> None:
    """Report balls whose own spot is not on the table."""
    told: set[KeyPath] = set()
    for name, shape in balls.items():
        path = place_of(name, surveyor.report, "spot")
        if shape.spot is not None and shape.spot not in surveyor.spec.spots and path not in told:
            told.add(path)
            known = surveyor.spec.spots
            surveyor.report.unknown("V301", path, "spot", shape.spot, known)
