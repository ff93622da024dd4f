"""From the table part of a variant file to the Table: pockets, spots, lines and zones.

One idea: coordinates may name L, W (the bed) and R (the largest ball's radius); they are
filled in here, in the order spots, lines, zones, and each mistake is reported where it stands.
"""

from __future__ import annotations

from dataclasses import replace
from math import hypot
from types import MappingProxyType
from typing import TYPE_CHECKING

from engine.table.furniture import (
    Area,
    Disc,
    Figure,
    HalfPlane,
    Line,
    LineId,
    Opposite,
    Places,
    SpotId,
    ZoneId,
)
from engine.table.region import has_room, obstacles, on_bed, span_at
from engine.variant.outlining import bare_table, bed_size, plain_table, with_bodies
from engine.variant.quantity import QuantityError

if TYPE_CHECKING:
    from collections.abc import Mapping

    from engine.table.furniture import Point, Table, Zone
    from engine.variant.locate import KeyPath
    from engine.variant.quantity import Expression
    from engine.variant.report import Report
    from engine.variant.table_spec import LineShape, Place, RoundShape, TableShape, ZoneShape

_EDGE = 1e-9
_LONGEST_CHAIN = 40


class Surveyor:
    """Places things on one table; `names` are the lengths that coordinates may use."""

    def __init__(self, spec: TableShape, radius: float, report: Report) -> None:
        self.spec = spec
        self.report = report
        size = bed_size(spec, report)
        self.names = {"L": size[0], "W": size[1], "R": radius}
        self.open: set[str] = set()
        self.done: dict[str, Point | None] = {}
        bare = bare_table(spec, size, radius, report)
        self.sound = bare is not None
        bare = bare or plain_table(spec, size)
        self.bed = self.valued(
            with_bodies(bare, self.bodies("posts"), self.bodies("holes"), spec.posts, report)
        )

    def bodies(self, key: str) -> dict[str, tuple[Point, float]]:
        """Return the posts or the holes: names, centres and radii (m)."""
        found = {}
        shapes: dict[str, RoundShape] = getattr(self.spec, key)
        for name, shape in shapes.items():
            at = self.point(shape.at, ("table", key, name, "at"))
            if at is not None:
                found[name] = at, shape.radius
        return found

    def valued(self, table: Table) -> Table:
        """Return the table with what a ball in each hole counts, and what it meets there."""
        pockets = (
            replace(
                pocket,
                value=hole.value,
                lip=hole.lip,
                rim=hole.rim,
                restitution=hole.restitution,
                friction=hole.friction,
                model=hole.model,
            )
            if (hole := self.spec.holes.get(pocket.id)) is not None
            else pocket
            for pocket in table.pockets
        )
        return replace(table, pockets=tuple(pockets))

    def number(self, expression: Expression | None, path: KeyPath) -> float | None:
        """Return a coordinate in metres; None, and a mistake, where it cannot be had."""
        if expression is None:
            return 0.0
        try:
            return expression.value(self.names)
        except QuantityError as error:
            self.report.add("V104", path, str(error), error.mend)
            return None

    def point(self, place: Place, path: KeyPath) -> Point | None:
        """Return where a place is, or None after a mistake."""
        start: Point | None = (0.0, 0.0)
        if place.spot is not None:
            start = self.spot(place.spot, (*path, "spot"))
        x = self.number(place.x, (*path, "x"))
        y = self.number(place.y, (*path, "y"))
        dx = self.number(place.dx, (*path, "dx"))
        dy = self.number(place.dy, (*path, "dy"))
        if start is None or x is None or y is None or dx is None or dy is None:
            return None
        return start[0] + x + dx, start[1] + y + dy

    def spot(self, name: str, path: KeyPath) -> Point | None:
        """Return the place of a named spot."""
        if name not in self.spec.spots:
            self.report.unknown("V301", path, "spot", name, self.spec.spots)
            return None
        if name in self.done:
            return self.done[name]
        if name in self.open:
            message = f"spot `{name}` is placed by itself"
            self.report.add("V202", path, message, "give one of them coordinates")
            return None
        if len(self.open) >= _LONGEST_CHAIN:
            message = f"more than {_LONGEST_CHAIN} spots lean on each other in a row"
            self.report.add("V202", path, message, "give one of them coordinates")
            return None
        self.open.add(name)
        self.done[name] = self.point(self.spec.spots[name], ("table", "spots", name))
        self.open.discard(name)
        return self.done[name]

    def on_bed(self, point: Point, margin: float = 0.0) -> bool:
        """Tell whether a point lies on the bed, `margin` away from the noses at least."""
        if margin > 0.0:
            return has_room(self.bed, point, margin)
        return self.within_noses(point) and all(
            hypot(point[0] - at[0], point[1] - at[1]) > reach
            for at, reach in obstacles(self.bed, 0.0)
        )

    def within_noses(self, point: Point) -> bool:
        """Tell whether a point lies on the bed, whatever stands or gapes there."""
        return on_bed(self.bed, point, _EDGE)

    def spots(self) -> dict[SpotId, Point]:
        """Return all spots; one that cannot be placed is reported and stands in the middle."""
        found = {}
        for name in self.spec.spots:
            path: KeyPath = ("table", "spots", name)
            point = self.spot(name, path)
            if point is not None and not self.on_bed(point):
                half = f"x within {self.bed.length / 2:g} m, y within {self.bed.width / 2:g} m"
                if self.within_noses(point):
                    half = "clear of posts and holes"
                elif self.bed.outline:
                    half = "move it inside the outline"
                self.report.add("V401", path, f"spot `{name}` is not on the bed", half)
            found[SpotId(name)] = point or (0.0, 0.0)
        return found

    def lines(self) -> dict[LineId, Line]:
        """Return all lines; one that cannot be drawn is reported, and only its name is right."""
        found = {}
        for name, shape in self.spec.lines.items():
            line = self.line(shape, ("table", "lines", name))
            found[LineId(name)] = line or Line((0.0, 0.0), (0.0, 1.0))
        return found

    def line(self, shape: LineShape, path: KeyPath) -> Line | None:
        """Return one line; x runs across the bed, y along it."""
        forms = (shape.x is not None, shape.y is not None, shape.start is not None)
        if sum(forms) != 1 or (shape.start is None) != (shape.end is None):
            mend = 'write x = "-L/4", or y = 0, or start and end'
            self.report.add("V110", path, "a line has one of x, y, or start and end", mend)
            return None
        if shape.start is not None and shape.end is not None:
            start = self.point(shape.start, (*path, "start"))
            end = self.point(shape.end, (*path, "end"))
        elif shape.x is not None:
            start, end = self.across(0, self.number(shape.x, (*path, "x")))
        else:
            start, end = self.across(1, self.number(shape.y, (*path, "y")))
        if start is None or end is None:
            return None
        if start == end or not (self.within_noses(start) and self.within_noses(end)):
            self.report.add(
                "V404",
                path,
                "the line has no length or leaves the bed",
                "keep x within L/2 and y within W/2 of the centre",
            )
            return None
        return Line(start, end, shape.drawn)

    def across(self, axis: int, value: float | None) -> tuple[Point | None, Point | None]:
        """Return the ends of a line across the bed (axis 0) or along it (axis 1)."""
        if value is None:
            return None, None
        low, high = span_at(self.bed, axis, value) or (0.0, 0.0)
        return ((value, low), (value, high)) if axis == 0 else ((low, value), (high, value))

    def zones(self, lines: Mapping[LineId, Line]) -> dict[ZoneId, Zone]:
        """Return all zones; one that cannot be drawn is reported, and only its name is right."""
        found: dict[ZoneId, Zone] = {}
        for name, shape in self.spec.zones.items():
            path: KeyPath = ("table", "zones", name)
            zone = self.zone(shape, path, lines)
            if isinstance(zone, Area) and zone.parts and not self.holds_a_place(zone):
                self.report.add(
                    "V408",
                    path,
                    f"zone `{name}` holds no place on the bed",
                    "drop one of its bounds, or turn one round",
                )
            found[ZoneId(name)] = zone or Area()
        return found | self.opposites(found)

    def opposites(self, zones: Mapping[ZoneId, Zone]) -> dict[ZoneId, Zone]:
        """Return the zones that are whichever of several areas holds no ball on."""
        found: dict[ZoneId, Zone] = {}
        for name, shape in self.spec.zones.items():
            areas = []
            for index, other in enumerate(shape.opposite or ()):
                path: KeyPath = ("table", "zones", name, "opposite", index)
                zone = zones.get(ZoneId(other))
                if zone is None:
                    self.report.unknown("V308", path, "zone", other, self.spec.zones)
                elif isinstance(zone, Area) and not self.spec.zones[other].opposite:
                    areas.append(zone)
                else:
                    mend = "name zones with `behind`, `beyond`, `left_of`, `right_of` or `disc`"
                    self.report.add("V110", path, f"zone `{other}` is no area", mend)
            if shape.opposite:
                found[ZoneId(name)] = Opposite(tuple(areas))
        return found

    def zone(self, shape: ZoneShape, path: KeyPath, lines: Mapping[LineId, Line]) -> Zone | None:
        """Return one zone."""
        sides = shape.behind or shape.beyond or shape.left_of or shape.right_of
        area = bool(sides or shape.disc is not None)
        single = (shape.bed, shape.places, shape.figure, shape.opposite)
        if area + sum(kind is not None for kind in single) != 1:
            mend = 'write bed = true, or behind = "a-line", or places = ["a-spot"]'
            self.report.add("V110", path, "a zone is the bed, an area, or places", mend)
            return None
        if shape.opposite is not None:
            return None
        if shape.figure is not None:
            corners = self.corners(shape.figure.corners, (*path, "figure", "corners"))
            return Figure(corners, shape.figure.margin, shape.with_line) if corners else None
        if shape.places is not None:
            return self.single_places(shape.places, path)
        halves = self.half_planes(shape, path, lines)
        if shape.disc is None:
            return Area(tuple(halves))
        centre = self.point(shape.disc.centre, (*path, "disc", "centre"))
        if centre is None:
            return None
        return Area((*halves, Disc(centre, shape.disc.radius, shape.with_line)))

    def corners(self, written: list[Place], path: KeyPath) -> tuple[Point, ...] | None:
        """Return the corners of a figure, counter-clockwise; None, and a mistake, where bent in."""
        points = [self.point(place, (*path, index)) for index, place in enumerate(written)]
        found = [point for point in points if point is not None]
        if len(found) < len(points):
            return None
        turns = [
            (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
            for a, b, c in zip(found, found[1:] + found[:1], found[2:] + found[:2], strict=True)
        ]
        if len(found) >= 3 and min(turns) > 0.0:
            return tuple(found)
        if len(found) >= 3 and max(turns) < 0.0:
            return tuple(reversed(found))
        mend = "name them in order round the figure"
        self.report.add("V110", path, "a figure has three corners or more and no dent", mend)
        return None

    def single_places(self, written: list[Place], path: KeyPath) -> Places:
        """Return a zone of single points."""
        points = []
        for index, place in enumerate(written):
            point = self.point(place, (*path, "places", index))
            if point is not None:
                points.append(point)
                if not self.on_bed(point):
                    self.report.add("V401", (*path, "places", index), "not on the bed")
        return Places(tuple(points))

    def half_planes(
        self, shape: ZoneShape, path: KeyPath, lines: Mapping[LineId, Line]
    ) -> list[HalfPlane]:
        """Return the sides of lines that bound a zone."""
        found = []
        for key, way in _WAYS.items():
            for index, name in enumerate(getattr(shape, key)):
                where: KeyPath = (*path, key, index)
                if name not in self.spec.lines:
                    self.report.unknown("V303", where, "line", name, self.spec.lines)
                elif LineId(name) in lines:
                    half = _half_plane(lines[LineId(name)], way, closed=shape.with_line)
                    if half is None:
                        mend = "left_of and right_of go with lines along, the others across"
                        self.report.add("V110", where, f"line `{name}` has no such side", mend)
                    else:
                        found.append(half)
        return found

    def holds_a_place(self, zone: Area) -> bool:
        """Tell, on a grid of the bed and at the discs' centres, whether a zone is not empty."""
        steps = 40
        grid = [
            (self.bed.length * (i / steps - 0.5), self.bed.width * (j / steps - 0.5))
            for i in range(steps + 1)
            for j in range(steps + 1)
        ]
        for part in zone.parts:
            if isinstance(part, Disc):
                reach = part.radius / 2
                ways = ((0, 0), (1, 0), (-1, 0), (0, 1), (0, -1))
                grid += [(part.centre[0] + reach * a, part.centre[1] + reach * b) for a, b in ways]
        return any(self.within_noses(point) and _inside(zone, point) for point in grid)


_WAYS = MappingProxyType(
    {
        "behind": (-1.0, 0.0),
        "beyond": (1.0, 0.0),
        "left_of": (0.0, 1.0),
        "right_of": (0.0, -1.0),
    }
)


def _half_plane(line: Line, way: Point, *, closed: bool) -> HalfPlane | None:
    """Return the side of a line that lies in direction `way`; None where neither does."""
    dx, dy = line.end[0] - line.start[0], line.end[1] - line.start[1]
    size = hypot(dx, dy)
    normal = -dy / size, dx / size
    along = normal[0] * way[0] + normal[1] * way[1]
    if abs(along) < 1e-9:
        return None
    sign = 1.0 if along > 0 else -1.0
    return HalfPlane(line.start, (normal[0] * sign + 0.0, normal[1] * sign + 0.0), closed)


def _inside(zone: Area, point: Point) -> bool:
    for part in zone.parts:
        if isinstance(part, Disc):
            if hypot(point[0] - part.centre[0], point[1] - part.centre[1]) > part.radius:
                return False
        else:
            away = point[0] - part.point[0], point[1] - part.point[1]
            if away[0] * part.normal[0] + away[1] * part.normal[1] < 0:
                return False
    return True


def furnish(surveyor: Surveyor) -> Table | None:
    """Return the table with its marks; None, and a mistake, where it cannot be built."""
    spots, lines = surveyor.spots(), surveyor.lines()
    zones = surveyor.zones(lines)
    if not surveyor.sound:
        return None
    return replace(
        surveyor.bed,
        spots=MappingProxyType(spots),
        lines=MappingProxyType(lines),
        zones=MappingProxyType(zones),
    )
