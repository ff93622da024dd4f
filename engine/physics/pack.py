"""From a world and a layout to the solvers' arrays.

One idea: names become row numbers here and nowhere else, and what stays from shot to shot is
packed once. Invariant: rows follow the order of `World.balls`, and a nose's row number leads back
to the cushion or the pocket it belongs to.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, hypot, isfinite, pi, sin, sqrt
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np

from engine.physics import state
from engine.table.furniture import Straight

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

    from engine.physics.world import Ball, Layout, World
    from engine.table.furniture import BallId, Curve, CushionId, PocketId, Point, Shape, Table

MOTIONS = {"slide-roll": state.SLIDE_ROLL, "two-speed": state.TWO_SPEED}
BALL_BALLS = {"elastic": state.ELASTIC, "frictional": state.FRICTIONAL}
CUSHIONS = {
    "restitution": state.RESTITUTION,
    "han-2005": state.HAN,
    "mathavan-2010": state.MATHAVAN,
}
STRIKES = ("point",)
POCKETS = ("drop-edge",)
FLIGHTS = ("ballistic", "none")
OVERLAP = 1e-4


@dataclass(frozen=True, slots=True)
class Owner:
    """What a nose belongs to: a cushion, or a pocket's jaw."""

    cushion: CushionId | None
    pocket: PocketId | None


@dataclass(frozen=True, slots=True, eq=False)
class Packed:
    """A world as arrays: its numbers (G_*), noses (N_*) and drop circles, which nothing changes.

    `rows` has one ball's row for each of `world.balls`, at rest at the origin.
    """

    world: World
    numbers: NDArray[np.float64]
    noses: NDArray[np.float64]
    owners: tuple[Owner, ...]
    drops: NDArray[np.float64]
    drop_ids: tuple[PocketId, ...]
    index: Mapping[BallId, int]
    rows: NDArray[np.float64]


def packed(world: World) -> Packed:
    """Return the world as arrays, the same value each time for one and the same world.

    The last few worlds are kept by identity, since comparing two takes longer than a shot.
    Raises ValueError for what cannot be.
    """
    found = _kept.get(id(world))
    if found is None:
        found = _pack(world)
        while len(_kept) >= KEPT:
            _kept.pop(next(iter(_kept)), None)
        _kept[id(world)] = found
    return found


KEPT = 8
_kept: dict[int, Packed] = {}
"""By `id`, which stays the world's own for as long as the value holds the world."""


def _pack(world: World) -> Packed:
    numbers = pack_world(world)
    noses, owners = pack_noses(world.table)
    rows = np.zeros((len(world.balls), state.BALL_WIDTH))
    rows[:, state.END] = np.inf
    for row, ball in zip(rows, world.balls, strict=True):
        row[state.RADIUS], row[state.MASS] = ball.radius, ball.mass
        row[state.Z] = ball.radius
        row[state.REACH] = nose_reach(ball.radius, world.table.nose_height)
    return Packed(
        world=world,
        numbers=numbers,
        noses=noses,
        owners=owners,
        drops=pack_pockets(world.table),
        drop_ids=tuple(pocket.id for pocket in world.table.pockets),
        index=MappingProxyType({ball.id: i for i, ball in enumerate(world.balls)}),
        rows=rows,
    )


def pack_world(world: World) -> NDArray[np.float64]:
    """Return the world's numbers, columns G_*; raises ValueError for what cannot be."""
    cloth, contact, rubber, table = world.cloth, world.contact, world.rubber, world.table
    _check_world(world)
    reach = max((ball.radius for ball in world.balls), default=0.0) * 8.0
    row = np.zeros(20)
    row[state.G_SLIDING], row[state.G_ROLLING] = cloth.sliding, cloth.rolling
    row[state.G_SPIN], row[state.G_THRESHOLD] = cloth.spin_deceleration, cloth.threshold
    row[state.G_GRAVITY], row[state.G_E] = cloth.gravity, contact.restitution
    row[state.G_FLOOR], row[state.G_RISE] = contact.friction_floor, contact.friction_rise
    row[state.G_DECAY], row[state.G_RUBBER] = contact.friction_decay, rubber.restitution
    row[state.G_SLOPE], row[state.G_KNEE] = rubber.restitution_slope, rubber.restitution_knee
    row[state.G_FRICTION], row[state.G_NOSE] = rubber.friction, table.nose_height
    models = world.models
    row[state.G_MOTION] = _choose(MOTIONS, models.motion, "motion")
    row[state.G_BALL_BALL] = _choose(BALL_BALLS, models.ball_ball, "ball_ball")
    row[state.G_CUSHION] = _choose(CUSHIONS, models.ball_cushion, "ball_cushion")
    _choose(dict.fromkeys(STRIKES, 0), models.strike, "strike")
    _choose(dict.fromkeys(POCKETS, 0), models.pocket, "pocket")
    _choose(dict.fromkeys(FLIGHTS, 0), models.flight, "flight")
    row[state.G_OUT_X] = table.length / 2.0 + reach
    row[state.G_OUT_Y] = table.width / 2.0 + reach
    row[state.G_BED] = cloth.bounce
    return row


def _choose(names: Mapping[str, int], name: str, what: str) -> int:
    if name not in names:
        message = f"unknown {what} model {name!r}; there are: {', '.join(names)}"
        raise ValueError(message)
    return names[name]


def _check_world(world: World) -> None:
    cloth = world.cloth
    above = {
        "sliding friction": cloth.sliding,
        "rolling friction": cloth.rolling,
        "spin deceleration": cloth.spin_deceleration,
        "gravity": cloth.gravity,
        "threshold": cloth.threshold,
    }
    for ball in world.balls:
        above[f"radius of {ball.id}"] = ball.radius
        above[f"mass of {ball.id}"] = ball.mass
    for what, number in above.items():
        if not (isfinite(number) and number > 0.0):
            message = f"{what} must be above zero, not {number}"
            raise ValueError(message)
    for what, number in (
        ("ball on ball", world.contact.restitution),
        ("ball on cushion", world.rubber.restitution),
        ("ball on bed", cloth.bounce),
    ):
        if not 0.0 <= number <= 1.0:
            message = f"the restitution of {what} lies between 0 and 1, not at {number}"
            raise ValueError(message)


def place_balls(world: Packed, layout: Layout) -> tuple[tuple[Ball, ...], NDArray[np.float64]]:
    """Return the balls on the table in the world's order and their rows, at rest.

    Raises ValueError for a layout that cannot be.
    """
    unknown = [ball for ball in layout if ball not in world.index]
    if unknown:
        message = f"the layout names balls that the world has not: {unknown}"
        raise ValueError(message)
    chosen = sorted(world.index[ball] for ball in layout)
    balls = tuple(world.world.balls[i] for i in chosen)
    rows = world.rows[chosen]
    for row, ball in zip(rows, balls, strict=True):
        row[state.X], row[state.Y] = layout[ball.id]
    _check_places(balls, rows)
    return balls, rows


def nose_reach(radius: float, nose_height: float) -> float:
    """Return the horizontal distance (m) from centre to nose at contact: R cos(theta)."""
    rise = nose_height - radius
    if abs(rise) >= radius:
        message = f"a nose {nose_height} m high never meets a ball of radius {radius} m"
        raise ValueError(message)
    return sqrt(radius * radius - rise * rise)


def _check_places(balls: tuple[Ball, ...], rows: NDArray[np.float64]) -> None:
    x, y, radii = rows[:, state.X], rows[:, state.Y], rows[:, state.RADIUS]
    if not isfinite(x.sum() + y.sum()):
        raise ValueError("a ball's place must be two finite numbers")
    dx, dy = x[:, None] - x, y[:, None] - y
    need = 2.0 * np.sqrt(radii[:, None] * radii) - OVERLAP
    bad = dx * dx + dy * dy < need * need
    if np.count_nonzero(bad) > len(balls):
        first, second = next((i, j) for i, j in np.argwhere(bad) if i < j)
        message = f"balls overlap: {balls[first].id} and {balls[second].id}"
        raise ValueError(message)


def pack_noses(table: Table) -> tuple[NDArray[np.float64], tuple[Owner, ...]]:
    """Return the noses, columns N_*, and whose they are; free ends become points."""
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
    return np.array(rows).reshape(len(rows), 11), tuple(owners)


def _covered(point: Point, centre: Point, radius: float) -> bool:
    return hypot(point[0] - centre[0], point[1] - centre[1]) <= radius + 1e-9


def _pack_shape(shape: Shape) -> list[float]:
    if isinstance(shape, Straight):
        (x, y), (ex, ey) = shape.start, shape.end
        size = hypot(ex - x, ey - y)
        box = [min(x, ex), min(y, ey), max(x, ex), max(y, ey)]
        return [0.0, x, y, (ex - x) / size, (ey - y) / size, size, 0.0, *box]
    return _pack_curve(shape)


def _pack_curve(shape: Curve) -> list[float]:
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


def pack_pockets(table: Table) -> NDArray[np.float64]:
    """Return the drop circles as rows of x, y, radius (m)."""
    rows = [(*pocket.centre, pocket.radius) for pocket in table.pockets]
    return np.array(rows, dtype=np.float64).reshape(len(rows), 3)


__all__ = [
    "Owner",
    "Packed",
    "nose_reach",
    "pack_noses",
    "pack_pockets",
    "pack_world",
    "packed",
    "place_balls",
]
