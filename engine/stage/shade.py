"""What lies in the cushions' shade: tints on the cloth along their feet, dark round posts.

One idea: strips of growing reach lie over one another, so that the shade fades; along the jaws
they narrow to nothing, as the cushion does not end there but turns away.
"""

from __future__ import annotations

import itertools
from math import hypot
from typing import TYPE_CHECKING

from engine.scene.shape import Disc
from engine.stage import plan
from engine.stage.bed import flat_sheet
from engine.stage.marks import LIFT
from engine.table.region import posts_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from engine.scene.shape import Mesh, Rgb
    from engine.table.furniture import Point, Table

SHADE: Rgb = (0, 0, 0)
SHADE_REACH = (0.006, 0.012, 0.019, 0.027)
DARK = 0.09
"""How much each strip darkens."""
POST_REACH = 0.03
"""How far the dark round a post goes, m."""


def build_shade(table: Table) -> list[Mesh]:
    """Return tints on the cloth along the cushions' feet: strips, each wider than the last."""
    standing = {post.id for post in posts_of(table)}
    lines = [
        _with_jaws(table, plan.trace_shapes(cushion.shapes, 0.1))
        for cushion in table.cushions
        if cushion.id not in standing
    ]
    return [
        flat_sheet(
            [strip for line in lines for strip in _strips(line, reach)],
            LIFT / 2.0,
            SHADE,
            layer=1,
            alpha=DARK,
        )
        for reach in SHADE_REACH
    ]


def _with_jaws(table: Table, nose: list[Point]) -> list[tuple[Point, float]]:
    """Return the places along a nose and its jaws, with the share of the reach there."""
    before: list[tuple[Point, float]] = []
    after: list[tuple[Point, float]] = []
    for jaw in table.jaws:
        points = plan.trace_shapes(jaw.shapes, 0.5)
        shares = [k / (len(points) - 1) for k in range(len(points))]
        if _same(points[-1], nose[0]):
            before = list(zip(points, shares, strict=True))[:-1]
        elif _same(points[0], nose[-1]):
            after = list(zip(points, reversed(shares), strict=True))[1:]
    return [*before, *((point, 1.0) for point in nose), *after]


def _same(a: Point, b: Point) -> bool:
    return hypot(a[0] - b[0], a[1] - b[1]) < 1e-6


def _strips(line: list[tuple[Point, float]], reach: float) -> list[plan.Polygon]:
    points = [point for point, _ in line]
    under = -0.012 if len(points) == 2 else -0.02
    edges = []
    for k, ((x, y), share) in enumerate(line):
        u, v = _inward(points, k)
        far = share * reach
        edges.append(((x + under * u, y + under * v), (x + far * u, y + far * v)))
    return [[a, b, d, c] for (a, c), (b, d) in itertools.pairwise(edges)]


def _inward(points: Sequence[Point], k: int) -> Point:
    """Return the unit way from a point of a nose into the bed, shared by its two pieces."""
    x, y = 0.0, 0.0
    for a, b in itertools.pairwise(points[max(k - 1, 0) : k + 2]):
        size = hypot(b[0] - a[0], b[1] - a[1])
        x, y = x + (a[1] - b[1]) / size, y + (b[0] - a[0]) / size
    size = hypot(x, y)
    return x / size, y / size


def shade_posts(table: Table) -> tuple[Disc, ...]:
    """Return the soft dark round the foot of every post."""
    return tuple(
        Disc((*post.centre, LIFT), post.radius + POST_REACH, SHADE, 0.4, POST_REACH)
        for post in posts_of(table)
    )
