"""What happened in one shot, sorted once: which verbs, who did them and to whom.

One idea: events are gone through a single time; whoever asks afterwards, the rules or the host,
asks the account. Every ball and pin is one bit, so a set of them is an int.
Invariant: `ev[VERB]` holds (event number, who, whom) in the order of the events.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rulelang import events as e

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from collections.abc import Set as AbstractSet

(
    HIT, CUSHION, PRESSED_CUSHION, JAW, RAIL, OUTSIDE, POCKETED, REBOUNDED, SETTLED, LEFT_TABLE,
    LEFT_CUSHION, CROSSED, ENTERED, LEFT_ZONE, JUMPED, TOPPLED, FELL, PIN_TOUCHED, LEANED,
    TIP_AGAIN, TIP_FOLLOWED, PLAYER_TOUCHED, HIT_POCKETED, PRESSED, FOOT, TOO_SOON, OMITTED, TIME,
) = range(28)  # fmt: skip
VERBS = 28

Row = tuple[int, int, Any]
Pair = tuple[str, str]
Handler = Callable[["Account", int, Any], Any]


class Account:
    """The events of a shot by what happened.

    `seen[VERB]` are the balls and pins that did it; `happened` has a bit for each verb that
    somebody did, and `VERBS` places higher one for each that the cue ball did. `cue_hits` are
    (event number, balls) of the cue ball's own hits. `down` are the balls that are off the bed
    when all is still, `named` the balls that some event names. The rest is for the making: `gone`
    are the balls in pockets, `moved` those that touched a nose, `struck` those of all hits,
    `cushioned` those of all cushions; `freed` has the balls, or their contacts, that are frozen
    to a cushion no more.
    """

    __slots__ = (
        "bits", "cue", "cue_hits", "cushioned", "delay", "down", "ev", "freed", "frozen", "gone",
        "happened", "moved", "named", "seen", "struck",
    )  # fmt: skip

    def __init__(
        self, bits: Mapping[str, int], cue: int, frozen: AbstractSet[Pair], delay: float
    ) -> None:
        self.bits = bits
        self.cue = cue
        self.frozen = frozen or None
        self.delay = delay
        self.ev: list[list[Row]] = [[] for _ in range(VERBS)]
        self.seen = [0] * VERBS
        self.cue_hits: list[tuple[int, int]] = []
        self.happened = 0
        self.down = 0
        self.named = 0
        self.gone = 0
        self.moved = 0
        self.struck = 0
        self.cushioned = 0
        self.freed: set[str | Pair] = set()


def account_of(
    bits: Mapping[str, int],
    struck: str,
    frozen: AbstractSet[Pair],
    events: Sequence[e.Event],
    delay: float,
) -> Account:
    """Return the account of a shot; balls settling within `delay` s count as pocketed.

    `struck` is the ball that the tip struck, `frozen` who touched whom before the stroke.
    """
    x = Account(bits, bits[struck], frozen, delay)
    hits, cushions, cue, struck_ones, cushioned = x.ev[HIT], x.ev[CUSHION], x.cue, 0, 0
    event: Any
    for number, event in enumerate(events):
        kind = type(event)
        if kind is e.BallsHit:
            ball, others = bits[event.ball], 0
            for name in event.others:
                others |= bits[name]
            both = ball | others
            if both & x.gone:
                _hit_pocketed(x, number, both)
                continue
            hits.append((number, ball, others))
            hits.append((number, others, ball))
            if both & cue:
                x.cue_hits.append((number, others if ball == cue else ball))
            if x.frozen is not None and not ball & (x.moved | struck_ones):
                _press(x, x.frozen, number, event)
            struck_ones |= both
        elif kind is e.CushionHit:
            ball = bits[event.ball]
            x.moved |= ball
            if x.frozen is not None and _is_pressed(x, x.frozen, event):
                x.ev[PRESSED_CUSHION].append((number, ball, event.cushion))
                continue
            cushioned |= ball
            cushions.append((number, ball, event.cushion))
        else:
            _HANDLERS[kind](x, number, event)
    x.struck, x.cushioned = struck_ones, cushioned
    _sum_up(x)
    return x


def _sum_up(x: Account) -> None:
    """Tell for each verb whether it happened, and who did it."""
    ev, seen, happened = x.ev, x.seen, 0
    others = ev[RAIL]
    ev[RAIL] = sorted([*ev[CUSHION], *others], key=_number) if others else ev[CUSHION]
    x.named |= x.struck | x.cushioned
    ready = {HIT: x.struck, CUSHION: x.cushioned}
    for verb, rows in enumerate(ev):
        if rows:
            happened |= 1 << verb
            mask = ready.get(verb, 0)
            if not mask:
                for row in rows:
                    mask |= row[1]
            seen[verb] = mask
            if mask & x.cue:
                happened |= 1 << VERBS + verb
    x.happened = happened


def _number(row: Row) -> int:
    return row[0]


def _hit_pocketed(x: Account, number: int, both: int) -> None:
    x.named |= both
    x.ev[HIT_POCKETED].append((number, both & ~x.gone, both))


def _press(x: Account, frozen: AbstractSet[Pair], number: int, event: Any) -> None:
    """Note the balls that a ball lay frozen to before anything moved it, and now drives on."""
    one = event.ball
    for other in event.others:
        if (one, other) in frozen or (other, one) in frozen:
            ball, met = x.bits[one], x.bits[other]
            x.ev[PRESSED] += ((number, ball, met), (number, met, ball))


def _is_pressed(x: Account, frozen: AbstractSet[Pair], event: Any) -> bool:
    """Tell whether a ball is pressed into the cushion that it lies frozen to."""
    if event.ball in x.freed:
        return False
    pair = (event.ball, f"cushion {event.cushion}")
    if pair in frozen and pair not in x.freed:
        return True
    x.freed.add(event.ball)
    return False


def _cushion_left(x: Account, number: int, event: Any) -> None:
    x.freed.add((event.ball, f"cushion {event.cushion}"))
    _row(x, LEFT_CUSHION, number, event, event.cushion)


def _row(x: Account, verb: int, number: int, event: Any, whom: Any) -> int:
    """Add a row on what a ball did, and return the ball."""
    ball = x.bits[event.ball]
    x.named |= ball
    x.ev[verb].append((number, ball, whom))
    return ball


def _jaw_hit(x: Account, number: int, event: Any) -> None:
    x.moved |= _row(x, JAW, number, event, event.pocket)
    _row(x, RAIL, number, event, event.pocket)


def _pocketed(x: Account, number: int, event: Any) -> None:
    ball = _row(x, POCKETED, number, event, event.pocket)
    x.gone |= ball
    x.down |= ball


def _rebounded(x: Account, number: int, event: Any) -> None:
    ball = _row(x, REBOUNDED, number, event, event.pocket)
    _row(x, RAIL, number, event, event.pocket)
    x.gone &= ~ball
    x.down &= ~ball
    x.ev[POCKETED][:] = [row for row in x.ev[POCKETED] if row[1] != ball]


def _settled(x: Account, number: int, event: Any) -> None:
    _row(x, SETTLED, number, event, event.pocket)
    if event.delay <= x.delay:
        _pocketed(x, number, event)


def _left_table(x: Account, number: int, event: Any) -> None:
    x.down |= _row(x, LEFT_TABLE, number, event, None)


def _of(verb: int, field: str) -> Handler:
    return lambda x, number, event: _row(x, verb, number, event, getattr(event, field))


def _alone(verb: int) -> Handler:
    return lambda x, number, event: _row(x, verb, number, event, None)


def _flag(verb: int) -> Handler:
    return lambda x, number, _event: x.ev[verb].append((number, 1, None))


def _jumped(x: Account, number: int, event: Any) -> None:
    other = x.bits[event.other]
    x.named |= other
    _row(x, JUMPED, number, event, other)


def _toppled(x: Account, number: int, event: Any) -> None:
    pin, bodies = x.bits[event.pin], 0
    for name in event.bodies:
        bodies |= x.bits[name]
    x.named |= bodies
    x.ev[TOPPLED].append((number, bodies, pin))
    x.ev[FELL].append((number, pin, bodies))


def _pin_touched(x: Account, number: int, event: Any) -> None:
    body, pin = x.bits[event.body], x.bits[event.pin]
    x.named |= body
    x.ev[PIN_TOUCHED] += ((number, body, pin), (number, pin, body))


def _leaned(x: Account, number: int, event: Any) -> None:
    ball = x.bits[event.ball]
    x.named |= ball
    x.ev[LEANED].append((number, x.bits[event.pin], ball))


_HANDLERS: dict[type, Handler] = {
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
