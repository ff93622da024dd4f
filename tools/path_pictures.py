"""Diagrams of classic shots for the documents: `python -m tools.path_pictures [--out DIR]`.

One idea: several strokes that differ in one thing are played from the same places, and the ways
of their balls are drawn over each other as seen from above, each with what was measured on it.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass, replace
from math import asin, atan2, cos, degrees, radians, sin
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from engine import research
from engine.physics.events import BallsCollided
from engine.physics.world import Strike

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from numpy.typing import NDArray

    from engine.physics.trace import Trace
    from engine.research import Lab
    from engine.table.furniture import Point

    Floats = NDArray[np.float64]
    Placing = Callable[[Floats | Point], tuple[float, float]]

IMAGES = Path(__file__).resolve().parent.parent / "docs" / "images"
GAME, CUE, OTHER = "eight_ball", "cue", "8"
CLOTH, CHALK, DARK = (24, 96, 66), (236, 236, 228), (20, 24, 22)
COLOURS = ((244, 208, 63), (236, 112, 99), (133, 193, 233), (187, 143, 206), (248, 196, 113))
SCALE, SMOOTH = 640.0, 3
"""Pixels a metre, and how many times finer it is drawn first."""


@dataclass(frozen=True, slots=True)
class Line:
    """One stroke of a diagram: its trace, what is said of it, and until when (s) it is drawn."""

    trace: Trace
    words: str
    until: float


@dataclass(frozen=True, slots=True)
class Diagram:
    """What is drawn: a part of the bed (m, from corner to corner), a heading, and the strokes."""

    low: Point
    high: Point
    title: str
    lines: tuple[Line, ...]


def _cut(lab: Lab, cut: float, far: float) -> dict[str, Point]:
    """Return the object ball at the origin and the cue ball `far` (m) from where it hits, at -x."""
    apart = 2.0 * lab.world.balls[0].radius
    return {CUE: (-apart * cos(cut) - far, -apart * sin(cut)), OTHER: (0.0, 0.0)}


def _hit(trace: Trace) -> float:
    return next(event.time for event in trace.events() if isinstance(event, BallsCollided))


def _way(trace: Trace, ball: str, time: float) -> float:
    v = trace.velocities([time])[0, [str(one.id) for one in trace.balls].index(ball)]
    return degrees(atan2(v[1], v[0]))


def _rolling_way(trace: Trace, ball: str) -> float:
    """Return a ball's direction (degrees) once it rolls after the first meeting."""
    return _way(trace, ball, _hit(trace) + 0.6)


def thirty_degrees(lab: Lab) -> Diagram:
    """Draw how a rolling cue ball leaves at about 30 degrees, from thin hits to thick ones."""
    lines = []
    for name, fraction in (("1/4", 0.25), ("1/2", 0.5), ("3/4", 0.75)):
        layout = _cut(lab, asin(1.0 - fraction), 0.4)
        trace = lab.shoot(layout, Strike(1.5, 0.0, follow=0.4))
        turned = abs(_rolling_way(trace, CUE))
        lines.append(Line(trace, f"{name} ball: {turned:.0f} degrees", _hit(trace) + 0.7))
    return Diagram((-0.53, -0.5), (0.93, 0.45), "the 30-degree rule", tuple(lines))


def draw_and_follow(lab: Lab) -> Diagram:
    """Draw a half-ball hit with the tip from far below to far above the middle."""
    lines = []
    for follow in (-0.5, -0.25, 0.0, 0.25, 0.5):
        layout = _cut(lab, radians(30.0), 0.45)
        trace = lab.shoot(layout, Strike(2.0, 0.0, follow=follow))
        turned = abs(_rolling_way(trace, CUE))
        where = "in the middle" if follow == 0.0 else f"{follow:+.2f} R"
        words = f"tip {where}: {turned:.0f} degrees"
        lines.append(Line(trace, words, _hit(trace) + 0.8))
    return Diagram((-0.55, -0.62), (0.95, 0.42), "draw and follow, half-ball hit", tuple(lines))


def throw(lab: Lab) -> Diagram:
    """Draw a stun shot: without friction between the balls, with it, and with side."""
    lines = []
    for name, ball_ball, side in (
        ("no friction", "elastic", 0.0),
        ("no side", "frictional", 0.0),
        ("inside, 0.4 R", "frictional", -0.4),
        ("outside, 0.4 R", "frictional", 0.4),
    ):
        tried = lab.with_models(ball_ball=ball_ball)
        layout = _cut(lab, radians(30.0), 0.3)
        trace = _straight(tried, layout, Strike(1.2, 0.0, follow=-0.08, side=side))
        thrown = 30.0 - _way(trace, OTHER, _hit(trace) + 1e-6)
        lines.append(Line(trace, f"{name}: thrown {thrown:+.1f} degrees", _hit(trace) + 1.2))
    return Diagram((-0.42, -0.46), (1.05, 0.5), "throw at a cut of 30 degrees", tuple(lines))


def _straight(lab: Lab, layout: dict[str, Point], strike: Strike) -> Trace:
    """Return the shot aimed so that squirt does not turn the ball's first way."""
    alone = lab.shoot({CUE: layout[CUE]}, strike)
    off = radians(_way(alone, CUE, 0.0))
    return lab.shoot(layout, replace(strike, heading=strike.heading - off))


DIAGRAMS: dict[str, Callable[[Lab], Diagram]] = {
    "thirty-degrees": thirty_degrees,
    "draw-and-follow": draw_and_follow,
    "throw": throw,
}


def paint(diagram: Diagram, radius: float) -> Image.Image:
    """Return a diagram as a picture."""
    scale = SCALE * SMOOTH
    (x0, y0), (x1, y1) = diagram.low, diagram.high
    size = round((x1 - x0) * scale), round((y1 - y0) * scale)
    picture = Image.new("RGB", size, CLOTH)
    pen = ImageDraw.Draw(picture)

    def at(point: Floats | Point) -> tuple[float, float]:
        return (float(point[0]) - x0) * scale, (y1 - float(point[1])) * scale

    for line, colour in zip(diagram.lines, COLOURS, strict=False):
        _paint_line(pen, line, colour, at)
    for line, colour in zip(diagram.lines, COLOURS, strict=False):
        _paint_balls(pen, line, colour, at, radius * scale)
    _paint_words(pen, diagram)
    return picture.resize((size[0] // SMOOTH, size[1] // SMOOTH), Image.Resampling.LANCZOS)


def _paint_line(pen: ImageDraw.ImageDraw, line: Line, colour: tuple[int, ...], at: Placing) -> None:
    for way in _ways(line):
        pen.line([at(point) for point in way], fill=colour, width=2 * SMOOTH, joint="curve")


def _ways(line: Line) -> Iterator[Floats]:
    times = np.arange(0.0, line.until, 0.004)
    places = line.trace.positions(times)[..., :2]
    yield from np.moveaxis(places, 1, 0)


def _paint_balls(
    pen: ImageDraw.ImageDraw, line: Line, colour: tuple[int, ...], at: Placing, radius: float
) -> None:
    trace = line.trace
    cue = [str(one.id) for one in trace.balls].index(CUE)
    first, ghost, last = trace.positions([0.0, _hit(trace), line.until])
    for place, inside in ((first, True), (last, False)):
        for k, (x, y, _) in enumerate(place):
            u, v = at((x, y))
            box = (u - radius, v - radius, u + radius, v + radius)
            body = CHALK if k == cue else DARK
            pen.ellipse(box, fill=body if inside else None, outline=colour, width=2 * SMOOTH)
    u, v = at(ghost[cue])
    pen.ellipse((u - radius, v - radius, u + radius, v + radius), outline=CHALK, width=SMOOTH)


def _paint_words(pen: ImageDraw.ImageDraw, diagram: Diagram) -> None:
    font = ImageFont.load_default(19 * SMOOTH)
    left, row = 14 * SMOOTH, 26 * SMOOTH
    pen.text((left, 10 * SMOOTH), diagram.title, fill=CHALK, font=font)
    for number, (line, colour) in enumerate(zip(diagram.lines, COLOURS, strict=False), 1):
        top = 10 * SMOOTH + number * row
        pen.line((left, top + row / 2, left + row, top + row / 2), fill=colour, width=4 * SMOOTH)
        pen.text((left + 1.3 * row, top), line.words, fill=CHALK, font=font)


def main() -> None:
    """Draw all diagrams."""
    parser = argparse.ArgumentParser(prog="python -m tools.path_pictures", description=__doc__)
    parser.add_argument("--out", type=Path, default=IMAGES, metavar="DIR")
    folder = parser.parse_args().out
    folder.mkdir(parents=True, exist_ok=True)
    lab = research.load(GAME)
    for name, make in DIAGRAMS.items():
        path = folder / f"{name}.png"
        paint(make(lab), lab.world.balls[0].radius).save(path, optimize=True)
        print(path)


if __name__ == "__main__":
    main()
