"""Vectors of the plane as pairs of numbers.

One idea: what several modules ask of two points or two vectors stands here once.
"""

from __future__ import annotations

from math import hypot

Vector = tuple[float, float]


def dot(first: Vector, second: Vector) -> float:
    """Return the scalar product."""
    return first[0] * second[0] + first[1] * second[1]


def distance(first: Vector, second: Vector) -> float:
    """Return how far two points are from each other."""
    return hypot(first[0] - second[0], first[1] - second[1])
