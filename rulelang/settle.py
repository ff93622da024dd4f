"""Many rules, one decision: sums, sets and single values settled without regard to order.

One idea: each kind of decision has its own way to be put together, and two rules that cannot
both be right are a clash that names both. Invariant: the result does not depend on rule order.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from rulelang.closures import singles
from rulelang.decisions import (
    InHand,
    Offer,
    Place,
    Remove,
    Rerack,
    Restore,
    SetUp,
    Spot,
    TableAction,
)

if TYPE_CHECKING:
    from collections.abc import Mapping

    from rulelang.program import CompiledRule, Program
    from rulelang.vocabulary import Tracked
    from rulelang.watch import Watch

    Fired = list[tuple[CompiledRule, list[tuple[Any, ...]]]]


class RuleClash(Exception):  # noqa: N818
    """Two rules decide one thing differently and neither overrides the other."""

    def __init__(self, what: str, one: CompiledRule, other: CompiledRule) -> None:
        places = " and ".join(
            f'"{rule.info.name}" ({rule.info.file}:{rule.info.line})' for rule in (one, other)
        )
        super().__init__(f"two rules decide the {what} differently: {places}")
        self.what = what
        self.rules = (one.info, other.info)


@dataclass(frozen=True, slots=True)
class Turn:
    """Who plays on; `player` is None where the turn simply passes."""

    continues: bool
    player: int | None


def _each(fired: Fired, tag: str) -> list[tuple[CompiledRule, tuple[Any, ...]]]:
    return [(rule, one) for rule, made in fired for one in made if one[0] == tag]


def _single(fired: Fired, tag: str, what: str) -> tuple[Any, ...] | None:
    found: tuple[Any, ...] | None = None
    owner: CompiledRule | None = None
    for rule, decision in _each(fired, tag):
        if found is not None and owner is not None and found != decision:
            raise RuleClash(what, owner, rule)
        found, owner = decision, rule
    return found


def decide_turn(fired: Fired, _c: Watch) -> Turn:
    """Return the turn; by default it passes."""
    found = _single(fired, "turn", "turn") if fired else None
    return Turn(continues=False, player=None) if found is None else Turn(found[1], found[2])


def decide_phase(fired: Fired) -> str | None:
    """Return the next phase, None where no rule decides it."""
    found = _single(fired, "phase", "phase") if fired else None
    return None if found is None else str(found[1])


def decide_in_hand(fired: Fired) -> InHand | None:
    """Return who has the cue ball in hand, and where."""
    found = _single(fired, "hand", "ball in hand") if fired else None
    return None if found is None else InHand(found[1], found[2])


def sum_points(fired: Fired, players: int, mates: int = 0) -> tuple[int, ...]:
    """Return the change of each player's score; players of one side have one score."""
    points = [0] * players
    if not fired:
        return tuple(points)
    for _, decision in _each(fired, "points"):
        for player in side_of(decision[1], players, mates):
            points[player - 1] += decision[2]
    return tuple(points)


def side_of(player: int, players: int, mates: int) -> range:
    """Return the players of one side of `mates`, who come to the table in turns; 0: alone."""
    sides = max(1, players // mates) if mates else players
    return range((player - 1) % sides + 1, players + 1, sides)


def offers_of(fired: Fired) -> tuple[Offer, ...]:
    """Return the offers, each option once; one option with two consequences is a clash."""
    found: dict[tuple[int, str], tuple[int, CompiledRule]] = {}
    for rule, (_, player, option, key) in _each(fired, "offer"):
        if (player, option) in found and found[player, option][0] != key:
            raise RuleClash(f"option {option}", found[player, option][1], rule)
        for other, _ in found:
            if other != player:
                raise RuleClash("player who chooses", found[other, _][1], rule)
        found[player, option] = (key, rule)
    return tuple(Offer(player, option, key) for (player, option), (key, _) in found.items())


def write_state(
    program: Program, fired: Fired, state: Mapping[str, Tracked]
) -> Mapping[str, Tracked]:
    """Return the tracked values after the writes of a section."""
    writes = _each(fired, "write")
    if not writes:
        return state
    adds: dict[tuple[str, int | None], tuple[int, CompiledRule]] = {}
    sets: dict[tuple[str, int | None], tuple[Any, CompiledRule]] = {}
    for rule, (_, op, name, player, value) in writes:
        where = (name, _keeper(program, state, name, player))
        if op == "add":
            adds[where] = (adds.get(where, (0, rule))[0] + value, rule)
            continue
        track = program.tracked[name]
        new = (1 if track.by_breaker else track.start) if op == "reset" else value
        if where in sets and sets[where][0] != new:
            raise RuleClash(f"value of {name}", sets[where][1], rule)
        sets[where] = (new, rule)
    for where, (_, rule) in adds.items():
        if where in sets:
            raise RuleClash(f"value of {where[0]}", rule, sets[where][1])
    return _written(program, state, adds, sets)


def _keeper(program: Program, state: Any, name: str, player: int | None) -> int | None:
    """Return the player under whom a value is kept: the first of a side that shares it."""
    if player is None or not program.tracked[name].per_side:
        return player
    return side_of(player, len(state[name]), program.mates)[0]


def _written(
    program: Program, state: Mapping[str, Tracked], adds: Any, sets: Any
) -> Mapping[str, Tracked]:
    after = dict(state)
    for table, adding in ((adds, True), (sets, False)):
        for (name, player), (value, _) in table.items():
            old: Any = after[name]
            if player is None:
                after[name] = old + value if adding else value
                continue
            mates = program.mates if program.tracked[name].per_side else 0
            if not mates:
                new = old[player - 1] + value if adding else value
                after[name] = (*old[: player - 1], new, *old[player:])
                continue
            row = list(old)
            for one in side_of(player, len(row), mates):
                row[one - 1] = row[one - 1] + value if adding else value
            after[name] = tuple(row)
    return after


def table_actions(program: Program, fired: Fired, c: Watch) -> tuple[TableAction, ...]:
    """Return what is done on the table, in the order in which it is to be done."""
    if not fired:
        return ()
    spots: dict[int, tuple[Any, CompiledRule]] = {}
    removed, kept, stood = 0, 0, 0
    rerack = restore = False
    for rule, made in fired:
        for d in made:
            if d[0] == "spot":
                _add_spots(spots, d, rule)
            elif d[0] == "remove":
                removed |= d[1]
            elif d[0] == "set up":
                stood |= d[1]
            elif d[0] == "rerack":
                rerack, kept = True, kept | d[1]
            elif d[0] == "restore":
                restore = True
    if restore:
        return (Restore(),)
    names = program.names
    actions: list[TableAction] = [Remove(names[bit]) for bit in singles(removed)]
    actions.extend(
        Spot(names[bit], _places(program, names[bit], spots[bit][0], c))
        for bit in _in_order(program, spots, c)
        if not rerack or bit & kept
    )
    if stood:
        actions.append(SetUp(tuple(names[bit] for bit in singles(stood))))
    if rerack:
        actions.append(Rerack(tuple(names[bit] for bit in singles(kept))))
    return tuple(actions)


def _add_spots(spots: dict[int, Any], decision: tuple[Any, ...], rule: CompiledRule) -> None:
    _, balls, places = decision
    for bit in singles(balls):
        if bit in spots and spots[bit][0] != places:
            raise RuleClash("spot of a ball", spots[bit][1], rule)
        spots[bit] = (places, rule)


def _in_order(program: Program, spots: dict[int, Any], c: Watch) -> list[int]:
    """Return the balls to spot: by the script's sets, or own spot free, then value or name."""
    if len(spots) < 2:
        return list(spots)
    if program.spotting_sets:
        sets = [run(c) for run in program.spotting_sets]
        return sorted(spots, key=lambda bit: (_first_of(sets, bit), bit))
    covered = c.shot.rest.spots if c.shot is not None else {}
    sign = {"highest": -1, "lowest": 1}.get(program.spotting, 0)

    def rank(bit: int) -> tuple[bool, int, int]:
        home = _own_spot(program, program.names[bit], c)
        return (home in covered, sign * program.values.get(bit, 0), bit)

    return sorted(spots, key=rank)


def _first_of(sets: list[int], bit: int) -> int:
    return next((number for number, one in enumerate(sets) if one & bit), len(sets))


def _own_spot(program: Program, ball: str, c: Watch) -> str | None:
    if ball in c.homes:
        return c.homes[ball]
    return next((b.spot for b in program.vocabulary.balls if b.name == ball), None)


def _places(program: Program, ball: str, written: Any, c: Watch) -> tuple[Place, ...]:
    own = _own_spot(program, ball, c) or next(iter(program.vocabulary.spots), None)
    made = []
    for kind, spot, toward in written:
        match kind:
            case "own" | "home":
                made.append(Place("at", own))
            case "near-own":
                made.append(Place("near", own, toward))
            case "near":
                made.append(Place("near", spot, toward))
            case _:
                made.append(Place(kind, spot))
    return tuple(made)
