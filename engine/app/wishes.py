"""What a player may wish for, by the name of an action: of the game, or of the window.

One idea: a key, a button on the screen and a script ask by the same name.
"""

from __future__ import annotations

from dataclasses import dataclass

from engine.app import commands


@dataclass(frozen=True, slots=True)
class Ask:
    """What is asked of the window rather than of the game, by an action's name."""

    action: str
    amount: float = 1.0


Wish = commands.Command | Ask

PLAIN: dict[str, commands.Command] = {
    "confirm": commands.Confirm(),
    "back": commands.Back(),
    "safety": commands.CallSafety(),
    "group": commands.CallNextGroup(),
    "undo": commands.Undo(),
    "redo": commands.Redo(),
    "fast": commands.Skip(),
    "step": commands.StepShown(1),
    "step-back": commands.StepShown(-1),
    "slower": commands.ChangePace(-1),
    "faster": commands.ChangePace(1),
    "next": commands.NextGame(),
    "arrange": commands.Arrange(),
    "take-off": commands.TakeOff(),
    "repeat": commands.Repeat(),
    "aid": commands.ChangeAid(),
}
WINDOW = (
    "wireframe",
    "painter",
    "scanline",
    "camera",
    "full-screen",
    "letters",
    "keep",
    "lay",
    "sound",
    "text",
    "help",
    "rules",
    "save",
    "why",
    "facts",
    "cloth",
    "picture",
    "clip",
    "paths",
    "menu",
)


def wishes_of(action: str, *, shift: bool = False) -> list[Wish]:
    """Return what an action asks for when it is asked for once; nothing where it takes steps."""
    if action == "camera" and shift:
        return [Ask("follow")]
    if action in WINDOW:
        return [Ask(action)]
    if action in PLAIN:
        return [PLAIN[action]]
    sign = -1 if shift else 1
    match action:
        case "ball":
            return [commands.CallNextBall(sign)]
        case "pocket":
            return [commands.CallNextPocket(sign)]
        case "struck":
            return [commands.StrikeNextBall(sign)]
        case "replay":
            return [commands.Replay(0.25 if shift else 1.0)]
        case "centre":
            return [commands.SetTip(0.0, 0.0), commands.SetElevation(0.0)]
    return []
