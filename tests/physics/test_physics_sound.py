"""What must hold for every shot: the monitor, chunks, labels, mirrors, processes, nasty places."""

import os
import subprocess
import sys
from itertools import pairwise
from math import inf, pi, sqrt
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from physics_cases import (
    ALCIATORE,
    CORNER,
    REACH,
    ROUND,
    SIDE,
    TIGHT,
    R,
    make_world,
    rack,
    random_layout,
    random_strike,
    throw,
    watch,
)

from engine.physics.events import BallLeftTable, BallPocketed, BallsCollided, CushionHit, JawHit
from engine.physics.simulate import Simulation, simulate, warm_up
from engine.physics.world import Ball, Cloth, Contact, Rubber, Strike, World
from engine.table.build import build_table

ROOT = Path(__file__).parents[2]
BREAK = {"b0": (-0.635, 0.003), **{f"b{k + 1}": p for k, p in enumerate(rack(0.635))}}


@pytest.mark.parametrize("seed", range(100))
def test_random_shots_on_a_table_without_pockets(seed):
    rng = np.random.default_rng(seed)
    n = int(rng.integers(1, 10))
    cushion = ["han-2005", "restitution", "mathavan-2010"][seed % 3]
    world = make_world(n, ball_cushion=cushion, flight="none")
    trace = simulate(world, random_layout(rng, n), "b0", random_strike(rng))
    watch(trace)
    assert len(trace.final) == n
    assert trace.kinetic_energy([trace.duration])[0] == 0.0


@pytest.mark.parametrize("seed", range(100))
def test_random_shots_on_a_table_with_six_pockets(seed):
    rng = np.random.default_rng(1000 + seed)
    n = int(rng.integers(1, 14))
    cuts = [(CORNER, SIDE), ROUND, TIGHT][seed % 3]
    world = make_world(n, pockets=True, cuts=cuts, flight="none")
    trace = simulate(world, random_layout(rng, n), "b0", random_strike(rng))
    watch(trace, pockets=True)
    assert len(trace.final) + len(trace.pocketed) == n
    assert not [e for e in trace.events() if isinstance(e, BallLeftTable)]


def test_all_pockets_take_balls_and_jaws_are_hit():
    world = make_world(1, pockets=True)
    pocketed, jaws = set(), set()
    for k in range(240):
        trace = simulate(world, {"b0": (0.1, 0.05)}, "b0", Strike(3.0, k * pi / 120))
        pocketed |= set(trace.pocketed.values())
        jaws |= {e.pocket for e in trace.events() if isinstance(e, JawHit)}
        for e in trace.events():
            if isinstance(e, BallPocketed):
                assert trace.positions([e.time + 1e-9])[0, 0, 2] < 0.0
    assert len(pocketed) == 6
    assert len(jaws) == 6


@pytest.mark.parametrize("chunk", [1 / 24, 1 / 60, 1 / 1000])
@pytest.mark.parametrize("solver", ["stepwise", "corrective", "preemptive"])
def test_chunks_of_time_change_no_bit(chunk, solver):
    world = make_world(16, pockets=True, solver=solver)
    whole = simulate(world, BREAK, "b0", Strike(5.0, 0.0))
    shot = Simulation(world, BREAK, "b0", Strike(5.0, 0.0))
    k = 0
    while not shot.finished:
        k += 1
        shot.advance(k * chunk)
        if k % 50 == 0:
            shot.trace().positions([k * chunk])
    assert shot.trace().hash() == whole.hash()


def test_a_trace_of_an_unfinished_shot_agrees_with_the_whole():
    world = make_world(16, pockets=True)
    whole = simulate(world, BREAK, "b0", Strike(5.0, 0.0))
    shot = Simulation(world, BREAK, "b0", Strike(5.0, 0.0))
    shot.advance(0.7)
    part = shot.trace()
    times = np.linspace(0.0, 0.7, 50)
    assert part.duration == 0.7
    assert (part.positions(times) == whole.positions(times)).all()
    assert part.events() == tuple(e for e in whole.events() if e.time <= 0.7)


SCRIPT = """
import sys
sys.path.insert(0, "tests/physics")
from test_physics_sound import BREAK, Strike, make_world, simulate
print(simulate(make_world(16, pockets=True), BREAK, "b0", Strike(7.0, 0.01, 0.1, 0.2, 0.1)).hash())
"""


def test_two_processes_with_different_hash_seeds_agree():
    seen = set()
    for seed in ("1", "77"):
        env = {**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": "."}
        done = subprocess.run(
            [sys.executable, "-c", SCRIPT],
            capture_output=True,
            text=True,
            env=env,
            check=True,
            cwd=ROOT,
        )
        seen.add(done.stdout.strip())
    assert len(seen) == 1
    assert len(seen.pop()) == 64


def few(rng):
    """Three balls and a gentle shot: sensitive, but not yet chaotic."""
    return random_layout(rng, 3), Strike(rng.uniform(0.3, 1.5), rng.uniform(0, 6.28), 0.0, 0.2, 0.1)


@pytest.mark.parametrize("seed", range(25))
def test_a_mirrored_table_gives_a_mirrored_trace(seed):
    rng = np.random.default_rng(seed)
    layout, strike = few(rng)
    world = make_world(3)
    other = Strike(strike.speed, -strike.heading, 0.0, -strike.side, strike.follow)
    one = simulate(world, layout, "b0", strike)
    two = simulate(world, {k: (x, -y) for k, (x, y) in layout.items()}, "b0", other)
    times = np.linspace(0.0, one.duration, 100)
    assert two.positions(times) == pytest.approx(one.positions(times) * [1, -1, 1], abs=1e-9)


@pytest.mark.parametrize("seed", range(25))
def test_turning_the_table_by_half_a_turn(seed):
    rng = np.random.default_rng(seed)
    layout, strike = few(rng)
    world = make_world(3, pockets=True)
    turned = Strike(strike.speed, strike.heading + pi, 0.0, strike.side, strike.follow)
    one = simulate(world, layout, "b0", strike)
    two = simulate(world, {k: (-x, -y) for k, (x, y) in layout.items()}, "b0", turned)
    times = np.linspace(0.0, min(one.duration, two.duration), 100)
    assert two.positions(times) == pytest.approx(one.positions(times) * [-1, -1, 1], abs=1e-9)


@pytest.mark.parametrize("seed", range(25))
def test_labels_change_no_bit(seed):
    rng = np.random.default_rng(seed)
    n = 8
    layout, strike = random_layout(rng, n), random_strike(rng)
    straight = simulate(make_world(n), layout, "b0", strike)
    names = [f"b{k}" for k in rng.permutation(n)]
    shuffled = simulate(make_world(ids=names), layout, "b0", strike)
    order = [names.index(f"b{k}") for k in range(n)]
    times = np.linspace(0.0, straight.duration, 50)
    assert shuffled.duration == straight.duration
    assert (shuffled.positions(times)[:, order] == straight.positions(times)).all()


@pytest.mark.parametrize("gap", [0.0, 1e-9, 1e-6, 1e-5, 1e-4, 1e-3])
@pytest.mark.parametrize("contact", [ALCIATORE, Contact(1.0, 0.0)])
def test_breaks_from_any_rack(gap, contact):
    layout = {"b0": (-0.635, 0.0), **{f"b{k + 1}": p for k, p in enumerate(rack(0.635, gap))}}
    trace = simulate(make_world(16, pockets=True, contact=contact), layout, "b0", Strike(8.0, 0.0))
    watch(trace, pockets=True)
    assert len(trace.log) < 2000


def test_a_break_straight_into_the_rack_stays_symmetric_at_first():
    layout = {"b0": (-0.635, 0.0), **{f"b{k + 1}": p for k, p in enumerate(rack(0.635))}}
    trace = simulate(make_world(16), layout, "b0", Strike(6.0, 0.0))
    hit = next(e.time for e in trace.events() if isinstance(e, BallsCollided))
    places = trace.positions([hit + 0.02])[0, :, :2]
    for x, y in places:
        assert np.hypot(places[:, 0] - x, places[:, 1] + y).min() < 1e-9


NASTY = {
    "rack rounded to micrometres": {
        "b0": (-0.3, 0.0),
        **{f"b{k + 1}": (round(x, 6), round(y, 6)) for k, (x, y) in enumerate(rack(0.2))},
    },
    "line": {"b0": (-0.3, 0.0), **{f"b{k + 1}": (2 * R * k, 0.0) for k in range(5)}},
    "all in line": {f"b{k}": (2 * R * k, 0.0) for k in range(6)},
    "row on a cushion": {
        "b0": (-0.3, 0.635 - REACH),
        **{f"b{k + 1}": (2 * R * k, 0.635 - REACH) for k in range(5)},
    },
    "in a corner": {
        "b0": (1.1, 0.5),
        "b1": (1.27 - REACH, 0.635 - REACH),
        "b2": (1.27 - REACH - 2 * R, 0.635 - REACH),
    },
    "ring": {
        "b0": (0.0, 0.0),
        **{f"b{k + 1}": (2 * R * np.cos(k * pi / 3), 2 * R * np.sin(k * pi / 3)) for k in range(6)},
    },
}


@pytest.mark.parametrize("layout", NASTY.values(), ids=NASTY.keys())
@pytest.mark.parametrize("speed", [0.01, 0.5, 6.0])
@pytest.mark.parametrize("follow", [-0.4, 0.0, 0.45])
def test_nasty_places(layout, speed, follow):
    world = make_world(len(layout))
    trace = simulate(world, layout, "b0", Strike(speed, 0.0, 0.0, 0.1, follow))
    overlap = 3e-6 if "b15" in layout else 0.0
    if overlap:
        assert np.isfinite(trace.positions([trace.duration])).all()
    else:
        watch(trace)
    assert len(trace.log) < 6000


def test_frozen_on_a_cushion_and_played_along_it():
    world = make_world(1)
    start = {"b0": (0.0, 0.635 - REACH)}
    trace = throw(world, start, {"b0": ((1.0, 0.0), (0.0, 0.0, 0.0))}, 0.5)
    assert not [e for e in trace.events() if isinstance(e, CushionHit)]
    assert trace.positions([0.5])[0, 0, 1] == start["b0"][1]


def test_spin_presses_a_ball_against_a_cushion():
    world = make_world(1)
    start = {"b0": (0.0, 0.635 - REACH)}
    trace = throw(world, start, {"b0": ((0.0, 0.0), (-50.0, 0.0, 0.0))})
    watch(trace)
    assert abs(trace.final["b0"][1] - start["b0"][1]) < 1e-3
    assert len(trace.log) < 3000


def test_forty_five_degrees_into_a_corner():
    trace = simulate(make_world(1), {"b0": (1.0, 0.365)}, "b0", Strike(4.0, pi / 4))
    watch(trace)
    first, second, *_ = [e for e in trace.events() if isinstance(e, CushionHit)]
    assert {first.cushion, second.cushion} == {"foot", "left"}
    assert second.time - first.time < 1e-12


@settings(max_examples=60, deadline=None)
@given(st.floats(0.05, 10.0), st.floats(0.0, 2 * pi), st.floats(-0.4, 0.4), st.floats(-0.4, 0.4))
def test_energy_never_grows_and_all_stop(speed, heading, side, follow):
    layout = {"b0": (0.0, 0.0), "b1": (2 * R, 0.0), "b2": (0.5, 0.3), "b3": (-0.8, -0.2)}
    strike = Strike(speed, heading, 0.0, side, follow)
    watch(simulate(make_world(4), layout, "b0", strike))


def test_balls_of_different_size_and_mass():
    table = build_table(1.8288, 0.9144, 0.031, *ROUND, 0.12)
    balls = (Ball("cue", 0.0238, 0.094), *(Ball(f"b{k}", 0.0254, 0.116) for k in range(6)))
    world = World(
        table,
        balls,
        Cloth(0.2, 0.01, 10.0),
        ALCIATORE,
        Rubber(0.9, 0.0, 0.0, 0.14),
        make_world().cue,
        make_world().models,
    )
    for seed in range(10):
        rng = np.random.default_rng(seed)
        layout = {"cue": (-0.5, 0.0)}
        layout |= {f"b{k}": (0.1 * k, 0.1 * rng.uniform(-1, 1)) for k in range(6)}
        trace = simulate(world, layout, "cue", Strike(4.0, rng.uniform(-0.1, 0.1)))
        watch(trace, reach=0.0238, size=(1.8288, 0.9144), pockets=True)
        hit = next((e for e in trace.events() if isinstance(e, BallsCollided)), None)
        if hit:
            i, j = (
                next(k for k, b in enumerate(balls) if b.id == name)
                for name in (hit.ball, hit.other)
            )
            apart = np.diff(trace.positions([hit.time])[0, [i, j], :2], axis=0)[0]
            need = 2.0 * sqrt(balls[i].radius * balls[j].radius)
            assert np.hypot(*apart) == pytest.approx(need, abs=1e-12)


def test_a_slow_ball_comes_to_rest():
    for speed in (1e-9, 1e-6, 1e-3):
        trace = simulate(make_world(1), {"b0": (0.0, 0.0)}, "b0", Strike(speed, 0.0))
        assert trace.duration < 0.02
        assert trace.final["b0"][0] == pytest.approx(0.0, abs=1e-4)


def test_refusals():
    world = make_world(2)
    with pytest.raises(ValueError, match="not on the table"):
        simulate(world, {"b1": (0.0, 0.0)}, "b0", Strike(1.0, 0.0))
    with pytest.raises(ValueError, match="world has not"):
        simulate(world, {"b0": (0.0, 0.0), "x": (0.1, 0.0)}, "b0", Strike(1.0, 0.0))
    with pytest.raises(ValueError, match="overlap"):
        simulate(world, {"b0": (0.0, 0.0), "b1": (0.05, 0.0)}, "b0", Strike(1.0, 0.0))
    with pytest.raises(ValueError, match="two finite numbers"):
        simulate(world, {"b0": (float("nan"), 0.0)}, "b0", Strike(1.0, 0.0))
    with pytest.raises(ValueError, match="unknown ball_cushion model"):
        simulate(make_world(1, ball_cushion="soft"), {"b0": (0.0, 0.0)}, "b0", Strike(1.0, 0.0))
    with pytest.raises(ValueError, match="unknown solver"):
        simulate(make_world(1, solver="magic"), {"b0": (0.0, 0.0)}, "b0", Strike(1.0, 0.0))
    for cloth in (Cloth(0.0, 0.01, 10.0), Cloth(0.2, -0.01, 10.0)):
        with pytest.raises(ValueError, match="above zero"):
            simulate(make_world(1, cloth=cloth), {"b0": (0.0, 0.0)}, "b0", Strike(1.0, 0.0))
    with pytest.raises(ValueError, match="restitution"):
        simulate(make_world(1, contact=Contact(1.2, 0.0)), {"b0": (0, 0)}, "b0", Strike(1.0, 0.0))


def test_pieces_give_the_positions():
    world = make_world(3)
    layout = {"b0": (0.0, 0.0), "b1": (0.4, 0.01), "b2": (-0.5, 0.2)}
    trace = simulate(world, layout, "b0", Strike(3.0, 0.0, 0.0, 0.2, 0.3))
    for index in range(3):
        pieces = trace.pieces_of(f"b{index}")
        assert pieces[0][0] == 0.0
        for (_, end, *_), (start, *_) in pairwise(pieces):
            assert end == start
        for t0, t1, r, v, a in pieces:
            s = 0.5 * (t1 - t0)
            expected = trace.positions([t0 + s])[0, index, :2]
            found = np.array(r) + np.array(v) * s + 0.5 * np.array(a) * s * s
            assert found == pytest.approx(expected, abs=1e-12)


def test_types_of_the_world_do_not_load_numba():
    code = (
        "import sys, engine.physics.world, engine.physics.events, engine.physics.simulate, "
        "engine.table.build; print('numba' in sys.modules)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT
    )
    assert done.stdout.strip() == "False"


def test_warm_up_speaks():
    said = []
    warm_up(said.append)
    warm_up()
    assert len(said) == 2


def test_momentum_in_a_break_without_noses():
    world = make_world(16, size=(50.0, 50.0), cloth=Cloth(1e-6, 1e-7, 10.0))
    shot = Simulation(world, BREAK, "b0", Strike(5.0, 0.0))
    shot.advance(1.0)
    trace = shot.trace()
    v = trace.velocities([0.0, 0.5, 1.0])[..., :2].sum(axis=1)
    assert v[1] == pytest.approx(v[0], abs=1e-4)
    assert v[2] == pytest.approx(v[0], abs=1e-4)
    assert shot.finished is False
    shot.advance(inf)
    assert shot.finished


def test_a_resting_contact_is_told_once():
    world = make_world(2)
    start = {"b0": (0.0, 0.0), "b1": (2 * R, 0.0)}
    trace = throw(world, start, {"b0": ((0.0, 0.0), (0.0, 10.0, 0.0))})
    told = [e for e in trace.events() if isinstance(e, BallsCollided)]
    assert len(told) == 1
    assert len(trace.log) > 50
