"""A record as a picture: the table from above, before and after each shot, and what differs.

One idea: a ring is where a ball lay, a disc where it came to rest, a line the way between them,
and a red cross a place that the record expects and the referee does not give.
Invariant: a shot of which no position is known has no picture, only its words.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin
from typing import TYPE_CHECKING

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from engine.game.situation import ball_to_strike
from engine.table.furniture import Curve

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from pathlib import Path

    from engine.records.compare import Difference
    from engine.records.run import Judgement, Outcome
    from engine.table.furniture import BallId, Point, Shape, Table
    from engine.variant.variant import Variant

WIDTH = 960
MARGIN = 40
LINE = 18
FRAMES = 400
PAPER, INK, RAIL, BED = (250, 249, 246), (40, 40, 40), (120, 90, 60), (196, 214, 204)
DIFFERS = (200, 30, 30)
MARK = (150, 165, 155)
DEFAULT = 12


@dataclass(frozen=True, slots=True)
class _Plan:
    """From metres on the bed to pixels of a picture whose table begins at `top`."""

    table: Table
    scale: float
    top: int

    def at(self, point: Point) -> tuple[float, float]:
        x, y = point
        return (
            MARGIN + (x + self.table.length / 2) * self.scale,
            self.top + (self.table.width / 2 - y) * self.scale,
        )

    @property
    def height(self) -> int:
        return round(self.table.width * self.scale)


def draw_outcome(outcome: Outcome, path: Path) -> bool:
    """Write a PNG of a record; False where no shot has a position that is known."""
    shots = [one for one in enumerate(outcome.judgements, 1) if _is_known(one[1])]
    if not shots:
        return False
    table = outcome.record.variant.world.table
    scale = (WIDTH - 2 * MARGIN) / table.length
    words = {number: list(_words(outcome, number)) for number, _ in shots}
    high = round(table.width * scale) + MARGIN
    total = 2 * MARGIN + sum(high + LINE * len(words[number]) + MARGIN for number, _ in shots)
    image = Image.new("RGB", (WIDTH, total), PAPER)
    pen = ImageDraw.Draw(image)
    font = ImageFont.load_default(DEFAULT)
    pen.text((MARGIN, 6), outcome.record.title, INK, font)
    top = 2 * MARGIN
    for number, judged in shots:
        plan = _Plan(table, scale, top)
        _draw_table(pen, plan)
        _draw_balls(pen, plan, outcome, judged, number)
        top += plan.height + MARGIN
        for text, colour in words[number]:
            pen.text((MARGIN, top - MARGIN // 4), text, colour, font)
            top += LINE
        top += MARGIN
    path.parent.mkdir(parents=True, exist_ok=True)
    image.save(path)
    return True


def _is_known(judged: Judgement) -> bool:
    return bool(judged.before.rest.positions or judged.shot.after.positions)


def _words(outcome: Outcome, number: int) -> Iterator[tuple[str, tuple[int, int, int]]]:
    judged = outcome.judgements[number - 1]
    yield f"shot {number}, player {judged.before.shooter}", INK
    for one in _of(outcome, number):
        yield f"{one.key}: expected {_short(one.expected)}", DIFFERS
        yield f"{'':{len(one.key)}}  got {_short(one.got)}", DIFFERS


def _short(value: object, most: int = 120) -> str:
    text = str(value)
    return text if len(text) <= most else f"{text[: most - 3]}..."


def _of(outcome: Outcome, number: int) -> list[Difference]:
    return [one for one in outcome.differences if one.shot == number]


def _draw_table(pen: ImageDraw.ImageDraw, plan: _Plan) -> None:
    x, y = plan.table.length / 2, plan.table.width / 2
    pen.rectangle((*plan.at((-x, y)), *plan.at((x, -y))), fill=BED)
    for line in plan.table.lines.values():
        if line.drawn:
            pen.line([plan.at(line.start), plan.at(line.end)], MARK, 1)
    for spot in plan.table.spots.values():
        _disc(pen, plan, spot, 2 / plan.scale, MARK, filled=True)
    for pocket in plan.table.pockets:
        _disc(pen, plan, pocket.centre, pocket.radius, (60, 60, 60), filled=True)
    shapes = [shape for cushion in plan.table.cushions for shape in cushion.shapes]
    shapes += [shape for jaw in plan.table.jaws for shape in jaw.shapes]
    for shape in shapes:
        pen.line([plan.at(point) for point in _points(shape)], RAIL, 3)


def _points(shape: Shape) -> list[Point]:
    if not isinstance(shape, Curve):
        return [shape.start, shape.end]
    x, y = shape.centre
    turns = [shape.start + shape.sweep * part / 12 for part in range(13)]
    return [(x + shape.radius * cos(turn), y + shape.radius * sin(turn)) for turn in turns]


def _draw_balls(
    pen: ImageDraw.ImageDraw, plan: _Plan, outcome: Outcome, judged: Judgement, number: int
) -> None:
    variant = outcome.record.variant
    radii = {body.id: body.radius for body in variant.world.balls}
    colours = {kind.id: kind.colour for kind in variant.balls}
    start, rest = _start(variant, judged), judged.verdict.after.rest.positions
    for ball, way in _ways(variant, judged, start).items():
        pen.line([plan.at(point) for point in way], colours[ball], 2, joint="curve")
    for ball, at in start.items():
        _disc(pen, plan, at, radii[ball], colours[ball], filled=False)
    for ball, at in rest.items():
        _disc(pen, plan, at, radii[ball], colours[ball], filled=True)
        x, y = plan.at(at)
        pen.text((x + radii[ball] * plan.scale, y), ball, INK, ImageFont.load_default(10))
    for at in _expected(_of(outcome, number)):
        x, y = plan.at(at)
        for dx, dy in ((6, 6), (6, -6)):
            pen.line([(x - dx, y - dy), (x + dx, y + dy)], DIFFERS, 2)


def _start(variant: Variant, judged: Judgement) -> dict[BallId, Point]:
    """Return where balls lay, the one in hand where it was put."""
    start = dict(judged.before.rest.positions)
    if judged.shot.placement is not None:
        start[judged.shot.struck or ball_to_strike(variant, judged.before)] = judged.shot.placement
    return start


def _ways(
    variant: Variant, judged: Judgement, start: Mapping[BallId, Point]
) -> dict[BallId, list[Point]]:
    """Return the way of every ball that moved: as played, or straight from start to rest."""
    played = _played(variant, judged)
    if played:
        return played
    after = judged.shot.after.positions
    return {ball: [start[ball], at] for ball, at in after.items() if start.get(ball, at) != at}


def _played(variant: Variant, judged: Judgement) -> dict[BallId, list[Point]]:
    """Return the ways of a stroke that can be played, nothing where it cannot."""
    if judged.shot.strike is None or not judged.before.rest.positions:
        return {}
    from engine.game.observe import simulate_shot  # noqa: PLC0415  it needs the physics

    try:
        trace = simulate_shot(variant, judged.before, judged.shot)
    except (KeyError, ValueError):
        return {}
    moments = np.linspace(0.0, trace.duration, FRAMES)
    places = trace.positions(moments)
    ways: dict[BallId, list[Point]] = {}
    for index, body in enumerate(trace.balls):
        way = [(float(x), float(y)) for x, y, z in places[:, index] if z > 0]
        if way and max(abs(x - way[0][0]) + abs(y - way[0][1]) for x, y in way) > body.radius / 10:
            ways[body.id] = way
    return ways


def _expected(differences: list[Difference]) -> Iterator[Point]:
    """Yield the places that a record expects and did not get."""
    for one in differences:
        if one.key.startswith("after.positions.") and isinstance(one.expected, list):
            yield one.expected[0], one.expected[1]
        elif one.key == "positions" and isinstance(one.expected, dict):
            yield from ((at[0], at[1]) for at in one.expected.values())


def _disc(
    pen: ImageDraw.ImageDraw,
    plan: _Plan,
    at: Point,
    radius: float,
    colour: tuple[int, int, int],
    *,
    filled: bool,
) -> None:
    x, y = plan.at(at)
    reach = max(2.0, radius * plan.scale)
    box = (x - reach, y - reach, x + reach, y + reach)
    if filled:
        pen.ellipse(box, fill=colour, outline=INK)
    else:
        pen.ellipse(box, outline=colour, width=2)
