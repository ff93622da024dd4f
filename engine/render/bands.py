"""Bands of rows, each drawn by a thread of its own.

Invariant: a band never touches another's rows, and what is drawn in a row depends on the row alone;
so any number of threads gives the same pixels.
"""

from __future__ import annotations

import itertools
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable


class Bands:
    """The threads of a renderer; the one that asks draws a band itself."""

    def __init__(self, threads: int) -> None:
        self._threads = max(1, threads)
        self._pool = ThreadPoolExecutor(self._threads - 1) if self._threads > 1 else None

    def run(self, draw: Callable[[int, int], object], first: int, last: int) -> None:
        """Call `draw(top, bottom)` for bands that together are the rows first to last."""
        if self._pool is None or last - first < 2 * self._threads:
            draw(first, last)
            return
        rows = last - first
        cuts = [first + rows * k // self._threads for k in range(self._threads + 1)]
        (top, bottom), *others = itertools.pairwise(cuts)
        task = [draw]
        waiting = [self._pool.submit(_call, task, a, b) for a, b in others]
        draw(top, bottom)
        for band in waiting:
            band.result()
        # a thread may hold its task a little longer; the picture in it must not stay lent
        task.clear()


def _call(task: list[Callable[[int, int], object]], top: int, bottom: int) -> None:
    task[0](top, bottom)
