"""Balls that start moving without a cue."""

import pytest
from physics_cases import R, make_world, throw

from engine.physics.strike import Motion
from engine.physics.throw import throw_balls


def test_a_throw_is_a_shot_like_any_other():
    world = make_world(2)
    layout = {"b0": (0.0, 0.0), "b1": (0.3, 0.01)}
    v, w = (1.5, 0.2), (0.0, 3.0 / R, 20.0)
    trace = throw_balls(world, layout, {"b0": Motion(v, w)})
    assert trace.hash() == throw(world, layout, {"b0": (v, w)}).hash()
    assert trace.velocities([0.0])[0, 0, :2] == pytest.approx(v)
    assert trace.kinetic_energy([trace.duration])[0] == 0.0


def test_only_what_lies_there_can_be_thrown():
    with pytest.raises(ValueError, match="b1"):
        throw_balls(make_world(2), {"b0": (0.0, 0.0)}, {"b1": Motion((1.0, 0.0), (0.0, 0.0, 0.0))})
    with pytest.raises(ValueError, match="no ball"):
        throw_balls(make_world(2), {}, {})
