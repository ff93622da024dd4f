"""The colours of the display, dark or light.

One idea: a colour is named once, as it is on a dark ground; a light theme says what stands for it.
Invariant: text can be read on its ground in both (contrast 4.5 to 1 or more, WCAG 2.2, 1.4.3).
"""

from __future__ import annotations

from types import MappingProxyType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping

Colour = tuple[int, int, int]
TEXT: Colour = (233, 232, 226)
FAINT: Colour = (150, 155, 162)
PLAIN: Colour = (205, 206, 204)
GOLD: Colour = (250, 196, 70)
GOOD: Colour = (128, 214, 140)
BAD: Colour = (255, 122, 108)
PANEL: Colour = (22, 25, 31)
BACKGROUND: Colour = (16, 18, 22)
EDGE: Colour = (62, 68, 80)
BUTTON: Colour = (36, 40, 48)
MARKED: Colour = (40, 44, 54)
PICKED: Colour = (60, 54, 32)
TROUGH: Colour = (40, 45, 52)
CHALK: Colour = (236, 234, 222)

LIGHT: Mapping[Colour, Colour] = MappingProxyType(
    {
        TEXT: (24, 26, 30),
        FAINT: (84, 90, 98),
        PLAIN: (52, 55, 58),
        GOLD: (132, 82, 0),
        GOOD: (18, 98, 44),
        BAD: (178, 24, 20),
        PANEL: (243, 242, 238),
        BACKGROUND: (232, 232, 227),
        EDGE: (176, 180, 186),
        BUTTON: (226, 228, 231),
        MARKED: (222, 225, 230),
        PICKED: (255, 238, 196),
        TROUGH: (208, 212, 217),
    }
)
THEMES: Mapping[str, Mapping[Colour, Colour]] = MappingProxyType(
    {"dark": MappingProxyType({}), "light": LIGHT}
)


def contrast(one: Colour, two: Colour) -> float:
    """Return how well two colours stand out from each other, 1 to 21 (WCAG 2.2)."""
    high, low = sorted((_luminance(one), _luminance(two)), reverse=True)
    return (high + 0.05) / (low + 0.05)


def _luminance(colour: Colour) -> float:
    shares = (part / 255.0 for part in colour)
    red, green, blue = (
        share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4 for share in shares
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue
