"""A scene's shapes as few long arrays in the world's frame, which is what kernels eat.

One idea: what is fixed is packed once and kept as long as the same objects come back; what
moves is packed in its own frame once and carried to its place each frame.
Invariant: the order of parts, faces and spheres follows the order of the scene's objects.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from engine.scene.shape import Mesh, Polyline, Sphere, sphere_mesh

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from engine.scene.camera import Camera, Size
    from engine.scene.scene import GameObject, Scene

    Doubles = NDArray[np.float64]
    Singles = NDArray[np.float32]
    Ints = NDArray[np.int32]
    Bytes = NDArray[np.uint8]

KINDS = {"hull": 0, "shell": 1, "sheet": 2}


@dataclass(frozen=True, slots=True, eq=False)
class Pack:
    """Meshes in a row: points, triangles, faces, edges, and where each part begins.

    `starts` is (parts + 1, 4): first point, triangle, face and plane of every part.
    `traits` is (parts, 2): kind and layer. `face_light` is (f, 2): gloss and alpha.
    """

    points: Doubles
    normals: Singles
    triangles: Ints
    faces: Ints
    face_normals: Doubles
    face_centres: Doubles
    face_offsets: Doubles
    face_colours: Bytes
    face_light: Singles
    face_smooth: NDArray[np.bool_]
    edges: Ints
    planes: Doubles
    starts: Ints
    traits: Ints

    @property
    def parts(self) -> int:
        """Return the number of parts."""
        return len(self.traits)


@dataclass(frozen=True, slots=True, eq=False)
class Spheres:
    """Spheres in a row; `skins` is one flat array, `skin_places` (n, 2) offset and size there.

    A size of zero is a sphere without a skin.
    """

    centres: Doubles
    rotations: Doubles
    radii: Doubles
    colours: Bytes
    gloss: Singles
    gradients: Ints
    skins: Bytes
    skin_places: Ints


@dataclass(frozen=True, slots=True, eq=False)
class Lines:
    """Segments in a row: ends (n, 2, 3), colours (n, 3), widths in m, alphas."""

    ends: Doubles
    colours: Bytes
    widths: Doubles
    alphas: Doubles


@dataclass(frozen=True, slots=True, eq=False)
class View:
    """A camera in numbers for one size of picture."""

    eye: Doubles
    basis: Doubles
    focal: float
    near: float
    size: Size


def view_of(camera: Camera, size: Size) -> View:
    """Return the numbers of a camera for a picture of `size` pixels."""
    return View(
        np.array(camera.eye, dtype=np.float64),
        np.ascontiguousarray(camera.basis()),
        camera.focal(size[1]),
        camera.near,
        size,
    )


def pack_mesh(mesh: Mesh) -> Pack:
    """Return one mesh as a pack, in its own frame."""
    normals = mesh.face_normals.astype(np.float64)
    centres = mesh.face_centres.astype(np.float64)
    count = len(normals)
    return Pack(
        points=mesh.positions.astype(np.float64),
        normals=mesh.normals,
        triangles=mesh.triangles,
        faces=mesh.faces,
        face_normals=normals,
        face_centres=centres,
        face_offsets=(normals * centres).sum(axis=1),
        face_colours=mesh.colours,
        face_light=np.tile(np.array([[mesh.gloss, mesh.alpha]], dtype=np.float32), (count, 1)),
        face_smooth=np.full(count, mesh.smooth),
        edges=mesh.edges,
        planes=mesh.planes,
        starts=np.array(
            [[0, 0, 0, 0], [len(mesh.positions), len(mesh.triangles), count, len(mesh.planes)]],
            dtype=np.int32,
        ),
        traits=np.array([[KINDS[mesh.kind], mesh.layer]], dtype=np.int32),
    )


def carry(pack: Pack, rotation: Doubles, position: Doubles) -> Pack:
    """Return a pack turned and moved to its place."""
    turned = pack.face_normals @ rotation.T
    centres = pack.face_centres @ rotation.T + position
    planes = pack.planes.copy()
    planes[:, :3] = pack.planes[:, :3] @ rotation.T
    planes[:, 3] += planes[:, :3] @ position
    return replace(
        pack,
        points=np.ascontiguousarray(pack.points @ rotation.T + position),
        normals=np.ascontiguousarray((pack.normals @ rotation.T).astype(np.float32)),
        face_normals=np.ascontiguousarray(turned),
        face_centres=np.ascontiguousarray(centres),
        face_offsets=(turned * centres).sum(axis=1),
        planes=planes,
    )


def sphere_pack(
    unit: Pack, centre: Doubles, rotation: Doubles, radius: float, colour: Bytes, gloss: float
) -> Pack:
    """Return a sphere as a mesh: the unit sphere's pack in its place and size."""
    placed = carry(unit, rotation * radius, centre)
    normals = np.ascontiguousarray(unit.face_normals @ rotation.T)
    count = len(normals)
    return replace(
        placed,
        normals=unit.normals,
        face_normals=normals,
        face_offsets=(normals * placed.face_centres).sum(axis=1),
        face_colours=np.tile(colour, (count, 1)),
        face_light=np.tile(np.array([[gloss, 1.0]], dtype=np.float32), (count, 1)),
    )


LEAP = 4
"""Steps of fineness between two unit spheres; few kinds of them are kept."""


class UnitSpheres:
    """Unit spheres as packs, finer for larger ones, each made once."""

    def __init__(self, pixels_a_step: float = 5.0, least: int = 6, most: int = 48) -> None:
        self._pixels_a_step, self._least, self._most = pixels_a_step, least, most
        self._kept: dict[int, Pack] = {}

    def of(self, spheres: Spheres, view: View) -> list[Pack]:
        """Return the unit sphere that suits the size of each on the screen."""
        depths = np.maximum((spheres.centres - view.eye) @ view.basis[2], view.near)
        across = spheres.radii * view.focal / depths
        wanted = np.rint(across * np.pi / self._pixels_a_step)
        wanted = LEAP * np.ceil(wanted / LEAP)
        steps = np.clip(wanted, self._least, np.minimum(spheres.gradients, self._most))
        return [self._one(int(k)) for k in steps]

    def make_all(self) -> None:
        """Make every sphere that may be wanted, so that none is made while balls roll."""
        for steps in (self._least, *range(2 * LEAP, self._most + 1, LEAP)):
            self._one(steps)

    def _one(self, steps: int) -> Pack:
        if steps not in self._kept:
            self._kept[steps] = pack_mesh(sphere_mesh(steps))
        return self._kept[steps]


def join(packs: list[Pack]) -> Pack:
    """Return packs as one, their numbers of points and faces shifted."""
    if len(packs) == 1:
        return packs[0]
    shifts = np.zeros(4, dtype=np.int32)
    triangles, faces, edges = [], [], []
    starts = [np.zeros((1, 4), dtype=np.int32)]
    for pack in packs:
        triangles.append(pack.triangles + shifts[0])
        faces.append(pack.faces + shifts[2])
        moved = pack.edges + np.array([shifts[0], shifts[0], shifts[2], shifts[2]], dtype=np.int32)
        edges.append(np.where(pack.edges < 0, pack.edges, moved).astype(np.int32))
        starts.append(pack.starts[1:] + shifts)
        shifts = shifts + pack.starts[-1]
    return Pack(
        points=np.concatenate([p.points for p in packs]),
        normals=np.concatenate([p.normals for p in packs]),
        triangles=np.concatenate(triangles),
        faces=np.concatenate(faces),
        face_normals=np.concatenate([p.face_normals for p in packs]),
        face_centres=np.concatenate([p.face_centres for p in packs]),
        face_offsets=np.concatenate([p.face_offsets for p in packs]),
        face_colours=np.concatenate([p.face_colours for p in packs]),
        face_light=np.concatenate([p.face_light for p in packs]),
        face_smooth=np.concatenate([p.face_smooth for p in packs]),
        edges=np.concatenate(edges),
        planes=np.concatenate([p.planes for p in packs]),
        starts=np.concatenate(starts),
        traits=np.concatenate([p.traits for p in packs]),
    )


def _empty() -> Pack:
    return Pack(
        points=np.zeros((0, 3)),
        normals=np.zeros((0, 3), np.float32),
        triangles=np.zeros((0, 3), np.int32),
        faces=np.zeros(0, np.int32),
        face_normals=np.zeros((0, 3)),
        face_centres=np.zeros((0, 3)),
        face_offsets=np.zeros(0),
        face_colours=np.zeros((0, 3), np.uint8),
        face_light=np.zeros((0, 2), np.float32),
        face_smooth=np.zeros(0, np.bool_),
        edges=np.zeros((0, 4), np.int32),
        planes=np.zeros((0, 4)),
        starts=np.zeros((1, 4), np.int32),
        traits=np.zeros((0, 2), np.int32),
    )


def no_spheres() -> Spheres:
    """Return no spheres at all."""
    return Spheres(
        centres=np.zeros((0, 3)),
        rotations=np.zeros((0, 3, 3)),
        radii=np.zeros(0),
        colours=np.zeros((0, 3), np.uint8),
        gloss=np.zeros(0, np.float32),
        gradients=np.zeros(0, np.int32),
        skins=np.zeros(3, np.uint8),
        skin_places=np.zeros((0, 2), np.int32),
    )


class Packer:
    """Packs scenes, and keeps what came before and comes again."""

    def __init__(self) -> None:
        self._fixed_objects: tuple[GameObject, ...] = ()
        self._fixed = _empty()
        self._fixed_lines: list[tuple[Polyline, GameObject]] = []
        self._meshes: dict[int, tuple[Mesh, Pack]] = {}
        self._skinned: tuple[object, ...] = ()
        self._skins = np.zeros(3, np.uint8)
        self._places = np.zeros((0, 2), np.int32)

    def fixed(self, scene: Scene) -> Pack:
        """Return the meshes that never move; the same pack while the objects are the same."""
        objects = tuple(o for o in scene.objects if o.fixed and o.visible)
        same = len(objects) == len(self._fixed_objects) and all(
            a is b for a, b in zip(objects, self._fixed_objects, strict=True)
        )
        if not same:
            packs = [pack for o in objects for pack in self._placed(o)]
            self._fixed_objects = objects
            self._fixed = join(packs) if packs else _empty()
        return self._fixed

    def moving(self, scene: Scene) -> Pack:
        """Return the meshes of objects that may move."""
        packs = [
            pack for o in scene.objects if o.visible and not o.fixed for pack in self._placed(o)
        ]
        return join(packs) if packs else _empty()

    def _placed(self, thing: GameObject) -> list[Pack]:
        position = np.array(thing.position)
        result = []
        for shape in thing.shapes:
            if isinstance(shape, Mesh):
                kept = self._meshes.get(id(shape))
                if kept is None:
                    kept = self._meshes[id(shape)] = (shape, pack_mesh(shape))
                result.append(carry(kept[1], thing.rotation, position))
        return result

    def spheres(self, scene: Scene) -> Spheres:
        """Return every visible sphere."""
        found = [
            (o, s) for o in scene.objects if o.visible for s in o.shapes if isinstance(s, Sphere)
        ]
        self._keep_skins(tuple(s.skin for _, s in found))
        return Spheres(
            centres=np.array([o.position for o, _ in found], dtype=np.float64).reshape(-1, 3),
            rotations=np.array([o.rotation for o, _ in found], dtype=np.float64).reshape(-1, 3, 3),
            radii=np.array([s.radius for _, s in found], dtype=np.float64),
            colours=np.array([s.colour for _, s in found], dtype=np.uint8).reshape(-1, 3),
            gloss=np.array([s.gloss for _, s in found], dtype=np.float32),
            gradients=np.array([s.gradient for _, s in found], dtype=np.int32),
            skins=self._skins,
            skin_places=self._places,
        )

    def _keep_skins(self, skins: tuple[object, ...]) -> None:
        same = len(skins) == len(self._skinned) and all(
            a is b for a, b in zip(skins, self._skinned, strict=True)
        )
        if same:
            return
        self._skinned = skins
        offsets: dict[int, tuple[int, int]] = {}
        flat, places, end = [np.zeros(3, np.uint8)], [], 3
        for skin in skins:
            if skin is None:
                places.append((0, 0))
                continue
            if id(skin) not in offsets:
                texels: Bytes = skin.texels  # type: ignore[attr-defined]
                offsets[id(skin)] = (end, len(texels))
                flat.append(np.ascontiguousarray(texels).reshape(-1))
                end += texels.size
            places.append(offsets[id(skin)])
        self._skins = np.concatenate(flat)
        self._places = np.array(places, dtype=np.int32).reshape(-1, 2)


def lines_of(scene: Scene) -> Lines:
    """Return every visible polyline as segments."""
    ends, colours, widths, alphas = [], [], [], []
    for thing in scene.objects:
        for shape in thing.shapes if thing.visible else ():
            if isinstance(shape, Polyline) and len(shape.points) > 1:
                placed = shape.points @ thing.rotation.T + np.array(thing.position)
                ends.append(np.stack([placed[:-1], placed[1:]], axis=1))
                count = len(placed) - 1
                colours += [shape.colour] * count
                widths += [shape.width] * count
                alphas += [shape.alpha] * count
    return Lines(
        np.concatenate(ends) if ends else np.zeros((0, 2, 3)),
        np.array(colours, dtype=np.uint8).reshape(-1, 3),
        np.array(widths, dtype=np.float64),
        np.array(alphas, dtype=np.float64),
    )
