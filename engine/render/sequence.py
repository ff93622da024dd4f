"""The order in which the painter's renderer takes a frame's things."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from engine.render import order, outline

if TYPE_CHECKING:
    from engine.render.arrays import Flags, Floats, Ints, Longs
    from engine.render.pack import Pack
    from engine.render.work import Work

SUNK = 0.98
"""A sphere whose centre is lower than this share of its radius drops into the ground."""


@dataclass(frozen=True, slots=True, eq=False)
class Sequence:
    """What is painted when: `below` are the parts of layers 0 and 1, `items` what stands there.

    `dropping` are spheres that sink into the ground; `boxes` (n, 4) what each item covers on the
    screen; `broken` how many circles in the order had to be broken.
    """

    below: tuple[Ints, Ints]
    dropping: Ints
    items: Ints
    boxes: Floats
    broken: int


def planes_between(pack: Pack) -> Floats:
    """Return the plane between every two parts, (p, p, 4), the first of the pair below."""
    table = np.zeros((pack.parts, pack.parts, 4))
    order.plane_table(pack.points, pack.planes, pack.starts, pack.traits, pack.face_normals, table)
    return table


def put_in_order(work: Work, fixed: int, table: Floats, *, only_fixed: bool = False) -> Sequence:
    """Return the order of a frame's things; `table` has the planes between the `fixed` parts."""
    pack, s, view = work.placed.pack, work.spheres, work.view
    parts = pack.parts
    boxes, outlines, spans, shown = _outlines(work)
    layers = pack.traits[:, 1]
    dropping = np.flatnonzero(s.centres[:, 2] < SUNK * s.radii).astype(np.int32) + parts
    wide, tall = view.size
    inside = (boxes[:, 2] > 0.0) & (boxes[:, 0] < wide) & (boxes[:, 3] > 0.0) & (boxes[:, 1] < tall)
    standing = np.concatenate([shown & (layers > 1), s.centres[:, 2] > 0.0]) & inside
    chosen = np.flatnonzero(standing).astype(np.int32)
    if only_fixed:
        chosen = chosen[chosen < fixed]
    middles = pack.points[pack.starts[:-1, 0]]
    far = ((np.concatenate([middles, s.centres]) - view.eye) ** 2).sum(axis=1)
    below = [np.flatnonzero(shown & (layers == k)).astype(np.int32) for k in (0, 1)]
    below[0] = below[0][np.lexsort((-far[below[0]], middles[below[0], 2]))]
    items = np.zeros(len(chosen), np.int32)
    broken = order.sort_items(
        chosen,
        boxes,
        outlines,
        spans,
        far,
        fixed,
        pack.points,
        pack.planes,
        pack.starts,
        pack.traits,
        pack.face_normals,
        table,
        s.centres,
        view.eye,
        items,
    )
    return Sequence((below[0], below[1]), dropping, items, boxes, broken)


def _outlines(work: Work) -> tuple[Floats, Floats, Longs, Flags]:
    """Return boxes and outlines of all items on the screen, and which parts are shown."""
    pack, s, view = work.placed.pack, work.spheres, work.view
    count = pack.parts + len(s.radii)
    boxes, spans = np.zeros((count, 4)), np.zeros(count + 1, np.int64)
    room = 4 * len(pack.triangles) + (outline.ROUND + 4) * len(s.radii) + 8
    outlines, shown = np.zeros((room, 2)), np.zeros(pack.parts, np.bool_)
    wide, tall = float(view.size[0]), float(view.size[1])
    outline.part_outlines(
        work.placed.seen,
        work.placed.screen,
        pack.triangles,
        pack.faces,
        pack.face_normals,
        pack.face_offsets,
        pack.starts,
        pack.traits,
        view.eye,
        view.focal,
        view.near,
        wide,
        tall,
        boxes,
        outlines,
        spans,
        shown,
    )
    outline.sphere_outlines(pack.parts, s.centres, s.radii, *view.numbers, boxes, outlines, spans)
    return boxes, outlines, spans, shown
