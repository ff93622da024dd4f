"""Scanline with a z-buffer: every pixel keeps the nearest surface and is lit by itself.

One idea: what never moves is drawn first, so that its colours and depths can be kept while the
camera rests; then marks and shadows, then what moves.
Invariant: with the kept picture or without, with one thread or two, the pixels are the same.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from engine.render import depth_kernels, disc_kernels, sphere_kernels
from engine.render.bands import Bands
from engine.render.groups import Groups, by_face, by_surface
from engine.render.image import Canvas, Picture, Target
from engine.render.keep import Kept
from engine.render.pack import join
from engine.render.packer import Packer
from engine.render.placed import Placed, place
from engine.render.spheres import UnitSpheres, no_spheres, sphere_pack
from engine.render.strokes import Strokes
from engine.render.surroundings import Backdrop, discs_of, lamps_of
from engine.render.view import View, view_of
from engine.render.warm import draw_tiny

if TYPE_CHECKING:
    from collections.abc import Callable

    from engine.render.arrays import Floats, Ints, Pixels, Singles
    from engine.render.lines import Lines
    from engine.render.pack import Pack
    from engine.render.spheres import Spheres
    from engine.scene.scene import Scene

LEAST_LINE = 1.1


class Scanline:
    """The renderer with a depth for every pixel.

    `threads` bands of the picture are drawn at the same time; `flat` gives every face one
    colour, which is what the painter's algorithm is measured against. Without `keeps` nothing is
    kept while the camera rests, without `surfaces` each face is filled by itself.
    """

    def __init__(
        self, threads: int = 2, *, flat: bool = False, keeps: bool = True, surfaces: bool = True
    ) -> None:
        self._bands = Bands(threads)
        self._packer = Packer()
        self._canvas = Canvas()
        self._flat = flat
        self._by_surface = surfaces and not flat
        self._units = UnitSpheres()
        self._kept = Kept(on=keeps)
        self._strokes, self._still_strokes = Strokes(), Strokes()
        self._backdrop = Backdrop()
        self._grouped: tuple[Pack, Groups] | None = None
        self._depth: Singles = np.zeros((1, 1), np.float32)
        self._drawn: Ints = np.zeros((0, 4), np.int32)

    def warm_up(self, progress: Callable[[str, float], None] | None = None) -> None:
        """Compile or load the kernels; `progress` hears what is done and the share of it."""
        if progress:
            progress("scanline", 0.1)
        draw_tiny(self)
        if progress:
            progress("scanline", 1.0)

    def render(self, scene: Scene, image: Picture) -> None:
        """Draw a scene into a picture."""
        target = self._canvas.open(image)
        size = target.size
        if self._depth.shape != size[::-1]:
            self._depth = np.zeros(size[::-1], np.float32)
        fixed, lines = self._packer.fixed(scene)
        kept = self._kept
        known = kept.knows(
            (fixed, scene.camera, scene.lights, scene.background, scene.ambient, size)
        )
        if kept.wants_picture:
            kept.depth = np.zeros(size[::-1], np.float32)
        frame = self._prepare(scene, target)
        still = None if known else self._prepare_fixed(scene, frame, fixed, lines)
        draw = partial(self._draw, target, frame, still, self._drawn)
        self._bands.run(draw, 0, target.height)
        self._drawn = frame.touched
        self._canvas.close(target, image)

    def _draw(
        self,
        target: Target,
        frame: _Frame,
        still: _Still | None,
        drawn: Ints,
        top: int,
        bottom: int,
    ) -> None:
        """Draw a band: what never moves, or what is kept of it; then what moves."""
        rows, kept = target.rows[top:bottom, : target.width], self._kept
        if still is None:
            rows[...] = kept.pixels[top:bottom]
            sphere_kernels.restore(self._depth, kept.depth, drawn, top, bottom)
        else:
            still.draw(target, self._depth, frame, top, bottom)
            if kept.wants_picture:
                kept.pixels[top:bottom] = rows
                kept.depth[top:bottom] = self._depth[top:bottom]
        frame.draw(target, self._depth, top, bottom)

    def _prepare_fixed(self, scene: Scene, frame: _Frame, fixed: Pack, lines: Lines) -> _Still:
        strokes = self._still_strokes
        strokes.begin(frame.view)
        strokes.add_lines(lines)
        return _Still(
            background=self._backdrop.rows(scene.background, frame.view.size[1]),
            placed=place(
                fixed,
                frame.view,
                frame.lamps,
                scene.ambient,
                self._groups_of(fixed) if self._by_surface else by_face(fixed),
                lit=self._flat,
            ),
            strokes=strokes,
        )

    def _groups_of(self, fixed: Pack) -> Groups:
        """Return the surfaces of what never moves, worked out once."""
        if self._grouped is None or self._grouped[0] is not fixed:
            self._grouped = fixed, by_surface(fixed)
        return self._grouped[1]

    def _prepare(self, scene: Scene, target: Target) -> _Frame:
        view = view_of(scene.camera, target.size)
        moving, lines = self._packer.moving(scene)
        self._strokes.begin(view)
        self._strokes.add_lines(lines)
        spheres = self._packer.spheres(scene)
        if self._flat:
            moving, spheres = self._flatten(moving, spheres, view), no_spheres()
        lamps = lamps_of(scene)
        discs, shades = discs_of((*scene.marks, *scene.shadows))
        seen, boxes = _place_spheres(spheres, view)
        return _Frame(
            view=view,
            flat=self._flat,
            lamps=lamps,
            ambient=scene.ambient,
            moving=place(moving, view, lamps, scene.ambient, by_face(moving), lit=self._flat),
            spheres=spheres,
            seen=seen,
            boxes=boxes,
            strokes=self._strokes,
            discs=discs,
            shades=shades,
        )

    def _flatten(self, moving: Pack, s: Spheres, view: View) -> Pack:
        """Return what moves with meshes for the spheres, for a picture with one light a face."""
        units = [self._units.one(number) for number in self._units.choose(s, view)]
        packs = [
            sphere_pack(
                unit, s.centres[i], s.rotations[i], s.radii[i], s.colours[i], float(s.gloss[i])
            )
            for i, unit in enumerate(units)
        ]
        return join([moving, *packs])


@dataclass(frozen=True, slots=True, eq=False)
class _Still:
    """What never moves, as one camera sees it."""

    background: Pixels
    placed: Placed
    strokes: Strokes

    def draw(self, target: Target, depth: Singles, frame: _Frame, top: int, bottom: int) -> None:
        """Draw a band of rows anew."""
        target.rows[top:bottom, : target.width] = self.background[top:bottom]
        depth[top:bottom] = 0.0
        frame.fill(target, depth, self.placed, top, bottom)
        frame.tint(target, depth, self.placed, top, bottom)
        self.strokes.draw(target, top, bottom, 0, self.strokes.count, LEAST_LINE, depth)


@dataclass(frozen=True, slots=True, eq=False)
class _Frame:
    """What may move, as one camera sees it, and the light on everything; shared by the bands.

    `seen` (n, 3) and `boxes` (n, 4) are the spheres' centres and what they cover on the screen.
    """

    view: View
    flat: bool
    lamps: Floats
    ambient: float
    moving: Placed
    spheres: Spheres
    seen: Floats
    boxes: Ints
    strokes: Strokes
    discs: Floats
    shades: Pixels

    @property
    def touched(self) -> Ints:
        """Return boxes of pixels about all that this frame writes into the depths."""
        return np.concatenate([self.boxes, self.moving.box(self.view.size)])

    def draw(self, target: Target, depth: Singles, top: int, bottom: int) -> None:
        """Draw tints, marks, shadows, lines and what moves in a band of rows."""
        s, numbers = self.spheres, self.view.numbers
        self.tint(target, depth, self.moving, top, bottom)
        disc_kernels.draw_discs(
            target.rows,
            depth,
            True,  # noqa: FBT003  a kernel's flag
            top,
            bottom,
            self.discs,
            self.shades,
            *numbers,
        )
        self.strokes.draw(target, top, bottom, 0, self.strokes.count, LEAST_LINE, depth)
        self.fill(target, depth, self.moving, top, bottom)
        sphere_kernels.draw_spheres(
            target.rows,
            depth,
            top,
            bottom,
            np.argsort(-(self.seen**2).sum(axis=1), kind="stable"),
            self.seen,
            self.boxes,
            s.centres,
            s.rotations,
            s.radii,
            s.colours,
            s.gloss,
            s.skins,
            s.skin_places,
            self.lamps,
            self.ambient,
            *numbers,
        )

    def fill(self, target: Target, depth: Singles, placed: Placed, top: int, bottom: int) -> None:
        """Draw the triangles of a pack that hide what is behind them."""
        pack = placed.pack
        depth_kernels.draw_triangles(
            target.rows,
            depth,
            top,
            bottom,
            placed.groups.order,
            placed.groups.starts,
            placed.groups.edges,
            placed.groups.edge_starts,
            placed.seen,
            placed.screen,
            pack.triangles,
            pack.faces,
            pack.face_normals,
            pack.face_offsets,
            pack.face_colours,
            pack.face_light,
            pack.face_smooth,
            pack.normals,
            self.lamps,
            self.ambient,
            self.flat,
            placed.shades,
            *self.view.numbers,
        )

    def tint(self, target: Target, depth: Singles, placed: Placed, top: int, bottom: int) -> None:
        """Draw the triangles of a pack that let light through."""
        pack, (eye, _, *lens) = placed.pack, self.view.numbers
        depth_kernels.draw_tints(
            target.rows,
            depth,
            top,
            bottom,
            placed.seen,
            placed.screen,
            pack.triangles,
            pack.faces,
            pack.face_normals,
            pack.face_offsets,
            pack.face_light,
            placed.shades,
            eye,
            *lens,
        )


def _place_spheres(spheres: Spheres, view: View) -> tuple[Floats, Ints]:
    """Return the spheres' centres in camera coordinates, and the pixels they cover, (n, 4)."""
    count = len(spheres.radii)
    seen, boxes = np.zeros((count, 3)), np.zeros((count, 4), np.int32)
    sphere_kernels.sphere_boxes(spheres.centres, spheres.radii, *view.numbers, seen, boxes)
    return seen, boxes
