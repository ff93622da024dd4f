"""The referee: what a shot means by the rules, and the situation that follows.

One idea: the script decides, the referee carries out. Choice first, then the stroke; each
turns one Situation into the next. Nothing here plays a sound, draws or reads a clock.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from engine.game.aftermath import fallen, rest_after
from engine.game.predicates import predicates_of
from engine.game.situation import (
    Judged,
    Situation,
    as_rules_see,
    ball_to_strike,
    cue_ball_of,
    zones_of,
)
from engine.game.spotting import Board, carry_out, covers, lift, place_ball, starting_place
from engine.game.verdict import Verdict
from engine.table.furniture import BallId, ZoneId
from rulelang import facts as said
from rulelang.evaluate import Admission, admit, choose, judge
from rulelang.events import StrokeOmitted

if TYPE_CHECKING:
    from engine.game.shot import Shot
    from engine.game.situation import Rest
    from engine.variant.variant import Variant
    from rulelang.decisions import Decisions, Offer

PLAY = "play"


def look_ahead(variant: Variant, situation: Situation, call: said.Call | None = None) -> Admission:
    """Return what must be called, what may be chosen and what is on before the next shot."""
    return admit(variant.program, as_rules_see(situation), call)


def judge_shot(
    variant: Variant, situation: Situation, shot: Shot, *, explain: bool = True
) -> Verdict:
    """Return the verdict on a shot whose events are known, or that is only a choice."""
    chosen = take_choice(variant, situation, shot, explain=explain)
    if shot.is_only_choice or chosen.after.over:
        return chosen
    verdict = _judge_stroke(variant, chosen.after, shot, explain=explain)
    if not chosen.explanation:
        return verdict
    return replace(verdict, explanation=(*chosen.explanation, *verdict.explanation))


def offer_taken(situation: Situation, choice: str | None) -> Offer | None:
    """Return the offer that a choice takes; `play` is taken where it is on offer and no other.

    An option that is not on offer is void.
    """
    on_offer = {offer.option: offer for offer in situation.offers}
    return on_offer.get(choice or PLAY) or on_offer.get(PLAY)


def take_choice(
    variant: Variant, situation: Situation, shot: Shot, *, explain: bool = True
) -> Verdict:
    """Return the verdict of the choice alone: what its consequences did at once."""
    taken = offer_taken(situation, shot.choice)
    after = replace(situation, offers=())
    if taken is None:
        return _nothing_said(after)
    last = situation.judged
    decided = choose(
        variant.program,
        as_rules_see(situation),
        taken.option,
        taken.key if taken.key >= 0 else None,
        last.situation if last else None,
        last.shot if last else None,
        shot.call.ball,
    )
    board = carry_out(
        variant,
        Board(situation.rest, situation.on_table),
        decided.table,
        decided.homes,
        last.before if last else situation,
    )
    in_hand = None if board.restored else situation.in_hand
    after = _follow(variant, after, decided, board, in_hand)
    if board.restored and last:
        after = _as_before(variant, after, last.before, decided)
    return _verdict(decided, board, _chosen_once(after, taken), explain=explain)


def _chosen_once(after: Situation, taken: Offer) -> Situation:
    """Return the situation without the offer just taken: one made before each shot stands still.

    What is on offer before a shot is chosen once; the stroke follows.
    """
    known = {taken.key} if taken.key >= 0 else {one.key for one in after.offers}
    again = any(one.option == taken.option and one.key in known for one in after.offers)
    return replace(after, offers=()) if again else after


def _judge_stroke(variant: Variant, situation: Situation, shot: Shot, *, explain: bool) -> Verdict:
    before = replace(situation, offers=())
    events = shot.events or ()
    down = fallen(events, variant.program.settled_within)
    rest = rest_after(variant, before, shot, down)
    seen, told = as_rules_see(before), _as_rules_hear(variant, before, shot, rest)
    decided = judge(variant.program, seen, told, explain=explain)
    board = Board(rest, before.on_table - down)
    board = carry_out(variant, board, decided.table, decided.homes, before)
    unplayed = any(isinstance(event, StrokeOmitted) for event in events)
    after = _follow(variant, before, decided, board, before.in_hand if unplayed else None)
    after = replace(after, judged=Judged(seen, told, _forget(before)))
    verdict = _verdict(decided, board, after, explain=explain)
    return replace(verdict, events=events)


def _as_rules_hear(variant: Variant, before: Situation, shot: Shot, after: Rest) -> said.Shot:
    placed = shot.placement
    return said.Shot(
        struck=shot.struck or ball_to_strike(variant, before),
        events=shot.events or (),
        call=shot.call,
        chosen=shot.choice,
        facts=shot.facts,
        predicates=predicates_of(variant, before, shot, after),
        rest=said.Rest(
            {ball: frozenset(zones) for ball, zones in after.zones.items()},
            after.frozen,
            covers(variant, after),
        ),
        placed=None if placed is None else zones_of(variant.world.table, placed),
    )


def _forget(situation: Situation) -> Situation:
    """Return the situation without the shot judged before it, so that history stays short."""
    return replace(situation, judged=None)


def _follow(
    variant: Variant,
    before: Situation,
    decided: Decisions,
    board: Board,
    in_hand: ZoneId | None,
) -> Situation:
    """Return the situation that decisions make; `in_hand` holds where they do not speak of it."""
    shooter = decided.offers[0].player if decided.offers else decided.next_player
    scores = tuple(map(sum, zip(before.scores, decided.points, strict=False)))
    given = decided.in_hand
    if given is not None:
        in_hand = None if given.zone is None else ZoneId(given.zone)
    after = replace(
        before,
        shooter=shooter,
        phase=decided.phase,
        scores=scores or before.scores,
        on_table=board.on_table,
        state=dict(decided.state),
        rest=board.rest,
        offers=decided.offers,
        eliminated=decided.eliminated,
        shots=before.shots + 1,
    )
    after = take_in_hand(variant, after, in_hand)
    if not decided.endings and cue_ball_of(variant, shooter) not in after.on_table:
        after = after if look_ahead(variant, after).strikable else on_the_bed(variant, after)
    return _end(after, decided) if decided.endings else announce(variant, after)


def take_in_hand(variant: Variant, situation: Situation, zone: ZoneId | None) -> Situation:
    """Return the situation with the shooter's cue ball in hand in `zone`, or not in hand."""
    if zone is None:
        return replace(situation, in_hand=None)
    ball = cue_ball_of(variant, situation.shooter)
    return replace(
        situation,
        in_hand=zone,
        on_table=situation.on_table | {ball},
        rest=lift(situation.rest, frozenset({ball})),
    )


def on_the_bed(variant: Variant, situation: Situation) -> Situation:
    """Return the situation with the shooter's cue ball on the bed, at its start if need be."""
    ball = cue_ball_of(variant, situation.shooter)
    if situation.in_hand is not None or ball in situation.rest.positions:
        return situation
    at = starting_place(variant, situation.rest, ball)
    if at is None:
        return situation
    rest = place_ball(variant, situation.rest, ball, at)
    return replace(situation, rest=rest, on_table=situation.on_table | {ball})


def _end(after: Situation, decided: Decisions) -> Situation:
    over = decided.endings[0]
    return replace(
        after,
        winner=over.winner,
        match_over=any(one.unit == "match" for one in decided.endings),
        offers=(),
        in_hand=None,
    )


def announce(variant: Variant, after: Situation) -> Situation:
    """Return the situation with what the script offers, and lets strike, before the next shot."""
    ahead = look_ahead(variant, after)
    strikable = frozenset(map(BallId, ahead.strikable))
    return replace(after, offers=after.offers or ahead.offers, strikable=strikable)


def _as_before(
    variant: Variant, after: Situation, before: Situation, decided: Decisions
) -> Situation:
    """Return the situation with phase and turn as before the stroke; scores and counters stay."""
    tracked = variant.program.tracked
    turned = {name: before.state[name] for name in before.state if tracked[name].scope == "turn"}
    phase = before.phase if decided.phase == after.phase else decided.phase
    return replace(
        take_in_hand(variant, after, before.in_hand),
        phase=phase,
        state={**after.state, **turned},
    )


def _nothing_said(after: Situation) -> Verdict:
    return Verdict((), (0,) * after.players, (), (), 0, (), (), after)


def _verdict(decided: Decisions, board: Board, after: Situation, *, explain: bool) -> Verdict:
    return Verdict(
        fouls=decided.fouls,
        points=decided.points or (0,) * after.players,
        spotted=board.spotted,
        removed=board.removed,
        reracked=board.reracked,
        explanation=decided.explanation if explain else (),
        events=(),
        after=after,
    )
