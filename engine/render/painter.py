"""The painter's algorithm: what is far is painted first, what hides it over it.

One idea: not triangles but convex parts are put in order, by the planes between them (see
`engine.render.order`); within a part no front face hides another.
Invariants: parts of a lower layer are painted before those of a higher one: pockets, then the bed
with its marks and shadows, then what stands on it. With the picture that is kept while the camera
rests or without, with one thread or two, the pixels are the same.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from engine.render import disc_kernels
from engine.render.bands import Bands
from engine.render.image import Canvas, Picture, Target
from engine.render.keep import Kept
from engine.render.pack import join
from engine.render.packer import Packer
from engine.render.sequence import Sequence, planes_between, put_in_order
from engine.render.spheres import UnitSpheres
from engine.render.strokes import NO_DEPTH, Strokes
from engine.render.surroundings import Backdrop, discs_of, lamps_of
from engine.render.view import view_of
from engine.render.warm import draw_tiny
from engine.render.work import Work, make_work

if TYPE_CHECKING:
    from collections.abc import Callable

    from engine.render.arrays import Flags, Floats, Ints, Pixels, Singles
    from engine.render.pack import Pack
    from engine.scene.scene import Scene

LEAST_LINE = 1.1
GROUND = np.uint32(0x7FC00000)
"""No number, as the bits of a float32: marks of any depth may lie here."""
COVERED = np.uint32(0x7F800000)
"""Infinitely near: nothing that lies on the ground is seen here."""
ON_GROUND = 2
"""The layer of what stands on the ground."""


class Painter:
    """The renderer without depth; `threads` bands of rows are painted at the same time."""

    def __init__(self, threads: int = 2, *, keeps: bool = True) -> None:
        self._bands = Bands(threads)
        self._packer = Packer()
        self._canvas = Canvas()
        self._units = UnitSpheres()
        self._strokes = Strokes()
        self._kept = Kept(on=keeps)
        self._backdrop = Backdrop()
        self._fixed: Pack | None = None
        self._table: Floats = np.zeros((0, 0, 4))

    def warm_up(self, progress: Callable[[str, float], None] | None = None) -> None:
        """Compile or load the kernels; `progress` hears what is done and the share of it."""
        if progress:
            progress("painter", 0.1)
        draw_tiny(self)
        if progress:
            progress("painter", 1.0)

    def render(self, scene: Scene, image: Picture) -> None:
        """Draw a scene into a picture."""
        target = self._canvas.open(image)
        frame = self._prepare(scene, target)
        if frame.may_be_kept and self._knows(frame, target):
            draw = partial(frame.paint_over, target, self._kept)
        else:
            draw = partial(frame.paint_all, target)
        self._bands.run(draw, 0, target.height)
        self._canvas.close(target, image)

    def _prepare(self, scene: Scene, target: Target) -> _Frame:
        """Return the frame: everything placed and put in order."""
        view = view_of(scene.camera, target.size)
        fixed, lines = self._packer.fixed(scene)
        if fixed is not self._fixed:
            self._fixed, self._table = fixed, planes_between(fixed)
        strokes = self._strokes
        strokes.begin(view)
        strokes.add_lines(lines)
        few = strokes.count
        moving, lines = self._packer.moving(scene)
        strokes.add_lines(lines)
        spheres = self._packer.spheres(scene)
        units = self._units.choose(spheres, view)
        pack = join([fixed, moving]) if moving.parts else fixed
        lamps = lamps_of(scene)
        work = make_work(pack, spheres, units, self._units.together, view, lamps, scene.ambient)
        discs, shades = discs_of((*scene.marks, *scene.shadows))
        return _Frame(
            work=work,
            fixed=fixed,
            order=put_in_order(work, fixed.parts, self._table),
            background=self._backdrop.rows(scene.background, target.height),
            strokes=strokes,
            few=few,
            discs=discs,
            shades=shades,
            key=(fixed, scene.camera, scene.lights, scene.background, scene.ambient, target.size),
        )

    def _knows(self, frame: _Frame, target: Target) -> bool:
        """Return whether the picture of what never moves is kept; keep it where it is time to."""
        kept = self._kept
        if kept.knows(frame.key):
            return True
        if not kept.wants_picture:
            return False
        still = put_in_order(frame.work, frame.fixed.parts, self._table, only_fixed=True)
        if still.broken:
            kept.drop()
            return False
        kept.depth = np.zeros(target.size[::-1], np.float32)
        self._bands.run(partial(frame.paint_fixed, kept, still.items), 0, target.height)
        return True


@dataclass(frozen=True, slots=True, eq=False)
class _Frame:
    """One frame, worked out once and painted by every band; the first `few` strokes are fixed."""

    work: Work
    fixed: Pack
    order: Sequence
    background: Pixels
    strokes: Strokes
    few: int
    discs: Floats
    shades: Pixels
    key: tuple[object, ...]

    @property
    def may_be_kept(self) -> bool:
        """Return whether what moves can be painted over a picture of what does not."""
        traits, light = self.work.placed.pack.traits, self.fixed.face_light
        return (
            not self.order.broken
            and not len(self.order.dropping)
            and bool((traits[self.fixed.parts :, 1] >= ON_GROUND).all())
            and bool((light[self._standing_faces(), 1] >= 1.0).all())
        )

    def _standing_faces(self) -> Flags:
        layers = np.repeat(self.fixed.traits[:, 1], np.diff(self.fixed.starts[:, 2]))
        return layers >= ON_GROUND

    def paint_all(self, target: Target, top: int, bottom: int) -> None:
        """Paint one band of rows."""
        rows, work, order = (top, bottom), self.work, self.order
        ground = order.below[1]
        moving = ground >= self.fixed.parts
        self._paint_floor(target, rows, ground[~moving])
        work.paint(target.rows, rows, ground[moving])
        self._paint_marks(target, rows, None)
        work.paint(target.rows, rows, order.items)

    def paint_fixed(self, kept: Kept, items: Ints, top: int, bottom: int) -> None:
        """Paint one band of what never moves into what is kept, and what of it is ground."""
        rows, work = (top, bottom), self.work
        self._paint_floor(Target(kept.pixels, work.view.size[0]), rows, self.order.below[1])
        work.paint(kept.pixels, rows, items)
        cover = kept.depth.view(np.uint32)
        cover[top:bottom] = GROUND
        work.paint(cover, rows, items, shades=np.full_like(work.placed.shades, COVERED))

    def paint_over(self, target: Target, kept: Kept, top: int, bottom: int) -> None:
        """Paint one band of what moves over what is kept."""
        rows = top, bottom
        target.rows[top:bottom, : target.width] = kept.pixels[top:bottom]
        self._paint_marks(target, rows, kept.depth)
        items, boxes = self.order.items, self.order.boxes
        self.work.paint(target.rows, rows, items, after=self.fixed.parts, boxes=boxes)

    def _paint_floor(self, target: Target, rows: tuple[int, int], ground: Ints) -> None:
        """Paint background, pockets and what drops into them, and the ground with its lines."""
        top, bottom = rows
        target.rows[top:bottom, : target.width] = self.background[top:bottom]
        self.work.paint(target.rows, rows, self.order.below[0])
        self.work.paint(target.rows, rows, self.order.dropping, whole=True)
        self.work.paint(target.rows, rows, ground)
        self.strokes.draw(target, top, bottom, 0, self.few, LEAST_LINE)

    def _paint_marks(self, target: Target, rows: tuple[int, int], cover: Singles | None) -> None:
        """Paint marks, shadows and lines that may move, with `cover` only on bare ground."""
        top, bottom = rows
        disc_kernels.draw_discs(
            target.rows,
            NO_DEPTH if cover is None else cover,
            cover is not None,
            top,
            bottom,
            self.discs,
            self.shades,
            *self.work.view.numbers,
        )
        last = self.strokes.count
        self.strokes.draw(target, top, bottom, self.few, last, LEAST_LINE, cover)
