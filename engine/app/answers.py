"""What is asked of the window rather than of the game: views, pages, pictures, practice, leaving.

One idea: each request has a name; what answers it is found here. Invariant: nothing here changes a
match, but for a layout that is laid out, which begins another one.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from engine.app.arranging import LayoutError
from engine.app.judging import why_not
from engine.app.pages import Page
from engine.app.panel import ClothPanel, facts_panel
from engine.app.practising import lay
from engine.app.session import SHOWING
from engine.app.view import struck_ball

if TYPE_CHECKING:
    from engine.app.loop import Loop
    from engine.app.wishes import Ask
    from engine.table.furniture import BallId

TEXT_SIZES = (1.0, 1.2, 1.45, 0.85)


def answer(loop: Loop, ask: Ask) -> None:
    """Do what is asked for by name; an unknown name asks for nothing."""
    match ask.action:
        case "wireframe" | "painter" | "scanline":
            loop.renderer = ask.action
        case "camera":
            loop.view = loop.view.next_camera()
        case "follow":
            loop.view = loop.view.following(_balls_seen(loop))
        case "full-screen":
            loop.window.toggle_full_screen()
        case "letters":
            loop.letters = not loop.letters
            loop.build_stage()
        case "zoom":
            loop.view = loop.view.zoomed(ask.amount)
        case "orbit":
            loop.view = loop.view.orbited(ask.amount, 0.0)
        case "tilt":
            loop.view = loop.view.orbited(0.0, ask.amount)
        case "text":
            now = TEXT_SIZES.index(loop.text) if loop.text in TEXT_SIZES else -1
            loop.text = TEXT_SIZES[(now + 1) % len(TEXT_SIZES)]
        case "sound":
            loop.speaker.muted = not loop.speaker.muted
            loop.note("sound off" if loop.speaker.muted else "sound on")
        case "help" | "why" | "rules" | "menu":
            loop.page, loop.scroll, loop.panel = Page[ask.action.upper()], 0, None
        case "facts" | "cloth":
            _open_panel(loop, Page[ask.action.upper()])
        case value if value.startswith("value-") and loop.panel is not None:
            loop.scroll = int(value.removeprefix("value-"))
            loop.panel = loop.panel.stepped(loop.scroll, 1)
        case "picture" | "clip" | "paths":
            _export(loop, ask.action)
        case "save":
            loop.page = None
            loop.note(loop.keeper.save_shot(loop.session.match))
        case "keep":
            loop.note(loop.keeper.keep_layout(loop.session))
        case "lay":
            _lay(loop)
        case "resume":
            loop.page = None
        case "games":
            loop.running, loop.wants_another = False, True
        case "quit":
            loop.running = False


def _balls_seen(loop: Loop) -> list[BallId]:
    """Return the balls that can be followed, the one struck left out."""
    struck = struck_ball(loop.session)
    there = loop.session.layout
    return [
        kind.id for kind in loop.session.variant.balls if kind.id in there and kind.id != struck
    ]


def _export(loop: Loop, kind: str) -> None:
    """Save what is seen, or begin to make a picture of the last shot."""
    loop.page = None
    if kind == "picture":
        loop.picture_due = True
    else:
        loop.note(loop.exporter.begin(kind, loop.session.match))


def _lay(loop: Loop) -> None:
    """Lay out the next layout that was kept, or say why not."""
    if loop.session.mode in SHOWING:
        return
    try:
        found = loop.keeper.next_layout(loop.session)
    except LayoutError as trouble:
        loop.note(str(trouble))
        return
    if found is None:
        loop.note("no layout of this game was kept")
        return
    name, situation = found
    loop.enter(lay(loop.session, situation))
    loop.note(f"laid out: {name}")


def _open_panel(loop: Loop, page: Page) -> None:
    """Open a page on which something can be set, or say why not."""
    refused = why_not(loop.session) if page is Page.FACTS else ""
    if loop.session.mode in SHOWING:
        refused = "wait until the balls have come to rest"
    loop.page = None if refused else page
    loop.scroll = 0
    if refused:
        loop.note(refused)
    elif page is Page.FACTS:
        loop.panel = facts_panel(loop.session)
    else:
        loop.panel = ClothPanel(loop.session.variant.world, loop.units)
