"""The bar below the picture: what is asked, the buttons, the gauges of the stroke.

One idea: whatever a moment waits for can be clicked here, and its key stands on it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import pygame

from engine.app.prompts import buttons_of, hint_of
from engine.app.session import BEFORE_STROKE
from engine.app.stroke import FASTEST, STEEPEST
from engine.app.theme import BAD, BUTTON, CHALK, EDGE, FAINT, GOLD, GOOD, PICKED, TEXT
from engine.app.units import Units

if TYPE_CHECKING:
    from engine.app.board import Board
    from engine.app.keymap import Keymap
    from engine.app.pen import Pen
    from engine.app.prompts import Button
    from engine.app.screen import Box
    from engine.app.session import Session

GAUGES = 330
"""Width of the gauges, in text pixels."""
ASKED = (19, 17, 15, 13)
"""Sizes of what is asked, the greatest first that has room."""


def draw_bottom(
    pen: Pen,
    session: Session,
    board: Board,
    box: Box,
    keymap: Keymap,
    units: Units = Units.METRIC,
) -> dict[str, Box]:
    """Draw the bar in its box; return what can be clicked, by name."""
    left, top, width, _ = box
    pen.panel(box, 255, None)
    pen.rule((left, top), (left + width, top))
    edge, room = pen.px(14), width - pen.px(GAUGES + 30)
    size = next((one for one in ASKED if pen.width(board.ask, one) <= room), ASKED[-1])
    pen.write(board.ask, (edge, top + pen.px(8)), TEXT, size, room=room)
    said = board.note or (f"called: {board.call}" if board.call else "")
    if said:
        lines = pen.wrap(said, room, 15)
        for place, text in enumerate(lines[:2]):
            pen.write(text, (edge, top + pen.px(33 + 18 * place)), GOLD, 15, room=room)
    else:
        pen.write(hint_of(session), (edge, top + pen.px(36)), FAINT, 14, room=room)
    hot = _draw_buttons(pen, buttons_of(session, keymap), (edge, top + pen.px(71)), room)
    if session.mode in BEFORE_STROKE:
        hot |= _draw_gauges(pen, session, (width - pen.px(GAUGES), top + pen.px(4)), units)
    return hot


def _draw_buttons(
    pen: Pen, buttons: list[Button], at: tuple[int, int], room: int
) -> dict[str, Box]:
    """Draw as many buttons as there is room for, each with its key."""
    hot: dict[str, Box] = {}
    x, y = at
    gap, high = pen.px(9), pen.px(25)
    for button in buttons:
        text, key = pen.width(button.text, 15), pen.width(button.key, 12)
        wide = text + key + 3 * gap
        if x + wide > at[0] + room:
            break
        box = (x, y, wide, high)
        fill, edge = (PICKED, GOLD) if button.is_main else (BUTTON, EDGE)
        pen.card(box, fill, edge)
        pen.write(button.text, (x + gap, y + pen.px(4)), TEXT, 15)
        pen.write(button.key, (x + 2 * gap + text, y + pen.px(6)), FAINT, 12)
        hot[f"do:{button.action}"] = box
        x += wide + gap
    return hot


def _draw_gauges(
    pen: Pen, session: Session, corner: tuple[int, int], units: Units
) -> dict[str, Box]:
    """Draw power, elevation and tip; return their boxes."""
    stroke = session.stroke
    x, top = corner
    wide, high = pen.px(205), pen.px(13)
    power = (x, top + pen.px(28), wide, high)
    share = stroke.speed / FASTEST
    pen.write("power", (x, top + pen.px(8)), FAINT, 14)
    speed = units.speed(stroke.speed)
    pen.write(speed, (x + wide, top + pen.px(8)), TEXT, 14, "right")
    pen.bar(power, share, _heat(share))
    raised = (x, top + pen.px(68), wide, high)
    pen.write("cue raised", (x, top + pen.px(48)), FAINT, 14)
    angle = f"{stroke.elevation:.0f} deg   aim {stroke.heading:.2f}"
    pen.write(angle, (x + wide, top + pen.px(48)), TEXT, 14, "right")
    pen.bar(raised, stroke.elevation / STEEPEST, (120, 150, 200))
    ball = pen.px(36)
    middle = x + pen.px(280), top + pen.px(46)
    _draw_tip(pen, session, middle, ball)
    return {
        "power": power,
        "elevation": raised,
        "tip": (middle[0] - ball, middle[1] - ball, 2 * ball, 2 * ball),
    }


def _draw_tip(pen: Pen, session: Session, middle: tuple[int, int], radius: int) -> None:
    """Draw the ball as the player sees it, the limit of the tip, and the tip."""
    surface, stroke = pen.surface, session.stroke
    pygame.draw.circle(surface, CHALK, middle, radius)
    pygame.draw.circle(surface, pen.tint(EDGE), middle, radius, 1)
    limit = round(radius * session.tip_limit)
    pygame.draw.circle(surface, (190, 186, 170), middle, limit, 1)
    for dx, dy in ((1, 0), (0, 1)):
        ends = [(middle[0] + s * dx * limit, middle[1] + s * dy * limit) for s in (-1, 1)]
        pygame.draw.line(surface, (206, 202, 188), ends[0], ends[1])
    place = (
        middle[0] + round(stroke.side * radius),
        middle[1] - round(stroke.follow * radius),
    )
    pygame.draw.circle(surface, (40, 90, 190), place, max(4, radius // 6))


def _heat(share: float) -> tuple[int, int, int]:
    """Return the colour of the power gauge, from green to red."""
    cold, hot = GOOD, BAD
    red, green, blue = (
        round(a + (b - a) * min(share * 1.3, 1.0)) for a, b in zip(cold, hot, strict=True)
    )
    return red, green, blue
