"""Tables of any outline: a closed chain of straight and round cushions, given by its corners.

One idea: each corner says where it is, which cushion begins there and what is done to it: left
plain, rounded, or cut for a pocket. The chain closes by itself, from the last corner to the first.
Invariant: what cannot be a table is told as a list of faults, each with its corner, and no table
is built.
"""

from __future__ import annotations

from itertools import pairwise
from math import asin, atan2, cos, degrees, hypot, pi, radians, tau
from typing import TYPE_CHECKING, Literal

from engine.table.furniture import Curve, Cushion, CushionId, Straight, Table
from engine.table.mouth import MouthError, cut_mouth, length_of, point_along, shortened
from engine.table.region import bounds, distance_to, ends, trace
from engine.table.rounding import round_corner
from frozen import value

if TYPE_CHECKING:
    from collections.abc import Sequence

    from engine.table.build import PocketCut
    from engine.table.furniture import Jaw, Pocket, PocketId, Point, Shape
    from engine.table.mouth import Mouth

NOSE = 0.01
"""Radius (m) of the round nose at a corner that points into the bed and says no other."""
NARROWEST = radians(30.0)
BLUNT = radians(3.0)
"""A turn into the bed smaller than this needs no round nose: two arcs of one curve."""
OFF_CENTRE = 0.001

Kind = Literal["centre", "arc", "short", "crossing", "clockwise", "narrow", "pocket"]


@value
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


@value
class Fault:
    """What is wrong with an outline: at which corner, or None for the whole; and a mend."""

    kind: Kind
    corner: int | None
    message: str
    mend: str


class OutlineError(ValueError):
    """An outline that is no table; `faults` has everything that is wrong."""

    def __init__(self, faults: Sequence[Fault]) -> None:
        super().__init__("; ".join(fault.message for fault in faults))
        self.faults = tuple(faults)


def build_outline(
    corners: Sequence[Corner], nose_height: float, rail_width: float, ball: float
) -> Table:
    """Return the table of an outline, bed on the left, for balls of at most `ball` (m) radius.

    Raises OutlineError with every fault.
    """
    pieces, faults = _pieces(corners, ball)
    if not faults:
        faults = _whole(corners, pieces, ball)
    if faults:
        raise OutlineError(faults)
    chain, fillets = _rounded(corners, pieces, faults)
    mouths = _mouths(corners, chain, ball, faults)
    cushions = _cushions(corners, chain, fillets, mouths, ball, faults)
    pockets = [mouth.pocket for mouth in mouths if mouth]
    _check_drops(corners, cushions, pockets, faults)
    if faults:
        raise OutlineError(faults)
    x0, y0, x1, y1 = bounds(chain_of(chain, fillets))
    jaws: list[Jaw] = [jaw for mouth in mouths if mouth for jaw in mouth.jaws]
    return Table(
        length=2.0 * max(-x0, x1),
        width=2.0 * max(-y0, y1),
        nose_height=nose_height,
        cushions=tuple(cushions),
        jaws=tuple(jaws),
        pockets=tuple(pockets),
        rail_width=rail_width,
        outline=chain_of(chain, fillets),
    )


def chain_of(chain: Sequence[Shape], fillets: Sequence[Curve | None]) -> tuple[Shape, ...]:
    """Return the closed chain: each piece after the round of the corner it begins at."""
    found: list[Shape] = []
    for piece, fillet in zip(chain, fillets, strict=True):
        found += [piece] if fillet is None else [fillet, piece]
    return tuple(found)


def box_of(corners: Sequence[Corner]) -> tuple[float, float, float, float] | None:
    """Return the box (m) about the corners' pieces, unrounded; None where one cannot be drawn."""
    shapes = [_piece(one, two.at) for one, two in _pairs(corners)]
    drawn = [shape for shape in shapes if shape is not None]
    return bounds(drawn) if len(drawn) == len(shapes) > 1 else None


def _pairs(corners: Sequence[Corner]) -> list[tuple[Corner, Corner]]:
    return list(zip(corners, (*corners[1:], *corners[:1]), strict=True))


def _pieces(corners: Sequence[Corner], ball: float) -> tuple[list[Shape], list[Fault]]:
    """Return the noses from corner to corner, before anything is cut."""
    pieces: list[Shape] = []
    faults: list[Fault] = []
    for index, (corner, following) in enumerate(_pairs(corners)):
        piece = None
        if _away(corner.at, following.at) < 2.0 * ball:
            faults.append(_short(index, corner, _away(corner.at, following.at)))
        else:
            piece = _piece(corner, following.at)
            if piece is None:
                faults.append(_no_arc(index, corner, following))
        if isinstance(piece, Curve) and piece.sweep > 0.0 and piece.radius < 2.0 * ball:
            message = f"cushion {corner.cushion} bends round {piece.radius * 1000:.0f} mm"
            mend = "a curve about the bed needs a radius of a ball's diameter at least"
            faults.append(Fault("narrow", index, f"{message}, too tight for a ball", mend))
        if piece is not None:
            pieces.append(piece)
    return pieces, faults


def _short(index: int, corner: Corner, left: float) -> Fault:
    shown = f"{max(left, 0.0) * 1000:.0f} mm"
    message = f"of cushion {corner.cushion} {shown} are left, less than a ball"
    mend = "move its corners apart, or cut and round less of it"
    return Fault("short", index, message, mend)


def _no_arc(index: int, corner: Corner, following: Corner) -> Fault:
    half = _away(corner.at, following.at) / 2.0
    message = f"no arc leads from this corner of cushion {corner.cushion} to the next"
    mend = f"a radius of {half:.3f} m or more, or a point `through` that is off the straight line"
    return Fault("arc", index, message, mend)


def _piece(corner: Corner, end: Point) -> Shape | None:
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
    return Curve(centre, _away(start, centre), first, sweep)


def _whole(corners: Sequence[Corner], pieces: list[Shape], ball: float) -> list[Fault]:
    """Return what is wrong with the outline as a whole, and with its corners' angles."""
    faults: list[Fault] = []
    crossed = _crossing(pieces)
    if crossed is not None:
        one, two = crossed
        names = f"{corners[one].cushion} and {corners[two].cushion}"
        message = f"the outline crosses itself: cushions {names}"
        mend = "name the corners in their order round the bed"
        return [Fault("crossing", two, message, mend)]
    if _area(trace(pieces)) <= 0.0:
        mend = "turn the order of the corners round, so that the bed is on the left"
        return [Fault("clockwise", None, "the outline runs clockwise", mend)]
    x0, y0, x1, y1 = bounds(pieces)
    middle = (x0 + x1) / 2.0, (y0 + y1) / 2.0
    if max(abs(middle[0]), abs(middle[1])) > OFF_CENTRE:
        message = f"the outline's middle lies at ({middle[0]:.4f}, {middle[1]:.4f}) m"
        mend = f"take {middle[0]:.4f} m from every x and {middle[1]:.4f} m from every y"
        faults.append(Fault("centre", None, f"{message}, not at the origin", mend))
    for index, corner in enumerate(corners):
        inner = pi - _turn(pieces[index - 1], pieces[index])
        if inner < NARROWEST:
            message = f"the corner is {degrees(inner):.0f} degrees wide, too narrow for a ball"
            mend = f"open it to {degrees(NARROWEST):.0f} degrees at least"
            faults.append(Fault("narrow", index, message, mend))
        elif corner.rounding is not None and 0.0 < corner.rounding < 2.0 * ball and inner < pi:
            message = f"a round of {corner.rounding * 1000:.0f} mm is too tight for a ball"
            mend = "a ball's diameter at least, or leave the corner plain"
            faults.append(Fault("narrow", index, message, mend))
    return faults


def _turn(before: Shape, after: Shape) -> float:
    """Return by what angle (rad) the chain turns to the left between two noses."""
    one, two = point_along(before, length_of(before))[1], point_along(after, 0.0)[1]
    return atan2(one[0] * two[1] - one[1] * two[0], one[0] * two[0] + one[1] * two[1])


def _crossing(pieces: Sequence[Shape]) -> tuple[int, int] | None:
    """Return the first two pieces that cross or touch away from a common corner."""
    runs = [[*trace([piece], 0.1), ends(piece)[1]] for piece in pieces]
    count = len(runs)
    segments = [(a, b, index) for index, run in enumerate(runs) for a, b in pairwise(run)]
    for i, (a, b, one) in enumerate(segments):
        for j, (c, d, two) in enumerate(segments[i + 2 :], i + 2):
            if i == 0 and j == len(segments) - 1:
                continue
            if _cross(a, b, c, d) and (count > 1):
                return one, two
    return None


def _cross(a: Point, b: Point, c: Point, d: Point) -> bool:
    if max(a[0], b[0]) < min(c[0], d[0]) or max(c[0], d[0]) < min(a[0], b[0]):
        return False
    if max(a[1], b[1]) < min(c[1], d[1]) or max(c[1], d[1]) < min(a[1], b[1]):
        return False
    one = _side(a, b, c) * _side(a, b, d)
    two = _side(c, d, a) * _side(c, d, b)
    return one <= 0.0 and two <= 0.0


def _side(a: Point, b: Point, p: Point) -> float:
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def _area(points: Sequence[Point]) -> float:
    return (
        sum(
            a[0] * b[1] - a[1] * b[0] for a, b in zip(points, (*points[1:], points[0]), strict=True)
        )
        / 2.0
    )


def _rounded(
    corners: Sequence[Corner], pieces: Sequence[Shape], faults: list[Fault]
) -> tuple[list[Shape], list[Curve | None]]:
    """Return the pieces cut back for the rounds of their corners, and those rounds."""
    fillets: list[Curve | None] = []
    cuts = [[0.0, 0.0] for _ in pieces]
    for index, corner in enumerate(corners):
        before, after = pieces[index - 1], pieces[index]
        turn = _turn(before, after)
        radius = corner.rounding
        if radius is None:
            radius = NOSE if turn < -BLUNT and corner.pocket is None else 0.0
        found = round_corner(before, after, radius, turn) if radius and abs(turn) > 1e-6 else None
        fillets.append(found.arc if found else None)
        if found:
            cuts[index - 1][1], cuts[index][0] = found.before, found.after
        elif radius and abs(turn) > 1e-6:
            message = f"the corner cannot be rounded by {radius * 1000:.0f} mm"
            mend = "a smaller round, or longer cushions beside it"
            faults.append(Fault("arc", index, message, mend))
    chain: list[Shape] = []
    for index, (piece, (first, last)) in enumerate(zip(pieces, cuts, strict=True)):
        left = length_of(piece) - first - last
        if left <= 0.0:
            faults.append(_short(index, corners[index], left))
        chain.append(shortened(piece, first, last) if left > 0.0 else piece)
    return chain, fillets


def _mouths(
    corners: Sequence[Corner], chain: Sequence[Shape], ball: float, faults: list[Fault]
) -> list[Mouth | None]:
    found: list[Mouth | None] = []
    for index, corner in enumerate(corners):
        mouth = None
        if corner.pocket is not None and corner.cut is not None:
            try:
                before, after = chain[index - 1], chain[index]
                mouth = cut_mouth(corner.pocket, corner.cut, before, after, ball)
            except MouthError as error:
                message = f"pocket {corner.pocket} cannot be cut here: {error}"
                mend = "compare its cut's figures with those of a shipped table"
                faults.append(Fault("pocket", index, message, mend))
        found.append(mouth)
    return found


def _cushions(
    corners: Sequence[Corner],
    chain: Sequence[Shape],
    fillets: Sequence[Curve | None],
    mouths: Sequence[Mouth | None],
    ball: float,
    faults: list[Fault],
) -> list[Cushion]:
    """Return the cushions, neighbours of one name joined, in the order of their first corner."""
    shapes: dict[CushionId, list[Shape]] = {}
    after_seam: dict[CushionId, list[Shape]] = {}
    wraps = len(corners) > 1 and corners[-1].cushion == corners[0].cushion
    for index, corner in enumerate(corners):
        first, last = mouths[index], mouths[(index + 1) % len(corners)]
        cut = (first.setback if first else 0.0), (last.setback if last else 0.0)
        left = length_of(chain[index]) - sum(cut)
        if left < 2.0 * ball:
            faults.append(_short(index, corner, left))
            continue
        own = [shortened(chain[index], *cut)]
        fillet = fillets[index]
        if fillet is not None:
            own.insert(0, fillet)
        seam = wraps and corner.cushion == corners[0].cushion
        if seam and any(c.cushion != corner.cushion for c in corners[:index]):
            after_seam.setdefault(corner.cushion, []).extend(own)
        else:
            shapes.setdefault(corner.cushion, []).extend(own)
    return [Cushion(name, (*after_seam.get(name, ()), *found)) for name, found in shapes.items()]


def _check_drops(
    corners: Sequence[Corner],
    cushions: Sequence[Cushion],
    pockets: Sequence[Pocket],
    faults: list[Fault],
) -> None:
    """Note every drop that reaches a nose, or another drop."""
    places = {corner.pocket: index for index, corner in enumerate(corners)}
    for number, pocket in enumerate(pockets):
        near = next(
            (
                cushion.id
                for cushion in cushions
                for shape in cushion.shapes
                if distance_to(shape, pocket.centre) < pocket.radius - 1e-6
            ),
            None,
        )
        other = next(
            (
                one.id
                for one in pockets[:number]
                if _away(one.centre, pocket.centre) < one.radius + pocket.radius
            ),
            None,
        )
        if near is not None or other is not None:
            what = f"cushion {near}" if near is not None else f"pocket {other}"
            message = f"the drop of pocket {pocket.id} reaches {what}"
            mend = "a smaller radius of the drop, or more room"
            faults.append(Fault("pocket", places[pocket.id], message, mend))


def _away(a: Point, b: Point) -> float:
    return hypot(a[0] - b[0], a[1] - b[1])


__all__ = ["Corner", "Fault", "OutlineError", "box_of", "build_outline"]
