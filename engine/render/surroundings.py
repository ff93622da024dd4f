"""What a scene has besides its objects, as arrays: lamps, discs and the background."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from engine.render.arrays import Floats, Pixels
    from engine.scene.scene import Scene
    from engine.scene.shape import Disc, Rgb

    Stops = tuple[tuple[float, Rgb], ...]


def lamps_of(scene: Scene) -> Floats:
    """Return the lights as (n, 4): position and power."""
    rows = [(*light.position, light.power) for light in scene.lights]
    return np.array(rows, dtype=np.float64).reshape(-1, 4)


def discs_of(discs: tuple[Disc, ...]) -> tuple[Floats, Pixels]:
    """Return discs as (n, 6) and their colours as 0x00RRGGBB (n,)."""
    rows = [(*d.centre, d.radius, d.alpha, d.softness) for d in discs]
    shades = [(d.colour[0] << 16) | (d.colour[1] << 8) | d.colour[2] for d in discs]
    return np.array(rows, dtype=np.float64).reshape(-1, 6), np.array(shades, dtype=np.uint32)


def background_of(stops: Stops, height: int) -> Pixels:
    """Return the colour of every row, mixed between the stops about its middle, (height, 1)."""
    places = [share for share, _ in stops]
    middles = (np.arange(height) + 0.5) / height
    rows = np.zeros((height, 1), np.uint32)
    for part in range(3):
        mixed = np.interp(middles, places, [colour[part] for _, colour in stops])
        rows[:, 0] |= np.rint(mixed).astype(np.uint32) << (16 - 8 * part)
    return rows


class Backdrop:
    """The background, worked out anew where its colours or the height are others."""

    def __init__(self) -> None:
        self._asked: object = None
        self._rows: Pixels = np.zeros((0, 1), np.uint32)

    def rows(self, stops: Stops, height: int) -> Pixels:
        """Return the colour of every row, (height, 1)."""
        if self._asked != (stops, height):
            self._asked, self._rows = (stops, height), background_of(stops, height)
        return self._rows
