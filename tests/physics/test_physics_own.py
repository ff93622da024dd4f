"""What one ball, cushion or pocket has of its own, and models that the loop asks others for."""

from dataclasses import replace
from math import inf

import numpy as np
import pytest
from physics_cases import IDEAL, NOSE, REACH, M, R, make_world, open_world, rack, throw

from engine.physics import state
from engine.physics.pack import packed
from engine.physics.simulate import Simulation, simulate
from engine.physics.world import Ball, Contact, Rubber, Strike
from engine.table.furniture import Curve, Cushion

G = 9.81


def with_first(world, **own):
    """The world with a first ball that has something of its own."""
    return replace(world, balls=(replace(world.balls[0], **own), *world.balls[1:]))


def with_cushion(world, name, **own):
    table = world.table
    cushions = tuple(replace(c, **own) if c.id == name else c for c in table.cushions)
    return replace(world, table=replace(table, cushions=cushions))


def rolling(speed):
    return {"b0": ((speed, 0.0), (0.0, speed / R, 0.0))}


def test_a_ball_rolls_as_far_as_its_own_friction_lets_it():
    world = with_first(open_world(2), rolling=0.02)
    layout = {"b0": (0.0, 0.0), "b1": (0.0, 5.0)}
    motions = rolling(1.0) | {"b1": ((1.0, 0.0), (0.0, 1.0 / R, 0.0))}
    final = throw(world, layout, motions).final
    assert final["b0"][0] == pytest.approx(1.0 / (2.0 * 0.02 * G), abs=1e-12)
    assert final["b1"][0] == pytest.approx(1.0 / (2.0 * 0.01 * G), abs=1e-12)


def test_a_ball_slides_with_its_own_friction():
    world = with_first(open_world(1), sliding=0.4)
    trace = throw(world, {"b0": (0.0, 0.0)}, {"b0": ((1.4, 0.0), (0.0, 0.0, 0.0))})
    assert trace.log[0, state.E_TIME] == pytest.approx(2.0 * 1.4 / (7.0 * 0.4 * G), abs=1e-12)


def test_a_ball_spins_out_at_its_own_rate():
    world = with_first(open_world(1), spin_deceleration=20.0)
    trace = throw(world, {"b0": (0.0, 0.0)}, {"b0": ((0.0, 0.0), (0.0, 0.0, 30.0))})
    assert trace.duration == pytest.approx(1.5, abs=1e-12)
    assert trace.spins([0.5])[0, 0, 2] == pytest.approx(20.0, abs=1e-12)


@pytest.mark.parametrize("swapped", [False, True])
def test_two_balls_have_the_mean_of_their_restitutions(swapped):
    world = with_first(open_world(2, contact=Contact(0.9, 0.0)), restitution=0.5)
    place = -1.0 if swapped else 1.0
    moving, other = ("b1", "b0") if swapped else ("b0", "b1")
    layout = {moving: (0.0, 0.0), other: (place * 2.0 * R, 0.0)}
    trace = throw(world, layout, {moving: ((place, 0.0), (0.0, 0.0, 0.0))}, 1e-9)
    v = trace.velocities([1e-9])[0, :, 0]
    assert abs(v[0] - v[1]) == pytest.approx(0.7, abs=1e-7)


def test_a_ball_with_more_grip_throws_more():
    def aside(grip):
        world = with_first(open_world(2, contact=Contact(1.0, 0.02)), grip=grip)
        layout = {"b0": (0.0, 0.0), "b1": (2.0 * R * np.cos(0.7), 2.0 * R * np.sin(0.7))}
        trace = throw(world, layout, {"b0": ((1.0, 0.0), (0.0, 0.0, 0.0))}, 1e-9)
        vx, vy = trace.velocities([1e-9])[0, 1, :2]
        return vy * np.cos(0.7) - vx * np.sin(0.7)

    assert aside(3.0) == pytest.approx(2.0 * aside(1.0), rel=1e-6)


def test_a_heavier_and_larger_ball_keeps_going():
    heavy = Ball("b0", 0.03015, 0.2)
    world = open_world(2, contact=IDEAL)
    world = replace(world, balls=(heavy, world.balls[1]))
    distance = 2.0 * np.sqrt(heavy.radius * R)
    trace = throw(
        world,
        {"b0": (0.0, 0.0), "b1": (distance, 0.0)},
        {"b0": ((1.0, 0.0), (0.0, 0.0, 0.0))},
        1e-9,
    )
    v = trace.velocities([1e-9])[0, :, 0]
    assert v[0] == pytest.approx((0.2 - M) / (0.2 + M), abs=1e-6)
    assert v[1] == pytest.approx(2.0 * 0.2 / (0.2 + M), abs=1e-6)


def test_a_dead_cushion_gives_back_less_than_the_others():
    world = make_world(1, rubber=Rubber(0.9, 0.0, 0.0, 0.0), ball_cushion="restitution")
    world = with_cushion(world, "foot", rubber=Rubber(0.4, 0.0, 0.0, 0.0))
    ratios = []
    for way in (1.0, -1.0):
        trace = throw(world, {"b0": (way * 1.2, 0.0)}, {"b0": ((way, 0.0), (0.0, way / R, 0.0))})
        hit = next(event for event in trace.events() if type(event).__name__ == "CushionHit")
        before, after = trace.velocities([hit.time - 1e-9, hit.time + 1e-9])[:, 0, 0]
        ratios.append(-after / before)
    assert ratios == pytest.approx([0.4, 0.9], abs=1e-6)


def test_a_cushion_may_have_a_model_of_its_own():
    world = make_world(1, ball_cushion="mathavan-2010")
    noses = packed(with_cushion(world, "head", model="restitution")).noses
    assert sorted(set(noses[:, state.N_MODEL])) == [state.RESTITUTION, state.MATHAVAN]


def test_an_upright_post_is_met_at_the_equator():
    world = make_world(1)
    post = Cushion("post", (Curve((0.5, 0.0), 0.05, 0.0, -2.0 * np.pi),))
    met = []
    for upright in (False, True):
        table = replace(
            world.table, cushions=(*world.table.cushions, replace(post, upright=upright))
        )
        trace = throw(replace(world, table=table), {"b0": (0.0, 0.0)}, rolling(1.0))
        hit = next(event for event in trace.events() if type(event).__name__ == "CushionHit")
        assert hit.cushion == "post"
        met.append(0.5 - trace.positions([hit.time])[0, 0, 0])
    assert met == pytest.approx([0.05 + REACH, 0.05 + R], abs=1e-9)


@pytest.mark.parametrize(
    "own",
    [{"sliding": 0.0}, {"rolling": -0.1}, {"restitution": 1.5}, {"grip": -1.0}, {"grip": inf}],
)
def test_what_a_ball_cannot_have_of_its_own(own):
    with pytest.raises(ValueError, match=r"b0|restitution"):
        simulate(with_first(make_world(1), **own), {"b0": (0.0, 0.0)}, "b0", Strike(1.0, 0.0))


RARE = [
    {"ball_ball": "mathavan-2014"},
    {"ball_cushion": "stronge"},
    {"cluster": "simultaneous"},
    {"cluster": "sequential"},
    {"pocket": "rim-lip", "pockets": True},
]


def rare_shot(models):
    world = make_world(6, **models)
    places = [(-0.6, 0.003), *rack(0.3, rows=2), (0.9, 0.5), (1.0, -0.4)]
    layout = dict(zip((f"b{i}" for i in range(6)), places, strict=True))
    return world, layout, "b0", Strike(5.0, 0.0, 0.0, 0.1, 0.2)


@pytest.mark.parametrize("models", RARE, ids=lambda one: next(iter(one.values())))
def test_what_is_asked_changes_no_bit_by_chunks(models):
    world, layout, ball, strike = rare_shot(models)
    whole = simulate(world, layout, ball, strike)
    shot = Simulation(world, layout, ball, strike)
    for tick in range(1, 600):
        shot.advance(tick / 60.0)
    shot.advance(inf)
    assert shot.trace().hash() == whole.hash()
    assert len(whole.log) > 10


@pytest.mark.parametrize("models", RARE[:2], ids=lambda one: next(iter(one.values())))
def test_solvers_with_a_step_refuse_what_they_do_not_know(models):
    world, layout, ball, strike = rare_shot(models | {"solver": "corrective"})
    with pytest.raises(ValueError, match="does not know"):
        simulate(world, layout, ball, strike)


def test_the_height_of_the_nose_is_for_noses_alone():
    assert NOSE > R  # so that the two ways of meeting a post differ
