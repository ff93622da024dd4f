"""Pins as they are seen: turned bodies that stand or lie, near or far, and their shadows.

One idea: a pin's rings follow a smooth curve through the radii of its profile, so a body that
bulges is one convex part; one that narrows is cut where it does. Invariant: no pin reaches below
the bed, however it leans.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise
from math import cos, hypot, pi, sin
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np

from engine.scene.scene import GameObject
from engine.scene.shape import Disc, make_mesh
from engine.stage.marks import LIFT
from engine.table.pin import Stance

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from numpy.typing import NDArray

    from engine.scene.camera import Vector
    from engine.scene.scene import Light
    from engine.scene.shape import Mesh, Rgb
    from engine.table.furniture import Pin, PinId, Table
    from engine.variant.variant import PinKind

    Profile = Sequence[tuple[float, float]]

NEAR, FAR = (18, 3), (8, 1)
"""Sides and steps of height between the radii of the profile, for a near pin and a far one."""
LARGE = 0.04
"""A pin is near where it is as tall as this share of its distance."""
WOOD: Rgb = (238, 230, 205)
"""What a pin is where nobody tells its colour."""
ROUNDED = 0.75
"""Radius of the flat top, in those of the head."""
SHADE = 1.5
"""How far apart along a pin the discs of its shadow are laid, in radii of its belly."""


@dataclass(frozen=True, slots=True, eq=False)
class Skittle:
    """One pin's profile, and its meshes as seen from near and from afar."""

    profile: Profile
    near: tuple[Mesh, ...]
    far: tuple[Mesh, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Skittles:
    """All pins of a table, and how they stand at first."""

    kinds: Mapping[PinId, Skittle] = field(default_factory=lambda: MappingProxyType({}))
    upright: Mapping[PinId, Stance] = field(default_factory=lambda: MappingProxyType({}))

    def objects(self, stances: Mapping[PinId, Stance], eye: Vector) -> list[GameObject]:
        """Return the pins as they stand or lie, each in the detail that its distance asks for."""
        placed = []
        for name, stance in stances.items():
            kind = self.kinds[name]
            x, y = stance.foot
            away = hypot(x - eye[0], y - eye[1], eye[2])
            near = kind.profile[-1][0] > LARGE * away
            turn = _rotation(stance)
            place = x, y, _lift(kind.profile, stance.tilt)
            placed.append(GameObject(kind.near if near else kind.far, place, turn))
        return placed

    def shadows(self, stances: Mapping[PinId, Stance], lamps: Sequence[Light]) -> tuple[Disc, ...]:
        """Return the shadows of all pins from each lamp, laid as rows of discs."""
        return tuple(
            disc
            for name, stance in stances.items()
            for disc in _shadows(self.kinds[name].profile, stance, lamps)
        )


def build_skittles(table: Table, kinds: Sequence[PinKind]) -> Skittles:
    """Return the pins of a table in their colours."""
    colours = {kind.id: kind.colour for kind in kinds}
    return Skittles(
        MappingProxyType({pin.id: _skittle(pin, colours.get(pin.id, WOOD)) for pin in table.pins}),
        MappingProxyType({pin.id: Stance(pin.at) for pin in table.pins}),
    )


def _skittle(pin: Pin, colour: Rgb) -> Skittle:
    near, far = (
        tuple(_turned(run, sides, colour) for run in _runs(pin.profile, steps))
        for sides, steps in (NEAR, FAR)
    )
    return Skittle(pin.profile, near, far)


def _runs(profile: Profile, steps: int) -> list[list[tuple[float, float]]]:
    """Return the rings of each convex part: all of a body that bulges, else what lies between."""
    if not _bulges(profile):
        return [[*pair] for pair in pairwise(profile)]
    rings = [
        (low[0] + (high[0] - low[0]) * k / steps, 0.0)
        for low, high in pairwise(profile)
        for k in range(steps)
    ]
    curve = [(z, _smooth(profile, z)) for z, _ in rings]
    top, head = profile[-1]
    if steps == 1:
        return [[*curve, (top, head)]]
    neck = top - (1.0 - ROUNDED) * head
    below = [ring for ring in curve if ring[0] < neck]
    return [[*below, (neck, _smooth(profile, neck)), (top, ROUNDED * head)]]


def _bulges(profile: Profile) -> bool:
    slopes = [(b[1] - a[1]) / (b[0] - a[0]) for a, b in pairwise(profile)]
    return all(after <= before for before, after in pairwise(slopes))


def _smooth(profile: Profile, z: float) -> float:
    """Return the radius at a height, on the parabola through the radii, at most the greatest."""
    (a, ra), (b, rb), (c, rc) = profile
    radius = (
        ra * (z - b) * (z - c) / ((a - b) * (a - c))
        + rb * (z - a) * (z - c) / ((b - a) * (b - c))
        + rc * (z - a) * (z - b) / ((c - a) * (c - b))
    )
    return min(radius, max(ra, rb, rc))


def _turned(rings: list[tuple[float, float]], sides: int, colour: Rgb) -> Mesh:
    points = [
        (r * cos(2.0 * pi * k / sides), r * sin(2.0 * pi * k / sides), z)
        for z, r in rings
        for k in range(sides)
    ]
    faces: list[tuple[int, ...]] = []
    for ring in range(len(rings) - 1):
        low, high = ring * sides, (ring + 1) * sides
        for k in range(sides):
            after = (k + 1) % sides
            faces.append((low + k, low + after, high + after, high + k))
    last, count = (len(rings) - 1) * sides, len(points)
    points += points[:sides] + points[last:]  # the ends have corners of their own: they are flat
    faces += [tuple(reversed(range(count, count + sides)))]
    faces += [tuple(range(count + sides, count + 2 * sides))]
    return make_mesh(np.array(points), faces, colour, gloss=0.35, smooth=True)


def _rotation(stance: Stance) -> NDArray[np.float64]:
    """Return the turn that leans +z by the tilt along the way, without a twist."""
    (wx, wy), c, s = stance.way, cos(stance.tilt), sin(stance.tilt)
    return np.array(
        [
            [wy * wy + wx * wx * c, wx * wy * (c - 1.0), wx * s],
            [wx * wy * (c - 1.0), wx * wx + wy * wy * c, wy * s],
            [-wx * s, -wy * s, c],
        ]
    )


def _lift(profile: Profile, tilt: float) -> float:
    """Return how high the middle of the foot is for a leaning pin to rest on the bed."""
    return max(r * sin(tilt) - z * cos(tilt) for z, r in profile)


def _shadows(profile: Profile, stance: Stance, lamps: Sequence[Light]) -> list[Disc]:
    found = []
    height, lift = profile[-1][0], _lift(profile, stance.tilt)
    belly = max(r for _, r in profile)
    count = max(2, round(height / (SHADE * belly)))
    for share in ((k + 0.5) / count for k in range(count)):
        along = share * height * sin(stance.tilt)
        x = stance.foot[0] + along * stance.way[0]
        y = stance.foot[1] + along * stance.way[1]
        z = lift + share * height * cos(stance.tilt)
        for lamp in lamps:
            lx, ly, lz = lamp.position
            stretch = z / (lz - z)
            away = hypot(x - lx, y - ly)
            place = x + (x - lx) * stretch, y + (y - ly) * stretch, LIFT
            found.append(
                Disc(place, 1.3 * belly, (0, 0, 0), 0.16 / (1.0 + 0.6 * away), 0.9 * belly)
            )
        near = max(0.0, 1.0 - z / (2.5 * belly))
        if near > 0.0:
            found.append(Disc((x, y, LIFT), 1.4 * belly, (0, 0, 0), 0.5 * near, 0.9 * belly))
    return found


__all__ = ["Skittle", "Skittles", "build_skittles"]
