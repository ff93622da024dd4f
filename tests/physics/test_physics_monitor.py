"""The monitor sees what it is there to see: each rule broken by hand in a sound trace."""

from dataclasses import replace

import numpy as np
import pytest
from physics_cases import REACH, R, make_world, rack

from engine.physics import state
from engine.physics.monitor import examine
from engine.physics.simulate import simulate
from engine.physics.world import Strike

WORLD = make_world(3)
LAYOUT = {"b0": (0.0, 0.0), "b1": (0.3, 0.01), "b2": (-0.5, 0.2)}


def sound():
    return simulate(WORLD, LAYOUT, "b0", Strike(3.0, 0.0, 0.0, 0.1, 0.2))


def spoilt(change):
    trace = sound()
    pieces, log = trace.pieces.copy(), trace.log.copy()
    change(pieces, log)
    return examine(replace(trace, pieces=pieces, log=log), WORLD.table)


def test_a_sound_shot_has_no_faults():
    found = examine(sound(), WORLD.table)
    assert found.faults() == ()
    assert found.momentum < 1e-14
    assert -1e-15 < found.gap < 1e-12


def test_a_flight_that_comes_into_the_bed_is_found():
    world = make_world(1)
    trace = simulate(world, {"b0": (0.0, 0.0)}, "b0", Strike(3.0, 0.0, 0.7))
    assert examine(trace, world.table).below < 1e-12
    pieces = trace.pieces.copy()
    first = int(np.flatnonzero(pieces[:, state.P_KIND] == state.FLY)[0])
    pieces[first, state.P_Z] -= 1e-6
    found = examine(replace(trace, pieces=pieces), world.table)
    assert found.below == pytest.approx(1e-6)
    assert any("in the bed" in words for words in found.faults())


def test_a_break_from_a_frozen_rack_keeps_momentum():
    layout = {"b0": (-0.6, 0.0), **{f"b{k + 1}": p for k, p in enumerate(rack(0.635))}}
    world = make_world(16, pockets=True)
    found = examine(simulate(world, layout, "b0", Strike(9.0, 0.003)), world.table)
    assert found.faults() == ()


def own(pieces, ball):
    return np.flatnonzero(pieces[:, state.P_BALL] == ball)


def put(ball, x, y):
    def change(pieces, _):
        rows = own(pieces, ball)
        pieces[rows, state.P_X], pieces[rows, state.P_Y] = x, y
        pieces[np.ix_(rows, [state.P_VX, state.P_VY, state.P_AX, state.P_AY])] = 0.0

    return change


def faster(pieces, _):
    row = own(pieces, 1)[1]
    pieces[row, state.P_VX] *= 1.001


def broken(pieces, _):
    pieces[own(pieces, 0)[1], state.P_VX] = np.nan


def gone(_, log):
    log[-1, state.E_KIND] = state.LEFT


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (put(2, 1.27 - REACH + 1e-6, 0.0), "in a nose"),
        (faster, "momentum is off"),
        (broken, "not finite"),
        (gone, "left the table"),
    ],
)
def test_what_is_wrong_is_told(change, words):
    assert any(words in fault for fault in spoilt(change).faults())


def test_an_overlap_counts_from_the_start():
    layout = {"b0": (0.0, 0.0), "b1": (2 * R - 1e-6, 0.0)}
    trace = simulate(make_world(2), layout, "b0", Strike(1.0, 1.5))
    found = examine(trace)
    assert found.gap == pytest.approx(-1e-6, rel=1e-6)
    assert found.overlap <= 1e-9
    trace = sound()
    pieces = trace.pieces.copy()
    pieces[own(pieces, 1)[-1], state.P_X : state.P_Y + 1] = pieces[
        own(pieces, 2)[-1], state.P_X : state.P_Y + 1
    ]
    assert examine(replace(trace, pieces=pieces)).overlap > R


def test_a_ball_that_passes_through_another():
    """Every meeting struck from the log, the striking ball runs on as if nobody were there."""
    alone = simulate(WORLD, {"b0": LAYOUT["b0"]}, "b0", Strike(3.0, 0.03))
    world = make_world(1)
    still = simulate(WORLD, {"b1": LAYOUT["b1"]}, "b1", Strike(0.0, 0.0))
    pieces = still.pieces.copy()
    pieces[:, state.P_BALL], pieces[:, state.P_T1] = 1, alone.duration
    both = replace(
        alone,
        balls=(alone.balls[0], still.balls[0]),
        pieces=np.concatenate([alone.pieces, pieces]),
    )
    assert examine(alone, world.table).faults() == ()
    assert examine(both).overlap > R / 4


def test_energy_that_comes_from_nowhere():
    def change(pieces, _):
        pieces[own(pieces, 1)[-2], state.P_WZ] = 50.0

    assert spoilt(change).gain > 1e-5


def test_above_a_nose_there_is_but_its_edge_and_behind_it_the_rail():
    def lifted(height):
        def change(pieces, _):
            row = own(pieces, 2)[0]
            pieces[row, state.P_KIND], pieces[row, state.P_Z] = state.FLY, height
            pieces[row, state.P_X], pieces[row, state.P_Y] = 1.29, 0.0
            pieces[row, state.P_T1] = pieces[row, state.P_T0] + 1e-3

        return change

    nose = WORLD.table.nose_height
    assert spoilt(lifted(nose + R)).sunk == 0.0
    assert spoilt(lifted(nose + 0.6 * R)).sunk > 1e-4
    assert spoilt(lifted(nose - 1e-3)).sunk > 0.02


def test_a_way_that_is_torn_is_told():
    def change(pieces, _):
        pieces[own(pieces, 1)[-1], state.P_X] += 1e-6

    assert spoilt(change).torn == pytest.approx(1e-6, rel=1e-6)
