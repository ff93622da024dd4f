"""The report's two solvers: they come near the exact one as steps shrink, and fail where told."""

import numpy as np
import pytest
from physics_cases import R, make_world, watch

from engine.physics.events import BallsCollided
from engine.physics.simulate import simulate
from engine.physics.world import Strike
from tools.compare_solvers import Shot, compare, few_balls, judge, render
from tools.compare_solvers import make_world as compared_world

LAYOUT = {"b0": (-0.5, 0.0), "b1": (0.3, 0.01), "b2": (-0.2, 0.4)}
STRIKE = Strike(1.5, 0.0, 0.0, 0.1, 0.2)


def off(solver, rate):
    exact = simulate(make_world(3), LAYOUT, "b0", STRIKE)
    trace = simulate(make_world(3, solver=solver), LAYOUT, "b0", STRIKE, step=1.0 / rate)
    apart = exact.positions([1.0]) - trace.positions([1.0])
    return np.abs(apart).max()


@pytest.mark.parametrize("solver", ["corrective", "preemptive"])
def test_small_steps_come_near_the_exact_shot(solver):
    assert off(solver, 20000) < 2e-3
    assert off(solver, 20000) < off(solver, 24)


def test_a_fast_ball_tunnels_through_another_at_24_steps():
    layout = {"b0": (-1.0, 0.0), "b1": (-1.0 + 0.15, 0.0)}
    strike = Strike(5.0, 0.0)

    def first_hit(solver):
        trace = simulate(make_world(2, solver=solver), layout, "b0", strike, step=1.0 / 24)
        return next(e.time for e in trace.events() if isinstance(e, BallsCollided))

    assert first_hit("stepwise") < 0.03
    assert first_hit("preemptive") == pytest.approx(first_hit("stepwise"), abs=1e-9)
    assert first_hit("corrective") > 0.1


def test_preemptive_keeps_balls_apart_when_one_moves():
    trace = simulate(
        make_world(2, solver="preemptive"),
        {"b0": (0.0, 0.0), "b1": (0.4, 0.0)},
        "b0",
        Strike(1.0, 0.0),
    )
    watch_gap = np.hypot(
        *(
            trace.positions(np.linspace(0, trace.duration, 300))[:, 0, :2]
            - trace.positions(np.linspace(0, trace.duration, 300))[:, 1, :2]
        ).T
    )
    assert watch_gap.min() > 2 * R - 0.03
    watch(simulate(make_world(2), {"b0": (0.0, 0.0), "b1": (0.4, 0.0)}, "b0", Strike(1.0, 0.0)))


def test_the_comparison_measures_what_it_says():
    world = compared_world()
    shots = list(few_balls())[:2]
    exact = list(compare(world, shots, "stepwise", 60))
    assert [(o.early, o.late, o.invented, o.escaped) for o in exact] == [(0.0, 0.0, 0.0, 0)] * 2
    assert all(o.seconds > 0.0 for o in exact)
    rough = compare(world, shots, "corrective", 24)
    assert max(o.early for o in rough) > 1e-3
    shot = Shot({"ball-0": (0.0, 0.0)}, Strike(1.0, 0.0))
    lines = list(render("One ball", world, [shot]))
    assert lines[0] == "One ball (1 shots)"
    assert sum("corrective" in line for line in lines) == 3
    whole = simulate(world, shot.layout, "ball-0", shot.strike)
    assert judge(whole, whole, 60, 0.1).late == 0.0
