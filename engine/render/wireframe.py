"""Wireframe: every edge once, faces turned away hidden, lines with blended borders.

One idea: the edges become strokes on the screen, first those that never move, and every band of
rows draws its strokes in that order; while the camera rests, the picture of the fixed ones is kept.
Invariant: with the kept picture or without, with one thread or two, the pixels are the same.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from engine.render.bands import Bands
from engine.render.image import Canvas, Picture, Target
from engine.render.keep import Kept
from engine.render.lines import Lines
from engine.render.packer import Packer
from engine.render.spheres import UnitSpheres
from engine.render.strokes import Strokes
from engine.render.view import view_of
from engine.render.warm import draw_tiny

if TYPE_CHECKING:
    from collections.abc import Callable

    from engine.scene.scene import Scene
    from engine.scene.shape import Disc

PIXELS_A_STEP = 11.0
LEAST, MOST = 4, 16
STROKE = 1.15
BACKGROUND = np.uint32(0x0C0F14)
RING = 12
"""Segments of a mark's rim."""


class Wireframe:
    """The renderer of edges; `threads` bands of the picture are drawn at the same time."""

    def __init__(self, threads: int = 2, *, keeps: bool = True) -> None:
        self._bands = Bands(threads)
        self._packer = Packer()
        self._canvas = Canvas()
        self._units = UnitSpheres(PIXELS_A_STEP, LEAST, MOST, 1)
        self._strokes = Strokes()
        self._kept = Kept(on=keeps)

    def warm_up(self, progress: Callable[[str, float], None] | None = None) -> None:
        """Compile or load the kernels; `progress` hears what is done and the share of it."""
        if progress:
            progress("wireframe", 0.1)
        draw_tiny(self)
        if progress:
            progress("wireframe", 1.0)

    def render(self, scene: Scene, image: Picture) -> None:
        """Draw a scene into a picture."""
        target = self._canvas.open(image)
        view = view_of(scene.camera, target.size)
        strokes = self._strokes
        strokes.begin(view)
        pack, lines = self._packer.fixed(scene)
        known = self._kept.knows((pack, scene.camera, target.size))
        if not known:
            strokes.add_mesh(pack)
            strokes.add_lines(lines)
        fixed = strokes.count
        pack, lines = self._packer.moving(scene)
        strokes.add_mesh(pack)
        strokes.add_lines(_rims(scene.marks))
        strokes.add_lines(lines)
        spheres = self._packer.spheres(scene)
        strokes.add_spheres(spheres, self._units.choose(spheres, view), self._units.together)
        keep = self._kept.wants_picture
        self._bands.run(partial(self._draw, target, fixed, known, keep), 0, target.height)
        self._canvas.close(target, image)

    def _draw(
        self,
        target: Target,
        fixed: int,
        known: bool,  # noqa: FBT001  by place
        keep: bool,  # noqa: FBT001
        top: int,
        bottom: int,
    ) -> None:
        """Draw a band: the first `fixed` strokes, or what is known of them; then the rest."""
        rows = target.rows[top:bottom, : target.width]
        strokes = self._strokes
        if known:
            rows[...] = self._kept.pixels[top:bottom]
        else:
            rows[...] = BACKGROUND
            strokes.draw(target, top, bottom, 0, fixed, STROKE)
            if keep:
                self._kept.pixels[top:bottom] = rows
        strokes.draw(target, top, bottom, fixed, strokes.count, STROKE)


def _rims(marks: tuple[Disc, ...]) -> Lines:
    """Return the rims of flat marks."""
    turns = np.linspace(0.0, 2.0 * np.pi, RING + 1)
    circle = np.stack([np.cos(turns), np.sin(turns), np.zeros(RING + 1)], axis=1)
    centres = np.array([mark.centre for mark in marks]).reshape(-1, 1, 3)
    radii = np.array([mark.radius for mark in marks]).reshape(-1, 1, 1)
    rims = centres + radii * circle
    colours = np.array([mark.colour for mark in marks], np.uint8).reshape(-1, 3)
    count = RING * len(marks)
    return Lines(
        np.stack([rims[:, :-1], rims[:, 1:]], axis=2).reshape(-1, 2, 3),
        np.repeat(colours, RING, axis=0),
        np.zeros(count),
        np.ones(count),
    )
