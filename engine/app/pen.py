"""Text and simple shapes on a pygame surface, sized by one scale.

One idea: every size is a number of "text pixels" times the scale, so the whole display grows
together. Invariant: a text is rendered once and kept while it is in use.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import pygame
import pygame.freetype

from engine.app.theme import BAD, EDGE, FAINT, GOOD, PANEL, PLAIN, TEXT, THEMES, TROUGH

if TYPE_CHECKING:
    from engine.app.screen import Box
    from engine.app.theme import Colour

TONES = {"head": TEXT, "good": GOOD, "bad": BAD, "plain": PLAIN, "faint": FAINT}
BASE = 17
KEPT = 600
NARROWER = 3
"""Pixels left free in a line, since its width is told by that of its words."""


@dataclass(slots=True)
class Pen:
    """Draws on `surface`; `scale` 1 is for a window 1280 x 720, `theme` is dark or light."""

    surface: pygame.Surface
    scale: float = 1.0
    theme: str = "dark"
    _fonts: dict[int, pygame.freetype.Font] = field(default_factory=dict)
    _widths: dict[tuple[str, int], int] = field(default_factory=dict)
    _texts: dict[tuple[str, int, Colour], pygame.Surface] = field(default_factory=dict)

    def tint(self, colour: Colour) -> Colour:
        """Return what stands for a colour in this theme."""
        return THEMES[self.theme].get(colour, colour)

    def px(self, size: float) -> int:
        """Return text pixels as whole pixels of the window."""
        return max(1, round(size * self.scale))

    def font(self, size: float = BASE) -> pygame.freetype.Font:
        """Return pygame's own font in a size; its letters are evenly spaced when small."""
        pixels = max(9, self.px(size))
        if pixels not in self._fonts:
            font = pygame.freetype.Font(None, 0.94 * pixels)
            font.pad = True
            self._fonts[pixels] = font
        return self._fonts[pixels]

    def line(self, size: float = BASE) -> int:
        """Return the height of a line of text."""
        font = self.font(size)
        return int(font.get_sized_height(float(font.size)))  # type: ignore[arg-type]

    def width(self, text: str, size: float = BASE) -> int:
        """Return the width of a text."""
        key = text, self.px(size)
        if key not in self._widths:
            if len(self._widths) > 8 * KEPT:
                self._widths.clear()
            self._widths[key] = int(self.font(size).get_rect(text).width)
        return self._widths[key]

    def write(
        self,
        text: str,
        place: tuple[int, int],
        colour: Colour = TEXT,
        size: float = BASE,
        align: str = "left",
        room: int | None = None,
    ) -> int:
        """Write a text at its upper left corner, middle or right; return its width.

        With `room`, a text that is too long ends in dots.
        """
        shown = self.fitted(text, size, room) if room is not None else text
        image = self._image(shown, size, colour)
        x = place[0] - {"left": 0, "middle": image.get_width() // 2}.get(align, image.get_width())
        self.surface.blit(image, (x, place[1]))
        return image.get_width()

    def fitted(self, text: str, size: float, room: int) -> str:
        """Return a text cut to `room` pixels, with dots where it is cut."""
        if self.width(text, size) <= room:
            return text
        while text and self.width(text + "...", size) > room:
            text = text[:-1]
        return text.rstrip() + "..."

    def _image(self, text: str, size: float, colour: Colour) -> pygame.Surface:
        key = text, self.px(size), self.tint(colour)
        if key not in self._texts:
            if len(self._texts) > KEPT:
                self._texts.clear()
            self._texts[key] = self.font(size).render(text, self.tint(colour))[0]
        return self._texts[key]

    def wrap(self, text: str, room: int, size: float = BASE) -> list[str]:
        """Return a text as lines no wider than `room`, broken at spaces; an indent is kept."""
        indent = text[: len(text) - len(text.lstrip())]
        start = self.width(f"{indent}.", size) - self.width(".", size) if indent else 0
        space = self.width(". .", size) - 2 * self.width(".", size)
        lines: list[str] = []
        now, wide = indent, start
        for word in text.split():
            own = self.width(word, size)
            if now.strip() and wide + space + own > room - NARROWER:
                lines.append(now)
                now, wide = indent, start
            wide += own + (space if now.strip() else 0)
            now = f"{now} {word}" if now.strip() else indent + word
        return [*lines, now]

    def panel(self, box: Box, alpha: int = 235, edge: Colour | None = EDGE) -> None:
        """Fill a box for text, see-through where `alpha` is below 255."""
        ground = self.tint(PANEL)
        if alpha >= 255:
            self.surface.fill(ground, box)
        else:
            sheet = pygame.Surface((box[2], box[3]), pygame.SRCALPHA)
            sheet.fill((*ground, alpha))
            self.surface.blit(sheet, (box[0], box[1]))
        if edge is not None:
            pygame.draw.rect(self.surface, self.tint(edge), box, 1)

    def veil(self) -> None:
        """Darken everything drawn so far, or on a light ground let it pale."""
        if self.theme == "light":
            self.surface.fill((70, 70, 72), special_flags=pygame.BLEND_RGB_ADD)
        else:
            self.surface.fill((104, 104, 108), special_flags=pygame.BLEND_RGB_MULT)

    def card(self, box: Box, fill: Colour, edge: Colour | None = None, radius: int = 4) -> None:
        """Fill a box with round corners."""
        pygame.draw.rect(self.surface, self.tint(fill), box, border_radius=radius)
        if edge is not None:
            pygame.draw.rect(self.surface, self.tint(edge), box, 1, border_radius=radius)

    def rule(self, start: tuple[int, int], end: tuple[int, int]) -> None:
        """Draw a line between two parts of the display."""
        pygame.draw.line(self.surface, self.tint(EDGE), start, end)

    def bar(self, box: Box, share: float, colour: Colour) -> None:
        """Draw a gauge filled to `share`."""
        self.card(box, TROUGH, radius=3)
        filled = pygame.Rect(box)
        filled.width = max(0, min(box[2], round(box[2] * share)))
        if filled.width:
            pygame.draw.rect(self.surface, self.tint(colour), filled, border_radius=3)
        pygame.draw.rect(self.surface, self.tint(EDGE), box, 1, border_radius=3)
