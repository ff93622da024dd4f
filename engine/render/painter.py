"""The painter's algorithm: what is far is painted first, what hides it over it.

One idea: not triangles but convex parts are put in order, by the planes between them (see
`engine.render.order`); within a part no front face hides another.
Invariant: parts of a lower layer are painted before those of a higher one: pockets, then the
bed with its marks and shadows, then what stands on it.
"""

from __future__ import annotations

import itertools
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING

import numpy as np

from engine.render import line_kernels, order, outline, painter_kernels, raster, shading
from engine.render.image import Canvas, Picture
from engine.render.pack import Pack, Packer, UnitSpheres, View, join, lines_of, view_of
from engine.render.scanline import discs_of, lamps_of, shade_background
from engine.render.warm import tiny_scene

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from engine.render.image import Pixels
    from engine.scene.scene import Scene

NO_DEPTH = np.zeros((1, 1), np.float32)
LEAST_LINE = 1.1


class Painter:
    """The renderer without depth; `threads` bands of rows are painted at the same time."""

    def __init__(self, threads: int = 2) -> None:
        self._packer = Packer()
        self._canvas = Canvas()
        self._threads = max(1, threads)
        self._pool = ThreadPoolExecutor(self._threads) if self._threads > 1 else None
        self._fixed: Pack | None = None
        self._table = np.zeros((0, 0, 4))
        self._units = UnitSpheres()

    def warm_up(self, progress: Callable[[str, float], None] | None = None) -> None:
        """Compile or load the kernels; `progress` hears what is done and the share of it."""
        if progress:
            progress("painter", 0.1)
        self.render(tiny_scene(), np.zeros((16, 16), np.uint32))
        self._units.make_all()
        if progress:
            progress("painter", 1.0)

    def render(self, scene: Scene, image: Picture) -> None:
        """Draw a scene into a picture."""
        pixels = self._canvas.open(image)
        view = view_of(scene.camera, (pixels.shape[1], pixels.shape[0]))
        fixed = self._packer.fixed(scene)
        if fixed is not self._fixed:
            self._fixed = fixed
            self._table = np.zeros((fixed.parts, fixed.parts, 4))
            order.plane_table(
                fixed.points,
                fixed.planes,
                fixed.starts,
                fixed.traits,
                fixed.face_normals,
                self._table,
            )
        moving = self._packer.moving(scene)
        pack = join([fixed, moving]) if moving.parts else fixed
        frame = _Frame(self, scene, view, pack, fixed.parts, self._table)
        if self._pool is None:
            frame.paint(pixels, 0, len(pixels))
        else:
            cuts = [len(pixels) * k // self._threads for k in range(self._threads + 1)]
            bands = [
                self._pool.submit(frame.paint, pixels, a, b) for a, b in itertools.pairwise(cuts)
            ]
            for band in bands:
                band.result()
        self._canvas.close(pixels, image)

    @property
    def packer(self) -> Packer:
        """Return what packs this renderer's scenes."""
        return self._packer

    @property
    def units(self) -> UnitSpheres:
        """Return the unit spheres that spheres are painted with."""
        return self._units


class _Frame:
    """One frame: the order of things, worked out once and painted by every band."""

    def __init__(
        self,
        painter: Painter,
        scene: Scene,
        view: View,
        pack: Pack,
        fixed: int,
        table: NDArray[np.float64],
    ) -> None:
        self.view, self.pack = view, pack
        self.scene = scene
        self.lamps = lamps_of(scene)
        self.lines = lines_of(scene)
        self.discs, self.disc_colours = discs_of((*scene.marks, *scene.shadows))
        self.spheres = painter.packer.spheres(scene)
        count = len(pack.points)
        self.seen, self.screen = np.zeros((count, 3)), np.zeros((count, 3))
        raster.project_points(
            pack.points,
            view.eye,
            view.basis,
            view.focal,
            view.near,
            float(view.size[0]),
            float(view.size[1]),
            self.seen,
            self.screen,
        )
        self.shades = np.zeros(len(pack.face_normals), np.uint32)
        shading.shade_faces(
            pack.face_centres,
            pack.face_normals,
            pack.face_colours,
            pack.face_light,
            view.eye,
            self.lamps,
            scene.ambient,
            self.shades,
        )
        self.units = painter.units.of(self.spheres, view)
        self.parts_below, self.items = self._sort(fixed, table)

    def _sort(
        self,
        fixed: int,
        table: NDArray[np.float64],
    ) -> tuple[list[list[int]], NDArray[np.int32]]:
        """Return the parts of layers 0 and 1, and the order of parts and spheres above."""
        pack, view, s = self.pack, self.view, self.spheres
        parts = pack.parts
        boxes = np.zeros((parts + len(s.radii), 4))
        spans = np.zeros(parts + len(s.radii) + 1, np.int64)
        outlines = np.zeros((4 * len(pack.triangles) + 20 * len(s.radii) + 8, 2))
        shown = np.zeros(parts, np.bool_)
        wide, tall = view.size
        outline.part_outlines(
            self.seen,
            self.screen,
            pack.triangles,
            pack.faces,
            pack.face_normals,
            pack.face_offsets,
            pack.starts,
            pack.traits,
            view.eye,
            view.focal,
            view.near,
            float(wide),
            float(tall),
            boxes,
            outlines,
            spans,
            shown,
        )
        outline.sphere_outlines(
            parts,
            s.centres,
            s.radii,
            view.eye,
            view.basis,
            view.focal,
            view.near,
            float(wide),
            float(tall),
            boxes,
            outlines,
            spans,
        )
        layers = pack.traits[:, 1]
        below = [[int(p) for p in np.flatnonzero(shown & (layers == k))] for k in (0, 1)]
        high = s.centres[:, 2] > 0.0 if len(s.radii) else np.zeros(0, np.bool_)
        inside = (
            (boxes[:, 2] > 0.0) & (boxes[:, 0] < wide) & (boxes[:, 3] > 0.0) & (boxes[:, 1] < tall)
        )
        found = np.flatnonzero(np.concatenate([shown & (layers >= 2), high]) & inside)
        chosen: NDArray[np.int32] = found.astype(np.int32)
        middles = (pack.starts[:-1, 0]).astype(np.int64)
        places = np.concatenate([pack.points[middles], s.centres]) if parts else s.centres
        far = ((places - view.eye) ** 2).sum(axis=1)
        result = np.zeros(len(chosen), np.int32)
        order.sort_items(
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
            result,
        )
        return below, result

    def paint(self, pixels: Pixels, top: int, bottom: int) -> None:
        """Paint one band of rows."""
        shade_background(pixels, self.scene.background, top, bottom)
        view, s = self.view, self.spheres
        for part in self.parts_below[0]:
            self._part(pixels, part, top, bottom)
        for number in range(len(s.radii)):
            if s.centres[number, 2] < 0.98 * s.radii[number]:
                self._sphere(pixels, number, top, bottom, upper_half=False)
        for part in self.parts_below[1]:
            self._part(pixels, part, top, bottom)
        shading.draw_discs(
            pixels,
            NO_DEPTH,
            False,  # noqa: FBT003  a kernel's flag
            top,
            bottom,
            self.discs,
            self.disc_colours,
            view.eye,
            view.basis,
            view.focal,
            view.near,
        )
        line_kernels.draw_segments(
            pixels,
            NO_DEPTH,
            False,  # noqa: FBT003  a kernel's flag
            top,
            bottom,
            self.lines.ends,
            self.lines.colours,
            self.lines.widths,
            self.lines.alphas,
            view.eye,
            view.basis,
            view.focal,
            view.near,
            LEAST_LINE,
        )
        for item in self.items:
            if item < self.pack.parts:
                self._part(pixels, int(item), top, bottom)
            else:
                number = int(item) - self.pack.parts
                dropping = bool(s.centres[number, 2] < 0.98 * s.radii[number])
                self._sphere(pixels, number, top, bottom, upper_half=dropping)

    def _part(self, pixels: Pixels, part: int, top: int, bottom: int) -> None:
        pack, view = self.pack, self.view
        painter_kernels.paint_part(
            pixels,
            top,
            bottom,
            int(pack.starts[part, 1]),
            int(pack.starts[part + 1, 1]),
            self.seen,
            self.screen,
            pack.triangles,
            pack.faces,
            pack.face_normals,
            pack.face_offsets,
            pack.face_light,
            self.shades,
            view.eye,
            view.focal,
            view.near,
        )

    def _sphere(
        self, pixels: Pixels, number: int, top: int, bottom: int, *, upper_half: bool
    ) -> None:
        s, view, unit = self.spheres, self.view, self.units[number]
        offset, size = s.skin_places[number]
        painter_kernels.paint_sphere(
            pixels,
            top,
            bottom,
            upper_half,
            unit.points,
            unit.triangles,
            unit.faces,
            unit.face_normals,
            unit.face_centres,
            s.centres[number],
            s.rotations[number],
            float(s.radii[number]),
            s.colours[number],
            float(s.gloss[number]),
            s.skins,
            int(offset),
            int(size),
            view.eye,
            view.basis,
            view.focal,
            view.near,
            self.lamps,
            self.scene.ambient,
        )
