"""Pictures of shots for the documents: `python -m tools.shot_pictures [--out DIR] [NAME...]`.

One idea: a picture is a table, where its balls lie, a stroke, an eye and some moments; the way of
every ball up to each moment is drawn on the cloth, and the moments stand side by side.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass, replace
from math import radians
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PIL import Image

from engine.physics.simulate import simulate
from engine.physics.world import Strike
from engine.render.renderer import make_renderer
from engine.scene.camera import Camera
from engine.scene.shape import Polyline
from engine.stage.cameras import above_camera
from engine.stage.marks import flat_path
from engine.stage.stage import stage_of
from engine.table.furniture import BallId
from engine.variant.load import read_draft

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

    from engine.physics.trace import Trace
    from engine.scene.camera import Vector
    from engine.scene.scene import Scene
    from engine.stage.stage import Stage
    from engine.table.furniture import Point
    from engine.variant.assemble import Draft

    Image3 = NDArray[np.uint8]

ROOT = Path(__file__).resolve().parent.parent
IMAGES = ROOT / "docs" / "images"
TABLES = ROOT / "tests" / "variant" / "tables"
FINE = 0.004
"""The ways are drawn in steps of so many seconds."""
PALE = (240, 240, 235)


@dataclass(frozen=True, slots=True)
class Picture:
    """What is shown: a game or a file, balls (m), who is struck and how (degrees), and when (s).

    `eye` and `target` are places (m), None for the camera above; `size` is that of one moment.
    """

    table: str | Path
    balls: Mapping[str, Point]
    struck: str
    speed: float
    heading: float
    moments: tuple[float, ...]
    eye: Vector | None = None
    target: Vector = (0.0, 0.0, 0.01)
    side: float = 0.0
    follow: float = 0.0
    size: tuple[int, int] = (960, 540)
    renderer: str = "scanline"
    elevation: float = 0.0
    ghosts: float = 0.0
    """The struck ball is seen at every so many seconds up to the moment; 0 for not."""


PICTURES: Mapping[str, Picture] = {
    "five-pins-shot": Picture(
        table="five_pins",
        balls={"white": (-0.95, -0.31), "yellow": (-0.55, -0.155), "red": (0.71, 0.0)},
        struck="white",
        speed=3.4,
        heading=22.2,
        moments=(0.228, 0.27, 0.4),
        eye=(-0.27, -0.3, 0.2),
        target=(0.0, 0.01, 0.0),
        size=(480, 400),
    ),
    "pins-falling": Picture(
        table="danish_pins",
        balls={"red": (-0.75, -0.2), "white-1": (-0.4, -0.1), "white-2": (0.71, 0.0)},
        struck="red",
        speed=1.9,
        heading=16.0,
        moments=(0.36, 0.43, 0.52),
        eye=(-0.42, -0.44, 0.3),
        target=(0.0, 0.0, 0.035),
        size=(480, 400),
    ),
    "ell-shot": Picture(
        table=TABLES / "ell.toml",
        balls={"cue": (-0.9, -0.35), "1": (0.2, -0.5), "2": (-0.6, 0.55), "3": (0.9, -0.1)},
        struck="cue",
        speed=4.5,
        heading=31.0,
        moments=(9.0,),
    ),
    "bumpers-shot": Picture(
        table=TABLES / "posts.toml",
        balls={"cue": (-0.5, 0.0), "1": (0.5, 0.1), "2": (0.5, -0.1), "3": (0.0, 0.3)},
        struck="cue",
        speed=3.0,
        heading=7.0,
        moments=(5.4,),
    ),
    "jump": Picture(
        table="eight_ball",
        balls={"cue": (-0.55, 0.0), "8": (-0.26, 0.0), "1": (0.35, 0.03)},
        struck="cue",
        speed=3.0,
        heading=0.0,
        elevation=42.0,
        moments=(0.36,),
        ghosts=0.04,
        eye=(-0.16, -0.56, 0.16),
        target=(-0.16, 0.0, 0.045),
        size=(960, 400),
    ),
    "masse": Picture(
        table="straight_rail",
        balls={"white": (-0.35, 0.03), "yellow": (-0.08, -0.015), "red": (0.3, -0.1)},
        struck="white",
        speed=3.0,
        heading=45.0,
        elevation=60.0,
        side=0.3,
        follow=-0.4,
        moments=(1.6,),
        ghosts=0.1,
        eye=(-0.02, -0.3, 0.85),
        target=(-0.02, -0.01, 0.0),
        size=(960, 480),
    ),
}


def draw(picture: Picture) -> Image3:
    """Return the pixels of a picture, its moments side by side."""
    draft, mistakes = read_draft(picture.table)
    if draft is None or mistakes:
        message = f"{picture.table} cannot be read"
        raise ValueError(message)
    trace = play(draft, picture)
    world = draft.world
    stage = stage_of(world.table, world.balls, draft.balls, draft.look, draft.pins)
    frames = []
    for moment in picture.moments:
        width, height = picture.size
        pixels = np.zeros((height, width, 3), np.uint8)
        scene = _scene(draft, stage, trace, picture, moment)
        make_renderer(picture.renderer).render(scene, pixels)
        frames.append(pixels)
    return np.concatenate(frames, axis=1)


def play(draft: Draft, picture: Picture) -> Trace:
    """Return the shot of a picture, played."""
    layout = {BallId(ball): at for ball, at in picture.balls.items()}
    strike = Strike(
        picture.speed,
        radians(picture.heading),
        radians(picture.elevation),
        side=picture.side,
        follow=picture.follow,
    )
    return simulate(draft.world, layout, BallId(picture.struck), strike)


def _scene(draft: Draft, stage: Stage, trace: Trace, picture: Picture, moment: float) -> Scene:
    places = trace.positions([moment])[0]
    shown = {
        ball.id: (float(at[0]), float(at[1]), float(at[2]))
        for ball, at in zip(trace.balls, places, strict=True)
    }
    camera = above_camera(draft.world.table, picture.size[0] / picture.size[1])
    if picture.eye is not None:
        camera = Camera(picture.eye, picture.target)
    scene = stage.scene(
        shown, camera, aids=_ways(draft, trace, moment), pins=trace.pins.stances(moment)
    )
    return _with_ghosts(scene, stage, trace, picture, moment) if picture.ghosts else scene


def _with_ghosts(
    scene: Scene, stage: Stage, trace: Trace, picture: Picture, moment: float
) -> Scene:
    """Return the scene with the struck ball also where it was before."""
    struck = BallId(picture.struck)
    seat = [ball.id for ball in trace.balls].index(struck)
    objects, shadows = list(scene.objects), list(scene.shadows)
    for x, y, z in trace.positions(np.arange(0.0, moment, picture.ghosts))[:, seat]:
        alone = stage.scene({struck: (float(x), float(y), float(z))}, scene.camera)
        objects += [one for one in alone.objects if one is not stage.furniture]
        shadows += alone.shadows
    return replace(scene, objects=tuple(objects), shadows=tuple(shadows))


def _ways(draft: Draft, trace: Trace, moment: float) -> list:  # type: ignore[type-arg]
    """Return the way of every ball that has moved, in its own colour."""
    colours = {kind.id: kind.colour for kind in draft.balls}
    times = np.arange(0.0, moment, FINE)
    way = trace.positions(times)
    found = []
    for number, ball in enumerate(trace.balls):
        points = [(float(x), float(y)) for x, y, z in way[:, number] if z > 0.0]
        colour = colours.get(ball.id, PALE)
        if np.ptp(np.array(points), axis=0).max() > FINE:
            found.append(flat_path(points, colour, 0.005, 0.8))
        if (way[:, number, 2] > ball.radius + 1e-9).any():
            found.append(Polyline(way[:, number].astype(np.float32), colour, 0.002, 0.8))
    return found


def main() -> None:
    """Draw the pictures named, or all."""
    parser = argparse.ArgumentParser(prog="python -m tools.shot_pictures", description=__doc__)
    parser.add_argument("names", nargs="*", help=f"some of: {', '.join(PICTURES)}")
    parser.add_argument("--out", type=Path, default=IMAGES, metavar="DIR")
    chosen = parser.parse_args()
    chosen.out.mkdir(parents=True, exist_ok=True)
    for name in chosen.names or PICTURES:
        path = chosen.out / f"{name}.png"
        Image.fromarray(draw(PICTURES[name])).save(path, optimize=True)
        print(path)


if __name__ == "__main__":
    main()
