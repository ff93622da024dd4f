"""What every moment of a game needs: a watch, the state at the start, homes and endings.

One idea: at whatever moment the rules are asked, they are asked through a Watch made here.
Invariant: nothing here fires a rule.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rulelang.closures import fresh, singles
from rulelang.decisions import Ending
from rulelang.settle import RuleClash
from rulelang.watch import Watch

if TYPE_CHECKING:
    from collections.abc import Mapping

    from rulelang.facts import Situation
    from rulelang.firing import Fired
    from rulelang.program import CompiledRule, Program
    from rulelang.vocabulary import Tracked


def look(program: Program, situation: Situation) -> Watch:
    """Return a watch on a situation, with nothing remembered yet."""
    c = Watch(program.bits, program.names, program.ball_mask, situation)
    c.values = program.values
    c.mates = program.mates
    c.memo, c.passing = fresh(program.lasting), fresh(program.passing)
    return c


def cue_ball_of(program: Program, player: int) -> str:
    """Return the name of a player's cue ball."""
    balls = program.vocabulary.cue_balls
    return balls[(player - 1) % len(balls)]


def homes_of(program: Program, c: Watch) -> Mapping[str, str]:
    """Return the home spot of every ball that has one now."""
    return {program.names[bit]: spot for balls, spot in program.homes for bit in singles(balls(c))}


def start_of(program: Program, name: str, situation: Situation) -> Tracked:
    """Return the value a tracked name starts with."""
    track = program.tracked[name]
    value = situation.breaker if track.by_breaker else track.start
    return (value,) * situation.players if track.per_player else value


def endings_of(fired: Fired, situation: Situation) -> tuple[tuple[Ending, ...], frozenset[int]]:
    """Return what ended and who won it, and who is out; two winners are a clash."""
    found: dict[str, tuple[int, CompiledRule]] = {}
    out = set(situation.eliminated)
    for rule, made in fired:
        for d in made:
            if d[0] == "end":
                if d[1] in found and found[d[1]][0] != d[2]:
                    raise RuleClash("winner", found[d[1]][1], rule)
                found[d[1]] = (d[2], rule)
            elif d[0] == "seat":
                (out.add if d[2] else out.discard)(d[1])
    return tuple(Ending(unit, who) for unit, (who, _) in found.items()), frozenset(out)
