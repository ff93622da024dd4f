"""The scenes of the reference pictures, one feature of the renderers each, seen from near."""

from __future__ import annotations

from dataclasses import replace
from math import radians
from pathlib import Path
from typing import TYPE_CHECKING

from engine.physics.world import Ball
from engine.scene.camera import Camera
from engine.scene.shape import Disc
from engine.stage.cameras import above_camera, cue_camera, orbit_camera
from engine.stage.cue import CuePose
from engine.stage.marks import flat_path, flat_ring, tint_zone
from engine.stage.skin import facing
from engine.stage.stage import stage_of
from engine.table.furniture import Area, BallId, HalfPlane, Pin, PinId, Pocket, PocketId
from engine.table.pin import Stance
from engine.variant.load import read_draft
from engine.variant.variant import BallKind, PinKind
from tools.render_scenes import (
    LOOK,
    RADIUS,
    make_stage,
    plain_table,
    pocket_table,
    round_jaw_table,
)

if TYPE_CHECKING:
    from collections.abc import Callable

    from engine.scene.camera import Size, Vector
    from engine.scene.scene import Scene
    from engine.scene.shape import Mesh, Polyline
    from engine.stage.stage import Stage

SIZE: Size = (256, 144)
TABLES = Path(__file__).resolve().parent.parent / "tests" / "variant" / "tables"
PROFILE = ((0.0, 0.005), (0.01, 0.0035), (0.014, 0.0045), (0.022, 0.002), (0.025, 0.0))
SKITTLE = tuple((2.0 * height, 2.0 * radius) for height, radius in PROFILE)


def jaw_hides_ball() -> Scene:
    """Return two balls at a corner's jaw, one of them half behind it."""
    stage = make_stage(pocket_table())
    names = list(stage.spheres)
    places = {names[1]: (1.262, 0.615, RADIUS), names[2]: (1.16, 0.59, RADIUS)}
    return stage.scene(places, Camera((0.98, 0.75, 0.13), (1.26, 0.62, 0.02)))


def ball_drops_into_pocket() -> Scene:
    """Return a ball half sunk in a side pocket, and one before it."""
    stage = make_stage(pocket_table())
    names = list(stage.spheres)
    places = {names[3]: (0.0, 0.7, -0.012), names[4]: (0.0, 0.58, RADIUS)}
    return stage.scene(places, Camera((0.05, 0.2, 0.3), (0.0, 0.65, 0.0)))


def label_band_and_shadow() -> Scene:
    """Return balls with stripes and numbers in a row."""
    stage = make_stage(plain_table())
    names = list(stage.spheres)
    places = {names[k]: (0.0, 0.075 * (k - 2), RADIUS) for k in range(5)}
    return stage.scene(places, Camera((-0.4, -0.12, 0.3), (0.0, 0.0, 0.02), field=0.5))


def cue_behind_ball_and_aids() -> Scene:
    """Return the cue at a ball, with lines, a ring, a tinted zone and a flat mark."""
    stage = make_stage(round_jaw_table())
    names = list(stage.spheres)
    places = {names[0]: (-0.8, 0.1, RADIUS), names[5]: (-0.2, 0.1, RADIUS)}
    pose = CuePose(places[names[0]], RADIUS, 0.0, 0.1, side=0.3, follow=0.3, gap=0.02)
    zone = Area((HalfPlane((-0.5, 0.0), (-1.0, 0.0), closed=True),))
    tint = tint_zone(zone, stage.table, (255, 255, 120))
    aids: list[Mesh | Polyline] = [
        *([tint] if tint else []),
        flat_path([(-0.8, 0.1), (-0.25, 0.1)], (255, 255, 255)),
        flat_ring((-0.25, 0.1), RADIUS, (255, 255, 255)),
    ]
    camera = cue_camera(stage.table, (-0.8, 0.1), 0.0)
    disc = Disc((-0.5, -0.2, 0.001), 0.05, (240, 40, 40), 0.8, 0.01)
    return stage.scene(places, camera, cue=pose, aids=aids, discs=[disc])


def whole_table_above() -> Scene:
    """Return a table with round jaws and sixteen balls from above."""
    stage = make_stage(round_jaw_table())
    names = list(stage.spheres)
    places = {name: (0.2 * k - 1.5, 0.1 * (k % 5) - 0.2, RADIUS) for k, name in enumerate(names)}
    return stage.scene(places, above_camera(stage.table, SIZE[0] / SIZE[1]))


def cloth_under_lamps() -> Scene:
    """Return bare cloth along the table, lighter under each lamp."""
    stage = make_stage(plain_table())
    return stage.scene({}, Camera((-1.2, 0.0, 0.5), (0.6, 0.0, 0.0), field=0.9))


def sights_on_wood() -> Scene:
    """Return a rail with its sights, its grain of light and the cushion before it."""
    stage = make_stage(plain_table())
    return stage.scene({}, Camera((0.1, 0.45, 0.22), (0.35, 0.76, 0.03)))


def corner_pocket() -> Scene:
    """Return a corner pocket with straight jaws, dark and deep."""
    stage = make_stage(pocket_table())
    return stage.scene({}, Camera((0.95, 0.3, 0.34), (1.28, 0.64, 0.0)))


def side_pocket_with_round_jaws() -> Scene:
    """Return a side pocket with round jaws."""
    stage = make_stage(round_jaw_table())
    return stage.scene({}, Camera((0.0, 0.5, 0.3), (0.0, 0.92, 0.0)))


def one_ball(stage: Stage, number: int, distance: float = 0.2) -> Scene:
    """Return one ball from near."""
    ball = list(stage.spheres)[number]
    place = {ball: (0.2, 0.1, RADIUS)}
    eye = (0.2 - distance, 0.1 - 0.2 * distance, distance)
    camera = Camera(eye, (0.2, 0.1, RADIUS), field=0.5)
    return stage.scene(place, camera)


def number_on_stripe() -> Scene:
    """Return a striped ball with a number of two digits."""
    return one_ball(make_stage(plain_table()), 11)


def number_on_plain() -> Scene:
    """Return a plain ball with a number."""
    return one_ball(make_stage(plain_table()), 4)


def highlights() -> Scene:
    """Return a ball of one colour with the lamps' highlights."""
    return one_ball(make_stage(plain_table()), 0)


def spin_marks() -> Scene:
    """Return a ball with dots, as it faces, turned and turned further."""
    names = [BallId(f"dotted-{k}") for k in range(3)]
    kinds = [BallKind(name, (240, 236, 220), "dots") for name in names]
    bodies = [Ball(name, RADIUS, 0.17) for name in names]
    stage = stage_of(plain_table(), bodies, kinds, LOOK)
    places: dict[BallId, Vector] = {n: (0.08 * (k - 1), 0.0, RADIUS) for k, n in enumerate(names)}
    turned = {name: facing(58.0 - 36.0 * k) for k, name in enumerate(names)}
    camera = Camera((0.0, -0.3, 0.2), (0.0, 0.0, RADIUS), field=0.5)
    return stage.scene(places, camera, orientations=turned)


def shadows_from_each_lamp() -> Scene:
    """Return two balls between two lamps, one of them in the air."""
    stage = make_stage(plain_table())
    names = list(stage.spheres)
    places = {names[0]: (0.0, 0.0, RADIUS), names[6]: (0.14, 0.05, 0.09)}
    return stage.scene(places, Camera((0.05, -0.45, 0.3), (0.06, 0.0, 0.03), field=0.5))


def pins_standing_and_falling() -> Scene:
    """Return three pins: one stands, one leans, one lies."""
    spots = {PinId("a"): (-0.06, 0.0), PinId("b"): (0.0, 0.0), PinId("c"): (0.06, 0.0)}
    pins = tuple(Pin(pin, at, SKITTLE, 0.02) for pin, at in spots.items())
    table = replace(plain_table(), pins=pins)
    kinds = [PinKind(pin, (200, 30, 30) if pin == "b" else (236, 230, 214)) for pin in spots]
    stage = stage_of(table, [], [], LOOK, kinds)
    tilts = (0.0, radians(35.0), radians(90.0))
    stances = {
        pin: Stance(at, (0.6, 0.8), tilt)
        for (pin, at), tilt in zip(spots.items(), tilts, strict=True)
    }
    camera = Camera((0.0, -0.26, 0.13), (0.0, 0.0, 0.02), field=0.5)
    return stage.scene({}, camera, pins=stances)


def cue_tip() -> Scene:
    """Return the tip and ferrule of a raised cue at a ball."""
    stage = make_stage(plain_table())
    ball = next(iter(stage.spheres))
    place = (0.0, 0.0, RADIUS)
    pose = CuePose(place, RADIUS, 0.0, radians(20.0), side=0.0, follow=0.2, gap=0.015)
    camera = Camera((-0.06, -0.22, 0.12), (-0.04, 0.0, 0.035), field=0.5)
    return stage.scene({ball: place}, camera, cue=pose)


def bed_hole() -> Scene:
    """Return a hole in the bed with a ball at its rim and a ball that drops."""
    table = plain_table()
    hole = Pocket(PocketId("hole"), (0.0, 0.0), 0.05, ((-0.05, 0.0), (0.05, 0.0)))
    stage = make_stage(replace(table, pockets=(hole,)))
    names = list(stage.spheres)
    places = {names[2]: (0.1, 0.02, RADIUS), names[5]: (-0.012, 0.0, -0.01)}
    return stage.scene(places, Camera((0.05, -0.35, 0.3), (0.02, 0.0, 0.0), field=0.5))


def _drafted(name: str) -> Stage:
    draft, mistakes = read_draft(TABLES / name)
    if draft is None or mistakes:
        raise ValueError(f"{name} cannot be read")
    return stage_of(draft.world.table, draft.world.balls, draft.balls, draft.look, draft.pins)


def ell_shaped_table() -> Scene:
    """Return an L-shaped table from above."""
    stage = _drafted("ell.toml")
    return stage.scene({}, above_camera(stage.table, SIZE[0] / SIZE[1]))


def rounded_table() -> Scene:
    """Return a table with round cushions from one side."""
    stage = _drafted("rounded.toml")
    return stage.scene({}, orbit_camera(stage.table, 2.4, 0.6))


def posts() -> Scene:
    """Return posts on the bed, one of them upright."""
    stage = _drafted("posts.toml")
    return stage.scene({}, Camera((-0.3, -0.5, 0.35), (0.12, 0.0, 0.0), field=0.6))


def upright_post_from_above() -> Scene:
    """Return posts from straight above, where an upright one shows no more than a rim."""
    stage = _drafted("posts.toml")
    up = (0.0, 1.0, 0.0)
    return stage.scene({}, Camera((0.0, 0.0, 1.4), (0.0, 0.0, 0.0), up, field=0.4))


def spots_and_lines() -> Scene:
    """Return a line across the cloth with spots, near enough to see their width."""
    stage = _drafted("posts.toml")
    x = -0.25 * stage.table.length
    return stage.scene({}, Camera((x - 0.35, -0.25, 0.2), (x, 0.0, 0.0), field=0.6))


def eye_in_the_cushion() -> Scene:
    """Return what an eye sees that is nearer to a cushion than the near plane."""
    stage = make_stage(pocket_table())
    names = list(stage.spheres)
    y = stage.table.width / 2.0
    places = {names[3]: (0.5, 0.3, RADIUS), names[8]: (0.4, y - RADIUS, RADIUS)}
    return stage.scene(places, Camera((0.3, y + 0.02, 0.06), (0.6, 0.1, 0.0), field=0.9))


SCENES: dict[str, Callable[[], Scene]] = {
    make.__name__: make
    for make in (
        jaw_hides_ball,
        ball_drops_into_pocket,
        label_band_and_shadow,
        cue_behind_ball_and_aids,
        whole_table_above,
        cloth_under_lamps,
        sights_on_wood,
        corner_pocket,
        side_pocket_with_round_jaws,
        number_on_stripe,
        number_on_plain,
        highlights,
        spin_marks,
        shadows_from_each_lamp,
        pins_standing_and_falling,
        cue_tip,
        bed_hole,
        ell_shaped_table,
        rounded_table,
        posts,
        upright_post_from_above,
        spots_and_lines,
        eye_in_the_cushion,
    )
}

__all__ = ["SCENES", "SIZE"]
