"""The picture's memory: every renderer writes 0x00RRGGBB into rows of uint32.

One idea: a box of the window's own memory is drawn into where it lies, and nothing is copied; any
other form of picture gets a copy at the end of the frame.
Invariant: nothing right of a target's `width` is read or written.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.lib.stride_tricks import as_strided
from numpy.typing import NDArray

Pixels = NDArray[np.uint32]

Picture = np.ndarray[Any, Any]
"""(h, w) uint32; (h, w, 3) uint8 red, green, blue; or (h, w, 4) uint8 blue, green, red, unused."""


@dataclass(frozen=True, slots=True, eq=False)
class Target:
    """Rows to draw into: `rows` is (h, at least `width`), in one piece; `width` may be drawn."""

    rows: Pixels
    width: int

    @property
    def height(self) -> int:
        """Return the number of rows."""
        return len(self.rows)

    @property
    def size(self) -> tuple[int, int]:
        """Return width and height in pixels."""
        return self.width, len(self.rows)


class Canvas:
    """Rows to draw into, and the way from there to the picture that was handed in."""

    def __init__(self) -> None:
        self._own: Pixels = np.zeros((1, 1), np.uint32)

    def open(self, picture: Picture) -> Target:
        """Return rows to draw into: the picture's own memory where it has the right form."""
        height, width = picture.shape[:2]
        if picture.dtype == np.uint32 and picture.ndim == 2 and _lies_in_rows(picture):
            pitch = picture.strides[0]
            return Target(as_strided(picture, (height, pitch // 4), (pitch, 4)), width)
        _check(picture)
        if self._own.shape != (height, width):
            self._own = np.zeros((height, width), np.uint32)
        return Target(self._own, width)

    def close(self, target: Target, picture: Picture) -> None:
        """Bring what was drawn into the picture, if it is not there already."""
        pixels = target.rows
        if pixels is not self._own:
            return
        if picture.ndim == 2:
            picture[...] = pixels
            return
        parts = pixels.view(np.uint8).reshape(*pixels.shape, 4)
        if picture.shape[2] == 3:
            picture[...] = parts[..., 2::-1]
        else:
            picture[...] = parts


def _lies_in_rows(picture: Picture) -> bool:
    pitch, step = picture.strides
    return step == 4 and pitch % 4 == 0 and pitch >= 4 * picture.shape[1] > 0


def _check(picture: Picture) -> None:
    fits = (picture.ndim == 2 and picture.dtype == np.uint32) or (
        picture.ndim == 3 and picture.shape[2] in (3, 4) and picture.dtype == np.uint8
    )
    if not fits:
        raise ValueError(
            f"a picture is (h, w) uint32 or (h, w, 3 or 4) uint8, not {picture.shape} "
            f"{picture.dtype}"
        )
