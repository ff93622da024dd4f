"""Tables of any outline: a closed chain of straight and round cushions, given by its corners.

One idea: each corner says where it is, which cushion begins there and what is done to it: left
plain, rounded, or cut for a pocket. The chain closes by itself, from the last corner to the first.
Invariant: what cannot be a table is told as a list of faults, each with its corner, and no table
is built.
"""

from __future__ import annotations

from math import radians
from typing import TYPE_CHECKING

from engine.geometry.vectors import distance
from engine.table.furniture import Curve, Cushion, Table
from engine.table.mouth import MouthError, cut_mouth, length_of, shortened
from engine.table.pieces import Corner, Fault, box_of, draw_pieces, too_short, turn_between
from engine.table.region import bounds, distance_to
from engine.table.rounding import round_corner
from engine.table.sound import faults_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from engine.table.furniture import CushionId, Jaw, Pocket, Shape
    from engine.table.mouth import Mouth

NOSE = 0.01
"""Radius (m) of the round nose at a corner that points into the bed and says no other."""
BLUNT = radians(3.0)
"""A turn into the bed smaller than this needs no round nose: two arcs of one curve."""


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
    pieces, faults = draw_pieces(corners, ball)
    if not faults:
        faults = faults_of(corners, pieces, ball)
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


def _rounded(
    corners: Sequence[Corner], pieces: Sequence[Shape], faults: list[Fault]
) -> tuple[list[Shape], list[Curve | None]]:
    """Return the pieces cut back for the rounds of their corners, and those rounds."""
    fillets: list[Curve | None] = []
    cuts = [[0.0, 0.0] for _ in pieces]
    for index, corner in enumerate(corners):
        before, after = pieces[index - 1], pieces[index]
        turn = turn_between(before, after)
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
            faults.append(too_short(index, corners[index], left))
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
            faults.append(too_short(index, corner, left))
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
                if distance(one.centre, pocket.centre) < one.radius + pocket.radius
            ),
            None,
        )
        if near is not None or other is not None:
            what = f"cushion {near}" if near is not None else f"pocket {other}"
            message = f"the drop of pocket {pocket.id} reaches {what}"
            mend = "a smaller radius of the drop, or more room"
            faults.append(Fault("pocket", places[pocket.id], message, mend))


__all__ = ["Corner", "Fault", "OutlineError", "box_of", "build_outline"]
