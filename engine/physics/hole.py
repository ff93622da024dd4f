"""A ball that has left the lip of a pocket: it falls, strikes wall, lip and rim, and its outcome.

One idea: between two blows gravity alone acts, so the way is a chain of parabolas. Invariant: it
ends below the bed, back on it, or over the rim.
"""

from __future__ import annotations

from math import hypot, sqrt
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
    CAPTURED,
    H_BALL,
    H_BED_COS,
    H_BED_X,
    H_BED_Y,
    H_E,
    H_GRAVITY,
    H_LIP,
    H_RADIUS,
    H_RIM,
    H_RUB,
    LONGEST,
    NODE,
    NUDGE,
    OVER,
    SLOW,
    STEP,
    node,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Ints = NDArray[np.int64]


@kernel_with_arrays
def at_bed(x: float, y: float, hole: Floats) -> bool:
    """Say whether the hole's edge in this direction from its middle is the bed's."""
    d = hypot(x, y)
    return x * hole[H_BED_X] + y * hole[H_BED_Y] >= hole[H_BED_COS] * d - 1e-12


@kernel_with_arrays
def _gap(body: Floats, hole: Floats, normal: Floats) -> float:
    """Return how far (m) a ball is from what is nearest in the hole; `normal` points from it."""
    d = hypot(body[B_X], body[B_Y])
    ex, ey = (body[B_X] / d, body[B_Y] / d) if d > 0.0 else (1.0, 0.0)
    lip, top = 0.0, hole[H_RIM]
    if at_bed(body[B_X], body[B_Y], hole):
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
    if at_bed(body[B_X], body[B_Y], hole):
        return BACK if body[B_Z] >= hole[H_BALL] - 1e-4 else -1
    return OVER if body[B_Z] > hole[H_RIM] else -1


@kernel_with_arrays
def fly(body: Floats, hole: Floats, time: float, way: Floats, counts: Ints) -> tuple[int, float]:
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
                node(body, time, way, counts)
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
    return at_bed(body[B_X], body[B_Y], hole) and not at_bed(trial[B_X], trial[B_Y], hole)


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


__all__ = ["at_bed", "fly"]
