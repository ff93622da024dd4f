"""Worlds, thrown balls and the monitor that the physics tests share."""

from dataclasses import replace
from math import inf, radians, sqrt

import numpy as np

from engine.physics import state
from engine.physics.monitor import examine
from engine.physics.simulate import Simulation
from engine.physics.world import Ball, Cloth, Contact, Cue, Models, Rubber, Strike, World
from engine.table.build import PocketCut, build_table

R, M, NOSE = 0.028575, 0.170097, 0.03629025
REACH = R * sqrt(1.0 - 0.27**2)
CORNER = PocketCut(0.1159, radians(142), 0.04, 0.003, 0.062)
SIDE = PocketCut(0.1286, radians(104), 0.005, 0.003, 0.0645)
ROUND = (
    PocketCut(0.083, radians(135), 0.03, 0.102, 0.05),
    PocketCut(0.087, radians(90), 0.0, 0.064, 0.05),
)
TIGHT = (
    PocketCut(0.0725, radians(135), 0.03, 0.012, 0.045),
    PocketCut(0.0825, radians(100), 0.01, 0.008, 0.05),
)
ALCIATORE = Contact(0.95, 0.009951, 0.108, 1.088)
IDEAL = Contact(1.0, 0.0)


def make_world(
    n=2,
    *,
    pockets=False,
    size=(2.54, 1.27),
    contact=ALCIATORE,
    rubber=None,
    cloth=None,
    cuts=(CORNER, SIDE),
    nose=NOSE,
    ids=None,
    **models,
):
    corner, side = cuts if pockets else (None, None)
    names = ids or [f"b{i}" for i in range(n)]
    return World(
        table=build_table(*size, nose, corner, side, 0.12),
        balls=tuple(Ball(name, R, M) for name in names),
        cloth=cloth or Cloth(0.2, 0.01, 10.0),
        contact=contact,
        rubber=rubber or Rubber(0.97, 0.035, 1.0, 0.14),
        cue=Cue(0.5386, 0.73, 0.6, 25.0),
        models=Models(**models),
    )


def grounded(world):
    """The same world with all balls kept on the bed."""
    return replace(world, models=replace(world.models, flight="none"))


def open_world(n=2, **options):
    """A bed so large that nothing reaches a nose."""
    return make_world(n, size=(200.0, 200.0), **options)


def throw(world, layout, motions, until=inf):
    """A shot that starts with given velocities and spins instead of a strike."""
    first = next(iter(layout))
    shot = Simulation(world, layout, first, Strike(0.0, 0.0))
    for index, ball in enumerate(shot._balls):
        v, w = motions.get(ball.id, ((0.0, 0.0), (0.0, 0.0, 0.0)))
        shot._rows[index, [state.VX, state.VY]] = v
        shot._rows[index, [state.WX, state.WY, state.WZ]] = w
        shot._kinds[index] = state.SLIDE
    shot.advance(until)
    return shot.trace()


def rack(apex, gap=0.0, rows=5):
    """Centres of a triangle with its apex at x = apex."""
    pitch = R + gap / 2.0
    return [
        (apex + row * sqrt(3.0) * pitch, (row - 2 * k) * pitch)
        for row in range(rows)
        for k in range(row + 1)
    ]


def watch(trace, reach=REACH, size=(2.54, 1.27), *, pockets=False):
    """The monitor finds nothing and all are inside; returns the smallest gap of two balls."""
    found = examine(trace)
    assert found.faults() == ()
    assert found.gap >= -1e-9
    times = np.unique(np.concatenate([trace.pieces[:, state.P_T0], [trace.duration]]))
    places = trace.positions(np.concatenate([times, np.linspace(0.0, trace.duration, 400)]))
    limit_x, limit_y = size[0] / 2.0, size[1] / 2.0
    slack = 0.12 if pockets else 1e-9 - reach
    here = places[..., 2] > 0.0
    assert (np.abs(places[..., 0])[here] <= limit_x + slack).all()
    assert (np.abs(places[..., 1])[here] <= limit_y + slack).all()
    return found.gap


def random_layout(rng, n, ids=None):
    layout = {}
    while len(layout) < n:
        x, y = rng.uniform(-1.2, 1.2), rng.uniform(-0.58, 0.58)
        if all(np.hypot(x - u, y - v) > 2 * R for u, v in layout.values()):
            layout[ids[len(layout)] if ids else f"b{len(layout)}"] = (x, y)
    return layout


def random_strike(rng, fastest=9.0):
    return Strike(
        rng.uniform(0.1, fastest),
        rng.uniform(0.0, 6.28),
        rng.choice([0.0, 0.0, 0.3, 1.0]),
        rng.uniform(-0.35, 0.35),
        rng.uniform(-0.35, 0.35),
    )
