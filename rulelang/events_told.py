"""Event phrases, compiled: who did what to whom, between two moments.

One idea: a verb is a row in a table, its index in the watch and the way its target is matched;
one function turns rows into closures. Invariant: a closure's answer depends on the watch alone.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rulelang import account as w
from rulelang.frozen import value
from rulelang.watch import BEGIN, END

if TYPE_CHECKING:
    from rulelang.watch import Watch

Match = Callable[["Watch"], Callable[[Any], Any]]
Select = Callable[["Watch", int, int, int], int]
Find = Callable[["Watch", int, int, int], list[int]]

TARGET_VERBS = {
    "hit": w.HIT,
    "pressed": w.PRESSED,
    "jumped over": w.JUMPED,
    "toppled": w.TOPPLED,
    "touched": w.PIN_TOUCHED,
    "leaned on": w.LEANED,
    "hit by": w.HIT,
    "pressed by": w.PRESSED,
    "touched by": w.PIN_TOUCHED,
    "toppled by": w.FELL,
}
PLACE_VERBS = {
    "pocketed": (w.POCKETED, "pocket"),
    "hit jaw": (w.JAW, "pocket"),
    "rebounded": (w.REBOUNDED, "pocket"),
    "settled": (w.SETTLED, "pocket"),
    "hit cushion": (w.CUSHION, "cushion"),
    "pressed cushion": (w.PRESSED_CUSHION, "cushion"),
    "left cushion": (w.LEFT_CUSHION, "cushion"),
    "crossed": (w.CROSSED, "line"),
    "entered": (w.ENTERED, "zone"),
    "left": (w.LEFT_ZONE, "zone"),
}
BARE_VERBS = {
    "hit rail": w.RAIL,
    "hit outside": w.OUTSIDE,
    "hit pocketed ball": w.HIT_POCKETED,
    "left table": w.LEFT_TABLE,
    "fell": w.FELL,
    "touched by player": w.PLAYER_TOUCHED,
}
ALONE = {
    "tip hit again": w.TIP_AGAIN,
    "tip followed": w.TIP_FOLLOWED,
    "player touched": w.PLAYER_TOUCHED,
}
FLAGS = {
    "foot left floor": w.FOOT,
    "stroke was too soon": w.TOO_SOON,
    "stroke was not played": w.OMITTED,
    "time was called": w.TIME,
}
OF_PINS = (w.FELL, w.LEANED, w.TOPPLED, w.PIN_TOUCHED)
"""What pins do, alone or as well as balls."""
TO_BALLS = (w.HIT, w.PRESSED, w.JUMPED)
"""What is done to balls alone, and to others than who does it."""


@value
class Telling:
    """A verb with its target: `select` the balls that did it, `find` the events.

    `verb` must have happened for any ball to be selected; -1 where that does not follow. `whole`:
    whoever did it is selected.
    """

    select: Select
    find: Find
    verb: int = -1
    whole: bool = False


def bare(verb: int) -> Telling:
    """Tell a verb whose target does not matter."""

    def select(c: Watch, who: int, lo: int, hi: int) -> int:
        mask = c.seen[verb] & who
        if not mask or (lo == BEGIN and hi == END):
            return mask
        mask = 0
        for number, a, _ in c.ev[verb]:
            if lo < number < hi:
                mask |= a
        return mask & who

    def find(c: Watch, who: int, lo: int, hi: int) -> list[int]:
        return [n for n, a, _ in c.ev[verb] if a & who and lo < n < hi]

    return Telling(select, find, verb, whole=True)


def matching(verb: int, match: Match) -> Telling:
    """Tell a verb whose target must fit `match`."""

    def select(c: Watch, who: int, lo: int, hi: int) -> int:
        if not c.seen[verb] & who:
            return 0
        fits = match(c)
        mask = 0
        for number, a, b in c.ev[verb]:
            if a & who and lo < number < hi and fits(b):
                mask |= a
        return mask & who

    def find(c: Watch, who: int, lo: int, hi: int) -> list[int]:
        fits = match(c)
        return [n for n, a, b in c.ev[verb] if a & who and lo < n < hi and fits(b)]

    return Telling(select, find, verb)


def on_balls(verb: int, balls: Callable[[Watch], int], *, whole: bool) -> Telling:
    """Tell a verb done to any of a set of balls; `whole` where it cannot be done to others."""

    def select(c: Watch, who: int, lo: int, hi: int) -> int:
        if not c.seen[verb] & who:
            return 0
        target = balls(c)
        if verb == w.HIT and who == c.cue:
            met = (b for number, b in c.cue_hits if lo < number < hi)
            return who if any(b & target for b in met) else 0
        mask = 0
        for number, a, b in c.ev[verb]:
            if b & target and a & who and lo < number < hi:
                mask |= a
        return mask & who

    def find(c: Watch, who: int, lo: int, hi: int) -> list[int]:
        target = balls(c)
        return [n for n, a, b in c.ev[verb] if a & who and b & target and lo < n < hi]

    return Telling(select, find, verb, whole=whole)


def counted(verb: int, how: str, count: int, balls: Callable[[Watch], int] | None) -> Telling:
    """Tell a verb done so many times (cushions), or to so many different balls."""

    def per_ball(c: Watch, one: int, lo: int, hi: int) -> bool:
        rows = [(n, b) for n, a, b in c.ev[verb] if a & one and lo < n < hi]
        if balls is None:
            return fits(how, len(rows), count, None)
        target, reached = balls(c), 0
        for _, b in rows:
            reached |= b
        return fits(how, (reached & target).bit_count(), count, target.bit_count())

    def select(c: Watch, who: int, lo: int, hi: int) -> int:
        mask, rest = 0, who
        while rest:
            one = rest & -rest
            rest ^= one
            if per_ball(c, one, lo, hi):
                mask |= one
        return mask

    def find(c: Watch, who: int, lo: int, hi: int) -> list[int]:
        target = END if balls is None else balls(c)
        found = [
            n for n, a, b in c.ev[verb] if a & who and lo < n < hi and (balls is None or b & target)
        ]
        return found[count - 1 :] if how == "at least" and count else found

    happens = how == "more than" or (how in ("at least", "exactly") and count > 0)
    return Telling(select, find, verb if happens else -1)


def fits(how: str, number: int, count: int, whole: int | None) -> bool:
    """Return whether `number` fits a quantifier; `whole` is the size of the whole set."""
    match how:
        case "any":
            return number > 0
        case "no":
            return number == 0
        case "every":
            return number == whole
        case "at least":
            return number >= count
        case "at most":
            return number <= count
        case "more than":
            return number > count
        case "fewer than":
            return number < count
        case _:
            return number == count


def fits_set(how: str, number: int, hit: int, whole: int) -> bool:
    """Return whether the balls `hit` of the set `whole` fit a quantifier."""
    if how == "any":
        return hit != 0
    if how == "no":
        return hit == 0
    if how == "every":
        return hit == whole
    return fits(how, hit.bit_count(), number, whole.bit_count())
