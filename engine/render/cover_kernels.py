"""Which pixels a surface covers: where its border crosses each row.

One idea: a row counts one more where a span begins and one less where it has ended; spans that meet
cancel out and are one. Invariant: what is noted of a surface lies in its `reach` and `bounds`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numba import njit

from engine.render.raster import by_height, rows_of, slopes_of, span_of

if TYPE_CHECKING:
    from engine.render.arrays import Bytes, Floats, Ints, Longs

FAR = 1 << 30


@njit(cache=True, nogil=True, error_model="numpy")
def cover(
    corner: Floats,
    count: int,
    rows: tuple[int, int],
    width: int,
    turns: Bytes,
    reach: Ints,
    bounds: Floats,
) -> None:
    """Note which pixels of a band a polygon covers: where its spans begin and end.

    `turns` (rows, width) gets one more where a span begins and one less where it has ended; `reach`
    (rows, 2) the first and last such places of a row; `bounds` the first row, the one after the
    last, the least and the greatest 1/z. Spans that meet cancel out and are one.
    """
    top, bottom = rows
    for part in range(count - 2):
        p, q, r = corner[0], corner[part + 1], corner[part + 2]
        x0, y0, x1, y1, x2, y2, cross = by_height(p[0], p[1], q[0], q[1], r[0], r[1])
        first, last = rows_of(y0, y2, top, bottom)
        if cross == 0.0 or first >= last or max(x0, x1, x2) < 0.0 or min(x0, x1, x2) > width:
            continue
        bounds[0], bounds[1] = min(bounds[0], first), max(bounds[1], last)
        bounds[2] = min(bounds[2], p[2], q[2], r[2])
        bounds[3] = max(bounds[3], p[2], q[2], r[2])
        slopes = slopes_of(x0, y0, x1, y1, x2, y2)
        for y in range(first, last):
            begin, end = span_of(y, 0, width, x0, y0, x1, y1, y2, cross, slopes)
            if begin >= end:
                continue
            turns[y - top, begin] += np.uint8(1)
            turns[y - top, end] -= np.uint8(1)
            reach[y - top, 0] = min(reach[y - top, 0], begin)
            reach[y - top, 1] = max(reach[y - top, 1], end)


@njit(cache=True, nogil=True, error_model="numpy")
def cover_border(
    edges: Ints,
    first: int,
    last: int,
    screen: Floats,
    rows: tuple[int, int],
    width: int,
    turns: Bytes,
    reach: Ints,
    bounds: Floats,
) -> bool:
    """Note where a surface's border, its edges first to last, crosses the rows (see `cover`).

    Returns False, with nothing noted, where a corner is too near for that.
    """
    for e in range(first, last):
        if screen[edges[e, 0], 2] <= 0.0:
            return False
    top, bottom = rows
    for e in range(first, last):
        a, b, step = edges[e, 0], edges[e, 1], np.uint8(1)
        bounds[2] = min(bounds[2], screen[a, 2])
        bounds[3] = max(bounds[3], screen[a, 2])
        if screen[a, 1] > screen[b, 1]:
            a, b, step = b, a, np.uint8(255)
        x, upper, lower = screen[a, 0], screen[a, 1], screen[b, 1]
        begin, end = rows_of(upper, lower, top, bottom)
        if begin >= end:
            continue
        bounds[0], bounds[1] = min(bounds[0], begin), max(bounds[1], end)
        slope = (screen[b, 0] - x) / (lower - upper)
        for y in range(begin, end):
            place = np.ceil(x + (y + 0.5 - upper) * slope - 0.5)
            at = int(min(max(place, 0.0), width))
            turns[y - top, at] += step
            reach[y - top, 0] = min(reach[y - top, 0], at)
            reach[y - top, 1] = max(reach[y - top, 1], at)
    return True


@njit(cache=True, nogil=True, error_model="numpy")
def next_turn(turns: Bytes, words: Longs, row: int, x: int, last: int) -> int:
    """Return the first place from `x` to `last` where a row of `turns` is not zero, else after it.

    `words` are the same rows, eight places at a time.
    """
    while x <= last:
        if x % 8 == 0 and words[row, x // 8] == 0:
            x += 8
        elif turns[row, x] == 0:
            x += 1
        else:
            return x
    return last + 1
