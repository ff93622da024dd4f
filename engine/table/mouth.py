"""A pocket cut into a chain of noses: jaws, facings and the drop, wherever it is cut.

One idea: both noses are cut back alike, along themselves, until the tips are a mouth apart; from
there everything follows from the ways of the noses at the cut.
Invariant: as on a rectangular table, the jaws run in until the drop circle spans them.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, hypot, isfinite, pi, sin, tan
from typing import TYPE_CHECKING

from engine.table.furniture import Curve, Jaw, Pocket, PocketId, Straight
from engine.table.region import ends

if TYPE_CHECKING:
    from engine.table.furniture import Point, Shape

RIM = 0.05
"""Height (m) of what stands behind a pocket where nothing is said: higher than any nose."""


@dataclass(frozen=True, slots=True)
class PocketCut:
    """How a pocket is cut into the cushions.

    `mouth` (m) runs from tip to tip, a tip being where the nose line and the line of the facing
    cross; `angle` (rad) is the cut angle between facing and cushion (WPA specifications 9: 142
    degrees at a corner, 104 at a side; 135 and 90 make parallel facings); `shelf` (m) runs from
    the mouth to the drop; `jaw_radius` (m) rounds the tip, and is the whole jaw where it is
    large; `radius` (m) is that of the drop circle. `lip`, `rim`, `restitution`, `friction` and
    `model` are those of the pocket.
    """

    mouth: float
    angle: float
    shelf: float
    jaw_radius: float
    radius: float
    lip: float = 0.0
    rim: float = RIM
    restitution: float = 0.2
    friction: float = 0.2
    model: str | None = None

    def pocket(self, name: PocketId, centre: Point, mouth: tuple[Point, Point]) -> Pocket:
        """Return a pocket of this kind."""
        return Pocket(
            name,
            centre,
            self.radius,
            mouth,
            model=self.model,
            lip=self.lip,
            rim=self.rim,
            restitution=self.restitution,
            friction=self.friction,
        )

    def __post_init__(self) -> None:
        sizes = (self.mouth, self.jaw_radius, self.radius)
        if not all(isfinite(size) and size > 0.0 for size in (*sizes, self.shelf + 1.0)):
            message = f"a pocket's mouth, jaw radius and drop radius must be above zero: {self}"
            raise ValueError(message)
        if not pi / 4 < self.angle < pi:
            message = f"a cut angle lies between 45 and 180 degrees, not at {self.angle} rad"
            raise ValueError(message)


@dataclass(frozen=True, slots=True)
class Mouth:
    """A pocket between two noses: how far (m) each is cut back, and what fills the gap."""

    setback: float
    jaws: tuple[Jaw, Jaw]
    pocket: Pocket


class MouthError(ValueError):
    """A pocket that cannot be cut where it should be."""


def cut_mouth(name: PocketId, cut: PocketCut, before: Shape, after: Shape, ball: float) -> Mouth:
    """Return the pocket cut where the nose `before` ends and the nose `after` begins.

    Balls of at most `ball` (m) radius must pass between its facings. Raises MouthError where they
    do not, where the noses are too short for it or its figures do not fit.
    """
    setback = _setback(cut, before, after)
    one, way_in = point_along(before, length_of(before) - setback)
    two, way_out = point_along(after, setback)
    tips = _ahead(one, way_in, tangent_of(cut)), _ahead(two, way_out, -tangent_of(cut))
    across = tips[1][0] - tips[0][0], tips[1][1] - tips[0][1]
    axis = across[1] / hypot(*across), -across[0] / hypot(*across)
    return Mouth(setback, *fill_gap(name, cut, tips, (way_in, way_out), axis, ball))


def fill_gap(
    name: PocketId,
    cut: PocketCut,
    tips: tuple[Point, Point],
    ways: tuple[Point, Point],
    axis: Point,
    ball: float = 0.0,
) -> tuple[tuple[Jaw, Jaw], Pocket]:
    """Return both jaws and the pocket between two tips, where the noses have the ways `ways`.

    `axis` is the unit vector from the mouth into the pocket; balls of at most `ball` (m) radius
    must pass between straight facings. Raises MouthError for figures that do not fit.
    """
    middle = (tips[0][0] + tips[1][0]) / 2.0, (tips[0][1] + tips[1][1]) / 2.0
    pocket = cut.pocket(name, _ahead(middle, axis, cut.shelf + cut.radius), tips)
    entering = _jaw(cut, tips[0], ways[0], axis, -1.0)
    leaving = _jaw(cut, tips[1], (-ways[1][0], -ways[1][1]), axis, 1.0)
    if ball:
        _check_throat(cut, (entering[-1], leaving[-1]), axis, ball)
    for jaw in (entering, leaving):
        _check_span(pocket, jaw[-1])
    back = tuple(_reversed(shape) for shape in reversed(leaving))
    return (Jaw(name, entering), Jaw(name, back)), pocket


def _setback(cut: PocketCut, before: Shape, after: Shape) -> float:
    """Return how far both noses are cut back (m) for the tips to be a mouth apart."""
    low, high = 0.0, min(length_of(before), length_of(after))
    if _apart(cut, before, after, high) < cut.mouth:
        raise MouthError("the cushions beside it are too short for its mouth")
    for _ in range(100):
        middle = (low + high) / 2.0
        if _apart(cut, before, after, middle) < cut.mouth:
            low = middle
        else:
            high = middle
    return high


def _apart(cut: PocketCut, before: Shape, after: Shape, setback: float) -> float:
    """Return how far the tips are apart, less than zero where they have passed each other."""
    one, way_in = point_along(before, length_of(before) - setback)
    two, way_out = point_along(after, setback)
    first, second = _ahead(one, way_in, tangent_of(cut)), _ahead(two, way_out, -tangent_of(cut))
    across = second[0] - first[0], second[1] - first[1]
    forward = across[0] * (way_in[0] + way_out[0]) + across[1] * (way_in[1] + way_out[1])
    return hypot(*across) if forward > 0.0 else -hypot(*across)


def _jaw(cut: PocketCut, tip: Point, way: Point, axis: Point, hand: float) -> tuple[Shape, ...]:
    """Return shoulder and facing walked into the pocket; `hand` is +1 where they turn left."""
    turn = pi - cut.angle
    start = _ahead(tip, way, -tangent_of(cut))
    aside = -hand * way[1], hand * way[0]
    centre = _ahead(start, aside, cut.jaw_radius)
    shoulder = Curve(centre, cut.jaw_radius, atan2(0.0 - aside[1], 0.0 - aside[0]), hand * turn)
    c, s = cos(hand * turn), sin(hand * turn)
    facing = c * way[0] - s * way[1], s * way[0] + c * way[1]
    inward = facing[0] * axis[0] + facing[1] * axis[1]
    if inward < 0.05:
        raise MouthError("its facings do not lead into it; a smaller cut angle turns them")
    reach = (cut.shelf + cut.radius) / inward
    if reach <= tangent_of(cut):
        return (shoulder,)
    return shoulder, Straight(_ahead(tip, facing, tangent_of(cut)), _ahead(tip, facing, reach))


def _check_throat(cut: PocketCut, lasts: tuple[Shape, Shape], axis: Point, ball: float) -> None:
    """Raise where straight facings come too near to each other before the drop begins."""
    places = []
    for last in lasts:
        if not isinstance(last, Straight):
            return
        way = point_along(last, 0.0)[1]
        back = (cut.radius - cut.radius / 8.0) / (way[0] * axis[0] + way[1] * axis[1])
        places.append(_ahead(last.end, way, -back))
    gap = (places[1][0] - places[0][0]) * -axis[1] + (places[1][1] - places[0][1]) * axis[0]
    if gap < 2.0 * ball:
        message = f"its facings leave {max(gap, 0.0) * 1000:.0f} mm before the drop"
        raise MouthError(f"{message}; a smaller cut angle opens it")


def _check_span(pocket: Pocket, last: Shape) -> None:
    if isinstance(last, Straight):
        gap = hypot(last.end[0] - pocket.centre[0], last.end[1] - pocket.centre[1])
    else:
        away = last.centre[0] - pocket.centre[0], last.centre[1] - pocket.centre[1]
        gap = hypot(*away) - last.radius
    if pocket.radius < gap - 1e-9:
        message = (
            f"a drop radius of {pocket.radius:.4f} m leaves a gap beside it; "
            f"it must be at least {gap:.4f} m"
        )
        raise MouthError(message)


def tangent_of(cut: PocketCut) -> float:
    """Return the way (m) from a tip to where its shoulder begins on the nose."""
    return cut.jaw_radius * tan((pi - cut.angle) / 2.0)


def _reversed(shape: Shape) -> Shape:
    if isinstance(shape, Straight):
        return Straight(shape.end, shape.start)
    return Curve(shape.centre, shape.radius, shape.start + shape.sweep, -shape.sweep)


def length_of(shape: Shape) -> float:
    """Return a nose's length (m)."""
    if isinstance(shape, Curve):
        return shape.radius * abs(shape.sweep)
    return hypot(shape.end[0] - shape.start[0], shape.end[1] - shape.start[1])


def point_along(shape: Shape, distance: float) -> tuple[Point, Point]:
    """Return the point `distance` (m) from a nose's beginning, and the unit way there."""
    if isinstance(shape, Straight):
        size = length_of(shape)
        way = (shape.end[0] - shape.start[0]) / size, (shape.end[1] - shape.start[1]) / size
        return _ahead(shape.start, way, distance), way
    hand = 1.0 if shape.sweep > 0.0 else -1.0
    angle = shape.start + hand * distance / shape.radius
    c, s = cos(angle), sin(angle)
    place = shape.centre[0] + shape.radius * c, shape.centre[1] + shape.radius * s
    return place, (-hand * s, hand * c)


def shortened(shape: Shape, first: float, last: float) -> Shape:
    """Return a nose less `first` (m) at its beginning and `last` at its end."""
    if isinstance(shape, Curve):
        hand = 1.0 if shape.sweep > 0.0 else -1.0
        start = shape.start + hand * first / shape.radius
        return Curve(
            shape.centre, shape.radius, start, shape.sweep - hand * (first + last) / shape.radius
        )
    near = point_along(shape, first)[0] if first else ends(shape)[0]
    far = point_along(shape, length_of(shape) - last)[0] if last else ends(shape)[1]
    return Straight(near, far)


def _ahead(point: Point, way: Point, distance: float) -> Point:
    return point[0] + way[0] * distance, point[1] + way[1] * distance


__all__ = [
    "Mouth",
    "MouthError",
    "PocketCut",
    "cut_mouth",
    "fill_gap",
    "length_of",
    "point_along",
    "shortened",
    "tangent_of",
]
