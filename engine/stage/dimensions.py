"""The measures of a table's picture that its furniture leaves open, all in m.

One idea: they follow from the table; what no rule gives is chosen once, here.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from engine.stage.region import stations
from engine.table.region import distance_to, is_hole

if TYPE_CHECKING:
    from engine.table.furniture import Table

RIM_STEPS = 28
"""Corners of a pocket's rim."""
LINER = 0.012
"""Width of the dark liner round a pocket."""
DEPTH = 0.105
"""Depth of a pocket below the bed."""
APRON = 0.11
"""How far the wood hangs below the bed."""


@dataclass(frozen=True, slots=True)
class Frame:
    """Half sizes of the rectangle behind the cushions and of the outer one, and heights."""

    inner: tuple[float, float]
    outer: tuple[float, float]
    cushion_depth: float
    rail: float
    nose: float
    top: float


def measure(table: Table) -> Frame:
    """Return the frame of a table; the wood is as wide as its pockets need."""
    depth = min(0.05, 0.45 * table.rail_width)
    if table.outline:
        return _measure_outline(table, depth)
    half = table.length / 2.0, table.width / 2.0
    reach = [
        max(abs(p.centre[axis]) + p.radius + 2.0 * LINER - half[axis] for p in table.pockets)
        if table.pockets
        else 0.0
        for axis in (0, 1)
    ]
    rail = max(table.rail_width, *reach)
    return Frame(
        inner=(half[0] + depth, half[1] + depth),
        outer=(half[0] + rail, half[1] + rail),
        cushion_depth=depth,
        rail=rail,
        nose=table.nose_height,
        top=table.nose_height + 0.007,
    )


def _measure_outline(table: Table, depth: float) -> Frame:
    """Return the frame about an outline: the boxes behind its cushions and about its wood."""
    places_of = stations(table.outline)
    rail = table.rail_width
    for pocket in table.pockets:
        if not is_hole(pocket):
            near = min(distance_to(shape, pocket.centre) for shape in table.outline)
            rail = max(rail, near + pocket.radius + 2.0 * LINER)
    boxes = []
    for reach in (depth, rail):
        places = [one.behind(reach) for one in places_of]
        boxes.append((max(abs(x) for x, _ in places), max(abs(y) for _, y in places)))
    return Frame(
        inner=boxes[0],
        outer=boxes[1],
        cushion_depth=depth,
        rail=rail,
        nose=table.nose_height,
        top=table.nose_height + 0.007,
    )
