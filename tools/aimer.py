"""A simple opponent for any game: try strokes with the real physics and the real referee.

One idea: nothing is known of the game; a stroke is good when the referee gives points, lets the
player go on or ends the game in his favour. Invariant: chance comes from the seed alone.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import chain
from math import atan2, cos, degrees, hypot, radians, sin
from typing import TYPE_CHECKING

from engine.game.observe import observe, simulate_shot
from engine.game.referee import judge_shot
from engine.physics.events import BallsCollided
from rulelang.facts import Call

if TYPE_CHECKING:
    from collections.abc import Iterator
    from random import Random

    from engine.app.session import Session
    from engine.app.stroke import Stroke
    from engine.game.shot import Shot
    from engine.game.situation import Situation
    from engine.game.verdict import Verdict
    from engine.physics.trace import Trace
    from engine.table.furniture import BallId, Point

FINE = 0.01
"""Degrees of one fine step of the aim."""


@dataclass(frozen=True, slots=True)
class Plan:
    """A stroke with its call, and what it is worth to the player."""

    stroke: Stroke
    call: Call
    worth: float


def find_plan(session: Session, lot: Random, tries: int = 140, *, foul: bool = False) -> Plan:
    """Return the best plan found in so many tries.

    With `foul`, the first one after which the other player is left with more than his turn.
    """
    best: Plan | None = None
    good = 0
    strokes = chain(_feeble(session), _strokes(session, lot)) if foul else _strokes(session, lot)
    for number, stroke in enumerate(strokes):
        if number >= tries or good > 3:
            break
        plan, went_wrong = _tried(session, stroke)
        if foul:
            plan = replace(plan, worth=50.0 if went_wrong else -50.0)
        if best is None or plan.worth > best.worth:
            best = plan
        good += plan.worth >= 1.0
        if foul and went_wrong:
            break
    if best is None:
        raise AssertionError("there is always a stroke to try")
    return best


def _tried(session: Session, stroke: Stroke) -> tuple[Plan, bool]:
    variant, ahead = session.variant, session.ahead
    shot = replace(session.shot, strike=stroke.strike())
    trace = simulate_shot(variant, ahead, shot)
    shot = replace(shot, call=_call(session, trace))
    verdict = judge_shot(
        variant, session.match.situation, observe(variant, ahead, shot, trace), explain=False
    )
    after = verdict.after
    went_wrong = after.winner is None and (verdict.is_foul or bool(after.offers))
    worth = _worth(ahead, verdict) + _nearness(session, shot)
    return Plan(stroke, shot.call, worth), went_wrong


def _call(session: Session, trace: Trace) -> Call:
    """Return the call that fits what would happen."""
    wanted, cue = session.wanted, session.cue_ball
    if not wanted.obliged:
        return session.call
    pots = [(ball, pocket) for ball, pocket in trace.pocketed.items() if ball != cue]
    pots.sort(key=lambda pot: pot[0] not in session.admission.on)
    if wanted.pocket:
        if pots:
            return Call(ball=pots[0][0], pocket=pots[0][1])
        return Call(safety=True) if wanted.safety else _any_call(session)
    for event in trace.events():
        if isinstance(event, BallsCollided) and cue in (event.ball, event.other):
            return Call(ball=event.other if event.ball == cue else event.ball)
    return _any_call(session)


def _any_call(session: Session) -> Call:
    ball = next(iter(sorted(session.ahead.on_table - {session.cue_ball})))
    pocket = next((p.id for p in session.variant.world.table.pockets), None)
    return Call(ball=ball, pocket=pocket if session.wanted.pocket else None)


def _worth(before: Situation, verdict: Verdict) -> float:
    me, after = before.shooter - 1, verdict.after
    worth = float(verdict.points[me] - sum(p for i, p in enumerate(verdict.points) if i != me))
    if after.winner is not None:
        return worth + (100.0 if after.winner == before.shooter else -100.0)
    worth += 1.0 if after.shooter == before.shooter and not after.offers else 0.0
    return worth - (3.0 if verdict.is_foul else 0.0)


def _nearness(session: Session, shot: Shot) -> float:
    """Return a little for a soft stroke, so that of two equal ones the softer is taken."""
    speed = shot.strike.speed if shot.strike else 0.0
    return -0.002 * speed if session.match.played else 0.02 * speed


def _strokes(session: Session, lot: Random) -> Iterator[Stroke]:
    """Yield strokes worth a try: pots by the ghost ball first, then all sorts of others."""
    now = session.stroke
    if not session.match.played:
        for speed in (9.0, 7.0, 5.0, 3.0):
            for turn in (0.0, 0.6, -0.6, 3.0, -3.0):
                yield _aimed(now, now.heading + turn, speed)
    aims = _pots(session)
    for heading, reach in aims:
        for speed in (1.2 + 0.6 * reach, 2.0 + 0.9 * reach):
            for turn in (0.0, 0.06, -0.06, 0.15, -0.15):
                yield _aimed(now, heading + turn, speed)
    thin = [heading for heading, _ in _contacts(session)]
    for _ in range(400):
        heading = lot.choice(thin) + lot.gauss(0.0, 2.5) if thin else lot.uniform(-180.0, 180.0)
        if lot.random() < 0.25:
            heading = lot.uniform(-180.0, 180.0)
        stroke = _aimed(now, heading, lot.uniform(1.5, 5.5))
        side, follow = 0.025 * lot.randint(-12, 12), 0.025 * lot.randint(-8, 12)
        yield stroke.tipped(side, follow, session.tip_limit)


def _feeble(session: Session) -> Iterator[Stroke]:
    """Yield strokes that are likely to be wrong: hardly any power, here and there."""
    for turn in (0.0, 40.0, -40.0, 90.0, 180.0):
        yield _aimed(session.stroke, session.stroke.heading + turn, 1.0)


def _aimed(now: Stroke, heading: float, speed: float) -> Stroke:
    """Return a stroke that fine steps of the aim can reach from where it is now."""
    steps = round((heading - now.heading) / FINE)
    return replace(now.turned(steps * FINE), side=0.0, follow=0.0, elevation=0.0).at(
        round(speed, 1)
    )


def _contacts(session: Session) -> list[tuple[float, float]]:
    """Return heading and distance to the balls that are on."""
    start = session.cue_place or (0.0, 0.0)
    return [
        (_heading(start, place), hypot(place[0] - start[0], place[1] - start[1]))
        for ball, place in session.layout.items()
        if ball in _targets(session)
    ]


def _targets(session: Session) -> frozenset[str]:
    others = frozenset(session.layout) - {session.cue_ball}
    return (session.admission.on & others) or others


def _pots(session: Session) -> list[tuple[float, float]]:
    """Return headings, straightest cuts first, that send a ball that is on to a pocket."""
    start = session.cue_place or (0.0, 0.0)
    radii = {ball.id: ball.radius for ball in session.variant.world.balls}
    found: list[tuple[float, float, float]] = []
    for ball, place in session.layout.items():
        if ball not in _targets(session):
            continue
        for pocket in session.variant.world.table.pockets:
            (ax, ay), (bx, by) = pocket.mouth
            way = radians(_heading(place, ((ax + bx) / 2.0, (ay + by) / 2.0)))
            gap = radii[ball] + radii[session.cue_ball]
            ghost = place[0] - gap * cos(way), place[1] - gap * sin(way)
            aim = radians(_heading(start, ghost))
            cut = abs((degrees(aim - way) + 180.0) % 360.0 - 180.0)
            if cut > 70.0 or not _is_clear(session, start, ghost, ball):
                continue
            far = hypot(place[0] - pocket.centre[0], place[1] - pocket.centre[1])
            if not _is_clear(session, place, pocket.centre, ball):
                continue
            reach = hypot(ghost[0] - start[0], ghost[1] - start[1]) + far
            found.append((cut + 25.0 * far, degrees(aim), reach / max(cos(radians(cut)), 0.3)))
    found.sort()
    return [(heading, reach) for _, heading, reach in found[:12]]


def _is_clear(session: Session, start: Point, end: Point, ball: BallId) -> bool:
    """Whether no other ball stands in the way of one that goes straight."""
    radii = {one.id: one.radius for one in session.variant.world.balls}
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = hypot(dx, dy) or 1.0
    for other, (x, y) in session.layout.items():
        if other in (ball, session.cue_ball):
            continue
        along = ((x - start[0]) * dx + (y - start[1]) * dy) / length
        aside = abs((x - start[0]) * dy - (y - start[1]) * dx) / length
        if 0.0 < along < length and aside < radii[other] + radii[session.cue_ball]:
            return False
    return True


def _heading(start: Point, end: Point) -> float:
    return degrees(atan2(end[1] - start[1], end[0] - start[0]))
