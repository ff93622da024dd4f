"""Aiming with a raised cue: the aid shows the jump that is then played."""

from dataclasses import replace
from math import radians

import numpy as np
import pytest

from engine.app import prediction
from engine.app.prediction import predict
from engine.app.session import Aid
from engine.game.observe import simulate_shot
from engine.physics.events import BallJumpedOver
from engine.physics.simulate import simulate
from engine.physics.world import Strike


@pytest.fixture
def aiming(start):
    """Return a session whose cue ball lies before the rack, the cue raised to jump it."""
    session = start("eight_ball")
    session = replace(session, place=(-0.7, 0.0), aid=Aid.ALL)
    return replace(session, stroke=session.stroke.headed(0.0).at(3.5).raised(45.0))


def test_the_aid_is_the_flight_that_is_played(aiming):
    trace = simulate_shot(aiming.variant, aiming.ahead, aiming.shot)
    assert trace.flies
    seen = predict(aiming)
    flat = predict(replace(aiming, stroke=aiming.stroke.raised(0.0)))
    assert seen.contact is not None
    assert seen.to_contact != flat.to_contact
    index = [ball.id for ball in trace.balls].index(aiming.cue_ball)
    way = trace.positions(np.linspace(0.0, trace.duration, 4000))[:, index, :2]
    for point in seen.to_contact:
        assert np.hypot(*(way - point).T).min() < 5e-3


def test_a_jump_is_aimed_over_the_first_ball(start):
    variant = start("eight_ball").variant
    layout = {"cue": (-0.6, 0.0), "1": (-0.3, 0.0), "2": (0.4, 0.0)}
    trace = simulate(variant.world, layout, "cue", Strike(3.0, 0.0, radians(42)))
    seen = prediction.read_prediction(trace, "cue")
    assert seen.contact[0] > -0.2
    assert any(isinstance(event, BallJumpedOver) for event in trace.events())


def test_the_aid_waits_while_flight_is_compiled(aiming, monkeypatch):
    monkeypatch.setattr(prediction, "flies_at_once", lambda: False)
    assert predict(aiming) is None
    assert predict(replace(aiming, stroke=aiming.stroke.raised(0.0))) is not None
