"""The rules asked at each moment of a game: its start, before a shot, after it, at a choice.

One idea: one function for each moment; the host calls these four and nothing else.
Invariant: whatever they are asked, they change nothing that they were given.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rulelang.choosing import choose
from rulelang.closures import singles
from rulelang.decisions import Admission, Decisions, Required
from rulelang.ends import starting
from rulelang.firing import fire, override, rules_of
from rulelang.judging import judge_shot
from rulelang.moment import cue_ball_of, homes_of, look, start_of
from rulelang.program import ANNOUNCED, CONSEQUENCE
from rulelang.settle import (
    RuleClash,
    decide_in_hand,
    decide_phase,
    decide_turn,
    offers_of,
    sum_points,
    table_actions,
    write_state,
)
from rulelang.watch import OutOfFuel

if TYPE_CHECKING:
    from rulelang.facts import Call, Shot, Situation
    from rulelang.program import Program
    from rulelang.vocabulary import Tracked

__all__ = ["Admission", "OutOfFuel", "RuleClash", "admit", "announces", "choose", "judge", "start"]


def start(program: Program, situation: Situation) -> Decisions:
    """Return what the rules say at the start of a game: state, phase, ball in hand."""
    c = look(program, situation)
    c.state = _start_state(program, situation)
    c.next_player = situation.breaker
    c.shooter = situation.breaker
    first = program.phases[0] if program.phases else ""
    c.phase = c.next_phase = first
    c.stage = CONSEQUENCE
    fired = starting(program, situation, c)
    c.state = write_state(program, fired, c.state)
    turn = decide_turn(fired, c)
    return Decisions(
        points=sum_points(fired, c.players, program.mates),
        state=c.state,
        phase=decide_phase(fired) or first,
        next_player=situation.breaker if turn.player is None else turn.player,
        table=table_actions(program, fired, c),
        in_hand=decide_in_hand(fired),
        offers=offers_of(fired),
        homes=homes_of(program, c),
    )


def admit(program: Program, situation: Situation, call: Call | None = None) -> Admission:
    """Return what must be announced, what may be chosen, and which balls are on."""
    c = look(program, situation)
    c.call = call
    c.cue = program.bits[cue_ball_of(program, situation.shooter)]
    c.objects = program.ball_mask & ~c.cue
    fired, _ = override(fire(rules_of(program, "before shot", c.phase), c))
    required = tuple(Required(d[1], d[2]) for _, made in fired for d in made if d[0] == "require")
    on = frozenset[str]()
    if program.on is not None:
        on = frozenset(program.names[bit] for bit in singles(program.on(c) & c.on_before))
    struck = 0
    for _, made in fired:
        for d in made:
            if d[0] == "strike":
                struck |= d[1]
    strikable = frozenset(program.names[bit] for bit in singles(struck & c.on_before))
    return Admission(required, offers_of(fired), on, strikable)


def announces(program: Program, phase: str) -> bool:
    """Tell whether `admit` may offer anything in a phase, or let other balls be struck."""
    found = program.by_phase.get(ANNOUNCED, {}).get(phase)
    return found is None or bool(found)


def judge(program: Program, situation: Situation, shot: Shot, *, explain: bool = True) -> Decisions:
    """Return everything the rules decide about a shot.

    Raises RuleClash where two rules decide one thing differently and neither overrides.
    """
    return judge_shot(program, situation, shot, explain=explain)[1]


def _start_state(program: Program, situation: Situation) -> dict[str, Tracked]:
    state: dict[str, Tracked] = {}
    for name, track in program.tracked.items():
        if track.scope == "match" and name in situation.state:
            state[name] = situation.state[name]
        else:
            state[name] = start_of(program, name, situation)
    return state
