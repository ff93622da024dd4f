"""The display round the picture: a bar above, a bar below, and panels.

One idea: what is said comes from `words`, where it stands is decided here, and what can be
clicked is handed back by name. Invariant: the bars never cover the picture.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import pygame

from engine.app.pen import BAD, EDGE, FAINT, GOLD, GOOD, TEXT, TONES, Pen
from engine.app.session import Mode
from engine.app.stroke import FASTEST, STEEPEST
from engine.app.words import Board, Line, board_of, spoken, verdict_lines

if TYPE_CHECKING:
    from engine.app.controls import Box
    from engine.app.session import Session
    from engine.variant.variant import BallKind

TOP, BOTTOM = 58, 92
"""Heights of the bars, in text pixels."""
CHALK = (236, 234, 222)


def scale_for(size: tuple[int, int], text: float) -> float:
    """Return the scale of the display for a window and the player's wish."""
    fit = min(size[0] / 1280.0, size[1] / 720.0)
    return text * min(max(fit, 0.8), 3.0)


@dataclass(slots=True)
class Hud:
    """The display; `hot` names what can be clicked, in the boxes of the last drawing."""

    pen: Pen
    hot: dict[str, Box] = field(default_factory=dict)

    def picture_box(self) -> Box:
        """Return the box that is left for the picture."""
        width, height = self.pen.surface.get_size()
        top, bottom = self.pen.px(TOP), self.pen.px(BOTTOM)
        return 0, top, width, max(height - top - bottom, 16)

    def draw(self, session: Session, status: str) -> None:
        """Draw the whole display for a session; `status` is said in the upper right corner."""
        self.hot.clear()
        board = board_of(session)
        self._top(session, board, status)
        self._bottom(session, board)
        if session.mode is Mode.CHOOSING:
            self._choices(session)
        elif session.mode is Mode.VERDICT and session.last is not None:
            lines = verdict_lines(session.variant, session.last)
            self._verdict(f"Shot {len(session.match.played)}", lines)
        elif session.mode is Mode.OVER and session.last is not None:
            lines = verdict_lines(session.variant, session.last)
            self._verdict("Game over", lines)

    def _top(self, session: Session, board: Board, status: str) -> None:
        pen = self.pen
        width, height = pen.surface.get_width(), pen.px(TOP)
        pen.panel((0, 0, width, height), 255, None)
        pygame.draw.line(pen.surface, EDGE, (0, height - 1), (width, height - 1))
        edge = pen.px(14)
        third = width // 4
        pen.write(board.title, (edge, pen.px(8)), TEXT, 21, room=third - edge)
        pen.write(board.phase, (edge, pen.px(34)), FAINT, 15, room=third - edge)
        self._players(board, third, width - third)
        pen.write(status, (width - edge, pen.px(36)), FAINT, 13, "right", room=third)
        if board.on_words:
            self._on(session, board, width - edge, third)

    def _on(self, session: Session, board: Board, right: int, room: int) -> None:
        """Write what is on with a dot of each colour."""
        pen = self.pen
        kinds = [kind for kind in session.variant.balls if kind.id in board.on]
        shown = _distinct(kinds)[:8]
        dot = pen.px(7)
        words = pen.fitted(f"on: {board.on_words}", 16, room - len(shown) * (2 * dot + 3))
        left = right - pen.write(words, (right, pen.px(9)), GOLD, 16, "right")
        for place, kind in enumerate(shown):
            x = left - pen.px(6) - (len(shown) - place) * (2 * dot + 3) + dot
            _dot(pen, (x, pen.px(18)), dot, kind)

    def _players(self, board: Board, left: int, right: int) -> None:
        pen = self.pen
        count = len(board.players)
        room = (right - left) // count
        for place, player in enumerate(board.players):
            x = left + place * room
            middle = x + room // 2
            if player.is_shooting:
                box = (x + pen.px(6), pen.px(5), room - pen.px(12), pen.px(TOP - 11))
                pygame.draw.rect(pen.surface, (48, 44, 30), box, border_radius=pen.px(5))
                pygame.draw.rect(pen.surface, GOLD, box, 1, border_radius=pen.px(5))
            colour = TEXT if player.is_shooting else FAINT
            name = pen.width(player.name, 16) + pen.px(12) + pen.width(player.score, 22)
            start = middle - name // 2
            pen.write(player.name, (start, pen.px(12)), colour, 16)
            pen.write(player.score, (start + name, pen.px(8)), colour, 22, "right")
            notes = ", ".join(player.notes)
            pen.write(notes, (middle, pen.px(35)), FAINT, 13, "middle", room - pen.px(20))

    def _bottom(self, session: Session, board: Board) -> None:
        pen = self.pen
        width, height = pen.surface.get_size()
        top = height - pen.px(BOTTOM)
        pen.panel((0, top, width, pen.px(BOTTOM)), 255, None)
        pygame.draw.line(pen.surface, EDGE, (0, top), (width, top))
        gauges = pen.px(330)
        room = width - gauges - pen.px(30)
        edge = pen.px(14)
        pen.write(board.ask, (edge, top + pen.px(10)), TEXT, 19, room=room)
        second = board.note or (f"called: {board.call}" if board.call else "")
        tone = BAD if board.note else GOLD
        pen.write(second, (edge, top + pen.px(37)), tone, 16, room=room)
        pen.write(board.hint, (edge, top + pen.px(64)), FAINT, 14, room=room)
        if session.mode in (Mode.PLACING, Mode.CALLING, Mode.AIMING):
            self._gauges(session, (width - gauges, top))

    def _gauges(self, session: Session, corner: tuple[int, int]) -> None:
        pen, stroke = self.pen, session.stroke
        x, top = corner
        wide, high = pen.px(205), pen.px(13)
        power = (x, top + pen.px(28), wide, high)
        share = stroke.speed / FASTEST
        pen.write("power", (x, top + pen.px(8)), FAINT, 14)
        speed = f"{stroke.speed:.2f} m/s"
        pen.write(speed, (x + wide, top + pen.px(8)), TEXT, 14, "right")
        pen.bar(power, share, _heat(share))
        raised = (x, top + pen.px(68), wide, high)
        pen.write("cue raised", (x, top + pen.px(48)), FAINT, 14)
        angle = f"{stroke.elevation:.0f} deg   aim {stroke.heading:.2f}"
        pen.write(angle, (x + wide, top + pen.px(48)), TEXT, 14, "right")
        pen.bar(raised, stroke.elevation / STEEPEST, (120, 150, 200))
        ball = pen.px(38)
        middle = x + pen.px(280), top + pen.px(46)
        self._tip(session, middle, ball)
        self.hot |= {
            "power": power,
            "elevation": raised,
            "tip": (middle[0] - ball, middle[1] - ball, 2 * ball, 2 * ball),
        }

    def _tip(self, session: Session, middle: tuple[int, int], radius: int) -> None:
        """Draw the ball as the player sees it, the limit of the tip, and the tip."""
        surface, stroke = self.pen.surface, session.stroke
        pygame.draw.circle(surface, CHALK, middle, radius)
        limit = round(radius * session.tip_limit)
        pygame.draw.circle(surface, (190, 186, 170), middle, limit, 1)
        for dx, dy in ((1, 0), (0, 1)):
            ends = [(middle[0] + s * dx * limit, middle[1] + s * dy * limit) for s in (-1, 1)]
            pygame.draw.line(surface, (206, 202, 188), *ends)
        place = (
            middle[0] + round(stroke.side * radius),
            middle[1] - round(stroke.follow * radius),
        )
        pygame.draw.circle(surface, (40, 90, 190), place, max(4, radius // 6))

    def _choices(self, session: Session) -> None:
        pen = self.pen
        options = session.match.situation.options
        row = pen.line(18) + pen.px(12)
        names = [f"{number}   {spoken(name)}" for number, name in enumerate(options, start=1)]
        wide = max(pen.px(300), max(pen.width(name, 18) for name in names) + pen.px(60))
        high = row * len(options) + pen.px(56)
        left, top = self._centre(wide, high)
        pen.panel((left, top, wide, high))
        pen.write("Choose", (left + wide // 2, top + pen.px(12)), TEXT, 19, "middle")
        for place, name in enumerate(names):
            box = (left + pen.px(12), top + pen.px(44) + place * row, wide - pen.px(24), row - 4)
            picked = place == session.picked
            if picked:
                pygame.draw.rect(pen.surface, (60, 54, 32), box, border_radius=4)
                pygame.draw.rect(pen.surface, GOLD, box, 1, border_radius=4)
            colour = TEXT if picked else TONES["plain"]
            pen.write(name, (box[0] + pen.px(14), box[1] + pen.px(5)), colour, 18)
            self.hot[f"option:{place}"] = box

    def _centre(self, wide: int, high: int) -> tuple[int, int]:
        _, top, width, height = self.picture_box()
        return (width - wide) // 2, top + max((height - high) // 2, 0)

    def _verdict(self, title: str, lines: list[Line]) -> None:
        pen = self.pen
        wide = min(pen.px(400), pen.surface.get_width() - 20)
        inner = wide - pen.px(28)
        rows = [
            (text, line.tone)
            for line in lines
            for text in pen.wrap(line.text, inner, 16 if line.tone != "faint" else 14)
        ]
        _, top, width, height = self.picture_box()
        row = pen.line(16)
        most = max(1, (height - pen.px(60)) // row)
        if len(rows) > most:
            rows = [*rows[: most - 2], ("(H for all of it)", "faint"), rows[-1]]
        high = row * len(rows) + pen.px(46)
        left, upper = width - wide - pen.px(12), top + height - high - pen.px(12)
        pen.panel((left, upper, wide, high))
        pen.write(title, (left + pen.px(14), upper + pen.px(10)), FAINT, 14)
        for place, (text, tone) in enumerate(rows):
            size = 14 if tone == "faint" else 16
            at = left + pen.px(14), upper + pen.px(34) + place * row
            pen.write(text, at, TONES[tone], size, room=inner)


def _distinct(kinds: list[BallKind]) -> list[BallKind]:
    """Return one ball of each look."""
    seen: dict[tuple[object, ...], BallKind] = {}
    for kind in kinds:
        seen.setdefault((kind.colour, kind.pattern, kind.label), kind)
    return list(seen.values())


def _dot(pen: Pen, middle: tuple[int, int], radius: int, kind: BallKind) -> None:
    if kind.pattern == "stripe":
        pygame.draw.circle(pen.surface, CHALK, middle, radius)
        band = (middle[0] - radius + 1, middle[1] - radius // 2, 2 * radius - 2, radius)
        pygame.draw.rect(pen.surface, kind.colour, band, border_radius=2)
    else:
        pygame.draw.circle(pen.surface, kind.colour, middle, radius)
    pygame.draw.circle(pen.surface, FAINT, middle, radius, 1)


def _heat(share: float) -> tuple[int, int, int]:
    """Return the colour of the power gauge, from green to red."""
    cold, hot = GOOD, BAD
    red, green, blue = (
        round(a + (b - a) * min(share * 1.3, 1.0)) for a, b in zip(cold, hot, strict=True)
    )
    return red, green, blue
