"""The display round the picture: a bar above, a bar below, a column beside it.

One idea: what is said comes as values, where it stands is decided here, in `bottom` and in
`column`, and what can be clicked is handed back by name. Invariant: nothing of it covers the
picture while there is something to be played.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from engine.app.board import board_of
from engine.app.bottom import draw_bottom
from engine.app.column import draw_column
from engine.app.keymap import Keymap
from engine.app.session import Mode
from engine.app.theme import BAD, FAINT, GOLD, PICKED, TEXT
from engine.app.units import Units
from engine.app.words import result_words

if TYPE_CHECKING:
    from engine.app.board import Board, TimeLine
    from engine.app.pen import Pen
    from engine.app.screen import Box
    from engine.app.session import Session

RIGHT, PLAYER = 290, 130
"""Widths of the right corner and, at least, of a player's field, in text pixels."""
TOP, BOTTOM, SIDE = 58, 104, 300
"""Heights of the bars and width of the column, in text pixels."""


def scale_for(size: tuple[int, int], text: float) -> float:
    """Return the scale of the display for a window and the player's wish."""
    fit = min(size[0] / 1280.0, size[1] / 720.0)
    return text * min(max(fit, 0.8), 3.0)


def _tone(time: TimeLine) -> tuple[int, int, int]:
    return BAD if time.is_short else TEXT


@dataclass(slots=True)
class Hud:
    """The display; `hot` names what can be clicked, in the boxes of the last drawing."""

    pen: Pen
    keymap: Keymap = field(default_factory=Keymap)
    units: Units = Units.METRIC
    letters: bool = False
    hot: dict[str, Box] = field(default_factory=dict)

    def picture_box(self) -> Box:
        """Return the box that is left for the picture."""
        width, height = self.pen.surface.get_size()
        top, bottom = self.pen.px(TOP), self.pen.px(BOTTOM)
        return 0, top, max(width - self._side(), 16), max(height - top - bottom, 16)

    def _side(self) -> int:
        return min(self.pen.px(SIDE), round(0.32 * self.pen.surface.get_width()))

    def draw(self, session: Session, status: str) -> None:
        """Draw the whole display for a session; `status` is said in the upper right corner."""
        self.hot.clear()
        pen = self.pen
        board = board_of(session, self.units)
        width, height = pen.surface.get_size()
        _, top, left, tall = self.picture_box()
        self._top(board, status)
        below = (0, height - pen.px(BOTTOM), width, pen.px(BOTTOM))
        self.hot |= draw_bottom(pen, session, board, below, self.keymap, self.units)
        beside = (left, top, width - left, tall)
        self.hot |= draw_column(pen, session, board, beside, self.keymap, letters=self.letters)
        if session.mode is Mode.OVER:
            self._banner(session)

    def _top(self, board: Board, status: str) -> None:
        pen = self.pen
        width, height = pen.surface.get_width(), pen.px(TOP)
        pen.panel((0, 0, width, height), 255, None)
        pen.rule((0, height - 1), (width, height - 1))
        corner = f"{self.keymap.shown('help')} keys   {self.keymap.shown('menu')} menu"
        edge, right = pen.px(14), min(pen.px(RIGHT), width // 4)
        left = self._title_width(board)
        self._title(board, left)
        self._players(board, left, width - right)
        pen.write(status, (width - edge, pen.px(12)), FAINT, 13, "right", room=right - edge)
        pen.write(corner, (width - edge, pen.px(34)), FAINT, 13, "right", room=right - edge)

    def _title_width(self, board: Board) -> int:
        """Return how wide the title's field is: as it needs, as far as the players leave it."""
        pen, width = self.pen, self.pen.surface.get_width()
        times = sum(pen.width(f"{one.name} {one.left}", 13) + pen.px(14) for one in board.time)
        needed = max(pen.width(board.title, 21), pen.width(board.phase, 13), times) + 2 * pen.px(18)
        most = width - min(pen.px(RIGHT), width // 4) - len(board.players) * pen.px(PLAYER)
        return max(min(needed, most, round(0.42 * width)), width // 6)

    def _title(self, board: Board, room: int) -> None:
        """Write the title, the time of the game, and phase and house rules in one line or two."""
        pen, edge = self.pen, self.pen.px(14)
        lines = pen.wrap(board.phase, room - 2 * edge, 13)
        two = len(lines) > 1 and not board.time
        rows = (1, 24, 39) if board.time else ((3, 28, 28) if two else (8, 34, 34))
        title, times, phase = map(pen.px, rows)
        pen.write(board.title, (edge, title), TEXT, 21, room=room - edge)
        self._times(board.time, (edge, times), room)
        shown = [lines[0], " ".join(lines[1:])] if two else [board.phase]
        for number, text in enumerate(shown):
            below = phase + number * pen.line(13)
            pen.write(text, (edge, below), FAINT, 13, room=room - edge)

    def _times(self, times: tuple[TimeLine, ...], place: tuple[int, int], end: int) -> None:
        """Write the time of the game between its title and its phase."""
        left, y = place
        for time in times:
            words = f"{time.name} {time.left}"
            self.pen.write(words, (left, y), _tone(time), 13, room=max(end - left, 1))
            left += self.pen.width(words, 13) + self.pen.px(14)

    def _own_times(self, times: tuple[TimeLine, ...], right: int) -> None:
        """Write the shooter's seconds, right-bound at the end of his field."""
        for time in times:
            self.pen.write(time.left, (right, self.pen.px(7)), _tone(time), 26, "right")
            right -= self.pen.width(time.left, 26) + self.pen.px(10)

    def _players(self, board: Board, left: int, right: int) -> None:
        pen = self.pen
        count = len(board.players)
        room = (right - left) // count
        for place, player in enumerate(board.players):
            x = left + place * room
            middle = x + room // 2
            if player.is_shooting:
                box = (x + pen.px(6), pen.px(5), room - pen.px(12), pen.px(TOP - 11))
                pen.card(box, PICKED, GOLD, pen.px(5))
                self._own_times(board.own_time, x + room - pen.px(14))
            colour = TEXT if player.is_shooting else FAINT
            score = pen.px(8) + pen.width(player.score, 22)
            free = room - score - pen.px(16)
            size = next((one for one in (16, 14, 12) if pen.width(player.name, one) <= free), 12)
            called = pen.fitted(player.name, size, free)
            name = pen.width(called, size) + score
            start = middle - name // 2
            pen.write(called, (start, pen.px(28 - size)), colour, size)
            pen.write(player.score, (start + name, pen.px(8)), colour, 22, "right")
            notes = ", ".join(player.notes)
            pen.write(notes, (middle, pen.px(35)), FAINT, 13, "middle", room - pen.px(20))

    def _banner(self, session: Session) -> None:
        """Say over the picture who has won."""
        pen = self.pen
        left, top, width, _ = self.picture_box()
        said = result_words(session.match.situation, session.names)
        wide = pen.width(said, 28) + pen.px(60)
        box = (left + (width - wide) // 2, top + pen.px(24), wide, pen.px(62))
        pen.panel(box, 225, GOLD)
        pen.write(said, (left + width // 2, box[1] + pen.px(15)), GOLD, 28, "middle")
