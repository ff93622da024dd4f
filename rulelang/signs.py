"""What must be the case for a condition to hold, as bits that are known before it is asked.

One idea: a shot is summed up in one number, a bit for each verb that happened, for each that the
cue ball did, for whether the shot is legal; a rule whose condition cannot hold with these bits is
passed over without asking it. Invariant: signs never rule out what could hold.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rulelang.account import VERBS
from rulelang.frozen import value

if TYPE_CHECKING:
    from collections.abc import Sequence

CUE = VERBS
"""The bit of what the cue ball did is the verb's, so many places higher."""
LEGAL, FOUL, PLACED = (1 << 2 * VERBS + n for n in range(3))
"""The shot is legal, the shot is foul, it is known where the ball in hand was put."""


@value
class Signs:
    """The bits that must `all` be there, of which `none` may, of which `any` must where there are.

    `exact` is the one bit that says the same as the condition, 0 where there is none. `phases`
    are the phases in which it can hold, None for all.
    """

    all: int = 0
    none: int = 0
    any: int = 0
    exact: int = 0
    phases: frozenset[str] | None = None


UNKNOWN = Signs()


def exactly(bit: int) -> Signs:
    """Return the signs of what holds just when a bit is there."""
    return Signs(bit, 0, 0, bit)


def opposite(signs: Signs) -> Signs:
    """Return the signs of what holds where a condition does not."""
    return Signs(none=signs.exact)


def of_all(parts: Sequence[Signs]) -> Signs:
    """Return the signs of conditions joined by `and`."""
    there = missing = 0
    for part in parts:
        there |= part.all
        missing |= part.none
    phases = [part.phases for part in parts if part.phases is not None]
    return Signs(
        there,
        missing,
        next((part.any for part in parts if part.any), 0),
        phases=frozenset.intersection(*phases) if phases else None,
    )


def of_any(parts: Sequence[Signs]) -> Signs:
    """Return the signs of conditions joined by `or`."""
    bits = [part.any or part.all & -part.all for part in parts]
    some = 0
    for bit in bits:
        some |= bit
    phases = [part.phases for part in parts if part.phases is not None]
    return Signs(
        any=some if all(bits) else 0,
        phases=frozenset.union(*phases) if len(phases) == len(parts) else None,
    )
