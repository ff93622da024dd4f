"""What a straight stroke can reach: clear paths and what hides a ball, read off positions.

One idea: a stroke is a direction; the ball it meets first is the nearest whose distance from
the line of travel is below the two radii. Sources: WPBSA S2 R17 (snookered), S3 R14 (paths).
"""

from __future__ import annotations

from dataclasses import dataclass
from math import asin, atan2, cos, hypot, inf, sin, sqrt
from typing import TYPE_CHECKING

from engine.game.noses import reach_of_nose

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from engine.table.furniture import BallId, Point, Shape

EDGE = 1.0 - 1e-9
SAMPLES = 41


@dataclass(frozen=True, slots=True)
class View:
    """What lies around a cue ball: its place, its radius, and the other balls (m).

    `noses` are those that can be in its way, `touch` how far (m) from one its centre is stopped.
    """

    origin: Point
    radius: float
    others: Mapping[BallId, Point]
    radii: Mapping[BallId, float]
    noses: tuple[Shape, ...] = ()
    touch: float = 0.0


def path_to(view: View, targets: Iterable[BallId]) -> str:
    """Return "full", "partial" or "none": the best straight path to one of the `targets`.

    Full is a path to the middle of a target, partial one to some part of it; another target
    in the way is as good as the target itself.
    """
    wanted = frozenset(targets) & frozenset(view.others)
    if has_full_path(view, wanted):
        return "full"
    offsets = [2.0 * step / (SAMPLES - 1) - 1.0 for step in range(SAMPLES)]
    reached = (
        first_met(view, _heading(view, ball, EDGE * offset)) in wanted
        for ball in sorted(wanted)
        for offset in offsets
    )
    return "partial" if any(reached) else "none"


def has_full_path(view: View, targets: Iterable[BallId]) -> bool:
    """Return whether the middle of one of the `targets` can be reached straight."""
    wanted = frozenset(targets) & frozenset(view.others)
    return any(first_met(view, _heading(view, ball, 0.0)) in wanted for ball in sorted(wanted))


def snookering_ball(view: View, targets: Iterable[BallId]) -> BallId | None:
    """Return the nearest ball that hides every target from the cue ball, or None."""
    return next(iter(snookering_balls(view, targets)), None)


def snookering_balls(view: View, targets: Iterable[BallId]) -> tuple[BallId, ...]:
    """Return the balls that hide every target from the cue ball, the nearest first.

    The cue ball is not snookered if both edges of one target can be reached free of any ball
    that is not a target. Of several balls that hide one target the nearest counts (S2 R17(b));
    more than one ball is returned where different targets are hidden by different balls (R17(c)).
    A ball behind a nose that stops the cue ball hides nothing (R17(e)).
    """
    wanted = frozenset(targets) & frozenset(view.others)
    effective: set[tuple[float, BallId]] = set()
    for ball in sorted(wanted):
        met = {_obstacle(view, ball, side * EDGE, wanted) for side in (-1.0, 1.0)} - {None}
        if not met:
            return ()
        effective.add(min((_distance(view, one), one) for one in met if one is not None))
    return tuple(ball for _, ball in sorted(effective))


def first_met(view: View, heading: float, among: Iterable[BallId] | None = None) -> BallId | None:
    """Return the ball that the cue ball, sent along `heading` (rad), meets first."""
    met = (
        (reach, ball)
        for ball in (view.others if among is None else among)
        if (reach := _reach(view, ball, heading)) is not None
    )
    far, ball = min(met, default=(0.0, None))
    return ball if far < _nose_ahead(view, heading) else None


def _obstacle(
    view: View, target: BallId, offset: float, wanted: frozenset[BallId]
) -> BallId | None:
    heading = _heading(view, target, offset)
    limit = _reach(view, target, heading)
    if limit is None:
        return None
    limit = min(limit, _nose_ahead(view, heading))
    in_the_way = [
        (reach, ball)
        for ball in view.others
        if ball not in wanted
        and (reach := _reach(view, ball, heading)) is not None
        and reach < limit
    ]
    return min(in_the_way, default=(0.0, None))[1]


def _nose_ahead(view: View, heading: float) -> float:
    if not view.noses:
        return inf
    return reach_of_nose(view.origin, heading, view.noses, view.touch)


def _distance(view: View, ball: BallId) -> float:
    (x, y), (u, v) = view.origin, view.others[ball]
    return hypot(u - x, v - y)


def _heading(view: View, ball: BallId, offset: float) -> float:
    (x, y), (u, v) = view.origin, view.others[ball]
    span = view.radius + view.radii[ball]
    distance = max(hypot(u - x, v - y), span)
    return atan2(v - y, u - x) + asin(min(span * abs(offset) / distance, 1.0)) * (
        1.0 if offset >= 0 else -1.0
    )


def _reach(view: View, ball: BallId, heading: float) -> float | None:
    """Return how far the cue ball travels before it meets `ball`, None if it passes by."""
    (x, y), (u, v) = view.origin, view.others[ball]
    ahead = (u - x) * cos(heading) + (v - y) * sin(heading)
    aside = (v - y) * cos(heading) - (u - x) * sin(heading)
    span = view.radius + view.radii[ball]
    if ahead <= 0.0 or abs(aside) > span:
        return None
    return ahead - sqrt(span * span - aside * aside)
