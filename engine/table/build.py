"""Rectangular tables from a few measures: noses, jaws and drops of a table with 0 or 6 pockets.

One idea: the outline is walked once, counter-clockwise, so the bed lies on the left of every
shape; each shape begins where the last one ends, and joints are tangent wherever a ball can
touch them. Invariant: the jaws run in until the drop circle spans them, so that no ball leaves
through a pocket without dropping.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot

from engine.table.furniture import Cushion, CushionId, Jaw, Pocket, PocketId, Point, Straight, Table
from engine.table.mouth import MouthError, PocketCut, fill_gap, tangent_of

PLAIN = ("foot", "left", "head", "right")
CUSHIONS = ("foot", "left-foot", "left-head", "head", "right-head", "right-foot")
POCKETS = ("foot-left", "side-left", "head-left", "head-right", "side-right", "foot-right")


@dataclass(frozen=True, slots=True)
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
            return self.before[1], -self.before[0]
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
    mouths = [_mouth(joint) for joint in joints]
    return Table(
        length=length,
        width=width,
        nose_height=nose_height,
        cushions=tuple(cushions),
        jaws=tuple(jaw for jaws, _ in mouths for jaw in jaws),
        pockets=tuple(pocket for _, pocket in mouths),
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
    start = _along(last.tips[1], last.after, tangent_of(last.cut))
    end = _along(following.tips[0], following.before, -tangent_of(following.cut))
    way = following.before
    if (end[0] - start[0]) * way[0] + (end[1] - start[1]) * way[1] <= 0.0:
        message = f"the pockets leave nothing of the {name} cushion"
        raise ValueError(message)
    return Cushion(CushionId(name), (Straight(start, end),))


def _mouth(joint: _Joint) -> tuple[tuple[Jaw, Jaw], Pocket]:
    try:
        return fill_gap(
            joint.pocket, joint.cut, joint.tips, (joint.before, joint.after), joint.axis
        )
    except MouthError as error:
        message = f"pocket {joint.pocket}: {error}"
        raise ValueError(message) from None


def _along(point: Point, way: Point, distance: float) -> Point:
    return point[0] + way[0] * distance, point[1] + way[1] * distance


__all__ = ["PocketCut", "build_table"]
