"""Whole scenes against independent 45-digit computations (groups B, H, I), and clusters (B, J)."""

from math import cos, radians, sin

import numpy as np
import pytest
from physics_cases import (
    ALCIATORE,
    IDEAL,
    REACH,
    R,
    make_world,
    open_world,
    rack,
    throw,
    watch,
)

from engine.physics.events import BallsCollided, CushionHit
from engine.physics.predict import NEVER, closes
from engine.physics.world import Contact, Rubber

STILL = (0.0, 0.0, 0.0)


def play(places, motions, contact=IDEAL, until=np.inf):
    world = open_world(len(places), contact=contact)
    layout = {f"b{i}": place for i, place in enumerate(places)}
    moves = {f"b{i}": motion for i, motion in enumerate(motions)}
    return throw(world, layout, moves, until)


def meetings(trace):
    return [(e.time, {e.ball, e.other}) for e in trace.events() if isinstance(e, BallsCollided)]


@pytest.mark.parametrize(
    ("places", "motion", "contact", "end", "final", "times"),
    [
        (
            [(0, 0), (0.2, 0)],
            ((2.0, 0.0), STILL),
            IDEAL,
            13.8477380397,
            [(0.20059298284, 0), (9.57337607606, 0)],
            [0.07411967253253],
        ),
        (
            [(0, 0), (1, 0.02)],
            ((2.0, 0.0), STILL),
            IDEAL,
            10.3305776707,
            [(2.64920273427, -1.10183041261), (5.37541756382, 1.6545647435)],
            [0.60771374470526],
        ),
        (
            [(0, 0), (1, 0.02)],
            ((2.0, 0.0), STILL),
            ALCIATORE,
            9.810608919,
            [(2.5860187498, -1.04662299813), (4.9440945152, 1.43922966246)],
            [0.60771374470526],
        ),
        (
            [(0, 0), (0.22, 0.07)],
            ((1.2, 0.0), (-45.0, 0.0, 0.0)),
            IDEAL,
            6.23267222366,
            [(1.97359783031, -0.226452763946), (1.00807003461, 1.30010977665)],
            [0.17465681373297],
        ),
        (
            [(0, 0), (0.4, 0.001), (0.8, 0.004)],
            ((3.0, 0.0), STILL),
            ALCIATORE,
            17.4195362512,
            [
                (0.475901949494, -0.0258584900351),
                (0.845166425402, 0.0703904035804),
                (15.3756097816, -0.422337776763),
            ],
            [0.11890988632743, 0.25255140269941],
        ),
        (
            [(0, 0), (0.1, 0)],
            ((1.0, 0.0), (0.0, 140.0, 0.0)),
            IDEAL,
            10.6831319704,
            [(4.02690363049, 0), (5.43405501944, 0)],
            [0.041185947122213, 1.0018681149319],
        ),
    ],
    ids=["stop-shot", "cut", "cut with throw", "masse", "combination", "double hit"],
)
def test_scenes(places, motion, contact, end, final, times):
    trace = play(places, [motion], contact)
    assert [t for t, _ in meetings(trace)] == pytest.approx(times, abs=1e-12)
    assert trace.duration == pytest.approx(end, abs=1e-9)
    for index, place in enumerate(final):
        assert trace.final[f"b{index}"] == pytest.approx(place, abs=1e-9)
    watch(trace, size=(200.0, 200.0))


def test_one_ball_in_a_box():
    box = (2.0 * (1.241425 + REACH), 2.0 * (0.606425 + REACH))
    world = make_world(1, size=box, rubber=Rubber(0.8, 0.0, 0.0, 0.0), ball_cushion="restitution")
    trace = throw(world, {"b0": (0.0, 0.0)}, {"b0": ((3.0, 2.0), STILL)})
    hits = [(e.time, e.cushion) for e in trace.events() if isinstance(e, CushionHit)]
    assert [name for _, name in hits] == ["left", "foot", "right", "head"]
    assert [t for t, _ in hits] == pytest.approx(
        [0.33346811289168, 0.47197479411861, 1.8976841885487, 3.2574749697704], abs=1e-12
    )
    assert trace.duration == pytest.approx(5.94650425016, abs=1e-10)
    assert trace.final["b0"] == pytest.approx((-0.932918712071, -0.135198156951), abs=1e-10)


@pytest.mark.parametrize(
    ("c", "b", "a", "last", "expected"),
    [
        ((0.5, 0.0), (-1.0, 0.0), (0.04905, 0.0), 10.19368, 0.45291157),
        ((0.5, 0.05), (-1.0, 0.0), (0.04905, 0.0), 10.19368, 0.48380194),
        ((0.5, 0.06), (-1.0, 0.0), (0.04905, 0.0), 10.19368, NEVER),
        ((0.5, 0.05715), (-1.0, 0.0), (0.04905, 0.0), 10.19368, NEVER),
        ((0.5, 0.0), (-0.5, 0.0), (0.0, 0.0), 5.09684, 0.8857),
        ((0.05715, 0.0), (0.95, 0.0), (0.0, 0.0), 1.0, NEVER),
        ((0.05715 - 1e-15, 0.0), (0.95, 0.0), (0.0, 0.0), 1.0, NEVER),
        ((0.05715 + 1e-15, 0.0), (0.95, 0.0), (0.0, 0.0), 1.0, NEVER),
        ((0.05715, 0.0), (-0.1, 0.0), (0.0, 0.0), 1.0, 0.0),
        ((0.22, 0.07), (-1.2, 0.0), (0.66930949, -0.71720695), 0.25612751, 0.17465681),
    ],
)
def test_contact_times(c, b, a, last, expected):
    found = closes(*c, *b, *a, 0.05715, last)
    assert found == expected or found == pytest.approx(expected, abs=1e-8)


def test_a_graze_of_a_nanometre_is_found_again_and_again():
    found = {closes(0.5, 0.057149999, -1.0, 0.0, 0.04905, 0.0, 0.05715, 10.0) for _ in range(3)}
    assert len(found) == 1
    assert found.pop() == pytest.approx(0.51289233, abs=1e-7)


def test_natural_roll_does_not_hit_twice():
    trace = play([(0, 0), (0.1, 0)], [((1.0, 0.0), (0.0, 1.0 / R, 0.0))])
    assert len(meetings(trace)) == 1


def test_draw_comes_back():
    trace = play([(0, 0), (2 * R, 0)], [((2.0, 0.0), (0.0, -2.0 / R, 0.0))])
    assert trace.final["b0"][0] == pytest.approx(-1.747488, rel=1e-6)


def test_cradle_with_gaps_is_sequential():
    """A gap of 0.1 mm and more separates the blows: the last ball gets ((1+e)/2)^(n-1)."""
    places = [(k * (2 * R + 2e-4), 0.0) for k in range(5)]
    trace = play([(-0.2, 0.0), *places[1:]], [((1.0, 0.0), STILL)], Contact(0.95, 0.0))
    first = next(e for e in trace.events() if isinstance(e, BallsCollided))
    start = trace.velocities([first.time - 1e-12])[0, 0, 0]
    last = next(t for t, pair in meetings(trace) if "b4" in pair)
    assert trace.velocities([last])[0, 4, 0] == pytest.approx(start * 0.975**4, rel=5e-3)


def velocities_after(places, speed, contact=IDEAL):
    trace = play(places, [((speed, 0.0), STILL)], contact, until=1e-9)
    return trace.velocities([1e-9])[0, :, :2]


def test_two_frozen_balls_struck_at_once():
    a = radians(30.0)
    places = [(0, 0), (2 * R * cos(a), 2 * R * sin(a)), (2 * R * cos(a), -2 * R * sin(a))]
    v = velocities_after(places, 1.0)
    assert v[0] == pytest.approx((-0.2, 0.0), abs=1e-3)
    assert np.hypot(*v[1]) == pytest.approx(0.6928, abs=1e-3)
    assert v[1] == pytest.approx(v[2] * [1, -1], abs=1e-9)


def test_hertz_chains():
    v = velocities_after([(k * 2 * R, 0.0) for k in range(3)], 1.0)[:, 0]
    assert v == pytest.approx((-0.070952354, 0.076403039, 0.99454931), abs=5e-5)
    v = velocities_after([(k * 2 * R, 0.0) for k in range(5)], 1.0)[:, 0]
    assert v == pytest.approx(
        (-0.071085017, -0.030273764, -0.014463629, 0.12704499, 0.98877742), abs=1e-4
    )


def test_frozen_rack_is_symmetric_and_keeps_momentum_and_energy():
    apex = 2 * R
    places = [(0.0, 0.0), *rack(apex)]
    v = velocities_after(places, 8.0)
    assert v.sum(axis=0) == pytest.approx((8.0, 0.0), abs=1e-9)
    assert (v**2).sum() <= 64.0 + 1e-9
    for i, (x, y) in enumerate(places):
        j = next(k for k, (u, w) in enumerate(places) if abs(u - x) + abs(w + y) < 1e-9)
        assert v[i] == pytest.approx(v[j] * [1, -1], abs=1e-9)
    corner = places.index(max(places, key=lambda p: (round(p[0], 6), p[1])))
    assert v[corner] == pytest.approx((3.8942398, 2.2447922), abs=2e-3)
    assert v[0] == pytest.approx((-1.4119099, 0.0), abs=2e-3)


def test_frozen_rack_does_not_know_labels():
    rng = np.random.default_rng(3)
    places = [(0.0, 0.0), *rack(2 * R)]
    order = [0, *(1 + rng.permutation(15))]
    straight = velocities_after(places, 6.0, ALCIATORE)
    shuffled = velocities_after([places[k] for k in order], 6.0, ALCIATORE)
    assert shuffled == pytest.approx(straight[order], abs=1e-9)


def test_pressed_together_they_do_not_sink_in():
    trace = play([(0, 0), (2 * R, 0)], [((0.0, 0.0), (0.0, 10.0, 0.0))], ALCIATORE)
    assert watch(trace, size=(200.0, 200.0)) >= -1e-9
    assert len(trace.log) < 1000
    apart = trace.positions([0.02])[0, 1, 0] - trace.positions([0.02])[0, 0, 0]
    assert apart - 2 * R < 1e-6
