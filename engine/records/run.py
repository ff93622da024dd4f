"""A record is judged: by its events, and by playing its strike again where it has one.

One idea: each shot is judged in the situation that the shot before it left.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot
from typing import TYPE_CHECKING

from engine.game.match import Match, next_game
from engine.game.phrases import format_event, without_time
from engine.game.referee import judge_shot, offer_taken
from engine.records.compare import WITHIN, Difference, compare
from engine.records.hash import physics_hash
from engine.records.record import RecordError
from rulelang.evaluate import RuleClash

if TYPE_CHECKING:
    from collections.abc import Iterator

    from engine.game.shot import Shot
    from engine.game.situation import Situation
    from engine.game.verdict import Verdict
    from engine.records.record import Record
    from rulelang.events import Event

MILLISECOND = 1e-3
ROUNDING = 1e-6


@dataclass(frozen=True, slots=True)
class Judgement:
    """One shot of a record as judged: the situation before it, the shot, the verdict."""

    before: Situation
    shot: Shot
    verdict: Verdict


@dataclass(frozen=True, slots=True)
class Outcome:
    """What came of a record; `replayed` is None where it holds no strike to play again."""

    record: Record
    judgements: tuple[Judgement, ...]
    differences: tuple[Difference, ...]
    replayed: bool | None

    @property
    def passed(self) -> bool:
        """Whether everything came out as expected."""
        return not self.differences


def run_record(record: Record, *, replay: bool = True) -> Outcome:
    """Return what the referee says of a record, against what it expects.

    Raises RecordError where a shot cannot be judged at all.
    """
    situation = record.start
    judged: list[Judgement] = []
    differences: list[Difference] = []
    replayed: bool | None = None
    for number, step in enumerate(record.steps, 1):
        if number - 1 in record.begun:
            situation = _next_game(record, situation, record.begun[number - 1])
        _check_playable(record, situation, step.shot, number)
        shot, played, strays = _played(record, situation, step.shot, number, replay=replay)
        replayed = played if replayed is None else (replayed and played is not False)
        verdict = _judged(record, situation, shot, number)
        judged.append(Judgement(situation, shot, verdict))
        differences += [*strays, *compare(number, step.expect, verdict, situation)]
        situation = verdict.after
    return Outcome(record, tuple(judged), tuple(differences), replayed)


def _next_game(record: Record, over: Situation, breaker: int) -> Situation:
    match = Match(record.variant, record.start.seed, record.start.settings, over)
    return next_game(match, breaker).situation


def _judged(record: Record, situation: Situation, shot: Shot, number: int) -> Verdict:
    try:
        return judge_shot(record.variant, situation, shot)
    except RuleClash as clash:
        mend = "let one of the two rules override the other, or narrow their conditions"
        raise _unusable(record, ("shot", number - 1), str(clash), mend) from None


def _check_playable(record: Record, situation: Situation, shot: Shot, number: int) -> None:
    where = ("shot", number - 1)
    if situation.over:
        raise _unusable(record, where, "the shot before this one has ended the game")
    if situation.offers and offer_taken(situation, shot.choice) is None:
        options = ", ".join(situation.options)
        raise _unusable(record, where, "a choice must be given", f"choose = one of: {options}")


def _unusable(
    record: Record, where: tuple[str | int, ...], message: str, mend: str = ""
) -> RecordError:
    return RecordError((record.source.diagnostic("T401", where, message, mend, on_key=True),))


def _played(
    record: Record, situation: Situation, shot: Shot, number: int, *, replay: bool
) -> tuple[Shot, bool | None, list[Difference]]:
    """Return the shot with its events, whether it was played, and how the play strayed."""
    if shot.strike is None:
        return shot, None, []
    known = _positions_known(record, situation, shot)
    same = record.physics is None or record.physics == physics_hash(record.variant.world)
    if shot.events is not None and not (known and same and replay):
        return shot, False, []
    if not known:
        where = ("shot", number - 1, "strike")
        mend = "give before.positions for every ball on the table, and place for a ball in hand"
        raise _unusable(record, where, "the stroke cannot be played without positions", mend)
    from engine.game.observe import play  # noqa: PLC0415  a record of events needs no physics

    seen = play(record.variant, situation, shot)
    if shot.events is None:
        return seen, True, []
    return shot, True, list(_strays(number, shot, seen))


def _positions_known(record: Record, situation: Situation, shot: Shot) -> bool:
    from engine.game.referee import take_choice  # noqa: PLC0415

    chosen = take_choice(record.variant, situation, shot).after if situation.offers else situation
    in_hand = chosen.in_hand is not None
    lying = chosen.rest.positions.keys() | (
        set(record.variant.cue_balls) if in_hand and shot.placement is not None else set()
    )
    return bool(lying) and chosen.on_table <= lying


def _strays(number: int, told: Shot, seen: Shot) -> Iterator[Difference]:
    wanted, got = told.events or (), seen.events or ()
    if not _same_events(wanted, got):
        yield Difference(
            number,
            "events",
            [format_event(one) for one in wanted],
            [format_event(one) for one in got],
        )
    for ball, (x, y) in told.after.positions.items():
        at = seen.after.positions.get(ball)
        if at is None or hypot(at[0] - x, at[1] - y) > WITHIN:
            yield Difference(number, f"after.positions.{ball}", [x, y], at and list(at))


def _same_events(wanted: tuple[Event, ...], got: tuple[Event, ...]) -> bool:
    if len(wanted) != len(got):
        return False
    return all(
        without_time(one) == without_time(other)
        and (
            one.time is None
            or other.time is None
            or abs(one.time - other.time) <= MILLISECOND + ROUNDING
        )
        for one, other in zip(wanted, got, strict=True)
    )
