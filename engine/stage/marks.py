"""What lies flat: spots, lines, arcs, sights, zones, and aids to aiming."""

from __future__ import annotations

from math import cos, hypot, inf, pi, sin
from typing import TYPE_CHECKING

import numpy as np

from engine.scene.shape import Disc as FlatDisc
from engine.scene.shape import Mesh, Polyline
from engine.stage import plan
from engine.stage.bed import flat_sheet
from engine.stage.region import clip, convex_pieces, stations
from engine.table.furniture import Area, Disc, HalfPlane, Straight
from engine.table.mouth import length_of, point_along
from engine.table.region import on_bed

if TYPE_CHECKING:
    from collections.abc import Sequence

    from engine.scene.shape import Rgb
    from engine.stage.dimensions import Frame
    from engine.table.furniture import Line, Point, Table, Zone

LIFT = 0.0004
"""Height of what is painted on the cloth, m."""
LINE_WIDTH = 0.0035
PAINT = 0.7
"""How much a line on the cloth covers."""
SPOT_RADIUS = 0.0065
ARC_STEPS = 48
LINE_STEPS = 200
LONG_SIDE = 0.5
"""A straight side of an outline has sights from this length on, m."""
GLEAM: Rgb = (235, 245, 235)


def build_lines(table: Table, colour: Rgb) -> tuple[Polyline, ...]:
    """Return the lines across the bed, and the arcs of zones with a round border."""
    straight = [
        flat_path(run, colour, alpha=PAINT)
        for line in table.lines.values()
        if line.drawn
        for run in _line_runs(line, table)
    ]
    round_zones = [
        (part, zone)
        for zone in table.zones.values()
        if isinstance(zone, Area)
        for part in zone.parts
        if isinstance(part, Disc)
    ]
    seen: set[tuple[Point, float]] = set()
    arcs = []
    for disc, zone in round_zones:
        if (disc.centre, disc.radius) not in seen:
            seen.add((disc.centre, disc.radius))
            arcs += [flat_path(run, colour, alpha=PAINT) for run in _arc_runs(disc, zone, table)]
    return (*straight, *arcs)


def _line_runs(line: Line, table: Table) -> list[list[Point]]:
    """Return the runs of a line that lie on the bed; on a rectangle it is whole."""
    (ax, ay), (bx, by) = line.start, line.end
    if not table.outline:
        return [[line.start, line.end]]
    steps = [k / LINE_STEPS for k in range(LINE_STEPS + 1)]
    runs: list[list[Point]] = [[]]
    for share in steps:
        point = ax + share * (bx - ax), ay + share * (by - ay)
        if on_bed(table, point, 1e-6):
            runs[-1] = [*runs[-1][:1], point]
        elif runs[-1]:
            runs.append([])
    return [run for run in runs if len(run) > 1]


def _arc_runs(disc: Disc, zone: Area, table: Table) -> list[list[Point]]:
    """Return the runs of a disc's rim that lie in the rest of its zone and on the bed."""
    turns = [2.0 * pi * k / ARC_STEPS for k in range(ARC_STEPS + 1)]
    x, y, r = *disc.centre, disc.radius
    runs: list[list[Point]] = [[]]
    for turn in turns:
        point = x + r * cos(turn), y + r * sin(turn)
        if on_bed(table, point) and all(
            _holds(part, point) for part in zone.parts if part is not disc
        ):
            runs[-1].append(point)
        elif runs[-1]:
            runs.append([])
    runs = [run for run in runs if len(run) > 1]
    if (
        len(runs) > 1
        and runs[0][0] == (x + r, y)
        and hypot(runs[-1][-1][0] - x - r, runs[-1][-1][1] - y) < 1e-9
    ):
        runs[0] = [*runs.pop(), *runs[0][1:]]
    return runs


def _holds(part: HalfPlane | Disc, point: Point) -> bool:
    if isinstance(part, Disc):
        away = hypot(point[0] - part.centre[0], point[1] - part.centre[1])
        return away <= part.radius + 1e-9
    way = (point[0] - part.point[0]) * part.normal[0] + (point[1] - part.point[1]) * part.normal[1]
    return way >= -1e-9


def flat_path(
    points: Sequence[Point],
    colour: Rgb,
    width: float = LINE_WIDTH,
    alpha: float = 1.0,
    height: float = LIFT,
) -> Polyline:
    """Return a line on the cloth through `points` (m)."""
    placed = np.array([(x, y, height) for x, y in points], dtype=np.float32)
    return Polyline(placed, colour, width, alpha)


def flat_ring(centre: Point, radius: float, colour: Rgb, width: float = LINE_WIDTH) -> Polyline:
    """Return a ring on the cloth, such as where a ball would stand."""
    rim = plan.circle(centre, radius, 32)
    return flat_path([*rim, rim[0]], colour, width)


def build_gleam(table: Table) -> tuple[Polyline, ...]:
    """Return the light along the cushions' noses."""
    return tuple(
        flat_path(
            plan.trace_shapes(cushion.shapes, 0.1), GLEAM, 0.002, 0.2, table.nose_height + LIFT
        )
        for cushion in table.cushions
    )


def build_spots(table: Table, colour: Rgb) -> tuple[FlatDisc, ...]:
    """Return the spots that are marked on the cloth."""
    places = sorted(set(table.spots.values()))
    return tuple(
        FlatDisc((x, y, LIFT), SPOT_RADIUS, colour, 0.9, 0.15 * SPOT_RADIUS) for x, y in places
    )


def build_sights(table: Table, frame: Frame, colour: Rgb) -> list[Mesh]:
    """Return the sights on the wood: eighths of the long rails, quarters of the short ones."""
    if table.outline:
        return _outline_sights(table, frame, colour)
    wide, high = 0.011, 0.006
    sheets = []
    for axis, parts in ((0, 8), (1, 4)):
        span = (table.length, table.width)[axis]
        rail = 1 - axis
        middle = (frame.inner[rail] + frame.outer[rail]) / 2.0
        for step in range(1, parts):
            for hand in (-1.0, 1.0):
                place = -span / 2.0 + span * step / parts
                x, y = (place, hand * middle) if axis == 0 else (hand * middle, place)
                if any(hypot(x - p.centre[0], y - p.centre[1]) < 0.15 for p in table.pockets):
                    continue
                dx, dy = (high, wide) if axis == 0 else (wide, high)
                rhomb = [(x + dx, y), (x, y + dy), (x - dx, y), (x, y - dy)]
                sheets.append(flat_sheet([rhomb], frame.top + 0.0006, colour, layer=2))
    return sheets


def _outline_sights(table: Table, frame: Frame, colour: Rgb) -> list[Mesh]:
    """Return the sights on the wood of an outline: quarters of each long straight side."""
    back = (frame.cushion_depth + frame.rail) / 2.0
    sheets = []
    for shape in table.outline:
        if not isinstance(shape, Straight) or length_of(shape) < LONG_SIDE:
            continue
        for quarter in (0.25, 0.5, 0.75):
            (x, y), (u, v) = point_along(shape, quarter * length_of(shape))
            x, y = x + back * v, y - back * u
            if any(hypot(x - p.centre[0], y - p.centre[1]) < 0.15 for p in table.pockets):
                continue
            ways = ((0.011 * u, 0.011 * v), (-0.006 * v, 0.006 * u))
            rhomb = [(x + s * a, y + s * b) for s in (1.0, -1.0) for a, b in ways]
            sheets.append(flat_sheet([rhomb], frame.top + 0.0006, colour, layer=2))
    return sheets


def tint_zone(zone: Zone, table: Table, colour: Rgb, alpha: float = 0.28) -> Mesh | None:
    """Return a tint over an area of the bed, or None where nothing of it is on the bed."""
    if not isinstance(zone, Area):
        return None
    x, y = table.length / 2.0, table.width / 2.0
    whole = [plan.rectangle(-x, -y, x, y)]
    if table.outline:
        whole = convex_pieces([place.point for place in stations(table.outline, longest=inf)])
    polygons = [polygon for part in whole if (polygon := _zone_of(zone, part))]
    if not polygons:
        return None
    return flat_sheet(polygons, LIFT / 2.0, colour, layer=1, alpha=alpha)


def _zone_of(zone: Area, polygon: plan.Polygon) -> plan.Polygon:
    """Return what of a convex polygon lies in an area."""
    for part in zone.parts:
        if isinstance(part, Disc):
            polygon = clip(polygon, plan.circle(part.centre, part.radius, ARC_STEPS))
        else:
            polygon = polygon and plan.cut(polygon, part.point, (-part.normal[0], -part.normal[1]))
    return polygon
