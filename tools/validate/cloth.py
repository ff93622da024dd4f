"""Group A: one ball on the cloth, sliding, rolling and spinning."""

from __future__ import annotations

from dataclasses import replace
from math import hypot
from typing import TYPE_CHECKING

import numpy as np

from engine.physics.events import BallStopped, RollingBegan
from engine.physics.strike import Motion, strike_ball
from engine.physics.world import Cue, Strike
from tools.validate.lab import (
    CLOTH,
    ball_name,
    cloth_of,
    radius_of,
    rolls_at,
    throw,
    velocity,
    world_of,
)
from tools.validate.prose import need

if TYPE_CHECKING:
    from collections.abc import Callable

    from engine.physics.trace import Trace
    from tools.validate.check import Check, Wanted


def _motion(check: Check) -> Motion:
    """Return how the check's ball starts: vectors, or numbers along +x and about +z."""
    radius = radius_of(check)
    if isinstance(check.parameters.get("v0"), list):
        v, w = check.numbers("v0"), check.numbers("omega0")
        return Motion((v[0], v[1]), (w[0], w[1], w[2]))
    speed = check.number("v0", default=0.0)
    side = check.number("omega_z", default=0.0)
    if check.has("tip_height_over_R"):
        return _struck(check, speed, check.number("tip_height_over_R"))
    turn = check.number("R_omega", default=0.0)
    if check.text("motion", "roll" if "m/s rolling" in check.description else "") == "roll":
        turn = speed
    return Motion((speed, 0.0), (0.0, turn / radius, side))


def _struck(check: Check, speed: float, height: float) -> Motion:
    """Return the motion of a ball that a level cue struck so that it has this speed (m/s)."""
    ball = world_of(check, 1).balls[0]
    cue = Cue(0.54, 0.8, 10.0, 25.0)
    unit = strike_ball(ball, cue, CLOTH, Strike(1.0, 0.0, follow=height)).velocity[0]
    return strike_ball(ball, cue, CLOTH, Strike(speed / unit, 0.0, follow=height))


def _run(check: Check, wanted: Wanted) -> Trace:
    cloth = replace(cloth_of(check), sliding=need(check, wanted, "mu_s"))
    world = world_of(check, 1, cloth=cloth)
    return throw(world, [(0.0, 0.0)], {0: _motion(check)})


def _stops_at(trace: Trace) -> float:
    return max((e.time for e in trace.events() if isinstance(e, BallStopped)), default=0.0)


def _slide_time(trace: Trace) -> object:
    return rolls_at(trace, 0)


def _slide_distance(trace: Trace) -> object:
    return float(trace.positions([rolls_at(trace, 0)])[0, 0, 0])


def _rolling_speed(trace: Trace) -> object:
    return float(velocity(trace, 0, rolls_at(trace, 0))[0])


def _rolling_velocity(trace: Trace) -> object:
    return velocity(trace, 0, rolls_at(trace, 0)).tolist()


def _way_to_roll(trace: Trace) -> object:
    both = trace.positions([0.0, rolls_at(trace, 0)])[:, 0, :2]
    return (both[1] - both[0]).tolist()


def _energy_lost(trace: Trace) -> object:
    start, end = trace.kinetic_energy([0.0, rolls_at(trace, 0)])
    return float(start - end)


def _energy_ratio(trace: Trace) -> object:
    start, end = trace.kinetic_energy([0.0, rolls_at(trace, 0)])
    return float(end / start)


def _slip(trace: Trace) -> object:
    v, w = trace.velocities([0.0])[0, 0], trace.spins([0.0])[0, 0]
    radius = trace.balls[0].radius
    return hypot(v[0] - radius * w[1], v[1] + radius * w[0])


def _distance(trace: Trace) -> object:
    return float(trace.positions([trace.duration])[0, 0, 0])


def _roll_distance(trace: Trace) -> object:
    start, end = trace.positions([rolls_at(trace, 0), trace.duration])[:, 0, 0]
    return float(end - start)


def _roll_time(trace: Trace) -> object:
    return _translation_ends(trace) - rolls_at(trace, 0)


def _translation_ends(trace: Trace) -> float:
    """Return when the ball's centre comes to rest, s."""
    moving = [t1 for _, t1, _, v, a in trace.pieces_of(ball_name(0)) if any(v) or any(a)]
    return max(moving, default=0.0)


def _side_spin_left(trace: Trace) -> object:
    return float(trace.spins([_translation_ends(trace)])[0, 0, 2])


def _angle(trace: Trace) -> object:
    """Return the angle turned about the vertical: spin changes evenly, so trapezia are exact."""
    times = np.unique([0.0, *(t for piece in trace.pieces_of(ball_name(0)) for t in piece[:2])])
    times = times[times <= _stops_at(trace)]
    spins = trace.spins(times)[:, 0, 2]
    return float((np.diff(times) * (spins[1:] + spins[:-1])).sum() / 2.0)


def _stun_time(trace: Trace) -> float:
    """Return when the spin about the level axis has gone while the ball slides, s."""
    end = rolls_at(trace, 0)
    first, last = trace.spins([0.0, end * (1.0 - 1e-9)])[:, 0, 1]
    return float(-first * end * (1.0 - 1e-9) / (last - first))


OF_A_RUN: tuple[tuple[str, Callable[[Trace], object]], ...] = (
    (r"slide_time|t_roll mu_s=.*", _slide_time),
    (r"slide_distance", _slide_distance),
    (r"v_rolling", _rolling_speed),
    (r"v_roll_xy.*", _rolling_velocity),
    (r"dr_xy.*", _way_to_roll),
    (r"KE_lost_J", _energy_lost),
    (r"KE0", lambda trace: float(trace.kinetic_energy([0.0])[0])),
    (r"KE_at_roll", lambda trace: float(trace.kinetic_energy([rolls_at(trace, 0)])[0])),
    (r"ratio", _energy_ratio),
    (r"u0_norm", _slip),
    (r"t_stop|t_rest", _stops_at),
    (r"distance|x_rest", _distance),
    (r"v_end", lambda trace: float(np.abs(trace.velocities([trace.duration])).max())),
    (r"w_end", lambda trace: float(np.abs(trace.spins([trace.duration])).max())),
    (r"n_rolling_events", lambda trace: sum(isinstance(e, RollingBegan) for e in trace.events())),
    (r"t_roll_to_rest", _roll_time),
    (r"roll_distance", _roll_distance),
    (r"t_roll_end", _translation_ends),
    (r"wz_at_roll_end", _side_spin_left),
    (r"angle_turned", _angle),
    (r"t_stun", _stun_time),
    (r"x_stun", lambda trace: float(trace.positions([_stun_time(trace)])[0, 0, 0])),
    (r"v_stun", lambda trace: float(trace.velocities([_stun_time(trace)])[0, 0, 0])),
)


def _run_to(check: Check, length: float, rolling: float | None = None) -> tuple[float, float]:
    """Return speed (m/s) and time (s) of a rolling ball that comes to rest after `length` (m)."""
    cloth = cloth_of(check)
    world = world_of(check, 1, cloth=replace(cloth, rolling=rolling or cloth.rolling))
    speed, trace = 1.0, None
    for _ in range(60):
        spin = (0.0, speed / world.balls[0].radius, 0.0)
        trace = throw(world, [(0.0, 0.0)], {0: Motion((speed, 0.0), spin)})
        way = float(trace.positions([trace.duration])[0, 0, 0])
        if abs(way - length) <= 1e-14 * length:
            break
        speed *= (length / way) ** 0.5
    return speed, trace.duration if trace else 0.0


def _lag_speed(check: Check, _: Wanted) -> object:
    return _run_to(check, check.number("L"))[0]


def _lag_time(check: Check, _: Wanted) -> object:
    return _run_to(check, check.number("L"))[1]


def _rolling_from_time(check: Check, wanted: Wanted) -> object:
    """Return the rolling friction with which a lag of the check's length takes the time told."""
    seconds, rolling = need(check, wanted, "t"), check.number("mu_r")
    for _ in range(60):
        ratio = _run_to(check, check.number("L"), rolling)[1] / seconds
        rolling *= ratio * ratio
        if abs(ratio - 1.0) < 1e-14:
            break
    return rolling


def _table_speed(check: Check, _: Wanted) -> object:
    """Return gravity over the deceleration of a rolling ball."""
    speed, seconds = _run_to(check, check.number("L"))
    return cloth_of(check).gravity * seconds / speed


def _spin_loss(check: Check, _: Wanted) -> object:
    """Return a ball's loss of side spin (rad/s^2) on a cloth that is given by its mu_sp."""
    cloth, radius = cloth_of(check), radius_of(check)
    mu = check.number("mu_sp", default=2.0 * radius * cloth.spin_deceleration / 5.0 / cloth.gravity)
    cloth = replace(cloth, spin_deceleration=5.0 * mu * cloth.gravity / (2.0 * radius))
    spin = Motion((0.0, 0.0), (0.0, 0.0, check.number("omega_z")))
    trace = throw(world_of(check, 1, cloth=cloth), [(0.0, 0.0)], {0: spin})
    start, end = trace.spins([0.0, trace.duration / 2.0])[:, 0, 2]
    return float(2.0 * (start - end) / trace.duration)


def _of_a_run(ask: Callable[[Trace], object]) -> Callable[[Check, Wanted], object]:
    return lambda check, wanted: ask(_run(check, wanted))


KINDS = (
    *((pattern, _of_a_run(ask)) for pattern, ask in OF_A_RUN),
    (r"alpha_from_mu_sp", _spin_loss),
    (r"v_start", _lag_speed),
    (r"t", _lag_time),
    (r"mu_r from t=.*", _rolling_from_time),
    (r"table_speed.*", _table_speed),
)
"""Which quantity is answered by what."""
