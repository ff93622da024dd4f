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
from engine.physics.entered import (
    B_VX,
    B_VY,
    B_VZ,
    B_WX,
    B_WY,
    B_WZ,
    B_X,
    B_Y,
    B_Z,
    BACK,
    BODY,
    H_BALL,
    H_BED_X,
    H_E,
    H_GRAVITY,
    H_LIP,
    H_RADIUS,
    HOLE,
    LEAN,
    LONGEST,
    NODE,
    SLIPS,
    STEP,
    energy,
    node,
)
from engine.physics.hole import at_bed, fly

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Ints = NDArray[np.int64]


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
    before = energy(body, hole)
    time, counts = 0.0, np.zeros(1, dtype=np.int64)
    outcome = -1
    node(body, 0.0, way, counts)
    if body[B_Z] <= hole[H_BALL] + 1e-9:
        lean = np.zeros(3)
        inertia = 1.4 if _rolls(body, hole) else 1.0
        back = _lean_over(body, hole, inertia, lean, way, counts)
        time = lean[2]
        outcome = BACK if back else -1
    if outcome < 0:
        outcome, time = fly(body, hole, time, way, counts)
    _no_gain(body, hole, before)
    count = counts[0]
    if way[count - 1, 0] < time:
        count = min(count + 1, way.shape[0])
    way[count - 1, 0], way[count - 1, 1:] = time, body
    return outcome, time, count


@kernel_with_arrays
def _no_gain(body: Floats, hole: Floats, before: float) -> None:
    """Take back from speed and spin what integration gained, or the modelled leap onto the bed."""
    height = hole[H_GRAVITY] * body[B_Z]
    inner = energy(body, hole) - height
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
        if not at_bed(cos(angle), sin(angle), hole):
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
            node(body, time, way, counts)
    back = y[0] <= 0.0
    y[0] = max(y[0], 0.0)
    lean[0], lean[1], lean[2] = y[0], y[1], time
    body[:] = first
    _set_down(body, hole, rho, y, whirl, start, inertia)
    node(body, time, way, counts)
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


__all__ = ["fall", "leaving_angle"]
