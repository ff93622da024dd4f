"""Judging places: what lies in a zone and what passes a line.

One idea: a ball is where its centre is, and a centre within `ON` of a line is on the line; every
question is answered from the exact roots of a distance along the ball's way.
Invariant: pure functions of plain numbers; nothing here knows whose ball it is.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import hypot, inf, sqrt
from typing import TYPE_CHECKING

from engine.geometry.vectors import distance, dot
from engine.table.furniture import Disc, Figure, HalfPlane, Line, Opposite, Places, Straight
from engine.table.region import ends, on_bed

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from engine.table.furniture import Point, Table, Zone

ON = 1e-4
"""How near (m) a centre is to a line to be on it."""

_ROUND = 1e-12
Polynomial = tuple[float, ...]
"""Coefficients, the constant first."""


@dataclass(frozen=True, slots=True)
class Piece:
    """A way r0 + v0 s + a s^2 / 2 for 0 <= s <= `duration`, from time `begin` on (m, s)."""

    begin: float
    duration: float
    position: Point
    velocity: Point
    acceleration: Point = (0.0, 0.0)

    def at(self, s: float) -> Point:
        """Return where the centre is, `s` seconds after `begin`."""
        (x, y), (u, v), (a, b) = self.position, self.velocity, self.acceleration
        return x + s * (u + s * a / 2), y + s * (v + s * b / 2)


@dataclass(frozen=True, slots=True)
class Crossing:
    """A line passed at `time`; `to` is the side reached, +1 left of the line's way, else -1."""

    time: float
    to: int


@dataclass(frozen=True, slots=True)
class ZoneChange:
    """A zone entered or left at `time`."""

    time: float
    entered: bool


def contains(zone: Zone, point: Point, table: Table) -> bool:
    """Tell whether a ball whose centre is at `point` (m) is in `zone` of `table`.

    A centre on the border belongs to the zone where the border is `closed`. A ball that hangs
    in the mouth of a pocket is still on the bed.
    """
    if isinstance(zone, Places):
        return any(distance(point, place) <= ON for place in zone.points)
    if isinstance(zone, Opposite):
        return any(contains(area, point, table) for area in zone.areas)
    if isinstance(zone, Figure):
        depth = zone.margin - _from_figure(zone.corners, point)
        return _on_bed(point, table) and depth + _border(closed=zone.closed) > 0.0
    return _on_bed(point, table) and all(_depth(part, point) > 0.0 for part in zone.parts)


def away_from(zone: Zone, point: Point) -> float:
    """Return how far (m) a point is from a zone, 0 inside; of several bounds the farthest."""
    if isinstance(zone, Places):
        return min(distance(point, place) for place in zone.points)
    if isinstance(zone, Figure):
        return max(0.0, _from_figure(zone.corners, point) - zone.margin)
    if isinstance(zone, Opposite):
        return min(away_from(area, point) for area in zone.areas)
    return max([0.0, *(_border(closed=part.closed) - _depth(part, point) for part in zone.parts)])


def _depth(part: HalfPlane | Disc, point: Point) -> float:
    """Return how deep a point lies in a part, counted from where belonging begins."""
    if isinstance(part, Disc):
        depth = part.radius - distance(point, part.centre)
    else:
        depth = dot(part.normal, (point[0] - part.point[0], point[1] - part.point[1]))
        depth /= hypot(*part.normal)
    return depth + _border(closed=part.closed)


def _from_figure(corners: Sequence[Point], point: Point) -> float:
    """Return how far (m) a point is from a convex figure; inside, less than 0 by its depth."""
    far, near = -inf, inf
    for start, end in zip(corners, (*corners[1:], corners[0]), strict=True):
        side = end[0] - start[0], end[1] - start[1]
        away = point[0] - start[0], point[1] - start[1]
        far = max(far, dot(_normal(Line(end, start)), away))
        along = min(max(dot(side, away) / dot(side, side), 0.0), 1.0)
        foot = start[0] + along * side[0], start[1] + along * side[1]
        near = min(near, distance(point, foot))
    return far if far <= 0.0 else near


def _border(*, closed: bool) -> float:
    return ON + _ROUND if closed else -ON - _ROUND


def _on_bed(point: Point, table: Table) -> bool:
    if on_bed(table, point, ON):
        return True
    for pocket in table.pockets:
        (ax, ay), (bx, by) = pocket.mouth
        middle = (ax + bx) / 2, (ay + by) / 2
        if distance(point, middle) <= distance(*pocket.mouth) / 2:
            return True
    return False


def side(line: Line, point: Point) -> int:
    """Return +1 left of the way from the line's start to its end, -1 right of it, 0 on it."""
    distance = _from_line(line, point)
    if abs(distance) <= ON + _ROUND:
        return 0
    return 1 if distance > 0 else -1


def _from_line(line: Line, point: Point) -> float:
    normal = _normal(line)
    return dot(normal, (point[0] - line.start[0], point[1] - line.start[1]))


def _normal(line: Line) -> Point:
    dx, dy = line.end[0] - line.start[0], line.end[1] - line.start[1]
    size = hypot(dx, dy)
    return -dy / size, dx / size


def crossings(line: Line, pieces: Iterable[Piece]) -> tuple[Crossing, ...]:
    """Return each time a centre passes from one side of `line` to the other.

    `pieces` follow one another. Coming onto the line and going back is no crossing, nor is
    setting out from it. A crossing is timed where the centre meets the line itself, and counts
    only between the line's ends.
    """
    found: list[Crossing] = []
    last = 0
    met: tuple[float, Point] | None = None
    for piece in pieces:
        across = _distance_along(_normal(line), line.start, piece)
        for low, high in pairwise(_cuts(piece, (across,), (0.0, ON, -ON))):
            if met is None or abs(_value(across, low)) < _ROUND:
                met = piece.begin + low, piece.at(low)
            now = side(line, piece.at((low + high) / 2))
            if now != 0 and last not in (0, now) and _within(line, met[1]):
                found.append(Crossing(met[0], now))
            last = now or last
    return tuple(found)


def _within(line: Line, point: Point) -> bool:
    way = line.end[0] - line.start[0], line.end[1] - line.start[1]
    along = dot(way, (point[0] - line.start[0], point[1] - line.start[1])) / hypot(*way)
    return -ON <= along <= hypot(*way) + ON


def zone_changes(zone: Zone, pieces: Iterable[Piece], table: Table) -> tuple[ZoneChange, ...]:
    """Return each time a centre comes into or goes out of `zone`; `pieces` follow one another."""
    found: list[ZoneChange] = []
    inside: bool | None = None
    for piece in pieces:
        borders = _borders(zone, piece, table)
        for low, high in pairwise(_cuts(piece, borders, (0.0,))):
            now = contains(zone, piece.at((low + high) / 2), table)
            if inside is None:
                inside = contains(zone, piece.at(low), table)
            if now != inside:
                found.append(ZoneChange(piece.begin + low, now))
                inside = now
    return tuple(found)


def _borders(zone: Zone, piece: Piece, table: Table) -> tuple[Polynomial, ...]:
    """Return polynomials in s that are zero wherever the answer of `contains` can change."""
    if isinstance(zone, Places):
        return tuple(_from_centre(place, ON, piece) for place in zone.points)
    if isinstance(zone, Opposite):
        return tuple(border for area in zone.areas for border in _borders(area, piece, table))
    borders = _outline_borders(table, piece) or [
        _shifted(_distance_along(normal, (0.0, 0.0), piece), -half - ON)
        for normal, half in (
            ((1.0, 0.0), table.length / 2),
            ((-1.0, 0.0), table.length / 2),
            ((0.0, 1.0), table.width / 2),
            ((0.0, -1.0), table.width / 2),
        )
    ]
    for pocket in table.pockets:
        (ax, ay), (bx, by) = pocket.mouth
        middle = (ax + bx) / 2, (ay + by) / 2
        borders.append(_from_centre(middle, distance(*pocket.mouth) / 2, piece))
    if isinstance(zone, Figure):
        return (*borders, *_figure_borders(zone, piece))
    for part in zone.parts:
        border = _border(closed=part.closed)
        if isinstance(part, Disc):
            borders.append(_from_centre(part.centre, part.radius + border, piece))
        else:
            size = hypot(*part.normal)
            normal = part.normal[0] / size, part.normal[1] / size
            borders.append(_shifted(_distance_along(normal, part.point, piece), border))
    return tuple(borders)


def _figure_borders(zone: Figure, piece: Piece) -> Iterator[Polynomial]:
    """Yield the borders of a figure with its margin: beside its sides, round its corners."""
    reach = zone.margin + _border(closed=zone.closed)
    for start, end in zip(zone.corners, (*zone.corners[1:], zone.corners[0]), strict=True):
        yield _from_centre(start, reach, piece)
        yield _shifted(_distance_along(_normal(Line(start, end)), start, piece), reach)


def _outline_borders(table: Table, piece: Piece) -> list[Polynomial]:
    """Return the borders of a bed with an outline: `ON` outside of every nose and its ends."""
    borders: list[Polynomial] = []
    for shape in table.outline:
        start, end = ends(shape)
        borders.append(_from_centre(start, ON, piece))
        if isinstance(shape, Straight):
            border = _distance_along(_normal(Line(start, end)), start, piece)
            borders.append(_shifted(border, ON))
        else:
            radius = shape.radius + (ON if shape.sweep > 0.0 else -ON)
            borders.append(_from_centre(shape.centre, radius, piece))
    return borders


def _distance_along(normal: Point, origin: Point, piece: Piece) -> Polynomial:
    away = piece.position[0] - origin[0], piece.position[1] - origin[1]
    return (
        dot(normal, away),
        dot(normal, piece.velocity),
        dot(normal, piece.acceleration) / 2,
    )


def _from_centre(centre: Point, radius: float, piece: Piece) -> Polynomial:
    """Return |r(s) - centre|^2 - radius^2, a quartic."""
    px, py = piece.position[0] - centre[0], piece.position[1] - centre[1]
    (u, v), (a, b) = piece.velocity, piece.acceleration
    return (
        px * px + py * py - radius * radius,
        2 * (px * u + py * v),
        u * u + v * v + px * a + py * b,
        u * a + v * b,
        (a * a + b * b) / 4,
    )


def _cuts(piece: Piece, borders: Sequence[Polynomial], levels: Sequence[float]) -> list[float]:
    """Return the ends of a piece and every time a border polynomial takes one of the levels."""
    times = {0.0, piece.duration}
    for border in borders:
        for level in levels:
            times.update(_roots(_shifted(border, -level), piece.duration))
    return sorted(times)


def _shifted(polynomial: Polynomial, by: float) -> Polynomial:
    return (polynomial[0] + by, *polynomial[1:])


def _value(polynomial: Polynomial, s: float) -> float:
    total = 0.0
    for coefficient in reversed(polynomial):
        total = total * s + coefficient
    return total


def _roots(polynomial: Polynomial, end: float) -> list[float]:
    """Return the roots in [0, end]: closed forms to degree two, beyond by isolation."""
    while len(polynomial) > 1 and polynomial[-1] == 0.0:
        polynomial = polynomial[:-1]
    reach = 0.0
    for coefficient in reversed(polynomial[1:]):
        reach = (reach + abs(coefficient)) * end
    if len(polynomial) <= 1 or reach < abs(polynomial[0]):
        return []
    if len(polynomial) == 2:
        roots = [-polynomial[0] / polynomial[1]]
    elif len(polynomial) == 3:
        roots = _quadratic(*polynomial)
    else:
        return _isolated(polynomial, end)
    return [root for root in roots if 0.0 <= root <= end]


def _quadratic(c: float, b: float, a: float) -> list[float]:
    """Return the real roots of a s^2 + b s + c, without cancellation."""
    inside = b * b - 4 * a * c
    if inside < 0.0:
        return []
    q = -(b + (sqrt(inside) if b >= 0 else -sqrt(inside))) / 2
    return [q / a] if q == 0.0 else [q / a, c / q]


def _isolated(polynomial: Polynomial, end: float) -> list[float]:
    """Return sign changes in [0, end], bracketed by the derivative's roots and bisected."""
    slope = tuple(index * one for index, one in enumerate(polynomial))[1:]
    marks = [0.0, *sorted(_roots(slope, end)), end]
    found = []
    for low, high in pairwise(marks):
        if (_value(polynomial, low) < 0.0) != (_value(polynomial, high) < 0.0):
            found.append(_bisected(polynomial, low, high))
    return found


def _bisected(polynomial: Polynomial, low: float, high: float) -> float:
    rising = _value(polynomial, low) < 0.0
    for _ in range(80):
        middle = (low + high) / 2
        if (_value(polynomial, middle) < 0.0) == rising:
            low = middle
        else:
            high = middle
    return high
