"""Spheres in a row, and the unit spheres of triangles that stand for them.

One idea: a sphere is as fine as it is large on the screen, in few steps, so that few kinds of unit
spheres are made, each once.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from engine.render.pack import Pack, carry, empty_pack, join, pack_mesh
from engine.scene.shape import sphere_mesh

if TYPE_CHECKING:
    from engine.render.arrays import Bytes, Floats, Ints, Longs, Singles
    from engine.render.view import View


@dataclass(frozen=True, slots=True, eq=False)
class Spheres:
    """Spheres in a row; `skins` is one flat array, `skin_places` (n, 2) offset and size there.

    A size of zero is a sphere without a skin.
    """

    centres: Floats
    rotations: Floats
    radii: Floats
    colours: Bytes
    gloss: Singles
    gradients: Ints
    skins: Bytes
    skin_places: Ints


def no_spheres() -> Spheres:
    """Return no spheres at all."""
    return Spheres(
        centres=np.zeros((0, 3)),
        rotations=np.zeros((0, 3, 3)),
        radii=np.zeros(0),
        colours=np.zeros((0, 3), np.uint8),
        gloss=np.zeros(0, np.float32),
        gradients=np.zeros(0, np.int32),
        skins=np.zeros(3, np.uint8),
        skin_places=np.zeros((0, 2), np.int32),
    )


def sphere_pack(
    unit: Pack, centre: Floats, rotation: Floats, radius: float, colour: Bytes, gloss: float
) -> Pack:
    """Return a sphere as a mesh: the unit sphere's pack in its place and size."""
    placed = carry(unit, rotation * radius, centre)
    normals = np.ascontiguousarray(unit.face_normals @ rotation.T)
    count = len(normals)
    return replace(
        placed,
        normals=unit.normals,
        face_normals=normals,
        face_offsets=(normals * placed.face_centres).sum(axis=1),
        face_colours=np.tile(colour, (count, 1)),
        face_light=np.tile(np.array([[gloss, 1.0]], dtype=np.float32), (count, 1)),
    )


LEAP = 4
"""Steps of latitude between two unit spheres; few kinds of them are kept."""


class UnitSpheres:
    """Unit spheres of `least` to `most` steps of latitude, finer for larger ones.

    A step is about `pixels_a_step` high on the screen; spheres differ by `leap` steps.
    """

    def __init__(
        self, pixels_a_step: float = 5.0, least: int = 6, most: int = 48, leap: int = LEAP
    ) -> None:
        self._pixels_a_step, self._least, self._most = pixels_a_step, least, most
        self._leap = leap
        self._numbers: dict[int, int] = {}
        self._kept: list[Pack] = []
        self._all: Pack | None = None

    def choose(self, spheres: Spheres, view: View) -> Longs:
        """Return for every sphere the number of the unit sphere that suits its size."""
        depths = np.maximum((spheres.centres - view.eye) @ view.basis[2], view.near)
        across = spheres.radii * view.focal / depths
        wanted = np.rint(across * np.pi / self._pixels_a_step)
        wanted = self._leap * np.ceil(wanted / self._leap)
        steps = np.clip(wanted, self._least, np.minimum(spheres.gradients, self._most))
        return np.array([self._number(k) for k in steps.astype(int).tolist()], dtype=np.int64)

    def one(self, number: int) -> Pack:
        """Return one unit sphere."""
        return self._kept[number]

    @property
    def together(self) -> Pack:
        """Return all unit spheres made so far as one pack; their numbers are its parts."""
        if self._all is None:
            self._all = join(self._kept) if self._kept else empty_pack()
        return self._all

    def _number(self, steps: int) -> int:
        if steps not in self._numbers:
            self._numbers[steps] = len(self._kept)
            self._kept.append(pack_mesh(sphere_mesh(steps)))
            self._all = None
        return self._numbers[steps]
