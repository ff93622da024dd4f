"""What is wrong with an outline as a whole: it crosses itself, runs clockwise, is too narrow.

One idea: what is asked is asked of the uncut pieces from corner to corner. Invariant: a chain that
crosses itself has no other fault, since nothing else can be said of it.
"""

from __future__ import annotations

from itertools import pairwise
from math import degrees, pi, radians
from typing import TYPE_CHECKING

from engine.table.pieces import Fault, turn_between
from engine.table.region import bounds, ends, trace

if TYPE_CHECKING:
    from collections.abc import Sequence

    from engine.table.furniture import Point, Shape
    from engine.table.pieces import Corner

NARROWEST = radians(30.0)
OFF_CENTRE = 0.001


def faults_of(corners: Sequence[Corner], pieces: list[Shape], ball: float) -> list[Fault]:
    """Return what is wrong with the outline as a whole, and with its corners' angles."""
    faults: list[Fault] = []
    crossed = _crossing(pieces)
    if crossed is not None:
        one, two = crossed
        names = f"{corners[one].cushion} and {corners[two].cushion}"
        message = f"the outline crosses itself: cushions {names}"
        mend = "name the corners in their order round the bed"
        return [Fault("crossing", two, message, mend)]
    if _area(trace(pieces)) <= 0.0:
        mend = "turn the order of the corners round, so that the bed is on the left"
        return [Fault("clockwise", None, "the outline runs clockwise", mend)]
    x0, y0, x1, y1 = bounds(pieces)
    middle = (x0 + x1) / 2.0, (y0 + y1) / 2.0
    if max(abs(middle[0]), abs(middle[1])) > OFF_CENTRE:
        message = f"the outline's middle lies at ({middle[0]:.4f}, {middle[1]:.4f}) m"
        mend = f"take {middle[0]:.4f} m from every x and {middle[1]:.4f} m from every y"
        faults.append(Fault("centre", None, f"{message}, not at the origin", mend))
    for index, corner in enumerate(corners):
        inner = pi - turn_between(pieces[index - 1], pieces[index])
        if inner < NARROWEST:
            message = f"the corner is {degrees(inner):.0f} degrees wide, too narrow for a ball"
            mend = f"open it to {degrees(NARROWEST):.0f} degrees at least"
            faults.append(Fault("narrow", index, message, mend))
        elif corner.rounding is not None and 0.0 < corner.rounding < 2.0 * ball and inner < pi:
            message = f"a round of {corner.rounding * 1000:.0f} mm is too tight for a ball"
            mend = "a ball's diameter at least, or leave the corner plain"
            faults.append(Fault("narrow", index, message, mend))
    return faults


def _crossing(pieces: Sequence[Shape]) -> tuple[int, int] | None:
    """Return the first two pieces that cross or touch away from a common corner."""
    runs = [[*trace([piece], 0.1), ends(piece)[1]] for piece in pieces]
    count = len(runs)
    segments = [(a, b, index) for index, run in enumerate(runs) for a, b in pairwise(run)]
    for i, (a, b, one) in enumerate(segments):
        for j, (c, d, two) in enumerate(segments[i + 2 :], i + 2):
            if i == 0 and j == len(segments) - 1:
                continue
            if _cross(a, b, c, d) and (count > 1):
                return one, two
    return None


def _cross(a: Point, b: Point, c: Point, d: Point) -> bool:
    if max(a[0], b[0]) < min(c[0], d[0]) or max(c[0], d[0]) < min(a[0], b[0]):
        return False
    if max(a[1], b[1]) < min(c[1], d[1]) or max(c[1], d[1]) < min(a[1], b[1]):
        return False
    one = _side(a, b, c) * _side(a, b, d)
    two = _side(c, d, a) * _side(c, d, b)
    return one <= 0.0 and two <= 0.0


def _side(a: Point, b: Point, p: Point) -> float:
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def _area(points: Sequence[Point]) -> float:
    return (
        sum(
            a[0] * b[1] - a[1] * b[0] for a, b in zip(points, (*points[1:], points[0]), strict=True)
        )
        / 2.0
    )


__all__ = ["faults_of"]
