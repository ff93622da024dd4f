"""The picture's memory: every renderer writes 0x00RRGGBB into an (h, w) uint32 array.

One idea: the window hands in its own memory in that form and nothing is copied; any other form
of picture gets a copy at the end of the frame.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Pixels = NDArray[np.uint32]

Picture = np.ndarray[Any, Any]
"""(h, w) uint32; (h, w, 3) uint8 red, green, blue; or (h, w, 4) uint8 blue, green, red, unused."""


class Canvas:
    """Pixels to draw into, and the way from there to the picture that was handed in."""

    def __init__(self) -> None:
        self._own: Pixels = np.zeros((1, 1), np.uint32)

    def open(self, picture: Picture) -> Pixels:
        """Return pixels to draw into: the picture's own memory where it has the right form."""
        if picture.dtype == np.uint32 and picture.ndim == 2 and picture.flags.c_contiguous:
            return picture
        _check(picture)
        if self._own.shape != picture.shape[:2]:
            self._own = np.zeros(picture.shape[:2], np.uint32)
        return self._own

    def close(self, pixels: Pixels, picture: Picture) -> None:
        """Bring what was drawn into the picture, if it is not there already."""
        if pixels is picture:
            return
        if picture.ndim == 2:
            picture[...] = pixels
            return
        parts = pixels.view(np.uint8).reshape(*pixels.shape, 4)
        if picture.shape[2] == 3:
            picture[...] = parts[..., 2::-1]
        else:
            picture[...] = parts


def _check(picture: Picture) -> None:
    fits = (picture.ndim == 2 and picture.dtype == np.uint32) or (
        picture.ndim == 3 and picture.shape[2] in (3, 4) and picture.dtype == np.uint8
    )
    if not fits:
        raise ValueError(
            f"a picture is (h, w) uint32 or (h, w, 3 or 4) uint8, not {picture.shape} "
            f"{picture.dtype}"
        )
