"""The window: opened by pygame, asked for events, lending its memory to the renderers.

One idea: pygame's events become plain values here, once; nothing else of the game reads them.
"""

from __future__ import annotations

import gc
import os
from dataclasses import dataclass
from time import sleep
from typing import TYPE_CHECKING

import pygame
import pygame.freetype

from engine.app import inputs

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    import numpy as np
    from numpy.typing import NDArray

SMALLEST = (480, 320)
PATIENCE = 40
"""Half milliseconds that memory lent is waited for."""


class NoWindowError(RuntimeError):
    """No window can be opened here; the message says what the system said."""


@dataclass(slots=True)
class Window:
    """The window's surface, 32 bits a pixel."""

    surface: pygame.Surface
    _before: tuple[int, int] | None = None
    """The size to go back to from the full screen."""

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in pixels."""
        return self.surface.get_size()

    def read(self) -> list[inputs.InputEvent]:
        """Return what happened since the last call, in order; takes up a new size."""
        found: list[inputs.InputEvent] = []
        for event in pygame.event.get():
            if event.type == pygame.VIDEORESIZE and not self.is_full:
                wanted = max(event.w, SMALLEST[0]), max(event.h, SMALLEST[1])
                self.surface = pygame.display.get_surface() or self.surface
                if wanted != self.size:
                    self.surface = _set_mode(wanted)
            found += translate(event)
        return found

    def part(self, box: tuple[int, int, int, int]) -> NDArray[np.uint32]:
        """Lend a box of the window's memory as (height, width) uint32 0x00RRGGBB.

        Nothing else may draw in the window while the array is kept.
        """
        left, top, width, height = box
        rows: NDArray[np.uint32] = pygame.surfarray.pixels2d(self.surface).T
        return rows[top : top + height, left : left + width]

    def take_back(self) -> None:
        """See to it that the memory lent is given back, before anything else draws.

        A renderer's thread may hold on to it for a moment after its work is done.
        """
        for _ in range(PATIENCE):
            if not self.surface.get_locked():
                return
            sleep(0.0005)
        gc.collect()

    def entitle(self, title: str) -> None:
        """Write a title on the window's frame."""
        pygame.display.set_caption(title)

    @property
    def is_full(self) -> bool:
        """Whether the window fills the screen."""
        return self._before is not None

    def toggle_full_screen(self) -> None:
        """Fill the screen, or go back to the size before."""
        if self._before is not None:
            size, self._before = self._before, None
            _set_mode(size)  # the first leaves the full screen, the second takes up the size
            self.surface = _set_mode(size)
            pygame.event.clear(pygame.VIDEORESIZE)
            return
        self._before = self.size
        sizes = pygame.display.get_desktop_sizes()
        screen = sizes[0] if sizes else self.size
        self.surface = pygame.display.set_mode(screen, pygame.FULLSCREEN, 32)

    def save(self, path: Path) -> None:
        """Write what was shown last as a picture; raises OSError."""
        path.parent.mkdir(parents=True, exist_ok=True)
        try:
            pygame.image.save(self.surface, path)
        except pygame.error as trouble:
            raise OSError(str(trouble)) from trouble

    def show(self) -> None:
        """Bring what was drawn to the screen."""
        pygame.display.flip()


def open_window(size: tuple[int, int], title: str) -> Window:
    """Return a new window; raises NoWindowError where there is no screen to open one on."""
    os.environ.setdefault("SDL_FRAMEBUFFER_ACCELERATION", "0")
    try:
        pygame.display.init()
        pygame.freetype.init()
        pygame.display.set_caption(title)
        surface = _set_mode(size)
    except pygame.error as trouble:
        raise NoWindowError(str(trouble)) from trouble
    return Window(surface)


def close_window() -> None:
    """Close the window and leave pygame as it was before."""
    pygame.quit()


def _set_mode(size: tuple[int, int]) -> pygame.Surface:
    return pygame.display.set_mode(size, pygame.RESIZABLE, 32)


def translate(event: pygame.event.Event) -> Iterator[inputs.InputEvent]:
    """Yield what a pygame event means for the input service."""
    match event.type:
        case pygame.KEYDOWN:
            yield inputs.KeyPressed(key_name(event.key))
        case pygame.KEYUP:
            yield inputs.KeyReleased(key_name(event.key))
        case pygame.TEXTINPUT:
            yield inputs.Typed(event.text)
        case pygame.MOUSEMOTION:
            yield inputs.MouseMoved(event.pos)
        case pygame.MOUSEBUTTONDOWN if event.button <= inputs.RIGHT:
            yield inputs.ButtonPressed(event.button, event.pos)
        case pygame.MOUSEBUTTONUP if event.button <= inputs.RIGHT:
            yield inputs.ButtonReleased(event.button, event.pos)
        case pygame.MOUSEWHEEL:
            yield inputs.Wheeled(event.y)
        case pygame.WINDOWFOCUSLOST:
            yield inputs.FocusLost()
        case pygame.QUIT:
            yield inputs.CloseAsked()


KEYPAD = {"+": "=", "-": "-"}


def key_name(code: int) -> str:
    """Return the lower-case name of a key; the keypad's keys are those of the main field."""
    name = pygame.key.name(code).lower()
    if name.startswith("[") and name.endswith("]") and len(name) == 3:
        return KEYPAD.get(name[1], name[1])
    return name
