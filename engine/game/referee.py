"""The referee: what a shot means by the rules, and the situation that follows.

One idea: the script decides, the referee carries out. Choice first, then the stroke; each
turns one Situation into the next. Nothing here plays a sound, draws or reads a clock.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from engine.game.aftermath import balls_in, rest_after
from engine.game.situation import Judged, Situation, ball_to_strike, cue_ball_of
from engine.game.spotting import Board, carry_out, lift, place_ball, starting_place
from engine.game.telling import as_rules_hear, as_rules_see
from engine.game.verdict import Verdict
from engine.table.furniture import BallId, ZoneId
from rulelang.account import OMITTED, account_of
from rulelang.evaluate import Admission, admit, announces, choose, judge

if TYPE_CHECKING:
    from engine.game.shot import Shot
    from engine.variant.variant import Variant
    from rulelang import facts as said
    from rulelang.decisions import Decisions, Offer
    from rulelang.events import Event

PLAY = "play"


def look_ahead(variant: Variant, situation: Situation, call: said.Call | None = None) -> Admission:
    """Return what must be called, what may be chosen and what is on before the next shot."""
    return admit(variant.program, as_rules_see(variant, situation), call)


def judge_shot(
    variant: Variant, situation: Situation, shot: Shot, *, explain: bool = True
) -> Verdict:
    """Return the verdict on a shot whose events are known, or that is only a choice."""
    if not situation.offers and not shot.is_only_choice:
        return _judge_stroke(variant, situation, shot, explain=explain)
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
        as_rules_see(variant, situation),
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
    after = _follow(variant, after, decided, board, in_hand, situation.judged)
    if board.restored and last:
        after = _as_before(variant, after, last.before, decided)
    return _verdict(decided, board, _chosen_once(after, taken), (), explain=explain)


def _chosen_once(after: Situation, taken: Offer) -> Situation:
    """Return the situation without the offer just taken: one made before each shot stands still.

    What is on offer before a shot is chosen once; the stroke follows.
    """
    known = {taken.key} if taken.key >= 0 else {one.key for one in after.offers}
    again = any(one.option == taken.option and one.key in known for one in after.offers)
    return replace(after, offers=()) if again else after


def _judge_stroke(variant: Variant, situation: Situation, shot: Shot, *, explain: bool) -> Verdict:
    before = _forget(situation)
    program, events = variant.program, shot.events or ()
    struck = shot.struck or ball_to_strike(variant, before)
    seen = as_rules_see(variant, before)
    account = account_of(program.bits, struck, seen.frozen, events, program.settled_within)
    down = balls_in(variant, account.down)
    rest = rest_after(variant, before, shot, account, down)
    told = as_rules_hear(variant, before, shot, struck, account, rest)
    decided = judge(program, seen, told, explain=explain)
    board = Board(rest, before.on_table - down)
    board = carry_out(variant, board, decided.table, decided.homes, before)
    in_hand = before.in_hand if account.seen[OMITTED] else None
    judged = Judged(seen, told, before)
    after = _follow(variant, before, decided, board, in_hand, judged)
    return _verdict(decided, board, after, events, explain=explain)


def _forget(situation: Situation) -> Situation:
    """Return the situation without offers, and without the shot judged before it.

    So history stays short.
    """
    if not situation.offers and situation.judged is None:
        return situation
    return Situation(
        situation.players,
        situation.shooter,
        situation.phase,
        situation.scores,
        situation.on_table,
        situation.state,
        situation.settings,
        situation.rest,
        situation.in_hand,
        (),
        situation.breaker,
        situation.eliminated,
        situation.seed,
        situation.shots,
        situation.games,
        situation.won_last,
        situation.winner,
        situation.match_over,
        None,
        situation.strikable,
    )


def _follow(
    variant: Variant,
    before: Situation,
    decided: Decisions,
    board: Board,
    in_hand: ZoneId | None,
    judged: Judged | None,
) -> Situation:
    """Return the situation that decisions make; `in_hand` holds where they do not speak of it."""
    shooter = decided.offers[0].player if decided.offers else decided.next_player
    given, over = decided.in_hand, decided.endings
    if given is not None:
        in_hand = None if given.zone is None else ZoneId(given.zone)
    on_table, rest, cue = board.on_table, board.rest, cue_ball_of(variant, shooter)
    if in_hand is not None:
        on_table, rest = on_table | {cue}, lift(rest, frozenset({cue}))
    after = Situation(
        before.players,
        shooter,
        decided.phase,
        tuple(map(sum, zip(before.scores, decided.points, strict=False))) or before.scores,
        on_table,
        decided.state,
        before.settings,
        rest,
        None if over else in_hand,
        () if over else decided.offers,
        before.breaker,
        decided.eliminated,
        before.seed,
        before.shots + 1,
        before.games,
        before.won_last,
        over[0].winner if over else before.winner,
        any(one.unit == "match" for one in over) if over else before.match_over,
        judged,
        before.strikable if over else frozenset(),
    )
    if over:
        return after
    if cue not in on_table and not look_ahead(variant, after).strikable:
        after = on_the_bed(variant, after)
    return announce(variant, after)


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
    rest = place_ball(situation.rest, ball, at)
    return replace(situation, rest=rest, on_table=situation.on_table | {ball})


def announce(variant: Variant, after: Situation) -> Situation:
    """Return the situation with what the script offers, and lets strike, before the next shot."""
    if not after.strikable and not announces(variant.program, after.phase):
        return after
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


def _verdict(
    decided: Decisions, board: Board, after: Situation, events: tuple[Event, ...], *, explain: bool
) -> Verdict:
    return Verdict(
        decided.fouls,
        decided.points or (0,) * after.players,
        board.spotted,
        board.removed,
        board.reracked,
        decided.explanation if explain else (),
        events,
        after,
    )
