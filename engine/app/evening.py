"""An evening at the table: a game is chosen, played and left, and another one is chosen.

One idea: one window stays open for all of it, and what is prepared once (kernels, renderers)
serves every game. Invariant: a match that is left is kept in its journal.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from time import monotonic
from typing import TYPE_CHECKING

import pygame

from engine.app.hud import scale_for
from engine.app.inputs import LEFT, ButtonPressed, CloseAsked, Input
from engine.app.lobby import change, choose, hear, pick
from engine.app.lobby_screen import LobbyScreen
from engine.app.opening import open_variant
from engine.app.pen import Pen
from engine.app.screen import within
from engine.app.settings import Settings
from engine.variant.library import VariantError

if TYPE_CHECKING:
    from collections.abc import Callable

    from engine.app.inputs import InputEvent
    from engine.app.lobby import Lobby
    from engine.app.startup import Startup
    from engine.app.window import Window
    from engine.variant.variant import Variant

PAUSE = 0.12
"""Seconds that a game is picked before it is loaded."""


@dataclass(slots=True)
class Reception:
    """The start screen in a window, until a game is chosen or the player leaves."""

    window: Window
    lobby: Lobby
    startup: Startup
    settings: Settings = field(default_factory=Settings)
    hands: Input = field(default_factory=Input)
    screen: LobbyScreen = field(init=False)
    _cards: dict[str, Variant | str] = field(default_factory=dict)
    _since: float = field(default_factory=monotonic)

    def __post_init__(self) -> None:
        self.screen = LobbyScreen(Pen(self.window.surface, theme=self.settings.theme))

    def run(self, each: Callable[[Reception], None] | None = None) -> Lobby:
        """Return the start screen as it was left; `each` is called before every frame."""
        clock = pygame.time.Clock()
        while self.lobby.chosen is None and not self.lobby.left:
            clock.tick(self.settings.rate)
            if each is not None:
                each(self)
            self.frame(self.window.read())
        return self.lobby

    def frame(self, events: list[InputEvent]) -> None:
        """Do one frame: take in `events`, load the game picked, draw."""
        self.hands.feed(events)
        before = self.lobby.entry
        if any(isinstance(event, CloseAsked) for event in events):
            self.lobby = replace(self.lobby, left=True)
            return
        if any(self.settings.keymap.has("full-screen", key) for key in self.hands.pressed):
            self.window.toggle_full_screen()
        self.lobby = hear(self.lobby, self.hands)
        for event in events:
            if isinstance(event, ButtonPressed) and event.button == LEFT:
                self.lobby = self._clicked(event.place)
        if self.lobby.entry != before:
            self._since = monotonic()
        self._load()
        self.screen.pen.surface = self.window.surface
        self.screen.pen.scale = scale_for(self.window.size, self.settings.text)
        self.screen.draw(self.lobby, self.startup.saying)
        self.window.show()

    def _clicked(self, place: tuple[int, int]) -> Lobby:
        hot = self.screen.hot.items()
        name = next((name for name, box in hot if within(box, place)), "")
        kind, _, rest = name.partition(":")
        match kind:
            case "pick" if int(rest) == self.lobby.picked:
                return choose(self.lobby)
            case "pick":
                return pick(self.lobby, int(rest))
            case "set":
                row, _, sign = rest.rpartition(":")
                return change(self.lobby, row, int(sign))
            case "mark":
                return replace(self.lobby, row=self.lobby.rows.index(rest))
            case "play":
                return choose(self.lobby)
        return self.lobby

    def _load(self) -> None:
        """Load the game picked, once it has been picked for a moment."""
        one = self.lobby.entry
        if one is None or self.lobby.card is not None or self.lobby.trouble:
            return
        if one.name not in self._cards:
            if monotonic() - self._since < PAUSE:
                return
            self._cards[one.name] = _card(one.name)
        card = self._cards[one.name]
        if isinstance(card, str):
            self.lobby = replace(self.lobby, trouble=card)
        else:
            self.lobby = replace(self.lobby, card=card)


def _card(name: str) -> Variant | str:
    """Return a game as loaded, or why it cannot be."""
    try:
        return open_variant(name)
    except VariantError as trouble:
        return str(trouble)
