"""How high a cue is held, so that it clears the cushion and the wood behind its ball.

One idea: behind the ball the cue crosses borders of known height; the least elevation is that at
which its lower side passes over each by a hair. Invariant: this is a matter of drawing alone:
the stroke keeps the elevation that the player set, and records say that one.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass, replace
from math import cos, hypot, inf, pi, sin, sqrt, tan
from typing import TYPE_CHECKING

from engine.stage import plan
from engine.stage.cue import LENGTH, radius_at
from engine.stage.dimensions import measure
from engine.stage.region import stations
from engine.table.region import posts_of

if TYPE_CHECKING:
    from engine.stage.cue import CuePose
    from engine.table.furniture import Point, Table

HAIR = 0.002
"""What is left between the cue and what it passes over, m."""
STEEPEST = 0.47 * pi
HALVINGS = 24


@dataclass(frozen=True, slots=True)
class Borders:
    """What a cue has to pass over: closed borders and posts, each with its height (m)."""

    edges: tuple[tuple[plan.Polygon, float], ...]
    posts: tuple[tuple[Point, float, float], ...]


def borders_of(table: Table) -> Borders:
    """Return a table's noses, the inner edge of its wood, and its posts (centre, radius, height).

    The wood is no higher further out, and a cue climbs, so its inner edge stands for all of it.
    """
    frame = measure(table)
    if table.outline:
        round_bed = stations(table.outline)
        noses = [one.point for one in round_bed]
        wood = [one.behind(frame.cushion_depth) for one in round_bed]
    else:
        x, y = table.length / 2.0, table.width / 2.0
        noses = plan.rectangle(-x, -y, x, y)
        (x, y) = frame.inner
        wood = plan.rectangle(-x, -y, x, y)
    return Borders(
        edges=((noses, frame.nose), (wood, frame.top)),
        posts=tuple((post.centre, post.radius, frame.top) for post in posts_of(table)),
    )


def raise_cue(borders: Borders, pose: CuePose) -> CuePose:
    """Return the pose at the least elevation that clears the borders, or its own if larger."""
    back = -cos(pose.heading), -sin(pose.heading)
    met = _met(borders, (pose.ball[0], pose.ball[1]), back)
    if _clears(pose, pose.elevation, met):
        return pose
    low, high = pose.elevation, max(STEEPEST, pose.elevation)
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if _clears(pose, middle, met) else (middle, high)
    return replace(pose, elevation=high)


def _met(borders: Borders, ball: Point, way: Point) -> list[tuple[float, float]]:
    """Return how far from the ball, and how high, each thing is that a cue passes over."""
    met = [(_crossing(ball, way, edge), height) for edge, height in borders.edges]
    for (x, y), radius, height in borders.posts:
        along = (x - ball[0]) * way[0] + (y - ball[1]) * way[1]
        aside = abs((x - ball[0]) * way[1] - (y - ball[1]) * way[0])
        reach = radius + radius_at(max(along, 0.0))
        if along > 0.0 and aside < reach:
            met.append((max(along - sqrt(reach * reach - aside * aside), 0.0), height))
    return met


def _crossing(start: Point, way: Point, border: plan.Polygon) -> float:
    """Return how far from `start` along a unit way the border is first met; inf for never."""
    found = inf
    for a, b in itertools.pairwise([*border, border[0]]):
        u, v = b[0] - a[0], b[1] - a[1]
        across = way[0] * v - way[1] * u
        if abs(across) <= plan.NEAR * hypot(u, v):
            continue
        x, y = a[0] - start[0], a[1] - start[1]
        along, share = (x * v - y * u) / across, (x * way[1] - y * way[0]) / across
        if along > 0.0 and -plan.NEAR < share < 1.0 + plan.NEAR:
            found = min(found, along)
    return found


def _clears(pose: CuePose, elevation: float, met: list[tuple[float, float]]) -> bool:
    """Return whether the lower side of a cue at this elevation is above all that is met.

    The tip is reckoned at the ball: further back on its way the cue is thinner at every place.
    """
    c, s, t = cos(elevation), sin(elevation), tan(elevation)
    depth = sqrt(max(1.0 - pose.side**2 - pose.follow**2, 0.0))
    behind = pose.radius * (depth * c - pose.follow * s)
    height = pose.ball[2] + pose.radius * (depth * s + pose.follow * c)
    for away, top in met:
        beyond = away - behind
        length = beyond / c
        if 0.0 < length < LENGTH:
            if height + beyond * t - radius_at(length) / c < top + HAIR:
                return False
        elif length <= 0.0 and height - radius_at(0.0) / c < top + HAIR:
            return False
    return True


__all__ = ["Borders", "borders_of", "raise_cue"]
