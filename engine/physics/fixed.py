"""The solvers `corrective` and `preemptive` of the 2012 report: fixed time steps, for comparison.

One idea: both ask only once per step what touches what. `corrective` moves all balls and then
pushes overlaps apart; `preemptive` moves one ball after the other, each up to the first thing in
its way, the others standing where they are. Motion between contacts is as exact as elsewhere, so
a difference from `stepwise` is the solver's own. Invariant: steps fall on multiples of `step`,
so chunks of time change no bit; but balls may tunnel, jump, and depend on their order.
"""

from __future__ import annotations

from math import sqrt
from typing import TYPE_CHECKING

import numpy as np

from engine.geometry.kernel import kernel, kernel_with_arrays
from engine.physics.collide import closing_speed, strike_apart
from engine.physics.motion import begin, place_at
from engine.physics.predict import NEVER, closes, nose_time
from engine.physics.rebound import bounce
from engine.physics.record import (
    change,
    drop,
    faster_first,
    into,
    move,
    note,
    restart,
)
from engine.physics.state import (
    AX,
    AY,
    CAP,
    DONE,
    DROPPED,
    END,
    EVENTS,
    FAST,
    FULL,
    GONE,
    N_CURVED,
    N_DX,
    N_DY,
    N_SIZE,
    N_SPAN,
    N_UPRIGHT,
    N_X,
    N_Y,
    NOSE,
    PAUSED,
    PIECES,
    RADIUS,
    REACH,
    REST,
    ROLL,
    SLIDE,
    STARTED,
    STORM,
    T0,
    TOUCHING,
    VX,
    VY,
    X,
    Y,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Ints = NDArray[np.int64]

CORRECTIVE, PREEMPTIVE = range(2)
HITS = 8
"""How often one ball may hit something within one step."""


@kernel
def run_fixed(
    balls: Floats,
    kinds: Ints,
    world: Floats,
    noses: Floats,
    pockets: Floats,
    pieces: Floats,
    events: Floats,
    counts: Ints,
    clock: Floats,
    until: float,
    step: float,
    solver: int,
) -> int:
    """Carry out all steps up to `until` (s); return DONE, PAUSED, FULL or STORM."""
    n = balls.shape[0]
    spare = 4 * HITS * (n * n + n + 8)
    if counts[STARTED] == 0:
        counts[STARTED] = 1
        for i in range(n):
            kinds[i] = begin(balls[i], world)
    while True:
        if counts[PIECES] + spare > pieces.shape[0] or counts[EVENTS] + spare > events.shape[0]:
            return FULL
        if counts[EVENTS] > counts[CAP]:
            return STORM
        idle = True
        for i in range(n):
            idle = idle and kinds[i] in (REST, GONE)
        if idle:
            return DONE
        following = (counts[STARTED]) * step
        if following > until:
            return PAUSED
        now = (counts[STARTED] - 1) * step
        counts[STARTED] += 1
        if solver == CORRECTIVE:
            _correct(balls, kinds, world, noses, pieces, events, counts, following)
        else:
            _preempt(balls, kinds, world, noses, pieces, events, counts, now, following)
        _catch(balls, kinds, pockets, pieces, events, counts, following)
        clock[0] = following


@kernel
def _age(
    balls: Floats,
    kinds: Ints,
    world: Floats,
    pieces: Floats,
    events: Floats,
    counts: Ints,
    i: int,
    now: float,
) -> None:
    """Let the ball's pieces end by themselves up to `now`."""
    while kinds[i] != GONE and balls[i, END] <= now:
        change(balls, kinds, world, pieces, events, counts, i)


@kernel
def _correct(
    balls: Floats,
    kinds: Ints,
    world: Floats,
    noses: Floats,
    pieces: Floats,
    events: Floats,
    counts: Ints,
    now: float,
) -> None:
    """Move all, then push apart what overlaps."""
    n = balls.shape[0]
    for i in range(n):
        _age(balls, kinds, world, pieces, events, counts, i, now)
    for i in range(n):
        for j in range(i + 1, n):
            if kinds[i] != GONE and kinds[j] != GONE:
                _part(balls, kinds, world, pieces, events, counts, i, j, now)
    for i in range(n):
        if kinds[i] in (ROLL, SLIDE, FAST):
            for k in range(noses.shape[0]):
                _push_out(balls, kinds, world, noses, pieces, events, counts, i, k, now)


@kernel
def _part(
    balls: Floats,
    kinds: Ints,
    world: Floats,
    pieces: Floats,
    events: Floats,
    counts: Ints,
    i: int,
    j: int,
    now: float,
) -> None:
    x, y = place_at(balls[i], now)
    u, v = place_at(balls[j], now)
    dx, dy = u - x, v - y
    apart = sqrt(dx * dx + dy * dy)
    need = 2.0 * sqrt(balls[i, RADIUS] * balls[j, RADIUS])
    if apart >= need or apart == 0.0:
        return
    move(balls, kinds, pieces, counts, i, now)
    move(balls, kinds, pieces, counts, j, now)
    push = 0.5 * (need - apart) / apart
    balls[i, X] -= push * dx
    balls[i, Y] -= push * dy
    balls[j, X] += push * dx
    balls[j, Y] += push * dy
    _collide(balls, world, events, counts, i, j, now)
    restart(balls, kinds, world, events, counts, i, now)
    restart(balls, kinds, world, events, counts, j, now)


@kernel
def _collide(
    balls: Floats, world: Floats, events: Floats, counts: Ints, one: int, two: int, now: float
) -> None:
    """Resolve the blow of two balls that touch and approach, and note it."""
    speed = closing_speed(balls[one], balls[two])
    if speed > 0.0:
        first, second = faster_first(balls, one, two)
        strike_apart(balls[one], balls[two], world)
        note(events, counts, TOUCHING, now, first, float(second), speed)


@kernel
def _depth(ball: Floats, nose: Floats, x: float, y: float) -> float:
    """Return how deep (m) a ball at (x, y) lies in a nose; at most zero where it does not."""
    dx, dy = x - nose[N_X], y - nose[N_Y]
    own = ball[RADIUS] if nose[N_UPRIGHT] != 0.0 else ball[REACH]
    if nose[N_CURVED] == 0.0:
        at = dx * nose[N_DX] + dy * nose[N_DY]
        depth = own - (dy * nose[N_DX] - dx * nose[N_DY])
        return depth if 0.0 <= at <= nose[N_SIZE] and depth < 4.0 * ball[RADIUS] else 0.0
    reach = sqrt(dx * dx + dy * dy)
    if dx * nose[N_DX] + dy * nose[N_DY] < reach * nose[N_SPAN]:
        return 0.0
    if nose[N_SIZE] < 0.0:
        return reach - (-nose[N_SIZE] - own)
    return nose[N_SIZE] + own - reach


@kernel
def _push_out(
    balls: Floats,
    kinds: Ints,
    world: Floats,
    noses: Floats,
    pieces: Floats,
    events: Floats,
    counts: Ints,
    i: int,
    k: int,
    now: float,
) -> None:
    x, y = place_at(balls[i], now)
    depth = _depth(balls[i], noses[k], x, y)
    if depth <= 0.0:
        return
    move(balls, kinds, pieces, counts, i, now)
    ix, iy = into(balls[i], noses[k])
    balls[i, X] -= depth * ix
    balls[i, Y] -= depth * iy
    if balls[i, VX] * ix + balls[i, VY] * iy > 0.0:
        speed = bounce(balls[i], world, noses[k], ix, iy)
        note(events, counts, NOSE, now, i, float(k), speed)
    restart(balls, kinds, world, events, counts, i, now)


@kernel_with_arrays
def _preempt(
    balls: Floats,
    kinds: Ints,
    world: Floats,
    noses: Floats,
    pieces: Floats,
    events: Floats,
    counts: Ints,
    now: float,
    following: float,
) -> None:
    """Move one ball after the other, each up to what stands in its way."""
    n = balls.shape[0]
    at = np.full(n, now)
    for i in range(n):
        for _ in range(HITS):
            if kinds[i] == GONE or at[i] >= following:
                break
            last = min(following, balls[i, END])
            if kinds[i] in (ROLL, SLIDE, FAST):
                t, other, nose = _first_hit(balls, kinds, noses, at, i, last)
                if t <= last:
                    _hit(balls, kinds, world, noses, pieces, events, counts, at, i, t, other, nose)
                    continue
            at[i] = last
            _age(balls, kinds, world, pieces, events, counts, i, last)
        _age(balls, kinds, world, pieces, events, counts, i, following)


@kernel_with_arrays
def _first_hit(
    balls: Floats, kinds: Ints, noses: Floats, at: Floats, i: int, last: float
) -> tuple[float, int, int]:
    """Return when ball `i` first meets a ball that stands as it is, or a nose, and which."""
    ball = balls[i].copy()
    s = at[i] - ball[T0]
    ball[X], ball[Y] = place_at(balls[i], at[i])
    ball[VX] += s * ball[AX]
    ball[VY] += s * ball[AY]
    ball[T0], ball[END] = at[i], last
    best, other, nose = NEVER, -1, -1
    for j in range(balls.shape[0]):
        if j == i or kinds[j] == GONE:
            continue
        x, y = place_at(balls[j], at[j])
        need = 2.0 * sqrt(ball[RADIUS] * balls[j, RADIUS])
        ax, ay = -0.5 * ball[AX], -0.5 * ball[AY]
        t = at[i] + closes(
            x - ball[X], y - ball[Y], -ball[VX], -ball[VY], ax, ay, need, last - at[i]
        )
        if t < best:
            best, other = t, j
    for k in range(noses.shape[0]):
        t = nose_time(ball, noses[k], last - at[i])
        if t < best:
            best, other, nose = t, -1, k
    return best, other, nose


@kernel
def _hit(
    balls: Floats,
    kinds: Ints,
    world: Floats,
    noses: Floats,
    pieces: Floats,
    events: Floats,
    counts: Ints,
    at: Floats,
    i: int,
    t: float,
    other: int,
    nose: int,
) -> None:
    move(balls, kinds, pieces, counts, i, t)
    at[i] = t
    if other < 0:
        ix, iy = into(balls[i], noses[nose])
        note(events, counts, NOSE, t, i, float(nose), bounce(balls[i], world, noses[nose], ix, iy))
    else:
        move(balls, kinds, pieces, counts, other, at[other])
        _collide(balls, world, events, counts, i, other, t)
        restart(balls, kinds, world, events, counts, other, at[other])
    restart(balls, kinds, world, events, counts, i, t)


@kernel
def _catch(
    balls: Floats,
    kinds: Ints,
    pockets: Floats,
    pieces: Floats,
    events: Floats,
    counts: Ints,
    now: float,
) -> None:
    """Drop the balls that are over a pocket at the end of the step."""
    for i in range(balls.shape[0]):
        if kinds[i] == GONE:
            continue
        x, y = place_at(balls[i], now)
        for k in range(pockets.shape[0]):
            dx, dy, size = x - pockets[k, 0], y - pockets[k, 1], pockets[k, 2]
            if kinds[i] != GONE and dx * dx + dy * dy <= size * size:
                drop(balls, kinds, pieces, counts, i, now)
                note(events, counts, DROPPED, now, i, float(k), 0.0)


__all__ = ["CORRECTIVE", "PREEMPTIVE", "run_fixed"]
