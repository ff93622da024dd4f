"""A shot judged: fouls, points, turn, table, next shot, ending, asked in this order.

One idea: a section's rules read what the sections before it left, and what they decide together
becomes the next section's view. Invariant: a watch only moves on, never back to a section.
"""

from __future__ import annotations

from operator import add
from typing import TYPE_CHECKING

from rulelang.closures import forget, opponent
from rulelang.decisions import Decisions, Ending, InHand, Offer, Rerack
from rulelang.ends import close
from rulelang.explain import Explanation, Log
from rulelang.firing import (
    ENDING,
    NEXT_SHOT,
    POINTS,
    TABLE,
    TURN,
    Fired,
    ask,
    judge_fouls,
)
from rulelang.moment import endings_of, homes_of, look
from rulelang.settle import (
    Turn,
    decide_in_hand,
    decide_phase,
    decide_turn,
    offers_of,
    sum_points,
    table_actions,
    write_state,
)

if TYPE_CHECKING:
    from collections.abc import Mapping

    from rulelang.facts import Shot, Situation
    from rulelang.program import Program
    from rulelang.vocabulary import Tracked
    from rulelang.watch import Watch


def judge_shot(
    program: Program, situation: Situation, shot: Shot, *, explain: bool
) -> tuple[Watch, Decisions]:
    """Return all decisions about a shot, and the watch as the last section left it."""
    c = look(program, situation)
    c.show(shot, program.settled_within)
    log = Log() if explain else None
    judge_fouls(program, c, log)
    points = _points(program, c, log)
    turn = _turn(program, c, log)
    _table(program, c, log)
    in_hand, offers, written = _next_shot(program, c, log)
    ended, eliminated, extra = _ending(program, situation, c, log)
    points = tuple(a + b for a, b in zip(points, extra, strict=True)) if ended else points
    next_player = _still_in(c, turn, eliminated)
    if next_player != c.next_player:
        in_hand, offers = _handed_on(c.next_player, next_player, in_hand, offers)
    if offers and not ended:
        next_player = offers[0].player
    over = bool(ended)
    decisions = Decisions(
        fouls=c.fouls,
        points=points,
        state=_reset(program, c.state, turn, written),
        phase=c.next_phase,
        next_player=next_player,
        continues=turn.continues,
        table=tuple(a for a in c.actions if not isinstance(a, Rerack)) if over else c.actions,
        in_hand=None if over else in_hand,
        offers=() if over else offers,
        endings=ended,
        eliminated=eliminated,
        homes=c.homes,
        explanation=() if log is None else Explanation(c, log),  # type: ignore[arg-type]
    )
    return c, decisions


def _points(program: Program, c: Watch, log: Log | None) -> tuple[int, ...]:
    fired = ask(program, c, POINTS, log)
    points = sum_points(fired, c.players, program.mates)
    if fired:
        _write(program, c, fired)
        if any(points):
            c.scores = tuple(map(add, c.scores, points))
    return points


def _write(program: Program, c: Watch, fired: Fired) -> None:
    """Write what a section decided; what changes from section to section is read anew."""
    c.state = write_state(program, fired, c.state)
    forget(c)


def _turn(program: Program, c: Watch, log: Log | None) -> Turn:
    fired = ask(program, c, TURN, log)
    turn = decide_turn(fired, c)
    if fired:
        _write(program, c, fired)
    c.continues, c.next_phase = turn.continues, decide_phase(fired) or c.phase
    c.next_player = _to_play(c, turn)
    c.homes = homes_of(program, c) if program.homes else {}
    return turn


def _table(program: Program, c: Watch, log: Log | None) -> None:
    fired = ask(program, c, TABLE, log)
    if fired:
        state = write_state(program, fired, c.state)
        c.actions, c.state = table_actions(program, fired, c), state
        forget(c)


def _next_shot(
    program: Program, c: Watch, log: Log | None
) -> tuple[InHand | None, tuple[Offer, ...], set[str]]:
    """Return the ball in hand, the offers, and the names of what was written."""
    fired = ask(program, c, NEXT_SHOT, log)
    if not fired:
        return None, (), set()
    in_hand, offers = decide_in_hand(fired), offers_of(fired)
    before = c.state
    _write(program, c, fired)
    return in_hand, offers, _written(fired, before, c.state)


def _written(fired: Fired, before: Mapping[str, Tracked], after: Mapping[str, Tracked]) -> set[str]:
    changed = {name for name in after if after[name] != before.get(name)}
    return changed | {d[2] for _, made in fired for d in made if d[0] == "write"}


def _ending(
    program: Program, situation: Situation, c: Watch, log: Log | None
) -> tuple[tuple[Ending, ...], frozenset[int], tuple[int, ...]]:
    fired = ask(program, c, ENDING, log)
    if not fired:
        return (), situation.eliminated, ()
    c.state = write_state(program, fired, c.state)
    ended, eliminated = endings_of(fired, situation)
    if not ended:
        return ended, eliminated, ()
    ended, points = close(program, situation, c, ended, log)
    return ended, eliminated, points


def _to_play(c: Watch, turn: Turn) -> int:
    if turn.continues:
        return c.shooter
    return opponent(c, c.shooter) if turn.player is None else turn.player


def _still_in(c: Watch, turn: Turn, eliminated: frozenset[int]) -> int:
    """Return who plays next: one who is out is passed over, one who is back in is not."""
    passes = turn.player is None and not turn.continues
    player = c.shooter % c.players + 1 if passes else c.next_player
    for _ in range(c.players):
        if player not in eliminated:
            return player
        player = player % c.players + 1
    return turn.player or player


def _handed_on(
    one: int, other: int, in_hand: InHand | None, offers: tuple[Offer, ...]
) -> tuple[InHand | None, tuple[Offer, ...]]:
    """Give to the other player what was meant for who was to play next."""
    if in_hand is not None and in_hand.player == one:
        in_hand = InHand(other, in_hand.zone)
    offered = tuple(Offer(other, o.option, o.key) if o.player == one else o for o in offers)
    return in_hand, offered


def _reset(
    program: Program, state: Mapping[str, Tracked], turn: Turn, written: set[str]
) -> Mapping[str, Tracked]:
    """Set back what is tracked per shot, and per turn where the turn passes."""
    changed: dict[str, Tracked] = {}
    for name, track in program.tracked.items():
        if track.scope == "shot" or (track.scope == "turn" and not turn.continues):
            if name in written:
                continue
            value = state.get(name)
            start = (track.start,) * len(value) if isinstance(value, tuple) else track.start
            if start != value:
                changed[name] = start
    return {**state, **changed} if changed else state
