"""Blows through touching balls without springs: cluster models `simultaneous` and `sequential`.

One idea: rigid balls exchange impulses at once. `simultaneous` finds them all together: the motion
after is the one nearest to that before (in the metric of kinetic energy) in which every touching
pair parts at least e times as fast as it neared; so it is unique, no label matters, and a layout
with a mirror keeps it (Moreau's sweeping law; J. J. Moreau 1988, with Newton's restitution).
`sequential` lets one pair after the other collide, the fastest approach first, of equals the one
further left as seen from the head, then the one nearer the head; it is what many simulators do, it
breaks the mirror of a layout, and it is given up after a number of blows, when `simultaneous`
without restitution ends what is left. Invariant: momentum is exact, energy is never gained.
"""

from __future__ import annotations

from math import sqrt
from typing import TYPE_CHECKING

import numpy as np

from engine.geometry.kernel import kernel_with_arrays
from engine.physics.collide import find_rub, give_rub, restitution, strike_apart
from engine.physics.shock import (
    C_A,
    C_ACROSS,
    C_B,
    C_FROZEN,
    C_NX,
    C_NY,
    C_ORDER,
    C_SPEED,
    C_UP,
    NEARBY,
)
from engine.physics.state import (
    ELASTIC,
    G_BALL_BALL,
    G_TOUCH,
    MASS,
    RADIUS,
    SOFT,
    VX,
    VY,
    X,
    Y,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Ints = NDArray[np.int64]

SWEEPS = 20_000
"""Sweeps over all contacts in search of the impulses."""

CLOSE = 4e-15
"""Change of an impulse, in parts of the greatest, with which the search ends."""

ROUNDS = 40
"""Blows at once after which what still nears does not bounce."""

BLOWS = 200
"""Blows one by one for each contact, after which what still nears does not bounce."""

TIE = 1e-9
"""Approaches as fast as each other, in parts."""


@kernel_with_arrays
def spread_at_once(
    balls: Floats, members: Ints, count: int, world: Floats, contacts: Floats
) -> int:
    """Let a blow run through the members at once; return how many `contacts` describe it.

    The columns of `contacts` are those of `engine.physics.shock`.
    """
    total = _touching(balls, members, count, contacts, world[G_TOUCH])
    row = contacts[:total]
    order = 1.0
    for turn in range(ROUNDS + 1):
        fastest = _fastest(balls, row)
        if fastest <= SOFT and turn > 0:
            break
        e = _least_lively(balls, row, world, fastest) if turn < ROUNDS else 0.0
        order = _round(balls, world, row, fastest, order, e)
    return total


@kernel_with_arrays
def spread_one_by_one(
    balls: Floats, members: Ints, count: int, world: Floats, contacts: Floats
) -> int:
    """Let a blow run through the members pair by pair; return how many `contacts` describe it."""
    total = _touching(balls, members, count, contacts, world[G_TOUCH])
    order = 1.0
    for _ in range(BLOWS * total):
        chosen = _next_pair(balls, contacts[:total])
        if chosen < 0:
            return total
        row = contacts[chosen]
        speed = strike_apart(balls[int(row[C_A])], balls[int(row[C_B])], world)
        row[C_SPEED] = max(row[C_SPEED], speed)
        if row[C_ORDER] == 0.0:
            row[C_ORDER] = order
            order += 1.0
    _round(balls, world, contacts[:total], _fastest(balls, contacts[:total]), order, 0.0)
    return total


@kernel_with_arrays
def _touching(balls: Floats, members: Ints, count: int, contacts: Floats, touch: float) -> int:
    """Fill `contacts` with all pairs of members that touch; return how many."""
    total = 0
    for p in range(count):
        for q in range(p + 1, count):
            one, two = balls[members[p]], balls[members[q]]
            x, y = two[X] - one[X], two[Y] - one[Y]
            reach = sqrt(x * x + y * y)
            if reach - 2.0 * sqrt(one[RADIUS] * two[RADIUS]) > min(touch, NEARBY):
                continue
            row = contacts[total]
            row[:] = 0.0
            row[C_A], row[C_B], row[C_NX], row[C_NY] = members[p], members[q], x / reach, y / reach
            row[C_FROZEN] = 1.0
            total += 1
    return total


@kernel_with_arrays
def _nearing(balls: Floats, row: Floats) -> float:
    one, two = balls[int(row[C_A])], balls[int(row[C_B])]
    return (one[VX] - two[VX]) * row[C_NX] + (one[VY] - two[VY]) * row[C_NY]


@kernel_with_arrays
def _fastest(balls: Floats, contacts: Floats) -> float:
    fastest = 0.0
    for c in range(contacts.shape[0]):
        fastest = max(fastest, _nearing(balls, contacts[c]))
    return fastest


@kernel_with_arrays
def _next_pair(balls: Floats, contacts: Floats) -> int:
    """Return the contact to go first, or -1 where none nears faster than a resting one."""
    fastest = _fastest(balls, contacts)
    chosen, left, ahead = -1, 0.0, 0.0
    for c in range(contacts.shape[0]):
        row = contacts[c]
        speed = _nearing(balls, row)
        if speed <= SOFT or speed < fastest * (1.0 - TIE):
            continue
        x = balls[int(row[C_A]), X] + balls[int(row[C_B]), X]
        y = balls[int(row[C_A]), Y] + balls[int(row[C_B]), Y]
        if chosen < 0 or y > left + TIE or (y > left - TIE and x < ahead):
            chosen, left, ahead = c, y, x
    return chosen


@kernel_with_arrays
def _round(
    balls: Floats,
    world: Floats,
    contacts: Floats,
    fastest: float,
    order: float,
    e: float,
) -> float:
    """Give all contacts their impulses at once; return the next free place in the order."""
    total = contacts.shape[0]
    goal, impulse = np.empty(total), np.zeros(total)
    for c in range(total):
        # also of a pair that parts, which may then near: a later round sees to that
        goal[c] = (1.0 + e) * _nearing(balls, contacts[c])
    _balance(balls, contacts, goal, impulse, fastest)
    for c in range(total):
        row = contacts[c]
        if impulse[c] > 0.0:
            row[C_SPEED] = max(row[C_SPEED], _nearing(balls, row))
            if row[C_ORDER] == 0.0:
                row[C_ORDER] = order
                order += 1.0
    _push(balls, contacts, impulse)
    if world[G_BALL_BALL] != ELASTIC:
        _rub(balls, world, contacts, impulse)
    return order


@kernel_with_arrays
def _least_lively(balls: Floats, contacts: Floats, world: Floats, speed: float) -> float:
    """Return the least restitution of the contacts: one for all, so that no energy is gained."""
    least = 1.0
    for c in range(contacts.shape[0]):
        a, b = int(contacts[c, C_A]), int(contacts[c, C_B])
        least = min(least, restitution(balls[a], balls[b], world, speed))
    return least


@kernel_with_arrays
def _balance(
    balls: Floats, contacts: Floats, goal: Floats, impulse: Floats, fastest: float
) -> None:
    """Fill `impulse` (N s, none below zero) so that every contact reaches its goal or is free.

    Gauss and Seidel's method with each impulse kept from pulling; sweeps go to and fro.
    """
    total = contacts.shape[0]
    given = np.zeros((balls.shape[0], 2))
    scale = fastest * balls[int(contacts[0, C_A]), MASS]
    for sweep in range(SWEEPS):
        change = 0.0
        for k in range(total):
            c = k if sweep % 2 == 0 else total - 1 - k
            row = contacts[c]
            a, b, nx, ny = int(row[C_A]), int(row[C_B]), row[C_NX], row[C_NY]
            light = 1.0 / balls[a, MASS] + 1.0 / balls[b, MASS]
            left = goal[c] + (given[a, 0] - given[b, 0]) * nx + (given[a, 1] - given[b, 1]) * ny
            new = max(0.0, impulse[c] + left / light)
            step = new - impulse[c]
            if step == 0.0:
                continue
            impulse[c] = new
            change = max(change, abs(step))
            for i, sign in ((a, -1.0), (b, 1.0)):
                given[i, 0] += sign * step * nx / balls[i, MASS]
                given[i, 1] += sign * step * ny / balls[i, MASS]
        if change <= CLOSE * scale:
            break


@kernel_with_arrays
def _push(balls: Floats, contacts: Floats, impulse: Floats) -> None:
    for c in range(contacts.shape[0]):
        row = contacts[c]
        one, two = balls[int(row[C_A])], balls[int(row[C_B])]
        one[VX] -= impulse[c] * row[C_NX] / one[MASS]
        one[VY] -= impulse[c] * row[C_NY] / one[MASS]
        two[VX] += impulse[c] * row[C_NX] / two[MASS]
        two[VY] += impulse[c] * row[C_NY] / two[MASS]


@kernel_with_arrays
def _rub(balls: Floats, world: Floats, contacts: Floats, impulse: Floats) -> None:
    """Apply the friction of every contact, found from the motion before any of it.

    Each may stop its share of the slip, one over the contacts of the busier ball, so that all
    together cannot give more energy than they take.
    """
    busy = np.zeros(balls.shape[0])
    for c in range(contacts.shape[0]):
        if impulse[c] > 0.0:
            busy[int(contacts[c, C_A])] += 1.0
            busy[int(contacts[c, C_B])] += 1.0
    for c in range(contacts.shape[0]):
        row = contacts[c]
        row[C_ACROSS] = row[C_UP] = 0.0
        if impulse[c] > 0.0:
            a, b = int(row[C_A]), int(row[C_B])
            share = 1.0 / max(busy[a], busy[b])
            row[C_ACROSS], row[C_UP] = find_rub(
                balls[a], balls[b], world, row[C_NX], row[C_NY], impulse[c], share
            )
    for c in range(contacts.shape[0]):
        row = contacts[c]
        if impulse[c] > 0.0:
            one, two = balls[int(row[C_A])], balls[int(row[C_B])]
            give_rub(one, two, row[C_NX], row[C_NY], row[C_ACROSS], row[C_UP])


__all__ = ["spread_at_once", "spread_one_by_one"]
