"""What the rules say when a game or the match has ended: `at game end:`, `at match end:`.

One idea: a game is closed once, after `ending:`; first the counters are written, then the rules
that end the match read them. Invariant: a rule that speaks of the winner is silent after a draw.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang.closures import forget, opponent
from rulelang.firing import override
from rulelang.moment import endings_of
from rulelang.settle import sum_points, write_state
from rulelang.watch import Nobody

if TYPE_CHECKING:
    from rulelang.decisions import Ending
    from rulelang.explain import Log
    from rulelang.facts import Situation
    from rulelang.firing import Fired
    from rulelang.program import CompiledRule, Program
    from rulelang.watch import Watch


def winner(c: Watch) -> int:
    """Return who won the game that just ended; raises Nobody where nobody did."""
    if not c.winner:
        raise Nobody
    return c.winner


def loser(c: Watch) -> int:
    """Return who comes after the winner; raises Nobody where nobody won."""
    return opponent(c, winner(c))


def fire_at(rules: tuple[CompiledRule, ...], c: Watch, log: Log | None = None) -> Fired:
    """Return the rules of a moment that fire and are not overridden.

    One that needs a winner is silent without. How they fared is kept in `log`.
    """
    fired: Fired = []
    for rule in rules:
        try:
            made = rule.run(c)
        except Nobody:
            continue
        if made is not None:
            fired.append((rule, made))
    left, beaten = override(fired)
    if log is not None and rules:
        log.close(rules, left, beaten, c)
    return left


def close(
    program: Program,
    situation: Situation,
    c: Watch,
    ended: tuple[Ending, ...],
    log: Log | None = None,
) -> tuple[tuple[Ending, ...], tuple[int, ...]]:
    """Run the rules of the end; return what has ended now, and the points they gave.

    The state of `c` is as they leave it.
    """
    c.winner = ended[0].winner
    rules = program.compiled.get("game end", ())
    points = [0] * c.players
    for late in (False, True):
        fired = fire_at(tuple(rule for rule in rules if rule.late is late), c, log)
        points = _apply(program, c, fired, points)
        if not any(one.unit == "match" for one in ended):
            match = [one for one in endings_of(fired, situation)[0] if one.unit == "match"]
            ended = (*ended, *match)
    over = next((one for one in ended if one.unit == "match"), None)
    if over is not None:
        c.winner = over.winner
        closing = program.compiled.get("match end", ())
        points = _apply(program, c, fire_at(closing, c, log), points)
    return ended, tuple(points)


def _apply(program: Program, c: Watch, fired: Fired, points: list[int]) -> list[int]:
    given = sum_points(fired, c.players, program.mates)
    c.state = write_state(program, fired, c.state)
    c.scores = tuple(a + b for a, b in zip(c.scores, given, strict=True))
    forget(c)
    return [a + b for a, b in zip(points, given, strict=True)]


def starting(program: Program, situation: Situation, c: Watch) -> Fired:
    """Return what fires at the start: of the match too where no game was played before."""
    c.winner = situation.winner
    moments: tuple[Any, ...] = program.compiled.get("game start", ())
    if not situation.games:
        moments = (*program.compiled.get("match start", ()), *moments)
    return fire_at(moments, c)
