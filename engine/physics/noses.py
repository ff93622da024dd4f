"""A table's noses as rows for the solvers: straight ones, arcs, and the points where one ends.

One idea: a ball meets a nose on the bed's side alone, so what sticks out into the bed, a free end
or a convex corner, becomes a point of its own. Invariant: a row number leads back to its owner.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, hypot, pi, sin
from typing import TYPE_CHECKING

import numpy as np

from engine.physics import state
from engine.table.furniture import Straight

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from engine.table.furniture import Curve, CushionId, PinId, PocketId, Point, Shape, Table


@dataclass(frozen=True, slots=True)
class Owner:
    """What a nose belongs to: a cushion, a pocket's jaw, or a pin."""

    cushion: CushionId | None
    pocket: PocketId | None
    pin: PinId | None = None


def pack_noses(table: Table) -> tuple[NDArray[np.float64], tuple[Owner, ...]]:
    """Return the noses, columns N_*, and whose they are; free ends become points.

    What they are covered with is filled in by `give_rubber`.
    """
    shapes: list[tuple[Shape, Owner]] = []
    for cushion in table.cushions:
        shapes += [(shape, Owner(cushion.id, None)) for shape in cushion.shapes]
    for jaw in table.jaws:
        shapes += [(shape, Owner(None, jaw.pocket)) for shape in jaw.shapes]
    rows = [_pack_shape(shape) for shape, _ in shapes]
    owners = [owner for _, owner in shapes]
    for point, owner in _sharp_ends(shapes):
        if any(_covered(point, p.centre, p.radius) for p in table.pockets):
            continue
        rows.append(_pack_point(point))
        owners.append(owner)
    return widen(rows), tuple(owners)


def widen(rows: list[list[float]]) -> NDArray[np.float64]:
    """Return rows of the nose's shape (N_* before N_E) with room for its numbers."""
    noses = np.zeros((len(rows), state.NOSE_WIDTH))
    noses[:, : state.N_E] = np.array(rows).reshape(len(rows), state.N_E)
    noses[:, state.N_PIN] = -1.0
    return noses


def _covered(point: Point, centre: Point, radius: float) -> bool:
    return hypot(point[0] - centre[0], point[1] - centre[1]) <= radius + 1e-9


def _pack_shape(shape: Shape) -> list[float]:
    if isinstance(shape, Straight):
        (x, y), (ex, ey) = shape.start, shape.end
        size = hypot(ex - x, ey - y)
        box = [min(x, ex), min(y, ey), max(x, ex), max(y, ey)]
        return [0.0, x, y, (ex - x) / size, (ey - y) / size, size, 0.0, *box]
    return pack_curve(shape)


def pack_curve(shape: Curve) -> list[float]:
    """Return an arc as a row of the nose's shape."""
    middle = shape.start + shape.sweep / 2.0
    half = min(abs(shape.sweep) / 2.0, pi)
    size = shape.radius if shape.sweep < 0.0 else -shape.radius
    (x, y), r = shape.centre, shape.radius
    angles = [middle - half, middle + half]
    angles += [k * pi / 2.0 for k in range(-8, 9) if abs(k * pi / 2.0 - middle) <= half]
    xs, ys = [x + r * cos(a) for a in angles], [y + r * sin(a) for a in angles]
    box = [min(xs), min(ys), max(xs), max(ys)]
    return [1.0, x, y, cos(middle), sin(middle), size, cos(half), *box]


def _pack_point(point: Point) -> list[float]:
    x, y = point
    return [1.0, x, y, 1.0, 0.0, 0.0, -1.0, x, y, x, y]


def _sharp_ends(shapes: list[tuple[Shape, Owner]]) -> list[tuple[Point, Owner]]:
    """Return the ends that stick out into the bed: free ends and convex corners."""
    starts = [_start(shape) for shape, _ in shapes]
    ends = [_end(shape) for shape, _ in shapes]
    from_here = {_key(point): way for point, way in starts}
    to_here = {_key(point) for point, _ in ends}
    found = []
    for (_, owner), (start, _), (end, way) in zip(shapes, starts, ends, strict=True):
        onward = from_here.get(_key(end))
        if onward is None or _turns_right(way, onward):
            found.append((end, owner))
        if _key(start) not in to_here:
            found.append((start, owner))
    return found


def _key(point: Point) -> tuple[int, int]:
    """Return the point on a grid so coarse that rounding seldom parts what belongs together.

    Where it does, a tangent joint gets a needless point, which no ball can tell from the joint.
    """
    return round(point[0] * 1e7), round(point[1] * 1e7)


def _turns_right(way: float, onward: float) -> bool:
    return sin(onward - way) < -1e-9


def _start(shape: Shape) -> tuple[Point, float]:
    if isinstance(shape, Straight):
        return shape.start, _way(shape)
    return _on(shape, shape.start)


def _end(shape: Shape) -> tuple[Point, float]:
    if isinstance(shape, Straight):
        return shape.end, _way(shape)
    return _on(shape, shape.start + shape.sweep)


def _way(shape: Straight) -> float:
    return atan2(shape.end[1] - shape.start[1], shape.end[0] - shape.start[0])


def _on(shape: Curve, angle: float) -> tuple[Point, float]:
    x = shape.centre[0] + shape.radius * cos(angle)
    y = shape.centre[1] + shape.radius * sin(angle)
    return (x, y), angle + (pi / 2.0 if shape.sweep > 0.0 else -pi / 2.0)


__all__ = ["Owner", "pack_curve", "pack_noses", "widen"]
