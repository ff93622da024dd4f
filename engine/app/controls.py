"""From hands to wishes: what keys and mouse together ask for in a frame.

One idea: given the input, the session and where things are on the screen, this answers a list
of values; it changes nothing itself.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from engine.app.keyboard import Keyboard
from engine.app.pointer import Pointer

if TYPE_CHECKING:
    from collections.abc import Sequence

    from engine.app.inputs import Input, InputEvent
    from engine.app.screen import Screen
    from engine.app.session import Session
    from engine.app.wishes import Wish


@dataclass(slots=True)
class Controls:
    """The player's hands over time."""

    keyboard: Keyboard = field(default_factory=Keyboard)
    pointer: Pointer = field(default_factory=Pointer)

    def read(
        self,
        hands: Input,
        events: Sequence[InputEvent],
        session: Session,
        screen: Screen,
        seconds: float,
    ) -> list[Wish]:
        """Return what is asked for in this frame."""
        wishes = self.keyboard.read(hands, session, screen, seconds)
        return wishes + self.pointer.read(hands, events, session, screen)
