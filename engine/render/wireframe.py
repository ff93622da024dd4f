"""Wireframe: every edge once, faces turned away hidden, lines with blended borders."""

from __future__ import annotations

import itertools
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING

import numpy as np

from engine.render import line_kernels
from engine.render.image import Canvas, Picture
from engine.render.pack import Lines, Pack, Packer, Spheres, View, lines_of, view_of
from engine.scene.shape import sphere_mesh

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from engine.render.image import Pixels
    from engine.scene.scene import Scene
    from engine.scene.shape import Mesh

NO_DEPTH = np.zeros((1, 1), np.float32)
PIXELS_A_STEP = 11.0
LEAST, MOST = 4, 16
STROKE = 1.15
DIMMED = 0.85
FAINT = 0.12
"""Tints no stronger than this are left out."""


BACKGROUND = np.uint32(0x0C0F14)


class Wireframe:
    """The renderer of edges; `threads` bands of the picture are drawn at the same time."""

    def __init__(self, threads: int = 2) -> None:
        self._threads = max(1, threads)
        self._pool = ThreadPoolExecutor(self._threads) if self._threads > 1 else None
        self._strokes: list[Lines] = []
        self._packer = Packer()
        self._canvas = Canvas()
        self._spheres: dict[int, Mesh] = {}

    def warm_up(self, progress: Callable[[str, float], None] | None = None) -> None:
        """Compile or load the kernels; `progress` hears what is done and the share of it."""
        ends = np.array([[[0.0, 0.0, 1.0], [0.1, 0.1, 1.0]]])
        self._segments(ends, np.zeros((1, 3), np.uint8), np.zeros(1), np.ones(1))
        self._draw(np.zeros((8, 8), np.uint32), View(np.zeros(3), np.eye(3), 8.0, 0.02, (8, 8)))
        if progress:
            progress("lines", 0.5)
        self._edges(np.zeros((0, 4), np.int32), np.zeros((0, 3)), np.zeros(0), np.zeros(3))
        if progress:
            progress("edges", 1.0)

    def render(self, scene: Scene, image: Picture) -> None:
        """Draw a scene into a picture."""
        pixels = self._canvas.open(image)
        view = view_of(scene.camera, (pixels.shape[1], pixels.shape[0]))
        for pack in (self._packer.fixed(scene), self._packer.moving(scene)):
            self._draw_pack(pack, view)
        self._draw_marks(scene)
        lines = lines_of(scene)
        self._segments(lines.ends, lines.colours, lines.widths, lines.alphas)
        self._draw_spheres(self._packer.spheres(scene), view)
        self._draw(pixels, view)
        self._canvas.close(pixels, image)

    def _draw_pack(self, pack: Pack, view: View) -> None:
        chosen = self._edges(pack.edges, pack.face_normals, pack.face_offsets, view.eye)
        edges = pack.edges[chosen]
        edges = edges[pack.face_light[edges[:, 2], 1] > FAINT]
        colours = _bright(pack.face_colours[edges[:, 2]])
        alphas = np.where(pack.face_light[edges[:, 2], 1] < 1.0, 0.4, DIMMED)
        widths = np.zeros(len(edges))
        self._segments(pack.points[edges[:, :2]], colours, widths, alphas)

    def _draw_marks(self, scene: Scene) -> None:
        turns = np.linspace(0.0, 2.0 * np.pi, 13)
        circle = np.stack([np.cos(turns), np.sin(turns), np.zeros(13)], axis=1)
        for mark in scene.marks:
            ring = circle * mark.radius + np.array(mark.centre)
            ends = np.stack([ring[:-1], ring[1:]], axis=1)
            colours = np.tile(np.array([mark.colour], np.uint8), (12, 1))
            self._segments(ends, colours, np.zeros(12), np.ones(12))

    def _draw_spheres(self, spheres: Spheres, view: View) -> None:
        """Draw far spheres before near ones, so that near strokes lie on top."""
        away = spheres.centres - view.eye
        for i in np.argsort(-(away**2).sum(axis=1), kind="stable"):
            depth = float(away[i] @ view.basis[2])
            if depth < view.near:
                continue
            across = spheres.radii[i] * view.focal / depth
            mesh = self._sphere(across, int(spheres.gradients[i]))
            turned = mesh.positions.astype(np.float64) @ spheres.rotations[i].T
            points = turned * spheres.radii[i] + spheres.centres[i]
            normals = mesh.face_normals.astype(np.float64)
            own_eye = (spheres.rotations[i].T @ (view.eye - spheres.centres[i])) / spheres.radii[i]
            offsets = (normals * mesh.face_centres).sum(axis=1)
            edges = mesh.edges[self._edges(mesh.edges, normals, offsets, own_eye)]
            middles = (mesh.positions[edges[:, 0]] + mesh.positions[edges[:, 1]]) * 0.5
            colours = _bright(look_up(spheres, i, middles))
            count = len(edges)
            self._segments(points[edges[:, :2]], colours, np.zeros(count), np.ones(count))

    def _sphere(self, across: float, gradient: int) -> Mesh:
        wanted = max(LEAST, min(MOST, gradient, round(across * np.pi / PIXELS_A_STEP)))
        if wanted not in self._spheres:
            self._spheres[wanted] = sphere_mesh(wanted)
        return self._spheres[wanted]

    @staticmethod
    def _edges(
        edges: NDArray[np.int32],
        normals: NDArray[np.float64],
        offsets: NDArray[np.float64],
        eye: NDArray[np.float64],
    ) -> NDArray[np.int32]:
        chosen = np.empty(len(edges), np.int32)
        count = line_kernels.select_edges(edges, normals, offsets, eye, chosen)
        return chosen[:count]

    def _segments(
        self,
        ends: NDArray[np.float64],
        colours: NDArray[np.uint8],
        widths: NDArray[np.float64],
        alphas: NDArray[np.float64],
    ) -> None:
        """Put strokes aside until the frame is drawn."""
        self._strokes.append(Lines(ends, colours, widths, alphas))

    def _draw(self, pixels: Pixels, view: View) -> None:
        """Draw all strokes that were put aside, in their order, band by band."""
        strokes, self._strokes = self._strokes, []
        lines = Lines(
            np.concatenate([s.ends for s in strokes]),
            np.concatenate([s.colours for s in strokes]),
            np.concatenate([s.widths for s in strokes]),
            np.concatenate([s.alphas for s in strokes]),
        )
        if self._pool is None:
            _draw_band(pixels, lines, view, 0, len(pixels))
            return
        cuts = [len(pixels) * k // self._threads for k in range(self._threads + 1)]
        bands = [
            self._pool.submit(_draw_band, pixels, lines, view, a, b)
            for a, b in itertools.pairwise(cuts)
        ]
        for band in bands:
            band.result()


def _draw_band(pixels: Pixels, lines: Lines, view: View, top: int, bottom: int) -> None:
    pixels[top:bottom] = BACKGROUND
    line_kernels.draw_segments(
        pixels,
        NO_DEPTH,
        False,  # noqa: FBT003  a kernel's flag
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
        STROKE,
    )


def _bright(colours: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return colours that stand out on black: the dark ones lifted, their hue kept."""
    values = colours.astype(np.float64)
    peak = values.max(axis=1, keepdims=True)
    lifted = values * (np.maximum(peak, 150.0) / np.maximum(peak, 1.0))
    return np.where(peak < 40.0, 110.0, lifted).astype(np.uint8)


def look_up(spheres: Spheres, number: int, directions: NDArray[np.float32]) -> NDArray[np.uint8]:
    """Return the skin's colours of one sphere at its own `directions` (n, 3)."""
    offset, size = (int(v) for v in spheres.skin_places[number])
    if size == 0:
        return np.tile(spheres.colours[number], (len(directions), 1))
    d = directions / np.abs(directions).sum(axis=1, keepdims=True)
    sign = np.where(d[:, :2] >= 0.0, 1.0, -1.0)
    folded = (1.0 - np.abs(d[:, 1::-1])) * sign
    uv = np.where(d[:, 2:] < 0.0, folded, d[:, :2])
    place = np.clip(((uv + 1.0) * 0.5 * size).astype(np.int64), 0, size - 1)
    texels = spheres.skins[offset : offset + 3 * size * size].reshape(size, size, 3)
    return texels[place[:, 1], place[:, 0]]
