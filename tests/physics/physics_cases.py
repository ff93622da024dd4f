"""Worlds, thrown balls and the monitor that the physics tests share."""

from math import inf, radians, sqrt

import numpy as np

from engine.physics import state
from engine.physics.simulate import Simulation
from engine.physics.world import Ball, Cloth, Contact, Cue, Models, Rubber, Strike, World
from engine.table.build import PocketCut, build_table

R, M, NOSE = 0.028575, 0.170097, 0.03629025
REACH = R * sqrt(1.0 - 0.27**2)
CORNER = PocketCut(0.1159, radians(142), 0.04, 0.003, 0.062)
SIDE = PocketCut(0.1286, radians(104), 0.005, 0.003, 0.0645)
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
    """The monitor: no overlap, no gain of energy, all inside, no NaN; returns the worst gap."""
    knots = np.unique(trace.pieces[:, [state.P_T0, state.P_T1]])
    times = np.unique(np.concatenate([knots, np.linspace(0.0, trace.duration, 400)]))
    places = trace.positions(times)
    assert np.isfinite(places).all()
    energy = trace.kinetic_energy(times)
    assert np.diff(energy).max(initial=-1.0) <= 1e-12
    gone = places[..., 2] < 0.0
    worst = inf
    for i in range(places.shape[1]):
        for j in range(i):
            apart = np.hypot(*(places[:, i, :2] - places[:, j, :2]).T)
            here = ~(gone[:, i] | gone[:, j])
            need = 2.0 * sqrt(trace.balls[i].radius * trace.balls[j].radius)
            worst = min(worst, (apart[here] - need).min(initial=inf))
    assert worst >= -1e-9
    limit_x, limit_y = size[0] / 2.0, size[1] / 2.0
    slack = 0.12 if pockets else 1e-9 - reach
    here = ~gone
    assert (np.abs(places[..., 0])[here] <= limit_x + slack).all()
    assert (np.abs(places[..., 1])[here] <= limit_y + slack).all()
    return worst


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
