"""Many shots at once: the same bits as one by one."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from physics_cases import make_world, rack, random_layout, random_strike

from engine.physics.batch import simulate_batch
from engine.physics.simulate import simulate
from engine.physics.world import Strike

BREAK = {"b0": (-0.635, 0.003), **{f"b{k + 1}": p for k, p in enumerate(rack(0.635))}}


def strokes(n):
    rng = np.random.default_rng(5)
    mixed = [(random_layout(rng, 9), "b0", random_strike(rng)) for _ in range(n)]
    return [*mixed, (BREAK, "b0", Strike(7.0, 0.01))]


def test_without_joblib_it_is_said_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "joblib", None)
    with pytest.raises(ModuleNotFoundError, match="batch"):
        simulate_batch(None, [({}, "cue", None)], workers=2)


@pytest.mark.parametrize("workers", [1, 2])
def test_a_batch_has_the_bits_of_its_shots(workers):
    world, shots = make_world(16, pockets=True), strokes(12)
    together = simulate_batch(world, shots, workers=workers)
    alone = [simulate(world, *shot) for shot in shots]
    assert [trace.hash() for trace in together] == [trace.hash() for trace in alone]
    assert together[-1].events() == alone[-1].events()


def test_nothing_and_nobody():
    world = make_world(2)
    assert simulate_batch(world, [], workers=2) == []
    with pytest.raises(ValueError, match="at least one"):
        simulate_batch(world, [], workers=0)


@pytest.mark.parametrize("workers", [1, 2])
def test_a_shot_that_cannot_be(workers):
    bad = ({"b0": (0.0, 0.0)}, "b1", Strike(1.0, 0.0))
    with pytest.raises(ValueError, match="not on the table"):
        simulate_batch(make_world(2), [bad, bad, bad], workers=workers)


def test_joblib_is_loaded_only_for_many_workers():
    code = """
import sys
sys.path.insert(0, "tests/physics")
from engine.physics.batch import simulate_batch
from physics_cases import make_world
from engine.physics.world import Strike
simulate_batch(make_world(1), [({"b0": (0.0, 0.0)}, "b0", Strike(1.0, 0.0))])
print("joblib" in sys.modules)
"""
    root = Path(__file__).parents[2]
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=root
    )
    assert done.stdout.strip() == "False"
