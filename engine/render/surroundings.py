"""What a scene has besides its objects, as arrays: lamps, discs and the background."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from engine.render.arrays import Floats, Pixels
    from engine.scene.scene import Scene
    from engine.scene.shape import Disc, Rgb


def lamps_of(scene: Scene) -> Floats:
    """Return the lights as (n, 4): position and power."""
    rows = [(*light.position, light.power) for light in scene.lights]
    return np.array(rows, dtype=np.float64).reshape(-1, 4)


def discs_of(discs: tuple[Disc, ...]) -> tuple[Floats, Pixels]:
    """Return discs as (n, 6) and their colours as 0x00RRGGBB (n,)."""
    rows = [(*d.centre, d.radius, d.alpha, d.softness) for d in discs]
    shades = [(d.colour[0] << 16) | (d.colour[1] << 8) | d.colour[2] for d in discs]
    return np.array(rows, dtype=np.float64).reshape(-1, 6), np.array(shades, dtype=np.uint32)


def background_of(colours: tuple[Rgb, Rgb], height: int) -> Pixels:
    """Return the colour of every row, from the upper colour to the lower one, (height, 1)."""
    upper, lower = (np.array(colour, dtype=np.float64) for colour in colours)
    share = np.linspace(0.0, 1.0, height)[:, None]
    red, green, blue = np.rint(upper * (1.0 - share) + lower * share).astype(np.uint32).T
    rows: Pixels = ((red << 16) | (green << 8) | blue)[:, None]
    return rows


class Backdrop:
    """The background, worked out anew where its colours or the height are others."""

    def __init__(self) -> None:
        self._asked: object = None
        self._rows: Pixels = np.zeros((0, 1), np.uint32)

    def rows(self, colours: tuple[Rgb, Rgb], height: int) -> Pixels:
        """Return the colour of every row, (height, 1)."""
        if self._asked != (colours, height):
            self._asked, self._rows = (colours, height), background_of(colours, height)
        return self._rows
