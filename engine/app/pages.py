"""Pages over the picture: the keys, the referee's full explanation, the menu.

One idea: a page is a title and lines; how it is drawn and scrolled is the same for all.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING

from engine.app import keys
from engine.app.pen import TONES
from engine.app.telling import explanation_lines, rules_lines
from engine.app.theme import FAINT, GOLD, MARKED, PICKED, TEXT
from engine.app.words import Line, player_name

if TYPE_CHECKING:
    from engine.app.hud import Hud
    from engine.app.keymap import Keymap
    from engine.app.panel import Panel
    from engine.app.session import Session


class Page(Enum):
    """The page that lies over the picture."""

    HELP = "Keys"
    WHY = "What the referee looked at"
    RULES = "The rules"
    FACTS = "What an eye saw"
    CLOTH = "Friction and restitution"
    MENU = "Menu"


@dataclass(frozen=True, slots=True)
class Row:
    """A row of a page: a line, with a second column where `keys` is not empty."""

    line: Line
    keys: str = ""
    hot: str = ""


MENU = (
    ("resume", "Go on playing"),
    ("help", "Keys"),
    ("why", "The referee's explanation"),
    ("rules", "The rules of this game"),
    ("facts", "What an eye saw of the last shot"),
    ("cloth", "Friction and restitution"),
    ("save", "Save the last shot as a record"),
    ("clip", "Save the last shot as a moving picture"),
    ("paths", "Save the ways of the last shot"),
    ("picture", "Save what is seen as a picture"),
    ("games", "Another game (the match is kept)"),
    ("quit", "Quit (the match is kept)"),
)


PICKING = (Page.MENU, Page.FACTS, Page.CLOTH)
"""Pages on which a row is picked."""


def rows_of(page: Page, session: Session, keymap: Keymap, panel: Panel | None = None) -> list[Row]:
    """Return what a page says."""
    if panel is not None:
        rows = [
            Row(Line(f"<  {value}  >", "head"), name, f"ask:value-{place}")
            for place, (name, value) in enumerate(panel.rows)
        ]
        return [*rows, Row(Line("")), *(Row(Line(text, "faint")) for text in panel.about)]
    if page is Page.HELP:
        return _help(keymap)
    if page is Page.WHY:
        return _why(session)
    if page is Page.RULES:
        return [Row(line) for line in rules_lines(session.variant)]
    return [Row(Line(text), hot=f"ask:{name}") for name, text in MENU]


def _why(session: Session) -> list[Row]:
    """Return how every rule fared in the stroke that was judged last."""
    last = session.last_judged
    if last is None:
        return [Row(line) for line in explanation_lines(())]
    number = session.match.played.index(last) + 1
    who = player_name(last.before.shooter, session.names)
    title = f"Shot {number}, {who}, by the {session.variant.rulebook}"
    told = explanation_lines(last.verdict.explanation)
    marks = "+ it spoke   - it was silent, and why   x another rule overrode it"
    return [Row(line) for line in (Line(title, "good"), Line(marks, "faint"), *told)]


def _help(keymap: Keymap) -> list[Row]:
    rows: list[Row] = []
    for group in keys.groups():
        rows += [Row(Line(""))] if rows else []
        rows.append(Row(Line(group, "head")))
        for one in keymap.bindings:
            if one.group == group:
                fine = "; Shift: fine" if one.takes == "shift" else ""
                rows.append(Row(Line(one.about + fine), one.shown))
    rows += [Row(Line("")), Row(Line("Mouse", "head"))]
    rows += [Row(Line(about), what) for what, about in keys.MOUSE]
    return rows


def draw_page(
    hud: Hud, page: Page, session: Session, scroll: int, panel: Panel | None = None
) -> int:
    """Draw a page, scrolled by rows or with that row picked; return how far that can go."""
    pen = hud.pen
    width, height = pen.surface.get_size()
    wide = min(pen.px(440 if page is Page.MENU else 860), width - 24)
    rows = _wrapped(hud, rows_of(page, session, hud.keymap, panel), wide)
    picking = page in PICKING
    step = pen.line(16) + pen.px(12 if picking else 3)
    most = max(1, (height - pen.px(110)) // step)
    last = max(0, len(rows) - most)
    first = min(max(scroll, 0), last)
    count = sum(bool(row.hot) for row in rows)
    picked = min(max(scroll, 0), count - 1) if picking else -1
    shown = rows[first : first + most]
    high = step * len(shown) + pen.px(70)
    left, top = (width - wide) // 2, (height - high) // 2
    pen.veil()
    pen.panel((left, top, wide, high), 255)
    pen.write(page.value, (left + pen.px(20), top + pen.px(12)), TEXT, 21)
    ending = "Esc closes"
    if panel is not None:
        ending = "Left / Right change   Enter accepts   Esc leaves it"
    elif last:
        ending = f"wheel or arrows scroll {first + 1}/{last + 1}   Esc closes"
    pen.write(ending, (left + wide - pen.px(20), top + pen.px(17)), FAINT, 13, "right")
    hud.hot.clear()
    for place, row in enumerate(shown):
        _draw_row(
            hud,
            row,
            (left + pen.px(20), top + pen.px(52) + place * step, wide, step),
            picked == first + place,
        )
    return count - 1 if picking else last


def _wrapped(hud: Hud, rows: list[Row], wide: int) -> list[Row]:
    pen = hud.pen
    column = pen.px(240)
    found = []
    for row in rows:
        room = wide - pen.px(40) - (column if row.keys else 0)
        for number, text in enumerate(pen.wrap(row.line.text, room, 16)):
            found.append(
                Row(Line(text, row.line.tone), row.keys if number == 0 else " ", row.hot)
                if row.keys
                else Row(Line(text, row.line.tone), "", row.hot)
            )
    return found


def _draw_row(hud: Hud, row: Row, box: tuple[int, int, int, int], picked: bool) -> None:  # noqa: FBT001
    pen = hud.pen
    x, y, wide, step = box
    if row.hot:
        place = x, y - pen.px(4), wide - pen.px(40), step - 2
        pen.card(place, PICKED if picked else MARKED, GOLD if picked else None)
        hud.hot[row.hot] = place
        x += pen.px(12)
    if row.keys:
        pen.write(row.keys, (x, y), GOLD, 16, room=pen.px(230))
        x += pen.px(240)
    pen.write(row.line.text, (x, y), TONES[row.line.tone], 16)
