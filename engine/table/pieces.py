"""An outline's corners, and the noses that lead from each to the next before anything is cut.

One idea: a cushion is straight, or an arc told by a point or a radius. Invariant: a piece that
cannot be drawn is a fault of its corner.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import asin, atan2, cos, hypot, tau
from typing import TYPE_CHECKING, Literal

from engine.geometry.vectors import distance
from engine.table.furniture import Curve, Straight
from engine.table.mouth import length_of, point_along
from engine.table.region import bounds

if TYPE_CHECKING:
    from collections.abc import Sequence

    from engine.table.furniture import CushionId, PocketId, Point, Shape
    from engine.table.mouth import PocketCut

Kind = Literal["centre", "arc", "short", "crossing", "clockwise", "narrow", "pocket"]


@dataclass(frozen=True, slots=True)
class Corner:
    """A corner of an outline, and the cushion from here to the next corner.

    `at` (m) is where the noses meet. The cushion is straight, or an arc `through` a point, or an
    arc of `radius` (m) that curves away from the bed. `rounding` (m) rounds the corner itself;
    `pocket` and `cut` put a pocket there. Neighbours of one `cushion` name are one cushion.
    """

    at: Point
    cushion: CushionId
    through: Point | None = None
    radius: float | None = None
    rounding: float | None = None
    pocket: PocketId | None = None
    cut: PocketCut | None = None


@dataclass(frozen=True, slots=True)
class Fault:
    """What is wrong with an outline: at which corner, or None for the whole; and a mend."""

    kind: Kind
    corner: int | None
    message: str
    mend: str


def box_of(corners: Sequence[Corner]) -> tuple[float, float, float, float] | None:
    """Return the box (m) about the corners' pieces, unrounded; None where one cannot be drawn."""
    shapes = [draw_piece(one, two.at) for one, two in pairs_of(corners)]
    drawn = [shape for shape in shapes if shape is not None]
    return bounds(drawn) if len(drawn) == len(shapes) > 1 else None


def pairs_of(corners: Sequence[Corner]) -> list[tuple[Corner, Corner]]:
    """Return each corner with the one that follows it."""
    return list(zip(corners, (*corners[1:], *corners[:1]), strict=True))


def draw_pieces(corners: Sequence[Corner], ball: float) -> tuple[list[Shape], list[Fault]]:
    """Return the noses from corner to corner, before anything is cut."""
    pieces: list[Shape] = []
    faults: list[Fault] = []
    for index, (corner, following) in enumerate(pairs_of(corners)):
        piece = None
        if distance(corner.at, following.at) < 2.0 * ball:
            faults.append(too_short(index, corner, distance(corner.at, following.at)))
        else:
            piece = draw_piece(corner, following.at)
            if piece is None:
                faults.append(_no_arc(index, corner, following))
        if isinstance(piece, Curve) and piece.sweep > 0.0 and piece.radius < 2.0 * ball:
            message = f"cushion {corner.cushion} bends round {piece.radius * 1000:.0f} mm"
            mend = "a curve about the bed needs a radius of a ball's diameter at least"
            faults.append(Fault("narrow", index, f"{message}, too tight for a ball", mend))
        if piece is not None:
            pieces.append(piece)
    return pieces, faults


def too_short(index: int, corner: Corner, left: float) -> Fault:
    """Return that of the cushion from a corner too little (m) is left."""
    shown = f"{max(left, 0.0) * 1000:.0f} mm"
    message = f"of cushion {corner.cushion} {shown} are left, less than a ball"
    mend = "move its corners apart, or cut and round less of it"
    return Fault("short", index, message, mend)


def _no_arc(index: int, corner: Corner, following: Corner) -> Fault:
    half = distance(corner.at, following.at) / 2.0
    message = f"no arc leads from this corner of cushion {corner.cushion} to the next"
    mend = f"a radius of {half:.3f} m or more, or a point `through` that is off the straight line"
    return Fault("arc", index, message, mend)


def draw_piece(corner: Corner, end: Point) -> Shape | None:
    """Return the nose from a corner to `end`; None where there is no such arc."""
    if corner.through is not None:
        return _arc_through(corner.at, corner.through, end)
    if corner.radius is None:
        return Straight(corner.at, end) if corner.at != end else None
    (ax, ay), (bx, by) = corner.at, end
    chord = hypot(bx - ax, by - ay)
    if chord == 0.0 or chord > 2.0 * corner.radius * (1.0 + 1e-9):
        return None
    half = asin(min(chord / 2.0 / corner.radius, 1.0))
    rise = corner.radius * cos(half)
    centre = (ax + bx) / 2.0 - (by - ay) / chord * rise, (ay + by) / 2.0 + (bx - ax) / chord * rise
    return Curve(centre, corner.radius, atan2(ay - centre[1], ax - centre[0]), 2.0 * half)


def _arc_through(start: Point, middle: Point, end: Point) -> Curve | None:
    """Return the arc from `start` through `middle` to `end`; None where they are in line."""
    ax, ay, bx, by = (
        middle[0] - start[0],
        middle[1] - start[1],
        end[0] - start[0],
        end[1] - start[1],
    )
    cross = ax * by - ay * bx
    if abs(cross) < 1e-6 * (hypot(ax, ay) + hypot(bx, by)) ** 2:
        return None
    a, b = ax * ax + ay * ay, bx * bx + by * by
    centre = (
        start[0] + (by * a - ay * b) / (2.0 * cross),
        start[1] + (ax * b - bx * a) / (2 * cross),
    )
    first = atan2(start[1] - centre[1], start[0] - centre[0])
    turn = (atan2(end[1] - centre[1], end[0] - centre[0]) - first) % tau
    sweep = turn if cross > 0.0 else turn - tau
    return Curve(centre, distance(start, centre), first, sweep)


def turn_between(before: Shape, after: Shape) -> float:
    """Return by what angle (rad) the chain turns to the left between two noses."""
    one, two = point_along(before, length_of(before))[1], point_along(after, 0.0)[1]
    return atan2(one[0] * two[1] - one[1] * two[0], one[0] * two[0] + one[1] * two[1])


__all__ = [
    "Corner",
    "Fault",
    "box_of",
    "draw_pieces",
    "pairs_of",
    "too_short",
    "turn_between",
]
