"""What a hole counts, painted beside it in strokes, to be read from the head of the table.

One idea: a digit is one or two lines on a grid, so that it stays crisp at any size.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from engine.stage.marks import flat_path
from engine.table.region import is_hole

if TYPE_CHECKING:
    from engine.scene.shape import Polyline, Rgb
    from engine.table.furniture import Point, Table

HEIGHT = 0.024
"""Height of a digit, m; its width is half of it."""
STEP = 0.75
"""From digit to digit, in heights."""
GAP = 0.013
"""From the rim to the digits, m."""
PEN = 0.0028
PAINT = 0.75
DIGITS: tuple[tuple[tuple[tuple[float, float], ...], ...], ...] = (
    (((0.15, 0), (0, 0.2), (0, 0.8), (0.15, 1), (0.35, 1), (0.5, 0.8), (0.5, 0.2),
           (0.35, 0), (0.15, 0)),),
    (((0.08, 0.78), (0.28, 1), (0.28, 0)),),
    (((0, 0.8), (0.13, 1), (0.37, 1), (0.5, 0.82), (0.5, 0.62), (0, 0), (0.5, 0)),),
    (((0, 0.87), (0.13, 1), (0.37, 1), (0.5, 0.85), (0.5, 0.66), (0.36, 0.53), (0.2, 0.53)),
          ((0.36, 0.53), (0.5, 0.4), (0.5, 0.15), (0.37, 0), (0.13, 0), (0, 0.13))),
    (((0.38, 0), (0.38, 1), (0, 0.3), (0.52, 0.3)),),
    (((0.46, 1), (0.05, 1), (0.02, 0.56), (0.32, 0.6), (0.5, 0.44), (0.5, 0.17), (0.35, 0),
           (0.13, 0), (0, 0.12)),),
    (((0.44, 1), (0.12, 0.7), (0, 0.4), (0, 0.17), (0.13, 0), (0.37, 0), (0.5, 0.17),
           (0.5, 0.38), (0.37, 0.54), (0.13, 0.54), (0.02, 0.44)),),
    (((0, 1), (0.5, 1), (0.17, 0)),),
    (((0.14, 0.54), (0, 0.68), (0, 0.86), (0.13, 1), (0.37, 1), (0.5, 0.86), (0.5, 0.68),
           (0.36, 0.54), (0.14, 0.54), (0, 0.38), (0, 0.15), (0.13, 0), (0.37, 0),
           (0.5, 0.15), (0.5, 0.38), (0.36, 0.54)),),
    (((0.06, 0), (0.38, 0.3), (0.5, 0.6), (0.5, 0.83), (0.37, 1), (0.13, 1), (0, 0.83),
           (0, 0.62), (0.13, 0.46), (0.37, 0.46), (0.48, 0.56)),),
)  # fmt: skip
"""Lines of each digit: right and up, in heights."""


def build_values(table: Table, colour: Rgb) -> tuple[Polyline, ...]:
    """Return the values of the holes in the bed that count something, beyond each as seen."""
    return tuple(
        flat_path(line, colour, PEN, PAINT)
        for pocket in table.pockets
        if is_hole(pocket) and pocket.value
        for line in _written(str(pocket.value), pocket.centre, pocket.radius + GAP)
    )


def _written(text: str, centre: Point, beyond: float) -> list[list[Point]]:
    """Return the lines of a number whose foot is `beyond` (m) past a centre, upright to +x."""
    marks = [DIGITS[int(digit)] for digit in text if digit.isdecimal()]
    first = -0.5 * (STEP * (len(marks) - 1) + 0.5)
    return [
        [
            (centre[0] + beyond + HEIGHT * up, centre[1] - HEIGHT * (first + STEP * place + right))
            for right, up in line
        ]
        for place, lines in enumerate(marks)
        for line in lines
    ]
