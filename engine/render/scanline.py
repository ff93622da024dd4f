"""Scanline with a z-buffer: every pixel keeps the nearest surface and is lit by itself.

One idea: what never moves is drawn first, so that its colours and depths can be kept while the
camera rests; then marks and shadows, then what moves.
Invariant: with the kept picture or without, with one thread or two, the pixels are the same.
"""

from __future__ import annotations

import itertools
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING

import numpy as np

from engine.render import depth_kernels, line_kernels, raster, shading
from engine.render.image import Canvas, Picture
from engine.render.pack import (
    Pack,
    Packer,
    Spheres,
    UnitSpheres,
    View,
    join,
    lines_of,
    no_spheres,
    sphere_pack,
    view_of,
)
from engine.render.warm import tiny_scene

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from engine.render.image import Pixels
    from engine.scene.scene import Scene
    from engine.scene.shape import Disc

LEAST_LINE = 1.1


class Scanline:
    """The renderer with a depth for every pixel.

    `threads` bands of the picture are drawn at the same time; `flat` gives every face one
    colour, which is what the painter's algorithm is measured against.
    """

    def __init__(self, threads: int = 2, *, flat: bool = False, keeps: bool = True) -> None:
        self._packer = Packer()
        self._canvas = Canvas()
        self._threads = max(1, threads)
        self._pool = ThreadPoolExecutor(self._threads) if self._threads > 1 else None
        self._flat = flat
        self._units = UnitSpheres()
        self._keeps = keeps
        self._depth = np.zeros((1, 1), np.float32)
        self._kept: tuple[object, ...] = ()
        self._kept_pixels = np.zeros((1, 1), np.uint32)
        self._kept_depth = np.zeros((1, 1), np.float32)

    def warm_up(self, progress: Callable[[str, float], None] | None = None) -> None:
        """Compile or load the kernels; `progress` hears what is done and the share of it."""
        scene, picture = tiny_scene(), np.zeros((16, 16), np.uint32)
        if progress:
            progress("scanline", 0.1)
        self.render(scene, picture)
        if progress:
            progress("scanline", 1.0)

    def render(self, scene: Scene, image: Picture) -> None:
        """Draw a scene into a picture."""
        pixels = self._canvas.open(image)
        if self._depth.shape != pixels.shape:
            self._depth = np.zeros(pixels.shape, np.float32)
        view = view_of(scene.camera, (pixels.shape[1], pixels.shape[0]))
        job = _Job(self, scene, view, pixels, self._depth)
        self._draw_fixed(job, scene)
        self._bands(job.draw_moving, len(pixels))
        self._canvas.close(pixels, image)

    def _draw_fixed(self, job: _Job, scene: Scene) -> None:
        key = (
            job.fixed,
            scene.camera,
            scene.lights,
            scene.background,
            scene.ambient,
            job.pixels.shape,
        )
        if self._keeps and _same(key, self._kept):
            job.pixels[...] = self._kept_pixels
            job.depth[...] = self._kept_depth
            return
        self._bands(job.draw_fixed, len(job.pixels))
        resting = len(self._kept) > 1 and self._kept[1] == scene.camera
        if self._keeps and (resting or not self._kept):
            self._kept_pixels, self._kept_depth = job.pixels.copy(), job.depth.copy()
            self._kept = key
        else:
            self._kept = (None, scene.camera)

    def _bands(self, draw: Callable[[int, int], None], height: int) -> None:
        """Draw the picture in bands of rows, each by a thread of its own."""
        if self._pool is None:
            draw(0, height)
            return
        cuts = [height * k // self._threads for k in range(self._threads + 1)]
        waiting = [self._pool.submit(draw, a, b) for a, b in itertools.pairwise(cuts)]
        for band in waiting:
            band.result()

    @property
    def packer(self) -> Packer:
        """Return what packs this renderer's scenes."""
        return self._packer

    @property
    def units(self) -> UnitSpheres:
        """Return the unit spheres for flat pictures."""
        return self._units

    @property
    def flat(self) -> bool:
        """Return whether every face has one colour."""
        return self._flat


def _same(a: tuple[object, ...], b: tuple[object, ...]) -> bool:
    return len(a) == len(b) and a[0] is b[0] and a[1:] == b[1:]


class _Job:
    """One frame: the scene in arrays, shared by the bands."""

    def __init__(
        self,
        renderer: Scanline,
        scene: Scene,
        view: View,
        pixels: Pixels,
        depth: NDArray[np.float32],
    ) -> None:
        packer = renderer.packer
        self.pixels, self.depth, self.view = pixels, depth, view
        self.flat = renderer.flat
        self.background = scene.background
        self.ambient = scene.ambient
        self.lamps = lamps_of(scene)
        self.fixed = packer.fixed(scene)
        self.moving = packer.moving(scene)
        self.spheres = packer.spheres(scene)
        if self.flat:
            self._flatten_spheres(renderer.units)
        self.lines = lines_of(scene)
        self.discs, self.disc_colours = discs_of((*scene.marks, *scene.shadows))
        self._moving_points = _project(self.moving, view)
        self._moving_shades = self._shade(self.moving)
        self._fixed_points: tuple[NDArray[np.float64], NDArray[np.float64]] | None = None
        self._order = far_first(self.spheres, view)

    def _flatten_spheres(self, units: UnitSpheres) -> None:
        """Make meshes of the spheres, for a picture with one light a face."""
        s = self.spheres
        packs = [
            sphere_pack(
                unit, s.centres[i], s.rotations[i], s.radii[i], s.colours[i], float(s.gloss[i])
            )
            for i, unit in enumerate(units.of(s, self.view))
        ]
        self.moving = join([self.moving, *packs])
        self.spheres = no_spheres()

    def draw_fixed(self, top: int, bottom: int) -> None:
        """Draw background and fixed parts in a band of rows."""
        shade_background(self.pixels, self.background, top, bottom)
        self.depth[top:bottom] = 0.0
        points = _project(self.fixed, self.view)
        self._triangles(self.fixed, points, self._shade(self.fixed), top, bottom)
        self._tints(self.fixed, points, top, bottom)

    def draw_moving(self, top: int, bottom: int) -> None:
        """Draw tints, marks, shadows and what moves in a band of rows."""
        view, lines, s = self.view, self.lines, self.spheres
        self._tints(self.moving, self._moving_points, top, bottom)
        shading.draw_discs(
            self.pixels,
            self.depth,
            True,  # noqa: FBT003  a kernel's flag
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
            self.pixels,
            self.depth,
            True,  # noqa: FBT003  a kernel's flag
            top,
            bottom,
            lines.ends,
            lines.colours,
            lines.widths,
            lines.alphas,
            view.eye,
            view.basis,
            view.focal,
            view.near,
            LEAST_LINE,
        )
        self._triangles(self.moving, self._moving_points, self._moving_shades, top, bottom)
        depth_kernels.draw_spheres(
            self.pixels,
            self.depth,
            top,
            bottom,
            self._order,
            s.centres,
            s.rotations,
            s.radii,
            s.colours,
            s.gloss,
            s.skins,
            s.skin_places,
            view.eye,
            view.basis,
            view.focal,
            view.near,
            self.lamps,
            self.ambient,
        )

    def _shade(self, pack: Pack) -> NDArray[np.uint32]:
        shades = np.zeros(len(pack.face_normals), np.uint32)
        if self.flat:
            shading.shade_faces(
                pack.face_centres,
                pack.face_normals,
                pack.face_colours,
                pack.face_light,
                self.view.eye,
                self.lamps,
                self.ambient,
                shades,
            )
        return shades

    def _triangles(
        self,
        pack: Pack,
        points: tuple[NDArray[np.float64], NDArray[np.float64]],
        shades: NDArray[np.uint32],
        top: int,
        bottom: int,
    ) -> None:
        view = self.view
        depth_kernels.draw_triangles(
            self.pixels,
            self.depth,
            top,
            bottom,
            points[0],
            points[1],
            pack.triangles,
            pack.faces,
            pack.face_normals,
            pack.face_offsets,
            pack.face_colours,
            pack.face_light,
            pack.face_smooth,
            pack.normals,
            view.eye,
            view.basis,
            view.focal,
            view.near,
            self.lamps,
            self.ambient,
            self.flat,
            shades,
        )

    def _tints(
        self,
        pack: Pack,
        points: tuple[NDArray[np.float64], NDArray[np.float64]],
        top: int,
        bottom: int,
    ) -> None:
        view = self.view
        depth_kernels.draw_tints(
            self.pixels,
            self.depth,
            top,
            bottom,
            points[0],
            points[1],
            pack.triangles,
            pack.faces,
            pack.face_normals,
            pack.face_offsets,
            pack.face_colours,
            pack.face_light,
            view.eye,
            view.focal,
            view.near,
        )


def _project(pack: Pack, view: View) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    seen, screen = np.zeros((len(pack.points), 3)), np.zeros((len(pack.points), 3))
    raster.project_points(
        pack.points,
        view.eye,
        view.basis,
        view.focal,
        view.near,
        float(view.size[0]),
        float(view.size[1]),
        seen,
        screen,
    )
    return seen, screen


def shade_background(
    pixels: Pixels,
    colours: tuple[tuple[int, int, int], tuple[int, int, int]],
    top: int,
    bottom: int,
) -> None:
    """Paint a band of the background."""
    upper, lower = (np.array(c, dtype=np.float64) for c in colours)
    share = np.linspace(0.0, 1.0, len(pixels))[top:bottom, None]
    fill_rows(pixels[top:bottom], upper * (1.0 - share) + lower * share)


def fill_rows(pixels: Pixels, colours: NDArray[np.float64]) -> None:
    """Give every row a colour of its own."""
    shade = np.rint(colours).astype(np.uint32)
    pixels[...] = ((shade[:, 0] << 16) | (shade[:, 1] << 8) | shade[:, 2])[:, None]


def lamps_of(scene: Scene) -> NDArray[np.float64]:
    """Return the lights as (n, 4): position and power."""
    rows = [(*light.position, light.power) for light in scene.lights]
    return np.array(rows, dtype=np.float64).reshape(-1, 4)


def discs_of(discs: tuple[Disc, ...]) -> tuple[NDArray[np.float64], NDArray[np.uint8]]:
    """Return discs as (n, 6) and their colours (n, 3)."""
    rows = [(*d.centre, d.radius, d.alpha, d.softness) for d in discs]
    colours = [d.colour for d in discs]
    return (
        np.array(rows, dtype=np.float64).reshape(-1, 6),
        np.array(colours, dtype=np.uint8).reshape(-1, 3),
    )


def far_first(spheres: Spheres, view: View) -> NDArray[np.int64]:
    """Return the spheres' numbers from the farthest to the nearest."""
    away = ((spheres.centres - view.eye) ** 2).sum(axis=1)
    return np.argsort(-away, kind="stable")
