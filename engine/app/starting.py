"""The window while the game is still being prepared.

One idea: it is drawn from the first frame on, before anything slow is loaded.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from engine.app.theme import BACKGROUND, FAINT, GOLD, TEXT

if TYPE_CHECKING:
    from engine.app.pen import Pen


def draw_start(pen: Pen, title: str, saying: str, share: float, *, is_first: bool) -> None:
    """Say what is being prepared, and how far it has come (0 to 1)."""
    width, height = pen.surface.get_size()
    middle = width // 2, height // 2
    pen.surface.fill(pen.tint(BACKGROUND))
    pen.write(title, (middle[0], middle[1] - pen.px(90)), TEXT, 34, "middle")
    pen.write(saying, (middle[0], middle[1] - pen.px(20)), FAINT, 17, "middle")
    if is_first:
        first = "first start: this is done once and takes about half a minute"
        pen.write(first, (middle[0], middle[1] + pen.px(44)), FAINT, 14, "middle")
    box = middle[0] - pen.px(160), middle[1] + pen.px(14), pen.px(320), pen.px(10)
    pen.bar(box, share, GOLD)
