"""Packs scenes, and keeps what came before and comes again.

One idea: what is fixed is packed once and kept as long as the same objects come back; what moves is
packed in its own frame while it is there, and carried to its place each frame.
Invariant: nothing is kept of a shape that the last scene no longer had.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from engine.render.lines import Lines, lines_of
from engine.render.pack import Pack, carry, empty_pack, join, pack_mesh
from engine.render.spheres import Spheres
from engine.scene.shape import Mesh, Sphere

if TYPE_CHECKING:
    from engine.render.arrays import Bytes
    from engine.scene.scene import GameObject, Scene
    from engine.scene.shape import Skin


class Packer:
    """Packs the scenes of one renderer."""

    def __init__(self) -> None:
        self._fixed_objects: tuple[GameObject, ...] = ()
        self._fixed = empty_pack()
        self._fixed_lines = lines_of(())
        self._meshes: dict[int, tuple[Mesh, Pack]] = {}
        self._rounds: tuple[GameObject, tuple[Sphere, ...]] | None = None
        self._skinned: tuple[Skin | None, ...] = ()
        self._skins = np.zeros(3, np.uint8)
        self._places = np.zeros((0, 2), np.int32)

    def fixed(self, scene: Scene) -> tuple[Pack, Lines]:
        """Return what never moves; the same pack and lines while the objects are the same."""
        objects = tuple(o for o in scene.objects if o.fixed and o.visible)
        same = len(objects) == len(self._fixed_objects) and all(
            a is b for a, b in zip(objects, self._fixed_objects, strict=True)
        )
        if not same:
            packs = [
                carry(pack_mesh(shape), o.rotation, np.array(o.position))
                for o in objects
                for shape in o.shapes
                if isinstance(shape, Mesh)
            ]
            self._fixed_objects = objects
            self._fixed = join(packs) if packs else empty_pack()
            self._fixed_lines = lines_of(objects)
        return self._fixed, self._fixed_lines

    def moving(self, scene: Scene) -> tuple[Pack, Lines]:
        """Return the meshes and lines of objects that may move."""
        objects = [o for o in scene.objects if o.visible and not o.fixed]
        before, self._meshes = self._meshes, {}
        packs = []
        for thing in objects:
            for shape in thing.shapes:
                if isinstance(shape, Mesh):
                    kept = before.get(id(shape)) or (shape, pack_mesh(shape))
                    self._meshes[id(shape)] = kept
                    packs.append(carry(kept[1], thing.rotation, np.array(thing.position)))
        return join(packs) if packs else empty_pack(), lines_of(objects)

    def spheres(self, scene: Scene) -> Spheres:
        """Return every visible sphere."""
        found = [
            (o, s)
            for o in scene.objects
            if o.visible
            for s in (self._round(o) if o.fixed else o.shapes)
            if isinstance(s, Sphere)
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

    def _round(self, thing: GameObject) -> tuple[Sphere, ...]:
        """Return the spheres of an object that never moves, looked for once."""
        if self._rounds is None or self._rounds[0] is not thing:
            self._rounds = thing, tuple(s for s in thing.shapes if isinstance(s, Sphere))
        return self._rounds[1]

    def _keep_skins(self, skins: tuple[Skin | None, ...]) -> None:
        same = len(skins) == len(self._skinned) and all(
            a is b for a, b in zip(skins, self._skinned, strict=True)
        )
        if same:
            return
        self._skinned = skins
        offsets: dict[int, tuple[int, int]] = {}
        flat: list[Bytes] = [np.zeros(3, np.uint8)]
        places, end = [], 3
        for skin in skins:
            if skin is None:
                places.append((0, 0))
                continue
            if id(skin) not in offsets:
                offsets[id(skin)] = (end, len(skin.texels))
                flat.append(np.ascontiguousarray(skin.texels).reshape(-1))
                end += skin.texels.size
            places.append(offsets[id(skin)])
        self._skins = np.concatenate(flat)
        self._places = np.array(places, dtype=np.int32).reshape(-1, 2)
