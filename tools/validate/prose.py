"""Numbers that stand in words: `phi=30`, `R=30.75 mm`, `h=7R/5`, `1 m/s`, `rolling`.

One idea: the names of quantities carry inputs, and so does some prose; what can be read by these
few patterns is read, everything else is asked of the check's fields. Invariant: a field of the
check goes before its prose.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from tools.validate.check import NotApplicableError

if TYPE_CHECKING:
    from tools.validate.check import Check, Wanted

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?"
COUNTS = {"one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "seven": 7}


def told(wanted: Wanted, name: str) -> float | None:
    """Return the number that a quantity's name gives as `name=number`, None where it does not."""
    found = re.search(rf"(?<![\w/|]){re.escape(name)} ?= ?({NUMBER})", wanted.quantity)
    return float(found[1]) if found else None


def need(check: Check, wanted: Wanted, *names: str) -> float:
    """Return an input from the quantity's name or else from the check's fields."""
    for name in names:
        value = told(wanted, name)
        if value is not None:
            return value
    return check.number(*names)


def need_or(check: Check, wanted: Wanted, name: str, usual: float) -> float:
    """Return an input as `need` does, or the usual one where neither gives it."""
    value = told(wanted, name)
    return check.number(name, default=usual) if value is None else value


def spoken(check: Check, name: str, pattern: str) -> float:
    """Return a field, or else the number that the check's words give by a pattern."""
    if check.has(name):
        return check.number(name)
    found = re.search(pattern.replace("#", f"({NUMBER})"), check.words)
    if not found:
        raise NotApplicableError(f"input only in prose: {name}")
    return float(found[1])


def count(check: Check, name: str, pattern: str) -> int:
    """Return a field that counts, or else the count that the words give, in digits or letters."""
    if check.has(name):
        return int(check.number(name))
    found = re.search(pattern, check.words, re.IGNORECASE)
    if not found:
        raise NotApplicableError(f"input only in prose: {name}")
    return COUNTS.get(found[1].lower()) or int(float(found[1]))


def motion_of(check: Check, wanted: Wanted | None = None) -> str:
    """Return `stun` or `roll`: the field `motion`, else the quantity's or the check's words."""
    if check.has("motion"):
        return check.text("motion")
    for text in (wanted.quantity if wanted else "", check.description):
        found = re.search(r"\b(stun|natural-roll|roll(?:ing|s)?)\b", text, re.IGNORECASE)
        if found:
            return "stun" if found[1].lower() == "stun" else "roll"
    raise NotApplicableError("input only in prose: motion")


def length_told(text: str, name: str, radius: float | None) -> float | None:
    """Return a length (m) such as `h=37 mm`, `h=7R/5`, `h=1.4R`, `h=0.635D`, `R=30.75 mm`."""
    found = re.search(rf"\b{name} ?= ?({NUMBER}) ?(mm|D|R(?:/({NUMBER}))?|m\b)", text)
    if not found:
        return None
    size, unit = float(found[1]), found[2]
    if unit.startswith("R") or unit == "D":
        if radius is None:
            return None
        return size * radius * (2.0 if unit == "D" else 1.0) / float(found[3] or 1.0)
    return size / 1000.0 if unit == "mm" else size
