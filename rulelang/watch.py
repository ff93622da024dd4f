"""One shot as the rules look at it: events sorted by what happened, sets of balls as bit masks.

One idea: every ball and pin is one bit, so a set is an int and a question about a set is one
operation; events are indexed once, and rules ask the index.
Invariant: `ev[VERB]` holds (event number, who, whom) in the order of the events.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang import events as e

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from rulelang.decisions import TableAction
    from rulelang.facts import Call, Shot, Situation
    from rulelang.vocabulary import Tracked

(
    HIT, CUSHION, PRESSED_CUSHION, JAW, RAIL, OUTSIDE, POCKETED, REBOUNDED, SETTLED, LEFT_TABLE,
    LEFT_CUSHION, CROSSED, ENTERED, LEFT_ZONE, JUMPED, TOPPLED, FELL, PIN_TOUCHED, LEANED,
    TIP_AGAIN, TIP_FOLLOWED, PLAYER_TOUCHED, HIT_POCKETED, PRESSED, FOOT, TOO_SOON, OMITTED, TIME,
) = range(28)  # fmt: skip

BEGIN = -1
END = 1 << 30


FUEL = 20_000
"""How many turns of loops one judgement may take."""


class OutOfFuel(Exception):  # noqa: N818 - it names what happened, as the other stops do
    """A script loops longer than any referee would."""


class Nobody(Exception):  # noqa: N818 - it names what is the case
    """A rule speaks of the winner where nobody has won."""


class Watch:
    """What the rules of one judgement read; the evaluator moves it from section to section."""

    __slots__ = (
        "actions", "all_events", "balls", "bits", "call", "chooser", "chosen", "continues", "cue",
        "cue_hits", "ev", "fouls", "fuel", "happened", "homes", "it", "legal", "mates", "memo",
        "names", "next_phase", "next_player", "objects", "on_after", "on_before", "phase",
        "player", "players", "scores", "seen", "shooter", "shot", "situation", "stage", "state",
        "stroke", "up_after", "up_before", "values", "winner",
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
        self.ev: list[list[tuple[int, int, Any]]] = [[] for _ in range(28)]
        self.seen = [0] * 28
        self.cue_hits: list[tuple[int, int]] = []
        self.stroke = True
        self.happened = 0
        self.fuel = FUEL
        self.all_events: tuple[e.Event, ...] = ()

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
        self.all_events = shot.events
        index = _Index(self, delay)
        for number, event in enumerate(shot.events):
            _HANDLERS[type(event)](index, number, event)
        self._sum_up(index)
        seen = self.seen
        self.on_after = self.on_before & ~(seen[POCKETED] | seen[LEFT_TABLE])
        self.up_after = self.up_before & ~(seen[FELL] | seen[LEANED])
        self.stroke = not seen[OMITTED]

    def _sum_up(self, index: _Index) -> None:
        """Tell for each verb whether it happened, and who did it."""
        seen, happened = self.seen, 0
        ready = {HIT: index.struck, CUSHION: index.cushioned}
        if len(index.rails) == len(index.cushions):
            ready[RAIL] = index.cushioned
        for verb, rows in enumerate(self.ev):
            if rows:
                happened |= 1 << verb
                mask = ready.get(verb, 0)
                if not mask:
                    for row in rows:
                        mask |= row[1]
                seen[verb] = mask
        self.happened = happened


class _Index:
    """Sorts events into a watch; remembers what lies frozen and what is gone.

    `struck` are the balls of all hits, `cushioned` those of all cushions, `moved` those that
    touched something else while any ball lay frozen.
    """

    __slots__ = (
        "bits", "cue", "cue_hits", "cushioned", "cushions", "delay", "ev", "gone", "hits", "moved",
        "pairs", "rails", "struck",
    )  # fmt: skip

    def __init__(self, watch: Watch, delay: float) -> None:
        self.ev = watch.ev
        self.hits, self.cushions, self.rails = watch.ev[HIT], watch.ev[CUSHION], watch.ev[RAIL]
        self.cue_hits = watch.cue_hits
        self.bits = watch.bits
        self.cue = watch.cue
        self.delay = delay
        self.gone = 0
        self.moved = 0
        self.struck = 0
        self.cushioned = 0
        self.pairs = set(watch.situation.frozen)
        if self.pairs:
            self.pairs |= {(b, a) for a, b in self.pairs}


def _balls_hit(x: _Index, number: int, event: Any) -> None:
    bits = x.bits
    ball = bits[event.ball]
    others = 0
    for name in event.others:
        others |= bits[name]
    both = ball | others
    if both & x.gone:
        x.ev[HIT_POCKETED].append((number, both & ~x.gone, both))
        return
    x.hits += ((number, ball, others), (number, others, ball))
    if both & x.cue:
        x.cue_hits.append((number, others if ball == x.cue else ball))
    if x.pairs and not ball & (x.moved | x.struck):
        for name in event.others:
            if (event.ball, name) in x.pairs:
                x.ev[PRESSED].append((number, ball, bits[name]))
                x.ev[PRESSED].append((number, bits[name], ball))
    x.struck |= both


def _cushion_hit(x: _Index, number: int, event: Any) -> None:
    ball = x.bits[event.ball]
    row = (number, ball, event.cushion)
    if x.pairs:
        x.moved |= ball
        mine = (event.ball, f"cushion {event.cushion}")
        if mine in x.pairs:
            x.ev[PRESSED_CUSHION].append(row)
            return
        stale = [p for p in x.pairs if p[0] == event.ball and p[1].startswith("cushion ")]
        x.pairs.difference_update(stale)
    x.cushioned |= ball
    x.cushions.append(row)
    x.rails.append(row)


def _cushion_left(x: _Index, number: int, event: Any) -> None:
    x.pairs.discard((event.ball, f"cushion {event.cushion}"))
    x.ev[LEFT_CUSHION].append((number, x.bits[event.ball], event.cushion))


def _jaw_hit(x: _Index, number: int, event: Any) -> None:
    row = (number, x.bits[event.ball], event.pocket)
    x.moved |= row[1]
    x.ev[JAW].append(row)
    x.ev[RAIL].append(row)


def _pocketed(x: _Index, number: int, event: Any) -> None:
    ball = x.bits[event.ball]
    x.gone |= ball
    x.ev[POCKETED].append((number, ball, event.pocket))


def _rebounded(x: _Index, number: int, event: Any) -> None:
    ball = x.bits[event.ball]
    x.gone &= ~ball
    x.ev[POCKETED][:] = [row for row in x.ev[POCKETED] if row[1] != ball]
    x.ev[REBOUNDED].append((number, ball, event.pocket))
    x.ev[RAIL].append((number, ball, event.pocket))


def _settled(x: _Index, number: int, event: Any) -> None:
    ball = x.bits[event.ball]
    x.ev[SETTLED].append((number, ball, event.pocket))
    if event.delay <= x.delay:
        _pocketed(x, number, event)


def _left_table(x: _Index, number: int, event: Any) -> None:
    ball = x.bits[event.ball]
    x.ev[LEFT_TABLE].append((number, ball, None))


def _of(verb: int, field: str) -> Callable[[_Index, int, Any], None]:
    def handle(x: _Index, number: int, event: Any) -> None:
        x.ev[verb].append((number, x.bits[event.ball], getattr(event, field)))

    return handle


def _alone(verb: int) -> Callable[[_Index, int, Any], None]:
    def handle(x: _Index, number: int, event: Any) -> None:
        x.ev[verb].append((number, x.bits[event.ball], None))

    return handle


def _flag(verb: int) -> Callable[[_Index, int, Any], None]:
    def handle(x: _Index, number: int, _event: Any) -> None:
        x.ev[verb].append((number, 1, None))

    return handle


def _jumped(x: _Index, number: int, event: Any) -> None:
    x.ev[JUMPED].append((number, x.bits[event.ball], x.bits[event.other]))


def _toppled(x: _Index, number: int, event: Any) -> None:
    pin, bodies = x.bits[event.pin], 0
    for name in event.bodies:
        bodies |= x.bits[name]
    x.ev[TOPPLED].append((number, bodies, pin))
    x.ev[FELL].append((number, pin, bodies))


def _pin_touched(x: _Index, number: int, event: Any) -> None:
    x.ev[PIN_TOUCHED].append((number, x.bits[event.body], x.bits[event.pin]))
    x.ev[PIN_TOUCHED].append((number, x.bits[event.pin], x.bits[event.body]))


def _leaned(x: _Index, number: int, event: Any) -> None:
    x.ev[LEANED].append((number, x.bits[event.pin], x.bits[event.ball]))


_HANDLERS: dict[type, Callable[[_Index, int, Any], None]] = {
    e.BallsHit: _balls_hit,
    e.CushionHit: _cushion_hit,
    e.CushionLeft: _cushion_left,
    e.JawHit: _jaw_hit,
    e.OutsideHit: _alone(OUTSIDE),
    e.Pocketed: _pocketed,
    e.Rebounded: _rebounded,
    e.Settled: _settled,
    e.LeftTable: _left_table,
    e.LineCrossed: _of(CROSSED, "line"),
    e.ZoneEntered: _of(ENTERED, "zone"),
    e.ZoneLeft: _of(LEFT_ZONE, "zone"),
    e.JumpedOver: _jumped,
    e.PinToppled: _toppled,
    e.PinTouched: _pin_touched,
    e.PinLeaned: _leaned,
    e.TipHitAgain: _alone(TIP_AGAIN),
    e.TipFollowed: _alone(TIP_FOLLOWED),
    e.PlayerTouched: _alone(PLAYER_TOUCHED),
    e.FootLifted: _flag(FOOT),
    e.PlayedTooSoon: _flag(TOO_SOON),
    e.StrokeOmitted: _flag(OMITTED),
    e.TimeCalled: _flag(TIME),
}


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


def touching(watch: Watch, balls: int, *, start: bool) -> int:
    """Return the mask of balls frozen to any of `balls`, at the start or at rest."""
    shot = watch.shot
    pairs = watch.situation.frozen if start or shot is None else shot.rest.frozen
    mask = 0
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
