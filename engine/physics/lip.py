"""The pocket model `rim-lip`: a ball at the edge of a drop, over its lip, in the hole, at its rim.

One idea: a pocket is an upright round hole whose edge is a ring of round section: on the side of
the bed the lip, level with the bed, elsewhere the rim, which may stand higher. A ball first leans
over the lip, in touch with it, its centre on a torus: rolling, or sliding where it came sliding. It
leaves it when nothing presses any more: cos(psi) = (10 + 7 v^2 / (g rho)) / 17 for one that rolls
straight in, rho = R + lip, at once from v^2 = g rho on; one that only cuts the edge comes back up.
Then it falls and strikes wall, lip and rim by restitution and friction until it lies below the
bed, is back on it, or has passed over the rim. Invariant: no energy is gained, one entry has one
outcome.
"""

from __future__ import annotations

from math import atan2, cos, hypot, pi, sin, sqrt
from typing import TYPE_CHECKING

import numpy as np

from engine.geometry.kernel import kernel_with_arrays

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Ints = NDArray[np.int64]

CAPTURED, BACK, OVER = range(3)
"""What becomes of a ball at a pocket: it falls in, is back on the bed, or leaps over the rim."""

B_X, B_Y, B_Z, B_VX, B_VY, B_VZ, B_WX, B_WY, B_WZ = range(9)
BODY = 9
"""A ball's centre from the pocket's at the height of the bed, velocity and spin: m, m/s, rad/s."""

(H_RADIUS, H_LIP, H_RIM, H_E, H_RUB, H_BED_X, H_BED_Y, H_BED_COS, H_BALL, H_GRAVITY) = range(10)
HOLE = 10
"""Radius of the drop, of its lip, height of the rim; restitution and friction in the hole; the
direction in which the bed lies and the cosine of the half angle that the lip takes up; the ball's
radius and gravity."""

STEP = 2e-4
"""Time step (s); the ends of a stage are found within one."""

LEAN = 1e-9
"""The least angle (rad) by which a ball that falls of itself is taken to lean."""

SLIPS = 0.05
"""Slip over speed from which on a ball is taken to slide over the lip without friction."""

SLOW = 0.05
"""An approach (m/s) in the hole that does not bounce: a ball settles instead of trembling."""

NUDGE = 1e-9
"""By how much (m, s) a ball is moved off a jaw, so that it is seen to be off."""

LONGEST = 20.0
"""Time (s) after which a ball that has found no way out of a hole is taken to lie in it."""


NODE = 5e-3
"""The longest time (s) between two places noted on the way, save in free flight."""


@kernel_with_arrays
def leaving_angle(speed: float, gravity: float, rho: float) -> float:
    """Return the angle (rad) at which a ball that rolls straight over a lip leaves it.

    `speed` (m/s) is that on the bed, `rho` (m) the radius of the centre's way. Zero: at once.
    """
    body = np.zeros(BODY)
    body[B_X], body[B_Z], body[B_VX] = -1e6, rho, speed
    hole = np.zeros(HOLE)
    hole[H_RADIUS], hole[H_BALL], hole[H_GRAVITY], hole[H_BED_X] = 1e6, rho, gravity, -1.0
    lean = np.zeros(3)
    way, counts = np.empty((2, 1 + BODY)), np.zeros(1, dtype=np.int64)
    _lean_over(body, hole, 1.4, lean, way, counts)
    return float(lean[0])


@kernel_with_arrays
def fall(body: Floats, hole: Floats, way: Floats) -> tuple[int, float, int]:
    """Carry a ball (B_*) whose centre has come over a drop (H_*) to its outcome, in place.

    `way` (n, 1 + BODY) gets time and state at the nodes of the ball's way, last the outcome;
    between two of them gravity alone acts, or little time goes by. Returns the outcome, the time
    (s) it takes and how many nodes there are.
    """
    before = _energy(body, hole)
    time, counts = 0.0, np.zeros(1, dtype=np.int64)
    outcome = -1
    _node(body, 0.0, way, counts)
    if body[B_Z] <= hole[H_BALL] + 1e-9:
        lean = np.zeros(3)
        inertia = 1.4 if _rolls(body, hole) else 1.0
        back = _lean_over(body, hole, inertia, lean, way, counts)
        time = lean[2]
        outcome = BACK if back else -1
    if outcome < 0:
        outcome, time = _fly(body, hole, time, way, counts)
    _no_gain(body, hole, before)
    count = counts[0]
    if way[count - 1, 0] < time:
        count = min(count + 1, way.shape[0])
    way[count - 1, 0], way[count - 1, 1:] = time, body
    return outcome, time, count


@kernel_with_arrays
def _node(body: Floats, time: float, way: Floats, counts: Ints) -> None:
    """Note a place of the ball's way, as long as there is room for it and the last."""
    if counts[0] < way.shape[0] - 1:
        way[counts[0], 0] = time
        way[counts[0], 1:] = body
        counts[0] += 1


@kernel_with_arrays
def _energy(body: Floats, hole: Floats) -> float:
    """Return a ball's energy over its mass."""
    speed = body[B_VX] ** 2 + body[B_VY] ** 2 + body[B_VZ] ** 2
    spin = body[B_WX] ** 2 + body[B_WY] ** 2 + body[B_WZ] ** 2
    return 0.5 * speed + 0.2 * hole[H_BALL] ** 2 * spin + hole[H_GRAVITY] * body[B_Z]


@kernel_with_arrays
def _no_gain(body: Floats, hole: Floats, before: float) -> None:
    """Take back from speed and spin what integration gained, or the modelled leap onto the bed."""
    height = hole[H_GRAVITY] * body[B_Z]
    inner = _energy(body, hole) - height
    if inner + height <= before or inner <= 0.0:
        return
    part = sqrt(max(before - height, 0.0) / inner) * (1.0 - 1e-15)
    for k in range(B_VX, BODY):
        body[k] *= part


@kernel_with_arrays
def _rolls(body: Floats, hole: Floats) -> bool:
    """Say whether a ball on the bed rolls, or nearly so."""
    ux = body[B_VX] - hole[H_BALL] * body[B_WY]
    uy = body[B_VY] + hole[H_BALL] * body[B_WX]
    return hypot(ux, uy) <= SLIPS * hypot(body[B_VX], body[B_VY]) + 1e-9


@kernel_with_arrays
def _pull(psi: float, hole: Floats, rho: float, whirl: float, inertia: float) -> float:
    """Return the angular acceleration of leaning: gravity's, and that of going round."""
    reach = hole[H_RADIUS] - rho * sin(psi)
    round_off = whirl * whirl * cos(psi) / (rho * reach * reach * reach)
    return hole[H_GRAVITY] * sin(psi) / (rho * inertia) - round_off


@kernel_with_arrays
def _pressed(psi: float, rate: float, hole: Floats, rho: float, whirl: float) -> float:
    """Return the force over mass with which lip and ball press each other."""
    reach = hole[H_RADIUS] - rho * sin(psi)
    outward = whirl * whirl / (reach * reach * reach) * sin(psi)
    return hole[H_GRAVITY] * cos(psi) - rho * rate * rate + outward


@kernel_with_arrays
def _lean_step(
    y: Floats, h: float, hole: Floats, rho: float, whirl: float, inertia: float, out: Floats
) -> None:
    """Fill `out` with angle, its rate, and the way round after h: Runge and Kutta's method."""
    a1 = _pull(y[0], hole, rho, whirl, inertia)
    r1 = y[1]
    a2 = _pull(y[0] + 0.5 * h * r1, hole, rho, whirl, inertia)
    r2 = y[1] + 0.5 * h * a1
    a3 = _pull(y[0] + 0.5 * h * r2, hole, rho, whirl, inertia)
    r3 = y[1] + 0.5 * h * a2
    a4 = _pull(y[0] + h * r3, hole, rho, whirl, inertia)
    r4 = y[1] + h * a3
    out[0] = y[0] + h / 6.0 * (r1 + 2.0 * r2 + 2.0 * r3 + r4)
    out[1] = y[1] + h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4)
    g1 = hole[H_RADIUS] - rho * sin(y[0])
    g2 = hole[H_RADIUS] - rho * sin(0.5 * (y[0] + out[0]) + h / 8.0 * (y[1] - out[1]))
    g3 = hole[H_RADIUS] - rho * sin(out[0])
    out[2] = y[2] + whirl * h / 6.0 * (1.0 / (g1 * g1) + 4.0 / (g2 * g2) + 1.0 / (g3 * g3))


@kernel_with_arrays
def _lean_over(
    body: Floats, hole: Floats, inertia: float, lean: Floats, way: Floats, counts: Ints
) -> bool:
    """Carry a ball over the lip; say whether it has come back up onto the bed.

    `lean` becomes angle, its rate and the time taken.
    """
    rho, d = hole[H_BALL] + hole[H_LIP], hypot(body[B_X], body[B_Y])
    ex, ey = body[B_X] / d if d > 0.0 else 1.0, body[B_Y] / d if d > 0.0 else 0.0
    inside = hole[H_RADIUS] - d
    inward = -(body[B_VX] * ex + body[B_VY] * ey)
    around = body[B_VY] * ex - body[B_VX] * ey
    if inside >= rho * 0.999 or inward * inward >= hole[H_GRAVITY] * rho:
        return False
    y, new = np.zeros(3), np.zeros(3)
    y[0] = np.arcsin(max(inside, 0.0) / rho)
    y[1] = inward / (rho * cos(y[0]))
    if y[0] < LEAN and abs(y[1]) < LEAN:
        y[0] = LEAN
    whirl = around * d
    time, noted, going = 0.0, 0.0, _pressed(y[0], y[1], hole, rho, whirl) > 0.0
    start, first = atan2(ey, ex), body.copy()
    while going and time < LONGEST:
        h = STEP
        _lean_step(y, h, hole, rho, whirl, inertia, new)
        angle = start + new[2]
        if not _at_bed(cos(angle), sin(angle), hole):
            if whirl * (new[2] - y[2]) <= 0.0:
                break
            whirl *= -hole[H_E]  # a jaw stands there
            continue
        if _leaves(new, hole, rho, whirl):
            going = False
            h = _last_step(y, h, hole, rho, whirl, inertia, new)
        y[:] = new
        time += h
        if going and time - noted >= NODE:
            noted = time
            body[:] = first
            _set_down(body, hole, rho, y, whirl, start, inertia)
            _node(body, time, way, counts)
    back = y[0] <= 0.0
    y[0] = max(y[0], 0.0)
    lean[0], lean[1], lean[2] = y[0], y[1], time
    body[:] = first
    _set_down(body, hole, rho, y, whirl, start, inertia)
    _node(body, time, way, counts)
    return back


@kernel_with_arrays
def _last_step(
    y: Floats, h: float, hole: Floats, rho: float, whirl: float, inertia: float, new: Floats
) -> float:
    """Fill `new` with the state in which the lip is left, within a step h; return that step."""
    low, high = 0.0, h
    for _ in range(60):
        h = 0.5 * (low + high)
        _lean_step(y, h, hole, rho, whirl, inertia, new)
        if _leaves(new, hole, rho, whirl):
            high = h
        else:
            low = h
    _lean_step(y, high, hole, rho, whirl, inertia, new)
    return high


@kernel_with_arrays
def _leaves(y: Floats, hole: Floats, rho: float, whirl: float) -> bool:
    """Say whether nothing presses any more, or the ball is back up."""
    loose = _pressed(y[0], y[1], hole, rho, whirl) <= 0.0
    return loose or y[0] < 0.0 or y[0] > 0.5 * pi


@kernel_with_arrays
def _set_down(
    body: Floats,
    hole: Floats,
    rho: float,
    y: Floats,
    whirl: float,
    start: float,
    inertia: float,
) -> None:
    """Turn the angles of leaning into place, velocity and, for a ball that rolls, spin."""
    psi, angle = y[0], start + y[2]
    ex, ey = cos(angle), sin(angle)
    reach = hole[H_RADIUS] - rho * sin(psi)
    out, up, around = -rho * y[1] * cos(psi), -rho * y[1] * sin(psi), whirl / reach
    body[B_X], body[B_Y] = reach * ex, reach * ey
    body[B_Z] = rho * cos(psi) - hole[H_LIP]
    body[B_VX], body[B_VY], body[B_VZ] = out * ex - around * ey, out * ey + around * ex, up
    if inertia == 1.0:
        return
    # from the lip to the centre; what spins about it goes on
    nx, ny, nz = -sin(psi) * ex, -sin(psi) * ey, cos(psi)
    left = body[B_WZ] * nz
    r = hole[H_BALL]
    body[B_WX] = (ny * body[B_VZ] - nz * body[B_VY]) / r + left * nx
    body[B_WY] = (nz * body[B_VX] - nx * body[B_VZ]) / r + left * ny
    body[B_WZ] = (nx * body[B_VY] - ny * body[B_VX]) / r + left * nz


@kernel_with_arrays
def _at_bed(x: float, y: float, hole: Floats) -> bool:
    """Say whether the hole's edge in this direction from its middle is the bed's."""
    d = hypot(x, y)
    return x * hole[H_BED_X] + y * hole[H_BED_Y] >= hole[H_BED_COS] * d - 1e-12


@kernel_with_arrays
def _gap(body: Floats, hole: Floats, normal: Floats) -> float:
    """Return how far (m) a ball is from what is nearest in the hole; `normal` points from it."""
    d = hypot(body[B_X], body[B_Y])
    ex, ey = (body[B_X] / d, body[B_Y] / d) if d > 0.0 else (1.0, 0.0)
    lip, top = 0.0, hole[H_RIM]
    if _at_bed(body[B_X], body[B_Y], hole):
        lip, top = hole[H_LIP], -hole[H_LIP]
    away, above = d - hole[H_RADIUS], body[B_Z] - top
    if above <= 0.0:
        normal[0], normal[1], normal[2] = -ex, -ey, 0.0
        return -away - lip - hole[H_BALL]
    if away >= 0.0:
        normal[0], normal[1], normal[2] = 0.0, 0.0, 1.0
        return above - lip - hole[H_BALL]
    reach = hypot(away, above)
    normal[0], normal[1], normal[2] = away / reach * ex, away / reach * ey, above / reach
    return reach - lip - hole[H_BALL]


@kernel_with_arrays
def _drift(body: Floats, h: float, gravity: float) -> None:
    body[B_X] += h * body[B_VX]
    body[B_Y] += h * body[B_VY]
    body[B_Z] += h * (body[B_VZ] - 0.5 * gravity * h)
    body[B_VZ] -= gravity * h


@kernel_with_arrays
def _outcome(body: Floats, hole: Floats) -> int:
    """Return what has become of a ball, or -1 while that is open."""
    if body[B_Z] <= -hole[H_BALL]:
        return CAPTURED
    if hypot(body[B_X], body[B_Y]) < hole[H_RADIUS]:
        return -1
    if _at_bed(body[B_X], body[B_Y], hole):
        return BACK if body[B_Z] >= hole[H_BALL] - 1e-4 else -1
    return OVER if body[B_Z] > hole[H_RIM] else -1


@kernel_with_arrays
def _fly(body: Floats, hole: Floats, time: float, way: Floats, counts: Ints) -> tuple[int, float]:
    """Let a ball fall and bounce in the hole to its outcome; return it and its time."""
    trial, normal, noted = np.empty(BODY), np.empty(3), time
    touching = _gap(body, hole, normal) <= 1e-7
    while time < LONGEST:
        trial[:] = body
        _drift(trial, STEP, hole[H_GRAVITY])
        h = STEP
        if _past_jaw(body, trial, hole):
            _off_jaw(body, hole)
            time += NUDGE
            continue
        gap = _gap(trial, hole, normal)
        if gap < 0.0 and not touching:
            low, high = 0.0, STEP
            for _ in range(50):
                h = 0.5 * (low + high)
                trial[:] = body
                _drift(trial, h, hole[H_GRAVITY])
                if _gap(trial, hole, normal) < 0.0:
                    high = h
                else:
                    low = h
            h = low
            trial[:] = body
            _drift(trial, h, hole[H_GRAVITY])
            gap = _gap(trial, hole, normal)
            touching = True
        elif gap < 0.0:
            for k in range(3):
                trial[k] -= gap * normal[k]
        else:
            touching = False
        body[:] = trial
        time += h
        if touching:
            _strike(body, hole, normal)
            if time - noted >= NODE or h < STEP:
                noted = time
                _node(body, time, way, counts)
        outcome = _outcome(body, hole)
        if outcome >= 0:
            return outcome, time
    return CAPTURED, time


@kernel_with_arrays
def _past_jaw(body: Floats, trial: Floats, hole: Floats) -> bool:
    """Say whether a ball over the lip would go on into the jaw where the bed ends."""
    outside = hypot(trial[B_X], trial[B_Y]) > hole[H_RADIUS] - hole[H_BALL]
    if not outside or trial[B_Z] > hole[H_RIM] + hole[H_BALL]:
        return False
    return _at_bed(body[B_X], body[B_Y], hole) and not _at_bed(trial[B_X], trial[B_Y], hole)


@kernel_with_arrays
def _off_jaw(body: Floats, hole: Floats) -> None:
    """Turn back what a ball has of speed round the hole."""
    d = hypot(body[B_X], body[B_Y])
    tx, ty = -body[B_Y] / d, body[B_X] / d
    change = (1.0 + hole[H_E]) * (body[B_VX] * tx + body[B_VY] * ty)
    body[B_VX] -= change * tx
    body[B_VY] -= change * ty
    away = NUDGE if change < 0.0 else -NUDGE
    body[B_X] += away * tx
    body[B_Y] += away * ty


@kernel_with_arrays
def _strike(body: Floats, hole: Floats, normal: Floats) -> None:
    """Resolve a blow against what lies behind `normal`: restitution, and friction to 2/7."""
    nx, ny, nz = normal[0], normal[1], normal[2]
    speed = -(body[B_VX] * nx + body[B_VY] * ny + body[B_VZ] * nz)
    if speed <= 0.0:
        return
    r = hole[H_BALL]
    pressed = (1.0 + (hole[H_E] if speed > SLOW else 0.0)) * speed
    wx, wy, wz = body[B_WX], body[B_WY], body[B_WZ]
    sx = body[B_VX] + speed * nx - r * (wy * nz - wz * ny)
    sy = body[B_VY] + speed * ny - r * (wz * nx - wx * nz)
    sz = body[B_VZ] + speed * nz - r * (wx * ny - wy * nx)
    slip = sqrt(sx * sx + sy * sy + sz * sz)
    body[B_VX] += pressed * nx
    body[B_VY] += pressed * ny
    body[B_VZ] += pressed * nz
    if slip <= 1e-15:
        return
    rub = -min(hole[H_RUB] * pressed, slip / 3.5) / slip
    sx, sy, sz = rub * sx, rub * sy, rub * sz
    body[B_VX] += sx
    body[B_VY] += sy
    body[B_VZ] += sz
    body[B_WX] -= 2.5 / r * (ny * sz - nz * sy)
    body[B_WY] -= 2.5 / r * (nz * sx - nx * sz)
    body[B_WZ] -= 2.5 / r * (nx * sy - ny * sx)


__all__ = ["BACK", "BODY", "CAPTURED", "HOLE", "OVER", "fall", "leaving_angle"]
