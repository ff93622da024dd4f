"""Posts that stand on the bed and the rims of holes in it.

One idea: a post is rubber under cloth with a wooden cap, round and convex, so one part.
"""

from __future__ import annotations

from math import cos, pi, sin
from typing import TYPE_CHECKING

import numpy as np

from engine.scene.shape import make_mesh
from engine.stage import plan
from engine.stage.bed import flat_sheet
from engine.stage.dimensions import LINER, RIM_STEPS
from engine.stage.marks import LIFT
from engine.table.region import is_hole, posts_of

if TYPE_CHECKING:
    from engine.scene.shape import Mesh, Rgb
    from engine.stage.dimensions import Frame
    from engine.table.furniture import Table

SIDES = 28
FOOT = 0.82
"""Radius of a post's foot and of its cap, in those of its nose."""


def build_posts(table: Table, frame: Frame, rubber: Rgb, wood: Rgb) -> list[Mesh]:
    """Return the posts: out from the foot to the nose, and in again to the cap; or upright."""
    turns = [2.0 * pi * k / SIDES for k in range(SIDES)]
    parts = []
    for post in posts_of(table):
        end = 1.0 if post.upright else FOOT
        levels = ((0.0, end), (frame.nose, 1.0), (frame.top, end))
        points = [
            (
                post.centre[0] + share * post.radius * cos(turn),
                post.centre[1] + share * post.radius * sin(turn),
                height,
            )
            for height, share in levels
            for turn in turns
        ]
        faces, colours = [], []
        for ring, colour in ((0, rubber), (SIDES, wood)):
            for k in range(SIDES):
                after = (k + 1) % SIDES
                faces.append((ring + k, ring + after, ring + SIDES + after, ring + SIDES + k))
                colours.append(colour)
        cap = tuple(range(2 * SIDES, 3 * SIDES))
        floor = [tuple(reversed(range(SIDES)))]
        parts.append(
            make_mesh(np.array(points), [*faces, cap], [*colours, wood], hidden=floor, gloss=0.2)
        )
    return parts


def build_hole_rims(table: Table, colour: Rgb) -> list[Mesh]:
    """Return the rims of the holes in the bed."""
    sheets = []
    for pocket in table.pockets:
        if not is_hole(pocket):
            continue
        near = plan.circle(pocket.centre, pocket.radius, RIM_STEPS)
        far = plan.circle(pocket.centre, pocket.radius + 0.5 * LINER, RIM_STEPS)
        ring = [[near[k - 1], far[k - 1], far[k], near[k]] for k in range(RIM_STEPS)]
        sheets.append(flat_sheet(ring, LIFT / 2.0, colour, layer=1))
    return sheets
