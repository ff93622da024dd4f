"""Rectangular tables from a few measures: noses, jaws and drops of a table with 0 or 6 pockets.

One idea: the outline is walked once, counter-clockwise, so the bed lies on the left of every
shape; each shape begins where the last one ends, and joints are tangent wherever a ball can
touch them. Invariant: the jaws run in until the drop circle spans them, so that no ball leaves
through a pocket without dropping.
"""

from __future__ import annotations

from math import cos, hypot, isfinite, pi, sin, tan

from engine.table.furniture import (
    Curve,
    Cushion,
    CushionId,
    Jaw,
    Pocket,
    PocketId,
    Point,
    Shape,
    Straight,
    Table,
)
from frozen import value

PLAIN = ("foot", "left", "head", "right")
CUSHIONS = ("foot", "left-foot", "left-head", "head", "right-head", "right-foot")
POCKETS = ("foot-left", "side-left", "head-left", "head-right", "side-right", "foot-right")


RIM = 0.05
"""Height (m) of what stands behind a pocket where nothing is said: higher than any nose."""


@value
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


@value
class _Joint:
    """Where one cushion ends and the next begins, and the pocket between them."""

    vertex: Point
    before: Point
    after: Point
    cut: PocketCut
    pocket: PocketId

    @property
    def axis(self) -> Point:
        """Return the unit vector from the mouth into the pocket."""
        if self.before == self.after:
            return _right(self.before)
        x, y = self.before[0] - self.after[0], self.before[1] - self.after[1]
        return x / hypot(x, y), y / hypot(x, y)

    @property
    def setback(self) -> float:
        """Return the way from vertex to tip along the nose line."""
        across = abs(self.before[0] * self.axis[1] - self.before[1] * self.axis[0])
        return self.cut.mouth / 2.0 / across

    @property
    def tips(self) -> tuple[Point, Point]:
        """Return both ends of the mouth, in the order of the walk."""
        return (
            _along(self.vertex, self.before, -self.setback),
            _along(self.vertex, self.after, self.setback),
        )


def build_table(
    length: float,
    width: float,
    nose_height: float,
    corner: PocketCut | None,
    side: PocketCut | None,
    rail_width: float,
) -> Table:
    """Return a rectangular table (m): six pockets with both cuts given, none with neither.

    Raises ValueError where the measures do not make a closed table.
    """
    if not (length > 0.0 and width > 0.0 and nose_height > 0.0 and rail_width > 0.0):
        raise ValueError("a table's length, width, nose height and rail width must be above zero")
    if corner is None and side is None:
        return _plain(length, width, nose_height, rail_width)
    if corner is None or side is None:
        raise ValueError("a table has six pockets or none: give both cuts or neither")
    joints = _joints(length, width, corner, side)
    cushions = []
    for name, last, following in zip(CUSHIONS, (joints[-1], *joints[:-1]), joints, strict=True):
        cushions.append(_cushion(name, last, following))
    jaws = [jaw for joint in joints for jaw in _jaws(joint)]
    return Table(
        length=length,
        width=width,
        nose_height=nose_height,
        cushions=tuple(cushions),
        jaws=tuple(jaws),
        pockets=tuple(_pocket(joint) for joint in joints),
        rail_width=rail_width,
    )


def _plain(length: float, width: float, nose_height: float, rail_width: float) -> Table:
    x, y = length / 2.0, width / 2.0
    ends = ((x, -y), (x, y), (-x, y), (-x, -y), (x, -y))
    cushions = tuple(
        Cushion(CushionId(name), (Straight(start, end),))
        for name, start, end in zip(PLAIN, ends[:-1], ends[1:], strict=True)
    )
    return Table(length, width, nose_height, cushions, (), (), rail_width=rail_width)


def _joints(length: float, width: float, corner: PocketCut, side: PocketCut) -> list[_Joint]:
    x, y = length / 2.0, width / 2.0
    north, west, south, east = (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0), (1.0, 0.0)
    places = (
        ((x, y), north, west, corner),
        ((0.0, y), west, west, side),
        ((-x, y), west, south, corner),
        ((-x, -y), south, east, corner),
        ((0.0, -y), east, east, side),
        ((x, -y), east, north, corner),
    )
    return [
        _Joint(vertex, before, after, cut, PocketId(name))
        for name, (vertex, before, after, cut) in zip(POCKETS, places, strict=True)
    ]


def _cushion(name: str, last: _Joint, following: _Joint) -> Cushion:
    start = _along(last.tips[1], last.after, _tangent(last.cut))
    end = _along(following.tips[0], following.before, -_tangent(following.cut))
    way = following.before
    if (end[0] - start[0]) * way[0] + (end[1] - start[1]) * way[1] <= 0.0:
        message = f"the pockets leave nothing of the {name} cushion"
        raise ValueError(message)
    return Cushion(CushionId(name), (Straight(start, end),))


def _jaws(joint: _Joint) -> tuple[Jaw, Jaw]:
    first, second = joint.tips
    entering = _jaw(joint, first, joint.before, -1.0)
    back = (-joint.after[0], -joint.after[1])
    leaving = _jaw(joint, second, back, 1.0)
    _check_span(joint, entering[-1])
    reverse = tuple(_reversed(shape) for shape in reversed(leaving))
    return Jaw(joint.pocket, entering), Jaw(joint.pocket, reverse)


def _jaw(joint: _Joint, tip: Point, way: Point, hand: float) -> tuple[Shape, ...]:
    """Return shoulder and facing walked into the pocket; `hand` is +1 where they turn left."""
    cut, turn = joint.cut, pi - joint.cut.angle
    start = _along(tip, way, -_tangent(cut))
    aside = (-hand * way[1], hand * way[0])
    centre = _along(start, aside, cut.jaw_radius)
    shoulder = Curve(centre, cut.jaw_radius, _heading((-aside[0], -aside[1])), hand * turn)
    facing = _turned(way, hand * turn)
    inward = facing[0] * joint.axis[0] + facing[1] * joint.axis[1]
    reach = (cut.shelf + cut.radius) / max(inward, 1e-9)
    if reach <= _tangent(cut):
        return (shoulder,)
    near, far = _along(tip, facing, _tangent(cut)), _along(tip, facing, reach)
    return shoulder, Straight(near, far)


def _check_span(joint: _Joint, last: Shape) -> None:
    """Raise unless the drop circle fills the gap between the jaws at its own centre's depth."""
    centre = _pocket(joint).centre
    if isinstance(last, Straight):
        gap = hypot(last.end[0] - centre[0], last.end[1] - centre[1])
    else:
        gap = hypot(last.centre[0] - centre[0], last.centre[1] - centre[1]) - last.radius
    if joint.cut.radius < gap - 1e-9:
        message = (
            f"pocket {joint.pocket}: a drop radius of {joint.cut.radius:.4f} m leaves a gap "
            f"beside it; it must be at least {gap:.4f} m"
        )
        raise ValueError(message)


def _pocket(joint: _Joint) -> Pocket:
    first, second = joint.tips
    middle = (first[0] + second[0]) / 2.0, (first[1] + second[1]) / 2.0
    centre = _along(middle, joint.axis, joint.cut.shelf + joint.cut.radius)
    return joint.cut.pocket(joint.pocket, centre, (first, second))


def _tangent(cut: PocketCut) -> float:
    return cut.jaw_radius * tan((pi - cut.angle) / 2.0)


def _reversed(shape: Shape) -> Shape:
    if isinstance(shape, Straight):
        return Straight(shape.end, shape.start)
    return Curve(shape.centre, shape.radius, shape.start + shape.sweep, -shape.sweep)


def _along(point: Point, way: Point, distance: float) -> Point:
    return point[0] + way[0] * distance, point[1] + way[1] * distance


def _right(way: Point) -> Point:
    return way[1], -way[0]


def _turned(way: Point, angle: float) -> Point:
    c, s = cos(angle), sin(angle)
    return c * way[0] - s * way[1], s * way[0] + c * way[1]


def _heading(way: Point) -> float:
    """Return the angle of one of the four axes, exactly."""
    return {(1, 0): 0.0, (0, 1): pi / 2, (-1, 0): pi, (0, -1): -pi / 2}[
        (round(way[0]), round(way[1]))
    ]


__all__ = ["PocketCut", "build_table"]
