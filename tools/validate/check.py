"""Checks as a file tells them, and what came of each.

One idea: a check is inputs (`parameters`) and quantities with a tolerance; each quantity is
answered by itself, and the check's status is made from its quantities. Invariant: an answer is
compared with the tolerance of the file alone.
"""

from __future__ import annotations

import json
import re
from dataclasses import dataclass, field, replace
from math import floor, isfinite, log10
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

PASS, FAIL, DIFFERS, NOT_APPLICABLE = "pass", "fail", "differs", "not-applicable"
"""What may come of a quantity; `differs` is a measured one that the simulator misses."""


class NotApplicableError(Exception):
    """A quantity that this simulator cannot answer, with the reason.

    `got` is what it gives all the same, where a check is for another model.
    """

    def __init__(self, reason: str, got: object = None) -> None:
        super().__init__(reason)
        self.got = got


class CheckFileError(ValueError):
    """A file that is not one of checks."""


SPEEDS = re.compile(r"slow/medium/fast ([\d.]+)/[\d.]+/([\d.]+) m/s")


@dataclass(frozen=True, slots=True)
class Wanted:
    """One quantity with the value expected and its tolerance (`abs`, `rel` or `none`)."""

    quantity: str
    value: object
    tol: float
    mode: str
    unit: str = ""


@dataclass(frozen=True, slots=True)
class Check:
    """One check of a file; `words` are its description and notes, `laws` what the file names."""

    id: str
    group: str
    kind: str
    description: str
    words: str
    parameters: Mapping[str, object]
    wanted: tuple[Wanted, ...]
    laws: Mapping[str, object] = field(default_factory=dict)
    formula: str = ""

    def has(self, name: str) -> bool:
        """Say whether the check gives a parameter."""
        return name in self.parameters

    def number(self, *names: str, default: float | None = None) -> float:
        """Return the first of these parameters as a number; raises where there is none."""
        for name in names:
            value = self.parameters.get(name)
            if value is not None and not isinstance(value, (list, dict)):
                return float(str(value))
        if default is None:
            raise NotApplicableError(f"input only in prose: {' or '.join(names)}")
        return default

    def numbers(self, name: str) -> tuple[float, ...]:
        """Return a parameter that is a list of numbers; raises where there is none."""
        value = self.parameters.get(name)
        if not isinstance(value, list):
            raise NotApplicableError(f"input only in prose: {name}")
        return tuple(map(float, value))

    def text(self, name: str, default: str | None = None) -> str:
        """Return a parameter as text; raises where there is none."""
        value = self.parameters.get(name, default)
        if value is None:
            raise NotApplicableError(f"input only in prose: {name}")
        return str(value)


@dataclass(frozen=True, slots=True)
class Answer:
    """What came of one quantity; `off` is how far it lies from the value, in its tolerance."""

    wanted: Wanted
    status: str
    got: object = None
    reason: str = ""
    off: float = 0.0


@dataclass(frozen=True, slots=True)
class Result:
    """What came of one check."""

    check: Check
    answers: tuple[Answer, ...]

    @property
    def status(self) -> str:
        """Return `fail` where any quantity fails, else `differs`, else `pass`, if there is one."""
        seen = {answer.status for answer in self.answers}
        return next((one for one in (FAIL, DIFFERS, PASS) if one in seen), NOT_APPLICABLE)

    @property
    def reasons(self) -> tuple[str, ...]:
        """Return why quantities are not applicable or by how much they differ, each once."""
        return tuple(dict.fromkeys(one.reason for one in self.answers if one.reason))


def read_checks(path: Path) -> tuple[Check, ...]:
    """Return the checks of a file; raises CheckFileError for what is none."""
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        raw = data["checks"]
        laws = _laws(raw)
        return tuple(_read(one, laws) for one in raw)
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise CheckFileError(f"{path}: not a file of checks: {error}") from error


def _read(raw: Mapping[str, object], laws: Mapping[str, object]) -> Check:
    expected = raw["expected"]
    if not isinstance(expected, list):
        raise TypeError("`expected` is a list of quantities")
    wanted = tuple(
        Wanted(
            str(one["quantity"]),
            one["value"],
            float(one.get("tol") or 0.0),
            str(one.get("tol_mode", "abs")),
            str(one.get("unit", "")),
        )
        for one in expected
    )
    parameters = raw.get("parameters") or {}
    if not isinstance(parameters, dict):
        raise TypeError("`parameters` is a table")
    description = str(raw.get("description", ""))
    words = f"{description} {raw.get('notes', '')}"
    group = str(raw.get("group", raw["id"]))
    kind, formula = str(raw.get("kind", "")), str(raw.get("formula", ""))
    return Check(str(raw["id"]), group, kind, description, words, parameters, wanted, laws, formula)


def _laws(raw: list[Mapping[str, object]]) -> dict[str, object]:
    """Return what some check defines for others: the friction law, and slow and fast speeds."""
    laws: dict[str, object] = {}
    for one in raw:
        given = one.get("parameters") or {}
        if isinstance(given, dict) and given.keys() >= {"a", "b", "c"}:
            laws |= {name: given[name] for name in ("a", "b", "c")}
        speeds = SPEEDS.search(str(one.get("description", "")))
        if speeds:
            laws |= {"v_slow": float(speeds[1]), "v_fast": float(speeds[2])}
    return laws


def compare(wanted: Wanted, got: object) -> Answer:
    """Return whether an answer lies within the tolerance of what is wanted."""
    off = _off(wanted.value, got, wanted)
    status = PASS if off <= 1.0 else FAIL
    return Answer(wanted, status, got, off=off)


def allow(answer: Answer) -> Answer:
    """Return what a measured quantity's answer counts as: it may differ, and says by how much."""
    value, got = answer.wanted.value, answer.got
    values = value if isinstance(value, list) else [value]
    gots = got if isinstance(got, list) else [got]
    shares = [_share(*pair) for pair in zip(values, gots, strict=False)]
    if answer.status != FAIL or len(values) != len(gots) or None in shares:
        return answer
    worst = max((share for share in shares if share is not None), key=abs)
    reason = f"{answer.wanted.quantity} by {worst:+.1f} %"
    return replace(answer, status=DIFFERS, reason=reason)


def _share(value: object, got: object) -> float | None:
    """Return by how many per cent an answer is off, None where that cannot be said."""
    if not isinstance(value, (int, float)) or not isinstance(got, (int, float)):
        return None
    return 100.0 * (got - value) / abs(value) if value != 0.0 and isfinite(got) else None


def _rounding(value: float) -> float:
    """Return half a unit of the twelfth digit: files give figures with no more than twelve."""
    if isinstance(value, int) or value == 0.0:
        return 0.0
    return 0.5 * 10.0 ** (floor(log10(abs(value))) - 11)


def _off(value: object, got: object, wanted: Wanted) -> float:
    """Return the worst distance of all numbers, in tolerances; infinity where shapes differ."""
    if isinstance(value, (list, tuple)):
        if not isinstance(got, (list, tuple)) or len(got) != len(value):
            return float("inf")
        pairs = zip(value, got, strict=True)
        return max((_off(one, other, wanted) for one, other in pairs), default=0.0)
    if isinstance(value, (int, float)) and isinstance(got, (int, float)):
        if isinstance(value, bool) or isinstance(got, bool) or not isfinite(got):
            return 0.0 if value == got else float("inf")
        limit = wanted.tol * (abs(value) if wanted.mode == "rel" else 1.0) + _rounding(value)
        distance = abs(got - value)
        if distance == 0.0:
            return 0.0
        return distance / limit if limit > 0.0 else float("inf")
    return 0.0 if value == got else float("inf")
