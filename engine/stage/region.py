"""The bed of any outline as convex polygons, and the outline as stations with ways backwards.

One idea: a station is a point of the nose line with the way that leads from it away from the bed,
one metre behind both of its noses; rails and cushions are laid from station to station.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin
from typing import TYPE_CHECKING, TypeGuard

from engine.stage import plan
from engine.table.furniture import Curve
from engine.table.mouth import length_of, point_along
from engine.table.region import ends

if TYPE_CHECKING:
    from collections.abc import Sequence

    from engine.table.furniture import Point, Shape

TURN = 0.12
"""The longest step along a curve, rad."""
LONGEST = 0.22
"""The longest length of wood in one piece, m, so that flat shading shows the lamps."""

SMALL = 0.2
"""A round nose of less than this radius (m) has wood of one corner behind it."""


@dataclass(frozen=True, slots=True)
class Station:
    """A point of the nose line, and the way backwards from `root`.

    `root` is the point itself, save on a round nose so small that all ways meet behind it: there
    it is the corner that was rounded, from `depth` (m) on.
    """

    point: Point
    root: Point
    way: Point
    depth: float = 0.0

    def behind(self, distance: float) -> Point:
        """Return the point `distance` (m) behind the nose."""
        if distance < self.depth:
            share = distance / self.depth
            x, y = self.behind(self.depth)
            px, py = self.point
            return px + share * (x - px), py + share * (y - py)
        return self.root[0] + distance * self.way[0], self.root[1] + distance * self.way[1]


def stations(
    chain: Sequence[Shape], *, closed: bool = True, longest: float = LONGEST
) -> list[Station]:
    """Return the stations of a chain in its order; of a closed one the first is not repeated."""
    found: list[Station] = []
    for index, shape in enumerate(chain):
        before = chain[index - 1] if closed or index else None
        if _is_small(shape):
            found += _round_nose(shape)
            continue
        if before is None or not _is_small(before):
            first = ends(shape)[0]
            after = _normal(shape, 0.0)
            one = _normal(before, length_of(before)) if before else after
            found.append(Station(first, first, _mitre(one, after)))
        for share in _steps(shape, longest):
            point, way = point_along(shape, share * length_of(shape))
            found.append(Station(point, point, (way[1], -way[0])))
    if not closed and not _is_small(chain[-1]):
        last = ends(chain[-1])[1]
        found.append(Station(last, last, _normal(chain[-1], length_of(chain[-1]))))
    return found


def _is_small(shape: Shape) -> TypeGuard[Curve]:
    return isinstance(shape, Curve) and shape.sweep < 0.0 and shape.radius < SMALL


def _steps(shape: Shape, longest: float) -> list[float]:
    turns = abs(shape.sweep) / TURN if isinstance(shape, Curve) else 0.0
    count = max(1, int(max(turns, length_of(shape) / longest) + 0.999))
    return [k / count for k in range(1, count)]


def _round_nose(shape: Curve) -> list[Station]:
    """Return the stations of a small round nose, all with the way of the corner behind it."""
    half = abs(shape.sweep) / 2.0
    middle = shape.start + shape.sweep / 2.0
    toward = cos(middle), sin(middle)
    reach = shape.radius / cos(half)
    corner = shape.centre[0] + reach * toward[0], shape.centre[1] + reach * toward[1]
    way = -toward[0] / cos(half), -toward[1] / cos(half)
    count = max(2, int(abs(shape.sweep) / 0.25 + 0.999))
    places = [point_along(shape, length_of(shape) * k / count)[0] for k in range(count + 1)]
    return [Station(place, corner, way, shape.radius) for place in places]


def _normal(shape: Shape, distance: float) -> Point:
    way = point_along(shape, distance)[1]
    return way[1], -way[0]


def _mitre(one: Point, two: Point) -> Point:
    share = max(1.0 + one[0] * two[0] + one[1] * two[1], 0.2)
    return (one[0] + two[0]) / share, (one[1] + two[1]) / share


def convex_pieces(polygon: plan.Polygon) -> list[plan.Polygon]:
    """Return convex polygons that fill a simple counter-clockwise one: ears, then merged."""
    pieces = _ears(polygon)
    merged = True
    while merged:
        merged = False
        for i, one in enumerate(pieces):
            for j in range(i + 1, len(pieces)):
                joined = _joined(one, pieces[j])
                if joined:
                    pieces[i] = joined
                    del pieces[j]
                    merged = True
                    break
            if merged:
                break
    return pieces


def _ears(polygon: plan.Polygon) -> list[plan.Polygon]:
    if _is_convex(polygon):
        return [polygon]
    rest, found = list(polygon), []
    while len(rest) > 3:
        for i in range(len(rest)):
            a, b, c = rest[i - 1], rest[i], rest[(i + 1) % len(rest)]
            if _cross(a, b, c) > 1e-12 and not any(
                _within(p, a, b, c) for p in rest if p not in (a, b, c)
            ):
                found.append([a, b, c])
                del rest[i]
                break
        else:
            del rest[min(range(len(rest)), key=lambda k: abs(_bend(rest, k)))]
    return [*found, rest]


def _joined(one: plan.Polygon, two: plan.Polygon) -> plan.Polygon | None:
    """Return two convex polygons that share an edge as one, None where it is not convex."""
    for i, a in enumerate(one):
        b = one[(i + 1) % len(one)]
        if a in two and b in two and two[(two.index(b) + 1) % len(two)] == a:
            k = two.index(a)
            inner = [two[(k + n) % len(two)] for n in range(1, len(two) - 1)]
            joined = [*one[: i + 1], *inner, *one[i + 1 :]]
            return joined if _is_convex(joined) else None
    return None


def _is_convex(polygon: plan.Polygon) -> bool:
    return all(_bend(polygon, k) >= -1e-12 for k in range(len(polygon)))


def _bend(polygon: plan.Polygon, k: int) -> float:
    return _cross(polygon[k - 1], polygon[k], polygon[(k + 1) % len(polygon)])


def _cross(a: Point, b: Point, c: Point) -> float:
    return (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])


def _within(p: Point, a: Point, b: Point, c: Point) -> bool:
    return _cross(a, b, p) >= -1e-12 and _cross(b, c, p) >= -1e-12 and _cross(c, a, p) >= -1e-12


def clip(polygon: plan.Polygon, by: plan.Polygon) -> plan.Polygon:
    """Return what two convex counter-clockwise polygons have in common; empty if nothing."""
    for a, b in zip(by, (*by[1:], by[0]), strict=True):
        if not polygon:
            return []
        polygon = plan.cut(polygon, a, (b[1] - a[1], a[0] - b[0]))
    return polygon


def tidy(polygon: plan.Polygon) -> plan.Polygon:
    """Return a polygon without corners that lie on one another; empty if no area is left."""
    kept = [
        p
        for k, p in enumerate(polygon)
        if max(abs(p[0] - polygon[k - 1][0]), abs(p[1] - polygon[k - 1][1])) > 1e-6
    ]
    return kept if len(kept) > 2 and plan.area(kept) > 1e-9 else []
