"""The stage: what a game looks like, as a scene for the renderers.

One idea: what never moves is built once and handed over as the same objects every frame; a
frame only places balls and cue and lays their shadows.
Invariant: everything follows from the table, the balls' kinds and the look; no game is named.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil
from typing import TYPE_CHECKING

from engine.scene.scene import GameObject, Light, Scene
from engine.scene.shape import Disc, Mesh, Polyline, Sphere
from engine.stage import marks
from engine.stage.bed import build_bed, build_pocket
from engine.stage.bodies import build_hole_rims, build_posts
from engine.stage.clearance import borders_of, raise_cue
from engine.stage.cue import CuePose, cue_meshes, place_cue
from engine.stage.cushions import build_cushions
from engine.stage.dimensions import measure
from engine.stage.rails import build_rails
from engine.stage.room import backdrop, build_legs, build_shadow
from engine.stage.shade import build_shade, shade_posts
from engine.stage.skin import facing, paint_skin
from engine.stage.skittles import Skittles, build_skittles
from engine.stage.values import build_values
from engine.stage.wood import toned

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    import numpy as np
    from numpy.typing import NDArray

    from engine.physics.world import Ball
    from engine.scene.camera import Camera, Vector
    from engine.scene.shape import Rgb
    from engine.stage.clearance import Borders
    from engine.stage.dimensions import Frame
    from engine.table.furniture import BallId, PinId, Table
    from engine.table.pin import Stance
    from engine.variant.variant import BallKind, Look, PinKind, Variant

LAMP_HEIGHT = 0.95
LAMP_SPACING = 1.3
BRIGHTNESS = 0.76
"""Light of all lamps on the bed, on the average."""
CHALK: Rgb = (214, 218, 208)
SIGHT: Rgb = (236, 226, 198)
RIM: Rgb = (136, 128, 112)
"""The metal round a hole in the bed."""
FAR = 10.0


@dataclass(frozen=True, slots=True, eq=False)
class Stage:
    """A table ready to be shown: `furniture` never moves, `spheres` has each ball's look."""

    table: Table
    furniture: GameObject
    spheres: Mapping[BallId, Sphere]
    cue: tuple[Mesh, ...]
    lamps: tuple[Light, ...]
    spots: tuple[Disc, ...]
    pins: Skittles
    borders: Borders

    def scene(
        self,
        positions: Mapping[BallId, Vector],
        camera: Camera,
        *,
        orientations: Mapping[BallId, NDArray[np.float64]] | None = None,
        cue: CuePose | None = None,
        aids: Sequence[Mesh | Polyline] = (),
        discs: Sequence[Disc] = (),
        pins: Mapping[PinId, Stance] | None = None,
    ) -> Scene:
        """Return the scene with balls at `positions` (m, their centres) seen by `camera`.

        `orientations` are (3, 3) from each ball's own frame to the world's; a ball without one
        shows its label. `aids` are lines and tints on the cloth, `discs` further flat marks.
        `pins` are those on the table, standing or lying; all stand where nothing is said.
        The `cue` is drawn no lower than it clears the cushion and the wood behind its ball.
        """
        turned = orientations or {}
        rest = _REST
        balls = [
            GameObject((self.spheres[ball],), place, turned.get(ball, rest))
            for ball, place in positions.items()
            if -FAR < place[2] < FAR
        ]
        objects = [self.furniture]
        if aids:
            objects.append(GameObject(tuple(aids)))
        objects += balls
        shown = self.pins.upright if pins is None else pins
        objects += self.pins.objects(shown, camera.eye)
        if cue is not None:
            objects.append(place_cue(self.cue, raise_cue(self.borders, cue)))
        return Scene(
            objects=tuple(objects),
            lights=self.lamps,
            camera=camera,
            background=backdrop(camera),
            ambient=0.40,
            marks=(*self.spots, *discs),
            shadows=tuple(
                shadow
                for ball, place in positions.items()
                for shadow in self._shadows(place, self.spheres[ball].radius)
            )
            + self.pins.shadows(shown, self.lamps),
        )

    def _shadows(self, place: Vector, radius: float) -> list[Disc]:
        """Return a ball's shadow from each lamp, and the dark where it touches the cloth."""
        x, y, z = place
        if z < 0.5 * radius:
            return []
        found = []
        for lamp in self.lamps:
            lx, ly, lz = lamp.position
            stretch = z / (lz - z)
            centre = x + (x - lx) * stretch, y + (y - ly) * stretch, marks.LIFT
            away = ((x - lx) ** 2 + (y - ly) ** 2) ** 0.5
            if away < 1.6 * LAMP_SPACING:
                strength = 0.34 / (1.0 + 0.6 * away)
                found.append(Disc(centre, 1.22 * radius, (0, 0, 0), strength, 0.7 * radius))
        fade = max(0.0, 1.0 - (z - radius) / (4.0 * radius))
        ground = x, y, marks.LIFT
        found.append(Disc(ground, 0.92 * radius, (0, 0, 0), 0.55 * fade, 0.8 * radius))
        return found


_REST = facing()


def build_stage(variant: Variant) -> Stage:
    """Return the stage of a variant, built once."""
    world = variant.world
    return stage_of(world.table, world.balls, variant.balls, variant.look, variant.pins)


def stage_of(
    table: Table,
    bodies: Sequence[Ball],
    kinds: Sequence[BallKind],
    look: Look,
    pins: Sequence[PinKind] = (),
) -> Stage:
    """Return the stage of a table with balls of these bodies and kinds, and its pins."""
    frame = measure(table)
    radii = {body.id: body.radius for body in bodies}
    spheres = {
        kind.id: Sphere(
            radii[kind.id], kind.colour, paint_skin(kind.colour, kind.pattern, kind.label)
        )
        for kind in kinds
    }
    return Stage(
        table=table,
        furniture=GameObject(_furniture(table, frame, look), fixed=True),
        spheres=spheres,
        cue=cue_meshes(),
        lamps=_lamps(table),
        spots=(*shade_posts(table), *marks.build_spots(table, CHALK)),
        pins=build_skittles(table, pins),
        borders=borders_of(table),
    )


def _furniture(table: Table, frame: Frame, look: Look) -> tuple[Mesh | Polyline, ...]:
    liner = _mix(look.pocket, (58, 54, 50), 0.35)
    rubber = _mix(look.cloth, (255, 255, 255), 0.07)
    return (
        *build_shadow(table, frame),
        *build_legs(table, frame, toned(look.rail, 1.2)),
        *(build_pocket(pocket, look.pocket) for pocket in table.pockets),
        build_bed(table, frame, look.cloth),
        *build_shade(table),
        *marks.build_gleam(table),
        *marks.build_lines(table, CHALK),
        *build_values(table, CHALK),
        *build_hole_rims(table, RIM),
        *build_cushions(table, frame, rubber),
        *build_posts(table, frame, rubber, look.rail),
        *build_rails(table, frame, look.rail, liner),
        *(marks.build_sights(table, frame, SIGHT) if look.sights else ()),
    )


def _mix(a: Rgb, b: Rgb, share: float) -> Rgb:
    red, green, blue = (round(u + (v - u) * share) for u, v in zip(a, b, strict=True))
    return red, green, blue


def _lamps(table: Table) -> tuple[Light, ...]:
    """Return a row of lamps along the table, with `BRIGHTNESS` on the bed on the average."""
    count = max(1, ceil(table.length / LAMP_SPACING - 0.5))
    places = [table.length * ((k + 0.5) / count - 0.5) for k in range(count)]
    grid = [
        (table.length * (i / 8.0 - 0.5), table.width * (j / 8.0 - 0.5))
        for i in range(9)
        for j in range(9)
    ]
    light = sum(
        LAMP_HEIGHT / ((x - lamp) ** 2 + y * y + LAMP_HEIGHT**2) for x, y in grid for lamp in places
    ) / len(grid)
    power = BRIGHTNESS / light
    return tuple(Light((x, 0.0, LAMP_HEIGHT), power) for x in places)
