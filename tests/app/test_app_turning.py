import numpy as np
import pytest

from engine.app import commands
from engine.app.session import Mode
from engine.app.steps import act
from engine.app.turning import MOST, Turning, rotations


@pytest.fixture
def trace(start):
    session = start("eight_ball")
    assert session.mode is Mode.PLACING
    for command in (
        commands.Confirm(),
        commands.SetTip(0.3, -0.3),
        commands.SetSpeed(6.0),
        commands.Confirm(),
    ):
        session = act(session, command)
    return session.trace


def test_following_the_spin_frame_by_frame_agrees_with_the_exact_rotations(trace):
    turning = Turning(trace)
    for time in np.arange(0.0, 2.0, 1.0 / 60.0):
        now = turning.at(float(time))
    exact = trace.orientations([float(time)])[0]
    angle = np.arccos(np.clip((np.einsum("nij,nij->n", now, exact) - 1.0) / 2.0, -1.0, 1.0))
    assert angle.max() < 0.15
    assert np.abs(now - np.eye(3)).max() > 0.5


def test_a_jump_in_time_is_near_the_exact_rotations_and_going_back_begins_anew(trace):
    turning = Turning(trace)
    for time in (2.0, 0.3):
        now, exact = turning.at(time), trace.orientations([time])[0]
        angle = np.arccos(np.clip((np.einsum("nij,nij->n", now, exact) - 1.0) / 2.0, -1.0, 1.0))
        assert angle.max() < 0.3
    assert np.array_equal(turning.at(-0.2), np.tile(np.eye(3), (len(trace.balls), 1, 1)))


def test_a_jump_to_the_end_takes_few_steps(trace, monkeypatch):
    asked = []
    spins = type(trace).spins
    monkeypatch.setattr(
        type(trace), "spins", lambda self, at: asked.append(len(at)) or spins(self, at)
    )
    turned = Turning(trace).at(trace.duration)
    assert sum(asked) <= MOST
    assert np.abs(np.linalg.det(turned) - 1.0).max() < 1e-9


def test_a_rotation_about_an_axis_turns_the_others():
    quarter = rotations(np.array([[0.0, 0.0, np.pi / 2.0], [0.0, 0.0, 0.0]]))
    assert quarter[0] @ [1.0, 0.0, 0.0] == pytest.approx([0.0, 1.0, 0.0], abs=1e-12)
    assert np.array_equal(quarter[1], np.eye(3))
