"""One shot as the rules look at it: what happened, what lies where, what is decided so far.

One idea: every ball and pin is one bit, so a set is an int and a question about a set is one
operation. Invariant: what the rules are shown of a shot does not change while they are asked.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang.account import (
    ENTERED,
    FELL,
    LEANED,
    LEFT_TABLE,
    LEFT_ZONE,
    OMITTED,
    OUTSIDE,
    POCKETED,
    account_of,
)
from rulelang.signs import FOUL, LEGAL, PLACED

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from rulelang.decisions import TableAction
    from rulelang.facts import Call, Shot, Situation
    from rulelang.vocabulary import Tracked

BEGIN = -1
END = 1 << 30


FUEL = 20_000
"""How many turns of loops one judgement may take."""


class OutOfFuel(Exception):  # noqa: N818 - it names what happened, as the other stops do
    """A script loops longer than any referee would."""


class Nobody(Exception):  # noqa: N818 - it names what is the case
    """A rule speaks of the winner where nobody has won."""


_NOTHING = account_of({"": 0}, "", frozenset(), (), 0.0)


class Watch:
    """What the rules of one judgement read; the evaluator moves it from section to section."""

    __slots__ = (
        "actions",
        "balls",
        "bits",
        "call",
        "chooser",
        "chosen",
        "continues",
        "cue",
        "cue_hits",
        "ev",
        "facts",
        "fouls",
        "fuel",
        "homes",
        "it",
        "legal",
        "mates",
        "memo",
        "names",
        "next_phase",
        "next_player",
        "objects",
        "on_after",
        "on_before",
        "passing",
        "phase",
        "player",
        "players",
        "scores",
        "seen",
        "shooter",
        "shot",
        "situation",
        "stage",
        "state",
        "stroke",
        "up_after",
        "up_before",
        "values",
        "winner",
    )  # fmt: skip

    def __init__(
        self, bits: Mapping[str, int], names: Mapping[int, str], balls: int, situation: Situation
    ) -> None:
        self.bits = bits
        self.names = names
        self.balls = balls
        self.situation = situation
        self.players = situation.players
        self.shooter = situation.shooter
        self.phase = situation.phase
        self.state: Mapping[str, Tracked] = situation.state
        self.scores: tuple[int, ...] = situation.scores
        self.values: Mapping[int, int] = {}
        self.stage = 0
        self.fouls: tuple[Any, ...] = ()
        self.legal = True
        self.next_phase = situation.phase
        self.next_player = situation.shooter
        self.continues = False
        self.chooser = situation.shooter
        self.chosen = 0
        self.actions: tuple[TableAction, ...] = ()
        self.homes: Mapping[str, str] = {}
        self.it = 0
        self.player = situation.shooter
        self.winner = situation.winner
        self.mates = 0
        self.memo: list[Any] = []
        self.passing: list[Any] = []
        self.shot: Shot | None = None
        self.call: Call | None = None
        self.cue = 0
        self.objects = balls
        mask = 0
        for name in situation.on_table:
            mask |= bits[name]
        self.on_before = mask
        self.on_after = mask
        standing = ~balls & (1 << len(bits)) - 1
        for name in situation.fallen:
            standing &= ~bits[name]
        self.up_before = self.up_after = standing
        self.ev, self.seen = _NOTHING.ev, _NOTHING.seen
        self.cue_hits: list[tuple[int, int]] = []
        self.stroke = True
        self.facts = LEGAL
        self.fuel = FUEL

    def rule_on(self, fouls: tuple[Any, ...]) -> None:
        """Take note of which fouls were found: without any the shot is legal."""
        self.fouls, self.legal = fouls, not fouls
        self.facts = self.facts & ~(LEGAL | FOUL) | (FOUL if fouls else LEGAL)

    def burn(self) -> None:
        """Count one turn of a loop; raises OutOfFuel when there were too many."""
        self.fuel -= 1
        if self.fuel < 0:
            raise OutOfFuel(f"more than {FUEL} turns of loops in one judgement")

    def show(self, shot: Shot, delay: float) -> None:
        """Index the events of `shot`; balls settling within `delay` s count as pocketed."""
        bits = self.bits
        self.shot = shot
        self.call = shot.call
        self.cue = bits[shot.struck]
        self.objects = self.balls & ~self.cue
        account = shot.account or account_of(
            bits, shot.struck, self.situation.frozen, shot.events, delay
        )
        self.ev, self.seen = account.ev, account.seen
        self.cue_hits = account.cue_hits
        self.facts = account.happened | LEGAL
        if shot.placed is not None:
            self.facts |= PLACED
        seen = self.seen
        self.on_after = self.on_before & ~(seen[POCKETED] | seen[LEFT_TABLE])
        self.up_after = self.up_before & ~(seen[FELL] | seen[LEANED])
        self.stroke = not seen[OMITTED]


def lie_in(watch: Watch, zone: str, *, start: bool) -> int:
    """Return the mask of balls that lie in `zone`, at the start of the shot or at rest."""
    zones = watch.situation.zones
    shot = watch.shot
    rest = None if start or shot is None else shot.rest.zones
    mask = 0
    for name, where in zones.items():
        if zone in where:
            mask |= watch.bits[name]
    if rest is None:
        return mask
    moves = sorted(
        [(n, b, True) for n, b, z in watch.ev[ENTERED] if z == zone]
        + [(n, b, False) for n, b, z in watch.ev[LEFT_ZONE] if z == zone]
    )
    for _, ball, inside in moves:
        mask = mask | ball if inside else mask & ~ball
    for name, where in rest.items():
        bit = watch.bits[name]
        mask = mask | bit if zone in where else mask & ~bit
    return mask & watch.on_after


def together(watch: Watch, balls: int, zones: tuple[str, ...], *, start: bool) -> int:
    """Return `balls` if all of them lie in one and the same of `zones`, else nothing."""
    for zone in zones:
        if not balls & ~lie_in(watch, zone, start=start):
            return balls
    return 0


def stayed_together(watch: Watch, balls: int, zones: tuple[str, ...]) -> int:
    """Return `balls` if all began in one and the same of `zones` and none left it, else nothing.

    A ball that left the bed, if only to come back, has left its zone.
    """
    if balls & (watch.seen[LEFT_TABLE] | watch.seen[OUTSIDE] | watch.seen[POCKETED]):
        return 0
    for zone in zones:
        left = sum({ball for _, ball, place in watch.ev[LEFT_ZONE] if place == zone})
        if not balls & (left | ~lie_in(watch, zone, start=True)):
            return balls
    return 0


def touching(watch: Watch, whom: Callable[[Watch], int], *, start: bool) -> int:
    """Return the mask of balls frozen to any of some others, at the start or at rest."""
    shot = watch.shot
    pairs = watch.situation.frozen if start or shot is None else shot.rest.frozen
    if not pairs:
        return 0
    mask, balls = 0, whom(watch)
    for a, b in pairs:
        if b.startswith("cushion "):
            continue
        one, other = watch.bits[a], watch.bits[b]
        if one & balls:
            mask |= other
        if other & balls:
            mask |= one
    return mask


def at_cushion(watch: Watch, cushion: str | None, *, start: bool) -> int:
    """Return the mask of balls frozen to `cushion`, or to any where it is None."""
    shot = watch.shot
    pairs = watch.situation.frozen if start or shot is None else shot.rest.frozen
    mask = 0
    for a, b in pairs:
        if b == f"cushion {cushion}" or (cushion is None and b.startswith("cushion ")):
            mask |= watch.bits[a]
    return mask
