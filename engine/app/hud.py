"""The display round the picture: a bar above, a bar below, a column beside it.

One idea: what is said comes from `words`, where it stands is decided here, and what can be
clicked is handed back by name. Invariant: nothing of it covers the picture while
there is something to be played.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import pygame

from engine.app.pen import BAD, EDGE, FAINT, GOLD, GOOD, TEXT, TONES, Pen
from engine.app.session import SHOWING, Mode
from engine.app.stroke import FASTEST, STEEPEST
from engine.app.words import Board, Line, board_of, player_name, result_words, spoken, verdict_lines

if TYPE_CHECKING:
    from engine.app.controls import Box
    from engine.app.session import Session
    from engine.variant.variant import BallKind

TOP, BOTTOM, SIDE = 58, 92, 300
"""Heights of the bars and width of the column, in text pixels."""
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
        return 0, top, max(width - self._side(), 16), max(height - top - bottom, 16)

    def _side(self) -> int:
        return min(self.pen.px(SIDE), round(0.32 * self.pen.surface.get_width()))

    def draw(self, session: Session, status: str) -> None:
        """Draw the whole display for a session; `status` is said in the upper right corner."""
        self.hot.clear()
        board = board_of(session)
        self._top(board, status)
        self._bottom(session, board)
        self._column(session, board)
        if session.mode is Mode.OVER:
            self._banner(session)

    def _top(self, board: Board, status: str) -> None:
        pen = self.pen
        width, height = pen.surface.get_width(), pen.px(TOP)
        pen.panel((0, 0, width, height), 255, None)
        pygame.draw.line(pen.surface, EDGE, (0, height - 1), (width, height - 1))
        edge = pen.px(14)
        third = width // 5
        pen.write(board.title, (edge, pen.px(8)), TEXT, 21, room=third - edge)
        pen.write(board.phase, (edge, pen.px(34)), FAINT, 15, room=third - edge)
        self._players(board, third, width - third)
        pen.write(status, (width - edge, pen.px(12)), FAINT, 13, "right", room=third)
        pen.write("F1 keys   Esc menu", (width - edge, pen.px(34)), FAINT, 13, "right", room=third)

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
        said = pen.wrap(second, room, 16)[:2]
        if len(said) < 2:
            pen.write(board.hint, (edge, top + pen.px(64)), FAINT, 14, room=room)
        for place, text in enumerate(said):
            pen.write(text, (edge, top + pen.px(37 + 25 * place)), GOLD, 16, room=room)
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
        ball = pen.px(36)
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
            pygame.draw.line(surface, (206, 202, 188), ends[0], ends[1])
        place = (
            middle[0] + round(stroke.side * radius),
            middle[1] - round(stroke.follow * radius),
        )
        pygame.draw.circle(surface, (40, 90, 190), place, max(4, radius // 6))

    def _banner(self, session: Session) -> None:
        """Say over the picture who has won."""
        pen = self.pen
        left, top, width, _ = self.picture_box()
        said = result_words(session.match.situation)
        wide = pen.width(said, 28) + pen.px(60)
        box = (left + (width - wide) // 2, top + pen.px(24), wide, pen.px(62))
        pen.panel(box, 225, GOLD)
        pen.write(said, (left + width // 2, box[1] + pen.px(15)), GOLD, 28, "middle")

    def _column(self, session: Session, board: Board) -> None:
        """Draw the column: what is on, what may be chosen, what the referee said last."""
        pen = self.pen
        _, top, left, height = self.picture_box()
        wide = self._side()
        pen.panel((left, top, wide, height), 255, None)
        pygame.draw.line(pen.surface, EDGE, (left, top), (left, top + height))
        x, room = left + pen.px(14), wide - pen.px(28)
        y = top + pen.px(12)
        if session.mode is Mode.CHOOSING:
            y = self._choices(session, (x, y), room)
        elif board.on_words:
            y = self._on(session, board, (x, y), room)
        played = session.match.played
        if session.mode in SHOWING and session.back_to is None:
            played = played[:-1]
        if played:
            lines = verdict_lines(session.variant, played[-1])
            who = player_name(played[-1].before.shooter)
            fresh = session.mode in (Mode.VERDICT, Mode.OVER)
            title = f"Shot {len(played)}, {who}"
            self._told(title, lines, (x, y), room, top + height - y, fresh=fresh)

    def _on(self, session: Session, board: Board, at: tuple[int, int], room: int) -> int:
        """Write what is on with a dot for each look; return where that ends."""
        pen = self.pen
        kinds = [kind for kind in session.variant.balls if kind.id in board.on]
        dot, (x, y) = pen.px(7), at
        pen.write("ball on", (x, y), FAINT, 14)
        y += pen.line(14) + pen.px(4)
        for place, kind in enumerate(_distinct(kinds)[: room // (2 * dot + 4)]):
            _dot(pen, (x + dot + place * (2 * dot + 4), y + dot), dot, kind)
        y += 2 * dot + pen.px(7)
        for text in pen.wrap(board.on_words, room, 17)[:3]:
            pen.write(text, (x, y), GOLD, 17)
            y += pen.line(17)
        return self._rule(x, y, room)

    def _rule(self, x: int, y: int, room: int) -> int:
        pygame.draw.line(
            self.pen.surface, EDGE, (x, y + self.pen.px(8)), (x + room, y + self.pen.px(8))
        )
        return y + self.pen.px(20)

    def _choices(self, session: Session, at: tuple[int, int], room: int) -> int:
        """Draw the list of choices; return where it ends."""
        pen, (x, y) = self.pen, at
        row = pen.line(18) + pen.px(12)
        pen.write(f"{player_name(session.shown.shooter)}, choose", (x, y), TEXT, 17)
        y += pen.line(17) + pen.px(8)
        for place, option in enumerate(session.match.situation.options):
            box = (x, y, room, row - pen.px(4))
            picked = place == session.picked
            colour = (60, 54, 32) if picked else (36, 40, 48)
            pygame.draw.rect(pen.surface, colour, box, border_radius=4)
            pygame.draw.rect(pen.surface, GOLD if picked else EDGE, box, 1, border_radius=4)
            name = f"{place + 1}   {spoken(option)}"
            tone = TEXT if picked else TONES["plain"]
            pen.write(name, (x + pen.px(12), y + pen.px(4)), tone, 18, room=room - pen.px(20))
            self.hot[f"option:{place}"] = box
            y += row
        return self._rule(x, y, room)

    def _told(
        self,
        title: str,
        lines: list[Line],
        at: tuple[int, int],
        room: int,
        height: int,
        *,
        fresh: bool,
    ) -> None:
        """Write the referee's words; brighter while they are new."""
        pen, (x, y) = self.pen, at
        rows = [
            (text, line.tone)
            for line in lines
            for text in pen.wrap(line.text, room, 16 if line.tone != "faint" else 14)
        ]
        row = pen.line(16) + pen.px(1)
        most = max(1, (height - pen.px(42)) // row)
        if len(rows) > most > 2:
            rows = [*rows[: most - 2], ("(H tells all of it)", "faint"), rows[-1]]
        pen.write(title, (x, y), GOLD if fresh else FAINT, 14)
        y += pen.line(14) + pen.px(4)
        for text, tone in rows[:most]:
            size = 14 if tone == "faint" else 16
            colour = TONES[tone] if fresh else _dimmed(TONES[tone])
            pen.write(text, (x, y), colour, size, room=room)
            y += row


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


def _dimmed(colour: tuple[int, int, int]) -> tuple[int, int, int]:
    red, green, blue = (round(part * 0.72) for part in colour)
    return red, green, blue


def _heat(share: float) -> tuple[int, int, int]:
    """Return the colour of the power gauge, from green to red."""
    cold, hot = GOOD, BAD
    red, green, blue = (
        round(a + (b - a) * min(share * 1.3, 1.0)) for a, b in zip(cold, hot, strict=True)
    )
    return red, green, blue
