"""The cache of what comes next for every ball, and which of it comes first.

One idea: each ball remembers its earliest nose, drop and partner, and the matrix of pair times is
renewed only in the row and column of a ball that changed. Invariant: order is time, then tier
(drop, ball and ball, nose, change of motion), then ball.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from engine.geometry.kernel import kernel
from engine.physics.predict import NEVER, nose_time, pair_time, pocket_time, swept_box
from engine.physics.state import (
    END,
    FAST,
    GONE,
    K_DROP,
    K_DROP_TIME,
    K_NOSE,
    K_NOSE_TIME,
    K_PAIR,
    K_PAIR_TIME,
    N_HIX,
    N_HIY,
    N_LOX,
    N_LOY,
    REST,
    ROLL,
    SLIDE,
    SPIN,
    T0,
    X,
    Y,
)

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Ints = NDArray[np.int64]


@kernel
def next_event(balls: Floats, kinds: Ints, foreseen: Floats) -> tuple[int, int, float]:
    """Return tier, ball and time of the earliest foreseen event."""
    best, tier, who = NEVER, 4, -1
    for i in range(balls.shape[0]):
        if kinds[i] == GONE:
            continue
        t = foreseen[i, K_DROP_TIME]
        if t < best or (t == best and tier > 0 and t < NEVER):
            best, tier, who = t, 0, i
        t = foreseen[i, K_PAIR_TIME]
        if t < best or (t == best and tier > 1 and t < NEVER):
            best, tier, who = t, 1, i
        t = foreseen[i, K_NOSE_TIME]
        if t < best or (t == best and tier > 2 and t < NEVER):
            best, tier, who = t, 2, i
        t = balls[i, END]
        if t < best:
            best, tier, who = t, 3, i
    return tier, who, best


@kernel
def foresee(
    balls: Floats,
    kinds: Ints,
    noses: Floats,
    pockets: Floats,
    pairs: Floats,
    foreseen: Floats,
    i: int,
    now: float,
    box: Floats,
) -> None:
    """Foresee all that may happen to ball `i`, whose piece starts `now`."""
    row = foreseen[i]
    row[K_NOSE_TIME] = row[K_DROP_TIME] = NEVER
    if kinds[i] != GONE:
        moving = kinds[i] in (ROLL, SLIDE, FAST)
        if moving:
            _foresee_noses(balls[i], noses, row, box)
        for k in range(pockets.shape[0]):
            px, py, size = pockets[k, 0], pockets[k, 1], pockets[k, 2]
            if moving:
                t = pocket_time(balls[i], px, py, size)
            else:
                inside = (balls[i, X] - px) ** 2 + (balls[i, Y] - py) ** 2 <= size * size
                t = now if inside else NEVER
            if t < row[K_DROP_TIME]:
                row[K_DROP_TIME], row[K_DROP] = t, k
    _foresee_pairs(balls, kinds, pairs, foreseen, i, now)


@kernel
def _foresee_noses(ball: Floats, noses: Floats, row: Floats, box: Floats) -> None:
    """Find the first nose; what lies beyond one that was found is not looked at."""
    last = ball[END] - ball[T0]
    swept_box(ball, last, box)
    for k in range(noses.shape[0]):
        if (
            noses[k, N_LOX] > box[2]
            or noses[k, N_HIX] < box[0]
            or noses[k, N_LOY] > box[3]
            or noses[k, N_HIY] < box[1]
        ):
            continue
        t = nose_time(ball, noses[k], last)
        if t < row[K_NOSE_TIME]:
            row[K_NOSE_TIME], row[K_NOSE] = t, k
            last = t - ball[T0]
            swept_box(ball, last, box)


@kernel
def _foresee_pairs(
    balls: Floats, kinds: Ints, pairs: Floats, foreseen: Floats, i: int, now: float
) -> None:
    """Renew row and column `i` of the pair times, and every row's earliest partner."""
    n = balls.shape[0]
    still = kinds[i] in (REST, SPIN)
    for j in range(n):
        if j == i:
            continue
        t = NEVER
        both_still = still and kinds[j] in (REST, SPIN)
        if kinds[i] != GONE and kinds[j] != GONE and not both_still:
            t = pair_time(balls[i], balls[j], now)
        if j > i:
            pairs[i, j] = t
            continue
        pairs[j, i] = t
        row = foreseen[j]
        if t < row[K_PAIR_TIME] or (t == row[K_PAIR_TIME] and i < row[K_PAIR] and t < NEVER):
            row[K_PAIR_TIME], row[K_PAIR] = t, i
        elif int(row[K_PAIR]) == i and row[K_PAIR_TIME] < NEVER and t > row[K_PAIR_TIME]:
            _earliest_partner(pairs, foreseen, j)
    _earliest_partner(pairs, foreseen, i)


@kernel
def _earliest_partner(pairs: Floats, foreseen: Floats, i: int) -> None:
    row = foreseen[i]
    row[K_PAIR_TIME] = NEVER
    for j in range(i + 1, pairs.shape[0]):
        if pairs[i, j] < row[K_PAIR_TIME]:
            row[K_PAIR_TIME], row[K_PAIR] = pairs[i, j], j


__all__ = ["foresee", "next_event"]
