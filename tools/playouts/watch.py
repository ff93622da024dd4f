"""What must hold after every shot, whatever was played.

One idea: each check takes the verdict alone and says in words what is wrong with it.
Invariant: nothing here knows a game.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations
from math import hypot
from typing import TYPE_CHECKING

from engine.game.referee import look_ahead
from engine.game.situation import cue_ball_of
from engine.table.furniture import BallId
from rulelang.events import LeftTable, Pocketed, Rebounded, Settled
from rulelang.facts import Call

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator
    from random import Random

    from engine.game.shot import Shot
    from engine.game.situation import Situation
    from engine.game.verdict import Verdict
    from engine.variant.variant import Variant
    from rulelang.events import Event
    from rulelang.program import CompiledRule, Program

MOST = 10**6
"""No score and no counter of a match comes near this."""
OVERLAP = 1e-6


def faults(variant: Variant, before: Situation, shot: Shot, verdict: Verdict) -> Iterator[str]:
    """Yield what is wrong with a verdict."""
    after = verdict.after
    yield from _balls(variant, before, shot, verdict)
    yield from _overlaps(variant, after)
    if tuple(map(sum, zip(before.scores, verdict.points, strict=True))) != after.scores:
        yield "the scores are not what they were and the points"
    if any(abs(score) > MOST for score in after.scores):
        yield "a score without bounds"
    yield from _state(before, after)
    if after.over:
        if after.winner not in range(after.players + 1):
            yield f"there is no player {after.winner} to win"
        return
    if variant.program.phases and after.phase not in variant.program.phases:
        yield f"there is no phase {after.phase}"
    if after.shooter not in range(1, after.players + 1) or after.shooter in after.eliminated:
        yield f"player {after.shooter} is next, who does not play"
    yield from _stuck(variant, after)


def _balls(variant: Variant, before: Situation, shot: Shot, verdict: Verdict) -> Iterator[str]:
    after = verdict.after
    known = {ball.id for ball in variant.balls}
    lost = before.on_table - after.on_table
    down = fallen(shot.events or (), variant.program.settled_within)
    restored = before.judged is not None and after.on_table == before.judged.before.on_table
    if not verdict.reracked and not restored and lost - down - set(verdict.removed):
        yield f"gone without a trace: {_named(lost - down - set(verdict.removed))}"
    own = {cue_ball_of(variant, player) for player in range(1, after.players + 1)}
    found = after.on_table - before.on_table - {one.ball for one in verdict.spotted}
    if not verdict.reracked and not restored and found - own:
        yield f"on the table from nowhere: {_named(found - own)}"
    if after.on_table - known:
        yield f"no ball of this game: {_named(after.on_table - known)}"
    placed = set(after.rest.positions) - after.on_table
    if placed:
        yield f"lies on the table and is not on it: {_named(placed)}"
    if not restored and not verdict.reracked:
        for one in verdict.spotted:
            if one.ball not in after.on_table:
                yield f"put back and not on the table: {one.ball}"


def fallen(events: Iterable[Event], settled_within: float) -> frozenset[BallId]:
    """Return the balls that a stroke's events took off the bed."""
    down: set[BallId] = set()
    for event in events:
        match event:
            case Pocketed(ball) | LeftTable(ball):
                down.add(BallId(ball))
            case Settled(ball, _, delay) if delay <= settled_within:
                down.add(BallId(ball))
            case Rebounded(ball):
                down.discard(BallId(ball))
            case _:
                pass
    return frozenset(down)


def _named(balls: object) -> str:
    return ", ".join(sorted(balls))  # type: ignore[call-overload]


def _overlaps(variant: Variant, after: Situation) -> Iterator[str]:
    radii = {one.id: one.radius for one in variant.world.balls}
    for (one, (x, y)), (other, (p, q)) in combinations(after.rest.positions.items(), 2):
        if hypot(x - p, y - q) < radii[one] + radii[other] - OVERLAP:
            yield f"{one} lies in {other}"


def _state(before: Situation, after: Situation) -> Iterator[str]:
    if before.state.keys() != after.state.keys():
        yield "a tracked value came or went"
    for name, value in after.state.items():
        row = value if isinstance(value, tuple) else (value,)
        if isinstance(value, tuple) and len(value) != after.players:
            yield f"{name} is not kept for every player"
        if any(isinstance(one, int) and abs(one) > MOST for one in row):
            yield f"{name} grows without bounds"


def _stuck(variant: Variant, after: Situation) -> Iterator[str]:
    """Yield why nobody can move."""
    if after.offers:
        return
    cue = cue_ball_of(variant, after.shooter)
    if after.strikable:
        if not after.strikable & after.on_table:
            yield "no ball that may be struck is on the table"
    elif cue not in after.on_table:
        yield f"player {after.shooter} has no cue ball"
    if variant.program.on is not None:
        if not _is_anything_on(variant, after):
            yield "no ball is on, and the game goes on"
    elif not after.on_table - {cue}:
        yield "there is no ball left to play at, and the game goes on"


def _is_anything_on(variant: Variant, after: Situation) -> bool:
    """Tell whether a ball is on, be it only where a group is claimed for the shot."""
    groups = {group for ball in variant.balls for group in ball.groups}
    calls = (None, *(Call(group=group) for group in sorted(groups)))
    return any(look_ahead(variant, after, call).on for call in calls)


def shuffled(program: Program, rng: Random) -> Program:
    """Return a program with the rules of every section in another order."""
    order = {rule.number: rng.random() for rules in program.compiled.values() for rule in rules}

    def mixed(rules: tuple[CompiledRule, ...]) -> tuple[CompiledRule, ...]:
        return tuple(sorted(rules, key=lambda rule: order[rule.number]))

    return replace(
        program,
        compiled={name: mixed(rules) for name, rules in program.compiled.items()},
        by_phase={
            name: {phase: mixed(rules) for phase, rules in found.items()}
            for name, found in program.by_phase.items()
        },
    )


def same(one: Verdict, other: Verdict) -> Iterator[str]:
    """Yield where two verdicts on one shot differ."""
    a, b = one.after, other.after
    pairs: dict[str, tuple[object, object]] = {
        "fouls": ({(f.name, f.worth) for f in one.fouls}, {(f.name, f.worth) for f in other.fouls}),
        "points": (one.points, other.points),
        "balls put back": (one.spotted, other.spotted),
        "balls removed": (set(one.removed), set(other.removed)),
        "balls racked": (one.reracked, other.reracked),
        "player": (a.shooter, b.shooter),
        "phase": (a.phase, b.phase),
        "state": (dict(a.state), dict(b.state)),
        "balls on the table": (a.on_table, b.on_table),
        "places": (dict(a.rest.positions), dict(b.rest.positions)),
        "ball in hand": (a.in_hand, b.in_hand),
        "options": (set(a.offers), set(b.offers)),
        "winner": ((a.winner, a.match_over), (b.winner, b.match_over)),
        "players out": (a.eliminated, b.eliminated),
        "balls to strike": (a.strikable, b.strikable),
    }
    for what, (first, second) in pairs.items():
        if first != second:
            yield f"the order of the rules decides the {what}: {first} or {second}"
