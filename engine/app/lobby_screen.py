"""The start screen, drawn: the list of games, and a card for the one picked.

One idea: a card is the game's own table from above with what can be set under it; everything on
it comes from the variant. Invariant: nothing is drawn by a renderer, so it is there at once.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from engine.app.lobby import NAME
from engine.app.lobby_table import draw_table
from engine.app.pen import TONES
from engine.app.theme import BACKGROUND, BAD, FAINT, GOLD, MARKED, PICKED, TEXT
from engine.app.words import capital, spoken

if TYPE_CHECKING:
    from engine.app.lobby import Entry, Lobby
    from engine.app.pen import Pen
    from engine.app.screen import Box
    from engine.variant.variant import Value

WHEN = re.compile(r"-(\d{4})(\d\d)(\d\d)-(\d\d)(\d\d)\d\d")
"""The day and the time in a journal's name."""
EXPLAINED = 3
"""Lines of what the marked row is about."""
ROW = 26
"""Height of a row, in text pixels."""


@dataclass(slots=True)
class LobbyScreen:
    """Draws the start screen; `hot` is what can be clicked, by name."""

    pen: Pen
    hot: dict[str, Box] = field(default_factory=dict)

    def draw(self, lobby: Lobby, saying: str) -> None:
        """Draw it; `saying` tells what is being prepared behind it."""
        pen, (width, height) = self.pen, self.pen.surface.get_size()
        self.hot.clear()
        pen.surface.fill(pen.tint(BACKGROUND))
        edge, top = pen.px(26), pen.px(74)
        pen.write("Headstring", (edge, pen.px(20)), TEXT, 30)
        told = (
            f"find: {lobby.typed}_"
            if lobby.typed
            else f"{len(lobby.shown)} games: type to find one"
        )
        pen.write(told, (edge, pen.px(54)), GOLD if lobby.typed else FAINT, 14)
        wide = min(pen.px(330), round(0.36 * width))
        bottom = height - pen.px(40)
        self._list(lobby, (edge, top, wide, bottom - top))
        left = edge + wide + edge
        self._card(lobby, (left, pen.px(24), width - left - edge, bottom - pen.px(24)))
        keys = "Up / Down  pick     Tab, Left / Right  set     Enter  play     Esc  leave"
        pen.write(keys, (edge, height - pen.px(28)), FAINT, 14, room=width - left)
        pen.write(saying, (width - edge, height - pen.px(28)), FAINT, 13, "right", left)

    def _list(self, lobby: Lobby, box: Box) -> None:
        pen, (left, top, wide, high) = self.pen, box
        step = pen.px(ROW)
        room = max(1, high // step)
        shown = lobby.shown
        first = min(max(lobby.picked - room // 2, 0), max(len(shown) - room, 0))
        for place, one in enumerate(shown[first : first + room], start=first):
            row = (left, top + (place - first) * step, wide, step - 2)
            self._game(one, row, picked=place == lobby.picked)
            self.hot[f"pick:{place}"] = row
        if not shown:
            pen.write("no game is called so: Backspace", (left, top), BAD, 16)

    def _game(self, one: Entry, box: Box, *, picked: bool) -> None:
        pen = self.pen
        if picked:
            pen.card(box, PICKED, GOLD)
        place = box[0] + pen.px(10), box[1] + pen.px(3)
        mark = "   (kept)" if one.kept else ""
        title = f"{one.title or one.name}{mark}"
        pen.write(title, place, TEXT if picked else TONES["plain"], 16, room=box[2] - pen.px(20))

    def _card(self, lobby: Lobby, box: Box) -> None:
        pen, (left, top, wide, high) = self.pen, box
        card = lobby.card
        if card is None:
            for number, text in enumerate(
                pen.wrap(lobby.trouble, wide, 15) if lobby.trouble else []
            ):
                pen.write(text, (left, top + number * pen.line(15)), BAD, 15)
            return
        rows = lobby.rows[1:]
        below = pen.px(ROW) * (len(rows) + 1) + pen.px(60)
        room = (left, top, wide, max(high - below, pen.px(120)))
        y = top + draw_table(pen.surface, card, room) + pen.px(12)
        book = f"by the {card.rulebook}" if card.rulebook else ""
        title = pen.write(card.title, (left, y), TEXT, 21)
        pen.write(book, (left + wide, y + pen.px(5)), FAINT, 14, "right", wide - title - pen.px(24))
        y += pen.px(34)
        for number, row in enumerate(rows, start=1):
            line = (left, y, wide, pen.px(ROW) - 2)
            self._row(lobby, row, line, marked=number == lobby.row)
            y += pen.px(ROW)
        play = (left, y + pen.px(4), pen.px(180), pen.px(ROW + 4))
        pen.card(play, GOLD)
        middle = play[0] + play[2] // 2, play[1] + pen.px(5)
        pen.write("Play  (Enter)", middle, BACKGROUND, 17, "middle")
        self.hot["play"] = play
        if lobby.row and lobby.row <= len(rows):
            start = left + play[2] + pen.px(20)
            self._explain(
                lobby, rows[lobby.row - 1], (start, play[1], left + wide - start, play[3])
            )

    def _explain(self, lobby: Lobby, row: str, box: Box) -> None:
        """Say all of what the marked row is about; in the row itself a long one is cut."""
        pen, (left, top, wide, _) = self.pen, box
        about = self._told(lobby, row, marked=True)[1]
        if pen.width(about, 13) < wide // 3:
            return
        for number, text in enumerate(pen.wrap(about, wide, 13)[:EXPLAINED]):
            pen.write(text, (left, top + number * pen.line(13)), TONES["plain"], 13, room=wide)

    def _row(self, lobby: Lobby, row: str, box: Box, *, marked: bool) -> None:
        pen, (left, top, wide, high) = self.pen, box
        if marked:
            pen.card(box, MARKED, GOLD)
        told, about = self._told(lobby, row, marked=marked)
        text = top + pen.px(3)
        pen.write(told, (left + pen.px(10), text), TEXT if marked else TONES["plain"], 15)
        middle, arrow = left + round(0.46 * wide), pen.px(60)
        arrows = () if row.startswith(NAME) else ((-1, middle - arrow), (1, middle + arrow))
        if row.startswith(NAME):
            self.hot[f"mark:{row}"] = box
        for sign, x in arrows:
            spot = (x - pen.px(10), top, pen.px(20), high)
            pen.write("<" if sign < 0 else ">", (x, text), GOLD, 15, "middle")
            self.hot[f"set:{row}:{sign}"] = spot
        said = _match_words(lobby) if row == "match" else _value_words(lobby.value(row))
        if row.startswith(NAME) and marked:
            said += "_"
        pen.write(said, (middle, text), GOLD, 15, "middle", room=2 * arrow - pen.px(24))
        start = middle + arrow + pen.px(24)
        pen.write(about, (start, text), FAINT, 13, room=max(left + wide - start, 1))

    @staticmethod
    def _told(lobby: Lobby, row: str, *, marked: bool) -> tuple[str, str]:
        """Return a row's name and what it is about."""
        if row == "players" or lobby.card is None:
            return "Players", ""
        if row == "match":
            count = len(lobby.entry.kept) if lobby.entry else 0
            return "Match", f"{count} kept" if count > 1 else "one is kept"
        if row.startswith(NAME):
            return f"Player {row.removeprefix(NAME)}", "type a name" if marked else "click to name"
        return capital(spoken(row)), lobby.card.settings[row].about


def _value_words(value: Value) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return spoken(str(value))


def _match_words(lobby: Lobby) -> str:
    """Return which match is played: a new one, or the day and time of one that is kept."""
    if not lobby.match or lobby.entry is None:
        return "new"
    found = WHEN.search(lobby.entry.kept[lobby.match - 1].stem)
    return f"{found[3]}.{found[2]}. {found[4]}:{found[5]}" if found else "go on"
