"""An option chosen: its consequences, carried out at once.

One idea: the consequences see the shot judged before, with the shooter and opponent of that shot,
and `chooser` is who chooses. Invariant: without a word about it, the chooser plays.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from rulelang.closures import forget, fresh, player_before
from rulelang.decisions import Decisions, InHand
from rulelang.explain import outcome_of, said_of
from rulelang.facts import Rest, Shot
from rulelang.judging import judge_shot
from rulelang.moment import cue_ball_of, endings_of, homes_of, look
from rulelang.program import CONSEQUENCE
from rulelang.settle import (
    decide_in_hand,
    decide_phase,
    offers_of,
    sum_points,
    table_actions,
    write_state,
)

if TYPE_CHECKING:
    from rulelang.decisions import RuleOutcome
    from rulelang.facts import Situation
    from rulelang.firing import Fired
    from rulelang.program import Program
    from rulelang.watch import Watch


def choose(
    program: Program,
    situation: Situation,
    option: str,
    key: int | None,
    before: Situation | None,
    shot: Shot | None,
    ball: str | None = None,
) -> Decisions:
    """Return what happens when `situation.shooter` chooses `option`, and names `ball` with it.

    `key` is the offer's; without it the consequences are found by the option's name. `before`
    and `shot` are the judged situation and shot, None where nothing is known of them.
    """
    made = _consequence(program, option, key)
    if before is not None and shot is not None:
        c, judged = judge_shot(program, before, shot, explain=False)
        c.next_phase = judged.phase
    else:
        c = look(program, situation)
        c.cue = program.bits[cue_ball_of(program, situation.shooter)]
        c.objects = program.ball_mask & ~c.cue
        if made is not None and made.to == "opponent":
            c.shooter = player_before(c, situation.shooter)
    c.memo = fresh(program.lasting)
    forget(c)
    c.chooser = c.next_player = situation.shooter
    c.chosen = program.bits.get(ball or "", 0)
    c.phase = situation.phase if before is None else before.phase
    c.state, c.scores = situation.state, situation.scores
    rest = shot.rest if shot is not None else Rest(situation.zones, situation.frozen)
    c.shot = shot or Shot(program.names[c.cue], (), rest=rest)
    c.stage = CONSEQUENCE
    c.homes = homes_of(program, c)
    c.actions = ()
    out: list[tuple[Any, ...]] = []
    rules = [rule for found in program.compiled.values() for rule in found]
    if made is not None:
        made.run(c, out)
    rule = next((r for r in rules if made is not None and r.number == made.rule), None)
    fired: Fired = [] if rule is None else [(rule, out)]
    decided = _chosen(program, situation, before, c, fired)
    return replace(decided, explanation=_told(c, option, fired))


def _told(c: Watch, option: str, fired: Fired) -> tuple[RuleOutcome, ...]:
    """Return the rule that offered the option, and what its consequences did."""
    because = f"player {c.chooser} chose {option}"
    return tuple(
        replace(
            outcome_of(rule.info, "fired", because, (), tuple(said_of(c, one) for one in made)),
            section="choice",
        )
        for rule, made in fired
    )


def _chosen(
    program: Program, situation: Situation, before: Situation | None, c: Watch, fired: Fired
) -> Decisions:
    acts = [d for _, made in fired for d in made]
    players = [d[1] for d in acts if d[0] == "plays" or (d[0] == "turn" and d[2] is not None)]
    restored = any(d[0] == "restore" for d in acts) and before is not None
    origin = before if restored and before is not None else situation
    player = players[0] if players else situation.shooter
    in_hand = decide_in_hand(fired)
    if in_hand is None and origin.in_hand is not None and not any(d[0] == "rerack" for d in acts):
        in_hand = InHand(player, origin.in_hand)
    endings, eliminated = endings_of(fired, situation)
    return Decisions(
        points=sum_points(fired, c.players, program.mates),
        state=write_state(program, fired, c.state),
        phase=decide_phase(fired) or origin.phase,
        next_player=player,
        continues=player == situation.shooter,
        table=table_actions(program, fired, c),
        in_hand=in_hand,
        offers=offers_of(fired),
        endings=endings,
        eliminated=eliminated,
        homes=c.homes,
    )


def _consequence(program: Program, option: str, key: int | None) -> Any:
    if key is not None and 0 <= key < len(program.consequences):
        return program.consequences[key]
    return next((one for one in program.consequences if one.option == option), None)
