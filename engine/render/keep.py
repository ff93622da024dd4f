"""What is kept while the camera rests: the picture of all that never moves.

One idea: a picture is worth keeping when the same key comes a second time; from the third on it is
known. Invariant: a key is compared by identity in its first place, which is what was packed, and by
value in the others.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from engine.render.arrays import Pixels, Singles

Key = tuple[object, ...]


class Kept:
    """The kept picture, and depths where the renderer has them."""

    def __init__(self, *, on: bool = True) -> None:
        self._on = on
        self._last: Key = ()
        self._known = False
        self.wants_picture = False
        self.pixels: Pixels = np.zeros((0, 0), np.uint32)
        self.depth: Singles = np.zeros((0, 0), np.float32)

    def knows(self, key: Key) -> bool:
        """Return whether the picture of `key` is kept.

        Where it is not, `wants_picture` says whether to write it to `pixels` (and `depth`) now;
        their last two places in `key` are the picture's width and height.
        """
        same = (
            self._on and bool(self._last) and key[0] is self._last[0] and key[1:] == self._last[1:]
        )
        self._last = key
        if same and self._known:
            self.wants_picture = False
            return True
        self.wants_picture, self._known = same, same
        size = key[-1]
        if same and isinstance(size, tuple) and self.pixels.shape != size[::-1]:
            self.pixels = np.zeros(size[::-1], np.uint32)
        return False

    def drop(self) -> None:
        """Take back that the picture of the last key is kept."""
        self._known, self.wants_picture = False, False
