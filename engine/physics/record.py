"""What the solvers write down: pieces that end, events that happen, balls that go.

One idea: a piece is written when it ends and an event when it happens, so the trace grows in
order and is never touched again. Invariant: a ball's pieces follow each other without a gap.
"""

from __future__ import annotations

from math import inf, sqrt
from typing import TYPE_CHECKING

from engine.geometry.kernel import kernel
from engine.physics.motion import begin, carry, finish
from engine.physics.state import (
    AX,
    AY,
    BX,
    BY,
    E_FIRST,
    E_KIND,
    E_SECOND,
    E_SPEED,
    E_TIME,
    END,
    EVENTS,
    G_OUT_X,
    G_OUT_Y,
    GONE,
    LEFT,
    N_CURVED,
    N_DX,
    N_DY,
    N_SIZE,
    N_X,
    N_Y,
    P_AX,
    P_AY,
    P_BALL,
    P_BX,
    P_BY,
    P_KIND,
    P_T0,
    P_T1,
    P_VX,
    P_VY,
    P_VZ,
    P_WX,
    P_WY,
    P_WZ,
    P_X,
    P_Y,
    P_Z,
    PIECE_WIDTH,
    PIECES,
    REST,
    ROLL,
    ROLLING,
    STOPPED,
    T0,
    VX,
    VY,
    VZ,
    WX,
    WY,
    WZ,
    X,
    Y,
    Z,
)

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Ints = NDArray[np.int64]


@kernel
def move(
    balls: Floats,
    kinds: Ints,
    pieces: Floats,
    counts: Ints,
    i: int,
    now: float,
) -> None:
    """Close the ball's piece and carry its origin to `now`."""
    close(balls[i], kinds[i], pieces, counts, i, now)
    carry(balls[i], now)


@kernel
def close(ball: Floats, kind: int, pieces: Floats, counts: Ints, i: int, now: float) -> None:
    """Write the ball's piece, which ends `now`, into the trace; an empty one is no piece."""
    if now > ball[T0]:
        write(ball, kind, pieces[counts[PIECES]], i, now)
        counts[PIECES] += 1


@kernel
def write(ball: Floats, kind: int, row: Floats, i: int, end: float) -> None:
    """Fill a row (P_*) with the ball's piece."""
    row[P_BALL], row[P_T0], row[P_T1], row[P_KIND] = i, ball[T0], end, kind
    row[P_X], row[P_Y], row[P_VX], row[P_VY] = ball[X], ball[Y], ball[VX], ball[VY]
    row[P_WX], row[P_WY], row[P_WZ] = ball[WX], ball[WY], ball[WZ]
    row[P_AX], row[P_AY], row[P_BX], row[P_BY] = ball[AX], ball[AY], ball[BX], ball[BY]
    row[P_Z], row[P_VZ] = ball[Z], ball[VZ]


@kernel
def note(
    events: Floats, counts: Ints, kind: float, now: float, first: int, second: float, speed: float
) -> None:
    """Write one event into the log."""
    row = events[counts[EVENTS]]
    row[E_KIND], row[E_TIME], row[E_FIRST] = kind, now, first
    row[E_SECOND], row[E_SPEED] = second, speed
    counts[EVENTS] += 1


@kernel
def drop(
    balls: Floats,
    kinds: Ints,
    pieces: Floats,
    counts: Ints,
    who: int,
    now: float,
) -> None:
    """Take a ball off the bed where it is."""
    move(balls, kinds, pieces, counts, who, now)
    kinds[who] = GONE
    ball = balls[who]
    ball[VX] = ball[VY] = ball[WX] = ball[WY] = ball[WZ] = 0.0
    ball[AX] = ball[AY] = ball[BX] = ball[BY] = 0.0
    ball[END] = inf


@kernel
def restart(
    balls: Floats, kinds: Ints, world: Floats, events: Floats, counts: Ints, i: int, now: float
) -> None:
    """Begin the piece that follows an event, and note where the ball has stopped by it."""
    before = kinds[i]
    kinds[i] = begin(balls[i], world)
    if kinds[i] == REST and before != REST:
        note(events, counts, STOPPED, now, i, -1.0, 0.0)


@kernel
def faster_first(balls: Floats, one: int, two: int) -> tuple[int, int]:
    """Return the two with the faster along the line of centres first."""
    nx, ny = balls[two, X] - balls[one, X], balls[two, Y] - balls[one, Y]
    mine = abs(balls[one, VX] * nx + balls[one, VY] * ny)
    yours = abs(balls[two, VX] * nx + balls[two, VY] * ny)
    return (one, two) if mine >= yours else (two, one)


@kernel
def into(ball: Floats, nose: Floats) -> tuple[float, float]:
    """Return the unit vector from the ball into the nose it touches."""
    if nose[N_CURVED] == 0.0:
        return nose[N_DY], -nose[N_DX]
    x, y = nose[N_X] - ball[X], nose[N_Y] - ball[Y]
    reach = sqrt(x * x + y * y)
    sign = -1.0 if nose[N_SIZE] < 0.0 else 1.0
    return sign * x / reach, sign * y / reach


@kernel
def change(
    balls: Floats,
    kinds: Ints,
    world: Floats,
    pieces: Floats,
    events: Floats,
    counts: Ints,
    who: int,
) -> None:
    """Let a ball's piece end by itself: slip ends, a ball stops, or it is found off the bed."""
    ball, before = balls[who], kinds[who]
    end = ball[END]
    close(ball, before, pieces, counts, who, end)
    kinds[who] = finish(ball, world, before)
    if abs(ball[X]) > world[G_OUT_X] or abs(ball[Y]) > world[G_OUT_Y]:
        drop(balls, kinds, pieces, counts, who, end)
        note(events, counts, LEFT, end, who, -1.0, 0.0)
    elif kinds[who] == ROLL:
        note(events, counts, ROLLING, end, who, -1.0, 0.0)
    elif kinds[who] == REST:
        note(events, counts, STOPPED, end, who, -1.0, 0.0)


@kernel
def arrange(
    balls: Floats, kinds: Ints, pieces: Floats, counts: Ints, now: float, out: Floats
) -> int:
    """Fill `out` with all pieces by ball and time, those still open cut off `now`; return how many.

    A ball that is gone has no open piece, save where it never had another.
    """
    n, written = balls.shape[0], counts[PIECES]
    row = 0
    for i in range(n):
        before = row
        for p in range(written):
            if int(pieces[p, P_BALL]) == i:
                for k in range(PIECE_WIDTH):
                    out[row, k] = pieces[p, k]
                row += 1
        if kinds[i] == GONE and row > before:
            continue
        end = balls[i, T0] if kinds[i] == GONE else now
        write(balls[i], kinds[i], out[row], i, end)
        row += 1
    return row


__all__ = [
    "arrange",
    "change",
    "close",
    "drop",
    "faster_first",
    "into",
    "move",
    "note",
    "restart",
    "write",
]
