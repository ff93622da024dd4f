"""Balls that leave the bed: the loop around `stepwise` while any ball flies.

One idea: to the balls on the bed a flying one is not there, so `stepwise.run` plays them on, one
moment at a time, and this loop puts in between what happens in the air. Once all are down again
the plain loop goes on alone, so shots that stay down never come here. Invariant: as there, the
arrays change at events alone, so stopping and resuming changes no bit.
"""

from __future__ import annotations

from math import inf, sqrt
from typing import TYPE_CHECKING

import numpy as np

from engine.geometry.kernel import kernel, kernel_with_arrays
from engine.physics.airborne import (
    flight_end,
    inside,
    nearest,
    nose_in_air,
    on_rail,
    over_pocket,
    pair_in_air,
)
from engine.physics.foresee import foresee, next_event
from engine.physics.impact import meet_ball, meet_bed, meet_nose
from engine.physics.motion import begin
from engine.physics.predict import NEVER
from engine.physics.record import close, move, note
from engine.physics.state import (
    ASK,
    ASK_ALARM,
    ASK_NOSE,
    AX,
    AY,
    BX,
    BY,
    C_ALARM,
    CAP,
    DOWN,
    DROPPED,
    END,
    EVENTS,
    FLY,
    FULL,
    G_GRAVITY,
    G_NOSE,
    G_RAIL,
    GONE,
    K_NOSE,
    K_NOSE_TIME,
    K_TOUCHED,
    LANDED,
    LEFT,
    N_PIN,
    NOSE,
    ON_RAIL,
    PAUSED,
    PIECES,
    RADIUS,
    REST,
    RUN,
    STARTED,
    STOPPED,
    STORM,
    T0,
    TOUCHING,
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
from engine.physics.stepwise import ask, run

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Ints = NDArray[np.int64]

IN_PAIR, IN_NOSE, IN_FALL = range(3)
LEVEL = 1e-9
"""A ball so near (m) to the height at which it lies on the rail is there."""

BACK = 2.0
"""A ball that falls behind a mouth, within so many drop radii, is in that pocket."""


@kernel_with_arrays
def run_flying(
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
    """Carry out all events up to `until` (s) while a ball flies; return how it ended."""
    n = balls.shape[0]
    spare = n * n + n + 8
    box = np.empty(4)
    bedded = np.empty(n, dtype=np.int64)
    _hide(kinds, bedded)
    if counts[STARTED] == 0:
        args = (pairs, foreseen, pieces, events, counts, clock, -1.0)
        run(balls, bedded, world, noses, pockets, *args)
        _show(kinds, bedded)
    for i in range(n):  # what was asked may have changed balls and pins
        if kinds[i] == FLY:
            _soar(balls[i], world, noses, pockets, foreseen[i])
    while True:
        if counts[PIECES] + spare > pieces.shape[0] or counts[EVENTS] + spare > events.shape[0]:
            return FULL
        if counts[EVENTS] > counts[CAP]:
            return STORM
        what, who, other, now = _next_in_air(balls, kinds, world, foreseen, clock[0])
        if now == NEVER:
            return DOWN
        _hide(kinds, bedded)
        _, _, below = next_event(balls, bedded, foreseen)
        if clock[C_ALARM] < min(now, below) and clock[C_ALARM] <= until:
            return ask(counts, clock, ASK_ALARM, who, who, clock[C_ALARM])
        if below <= min(now, until):
            args = (pairs, foreseen, pieces, events, counts, clock, below)
            answer = run(balls, bedded, world, noses, pockets, *args)
            _show(kinds, bedded)
            if answer in (FULL, STORM, ASK):
                return answer
            continue
        if now > until:
            return PAUSED
        now = max(now, clock[0])
        clock[0] = now
        if what == IN_PAIR:
            _meet(balls, kinds, world, pieces, events, counts, who, other, now)
            _settle(
                balls, kinds, world, noses, pockets, pairs, foreseen, events, counts, other, box
            )
        elif what == IN_NOSE:
            _advance(balls[who], kinds[who], world, pieces, counts, who, now)
            nose = int(foreseen[who, K_NOSE])
            if noses[nose, N_PIN] >= 0.0:
                foreseen[who, K_TOUCHED] = 1.0
                return ask(counts, clock, ASK_NOSE, who, nose, now)
            px, py = nearest(noses[nose], balls[who, X], balls[who, Y])
            speed = meet_nose(balls[who], world, noses[nose], px, py)
            note(events, counts, NOSE, now, who, float(nose), speed)
        else:
            _advance(balls[who], kinds[who], world, pieces, counts, who, now)
            kinds[who] = _come_down(balls[who], world, noses, pockets, events, counts, who, now)
        _settle(balls, kinds, world, noses, pockets, pairs, foreseen, events, counts, who, box)


@kernel
def _hide(kinds: Ints, bedded: Ints) -> None:
    for i in range(kinds.shape[0]):
        bedded[i] = GONE if kinds[i] == FLY else kinds[i]


@kernel
def _show(kinds: Ints, bedded: Ints) -> None:
    for i in range(kinds.shape[0]):
        if kinds[i] != FLY:
            kinds[i] = bedded[i]


@kernel
def _next_in_air(
    balls: Floats, kinds: Ints, world: Floats, foreseen: Floats, now: float
) -> tuple[int, int, int, float]:
    """Return kind, ball, other ball and time of the earliest event of a flying ball."""
    best, what, who, other = NEVER, IN_FALL, -1, -1
    for i in range(balls.shape[0]):
        if kinds[i] != FLY:
            continue
        for j in range(balls.shape[0]):
            if j == i or kinds[j] == GONE or (kinds[j] == FLY and j < i):
                continue
            # the lower index first, so that labels decide as little as they can
            a, b = min(i, j), max(i, j)
            t = pair_in_air(balls[a], balls[b], kinds[a], kinds[b], world, now)
            if t < best:
                best, what, who, other = t, IN_PAIR, i, j
        if foreseen[i, K_NOSE_TIME] < best:
            best, what, who = foreseen[i, K_NOSE_TIME], IN_NOSE, i
        if balls[i, END] < best:
            best, what, who = balls[i, END], IN_FALL, i
    return what, who, other, best


@kernel
def _soar(ball: Floats, world: Floats, noses: Floats, pockets: Floats, row: Floats) -> None:
    """Begin a piece of flight at the row's r, v and T0: where it ends, and the first nose."""
    ball[AX] = ball[AY] = ball[BX] = ball[BY] = 0.0
    ball[END] = flight_end(ball, world, noses, pockets)
    row[K_NOSE_TIME] = NEVER
    for k in range(noses.shape[0]):
        t = nose_in_air(ball, noses[k], world, min(ball[END], row[K_NOSE_TIME]) - ball[T0])
        if t < row[K_NOSE_TIME]:
            row[K_NOSE_TIME], row[K_NOSE] = t, k


@kernel
def _advance(
    ball: Floats, kind: int, world: Floats, pieces: Floats, counts: Ints, i: int, now: float
) -> None:
    """Close a flying ball's piece and carry its origin to `now`."""
    close(ball, kind, pieces, counts, i, now)
    s, gravity = now - ball[T0], world[G_GRAVITY]
    ball[X] += s * ball[VX]
    ball[Y] += s * ball[VY]
    ball[Z] += s * (ball[VZ] - 0.5 * gravity * s)
    ball[VZ] -= gravity * s
    ball[T0] = now


@kernel
def _meet(
    balls: Floats,
    kinds: Ints,
    world: Floats,
    pieces: Floats,
    events: Floats,
    counts: Ints,
    who: int,
    other: int,
    now: float,
) -> None:
    """Let two balls meet; one that is lifted off the bed flies from now on."""
    for i in (who, other):
        if kinds[i] == FLY:
            _advance(balls[i], kinds[i], world, pieces, counts, i, now)
        else:
            move(balls, kinds, pieces, counts, i, now)
    first, second = _faster_first(balls, min(who, other), max(who, other))
    one, two = min(who, other), max(who, other)
    speed = meet_ball(balls[one], balls[two], kinds[one], kinds[two], world)
    note(events, counts, TOUCHING, now, first, float(second), speed)
    if kinds[other] != FLY and balls[other, VZ] > 0.0:
        kinds[other] = FLY


@kernel
def _faster_first(balls: Floats, one: int, two: int) -> tuple[int, int]:
    nx, ny = balls[two, X] - balls[one, X], balls[two, Y] - balls[one, Y]
    nz = balls[two, Z] - balls[one, Z]
    mine = abs(balls[one, VX] * nx + balls[one, VY] * ny + balls[one, VZ] * nz)
    yours = abs(balls[two, VX] * nx + balls[two, VY] * ny + balls[two, VZ] * nz)
    return (one, two) if mine >= yours else (two, one)


@kernel
def _come_down(
    ball: Floats,
    world: Floats,
    noses: Floats,
    pockets: Floats,
    events: Floats,
    counts: Ints,
    who: int,
    now: float,
) -> int:
    """Let a fall end: in a pocket, off the table, or on bed or rail, off which it may bounce."""
    pocket = over_pocket(pockets, ball[X], ball[Y], 1.0 + 1e-9)
    off = not inside(noses, ball[X], ball[Y])
    high = abs(ball[Z] - ball[RADIUS] - world[G_NOSE]) < LEVEL
    if pocket < 0 and off and not high:
        pocket = over_pocket(pockets, ball[X], ball[Y], BACK)
    if pocket >= 0 and not high:
        note(events, counts, DROPPED, now, who, float(pocket), 0.0)
    elif (
        high
        and on_rail(noses, ball[X], ball[Y], world[G_RAIL])
        and _bounce_on_rail(ball, world, events, counts, who, now)
    ):
        return FLY
    elif off or high:
        note(events, counts, LEFT, now, who, -1.0, 0.0)
    else:
        speed = meet_bed(ball, world)
        note(events, counts, LANDED, now, who, -1.0, speed)
        return FLY if ball[VZ] > 0.0 else REST
    ball[VX] = ball[VY] = ball[VZ] = ball[WX] = ball[WY] = ball[WZ] = 0.0
    ball[AX] = ball[AY] = ball[BX] = ball[BY] = 0.0
    ball[END] = inf
    return GONE


@kernel
def _bounce_on_rail(
    ball: Floats, world: Floats, events: Floats, counts: Ints, who: int, now: float
) -> bool:
    """Let a ball bounce, or run on by small hops, on top of the rail; say whether it goes on."""
    speed = meet_bed(ball, world)
    ball[Z] = world[G_NOSE] + ball[RADIUS]
    if speed * speed > 4.0 * world[G_GRAVITY] * RUN:
        note(events, counts, LANDED, now, who, ON_RAIL, speed)
    if ball[VZ] > 0.0:
        return True
    square, pay = ball[VX] ** 2 + ball[VY] ** 2, 2.0 * world[G_GRAVITY] * RUN
    if square <= 2.0 * pay:
        return False
    factor = sqrt(1.0 - pay / square)
    ball[VX] *= factor
    ball[VY] *= factor
    ball[VZ] = sqrt(pay) * (1.0 - 1e-12)
    return True


@kernel_with_arrays
def _settle(
    balls: Floats,
    kinds: Ints,
    world: Floats,
    noses: Floats,
    pockets: Floats,
    pairs: Floats,
    foreseen: Floats,
    events: Floats,
    counts: Ints,
    i: int,
    box: Floats,
) -> None:
    """Begin the piece that follows an event in the air and foresee it."""
    now = balls[i, T0]
    if kinds[i] not in (FLY, GONE):
        kinds[i] = begin(balls[i], world)
        if kinds[i] == REST:
            note(events, counts, STOPPED, now, i, -1.0, 0.0)
    bedded = np.empty(kinds.shape[0], dtype=np.int64)
    _hide(kinds, bedded)
    foresee(balls, bedded, noses, pockets, pairs, foreseen, i, now, box)
    if kinds[i] == FLY:
        _soar(balls[i], world, noses, pockets, foreseen[i])


__all__ = ["DOWN", "run_flying"]
