"""Random shots on the shipped tables, balls touching balls and cushions among them."""

import numpy as np
import pytest
from physics_cases import grounded, random_strike, watch

from engine.physics.events import BallLeftTable
from engine.physics.pack import nose_reach, packed
from engine.physics.simulate import simulate
from engine.variant.load import load_variant

GAPS = (0.0, 1e-9, 1e-6, 1e-4)


def crowded(rng, world, reach):
    """Some balls of the set, many of which touch another, or a long cushion."""
    table, radius = world.table, world.balls[0].radius
    limit = np.array([table.length / 2 - reach, table.width / 2 - reach])
    mouths = np.array([pocket.centre for pocket in table.pockets]).reshape(-1, 2)
    places = []
    while len(places) < int(rng.integers(2, len(world.balls) + 1)):
        place = rng.uniform(-1.0, 1.0, 2) * limit
        if places and rng.random() < 0.4:
            angle, gap = rng.uniform(0.0, 6.28), GAPS[int(rng.integers(4))]
            turn = np.array([np.cos(angle), np.sin(angle)])
            place = places[int(rng.integers(len(places)))] + (2 * radius + gap) * turn
        elif rng.random() < 0.1:
            place[1] = limit[1]
        near = np.array(places).reshape(-1, 2) - place
        free = (np.hypot(*near.T) >= 2 * radius).all()
        clear = (np.hypot(*(mouths - place).T) > 2.5 * radius).all()
        if free and clear and (np.abs(place) <= limit).all():
            places.append(place)
    pairs = zip(world.balls, places, strict=False)
    return {ball.id: (float(x), float(y)) for ball, (x, y) in pairs}


@pytest.mark.parametrize("name", ["eight_ball", "snooker", "three_cushion"])
@pytest.mark.parametrize("seed", range(25))
def test_random_shots(name, seed):
    world = grounded(load_variant(name).world)
    table = world.table
    reach = nose_reach(world.balls[0].radius, table.nose_height)
    rng = np.random.default_rng(seed)
    layout = crowded(rng, world, reach)
    trace = simulate(world, layout, world.balls[0].id, random_strike(rng))
    watch(trace, reach, (table.length, table.width), pockets=bool(table.pockets))
    assert not [e for e in trace.events() if isinstance(e, BallLeftTable)]
    assert len(trace.final) + len(trace.pocketed) == len(layout)
    assert len(trace.log) < 3000


def test_a_world_is_packed_once():
    one, two = load_variant("eight_ball").world, load_variant("snooker").world
    assert packed(one) is packed(one)
    assert packed(two).world is two
    assert packed(one).world is one
