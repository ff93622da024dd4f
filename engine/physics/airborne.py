"""When a flying ball meets something: bed, rail, nose, or a ball in the air or on the bed.

One idea: in flight the centre follows a parabola in height over a straight line, so a meeting of
balls is a quartic as on the bed, and the gap to a nose, which has a degree of eight where it is
an arc, is approached in steps that cannot pass it. Invariant: an answer is an absolute time not
before `now`, or NEVER.
"""

from __future__ import annotations

from math import acos, atan2, cos, pi, sin, sqrt
from typing import TYPE_CHECKING

from engine.geometry.kernel import kernel
from engine.geometry.roots import NEVER, first_fall
from engine.physics.predict import DIP, NEAR
from engine.physics.state import (
    AX,
    AY,
    END,
    FLY,
    G_GRAVITY,
    G_NOSE,
    N_CURVED,
    N_DX,
    N_DY,
    N_HIX,
    N_HIY,
    N_LOX,
    N_LOY,
    N_PIN,
    N_SIZE,
    N_SPAN,
    N_UPRIGHT,
    N_X,
    N_Y,
    RADIUS,
    T0,
    VX,
    VY,
    VZ,
    X,
    Y,
    Z,
)

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Ints = NDArray[np.int64]

STRIDE = 1e-6
"""The least step (m) towards a nose: a graze shallower than 1e-11 m may be passed over."""


@kernel
def fall_time(z: float, vz: float, gravity: float, height: float) -> float:
    """Return how long (s) a ball at `z` takes to come down to `height`; 0 if it is lower now."""
    drop = z - height
    inside = vz * vz + 2.0 * gravity * drop
    if inside < 0.0:
        return 0.0
    root = sqrt(inside)
    if vz >= 0.0:
        return (vz + root) / gravity
    return max(2.0 * drop / (root - vz), 0.0)


@kernel
def flight_end(ball: Floats, world: Floats, noses: Floats, pockets: Floats) -> float:
    """Return the absolute time of landing on the bed or the rail, or of meeting a pocket's back."""
    gravity, top = world[G_GRAVITY], world[G_NOSE] + ball[RADIUS]
    t = fall_time(ball[Z], ball[VZ], gravity, top)
    high = ball[Z] > top or ball[VZ] * ball[VZ] > 2.0 * gravity * (top - ball[Z])
    if high and t > 0.0:
        x, y = ball[X] + t * ball[VX], ball[Y] + t * ball[VY]
        if over_pocket(pockets, x, y, 1.0) < 0 and not inside(noses, x, y):
            return ball[T0] + t
    t = fall_time(ball[Z], ball[VZ], gravity, ball[RADIUS])
    if inside(noses, ball[X] + t * ball[VX], ball[Y] + t * ball[VY]):
        return ball[T0] + t
    for k in range(pockets.shape[0]):  # so low behind the noses it has come through a pocket
        out = _leaves_circle(ball, pockets[k])
        if 0.0 < out < t and ball[Z] + out * (ball[VZ] - 0.5 * gravity * out) < top:
            t = out
    return ball[T0] + t


@kernel
def _leaves_circle(ball: Floats, pocket: Floats) -> float:
    """Return when (s) a straight way leaves a drop circle, at most zero where it does not."""
    x, y = ball[X] - pocket[0], ball[Y] - pocket[1]
    square = ball[VX] * ball[VX] + ball[VY] * ball[VY]
    along = x * ball[VX] + y * ball[VY]
    under = along * along - square * (x * x + y * y - pocket[2] * pocket[2])
    if square == 0.0 or under <= 0.0:
        return 0.0
    return (sqrt(under) - along) / square


@kernel
def over_pocket(pockets: Floats, x: float, y: float, grown: float) -> int:
    """Return the first pocket whose drop circle, `grown` times as wide, lies below, or -1."""
    for k in range(pockets.shape[0]):
        dx, dy, size = x - pockets[k, 0], y - pockets[k, 1], grown * pockets[k, 2]
        if dx * dx + dy * dy <= size * size:
            return k
    return -1


@kernel
def inside(noses: Floats, x: float, y: float) -> bool:
    """Say whether the noses run round a point: what they turn by, seen from it, passes pi.

    The gaps at pockets turn the rest, so that the bed ends where a gap is seen at pi. With no
    noses all is bed.
    """
    total, any_nose = 0.0, False
    for k in range(noses.shape[0]):
        nose = noses[k]
        if nose[N_SIZE] == 0.0 or nose[N_PIN] >= 0.0:
            continue
        any_nose = True
        total += _turn_straight(nose, x, y) if nose[N_CURVED] == 0.0 else _turn_arc(nose, x, y)
    return not any_nose or total > pi


@kernel
def _angle(ax: float, ay: float, bx: float, by: float) -> float:
    return atan2(ax * by - ay * bx, ax * bx + ay * by)


@kernel
def _turn_straight(nose: Floats, x: float, y: float) -> float:
    ax, ay = nose[N_X] - x, nose[N_Y] - y
    return _angle(ax, ay, ax + nose[N_SIZE] * nose[N_DX], ay + nose[N_SIZE] * nose[N_DY])


@kernel
def _turn_arc(nose: Floats, x: float, y: float) -> float:
    """Return the turn of an arc, walked counter-clockwise where the bed lies inside it."""
    half, middle = acos(min(max(nose[N_SPAN], -1.0), 1.0)), atan2(nose[N_DY], nose[N_DX])
    size, way = abs(nose[N_SIZE]), (1.0 if nose[N_SIZE] < 0.0 else -1.0)
    total, parts = 0.0, 32
    px = nose[N_X] + size * cos(middle - way * half) - x
    py = nose[N_Y] + size * sin(middle - way * half) - y
    for p in range(1, parts + 1):
        at = middle + way * half * (2.0 * p / parts - 1.0)
        qx, qy = nose[N_X] + size * cos(at) - x, nose[N_Y] + size * sin(at) - y
        total += _angle(px, py, qx, qy)
        px, py = qx, qy
    return total


@kernel
def on_rail(noses: Floats, x: float, y: float, width: float) -> bool:
    """Say whether a point behind the noses lies no farther than `width` (m) from one."""
    for k in range(noses.shape[0]):
        if noses[k, N_PIN] >= 0.0:
            continue
        px, py = nearest(noses[k], x, y)
        if (x - px) ** 2 + (y - py) ** 2 <= width * width:
            return True
    return False


@kernel
def nearest(nose: Floats, x: float, y: float) -> tuple[float, float]:
    """Return the point (m) of a nose that is nearest to (x, y)."""
    dx, dy = x - nose[N_X], y - nose[N_Y]
    ahead = dx * nose[N_DX] + dy * nose[N_DY]
    if nose[N_CURVED] == 0.0:
        at = min(max(ahead, 0.0), nose[N_SIZE])
        return nose[N_X] + at * nose[N_DX], nose[N_Y] + at * nose[N_DY]
    size, reach = abs(nose[N_SIZE]), sqrt(dx * dx + dy * dy)
    if ahead >= reach * nose[N_SPAN] and reach > 0.0:
        return nose[N_X] + size * dx / reach, nose[N_Y] + size * dy / reach
    aside = dy * nose[N_DX] - dx * nose[N_DY]
    c, s = nose[N_SPAN], sqrt(max(1.0 - nose[N_SPAN] ** 2, 0.0))
    s = s if aside >= 0.0 else -s
    ex, ey = c * nose[N_DX] - s * nose[N_DY], c * nose[N_DY] + s * nose[N_DX]
    return nose[N_X] + size * ex, nose[N_Y] + size * ey


@kernel
def _gap(ball: Floats, nose: Floats, world: Floats, t: float) -> float:
    x, y = ball[X] + t * ball[VX], ball[Y] + t * ball[VY]
    z = ball[Z] + t * (ball[VZ] - 0.5 * world[G_GRAVITY] * t) - world[G_NOSE]
    if nose[N_PIN] >= 0.0:
        wide = max(sqrt((x - nose[N_X]) ** 2 + (y - nose[N_Y]) ** 2) - nose[N_SIZE], 0.0)
        over = max(z + world[G_NOSE] - max(nose[N_UPRIGHT], ball[RADIUS]), 0.0)
        return sqrt(wide * wide + over * over) - ball[RADIUS]
    px, py = nearest(nose, x, y)
    return sqrt((x - px) ** 2 + (y - py) ** 2 + z * z) - ball[RADIUS]


@kernel
def nose_in_air(ball: Floats, nose: Floats, world: Floats, last: float) -> float:
    """Return when a flying ball at its T0 touches a nose within `last` seconds, or NEVER."""
    reach = ball[RADIUS] + 1e-6
    ex, ey = ball[X] + last * ball[VX], ball[Y] + last * ball[VY]
    if nose[N_LOX] > max(ball[X], ex) + reach or nose[N_HIX] < min(ball[X], ex) - reach:
        return NEVER
    if nose[N_LOY] > max(ball[Y], ey) + reach or nose[N_HIY] < min(ball[Y], ey) - reach:
        return NEVER
    steep = max(abs(ball[VZ]), abs(ball[VZ] - world[G_GRAVITY] * last))
    speed = sqrt(ball[VX] ** 2 + ball[VY] ** 2 + steep * steep) + 1e-12
    t, gap = 0.0, _gap(ball, nose, world, 0.0)
    if gap <= NEAR and _closing(ball, nose, world) > NEAR:
        return ball[T0]
    while t < last:
        following = min(t + max(gap, STRIDE) / speed, last)
        ahead = _gap(ball, nose, world, following)
        if ahead < 0.0:
            if gap >= 0.0:
                return ball[T0] + _cross(ball, nose, world, t, following)
            if ahead < gap:
                return ball[T0] + t
        t, gap = following, ahead
    return NEVER


@kernel
def _closing(ball: Floats, nose: Floats, world: Floats) -> float:
    px, py = nearest(nose, ball[X], ball[Y])
    dx, dy, dz = px - ball[X], py - ball[Y], world[G_NOSE] - ball[Z]
    if nose[N_PIN] >= 0.0:
        dz = min(max(nose[N_UPRIGHT], ball[RADIUS]) - ball[Z], 0.0)
    reach = sqrt(dx * dx + dy * dy + dz * dz)
    return (dx * ball[VX] + dy * ball[VY] + dz * ball[VZ]) / reach


@kernel
def _cross(ball: Floats, nose: Floats, world: Floats, low: float, high: float) -> float:
    for _ in range(60):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        if _gap(ball, nose, world, middle) < 0.0:
            high = middle
        else:
            low = middle
    return low


@kernel
def _lift(ball: Floats, kind: int, gravity: float, s: float) -> tuple[float, float, float]:
    """Return height, its speed and half its acceleration, `s` seconds into the piece."""
    if kind != FLY:
        return ball[RADIUS], 0.0, 0.0
    return (
        ball[Z] + s * (ball[VZ] - 0.5 * gravity * s),
        ball[VZ] - gravity * s,
        -0.5 * gravity,
    )


@kernel
def pair_in_air(
    one: Floats, two: Floats, kind_one: int, kind_two: int, world: Floats, now: float
) -> float:
    """Return the time at which two balls touch of which at least one flies, or NEVER."""
    last = min(one[END], two[END]) - now
    if last < 0.0:
        return NEVER
    s, u = now - one[T0], now - two[T0]
    z1, w1, a1 = _lift(one, kind_one, world[G_GRAVITY], s)
    z2, w2, a2 = _lift(two, kind_two, world[G_GRAVITY], u)
    cx = (two[X] + u * (two[VX] + 0.5 * u * two[AX])) - (one[X] + s * (one[VX] + 0.5 * s * one[AX]))
    cy = (two[Y] + u * (two[VY] + 0.5 * u * two[AY])) - (one[Y] + s * (one[VY] + 0.5 * s * one[AY]))
    bx = (two[VX] + u * two[AX]) - (one[VX] + s * one[AX])
    by = (two[VY] + u * two[AY]) - (one[VY] + s * one[AY])
    ax, ay = 0.5 * (two[AX] - one[AX]), 0.5 * (two[AY] - one[AY])
    distance = one[RADIUS] + two[RADIUS]
    return now + closes_in_space(cx, cy, z2 - z1, bx, by, w2 - w1, ax, ay, a2 - a1, distance, last)


@kernel
def closes_in_space(
    cx: float,
    cy: float,
    cz: float,
    bx: float,
    by: float,
    bz: float,
    ax: float,
    ay: float,
    az: float,
    distance: float,
    last: float,
) -> float:
    """Return when |c + b t + a t^2| first falls below `distance` (m), as `predict.closes`, s."""
    square = cx * cx + cy * cy + cz * cz
    gap = square - distance * distance
    drift = cx * bx + cy * by + cz * bz
    reach = sqrt(square)
    bend = bx * bx + by * by + bz * bz + 2.0 * (cx * ax + cy * ay + cz * az)
    if gap <= 2.0 * distance * NEAR:
        if drift < -reach * NEAR:
            return 0.0 if reach > 0.5 * distance else NEVER
        if drift <= reach * NEAR:
            drift = 0.0
            distance = min(distance, reach) - (DIP if bend < 0.0 else 0.0)
            gap = max(square - distance * distance, 0.0)
        elif gap <= 0.0:
            distance = reach
            gap = 0.0
    speed = sqrt(bx * bx + by * by + bz * bz)
    pull = sqrt(ax * ax + ay * ay + az * az)
    if reach - distance > (speed + pull * last) * last:
        return NEVER
    k3 = 2.0 * (ax * bx + ay * by + az * bz)
    s2 = last * last
    k1, k2, k4 = 2.0 * drift * last, bend * s2, pull * pull * s2 * s2
    s = first_fall(gap, k1, k2, k3 * s2 * last, k4, 0.0, 1.0)
    if s == NEVER:
        return NEVER
    t = s * last
    for _ in range(2):
        x, y, z = cx + t * (bx + t * ax), cy + t * (by + t * ay), cz + t * (bz + t * az)
        closing = x * (bx + 2.0 * t * ax) + y * (by + 2.0 * t * ay) + z * (bz + 2.0 * t * az)
        far = sqrt(x * x + y * y + z * z)
        step = (far - distance) * far / closing if closing != 0.0 else 0.0
        if abs(step) > 1e-6:
            break
        t -= step
    return min(max(t, 0.0), last)


__all__ = [
    "closes_in_space",
    "fall_time",
    "flight_end",
    "inside",
    "nearest",
    "nose_in_air",
    "on_rail",
    "over_pocket",
    "pair_in_air",
]
