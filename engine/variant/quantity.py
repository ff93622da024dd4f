"""Lengths, masses and angles as people write them: "2.84 m", "11 ft 8 1/2 in", "-L/4".

One idea: one small grammar serves them all. Numbers with units, the names of a few known
lengths, + - * / and brackets; every value carries the power of its unit, so that "2.84" without
a unit, or a length times a length, is a mistake and not a guess.
Invariant: nothing is ever evaluated as code, and time is linear in the length of the text.
"""

from __future__ import annotations

import math
import re
from fractions import Fraction
from typing import TYPE_CHECKING

from rulelang.frozen import value

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

LENGTHS = {
    "m": 1.0,
    "cm": 0.01,
    "mm": 0.001,
    "in": 0.0254,
    "inch": 0.0254,
    "inches": 0.0254,
    "ft": 0.3048,
}
MASSES = {"kg": 1.0, "g": 0.001, "oz": 0.028349523125, "lb": 0.45359237}
ANGLES = {"rad": 1.0, "deg": math.pi / 180, "°": math.pi / 180}

_TOKEN = re.compile(
    r"\s*(?:(?P<mixed>(?:\d+\s+)?\d+/\d+(?=\s*[a-z°]))"
    r"|(?P<number>(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?)"
    r"|(?P<word>[A-Za-z°]+)"
    r"|(?P<sign>[-+*/()]))"
)
_LONGEST = 120
_DEEPEST = 12


class QuantityError(ValueError):
    """A text that is no quantity; `mend` says what would be one."""

    def __init__(self, message: str, mend: str = "") -> None:
        super().__init__(message)
        self.mend = mend


@value
class Kind:
    """What is measured, in which units, with an example for a mend."""

    noun: str
    units: Mapping[str, float]
    example: str


LENGTH = Kind("a length", LENGTHS, '"2.84 m", "52.5 mm", "9 in" or a plain number of metres')
MASS = Kind("a mass", MASSES, '"170 g", "6 oz" or a plain number of kilograms')
ANGLE = Kind("an angle", ANGLES, '"142 deg" or a plain number of radians')


@value
class Expression:
    """A checked text of a length that still waits for the names in it."""

    text: str | float

    def value(self, names: Mapping[str, float]) -> float:
        """Return metres, with `names` (such as L, W, R) filled in.

        Raises QuantityError for an unknown name.
        """
        return read_quantity(self.text, LENGTH, names)


def read_quantity(written: object, kind: Kind, names: Mapping[str, float] | None = None) -> float:
    """Return `written` in SI units: a number as it stands, a text by the grammar above.

    `names` are lengths that the text may use by name. Raises QuantityError.
    """
    if isinstance(written, bool) or not isinstance(written, int | float | str):
        raise QuantityError(f"expected {kind.noun}", f"write {kind.example}")
    if not isinstance(written, str):
        return _finite(float(written), kind)
    if len(written) > _LONGEST:
        raise QuantityError(f"{kind.noun} may not be longer than {_LONGEST} characters")
    reader = _Reader(written, kind, names or {})
    return _finite(reader.read(), kind)


def _finite(value: float, kind: Kind) -> float:
    if not math.isfinite(value) or abs(value) > 1e6:
        raise QuantityError(f"{value} is no sensible size for {kind.noun}", f"write {kind.example}")
    return value


Term = tuple[float, int]
"""A value and the power of its unit: 0 for a bare number, 1 for a quantity."""


class _Reader:
    """Recursive descent over one text."""

    def __init__(self, text: str, kind: Kind, names: Mapping[str, float]) -> None:
        self.text = text
        self.kind = kind
        self.names = names
        self.tokens = [*self.split(), ("end", "")]
        self.at = 0
        self.depth = 0

    def fail(self, what: str, mend: str = "") -> QuantityError:
        told = f'"{self.text}" {what}' if what.startswith("is ") else f'"{self.text}": {what}'
        return QuantityError(told, mend or f"write {self.kind.example}")

    def split(self) -> Iterator[tuple[str, str]]:
        at = 0
        text = self.text.rstrip()
        while at < len(text):
            match = _TOKEN.match(text, at)
            if match is None or match.lastgroup is None:
                mend = _with_point(text) if text[at] == "," else ""
                raise self.fail(f"cannot read `{text[at:].strip()[:12]}`", mend)
            yield match.lastgroup, match.group(match.lastgroup)
            at = match.end()

    def read(self) -> float:
        value, power = self.sum()
        if self.tokens[self.at][0] != "end":
            raise self.fail(f"did not expect `{self.tokens[self.at][1]}`")
        if power == 0 and value != 0:
            units = ", ".join(self.kind.units)
            raise self.fail(f"has no unit; {self.kind.noun} is in one of {units}")
        if power not in (0, 1):
            raise self.fail(f"is not {self.kind.noun}")
        return value

    def take(self, signs: str) -> str:
        group, text = self.tokens[self.at]
        if group == "sign" and text in signs:
            self.at += 1
            return text
        return ""

    def sum(self) -> Term:
        left, power = self.product()
        while sign := self.take("+-"):
            right, other = self.product()
            if power != other and left != 0 and right != 0:
                raise self.fail("adds a bare number to a quantity; give the number a unit")
            power = power if left != 0 else other
            left = left + right if sign == "+" else left - right
        return left, power

    def product(self) -> Term:
        left, power = self.factor()
        while True:
            sign = self.take("*/")
            if not sign and not self.multiplies_by_juxtaposition():
                return left, power
            right, other = self.factor()
            if sign == "/":
                if right == 0:
                    raise self.fail("divides by zero")
                left, power = left / right, power - other
            else:
                left, power = left * right, power + other

    def multiplies_by_juxtaposition(self) -> bool:
        group, text = self.tokens[self.at]
        return (group == "word" and text in self.names) or text == "("

    def factor(self) -> Term:
        self.depth += 1
        if self.depth > _DEEPEST:
            raise self.fail("is nested too deeply")
        try:
            return self.signed()
        finally:
            self.depth -= 1

    def signed(self) -> Term:
        if sign := self.take("+-"):
            value, power = self.factor()
            return (-value if sign == "-" else value), power
        if self.take("("):
            inside = self.sum()
            if not self.take(")"):
                raise self.fail("lacks a closing bracket")
            return inside
        if self.tokens[self.at][0] == "word":
            return self.name()
        return self.measure()

    def name(self) -> Term:
        word = self.tokens[self.at][1]
        if word not in self.names:
            known = f"known here: {', '.join(self.names)}" if self.names else ""
            raise self.fail(f"`{word}` is not known here", known)
        self.at += 1
        return self.names[word], 1

    def measure(self) -> Term:
        total, power = self.one_measure()
        while power == 1 and self.tokens[self.at][0] in ("number", "mixed"):
            more, other = self.one_measure()
            if other != 1:
                raise self.fail("has a number without a unit")
            total += more
        return total, power

    def one_measure(self) -> Term:
        group, text = self.tokens[self.at]
        if group not in ("number", "mixed"):
            raise self.fail(f"expected a number before `{text}`" if text else "ends too early")
        self.at += 1
        value = _mixed(text) if group == "mixed" else float(text)
        if value is None:
            raise self.fail("divides by zero")
        group, unit = self.tokens[self.at]
        if group != "word" or unit in self.names:
            return value, 0
        if unit not in self.kind.units:
            units = ", ".join(self.kind.units)
            raise self.fail(f"`{unit}` is no unit of {self.kind.noun}", f"use one of {units}")
        self.at += 1
        return value * self.kind.units[unit], 1


def _with_point(text: str) -> str:
    """Return the mend of a number with a decimal comma."""
    return f'write a decimal point: "{text.replace(",", ".")}"'


def _mixed(text: str) -> float | None:
    """Return "8 1/2" as 8.5, or None when it divides by zero."""
    try:
        return float(sum(Fraction(part) for part in text.split()))
    except ZeroDivisionError:
        return None
