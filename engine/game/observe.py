"""What the referee sees of a simulated stroke: a trace becomes the events of the record.

One idea: contacts come from the solver's own events; lines and zones are read off the motion
pieces afterwards, exactly, so that the solver knows nothing of them.
Invariant: events are in order of time; a shot observed twice reads the same.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from engine.game.contacts import as_cushion, contacts_of
from engine.game.shot import Shot, as_written
from engine.game.situation import TOUCHING, Rest, Situation, ball_to_strike, cue_ball_of
from engine.physics import events as seen
from engine.physics.simulate import simulate
from engine.table.marks import Piece, crossings, zone_changes
from engine.table.region import distance_to, nose_reach
from rulelang import events as told

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from engine.physics.trace import Trace
    from engine.physics.world import Layout, World
    from engine.table.furniture import BallId, Cushion
    from engine.variant.variant import Variant

STEPS = 32


def layout_of(variant: Variant, situation: Situation, shot: Shot) -> Layout:
    """Return where the balls lie at the stroke, the ball in hand at its placement (m)."""
    layout = dict(situation.rest.positions)
    if situation.in_hand is not None and shot.placement is not None:
        layout[cue_ball_of(variant, situation.shooter)] = shot.placement
    return layout


def simulate_shot(variant: Variant, situation: Situation, shot: Shot) -> Trace:
    """Return the stroke played; raises ValueError for a shot without strike or cue ball."""
    if shot.strike is None:
        raise ValueError("a shot without a strike cannot be played")
    ball = shot.struck or ball_to_strike(variant, situation)
    layout = layout_of(variant, situation, shot)
    strike, fallen = as_written(shot.strike), situation.rest.fallen
    return simulate(variant.world, layout, ball, strike, fallen=fallen)


def play(variant: Variant, situation: Situation, shot: Shot) -> Shot:
    """Return the shot with what was seen when it was played."""
    return observe(variant, situation, shot, simulate_shot(variant, situation, shot))


def observe(variant: Variant, situation: Situation, shot: Shot, trace: Trace) -> Shot:
    """Return the shot with its events and the balls at rest, as seen in the trace."""
    struck = shot.struck or ball_to_strike(variant, situation)
    found = [
        *_contacts(trace, struck, variant.same_time),
        *_marks(variant, trace),
        *_leavings(variant.world, situation, trace),
    ]
    ordered = sorted(found, key=lambda event: event.time or 0.0)
    return replace(shot, events=tuple(ordered), after=Rest(positions=dict(trace.final)))


def _contacts(trace: Trace, struck: BallId, same_time: float) -> Iterator[told.Event]:
    """Yield what touched what; hits of one ball, one right after the other, are one event."""
    together: list[told.BallsHit] = []
    for event in trace.events():
        one = _translate(event, struck)
        if one is None:
            continue
        if isinstance(one, told.BallsHit) and together and _same(together[0], one, same_time):
            together.append(one)
            continue
        yield from _at_once(together)
        together = [one] if isinstance(one, told.BallsHit) else []
        if not together:
            yield one
    yield from _at_once(together)


def _same(first: told.BallsHit, one: told.BallsHit, same_time: float) -> bool:
    return one.ball == first.ball and (one.time or 0.0) - (first.time or 0.0) <= same_time


def _at_once(hits: list[told.BallsHit]) -> Iterator[told.BallsHit]:
    if hits:
        others = tuple(dict.fromkeys(other for hit in hits for other in hit.others))
        yield replace(hits[0], others=others)


def _translate(event: seen.Event, struck: BallId) -> told.Event | None:
    match event:
        case seen.BallsCollided(time, ball, other):
            first, second = (other, ball) if other == struck else (ball, other)
            return told.BallsHit(first, (second,), time)
        case seen.CushionHit(time, ball, cushion):
            return told.CushionHit(ball, cushion, time)
        case seen.JawHit(time, ball, pocket):
            return told.JawHit(ball, pocket, time)
        case seen.BallPocketed(time, ball, pocket):
            return told.Pocketed(ball, pocket, time)
        case seen.BallLeftTable(time, ball):
            return told.LeftTable(ball, time)
        case seen.BallJumpedOver(time, ball, other):
            return told.JumpedOver(ball, other, time)
        case seen.PinToppled(time, pin, by):
            return told.PinToppled(by, pin, time)
        case seen.PinTouched(time, pin, by):
            return told.PinTouched(by, pin, time)
        case seen.RollingBegan() | seen.BallStopped() | seen.BallLanded() | seen.BallLeftBed():
            return None


def _marks(variant: Variant, trace: Trace) -> Iterator[told.Event]:
    """Yield the lines and zones passed that the script asks about."""
    table, asked = variant.world.table, variant.program.asks
    for ball in trace.balls:
        ways = pieces_of(trace, ball.id)
        for name, line in table.lines.items():
            if name in asked:
                for crossing in crossings(line, ways):
                    yield told.LineCrossed(ball.id, name, crossing.time)
        for place, zone in table.zones.items():
            if place in asked:
                for change in zone_changes(zone, ways, table):
                    kind = told.ZoneEntered if change.entered else told.ZoneLeft
                    yield kind(ball.id, place, change.time)


def pieces_of(trace: Trace, ball: BallId) -> tuple[Piece, ...]:
    """Return the ball's way, piece by piece."""
    return tuple(
        Piece(begin, end - begin, position, velocity, acceleration)
        for begin, end, position, velocity, acceleration in trace.pieces_of(ball)
        if end > begin
    )


def _leavings(world: World, situation: Situation, trace: Trace) -> Iterator[told.Event]:
    """Yield when a ball that was frozen to a cushion comes clear of it."""
    radii = {ball.id: ball.radius for ball in trace.balls}
    frozen = contacts_of(world, situation.rest)
    for cushion in world.table.cushions:
        for ball in sorted(radii):
            if (ball, as_cushion(cushion.id)) in frozen:
                clear = nose_reach(radii[ball], world.table.nose_height) + TOUCHING
                time = _first_clear(cushion, pieces_of(trace, ball), clear)
                if time is not None:
                    yield told.CushionLeft(ball, cushion.id, time)


def _first_clear(cushion: Cushion, ways: Iterable[Piece], clear: float) -> float | None:
    for way in ways:
        for step in range(1, STEPS + 1):
            high = way.duration * step / STEPS
            if _gap(cushion, way, high) > clear:
                low = way.duration * (step - 1) / STEPS
                return way.begin + _bisect(cushion, way, clear, low, high)
    return None


def _bisect(cushion: Cushion, way: Piece, clear: float, low: float, high: float) -> float:
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (low, middle) if _gap(cushion, way, middle) > clear else (middle, high)
    return high


def _gap(cushion: Cushion, way: Piece, s: float) -> float:
    return min(distance_to(nose, way.at(s)) for nose in cushion.shapes)
