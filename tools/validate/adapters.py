"""Which adapter answers which kind of check.

One idea: a group's letter chooses a table of patterns, a quantity's name chooses the row, and the
row's function reads the rest from the check's fields. Invariant: no check is known by its id.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from engine.physics.simulate import EventStormError
from tools.validate import (
    balls,
    cloth,
    cluster,
    cue,
    cushion,
    flight,
    measured,
    scene,
    space,
)
from tools.validate.check import (
    FAIL,
    NOT_APPLICABLE,
    Answer,
    Check,
    NotApplicableError,
    Result,
    Wanted,
    allow,
    compare,
)

if TYPE_CHECKING:
    from collections.abc import Callable

    Kinds = tuple[tuple[str, Callable[[Check, Wanted], object]], ...]


def _kinds(check: Check) -> Kinds:
    """Return the patterns for a check's group, by the fields it carries."""
    letter = check.group[:1].upper()
    if letter == "K" or (check.kind == "measured" and letter == "E"):
        return measured.KINDS
    if letter == "B" and check.has("v_max"):
        return space.KINDS
    if letter == "F" and check.has("theta_deg"):
        return cue.RAISED
    if letter == "C" and flight.is_spatial(check):
        return flight.MEETINGS
    return {
        "A": cloth.KINDS,
        "B": balls.KINDS,
        "C": balls.KINDS,
        "D": balls.KINDS,
        "E": cushion.KINDS,
        "F": cue.KINDS,
        "G": flight.KINDS,
        "H": scene.KINDS,
        "I": scene.KINDS,
        "J": (*cluster.KINDS, *balls.KINDS),
    }.get(letter, ())


def run_check(check: Check) -> Result:
    """Return what the simulator makes of a check."""
    return Result(check, tuple(_answer(check, wanted) for wanted in check.wanted))


def _answer(check: Check, wanted: Wanted) -> Answer:
    for pattern, ask in _kinds(check):
        if re.fullmatch(pattern, wanted.quantity):
            return _asked(check, wanted, ask)
    return Answer(wanted, NOT_APPLICABLE, reason="no adapter for this kind of quantity")


def _asked(check: Check, wanted: Wanted, ask: Callable[[Check, Wanted], object]) -> Answer:
    try:
        answer = compare(wanted, ask(check, wanted))
        return allow(answer) if check.kind == "measured" else answer
    except NotApplicableError as reason:
        return Answer(wanted, NOT_APPLICABLE, got=reason.got, reason=str(reason))
    except (ValueError, LookupError, StopIteration, EventStormError) as error:
        told = f"{type(error).__name__}: {error}"
        return Answer(wanted, FAIL, got=told, off=float("inf"))
