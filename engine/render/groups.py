"""Surfaces: triangles that lie in one plane and look alike, whatever meshes they are of.

One idea: a surface is known by its border alone. An edge between two of its triangles is walked in
either direction and cancels out; what is left is the border, and what lies between its crossings
with a row of pixels is one long span.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from engine.render.arrays import Ints, Longs
    from engine.render.pack import Pack

FINE = 1e6
"""Planes that differ by less than one part of this are one plane."""


@dataclass(frozen=True, slots=True, eq=False)
class Groups:
    """Surface k has triangles `order[starts[k]:starts[k + 1]]` and a border.

    The border is `edges[edge_starts[k]:edge_starts[k + 1]]`, (n, 2) points from and to; where there
    is none, its triangles stand for it.
    """

    order: Ints
    starts: Ints
    edges: Ints
    edge_starts: Ints


UNGROUPED = Groups(
    np.zeros(0, np.int32), np.zeros(1, np.int32), np.zeros((0, 2), np.int32), np.zeros(1, np.int32)
)
"""No surfaces, for who does not fill them."""


def by_face(pack: Pack) -> Groups:
    """Return a surface for every face, without borders: its triangles stand for it."""
    faces = pack.faces
    cuts = np.flatnonzero(np.diff(faces)) + 1
    starts = np.concatenate([[0], cuts, [len(faces)]] if len(faces) else [[0]]).astype(np.int32)
    order = np.arange(len(faces), dtype=np.int32)
    return Groups(order, starts, np.zeros((0, 2), np.int32), np.zeros_like(starts))


def by_surface(pack: Pack) -> Groups:
    """Return a surface for all faces of one plane, colour and gloss, in the order they begin.

    A smooth face is a surface of its own, since its light does not follow from its plane.
    """
    count = len(pack.face_normals)
    if not count:
        return by_face(pack)
    look = np.concatenate(
        [
            np.rint(pack.face_normals * FINE),
            np.rint(pack.face_offsets[:, None] * FINE),
            pack.face_colours.astype(np.float64),
            np.rint(pack.face_light * FINE),
            np.where(pack.face_smooth, np.arange(count) + 1.0, 0.0)[:, None],
        ],
        axis=1,
    )
    _, first, group = np.unique(look, axis=0, return_index=True, return_inverse=True)
    rank = np.argsort(np.argsort(first))[group.reshape(-1)]
    _, kept, same = np.unique(pack.points, axis=0, return_index=True, return_inverse=True)
    return _gather(pack, rank[pack.faces], kept[same.reshape(-1)])


def _gather(pack: Pack, group: Longs, points: Longs) -> Groups:
    """Return the surfaces of triangles by their `group`; `points` says which are the same."""
    order = np.argsort(group, kind="stable")
    border, owner = _borders(points[pack.triangles], group)
    numbers = np.unique(group)
    return Groups(
        order.astype(np.int32),
        _ends(group[order], numbers),
        border.astype(np.int32),
        _ends(owner, numbers),
    )


def _borders(triangles: Longs, group: Longs) -> tuple[Longs, Longs]:
    """Return the edges that no other triangle of a group walks the other way, and their groups."""
    edges = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    owner = np.repeat(group, 3)
    low, high = edges.min(axis=1), edges.max(axis=1)
    way = np.where(edges[:, 0] < edges[:, 1], 1, -1)
    order = np.lexsort((high, low, owner))
    key = np.stack([owner, low, high], axis=1)[order]
    first = np.concatenate([[True], (key[1:] != key[:-1]).any(axis=1)])
    which = np.cumsum(first) - 1
    total = np.bincount(which, weights=way[order]).astype(np.int64)
    key = key[np.flatnonzero(first)]
    key, total = np.repeat(key, np.abs(total), axis=0), np.repeat(total, np.abs(total))
    border = np.where((total > 0)[:, None], key[:, 1:], key[:, :0:-1])
    return border, key[:, 0]


def _ends(sorted_groups: Longs, numbers: Longs) -> Ints:
    """Return where each group begins in a sorted row of them, and where the last ends."""
    begins = np.searchsorted(sorted_groups, numbers)
    return np.concatenate([begins, [len(sorted_groups)]]).astype(np.int32)
