"""A match: a variant, a seed and the shots so far.

One idea: every state is kept, so undo, replay, resume and records are one mechanism.
Invariant: the situation is what the shots, judged one after the other, made of the start.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from engine.game.referee import announce, judge_shot, on_the_bed, take_in_hand
from engine.game.situation import Rest, Situation, cue_ball_of, empty
from engine.game.spotting import Board, carry_out, place_ball
from engine.game.telling import as_rules_see
from engine.table.furniture import BallId, ZoneId
from engine.variant.rack import lay_rack
from rulelang.evaluate import start

if TYPE_CHECKING:
    from collections.abc import Mapping

    from engine.game.shot import Shot
    from engine.game.verdict import Verdict
    from engine.variant.variant import Value, Variant
    from rulelang.vocabulary import Tracked


@dataclass(frozen=True, slots=True)
class Played:
    """One shot of a match with the situation before it and the verdict on it."""

    before: Situation
    shot: Shot
    verdict: Verdict


@dataclass(frozen=True, slots=True)
class Match:
    """A match as a value; `situation` is the one before the next shot.

    `names` are the players' by their number, as far as they have one.
    """

    variant: Variant
    seed: int
    settings: Mapping[str, Value]
    situation: Situation
    played: tuple[Played, ...] = field(default=())
    names: tuple[str, ...] = ()


class SettingError(ValueError):
    """A number of players or a setting that the variant does not know."""


def start_match(
    variant: Variant,
    players: int | None = None,
    settings: Mapping[str, Value] = empty(),
    seed: int = 0,
) -> Match:
    """Return a new match; raises SettingError for players or settings the variant refuses."""
    fewest, most, usual = variant.players
    count = usual if players is None else players
    if not fewest <= count <= most:
        many = str(most) if fewest == most else f"{fewest} to {most}"
        raise SettingError(f"{variant.title} is for {many} players, not {count}")
    chosen = check_settings(variant, settings)
    return Match(variant, seed, chosen, start_game(variant, count, chosen, seed))


def check_settings(variant: Variant, settings: Mapping[str, Value]) -> dict[str, Value]:
    """Return every setting of the variant with its value; raises SettingError."""
    values = {name: setting.default for name, setting in variant.settings.items()}
    for name, value in settings.items():
        if name not in values:
            known = ", ".join(values)
            has = f"; it has: {known}" if known else ": it has none"
            raise SettingError(f"{variant.title} has no setting {name}{has}")
        setting = variant.settings[name]
        if type(value) is not type(setting.default):
            kind = {bool: "true or false", int: "a whole number"}.get(type(setting.default), "text")
            raise SettingError(f"the setting {name} is {kind}, not {value!r}")
        if setting.choices and value not in setting.choices:
            known = ", ".join(map(str, setting.choices))
            raise SettingError(f"the setting {name} is one of {known}, not {value!r}")
        low, high = setting.least, setting.most
        if isinstance(value, int) and low is not None and value < low:
            raise SettingError(f"the setting {name} is at least {low}, not {value}")
        if isinstance(value, int) and high is not None and value > high:
            raise SettingError(f"the setting {name} is at most {high}, not {value}")
        values[name] = value
    return values


def start_game(
    variant: Variant,
    players: int,
    settings: Mapping[str, Value],
    seed: int = 0,
    breaker: int = 1,
    scores: tuple[int, ...] | None = None,
    last: Situation | None = None,
) -> Situation:
    """Return the situation before the first shot of a game, balls racked by the seed.

    `last` is how the game before it in the match ended: what is tracked per match is kept.
    """
    situation = Situation(
        players=players,
        shooter=breaker,
        phase=(variant.program.phases or ("",))[0],
        scores=scores or (0,) * players,
        on_table=balls_at_start(variant, breaker),
        state={**start_state(variant, players, breaker), **_kept(variant, last)},
        settings=settings,
        rest=racked(variant, seed),
        breaker=breaker,
        seed=seed,
        games=0 if last is None else last.games + 1,
        won_last=0 if last is None else last.winner or 0,
    )
    return _open(variant, situation)


def next_game(match: Match, breaker: int | None = None) -> Match:
    """Return the match with the next game begun; without a `breaker` the breaks go round.

    Raises ValueError where the game is still open, or the match is over.
    """
    last = match.situation
    if not last.over or last.match_over:
        raise ValueError("the match is over" if last.match_over else "the game is not over yet")
    chosen = last.breaker % last.players + 1 if breaker is None else breaker
    seed = match.seed + 7919 * (last.games + 1)
    begun = start_game(match.variant, last.players, match.settings, seed, chosen, last=last)
    return replace(match, situation=begun)


def _kept(variant: Variant, last: Situation | None) -> dict[str, Tracked]:
    """Return what is tracked per match, as the last game left it."""
    if last is None:
        return {}
    tracked = variant.program.tracked
    return {name: value for name, value in last.state.items() if tracked[name].scope == "match"}


def balls_at_start(variant: Variant, breaker: int = 1) -> frozenset[BallId]:
    """Return the balls in play at the start: those racked and the breaker's cue ball.

    Another player's cue ball that is not racked comes into play when its owner needs it.
    """
    return frozenset(lay_rack(variant.rack, 0)) | {cue_ball_of(variant, breaker)}


def racked(variant: Variant, seed: int) -> Rest:
    """Return the balls at rest in their starting places."""
    rest = Rest()
    for ball, at in lay_rack(variant.rack, seed).items():
        rest = place_ball(rest, ball, at)
    return rest


def start_state(variant: Variant, players: int, breaker: int = 1) -> dict[str, Tracked]:
    """Return the start value of everything the script tracks, per player as a tuple."""
    return {
        name: (start,) * players if track.per_player else start
        for name, track in variant.program.tracked.items()
        for start in [breaker if track.by_breaker else track.start]
    }


def _open(variant: Variant, situation: Situation) -> Situation:
    """Return the situation after what the script does, and offers, at the start of a game."""
    decided = start(variant.program, as_rules_see(variant, situation))
    given = decided.in_hand
    zone = None if given is None or given.zone is None else ZoneId(given.zone)
    points = decided.points or (0,) * situation.players
    board = carry_out(
        variant, Board(situation.rest, situation.on_table), decided.table, decided.homes, situation
    )
    begun = replace(
        situation,
        scores=tuple(map(sum, zip(situation.scores, points, strict=True))),
        on_table=board.on_table,
        rest=board.rest,
        offers=decided.offers,
        phase=decided.phase or situation.phase,
        state=dict(decided.state) or situation.state,
        shooter=decided.next_player or situation.shooter,
    )
    ready = take_in_hand(variant, begun, zone)
    return announce(variant, ready if zone else on_the_bed(variant, ready))


def advance(match: Match, shot: Shot, verdict: Verdict) -> Match:
    """Return the match after a shot and its verdict."""
    played = Played(match.situation, shot, verdict)
    return replace(match, situation=verdict.after, played=(*match.played, played))


def rejudge(match: Match, variant: Variant) -> Match:
    """Return the match with every shot judged again by another text of its game.

    What happened on the table stays, what the referee says of it may change. Raises SettingError
    where the players or settings do not fit, ValueError where a shot no longer can be played, and
    what judging raises.
    """
    first = match.played[0].before if match.played else match.situation
    known = {name: value for name, value in match.settings.items() if name in variant.settings}
    again = start_match(variant, first.players, known, match.seed)
    games = first.games
    for one in match.played:
        if one.before.games > games:
            games = one.before.games
            again = next_game(again, one.before.breaker)
        unknown = one.before.on_table - {kind.id for kind in variant.balls}
        if unknown:
            raise ValueError(f"a shot was played with balls that are gone: {sorted(unknown)}")
        again = advance(again, one.shot, judge_shot(variant, again.situation, one.shot))
    return replace(again, names=match.names)


def undo(match: Match) -> Match:
    """Return the match before its last shot; a match without shots as it is."""
    if not match.played:
        return match
    return replace(match, situation=match.played[-1].before, played=match.played[:-1])
