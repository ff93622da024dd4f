"""Shapes: what can be drawn, as arrays of numbers.

One idea: a shape is plain data in its own frame (m); a game object places it in the world.
Invariant: a `Mesh` is one part that never hides itself behind another of its own front faces:
a convex hull seen from outside, a shell seen from inside, or a flat sheet.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import sqrt
from typing import TYPE_CHECKING, Literal

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    Floats = NDArray[np.float32]
    Ints = NDArray[np.int32]
    Bytes = NDArray[np.uint8]

Kind = Literal["hull", "shell", "sheet"]
Rgb = tuple[int, int, int]

HIDDEN = -1
"""In place of a face index: the edge has no second face, or the face is not to be drawn."""


@dataclass(frozen=True, slots=True, eq=False)
class Mesh:
    """One part made of flat polygons.

    positions: float32 (v, 3); normals: float32 (v, 3), outward, used where `smooth`;
    triangles: int32 (t, 3), counter-clockwise seen from the front; faces: int32 (t,), the
    polygon each triangle belongs to; face_normals, face_centres: float32 (f, 3);
    colours: uint8 (f, 3); edges: int32 (e, 4), both ends and the one or two faces that meet
    there (`HIDDEN` for none); planes: float64 (k, 4), outward (a, b, c, d) with
    ax + by + cz <= d for the whole part, where it is a hull.
    `layer` orders parts for a renderer without depth: 0 below the ground, 1 the ground, 2 on it.
    `gloss` is the strength of highlights, 0 to 1; `alpha` is less than 1 for a tint.
    """

    positions: Floats
    normals: Floats
    triangles: Ints
    faces: Ints
    face_normals: Floats
    face_centres: Floats
    colours: Bytes
    edges: Ints
    planes: NDArray[np.float64]
    kind: Kind = "hull"
    layer: int = 2
    gloss: float = 0.0
    alpha: float = 1.0
    smooth: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Skin:
    """A painted surface for a sphere: uint8 (n, n, 3), looked up by the sphere's own direction.

    The directions are folded onto a square (an octahedron's net): see `skin_directions`.
    """

    texels: Bytes


@dataclass(frozen=True, slots=True, eq=False)
class Sphere:
    """A sphere of `radius` (m), painted with `colour` or a skin.

    `gradient` is the number of steps of latitude; a renderer that draws it by triangles may
    take fewer when it is small on the screen. Steps of longitude are twice as many.
    """

    radius: float
    colour: Rgb
    skin: Skin | None = None
    gradient: int = 24
    gloss: float = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class Polyline:
    """A line through `points`, float32 (n, 3), `width` (m) thick, at least a pixel's width.

    On the ground it is drawn before what stands there.
    """

    points: Floats
    colour: Rgb
    width: float = 0.003
    alpha: float = 1.0


@dataclass(frozen=True, slots=True)
class Disc:
    """A flat round mark or shadow on a level plane: `centre` and `radius` in m.

    Covers fully within `radius` - `softness`, and fades to nothing at `radius`.
    """

    centre: tuple[float, float, float]
    radius: float
    colour: Rgb
    alpha: float = 1.0
    softness: float = 0.0


Shape = Mesh | Sphere | Polyline


def make_mesh(
    positions: Floats | NDArray[np.float64],
    polygons: Sequence[Sequence[int]],
    colours: Rgb | Sequence[Rgb],
    *,
    hidden: Sequence[Sequence[int]] = (),
    kind: Kind = "hull",
    layer: int = 2,
    gloss: float = 0.0,
    alpha: float = 1.0,
    smooth: bool = False,
) -> Mesh:
    """Return the mesh of flat convex `polygons` (indices, counter-clockwise from the front).

    `hidden` polygons belong to the part's hull but are never seen, such as a side against a
    neighbour. Raises ValueError where a polygon has less than three corners.
    """
    points = np.asarray(positions, dtype=np.float64)
    if any(len(polygon) < 3 for polygon in (*polygons, *hidden)):
        raise ValueError("a polygon has at least three corners")
    normals = np.array([_newell(points[list(p)]) for p in polygons]).reshape(-1, 3)
    centres = np.array([points[list(p)].mean(axis=0) for p in polygons]).reshape(-1, 3)
    triangles = [(p[0], p[i], p[i + 1]) for p in polygons for i in range(1, len(p) - 1)]
    owners = [face for face, p in enumerate(polygons) for _ in range(len(p) - 2)]
    solid = [*polygons, *hidden] if kind == "hull" else []
    return Mesh(
        positions=points.astype(np.float32),
        normals=_vertex_normals(len(points), polygons, normals),
        triangles=np.array(triangles, dtype=np.int32).reshape(-1, 3),
        faces=np.array(owners, dtype=np.int32),
        face_normals=normals.astype(np.float32),
        face_centres=centres.astype(np.float32),
        colours=_face_colours(colours, len(polygons)),
        edges=_edges(polygons),
        planes=_planes(points, solid),
        kind=kind,
        layer=layer,
        gloss=gloss,
        alpha=alpha,
        smooth=smooth,
    )


def _newell(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the unit normal of a polygon, by Newell's sum; zero where it has no area."""
    first, *others = corners.tolist()
    arms = [(x - first[0], y - first[1], z - first[2]) for x, y, z in others]
    a = b = c = 0.0
    for (x, y, z), (u, v, w) in pairwise(arms):
        a += y * w - z * v
        b += z * u - x * w
        c += x * v - y * u
    size = sqrt(a * a + b * b + c * c)
    return np.array((a, b, c)) / size if size > 0.0 else np.zeros(3)


def _planes(points: NDArray[np.float64], polygons: list[Sequence[int]]) -> NDArray[np.float64]:
    planes = []
    for polygon in polygons:
        normal = _newell(points[list(polygon)])
        planes.append((*normal, float((points @ normal).max())))
    return np.array(planes, dtype=np.float64).reshape(-1, 4)


def _face_colours(colours: Rgb | Sequence[Rgb], count: int) -> Bytes:
    given = np.asarray(colours, dtype=np.uint8)
    return np.ascontiguousarray(np.broadcast_to(given, (count, 3)))


def _vertex_normals(
    count: int, polygons: Sequence[Sequence[int]], normals: NDArray[np.float64]
) -> Floats:
    sums = np.zeros((count, 3))
    for polygon, normal in zip(polygons, normals, strict=True):
        sums[list(polygon)] += normal
    sizes = np.linalg.norm(sums, axis=1, keepdims=True)
    return (sums / np.where(sizes > 0.0, sizes, 1.0)).astype(np.float32)


def _edges(polygons: Sequence[Sequence[int]]) -> Ints:
    """Return every edge once, with the faces on its two sides."""
    found: dict[tuple[int, int], list[int]] = {}
    for face, polygon in enumerate(polygons):
        for a, b in zip(polygon, (*polygon[1:], polygon[0]), strict=True):
            found.setdefault((min(a, b), max(a, b)), []).append(face)
    rows = [(a, b, f[0], f[1] if len(f) > 1 else HIDDEN) for (a, b), f in found.items()]
    return np.array(rows, dtype=np.int32).reshape(-1, 4)


def skin_directions(size: int) -> NDArray[np.float64]:
    """Return the own direction of every texel of a skin: (size, size, 3), unit length."""
    axis = (np.arange(size) + 0.5) / size * 2.0 - 1.0
    u, v = np.meshgrid(axis, axis)
    z = 1.0 - np.abs(u) - np.abs(v)
    folded_x = np.where(z < 0.0, (1.0 - np.abs(v)) * np.where(u >= 0.0, 1.0, -1.0), u)
    folded_y = np.where(z < 0.0, (1.0 - np.abs(u)) * np.where(v >= 0.0, 1.0, -1.0), v)
    directions = np.stack([folded_x, folded_y, z], axis=-1)
    lengths: NDArray[np.float64] = np.linalg.norm(directions, axis=-1, keepdims=True)
    return directions / lengths


def sphere_mesh(gradient: int) -> Mesh:
    """Return a closed unit sphere: `gradient` steps of latitude, twice as many of longitude."""
    if gradient < 2:
        raise ValueError("a sphere has at least two steps of latitude")
    around = 2 * gradient
    rings = []
    for step in range(1, gradient):
        polar = np.pi * step / gradient
        turn = np.arange(around) * (2.0 * np.pi / around)
        height = np.full(around, np.cos(polar))
        rings.append(
            np.stack([np.sin(polar) * np.cos(turn), np.sin(polar) * np.sin(turn), height], 1)
        )
    points = np.concatenate([[[0.0, 0.0, 1.0]], *rings, [[0.0, 0.0, -1.0]]])
    last = len(points) - 1
    polygons: list[tuple[int, ...]] = []
    for k in range(around):
        after = (k + 1) % around
        polygons.append((0, 1 + k, 1 + after))
        for ring in range(gradient - 2):
            top, bottom = 1 + ring * around, 1 + (ring + 1) * around
            polygons.append((top + k, bottom + k, bottom + after, top + after))
        end = 1 + (gradient - 2) * around
        polygons.append((last, end + after, end + k))
    return make_mesh(points, polygons, (255, 255, 255), smooth=True)
