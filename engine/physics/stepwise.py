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

from engine.geometry.kernel import kernel, kernel_with_arrays
from engine.physics.collide import closing_speed, strike_apart
from engine.physics.foresee import foresee, next_event
from engine.physics.motion import begin, place_at
from engine.physics.predict import NEVER
from engine.physics.rebound import meet_nose
from engine.physics.record import (
    change,
    drop,
    faster_first,
    into,
    move,
    note,
    restart,
)
from engine.physics.shock import C_A, C_B, C_ORDER, C_SPEED, CONTACT_WIDTH, gather, spread
from engine.physics.state import (
    ASK,
    ASK_ALARM,
    ASK_CLUSTER,
    ASK_DROP,
    ASK_NOSE,
    ASK_OTHER,
    ASK_PAIR,
    ASK_WHAT,
    ASK_WHO,
    C_ALARM,
    CAP,
    D_MODEL,
    DONE,
    DROP_EDGE,
    DROPPED,
    EVENTS,
    FLY,
    FRICTIONAL,
    FULL,
    G_BALL_BALL,
    G_CLUSTER,
    G_TOUCH,
    GONE,
    HERTZ,
    K_DROP,
    K_NOSE,
    K_PAIR,
    K_TOUCHED,
    MATHAVAN,
    N_MODEL,
    N_PIN,
    NOSE,
    PAUSED,
    PIECES,
    RADIUS,
    REST,
    SOFT,
    STARTED,
    STORM,
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


@kernel_with_arrays
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
    """Carry out all events up to `until` (s); return DONE, PAUSED, FULL, STORM or ASK."""
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
            foresee(balls, kinds, noses, pockets, pairs, foreseen, i, 0.0, box)
    while True:
        if counts[PIECES] + spare > pieces.shape[0] or counts[EVENTS] + spare > events.shape[0]:
            return FULL
        if counts[EVENTS] > counts[CAP]:
            return STORM
        tier, who, now = next_event(balls, kinds, foreseen)
        if clock[C_ALARM] < now and clock[C_ALARM] <= until:
            return ask(counts, clock, ASK_ALARM, who, who, clock[C_ALARM])
        if now == NEVER:
            return DONE
        if now > until:
            return PAUSED
        now = max(now, clock[0])
        clock[0] = now
        if tier == 0:
            pocket = int(foreseen[who, K_DROP])
            if pockets[pocket, D_MODEL] != DROP_EDGE:
                move(balls, kinds, pieces, counts, who, now)
                foreseen[who, K_TOUCHED] = 1.0
                return ask(counts, clock, ASK_DROP, who, pocket, now)
            drop(balls, kinds, pieces, counts, who, now)
            note(events, counts, DROPPED, now, who, foreseen[who, K_DROP], 0.0)
            foresee(balls, kinds, noses, pockets, pairs, foreseen, who, now, box)
        elif tier == 1:
            other = int(foreseen[who, K_PAIR])
            count = meet_balls(
                balls, kinds, world, pieces, events, counts, members, contacts, who, other, now
            )
            if count < 0:
                for p in range(-count):
                    foreseen[members[p], K_TOUCHED] = 1.0
                return ask(counts, clock, ASK_PAIR if count == -2 else ASK_CLUSTER, who, other, now)
            for p in range(count):
                foresee(balls, kinds, noses, pockets, pairs, foreseen, members[p], now, box)
        elif tier == 2:
            nose = int(foreseen[who, K_NOSE])
            move(balls, kinds, pieces, counts, who, now)
            ix, iy = into(balls[who], noses[nose])
            speed = balls[who, VX] * ix + balls[who, VY] * iy
            rare = noses[nose, N_MODEL] > MATHAVAN or noses[nose, N_PIN] >= 0.0
            if rare and speed >= SOFT:
                foreseen[who, K_TOUCHED] = 1.0
                return ask(counts, clock, ASK_NOSE, who, nose, now)
            speed = meet_nose(balls[who], world, noses[nose], ix, iy)
            note(events, counts, NOSE, now, who, float(nose), speed)
            restart(balls, kinds, world, events, counts, who, now)
            foresee(balls, kinds, noses, pockets, pairs, foreseen, who, now, box)
        else:
            change(balls, kinds, world, pieces, events, counts, who)
            foresee(balls, kinds, noses, pockets, pairs, foreseen, who, now, box)


@kernel_with_arrays
def meet_balls(
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
    """Resolve a meeting of two balls, or of a cluster they touch; return how many were moved.

    A negative number says that the meeting of so many members is for others to resolve.
    """
    move(balls, kinds, pieces, counts, one, now)
    move(balls, kinds, pieces, counts, two, now)
    members[0], members[1], count = one, two, 2
    speed = closing_speed(balls[one], balls[two])
    if speed >= SOFT and _company(balls, kinds, one, two, now, world[G_TOUCH]):
        present = np.zeros(balls.shape[0], dtype=np.int64)
        for i in range(balls.shape[0]):
            present[i] = 1 if kinds[i] != GONE else 0
        count = _gather_now(balls, kinds, world, pieces, counts, present, members, one, two, now)
    rare = world[G_BALL_BALL] > FRICTIONAL if count == 2 else world[G_CLUSTER] != HERTZ
    if rare and speed >= SOFT:
        return -count
    if count == 2:
        first, second = faster_first(balls, one, two)
        strike_apart(balls[one], balls[two], world)
        note(events, counts, TOUCHING, now, first, float(second), speed)
    else:
        first, second = faster_first(balls, one, two)
        note(events, counts, TOUCHING, now, first, float(second), speed)
        total = spread(balls, members, count, world, contacts)
        _note_contacts(events, counts, contacts, total, one, two, now)
    for p in range(count):
        restart(balls, kinds, world, events, counts, members[p], now)
    return count


@kernel
def ask(counts: Ints, clock: Floats, what: float, who: int, other: int, now: float) -> int:
    """Leave what is asked in the counts and its time in the clock; return ASK."""
    counts[ASK_WHAT], counts[ASK_WHO], counts[ASK_OTHER] = int(what), who, other
    clock[0] = max(now, clock[0])
    return ASK


@kernel_with_arrays
def resume(
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
    everyone: bool,  # noqa: FBT001  numba knows no keywords
) -> None:
    """Go on after an answer: begin the touched balls' pieces and foresee them, or `everyone`.

    Touched are those with K_TOUCHED, which is cleared; their rows hold r, v and w at the clock's
    time. Balls that fly are left to `flight`.
    """
    n, now = balls.shape[0], clock[0]
    box = np.empty(4)
    bedded = np.empty(n, dtype=np.int64)
    for i in range(n):
        if everyone and foreseen[i, K_TOUCHED] == 0.0 and kinds[i] not in (REST, GONE, FLY):
            move(balls, kinds, pieces, counts, i, now)
            foreseen[i, K_TOUCHED] = 1.0
        if foreseen[i, K_TOUCHED] != 0.0 and kinds[i] not in (GONE, FLY):
            restart(balls, kinds, world, events, counts, i, now)
        bedded[i] = GONE if kinds[i] == FLY else kinds[i]
    for i in range(n):
        if foreseen[i, K_TOUCHED] != 0.0:
            foreseen[i, K_TOUCHED] = 0.0
            foresee(balls, bedded, noses, pockets, pairs, foreseen, i, now, box)


@kernel
def _company(balls: Floats, kinds: Ints, one: int, two: int, now: float, gap: float) -> bool:
    """Say whether a third ball touches one of the two."""
    for k in range(balls.shape[0]):
        if k in (one, two) or kinds[k] == GONE:
            continue
        x, y = place_at(balls[k], now)
        for i in (one, two):
            dx, dy = x - balls[i, X], y - balls[i, Y]
            touch = 2.0 * sqrt(balls[i, RADIUS] * balls[k, RADIUS]) + gap
            if dx * dx + dy * dy <= touch * touch:
                return True
    return False


@kernel_with_arrays
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
        here[i, X], here[i, Y] = place_at(balls[i], now)
    count = gather(here, present, one, two, members, world[G_TOUCH])
    for p in range(count):
        if members[p] not in (one, two):
            move(balls, kinds, pieces, counts, members[p], now)
    return count


@kernel
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
                note(events, counts, TOUCHING, now, a, float(b), row[C_SPEED])


__all__ = ["ask", "meet_balls", "resume", "run"]
