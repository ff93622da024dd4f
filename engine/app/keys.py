"""Every key of the game, as data: what it does, in which words, and how it is named.

One idea: this table is the only place that knows a key; the help page, the documentation, the
controls and the player's own keys (keymap) start from it. Invariant: an action has one name,
and no key does two things at once in one mode.
"""

from __future__ import annotations

from dataclasses import dataclass

ALWAYS, AIMING, PLACING, CHOOSING, SHIFTED = "always", "aiming", "placing", "choosing", "shifted"


@dataclass(frozen=True, slots=True)
class Binding:
    """An action with the keys (by SDL's names, lower case) that ask for it."""

    action: str
    keys: tuple[str, ...]
    shown: str
    about: str
    group: str
    takes: str = ""
    """The modifier that changes it, "shift" where shift makes it fine."""
    when: str = ALWAYS
    """When the keys are heard; SHIFTED ones only with Shift."""
    ordered: bool = False
    """Whether each key has a meaning of its own, by its place: left and right, up and down."""


AIM, TABLE, SAY, VIEW, GAME = "Aiming", "Placing the ball", "Calls and choices", "View", "Game"
PRACTICE, SHOWN = "Practice", "While a shot is shown"

BINDINGS: tuple[Binding, ...] = (
    Binding(
        "turn",
        ("left", "right"),
        "Left / Right",
        "turn the aim",
        AIM,
        "shift",
        AIMING,
        ordered=True,
    ),
    Binding(
        "power",
        ("up", "down"),
        "Up / Down",
        "strike harder, softer",
        AIM,
        "shift",
        AIMING,
        ordered=True,
    ),
    Binding(
        "spin",
        ("w", "a", "s", "d"),
        "W A S D",
        "move the tip on the ball",
        AIM,
        "shift",
        AIMING,
        ordered=True,
    ),
    Binding("centre", ("x",), "X", "tip back to the centre, cue level", AIM),
    Binding(
        "elevate",
        ("e", "q"),
        "E / Q",
        "raise, lower the butt of the cue",
        AIM,
        "shift",
        AIMING,
        ordered=True,
    ),
    Binding("struck", ("k",), "K", "strike another ball, where the rules allow it", AIM),
    Binding(
        "aid", ("t",), "T", "aiming aid: off, line, ghost ball, the ball's path, all paths", AIM
    ),
    Binding(
        "confirm",
        ("space", "return", "enter"),
        "Space, Enter",
        "strike; accept; go on; halt what is shown",
        AIM,
    ),
    Binding(
        "move",
        ("left", "right", "up", "down"),
        "Arrows",
        "move the ball",
        TABLE,
        "shift",
        PLACING,
        ordered=True,
    ),
    Binding(
        "back",
        ("b", "backspace"),
        "B",
        "back to the placing or the call, to the match as it was",
        TABLE,
    ),
    Binding("ball", ("tab",), "Tab", "call the next ball (with Shift: the one before)", SAY),
    Binding("pocket", ("p",), "P", "call the next pocket (with Shift: the one before)", SAY),
    Binding("safety", ("o",), "O", "call a safety, or take it back", SAY),
    Binding("group", ("g",), "G", "call a group, or the next one", SAY),
    Binding(
        "pick",
        ("up", "down"),
        "Up / Down",
        "go through the choices",
        SAY,
        when=CHOOSING,
        ordered=True,
    ),
    Binding(
        "choose",
        ("1", "2", "3", "4", "5", "6", "7", "8", "9"),
        "Shift + 1 to 9",
        "take a choice by its number",
        SAY,
        when=SHIFTED,
        ordered=True,
    ),
    Binding("why", ("h",), "H", "the referee's full explanation", SAY),
    Binding("facts", ("z",), "Z", "tell what an eye saw of the last shot; it is judged again", SAY),
    Binding("wireframe", ("1",), "1", "draw as a wireframe", VIEW),
    Binding("painter", ("2",), "2", "draw by the painter's algorithm", VIEW),
    Binding("scanline", ("3",), "3", "draw by scanlines with a z-buffer", VIEW),
    Binding(
        "camera",
        ("c",),
        "C",
        "camera: from the cue, from above, free orbit, along with a ball",
        VIEW,
    ),
    Binding(
        "orbit",
        (",", "."),
        ", / .",
        "turn the free camera, or the one along with a ball",
        VIEW,
        ordered=True,
    ),
    Binding(
        "tilt",
        ("page up", "page down"),
        "PgUp / PgDn",
        "raise, lower the camera",
        VIEW,
        ordered=True,
    ),
    Binding(
        "zoom", ("=", "-"), "+ / -", "nearer, farther (also the mouse wheel)", VIEW, ordered=True
    ),
    Binding("sound", ("m",), "M", "sound on or off", VIEW),
    Binding("full-screen", ("f11",), "F11", "fill the screen, or no longer", VIEW),
    Binding("letters", ("f4",), "F4", "numbers and letters on every ball, or no longer", VIEW),
    Binding("text", ("f3",), "F3", "size of the text", VIEW),
    Binding("arrange", ("i",), "I", "put balls anywhere; once more to play from there", PRACTICE),
    Binding("take-off", ("delete",), "Delete", "take the ball off, or bring it back", PRACTICE),
    Binding("repeat", ("v",), "V", "the last stroke once more, from where the balls lay", PRACTICE),
    Binding("keep", ("f6",), "F6", "keep the layout", PRACTICE),
    Binding("lay", ("f7",), "F7", "lay out the next layout that was kept", PRACTICE),
    Binding("cloth", ("f10",), "F10", "friction and restitution: look, change, practise", PRACTICE),
    Binding("replay", ("r",), "R", "see the last shot again (with Shift: slowly)", SHOWN),
    Binding("fast", ("f",), "F", "skip to the end", SHOWN),
    Binding("step", ("'",), "'", "a single step on", SHOWN),
    Binding("step-back", (";",), ";", "a single step back", SHOWN),
    Binding("slower", ("[",), "[", "slower", SHOWN),
    Binding("faster", ("]",), "]", "faster", SHOWN),
    Binding("help", ("f1",), "F1", "this page", GAME),
    Binding("rules", ("f2",), "F2", "the rules of the game, as its script has them", GAME),
    Binding("save", ("f5",), "F5", "save the last shot as a record", GAME),
    Binding("clip", ("f8",), "F8", "save the last shot as a moving picture (GIF)", GAME),
    Binding("paths", ("f9",), "F9", "save the ways of the last shot as a picture", GAME),
    Binding("picture", ("f12",), "F12", "save what is seen as a picture", GAME),
    Binding("undo", ("u",), "U", "take the last shot back", GAME),
    Binding("redo", ("y",), "Y", "play the shot taken back again", GAME),
    Binding("next", ("n",), "N", "next game, when one is over", GAME),
    Binding("menu", ("escape",), "Esc", "close a page; menu and quit", GAME),
)

MOUSE: tuple[tuple[str, str], ...] = (
    ("Left click on the cloth", "aim there; place the ball there; call that ball or pocket"),
    ("Click a button below the table", "what it says: strike, accept, go on, back, undo"),
    ("Left drag", "turn the aim"),
    ("Right drag back, let go", "draw the cue back and strike"),
    ("Middle drag", "turn the free camera"),
    ("Wheel", "zoom; scroll a page"),
    ("Click the gauges", "power, tip on the ball, raised cue"),
)


def binding(action: str) -> Binding:
    """Return the binding of an action; raises KeyError for an action that does not exist."""
    for one in BINDINGS:
        if one.action == action:
            return one
    raise KeyError(action)


def groups() -> tuple[str, ...]:
    """Return the groups in the order of the help page."""
    return tuple(dict.fromkeys(one.group for one in BINDINGS))
