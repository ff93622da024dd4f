"""What can be done at this moment: the buttons under the picture, and a word on the rest.

One idea: whatever a mode waits for has a button with its key on it, so a game can be played by
mouse alone or by keyboard alone.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from engine.app.session import Mode
from engine.table.furniture import Places

if TYPE_CHECKING:
    from engine.app.keymap import Keymap
    from engine.app.session import Session


@dataclass(frozen=True, slots=True)
class Button:
    """Something to click; `action` is the name of what it asks for, `key` its key."""

    text: str
    action: str
    key: str
    is_main: bool = False


def buttons_of(session: Session, keymap: Keymap) -> list[Button]:
    """Return the buttons of a moment, the one that goes on first."""
    return [
        Button(text, action, keymap.shown(action), is_main=place == 0)
        for place, (text, action) in enumerate(_offered(session))
        if text
    ]


def _offered(session: Session) -> list[tuple[str, str]]:
    wanted = session.wanted
    undo = ("Undo" if session.match.played else "", "undo")
    redo = ("Redo" if session.later else "", "redo")
    why = ("Why" if session.last_judged else "", "why")
    match session.mode:
        case Mode.CHOOSING:
            ball = ("Ball" if session.choosable else "", "ball")
            return [("Take this choice", "confirm"), ball, why, undo, redo]
        case Mode.PLACING:
            return [("Put it down", "confirm"), ("Camera", "camera"), undo, redo]
        case Mode.CALLING:
            return [
                ("Accept the call" if wanted.obliged else "Go on", "confirm"),
                ("Safety" if wanted.safety else "", "safety"),
                ("Ball" if wanted.ball else "", "ball"),
                ("Pocket" if wanted.pocket else "", "pocket"),
                ("Group" if wanted.group else "", "group"),
                ("Back" if session.placing else "", "back"),
                undo,
                redo,
            ]
        case Mode.AIMING:
            back = wanted.anything or session.placing
            return [
                ("Strike", "confirm"),
                (f"Aid: {session.aid.value}", "aid"),
                ("Other ball" if len(session.strikable) > 1 else "", "struck"),
                ("Camera", "camera"),
                ("Back" if back else "", "back"),
                undo,
                redo,
            ]
        case Mode.STRIKING | Mode.ROLLING:
            halt = "Go on" if session.halted else "Halt"
            turns = [
                ("Slower", "slower"),
                ("Faster", "faster"),
                ("Step", "step"),
                ("Again", "replay"),
            ]
            return [("Skip to the end", "fast"), (halt, "confirm"), *turns]
        case Mode.VERDICT:
            return [("Go on", "confirm"), why, ("Replay", "replay"), ("Save", "save"), undo]
        case Mode.OVER:
            after = "New match" if session.match.situation.match_over else "Next game"
            return [(after, "next"), why, ("Replay", "replay"), ("Save", "save"), undo]
        case Mode.ARRANGING:
            held = [("Other ball", "ball"), ("Off / on", "take-off")]
            return [("Play from here", "confirm"), *held, ("As it was", "back")]


def hint_of(session: Session) -> str:
    """Return how the rest is done by mouse and by keys."""
    wanted = session.wanted
    match session.mode:
        case Mode.CHOOSING:
            named = "; click the ball it is about" if session.choosable else ""
            return f"click a choice, or go up and down{named}"
        case Mode.PLACING:
            if session.placing and isinstance(session.placing.zone, Places):
                return "click one of the marked places, or move it with the arrows"
            return "click or drag it within the bright zone, or move it with the arrows"
        case Mode.CALLING:
            things = " and ".join(
                word for word, on in (("a ball", wanted.ball), ("a pocket", wanted.pocket)) if on
            )
            return f"click {things} on the table" if things else ""
        case Mode.ARRANGING:
            return "click a ball and drag it, or Tab and the arrows; F6 keeps the layout"
        case Mode.AIMING:
            return "click or drag to aim; right drag back and let go to strike; arrows, WASD: F1"
    return ""
