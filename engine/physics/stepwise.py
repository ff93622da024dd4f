"""The solver `stepwise`: from event to event, exactly, in one jitted loop.

One idea: every ball keeps its own piece and its own origin; the earliest of all foreseen events
is carried out, and only the balls it touched are foreseen anew. Order is time, then tier (drop,
ball and ball, nose, change of motion), then ball. Invariant: the arrays change at events alone,
so stopping between two events and resuming changes no bit.
"""

from __future__ import annotations

from math import sqrt
from typing import TYPE_CHECKING

import numpy as np
from numba import njit

from engine.physics.collide import closing_speed, strike_apart
from engine.physics.motion import begin, carry, finish
from engine.physics.predict import NEVER, nose_time, pair_time, pocket_time, swept_box
from engine.physics.rebound import bounce
from engine.physics.shock import (
    C_A,
    C_B,
    C_ORDER,
    C_SPEED,
    CONTACT_WIDTH,
    TOUCH,
    gather,
    spread,
)
from engine.physics.state import (
    AX,
    AY,
    BX,
    BY,
    DROPPED,
    E_FIRST,
    E_KIND,
    E_SECOND,
    E_SPEED,
    E_TIME,
    END,
    FAST,
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
    NOSE,
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
    P_WX,
    P_WY,
    P_WZ,
    P_X,
    P_Y,
    RADIUS,
    REST,
    ROLL,
    ROLLING,
    SLIDE,
    SOFT,
    SPIN,
    STOPPED,
    T0,
    TOUCHING,
    VX,
    VY,
    WX,
    WY,
    WZ,
    X,
    Y,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Ints = NDArray[np.int64]

DONE, PAUSED, FULL, STORM = range(4)
"""How a run ends: all at rest, `until` reached, buffers full, more events than the cap."""

K_NOSE_TIME, K_DROP_TIME, K_PAIR_TIME, K_NOSE, K_DROP, K_PAIR = range(6)
FORESEEN_WIDTH = 6

PIECES, EVENTS, STARTED, CAP = range(4)


@njit(cache=True, error_model="numpy")
def run(
    balls: Floats,
    kinds: Ints,
    world: Floats,
    noses: Floats,
    pockets: Floats,
    pairs: Floats,
    foreseen: Floats,
    pieces: Floats,
    events: Floats,
    counts: Ints,
    clock: Floats,
    until: float,
) -> int:
    """Carry out all events up to `until` (s); return DONE, PAUSED, FULL or STORM."""
    n = balls.shape[0]
    box = np.empty(4)
    spare = n * n + n + 8
    members = np.empty(n, dtype=np.int64)
    contacts = np.empty((n * n // 2 + 1, CONTACT_WIDTH))
    if counts[STARTED] == 0:
        counts[STARTED] = 1
        for i in range(n):
            if kinds[i] != GONE:
                kinds[i] = begin(balls[i], world)
        for i in range(n):
            _foresee(balls, kinds, noses, pockets, pairs, foreseen, i, 0.0, box)
    while True:
        if counts[PIECES] + spare > pieces.shape[0] or counts[EVENTS] + spare > events.shape[0]:
            return FULL
        if counts[EVENTS] > counts[CAP]:
            return STORM
        tier, who, now = _next(balls, kinds, foreseen)
        if now == NEVER:
            return DONE
        if now > until:
            return PAUSED
        now = max(now, clock[0])
        clock[0] = now
        if tier == 0:
            drop(balls, kinds, world, pieces, counts, who, now)
            note(events, counts, DROPPED, now, who, foreseen[who, K_DROP], 0.0)
            _foresee(balls, kinds, noses, pockets, pairs, foreseen, who, now, box)
        elif tier == 1:
            other = int(foreseen[who, K_PAIR])
            count = _meet(
                balls, kinds, world, pieces, events, counts, members, contacts, who, other, now
            )
            for p in range(count):
                _foresee(balls, kinds, noses, pockets, pairs, foreseen, members[p], now, box)
        elif tier == 2:
            nose = int(foreseen[who, K_NOSE])
            move(balls, kinds, world, pieces, counts, who, now)
            ix, iy = into(balls[who], noses[nose])
            speed = bounce(balls[who], world, ix, iy)
            note(events, counts, NOSE, now, who, nose, speed)
            kinds[who] = begin(balls[who], world)
            if kinds[who] == REST:
                note(events, counts, STOPPED, now, who, -1.0, 0.0)
            _foresee(balls, kinds, noses, pockets, pairs, foreseen, who, now, box)
        else:
            change(balls, kinds, world, pieces, events, counts, who)
            _foresee(balls, kinds, noses, pockets, pairs, foreseen, who, now, box)


@njit(cache=True, error_model="numpy")
def _next(balls: Floats, kinds: Ints, foreseen: Floats) -> tuple[int, int, float]:
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


@njit(cache=True, error_model="numpy")
def _foresee(
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
            swept_box(balls[i], box)
            for k in range(noses.shape[0]):
                t = nose_time(balls[i], noses[k], box)
                if t < row[K_NOSE_TIME]:
                    row[K_NOSE_TIME], row[K_NOSE] = t, k
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


@njit(cache=True, error_model="numpy")
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


@njit(cache=True, error_model="numpy")
def _earliest_partner(pairs: Floats, foreseen: Floats, i: int) -> None:
    row = foreseen[i]
    row[K_PAIR_TIME] = NEVER
    for j in range(i + 1, pairs.shape[0]):
        if pairs[i, j] < row[K_PAIR_TIME]:
            row[K_PAIR_TIME], row[K_PAIR] = pairs[i, j], j


@njit(cache=True, error_model="numpy")
def move(
    balls: Floats,
    kinds: Ints,
    world: Floats,
    pieces: Floats,
    counts: Ints,
    i: int,
    now: float,
) -> None:
    """Close the ball's piece and carry its origin to `now`."""
    close(balls[i], kinds[i], pieces, counts, i, now)
    carry(balls[i], world, now)


@njit(cache=True, error_model="numpy")
def close(ball: Floats, kind: int, pieces: Floats, counts: Ints, i: int, now: float) -> None:
    """Write the ball's piece, which ends `now`, into the trace; an empty one is no piece."""
    if now <= ball[T0]:
        return
    row = pieces[counts[PIECES]]
    row[P_BALL], row[P_T0], row[P_T1], row[P_KIND] = i, ball[T0], now, kind
    row[P_X], row[P_Y], row[P_VX], row[P_VY] = ball[X], ball[Y], ball[VX], ball[VY]
    row[P_WX], row[P_WY], row[P_WZ] = ball[WX], ball[WY], ball[WZ]
    row[P_AX], row[P_AY], row[P_BX], row[P_BY] = ball[AX], ball[AY], ball[BX], ball[BY]
    counts[PIECES] += 1


@njit(cache=True, error_model="numpy")
def note(
    events: Floats, counts: Ints, kind: int, now: float, first: int, second: float, speed: float
) -> None:
    """Write one event into the log."""
    row = events[counts[EVENTS]]
    row[E_KIND], row[E_TIME], row[E_FIRST] = kind, now, first
    row[E_SECOND], row[E_SPEED] = second, speed
    counts[EVENTS] += 1


@njit(cache=True, error_model="numpy")
def drop(
    balls: Floats,
    kinds: Ints,
    world: Floats,
    pieces: Floats,
    counts: Ints,
    who: int,
    now: float,
) -> None:
    """Take a ball off the bed where it is."""
    move(balls, kinds, world, pieces, counts, who, now)
    kinds[who] = GONE
    ball = balls[who]
    ball[VX] = ball[VY] = ball[WX] = ball[WY] = ball[WZ] = 0.0
    ball[AX] = ball[AY] = ball[BX] = ball[BY] = 0.0
    ball[END] = NEVER


@njit(cache=True, error_model="numpy")
def _meet(
    balls: Floats,
    kinds: Ints,
    world: Floats,
    pieces: Floats,
    events: Floats,
    counts: Ints,
    members: Ints,
    contacts: Floats,
    one: int,
    two: int,
    now: float,
) -> int:
    """Resolve a meeting of two balls, or of a cluster they touch; return how many were moved."""
    move(balls, kinds, world, pieces, counts, one, now)
    move(balls, kinds, world, pieces, counts, two, now)
    members[0], members[1], count = one, two, 2
    speed = closing_speed(balls[one], balls[two])
    if speed >= SOFT and _company(balls, kinds, one, two, now):
        present = np.zeros(balls.shape[0], dtype=np.int64)
        for i in range(balls.shape[0]):
            present[i] = 1 if kinds[i] != GONE else 0
        count = _gather_now(balls, kinds, world, pieces, counts, present, members, one, two, now)
    if count == 2:
        first, second = faster_first(balls, one, two)
        strike_apart(balls[one], balls[two], world)
        note(events, counts, TOUCHING, now, first, second, speed)
    else:
        first, second = faster_first(balls, one, two)
        note(events, counts, TOUCHING, now, first, second, speed)
        total = spread(balls, members, count, world, contacts)
        _note_contacts(events, counts, contacts, total, one, two, now)
    for p in range(count):
        i = members[p]
        moved = kinds[i] != REST
        kinds[i] = begin(balls[i], world)
        if moved and kinds[i] == REST:
            note(events, counts, STOPPED, now, i, -1.0, 0.0)
    return count


@njit(cache=True, error_model="numpy")
def _at(ball: Floats, now: float) -> tuple[float, float]:
    s = now - ball[T0]
    x = ball[X] + s * (ball[VX] + 0.5 * s * ball[AX])
    return x, ball[Y] + s * (ball[VY] + 0.5 * s * ball[AY])


@njit(cache=True, error_model="numpy")
def _company(balls: Floats, kinds: Ints, one: int, two: int, now: float) -> bool:
    """Say whether a third ball touches one of the two."""
    for k in range(balls.shape[0]):
        if k in (one, two) or kinds[k] == GONE:
            continue
        x, y = _at(balls[k], now)
        for i in (one, two):
            dx, dy = x - balls[i, X], y - balls[i, Y]
            touch = 2.0 * sqrt(balls[i, RADIUS] * balls[k, RADIUS]) + TOUCH
            if dx * dx + dy * dy <= touch * touch:
                return True
    return False


@njit(cache=True, error_model="numpy")
def _gather_now(
    balls: Floats,
    kinds: Ints,
    world: Floats,
    pieces: Floats,
    counts: Ints,
    present: Ints,
    members: Ints,
    one: int,
    two: int,
    now: float,
) -> int:
    """Gather the touching cluster about two balls and bring its members to `now`."""
    here = np.empty(balls.shape)
    for i in range(balls.shape[0]):
        here[i, RADIUS] = balls[i, RADIUS]
        here[i, X], here[i, Y] = _at(balls[i], now)
    count = gather(here, present, one, two, members)
    for p in range(count):
        if members[p] not in (one, two):
            move(balls, kinds, world, pieces, counts, members[p], now)
    return count


@njit(cache=True, error_model="numpy")
def faster_first(balls: Floats, one: int, two: int) -> tuple[int, int]:
    """Return the two with the faster along the line of centres first."""
    nx, ny = balls[two, X] - balls[one, X], balls[two, Y] - balls[one, Y]
    mine = abs(balls[one, VX] * nx + balls[one, VY] * ny)
    yours = abs(balls[two, VX] * nx + balls[two, VY] * ny)
    return (one, two) if mine >= yours else (two, one)


@njit(cache=True, error_model="numpy")
def _note_contacts(
    events: Floats, counts: Ints, contacts: Floats, total: int, one: int, two: int, now: float
) -> None:
    """Note the cluster's other contacts in the order in which the blow reached them."""
    for order in range(1, total + 1):
        for c in range(total):
            row = contacts[c]
            if int(row[C_ORDER]) != order:
                continue
            a, b = int(row[C_A]), int(row[C_B])
            if (a, b) != (one, two):  # both come lower index first
                note(events, counts, TOUCHING, now, a, b, row[C_SPEED])


@njit(cache=True, error_model="numpy")
def into(ball: Floats, nose: Floats) -> tuple[float, float]:
    """Return the unit vector from the ball into the nose it touches."""
    if nose[N_CURVED] == 0.0:
        return nose[N_DY], -nose[N_DX]
    x, y = nose[N_X] - ball[X], nose[N_Y] - ball[Y]
    reach = sqrt(x * x + y * y)
    sign = -1.0 if nose[N_SIZE] < 0.0 else 1.0
    return sign * x / reach, sign * y / reach


@njit(cache=True, error_model="numpy")
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
        drop(balls, kinds, world, pieces, counts, who, end)
        note(events, counts, LEFT, end, who, -1.0, 0.0)
    elif kinds[who] == ROLL:
        note(events, counts, ROLLING, end, who, -1.0, 0.0)
    elif kinds[who] == REST:
        note(events, counts, STOPPED, end, who, -1.0, 0.0)


__all__ = [
    "CAP",
    "DONE",
    "EVENTS",
    "FORESEEN_WIDTH",
    "FULL",
    "PAUSED",
    "PIECES",
    "STARTED",
    "STORM",
    "change",
    "close",
    "drop",
    "faster_first",
    "into",
    "move",
    "note",
    "run",
]
