"""When the next contact comes: ball and ball, ball and nose, ball and drop.

One idea: a contact is the first downward crossing of a gap inside the time for which both pieces
hold, found in scaled time and polished on the true distance. A pair that touches or overlaps is
measured from where it stands: nearing is now, parting is ignored until it nears again, and a pair
pressed together with no speed is let in by `DIP` so that it has one. Invariant: an answer is an
absolute time not before `now`, or NEVER.
"""

from __future__ import annotations

from math import sqrt
from typing import TYPE_CHECKING

from engine.geometry.kernel import kernel
from engine.geometry.roots import NEVER, first_fall, polish
from engine.physics.state import (
    AX,
    AY,
    END,
    N_CURVED,
    N_DX,
    N_DY,
    N_SIZE,
    N_SPAN,
    N_UPRIGHT,
    N_X,
    N_Y,
    RADIUS,
    REACH,
    T0,
    VX,
    VY,
    X,
    Y,
)

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

DIP = 4e-10
NEAR = 1e-9


@kernel
def passes_by(
    cx: float, cy: float, bx: float, by: float, ax: float, ay: float, distance: float, last: float
) -> bool:
    """Say whether c + b t + a t^2 surely stays farther than `distance` (m) for t in [0, last].

    The path leaves its chord by at most |a| last^2 / 4.
    """
    dx, dy = last * (bx + last * ax), last * (by + last * ay)
    near = distance + 0.25 * last * last * (abs(ax) + abs(ay)) + 1e-6
    square = dx * dx + dy * dy
    along = -(cx * dx + cy * dy)
    if along <= 0.0 or square == 0.0:
        return cx * cx + cy * cy > near * near
    if along >= square:
        return (cx + dx) ** 2 + (cy + dy) ** 2 > near * near
    across = cx * dy - cy * dx
    return across * across > near * near * square


@kernel
def closes(
    cx: float, cy: float, bx: float, by: float, ax: float, ay: float, distance: float, last: float
) -> float:
    """Return when |c + b t + a t^2| first falls below `distance` (m) for t in [0, last], s."""
    square = cx * cx + cy * cy
    gap = square - distance * distance
    drift = cx * bx + cy * by
    if gap <= 2.0 * distance * NEAR:
        reach = sqrt(square)
        if drift < -reach * NEAR:
            return 0.0 if reach > 0.5 * distance else NEVER
        if drift <= reach * NEAR:
            drift = 0.0
            bend = bx * bx + by * by + 2.0 * (cx * ax + cy * ay)
            distance = min(distance, reach) - (DIP if bend < 0.0 else 0.0)
            gap = max(square - distance * distance, 0.0)
        elif gap <= 0.0:
            distance = reach
            gap = 0.0
    else:
        reach = sqrt(square)
    speed = sqrt(bx * bx + by * by)
    pull = sqrt(ax * ax + ay * ay)
    if reach - distance > (speed + pull * last) * last:
        return NEVER
    if passes_by(cx, cy, bx, by, ax, ay, distance, last):
        return NEVER
    k1 = 2.0 * drift
    k2 = bx * bx + by * by + 2.0 * (cx * ax + cy * ay)
    k3 = 2.0 * (ax * bx + ay * by)
    if gap >= 0.0 and k1 >= 0.0 and k2 >= 0.0 and k3 >= 0.0:
        return NEVER
    k4 = pull * pull
    s2 = last * last
    s = first_fall(gap, k1 * last, k2 * s2, k3 * s2 * last, k4 * s2 * s2, 0.0, 1.0)
    if s == NEVER:
        return NEVER
    return min(polish(cx, cy, bx, by, ax, ay, distance, s * last), last)


@kernel
def pair_time(one: Floats, two: Floats, now: float) -> float:
    """Return the time at which two balls touch; unequal balls on a bed touch at 2 sqrt(R r)."""
    last = min(one[END], two[END]) - now
    if last < 0.0:
        return NEVER
    s, u = now - one[T0], now - two[T0]
    cx = (two[X] + u * (two[VX] + 0.5 * u * two[AX])) - (one[X] + s * (one[VX] + 0.5 * s * one[AX]))
    cy = (two[Y] + u * (two[VY] + 0.5 * u * two[AY])) - (one[Y] + s * (one[VY] + 0.5 * s * one[AY]))
    bx = (two[VX] + u * two[AX]) - (one[VX] + s * one[AX])
    by = (two[VY] + u * two[AY]) - (one[VY] + s * one[AY])
    ax, ay = 0.5 * (two[AX] - one[AX]), 0.5 * (two[AY] - one[AY])
    distance = 2.0 * sqrt(one[RADIUS] * two[RADIUS])
    return now + closes(cx, cy, bx, by, ax, ay, distance, last)


@kernel
def pocket_time(ball: Floats, px: float, py: float, radius: float) -> float:
    """Return when the centre of a ball at its T0 comes over a drop circle."""
    cx, cy = ball[X] - px, ball[Y] - py
    if cx * cx + cy * cy <= radius * radius:
        return ball[T0]
    last = ball[END] - ball[T0]
    k1 = 2.0 * (cx * ball[VX] + cy * ball[VY])
    reach = sqrt(cx * cx + cy * cy) - radius
    speed = sqrt(ball[VX] * ball[VX] + ball[VY] * ball[VY])
    ax, ay = 0.5 * ball[AX], 0.5 * ball[AY]
    if not reach <= (speed + sqrt(ax * ax + ay * ay) * last) * last:
        return NEVER
    if passes_by(cx, cy, ball[VX], ball[VY], ax, ay, radius, last):
        return NEVER
    gap = cx * cx + cy * cy - radius * radius
    k2 = speed * speed + 2.0 * (cx * ax + cy * ay)
    k3 = 2.0 * (ax * ball[VX] + ay * ball[VY])
    k4, s2 = ax * ax + ay * ay, last * last
    s = first_fall(gap, k1 * last, k2 * s2, k3 * s2 * last, k4 * s2 * s2, 0.0, 1.0)
    if s == NEVER:
        return NEVER
    t = polish(cx, cy, ball[VX], ball[VY], ax, ay, radius, s * last)
    return ball[T0] + min(t, last)


@kernel
def swept_box(ball: Floats, last: float, box: Floats) -> None:
    """Fill `box` with the low and high x and y of the ball's path, grown by its radius.

    The path is that of the next `last` seconds.
    """
    for axis in range(2):
        r, v, a = ball[X + axis], ball[VX + axis], ball[AX + axis]
        end = r + last * (v + 0.5 * last * a)
        low, high = min(r, end), max(r, end)
        if a != 0.0:
            turn = -v / a
            if 0.0 < turn < last:
                peak = r + 0.5 * turn * v
                low, high = min(low, peak), max(high, peak)
        box[axis], box[2 + axis] = low - ball[RADIUS] - 1e-6, high + ball[RADIUS] + 1e-6


@kernel
def nose_time(ball: Floats, nose: Floats, last: float) -> float:
    """Return when a ball at its T0 touches a nose within `last` seconds, or NEVER."""
    if nose[N_CURVED] != 0.0:
        return _arc_time(ball, nose, last)
    return _line_time(ball, nose, last)


@kernel
def _line_time(ball: Floats, nose: Floats, last: float) -> float:
    nx, ny = -nose[N_DY], nose[N_DX]
    x, y = ball[X] - nose[N_X], ball[Y] - nose[N_Y]
    gap = x * nx + y * ny - (ball[RADIUS] if nose[N_UPRIGHT] != 0.0 else ball[REACH])
    speed = ball[VX] * nx + ball[VY] * ny
    pull = 0.5 * (ball[AX] * nx + ball[AY] * ny)
    at = x * nose[N_DX] + y * nose[N_DY]
    beside = -NEAR <= at <= nose[N_SIZE] + NEAR
    if beside and -1e-5 < gap <= NEAR:
        if speed < -NEAR:
            return ball[T0]
        gap = max(gap, 0.0)
        if speed <= NEAR:
            speed = 0.0
            gap = DIP if pull < 0.0 else 0.0
    if gap >= 0.0 and speed >= 0.0 and pull >= 0.0:
        return NEVER
    if gap >= 1e-6 and pull <= 0.0 and gap + last * (speed + last * pull) > 1e-6:
        return NEVER
    s = first_fall(gap, speed * last, pull * last * last, 0.0, 0.0, 0.0, 1.0)
    if s == NEVER:
        return NEVER
    t = s * last
    at += t * (
        ball[VX] * nose[N_DX]
        + ball[VY] * nose[N_DY]
        + 0.5 * t * (ball[AX] * nose[N_DX] + ball[AY] * nose[N_DY])
    )
    if not -NEAR <= at <= nose[N_SIZE] + NEAR:
        return NEVER
    return ball[T0] + t


@kernel
def _arc_time(ball: Floats, nose: Floats, last: float) -> float:
    cx, cy = ball[X] - nose[N_X], ball[Y] - nose[N_Y]
    ax, ay = 0.5 * ball[AX], 0.5 * ball[AY]
    inside = nose[N_SIZE] < 0.0
    own = ball[RADIUS] if nose[N_UPRIGHT] != 0.0 else ball[REACH]
    distance = abs(nose[N_SIZE]) - own if inside else nose[N_SIZE] + own
    sign = -1.0 if inside else 1.0
    if not inside and passes_by(cx, cy, ball[VX], ball[VY], ax, ay, distance, last):
        return NEVER
    square = cx * cx + cy * cy
    reach = sqrt(square)
    drift = cx * ball[VX] + cy * ball[VY]
    gap = sign * (reach - distance)
    if -1e-5 < gap <= NEAR and _faces(nose, cx, cy):
        slope = sign * drift / reach
        if slope < -NEAR:
            return ball[T0]
        bend = ball[VX] * ball[VX] + ball[VY] * ball[VY] + 2.0 * (cx * ax + cy * ay)
        distance = min(distance, reach) if sign > 0.0 else max(distance, reach)
        if slope <= NEAR:
            drift = 0.0
            distance -= sign * DIP if sign * bend < 0.0 else 0.0
    k0 = sign * (square - distance * distance)
    if -1e-5 < gap <= NEAR and _faces(nose, cx, cy):
        k0 = max(k0, 0.0)
    k1 = sign * 2.0 * drift * last
    speed2 = ball[VX] * ball[VX] + ball[VY] * ball[VY]
    k2 = sign * (speed2 + 2.0 * (cx * ax + cy * ay)) * last * last
    k3 = sign * 2.0 * (ax * ball[VX] + ay * ball[VY]) * last * last * last
    k4 = sign * (ax * ax + ay * ay) * last * last * last * last
    low = 0.0
    for _ in range(2):
        s = first_fall(k0, k1, k2, k3, k4, low, 1.0)
        if s == NEVER:
            return NEVER
        t = polish(cx, cy, ball[VX], ball[VY], ax, ay, distance, s * last)
        x = cx + t * (ball[VX] + t * ax)
        y = cy + t * (ball[VY] + t * ay)
        if _faces(nose, x, y):
            return ball[T0] + min(t, last)
        low = s + 1e-12
    return NEVER


@kernel
def _faces(nose: Floats, x: float, y: float) -> bool:
    """Say whether the direction (x, y) from the arc's centre lies in its sweep."""
    ahead = x * nose[N_DX] + y * nose[N_DY]
    aside = y * nose[N_DX] - x * nose[N_DY]
    reach = sqrt(x * x + y * y)
    # N_SPAN is the cosine of the half sweep
    return ahead >= reach * nose[N_SPAN] - 1e-9 or abs(aside) == 0.0 < ahead


__all__ = ["NEVER", "closes", "nose_time", "pair_time", "pocket_time", "swept_box"]
