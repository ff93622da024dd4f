"""A blow that runs through balls that touch each other: a local compliant step.

One idea: inside a frozen cluster one impulse after the other depends on the order, so all contacts
push at once, as Hertz springs F = K d^1.5, weaker by e^2 when they unload (Walton & Braun 1986).
First with the balls' tiny way counted, then with the normals as they lie, until no touching
pair nears. Places and the clock stand still meanwhile (a blow lasts some 0.3 ms and moves a ball by
less than 1 mm). Invariant: momentum is exact, energy is never gained, no label matters.
"""

from __future__ import annotations

from math import sqrt
from typing import TYPE_CHECKING

import numpy as np

from engine.geometry.kernel import kernel, kernel_with_arrays
from engine.physics.collide import find_rub, give_rub, restitution
from engine.physics.state import (
    ELASTIC,
    G_BALL_BALL,
    G_TOUCH,
    MASS,
    RADIUS,
    SOFT,
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

STIFFNESS = 8.0586699e8
"""K of two phenolic balls, N/m^1.5; no result but the balls' tiny way depends on it."""

TOUCH = 2e-6
"""Balls with a gap no wider than this (m) push each other as they lie."""

TIGHT = 1e-9
"""The same where the ways through the gaps count."""

NEARBY = 1e-3
STEPS, WEAK_STEPS = 400, 30
"""Steps in the time that two balls touch; the error falls with their square (7e-6 m/s at 1 m/s)."""

WEAK = 0.01
"""A blow (m/s) that needs no more than WEAK_STEPS: balls pressed into others give many of them."""

(C_A, C_B, C_LENGTH, C_NX, C_NY, C_ORDER, C_SPEED, C_FROZEN, C_UX, C_UY, C_ACROSS, C_UP) = range(12)
CONTACT_WIDTH = 12
"""Two balls, the length at which they touch, their normal as they lie; when the blow came and how
fast they neared; whether they touch; and of this step the normal and the friction impulse."""


@kernel_with_arrays
def gather(
    balls: Floats, present: Ints, first: int, second: int, members: Ints, touch: float
) -> int:
    """Fill `members` with all within `touch` (m) of one another, from the two; return how many."""
    n = balls.shape[0]
    inside = np.zeros(n, dtype=np.bool_)
    inside[first] = inside[second] = True
    grew = True
    while grew:
        grew = False
        for i in range(n):
            if not inside[i]:
                continue
            for j in range(n):
                if present[j] == 0 or inside[j] or _gap(balls[i], balls[j]) > touch:
                    continue
                inside[j] = grew = True
    count = 0
    for i in range(n):
        if inside[i]:
            members[count] = i
            count += 1
    return count


@kernel
def _gap(one: Floats, two: Floats) -> float:
    x, y = two[X] - one[X], two[Y] - one[Y]
    return sqrt(x * x + y * y) - 2.0 * sqrt(one[RADIUS] * two[RADIUS])


@kernel_with_arrays
def spread(balls: Floats, members: Ints, count: int, world: Floats, contacts: Floats) -> int:
    """Let a blow run through the members; return how many `contacts` rows describe it."""
    total = _contacts(balls, members, count, contacts, world[G_TOUCH])
    before = _energy(balls, members, count)
    way = np.zeros((balls.shape[0], 2))
    order = _round(balls, members, count, world, contacts[:total], way, 1.0, 1.0)
    for _ in range(60):
        for i in range(way.shape[0]):
            way[i, 0] = way[i, 1] = 0.0
        if _fastest(balls, contacts[:total]) <= SOFT:
            break
        order = _round(balls, members, count, world, contacts[:total], way, 0.0, order)
    _forbid_gain(balls, members, count, before)
    return total


@kernel
def _contacts(balls: Floats, members: Ints, count: int, contacts: Floats, touch: float) -> int:
    """Fill `contacts` with all pairs that may push each other in this blow; return how many."""
    # where wider gaps belong to a blow, the ways through them count, and so do those of tight ones
    closed = TOUCH if touch <= TOUCH else TIGHT
    total = 0
    for p in range(count):
        for q in range(p + 1, count):
            one, two = balls[members[p]], balls[members[q]]
            gap = _gap(one, two)
            if gap > NEARBY:
                continue
            row = contacts[total]
            x, y = two[X] - one[X], two[Y] - one[Y]
            reach = sqrt(x * x + y * y)
            row[C_A], row[C_B], row[C_NX], row[C_NY] = members[p], members[q], x / reach, y / reach
            row[C_FROZEN] = 1.0 if gap <= TOUCH else 0.0
            row[C_LENGTH] = reach if gap <= closed else reach - gap
            row[C_ORDER] = row[C_SPEED] = 0.0
            total += 1
    return total


@kernel
def _fastest(balls: Floats, contacts: Floats) -> float:
    """Return the greatest speed at which touching members near each other."""
    fastest = 0.0
    for c in range(contacts.shape[0]):
        row = contacts[c]
        if row[C_FROZEN] != 0.0:
            fastest = max(fastest, _nearing(balls, row, row[C_NX], row[C_NY]))
    return fastest


@kernel
def _nearing(balls: Floats, row: Floats, nx: float, ny: float) -> float:
    one, two = balls[int(row[C_A])], balls[int(row[C_B])]
    return (one[VX] - two[VX]) * nx + (one[VY] - two[VY]) * ny


@kernel_with_arrays
def _round(
    balls: Floats,
    members: Ints,
    count: int,
    world: Floats,
    contacts: Floats,
    way: Floats,
    moving: float,
    order: float,
) -> float:
    """Integrate until all contacts have opened; return the next free place in the order."""
    speed = _fastest(balls, contacts)
    reduced = 0.5 * balls[members[0], MASS]
    depth = (1.25 * reduced * speed * speed / STIFFNESS) ** 0.4
    steps = STEPS if speed > WEAK else WEAK_STEPS
    step = 2.943 * depth / speed / steps
    quiet = 0
    force = np.zeros(contacts.shape[0])
    for tick in range(200 * steps):
        half = 0.5 * step if tick == 0 else step
        active = _push(balls, world, contacts, way, force, half, moving)
        for c in range(contacts.shape[0]):
            if force[c] > 0.0 and contacts[c, C_ORDER] == 0.0:
                contacts[c, C_ORDER] = order
                order += 1.0
        quiet = 0 if active else quiet + 1
        if tick > 2 and quiet > (steps // 2 if moving > 0.0 else 0):
            break
        for p in range(count):
            i = members[p]
            way[i, 0] += balls[i, VX] * step
            way[i, 1] += balls[i, VY] * step
    return order


@kernel
def _push(
    balls: Floats,
    world: Floats,
    contacts: Floats,
    way: Floats,
    force: Floats,
    step: float,
    moving: float,
) -> bool:
    """Give every contact's impulse of one step; forces first, from places alone."""
    active = False
    for c in range(contacts.shape[0]):
        row = contacts[c]
        a, b = int(row[C_A]), int(row[C_B])
        dx, dy = way[b, 0] - way[a, 0], way[b, 1] - way[a, 1]
        nx, ny = row[C_NX], row[C_NY]
        force[c] = 0.0
        if moving > 0.0:
            x = balls[b, X] - balls[a, X] + dx
            y = balls[b, Y] - balls[a, Y] + dy
            reach = sqrt(x * x + y * y)
            nx, ny, depth = x / reach, y / reach, row[C_LENGTH] - reach
        elif row[C_FROZEN] != 0.0:
            depth = -(dx * nx + dy * ny)
        else:
            depth = 0.0
        if depth <= 0.0:
            continue
        active = True
        nearing = _nearing(balls, row, nx, ny)
        row[C_SPEED] = max(row[C_SPEED], nearing)
        row[C_UX], row[C_UY] = nx, ny
        e = restitution(balls[a], balls[b], world, row[C_SPEED])
        part = 1.0 if nearing > 0.0 else e * e
        force[c] = part * STIFFNESS * depth * sqrt(depth)
    rubs = world[G_BALL_BALL] != ELASTIC
    for c in range(contacts.shape[0]):
        if force[c] > 0.0 and rubs:
            row = contacts[c]
            one, two = balls[int(row[C_A])], balls[int(row[C_B])]
            row[C_ACROSS], row[C_UP] = find_rub(
                one, two, world, row[C_UX], row[C_UY], force[c] * step, 0.15
            )
    for c in range(contacts.shape[0]):
        if force[c] > 0.0:
            _give(balls, contacts[c], force[c] * step, rubs)
    return active


@kernel
def _give(balls: Floats, row: Floats, impulse: float, rubs: bool) -> None:  # noqa: FBT001
    """Apply one contact's impulses, all of which were found before any is applied."""
    one, two = balls[int(row[C_A])], balls[int(row[C_B])]
    nx, ny = row[C_UX], row[C_UY]
    one[VX] -= impulse * nx / one[MASS]
    one[VY] -= impulse * ny / one[MASS]
    two[VX] += impulse * nx / two[MASS]
    two[VY] += impulse * ny / two[MASS]
    if rubs:
        give_rub(one, two, nx, ny, row[C_ACROSS], row[C_UP])


@kernel
def _energy(balls: Floats, members: Ints, count: int) -> float:
    total = 0.0
    for p in range(count):
        ball = balls[members[p]]
        spin = ball[WX] ** 2 + ball[WY] ** 2 + ball[WZ] ** 2
        total += ball[MASS] * (
            0.5 * (ball[VX] ** 2 + ball[VY] ** 2) + 0.2 * ball[RADIUS] ** 2 * spin
        )
    return total


@kernel
def _forbid_gain(balls: Floats, members: Ints, count: int, before: float) -> None:
    """Take back what the integration gained, from the motion relative to the centre of mass."""
    gain = _energy(balls, members, count) - before
    if gain <= 0.0:
        return
    mass = px = py = 0.0
    for p in range(count):
        ball = balls[members[p]]
        mass += ball[MASS]
        px += ball[MASS] * ball[VX]
        py += ball[MASS] * ball[VY]
    cx, cy, inner = px / mass, py / mass, 0.0
    for p in range(count):
        ball = balls[members[p]]
        inner += 0.5 * ball[MASS] * ((ball[VX] - cx) ** 2 + (ball[VY] - cy) ** 2)
    if inner <= gain:
        return
    factor = sqrt(1.0 - gain / inner) * (1.0 - 1e-15)
    for p in range(count):
        ball = balls[members[p]]
        ball[VX] = cx + factor * (ball[VX] - cx)
        ball[VY] = cy + factor * (ball[VY] - cy)


__all__ = ["CONTACT_WIDTH", "C_A", "C_B", "C_ORDER", "C_SPEED", "gather", "spread"]
