"""The same shot gives the same bits, or where it is a turned one the same to a nanometre.

One idea: whatever is not physics (how time is cut, which process, how many workers, which names,
when and in which direction) decides nothing. The pinned hashes are rewritten by
`python -m tools.pinned --update`, after a change that is meant to change bits.
"""

import os
import subprocess
import sys
from math import inf, pi
from pathlib import Path

import numpy as np
import pytest
from physics_cases import R, make_world, rack, random_layout, throw

from engine.physics.batch import simulate_batch
from engine.physics.simulate import Simulation, simulate
from engine.physics.world import Strike
from tools.pinned import FAMILIES, build, pinned, shot_of, spoken

ROOT = Path(__file__).parents[2]


@pytest.mark.parametrize("family", FAMILIES)
def test_the_pinned_shot_of_a_family_has_not_changed(family):
    kept = pinned()
    now = spoken(simulate(*shot_of(family)))
    then = kept["families"][family]
    if kept["build"] == build():
        assert now["hash"] == then["hash"], "meant? then: python -m tools.pinned --update"
    early = {name: now["at_half_a_second"][name] for name in then["at_half_a_second"]}
    assert early == {
        name: pytest.approx(place, abs=1e-6) for name, place in then["at_half_a_second"].items()
    }


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("chunk", [1 / 24, 1 / 60, 1 / 1000, 0.0313])
def test_a_familys_shot_in_chunks_of_time(family, chunk):
    world, layout, ball, strike = shot_of(family)
    whole = simulate(world, layout, ball, strike)
    shot = Simulation(world, layout, ball, strike)
    k = 0
    while not shot.finished:
        k += 1
        shot.advance(k * chunk)
    assert shot.trace().hash() == whole.hash()


def test_a_familys_shot_in_other_processes_with_other_hash_seeds():
    told = {}
    for seed in ("0", "1", "4242"):
        done = subprocess.run(
            [sys.executable, "-m", "tools.pinned"],
            capture_output=True,
            text=True,
            env={**os.environ, "PYTHONHASHSEED": seed},
            check=True,
            cwd=ROOT,
        )
        told[seed] = done.stdout
    assert len(set(told.values())) == 1
    for family in FAMILIES:
        assert simulate(*shot_of(family)).hash() in told["0"]


@pytest.mark.parametrize("family", FAMILIES)
def test_a_familys_shots_on_one_worker_and_on_two(family):
    world, layout, ball, strike = shot_of(family)
    shots = [
        (layout, ball, Strike(strike.speed, strike.heading + 0.001 * k, 0.0, 0.1, 0.1))
        for k in range(6)
    ]
    one, two = (simulate_batch(world, shots, workers=workers) for workers in (1, 2))
    assert [trace.hash() for trace in one] == [trace.hash() for trace in two]


@pytest.mark.parametrize("seed", range(10))
def test_names_change_nothing_beyond_a_nanometre_in_a_frozen_rack(seed):
    """Until balls meet again, which multiplies the last bit's differences."""
    rng = np.random.default_rng(seed)
    places = [(-0.3, rng.uniform(-0.02, 0.02)), *rack(0.3)]
    names = [f"b{k}" for k in rng.permutation(16)]
    strike = Strike(rng.uniform(1.0, 9.0), 0.0)
    ends = []
    for ids in ([f"b{k}" for k in range(16)], names):
        world = make_world(ids=ids, flight="none")
        trace = simulate(world, dict(zip(ids, places, strict=True)), ids[0], strike)
        when = trace.log[0, 1] + 1e-9
        ends.append((trace.velocities([when])[0], R * trace.spins([when])[0]))
    for plain, shuffled in zip(*ends, strict=True):
        assert shuffled == pytest.approx(plain, abs=1e-9)


@pytest.mark.parametrize("seed", range(10))
@pytest.mark.parametrize("later", [0.11, 0.7])
def test_a_shot_taken_up_later_goes_on_as_it_would_have(seed, later):
    """The clock starts anew in the middle of a shot: the rest is the same, moved in time."""
    rng = np.random.default_rng(seed)
    layout = random_layout(rng, 4)
    strike = Strike(rng.uniform(0.5, 1.5), rng.uniform(0, 6.28), 0.0, 0.2, 0.1)
    world = make_world(4, flight="none")
    whole = simulate(world, layout, "b0", strike)
    assert whole.duration > later
    at = [later]
    places, speeds, spins = (ask(at)[0] for ask in (whole.positions, whole.velocities, whole.spins))
    names = [ball.id for ball in whole.balls]
    motions = {n: (tuple(v[:2]), tuple(w)) for n, v, w in zip(names, speeds, spins, strict=True)}
    start = {n: (float(p[0]), float(p[1])) for n, p in zip(names, places, strict=True)}
    rest = throw(world, start, motions, inf)
    times = np.linspace(0.0, min(rest.duration, whole.duration - later), 60)
    assert rest.duration == pytest.approx(whole.duration - later, abs=1e-6)
    assert rest.positions(times) == pytest.approx(whole.positions(later + times), abs=1e-8)


def turned(point, quarters, mirror):
    x, y = point
    if mirror:
        y = -y
    for _ in range(quarters):
        x, y = -y, x
    return x, y


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("quarters", [0, 1, 2, 3])
@pytest.mark.parametrize("mirror", [False, True])
def test_a_scene_turned_by_quarters_and_mirrored_on_a_square_table(seed, quarters, mirror):
    rng = np.random.default_rng(seed)
    world = make_world(3, size=(1.6, 1.6), flight="none")
    layout = {f"b{k}": tuple(rng.uniform(-0.6, 0.6, 2)) for k in range(3)}
    heading, side, follow = rng.uniform(0, 6.28), 0.2, 0.15
    speed = rng.uniform(0.4, 1.4)
    one = simulate(world, layout, "b0", Strike(speed, heading, 0.0, side, follow))
    sign = -1.0 if mirror else 1.0
    strike = Strike(speed, sign * heading + quarters * pi / 2, 0.0, sign * side, follow)
    scene = {name: turned(place, quarters, mirror) for name, place in layout.items()}
    two = simulate(world, scene, "b0", strike)
    times = np.linspace(0.0, min(one.duration, two.duration), 80)
    there = one.positions(times)
    expected = np.stack([*turned((there[..., 0], there[..., 1]), quarters, mirror)], axis=-1)
    assert two.positions(times)[..., :2] == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("seed", range(8))
def test_a_nudge_of_a_femtometre_changes_no_event_of_a_calm_shot(seed):
    rng = np.random.default_rng(seed)
    layout = random_layout(rng, 3)
    strike = Strike(rng.uniform(0.4, 1.2), rng.uniform(0, 6.28))
    nudged = {name: (x + 1e-15, y - 1e-15) for name, (x, y) in layout.items()}
    told = []
    for places in (layout, nudged):
        trace = simulate(make_world(3, flight="none"), places, "b0", strike)
        told.append([(type(event), event.ball) for event in trace.events()])
    assert told[0] == told[1]
