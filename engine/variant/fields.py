"""The kinds of field a variant file has: quantities, names, colours, places.

One idea: each kind is an annotated type whose reader speaks in codes and mends, so the list of
errors of pydantic's core becomes the author's list of mistakes.
"""

from __future__ import annotations

import math
import re
from typing import Annotated

from pydantic_core import PydanticCustomError

from engine.variant.quantity import (
    ANGLE,
    LENGTH,
    MASS,
    Expression,
    Kind,
    QuantityError,
    read_quantity,
)
from engine.variant.shape import After, Before, Bounds, Told

_KEBAB = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")
_STEM = re.compile(r"[a-z0-9]+([-_][a-z0-9]+)*")
_HEX = re.compile(r"#([0-9a-fA-F]{6})")
_LONGEST_NAME = 60
_LONGEST_LENGTH = 20.0
_LARGEST_MASS = 10.0


def mistake(code: str, what: str, mend: str = "") -> PydanticCustomError:
    """Return an error that carries a code of our own and a mend."""
    return PydanticCustomError(code, "{what}", {"what": what, "mend": mend})


def _quantity(kind: Kind, written: object) -> float:
    try:
        return read_quantity(written, kind)
    except QuantityError as error:
        raise mistake("V104", str(error), error.mend) from None


def _expression(written: object) -> object:
    names = {"L": 2.0, "W": 1.0, "R": 0.03}
    try:
        read_quantity(written, LENGTH, names)
    except QuantityError as error:
        raise mistake("V104", str(error), error.mend) from None
    return Expression(written) if isinstance(written, str | int | float) else written


def _kebab(name: str) -> str:
    if _KEBAB.fullmatch(name) and len(name) <= _LONGEST_NAME:
        return name
    better = re.sub(r"[^a-z0-9]+", "-", re.sub(r"(?<=[a-z])(?=[A-Z])", "-", name).lower())
    better = better.strip("-")[:_LONGEST_NAME]
    mend = f"write `{better}`" if better else "use small letters, digits and hyphens"
    raise mistake("V107", f"`{name[:_LONGEST_NAME]}` is not kebab-case", mend)


def _stem(name: str) -> str:
    if _STEM.fullmatch(name) and len(name) <= _LONGEST_NAME:
        return name
    raise mistake(
        "V107",
        f"`{name[:_LONGEST_NAME]}` is not the stem of a file",
        "use small letters, digits, hyphens and underscores, without folder and ending",
    )


def _colour(written: object) -> tuple[int, int, int]:
    match = _HEX.fullmatch(written) if isinstance(written, str) else None
    if match is None:
        raise mistake("V108", "a colour is written as six hexadecimal digits", 'write "#1e6b3c"')
    digits = match.group(1)
    return int(digits[0:2], 16), int(digits[2:4], 16), int(digits[4:6], 16)


def _above_zero(value: float) -> float:
    if value <= 0:
        raise mistake("V105", f"{value:g} is not above zero", "give a size above zero")
    return value


def _not_below_zero(value: float) -> float:
    if value < 0:
        raise mistake("V105", f"{value:g} is below zero", "write 0 or more")
    return value


def _of_a_room(value: float) -> float:
    if value > _LONGEST_LENGTH:
        mend = f'a plain number is metres; name the unit, as in "{value:g} cm" or "{value:g} mm"'
        raise mistake("V105", f"{value:g} m is larger than any table", mend)
    return value


def _of_a_hand(value: float) -> float:
    if value > _LARGEST_MASS:
        mend = f'a plain number is kilograms; name the unit, as in "{value:g} g"'
        raise mistake("V105", f"{value:g} kg is heavier than any ball or cue", mend)
    return value


def _opening(value: float) -> float:
    if not math.pi / 4 <= value <= math.pi:
        mend = 'a plain number is radians; write "45 deg" to "180 deg", as in "142 deg"'
        raise mistake("V105", f"{value:g} rad is no angle between facing and cushion", mend)
    return value


def _written(noun: str, units: str, reckoned: str = "") -> Told:
    """Return what an editor is told of a quantity: a number, or a text with a unit."""
    text = {"type": "string", "maxLength": 120, "pattern": rf"({units})\b{reckoned}|^[ 0.+-]*0$|°"}
    number = {"type": "number", "minimum": -1e6, "maximum": 1e6}
    return Told({"anyOf": [number, text], "description": f"{noun}."})


_A_LENGTH = _written(
    'A length, such as "57.15 mm"; a plain number is metres', "m|cm|mm|in|inch|inches|ft"
)
_A_COORDINATE = _written(
    'A length, which may be reckoned with L, W and R: "-L/4", "2 R + 1 mm"',
    "m|cm|mm|in|inch|inches|ft",
    r"|\b[LWR]\b",
)
_A_MASS = _written('A mass, such as "170 g"; a plain number is kilograms', "kg|g|oz|lb")
_AN_ANGLE = _written('An angle, such as "142 deg"; a plain number is radians', "rad|deg")
_A_NAME = Told({"type": "string", "pattern": f"^{_KEBAB.pattern}$", "maxLength": _LONGEST_NAME})
_A_STEM = Told({"type": "string", "pattern": f"^{_STEM.pattern}$", "maxLength": _LONGEST_NAME})
_A_COLOUR = Told({"type": "string", "pattern": "^#[0-9a-fA-F]{6}$"})

Metres = Annotated[float, Before(lambda written: _quantity(LENGTH, written)), _A_LENGTH]
Size = Annotated[Metres, After(_above_zero), After(_of_a_room)]
Gap = Annotated[Metres, After(_not_below_zero)]
Kilograms = Annotated[
    float,
    Before(lambda written: _quantity(MASS, written)),
    After(_above_zero),
    After(_of_a_hand),
    _A_MASS,
]
Radians = Annotated[float, Before(lambda written: _quantity(ANGLE, written)), _AN_ANGLE]
Cut = Annotated[Radians, After(_opening)]
Coordinate = Annotated[Expression, Before(_expression), _A_COORDINATE]
Name = Annotated[str, After(_kebab), _A_NAME]
Stem = Annotated[str, After(_stem), _A_STEM]
Rgb = Annotated[tuple[int, int, int], Before(_colour), _A_COLOUR]
Fraction = Annotated[float, Bounds(ge=0, le=1)]
Factor = Annotated[float, Bounds(ge=0, le=1000)]
Slope = Annotated[float, Bounds(ge=-1000, le=1000)]
