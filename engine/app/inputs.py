"""The input service: which keys are held, where the mouse is, what was pressed this frame.

One idea: events go in as plain values, questions are answered from them; no window is needed.
Invariant: a key is held from its press to its release, or until the window loses the focus.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

Place = tuple[int, int]
"""Pixels from the window's upper left corner."""

SHIFTS = frozenset({"left shift", "right shift"})
LEFT, MIDDLE, RIGHT = 1, 2, 3


@dataclass(frozen=True, slots=True)
class KeyPressed:
    """A key went down; `key` is its lower-case name."""

    key: str


@dataclass(frozen=True, slots=True)
class KeyReleased:
    """A key came up."""

    key: str


@dataclass(frozen=True, slots=True)
class Typed:
    """Text was typed, as the keyboard's layout has it."""

    text: str


@dataclass(frozen=True, slots=True)
class MouseMoved:
    """The mouse is now at `place`."""

    place: Place


@dataclass(frozen=True, slots=True)
class ButtonPressed:
    """A mouse button went down at `place`; 1 left, 2 middle, 3 right."""

    button: int
    place: Place


@dataclass(frozen=True, slots=True)
class ButtonReleased:
    """A mouse button came up at `place`."""

    button: int
    place: Place


@dataclass(frozen=True, slots=True)
class Wheeled:
    """The wheel turned by `notches`, away from the player positive."""

    notches: int


@dataclass(frozen=True, slots=True)
class FocusLost:
    """The window no longer hears the keyboard."""


@dataclass(frozen=True, slots=True)
class CloseAsked:
    """The player closed the window."""


InputEvent = (
    KeyPressed
    | KeyReleased
    | Typed
    | MouseMoved
    | ButtonPressed
    | ButtonReleased
    | Wheeled
    | FocusLost
    | CloseAsked
)


@dataclass(slots=True)
class Input:
    """What the player's hands do, as of the last `feed`."""

    held: set[str] = field(default_factory=set)
    buttons: set[int] = field(default_factory=set)
    mouse: Place = (0, 0)
    pressed: list[str] = field(default_factory=list)
    typed: str = ""
    wheel: int = 0
    moved: Place = (0, 0)
    """How far the mouse went since the frame before."""

    def feed(self, events: Iterable[InputEvent]) -> None:
        """Take in one frame's events, in their order."""
        self.pressed, self.typed, self.wheel, before = [], "", 0, self.mouse
        for event in events:
            self._take(event)
        self.moved = (self.mouse[0] - before[0], self.mouse[1] - before[1])

    def _take(self, event: InputEvent) -> None:
        match event:
            case KeyPressed(key):
                self.held.add(key)
                self.pressed.append(key)
            case KeyReleased(key):
                self.held.discard(key)
            case Typed(text):
                self.typed += text
            case MouseMoved(place):
                self.mouse = place
            case ButtonPressed(button, place):
                self.buttons.add(button)
                self.mouse = place
            case ButtonReleased(button, place):
                self.buttons.discard(button)
                self.mouse = place
            case Wheeled(notches):
                self.wheel += notches
            case FocusLost() | CloseAsked():
                self.held.clear()
                self.buttons.clear()

    def down(self, *keys: str) -> bool:
        """Whether one of `keys` is held."""
        return not self.held.isdisjoint(keys)

    @property
    def shift(self) -> bool:
        """Whether a shift key is held."""
        return not self.held.isdisjoint(SHIFTS)

    def axis(self, lower: str, higher: str) -> int:
        """Return -1, 0 or 1 from two keys; both at once cancel."""
        return int(higher in self.held) - int(lower in self.held)

    @property
    def horizontal(self) -> int:
        """The arrows left and right as -1, 0, 1."""
        return self.axis("left", "right")

    @property
    def vertical(self) -> int:
        """The arrows down and up as -1, 0, 1."""
        return self.axis("down", "up")

    @property
    def horizontal_wasd(self) -> int:
        """A and D as -1, 0, 1."""
        return self.axis("a", "d")

    @property
    def vertical_wasd(self) -> int:
        """S and W as -1, 0, 1."""
        return self.axis("s", "w")
