"""A frame of the painter's in arrays: parts and spheres placed on the screen, each face's light."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from engine.render import painter_kernels
from engine.render.placed import Placed, place

if TYPE_CHECKING:
    from engine.render.arrays import Floats, Ints, Longs, Pixels
    from engine.render.pack import Pack
    from engine.render.spheres import Spheres
    from engine.render.view import View


@dataclass(frozen=True, slots=True, eq=False)
class Work:
    """What there is to paint.

    Items are numbered parts first, then spheres. `units` says which of the unit spheres each sphere
    is painted by; `ball_starts` (n, 2) where its corners and faces begin in `ball_screen` and
    `ball_light`.
    """

    view: View
    placed: Placed
    spheres: Spheres
    units: Longs
    unit_pack: Pack
    ball_starts: Longs
    ball_screen: Floats
    ball_light: Floats

    def paint(
        self,
        image: Pixels,
        rows: tuple[int, int],
        items: Ints,
        *,
        after: int = 0,
        whole: bool = False,
        boxes: Floats | None = None,
        shades: Pixels | None = None,
    ) -> None:
        """Paint items in their order in a band of rows (see `painter_kernels.paint_items`)."""
        placed, unit, s = self.placed, self.unit_pack, self.spheres
        pack = placed.pack
        painter_kernels.paint_items(
            image,
            rows[0],
            rows[1],
            items,
            after,
            whole,
            NO_BOXES if boxes is None else boxes,
            placed.seen,
            placed.screen,
            pack.starts,
            pack.triangles,
            pack.faces,
            pack.face_normals,
            pack.face_offsets,
            pack.face_light,
            placed.shades if shades is None else shades,
            self.units,
            unit.starts,
            unit.triangles,
            unit.faces,
            unit.points,
            self.ball_starts,
            self.ball_screen,
            self.ball_light,
            s.centres,
            s.radii,
            s.colours,
            s.skins,
            s.skin_places,
            *self.view.numbers,
        )


NO_BOXES = np.zeros((0, 4))


def make_work(
    pack: Pack,
    spheres: Spheres,
    units: Longs,
    unit_pack: Pack,
    view: View,
    lamps: Floats,
    ambient: float,
) -> Work:
    """Place parts and spheres on the screen and light their faces."""
    placed = place(pack, view, lamps, ambient, lit=True)
    starts, counts = _places(units, unit_pack)
    corners, light = np.zeros((counts[0], 2)), np.zeros((counts[1], 3))
    painter_kernels.place_spheres(
        units,
        unit_pack.starts,
        unit_pack.points,
        unit_pack.face_normals,
        unit_pack.face_centres,
        spheres.centres,
        spheres.rotations,
        spheres.radii,
        spheres.gloss,
        lamps,
        ambient,
        *view.numbers,
        starts,
        corners,
        light,
    )
    return Work(
        view=view,
        placed=placed,
        spheres=spheres,
        units=units,
        unit_pack=unit_pack,
        ball_starts=starts,
        ball_screen=corners,
        ball_light=light,
    )


def _places(units: Longs, unit_pack: Pack) -> tuple[Longs, tuple[int, int]]:
    """Return where each sphere's corners and faces begin, and how many there are of both."""
    sizes = np.diff(unit_pack.starts[:, [0, 2]].astype(np.int64), axis=0)[units]
    ends = np.concatenate([np.zeros((1, 2), np.int64), np.cumsum(sizes, axis=0)])
    return ends[:-1], (int(ends[-1, 0]), int(ends[-1, 1]))
