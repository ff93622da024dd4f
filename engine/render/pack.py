"""Meshes as few long arrays in the world's frame, which is what kernels eat.

One idea: a mesh is packed in its own frame once and carried to its place.
Invariant: the order of parts and faces follows the order of what was packed.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from engine.render.arrays import Bytes, Flags, Floats, Ints, Singles
    from engine.scene.shape import Mesh

KINDS = {"hull": 0, "shell": 1, "sheet": 2}


@dataclass(frozen=True, slots=True, eq=False)
class Pack:
    """Meshes in a row: points, triangles, faces, edges, and where each part begins.

    `starts` is (parts + 1, 4): first point, triangle, face and plane of every part; `part_edges`
    (parts + 1,) the first edge.
    `traits` is (parts, 2): kind and layer. `face_light` is (f, 2): gloss and alpha.
    """

    points: Floats
    normals: Singles
    triangles: Ints
    faces: Ints
    face_normals: Floats
    face_centres: Floats
    face_offsets: Floats
    face_colours: Bytes
    face_light: Singles
    face_smooth: Flags
    edges: Ints
    planes: Floats
    starts: Ints
    traits: Ints
    part_edges: Ints

    @property
    def parts(self) -> int:
        """Return the number of parts."""
        return len(self.traits)


def pack_mesh(mesh: Mesh) -> Pack:
    """Return one mesh as a pack, in its own frame."""
    normals = mesh.face_normals.astype(np.float64)
    centres = mesh.face_centres.astype(np.float64)
    count = len(normals)
    return Pack(
        points=mesh.positions.astype(np.float64),
        normals=mesh.normals,
        triangles=mesh.triangles,
        faces=mesh.faces,
        face_normals=normals,
        face_centres=centres,
        face_offsets=(normals * centres).sum(axis=1),
        face_colours=mesh.colours,
        face_light=np.tile(np.array([[mesh.gloss, mesh.alpha]], dtype=np.float32), (count, 1)),
        face_smooth=np.full(count, mesh.smooth),
        edges=mesh.edges,
        planes=mesh.planes,
        starts=np.array(
            [[0, 0, 0, 0], [len(mesh.positions), len(mesh.triangles), count, len(mesh.planes)]],
            dtype=np.int32,
        ),
        traits=np.array([[KINDS[mesh.kind], mesh.layer]], dtype=np.int32),
        part_edges=np.array([0, len(mesh.edges)], dtype=np.int32),
    )


def carry(pack: Pack, rotation: Floats, position: Floats) -> Pack:
    """Return a pack turned and moved to its place."""
    turned = pack.face_normals @ rotation.T
    centres = pack.face_centres @ rotation.T + position
    planes = pack.planes.copy()
    planes[:, :3] = pack.planes[:, :3] @ rotation.T
    planes[:, 3] += planes[:, :3] @ position
    return replace(
        pack,
        points=np.ascontiguousarray(pack.points @ rotation.T + position),
        normals=np.ascontiguousarray((pack.normals @ rotation.T).astype(np.float32)),
        face_normals=np.ascontiguousarray(turned),
        face_centres=np.ascontiguousarray(centres),
        face_offsets=(turned * centres).sum(axis=1),
        planes=planes,
    )


def join(packs: list[Pack]) -> Pack:
    """Return packs as one, their numbers of points and faces shifted."""
    if len(packs) == 1:
        return packs[0]
    shifts = np.zeros(4, dtype=np.int32)
    triangles, faces, edges = [], [], []
    starts = [np.zeros((1, 4), dtype=np.int32)]
    for pack in packs:
        triangles.append(pack.triangles + shifts[0])
        faces.append(pack.faces + shifts[2])
        moved = pack.edges + np.array([shifts[0], shifts[0], shifts[2], shifts[2]], dtype=np.int32)
        edges.append(np.where(pack.edges < 0, pack.edges, moved).astype(np.int32))
        starts.append(pack.starts[1:] + shifts)
        shifts = shifts + pack.starts[-1]
    return Pack(
        points=np.concatenate([p.points for p in packs]),
        normals=np.concatenate([p.normals for p in packs]),
        triangles=np.concatenate(triangles),
        faces=np.concatenate(faces),
        face_normals=np.concatenate([p.face_normals for p in packs]),
        face_centres=np.concatenate([p.face_centres for p in packs]),
        face_offsets=np.concatenate([p.face_offsets for p in packs]),
        face_colours=np.concatenate([p.face_colours for p in packs]),
        face_light=np.concatenate([p.face_light for p in packs]),
        face_smooth=np.concatenate([p.face_smooth for p in packs]),
        edges=np.concatenate(edges),
        planes=np.concatenate([p.planes for p in packs]),
        starts=np.concatenate(starts),
        traits=np.concatenate([p.traits for p in packs]),
        part_edges=_run_on([p.part_edges for p in packs]),
    )


def empty_pack() -> Pack:
    """Return a pack of nothing."""
    return Pack(
        points=np.zeros((0, 3)),
        normals=np.zeros((0, 3), np.float32),
        triangles=np.zeros((0, 3), np.int32),
        faces=np.zeros(0, np.int32),
        face_normals=np.zeros((0, 3)),
        face_centres=np.zeros((0, 3)),
        face_offsets=np.zeros(0),
        face_colours=np.zeros((0, 3), np.uint8),
        face_light=np.zeros((0, 2), np.float32),
        face_smooth=np.zeros(0, np.bool_),
        edges=np.zeros((0, 4), np.int32),
        planes=np.zeros((0, 4)),
        starts=np.zeros((1, 4), np.int32),
        traits=np.zeros((0, 2), np.int32),
        part_edges=np.zeros(1, np.int32),
    )


def _run_on(starts: list[Ints]) -> Ints:
    """Return starts that go on where the ones before ended."""
    sizes = np.concatenate([np.diff(one) for one in starts])
    return np.concatenate([[0], np.cumsum(sizes)]).astype(np.int32)
