"""What a record expects against what the referee said.

One idea: only the keys present are compared, each in its own way; a difference is a value that
names the key, what was expected and what was got.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot
from typing import TYPE_CHECKING

from engine.records.say import SAYINGS, in_hand_of, points_of, spotted_of, state_of

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from engine.game.situation import Situation
    from engine.game.verdict import Spotted, Verdict
    from engine.records.spec import ExpectSpec
    from engine.table.furniture import BallId

WITHIN = 1e-3
"""Positions agree within a millimetre."""


@dataclass(frozen=True, slots=True)
class Difference:
    """One key of one shot (from 1) that came out otherwise."""

    shot: int
    key: str
    expected: object
    got: object

    def __str__(self) -> str:
        return f"shot {self.shot}: {self.key}: expected {self.expected!r}, got {self.got!r}"


def compare(
    number: int, expect: ExpectSpec, verdict: Verdict, before: Situation
) -> Iterator[Difference]:
    """Yield every difference between what is expected and the verdict of shot `number`."""
    for key in sorted(expect.model_fields_set, key=list(type(expect).model_fields).index):
        expected = getattr(expect, key)
        if expected is None:
            continue
        got = _got(key, expected, verdict, before)
        if not _agree(key, expected, got, verdict):
            yield Difference(number, key, expected, got)


def _got(key: str, expected: object, verdict: Verdict, before: Situation) -> object:
    match key:
        case "fouls" | "options" | "next" | "phase" | "over" | "winner" | "rerack":
            return SAYINGS[key](verdict)
        case "points":
            return points_of(verdict, before)
        case "spotted" | "spotted_in_order":
            return [spotted_of(one) for one in verdict.spotted]
        case "in_hand":
            return in_hand_of(verdict)
        case "positions":
            wanted: Mapping[BallId, object] = expected  # type: ignore[assignment]
            lying = verdict.after.rest.positions
            return {ball: list(lying[ball]) if ball in lying else None for ball in wanted}
        case _:
            names: Mapping[str, object] = expected  # type: ignore[assignment]
            return state_of(verdict, names)


def _agree(key: str, expected: object, got: object, verdict: Verdict) -> bool:
    match key, expected:
        case (("fouls" | "options"), list()):
            return isinstance(got, list) and set(expected) == set(got)
        case "spotted", list():
            return _same_set(expected, list(verdict.spotted))
        case "spotted_in_order", list():
            return len(expected) == len(verdict.spotted) and all(
                _fits(text, one) for text, one in zip(expected, verdict.spotted, strict=True)
            )
        case "positions", dict():
            return all(_near(at, got[ball]) for ball, at in expected.items())  # type: ignore[index]
        case _:
            return _same(expected, got)


def _same(expected: object, got: object) -> bool:
    """Tell whether two values are equal and of one kind: 1 is not true."""
    if isinstance(expected, dict) and isinstance(got, dict):
        return expected.keys() == got.keys() and all(
            _same(value, got[name]) for name, value in expected.items()
        )
    if isinstance(expected, list) and isinstance(got, list):
        return len(expected) == len(got) and all(map(_same, expected, got))
    return type(expected) is type(got) and expected == got


def _same_set(expected: list[str], got: list[Spotted]) -> bool:
    left = list(got)
    for text in sorted(expected, key=len, reverse=True):
        fit = next((one for one in left if _fits(text, one)), None)
        if fit is None:
            return False
        left.remove(fit)
    return not left


def _fits(text: str, spotted: Spotted) -> bool:
    return text in {spotted.ball, spotted_of(spotted)}


def _near(expected: list[float], got: list[float] | None) -> bool:
    if got is None:
        return False
    return hypot(expected[0] - got[0], expected[1] - got[1]) <= WITHIN
