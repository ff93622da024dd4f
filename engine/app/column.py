"""The column beside the picture: what is on, what may be chosen, what the referee said last.

One idea: it is read from the top; what must be answered now stands above what is over.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import pygame

from engine.app.choices import choice_words, option_name
from engine.app.labels import labels_of
from engine.app.pen import TONES
from engine.app.session import SHOWING, Mode
from engine.app.telling import verdict_lines
from engine.app.theme import (
    BAD,
    BUTTON,
    CHALK,
    EDGE,
    FAINT,
    GOLD,
    PANEL,
    PICKED,
    TEXT,
    Colour,
    contrast,
)
from engine.app.words import player_name

if TYPE_CHECKING:
    from engine.app.board import Board
    from engine.app.keymap import Keymap
    from engine.app.pen import Pen
    from engine.app.screen import Box
    from engine.app.session import Session
    from engine.app.words import Line
    from engine.variant.variant import BallKind


@dataclass(slots=True)
class Column:
    """Writes downwards from `y` in a column of `room` pixels; `hot` is what can be clicked."""

    pen: Pen
    x: int
    y: int
    room: int
    end: int
    hot: dict[str, Box] = field(default_factory=dict)

    def line(self, text: str, colour: tuple[int, int, int], size: float, gap: float = 0.0) -> None:
        """Write one line, cut where it is too long."""
        self.pen.write(text, (self.x, self.y), colour, size, room=self.room)
        self.y += self.pen.line(size) + (self.pen.px(gap) if gap else 0)

    def text(self, text: str, colour: tuple[int, int, int], size: float, most: int = 9) -> None:
        """Write a text in as many lines as it takes, up to `most`."""
        for row in self.pen.wrap(text, self.room, size)[:most]:
            self.line(row, colour, size)

    def rule(self) -> None:
        """Draw a line across."""
        y = self.y + self.pen.px(8)
        self.pen.rule((self.x, y), (self.x + self.room, y))
        self.y += self.pen.px(20)


def draw_column(
    pen: Pen, session: Session, board: Board, box: Box, keymap: Keymap, *, letters: bool = False
) -> dict[str, Box]:
    """Draw the column in its box; return what can be clicked, by name."""
    left, top, wide, high = box
    pen.panel(box, 255, None)
    pen.rule((left, top), (left, top + high))
    edge = pen.px(14)
    column = Column(pen, left + edge, top + pen.px(12), wide - 2 * edge, top + high)
    if session.trouble:
        _draw_trouble(column, session, keymap)
    if session.mode is Mode.CHOOSING:
        _draw_choices(column, session)
    if board.on_words:
        _draw_on(column, session, board, letters=letters)
    if board.turn:
        column.line("this turn", FAINT, 14)
        for counted in board.turn:
            column.line(counted, TONES["plain"], 16)
        column.rule()
    played = session.match.played
    if session.mode in SHOWING and session.back_to is None:
        played = played[:-1]
    if played:
        lines = verdict_lines(session.variant, played[-1], session.names)
        who = player_name(played[-1].before.shooter, session.names)
        fresh = session.mode in (Mode.VERDICT, Mode.OVER)
        title = f"Shot {len(played)}, {who}"
        _draw_told(column, title, lines, session.variant.rulebook, keymap, fresh=fresh)
    return column.hot


def _draw_trouble(column: Column, session: Session, keymap: Keymap) -> None:
    """Tell what is wrong with the script, and that nothing is lost."""
    column.line("The script is in trouble", BAD, 17)
    told = [line for line in session.trouble.splitlines() if line.strip(" |^")]
    for line in told[:14]:
        column.text(line.strip(), TONES["plain"], 14, 14)
    undo = keymap.shown("undo")
    kept = f"The match is as it was before. Mend it, play otherwise, or take a shot back ({undo})."
    column.text(kept, FAINT, 14)
    column.rule()


def _draw_choices(column: Column, session: Session) -> None:
    """Draw the list of choices, each with what follows from it."""
    pen = column.pen
    situation = session.match.situation
    inset, pad = pen.px(12), pen.px(5)
    column.line(f"{player_name(session.shown.shooter, session.names)}, choose", TEXT, 17, 6)
    for place, option in enumerate(situation.options):
        picked = place == session.picked
        named = session.call.ball if picked else None
        words = choice_words(session.variant, situation, option, named, session.names)
        about = pen.wrap(words, column.room - 2 * inset, 13) if words else []
        high = pen.line(17) + len(about) * pen.line(13) + 2 * pad
        box = (column.x, column.y, column.room, high)
        fill, edge = (PICKED, GOLD) if picked else (BUTTON, EDGE)
        pen.card(box, fill, edge)
        y = column.y + pad
        name = f"{place + 1}   {option_name(option)}"
        pen.write(name, (column.x + inset, y), TEXT, 17, room=column.room - 2 * inset)
        for number, row in enumerate(about):
            below = y + pen.line(17) + number * pen.line(13)
            pen.write(row, (column.x + inset, below), TONES["plain"], 13)
        column.hot[f"option:{place}"] = box
        column.y += high + pen.px(6)
    column.rule()


def _draw_on(column: Column, session: Session, board: Board, *, letters: bool) -> None:
    """Write what is on, with a dot for each look, and with `letters` what stands on the ball."""
    pen = column.pen
    kinds = [kind for kind in session.variant.balls if kind.id in board.on]
    dot = pen.px(11 if letters else 7)
    told = labels_of(session.variant) if letters else {}
    column.line("ball on", FAINT, 14, 4)
    step = 2 * dot + 4
    in_a_row = max(1, column.room // step)
    looks = _distinct(kinds)
    for place, kind in enumerate(looks):
        row, here = divmod(place, in_a_row)
        middle = column.x + dot + here * step, column.y + dot + row * step
        _draw_dot(pen, middle, dot, kind)
        if letters:
            _draw_label(pen, middle, told[kind.id], kind.colour)
    column.y += (len(looks) - 1) // in_a_row * step + 2 * dot + pen.px(7)
    column.text(board.on_words, GOLD, 17, 3)
    column.rule()


def _draw_told(
    column: Column, title: str, lines: list[Line], rulebook: str, keymap: Keymap, *, fresh: bool
) -> None:
    """Write the referee's words and by which rulebook; brighter while they are new."""
    pen = column.pen
    sizes = {"faint": 14}
    rows = [
        (text, line.tone)
        for line in lines
        for text in pen.wrap(line.text, column.room, sizes.get(line.tone, 16))
    ]
    column.line(title, GOLD if fresh else FAINT, 14, 4)
    row = pen.line(16) + pen.px(1)
    book = pen.wrap(f"by the {rulebook}", column.room, 13) if rulebook else []
    most = max(1, (column.end - column.y - pen.px(12) - len(book) * pen.line(13)) // row)
    if len(rows) > most > 2:
        rows = [*rows[: most - 2], (f"({keymap.shown('why')} tells all of it)", "faint"), rows[-1]]
    for text, tone in rows[:most]:
        colour = TONES[tone] if fresh else _dimmed(pen, TONES[tone])
        pen.write(text, (column.x, column.y), colour, sizes.get(tone, 16), room=column.room)
        column.y += row
    column.y += pen.px(6)
    for text in book:
        if column.y + pen.line(13) < column.end:
            column.line(text, _dimmed(pen, FAINT), 13)


def _distinct(kinds: list[BallKind]) -> list[BallKind]:
    """Return one ball of each look."""
    seen: dict[tuple[object, ...], BallKind] = {}
    for kind in kinds:
        seen.setdefault((kind.colour, kind.pattern, kind.label), kind)
    return list(seen.values())


def _draw_dot(pen: Pen, middle: tuple[int, int], radius: int, kind: BallKind) -> None:
    if kind.pattern == "stripe":
        pygame.draw.circle(pen.surface, CHALK, middle, radius)
        band = (middle[0] - radius + 1, middle[1] - radius // 2, 2 * radius - 2, radius)
        pygame.draw.rect(pen.surface, kind.colour, band, border_radius=2)
    else:
        pygame.draw.circle(pen.surface, kind.colour, middle, radius)
    pygame.draw.circle(pen.surface, pen.tint(FAINT), middle, radius, 1)


def _draw_label(pen: Pen, middle: tuple[int, int], label: str, colour: Colour) -> None:
    """Write a ball's label on its dot, in black or white."""
    ink = max(((12, 12, 14), (250, 250, 248)), key=lambda one: contrast(one, colour))
    size = 12 if len(label) < 3 else 9
    pen.write(label, (middle[0], middle[1] - pen.line(size) // 2), ink, size, "middle")


def _dimmed(pen: Pen, colour: tuple[int, int, int]) -> tuple[int, int, int]:
    """Return a colour nearer to its ground."""
    mixed = zip(pen.tint(colour), pen.tint(PANEL), strict=True)
    red, green, blue = (round(0.75 * part + 0.25 * ground) for part, ground in mixed)
    return red, green, blue
