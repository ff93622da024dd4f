"""The strokes of a frame: lines and edges on the screen, in the order drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from engine.render import edge_kernels, line_kernels
from engine.render.view import View

if TYPE_CHECKING:
    from engine.render.arrays import Floats, Longs, Pixels, Singles
    from engine.render.image import Target
    from engine.render.lines import Lines
    from engine.render.pack import Pack
    from engine.render.spheres import Spheres

NO_DEPTH = np.zeros((1, 1), np.float32)


class Strokes:
    """The strokes of a frame, in the order drawn."""

    def __init__(self) -> None:
        self.count = 0
        self._lines: Floats = np.zeros((1024, line_kernels.FIELDS))
        self._shades: Pixels = np.zeros(1024, np.uint32)
        self._view = View(np.zeros(3), np.eye(3), 1.0, 0.02, (1, 1))

    def begin(self, view: View) -> None:
        """Begin a new frame."""
        self.count, self._view = 0, view

    def add_mesh(self, pack: Pack) -> None:
        """Add the edges of a pack that are turned to the eye."""
        self._make_room(len(pack.edges))
        view = self._view
        self.count = edge_kernels.mesh_strokes(
            pack.points,
            pack.edges,
            pack.face_normals,
            pack.face_offsets,
            pack.face_colours,
            pack.face_light,
            *view.numbers,
            self._lines,
            self._shades,
            self.count,
        )

    def add_lines(self, lines: Lines) -> None:
        """Add segments."""
        self._make_room(len(lines))
        self.count = line_kernels.place_segments(
            lines.ends,
            lines.colours,
            lines.widths,
            lines.alphas,
            *self._view.numbers,
            self._lines,
            self._shades,
            self.count,
        )

    def add_spheres(self, spheres: Spheres, steps: Longs, units: Pack) -> None:
        """Add spheres, far ones first, so that near strokes lie on top."""
        starts = units.part_edges
        self._make_room(int((starts[steps + 1] - starts[steps]).sum()))
        away = ((spheres.centres - self._view.eye) ** 2).sum(axis=1)
        self.count = edge_kernels.sphere_strokes(
            np.argsort(-away, kind="stable"),
            steps,
            np.stack([units.starts[:, 0], starts], axis=1),
            units.points,
            units.edges,
            units.face_normals,
            units.face_offsets,
            spheres.centres,
            spheres.rotations,
            spheres.radii,
            spheres.colours,
            spheres.skins,
            spheres.skin_places,
            *self._view.numbers,
            self._lines,
            self._shades,
            self.count,
        )

    def draw(
        self,
        target: Target,
        top: int,
        bottom: int,
        first: int,
        last: int,
        least: float,
        depth: Singles | None = None,
    ) -> None:
        """Draw strokes first to last in a band of rows, `least` pixels wide at least.

        With `depth` (1/z), only what is not behind it.
        """
        line_kernels.draw_strokes(
            target.rows,
            target.width,
            NO_DEPTH if depth is None else depth,
            depth is not None,
            top,
            bottom,
            self._lines,
            self._shades,
            first,
            last,
            least,
        )

    def _make_room(self, more: int) -> None:
        wanted = self.count + more + 1
        if wanted > len(self._lines):
            room = 2 * wanted - len(self._lines)
            self._lines = np.concatenate([self._lines, np.zeros((room, line_kernels.FIELDS))])
            self._shades = np.concatenate([self._shades, np.zeros(room, np.uint32)])
