"""From a set of pins as written to the pins that stand on the table, and their looks.

One idea: what a pin does not say is the set's; sizes are written as diameters and kept as radii.
Invariant: a pin that is kept stands on the bed, clear of posts, holes and other pins.
"""

from __future__ import annotations

from math import hypot
from typing import TYPE_CHECKING, Any

from engine.table.furniture import Pin, PinId
from engine.variant.outlining import in_the_way
from engine.variant.variant import PinKind

if TYPE_CHECKING:
    from collections.abc import Iterable

    from engine.table.furniture import Point
    from engine.variant.furnish import Surveyor
    from engine.variant.locate import KeyPath
    from engine.variant.report import Report
    from engine.variant.spec import PinSet, PinShape, VariantSpec


def build_pins(
    spec: VariantSpec, balls: Iterable[str], surveyor: Surveyor
) -> tuple[tuple[Pin, ...], tuple[PinKind, ...]]:
    """Return the pins in the order of the file; mistakes go to the surveyor's report.

    `balls` are the names of all balls.
    """
    if spec.pins is None:
        return (), ()
    _check_names(spec, spec.pins, balls, surveyor.report)
    pins: list[Pin] = []
    kinds = []
    for name, shape in spec.pins.pin.items():
        path: KeyPath = ("pins", "pin", name)
        at = surveyor.point(shape.at, (*path, "at"))
        kinds.append(PinKind(PinId(name), shape.colour or spec.pins.colour))
        if at is None:
            continue
        pin = _pin(spec.pins, shape, name, at, surveyor.report)
        taken = in_the_way(surveyor.bed, at, pin.belly) or _beside(pins, pin)
        if taken:
            mend = "move it to where it has air around it"
            surveyor.report.add("V416", path, f"pin `{name}` {taken}", mend, on_key=True)
        pins.append(pin)
    return tuple(pins), tuple(kinds)


def _beside(pins: Iterable[Pin], pin: Pin) -> str:
    for other in pins:
        apart = hypot(pin.at[0] - other.at[0], pin.at[1] - other.at[1])
        if apart <= pin.belly + other.belly:
            return f"touches pin `{other.id}`"
    return ""


def _pin(pins: PinSet, shape: PinShape, name: str, at: Point, report: Report) -> Pin:
    def said(key: str) -> Any:
        own = getattr(shape, key)
        return getattr(pins, key) if own is None else own

    height, base = said("height"), said("base")
    belly_height = said("belly_height") or height / 2.0
    if not belly_height < height:
        own = shape.belly_height is not None
        path: KeyPath = ("pins", "pin", name, "belly_height") if own else ("pins", "belly_height")
        message = f"the belly of pin `{name}` is not below its head"
        report.add("V417", path, message, f"write less than the height, {height * 1000:g} mm")
        belly_height = height / 2.0
    profile = (
        (0.0, base / 2.0),
        (belly_height, said("belly") / 2.0),
        (height, (said("head") or base) / 2.0),
    )
    return Pin(
        PinId(name),
        at,
        profile,
        said("mass"),
        pins.restitution,
        pins.friction,
        said("topples_at"),
    )


def _check_names(spec: VariantSpec, pins: PinSet, balls: Iterable[str], report: Report) -> None:
    """Report a pin that is called like something else that scripts and records name."""
    others: dict[str, str] = dict.fromkeys(balls, "ball")
    for kind in ("spot", "line", "zone", "post", "hole"):
        others |= dict.fromkeys(getattr(spec.table, f"{kind}s"), kind)
    for name in pins.pin:
        if name in others:
            message = f"`{name}` is a {others[name]} and a pin"
            report.add("V304", ("pins", "pin", name), message, "name the pin anew", on_key=True)
