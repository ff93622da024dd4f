"""A shot as a short moving picture, and as a picture of its ways; no window is needed.

One idea: the stroke is played again and drawn moment by moment from above. Invariant: what is shown
is the trace of the shot itself, at the speed at which it was played.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PIL import Image

from engine.app.turning import Turning
from engine.game.observe import simulate_shot
from engine.game.referee import take_choice
from engine.render.renderer import make_renderer
from engine.stage.cameras import above_camera
from engine.stage.skin import facing
from engine.stage.stage import build_stage

if TYPE_CHECKING:
    from collections.abc import Iterator

    from engine.game.match import Match
    from engine.game.shot import Shot
    from engine.game.situation import Situation
    from engine.physics.trace import Trace
    from engine.records.run import Outcome
    from engine.scene.camera import Size
    from engine.stage.stage import Stage
    from engine.variant.variant import Variant

SIZE = (640, 360)
RATE = 20
"""Pictures a second."""
LONGEST = 15.0
"""Seconds of a shot that are shown."""
COLOURS = 128


class NoStrokeError(ValueError):
    """A shot that cannot be shown moving, for want of a stroke or of places."""


def write_clip(
    path: Path,
    variant: Variant,
    before: Situation,
    shot: Shot,
    *,
    size: Size = SIZE,
    renderer: str = "scanline",
) -> None:
    """Write a GIF of a shot at `size` (pixels), as it was played.

    Raises NoStrokeError for a shot without a stroke or of which no place is known, OSError where
    the file cannot be written.
    """
    if shot.strike is None or not before.rest.positions:
        raise NoStrokeError("a shot is shown moving only where a stroke and its places are known")
    try:
        trace = simulate_shot(variant, take_choice(variant, before, shot).after, shot)
    except (KeyError, ValueError) as trouble:
        raise NoStrokeError(f"the stroke cannot be played: {trouble}") from trouble
    pictures = _pictures(build_stage(variant), trace, size, renderer)
    first = next(pictures).quantize(COLOURS, dither=Image.Dither.NONE)
    rest = [one.quantize(palette=first, dither=Image.Dither.NONE) for one in pictures]
    path.parent.mkdir(parents=True, exist_ok=True)
    first.save(path, save_all=True, append_images=rest, duration=1000 // RATE, loop=0)


def _pictures(stage: Stage, trace: Trace, size: Size, renderer: str) -> Iterator[Image.Image]:
    drawer, camera = make_renderer(renderer), above_camera(stage.table, size[0] / size[1])
    turning, front = Turning(trace), facing()
    end = min(trace.duration, LONGEST)
    pixels = np.zeros((size[1], size[0], 3), np.uint8)
    for time in [*np.arange(0.0, end, 1.0 / RATE).tolist(), end]:
        rows = trace.positions([time])[0]
        turned = turning.at(time)
        scene = stage.scene(
            {ball.id: tuple(row.tolist()) for ball, row in zip(trace.balls, rows, strict=True)},
            camera,
            orientations={
                ball.id: turn @ front for ball, turn in zip(trace.balls, turned, strict=True)
            },
            pins=trace.pins.stances(time),
        )
        drawer.render(scene, pixels)
        yield Image.fromarray(pixels)


def outcome_of(match: Match) -> Outcome:
    """Return the last shot of a match as the outcome of a record; raises RecordError."""
    from engine.records.read import read_record_text  # noqa: PLC0415
    from engine.records.run import run_record  # noqa: PLC0415
    from engine.records.write import record_text  # noqa: PLC0415

    record = read_record_text(record_text(match), Path("shot.toml"), lambda _name: match.variant)
    return run_record(record)


__all__ = ["LONGEST", "RATE", "SIZE", "NoStrokeError", "outcome_of", "write_clip"]
