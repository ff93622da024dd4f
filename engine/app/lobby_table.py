"""A table from above, as a plan: rails, cloth, pockets, lines and the balls as they start.

One idea: it is drawn from the variant's own shapes by circles and polygons alone, so that no
renderer has to be ready. Invariant: the whole table fits its box, true to scale.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import pygame

from engine.app.theme import CHALK
from engine.stage.plan import trace_shapes
from engine.variant.rack import lay_rack

if TYPE_CHECKING:
    from engine.app.screen import Box
    from engine.table.furniture import Point
    from engine.variant.variant import BallKind, Variant

STEP = 0.01
"""Metres between the points of a curve."""


@dataclass(frozen=True, slots=True)
class Plan:
    """Metres to pixels: the middle of the box and pixels a metre."""

    middle: tuple[float, float]
    scale: float

    def at(self, point: Point) -> tuple[int, int]:
        """Return a point of the table as a pixel."""
        x, y = point
        return round(self.middle[0] + self.scale * x), round(self.middle[1] - self.scale * y)

    def px(self, length: float) -> int:
        """Return a length (m) in pixels, at least one."""
        return max(1, round(self.scale * length))


def draw_table(surface: pygame.Surface, variant: Variant, box: Box) -> int:
    """Draw a variant's table with its rack at the top of a box (pixels); return its height."""
    table, look = variant.world.table, variant.look
    wide, high = table.length + 2.0 * table.rail_width, table.width + 2.0 * table.rail_width
    scale = min(box[2] / wide, box[3] / high)
    plan = Plan((box[0] + box[2] / 2.0, box[1] + scale * high / 2.0), scale)
    corner = plan.at((-wide / 2.0, high / 2.0))
    frame = (*corner, plan.px(wide), plan.px(high))
    pygame.draw.rect(surface, look.rail, frame, border_radius=plan.px(0.06))
    _draw_bed(surface, variant, plan)
    for pocket in table.pockets:
        pygame.draw.circle(surface, look.pocket, plan.at(pocket.centre), plan.px(pocket.radius))
    line = tuple((2 * part + other) // 3 for part, other in zip(look.cloth, CHALK, strict=True))
    for mark in table.lines.values():
        if mark.drawn:
            pygame.draw.line(surface, line, plan.at(mark.start), plan.at(mark.end))
    for pin in table.pins:
        pygame.draw.circle(
            surface, CHALK, plan.at(pin.at), max(2, plan.px(max(r for _, r in pin.profile)))
        )
    radii = {ball.id: ball.radius for ball in variant.world.balls}
    kinds = {kind.id: kind for kind in variant.balls}
    edge = tuple(part // 3 for part in look.cloth)
    for ball, place in lay_rack(variant.rack, 1).items():
        at, radius = plan.at(place), max(2, plan.px(radii[ball]))
        _draw_ball(surface, kinds[ball], at, radius)
        pygame.draw.circle(surface, edge, at, radius, 1)
    return frame[3]


def _draw_bed(surface: pygame.Surface, variant: Variant, plan: Plan) -> None:
    table = variant.world.table
    if table.outline:
        corners = [plan.at(point) for point in trace_shapes(table.outline, STEP)]
        pygame.draw.polygon(surface, variant.look.cloth, corners)
        return
    corner = plan.at((-table.length / 2.0, table.width / 2.0))
    bed = (*corner, plan.px(table.length), plan.px(table.width))
    pygame.draw.rect(surface, variant.look.cloth, bed)


def _draw_ball(
    surface: pygame.Surface, kind: BallKind, place: tuple[int, int], radius: int
) -> None:
    if kind.pattern == "stripe":
        pygame.draw.circle(surface, CHALK, place, radius)
        band = (place[0] - radius, place[1] - radius // 2, 2 * radius, radius)
        pygame.draw.rect(surface, kind.colour, band, border_radius=radius // 2)
    else:
        pygame.draw.circle(surface, kind.colour, place, radius)
