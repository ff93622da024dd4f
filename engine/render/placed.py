"""A pack as one camera sees it: its points on the screen and the shades of its faces."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from engine.render import raster, shading
from engine.render.groups import UNGROUPED, Groups

if TYPE_CHECKING:
    from engine.render.arrays import Floats, Ints, Pixels
    from engine.render.pack import Pack
    from engine.render.view import View


@dataclass(frozen=True, slots=True, eq=False)
class Placed:
    """`seen` (n, 3) are camera coordinates, `screen` (n, 3) pixels and 1/z, zero where too near.

    `shades` has a colour for every face, under one light where the face was lit.
    """

    pack: Pack
    groups: Groups
    seen: Floats
    screen: Floats
    shades: Pixels

    def box(self, size: tuple[int, int]) -> Ints:
        """Return the pixels that may be covered, (1, 4): first column, row, those after the last.

        Nothing at all gives (0, 4).
        """
        if not len(self.screen):
            return np.zeros((0, 4), np.int32)
        if (self.screen[:, 2] <= 0.0).any():
            return np.array([[0, 0, *size]], dtype=np.int32)
        low = np.clip(np.floor(self.screen[:, :2].min(axis=0)), 0, size)
        high = np.clip(np.ceil(self.screen[:, :2].max(axis=0)) + 1, 0, size)
        return np.array([[*low, *high]]).astype(np.int32)


def place(
    pack: Pack,
    view: View,
    lamps: Floats,
    ambient: float,
    groups: Groups = UNGROUPED,
    *,
    lit: bool,
) -> Placed:
    """Return a pack on the screen; where not `lit`, only tints have their shades."""
    seen, screen = np.zeros((len(pack.points), 3)), np.zeros((len(pack.points), 3))
    raster.project_points(pack.points, *view.numbers, seen, screen)
    shades = np.zeros(len(pack.face_normals), np.uint32)
    shading.shade_faces(
        pack.face_centres,
        pack.face_normals,
        pack.face_colours,
        pack.face_light,
        lit,
        view.eye,
        lamps,
        ambient,
        shades,
    )
    return Placed(pack, groups, seen, screen, shades)
