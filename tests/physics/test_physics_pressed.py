"""Two balls that rub on each other and on the cloth, against a fine integration and bounds."""

from dataclasses import replace
from math import atan2, cos, degrees, hypot, radians, sin

import numpy as np
import pytest
from physics_cases import make_world, open_world, throw

from engine.physics import state
from engine.physics.pack import pack_world
from engine.physics.rare import part
from engine.physics.world import Ball, Cloth, Contact

R, M = 0.02625, 0.1406
SNOOKER = Contact(0.89, 0.05)
TABLE = {
    (1.539, 33.83): (0.914, 0.831, 31.93, 32.20),
    (1.032, 26.36): (0.520, 0.599, 32.45, 25.07),
    (1.364, 40.52): (0.917, 0.676, 29.91, 38.62),
    (1.731, 46.50): (1.280, 0.780, 27.32, 44.38),
    (0.942, 18.05): (0.383, 0.579, 29.47, 17.15),
}
"""Mathavan, Jackson & Parkin 2014, tables 1 and 2: speeds (m/s) and angles (degrees) after slip."""


def world_of(contact=SNOOKER, sliding=0.21):
    world = make_world(2, contact=contact, cloth=Cloth(sliding, 0.01, 10.0))
    balls = tuple(replace(ball, radius=R, mass=M) for ball in world.balls)
    return replace(world, balls=balls, models=replace(world.models, ball_ball="mathavan-2014"))


def rows_of(world, v, w, angle, second=((0.0, 0.0), (0.0, 0.0, 0.0))):
    rows = np.zeros((2, state.BALL_WIDTH))
    for row, ball in zip(rows, world.balls, strict=True):
        row[state.RADIUS], row[state.MASS] = ball.radius, ball.mass
        row[state.SLIDING] = world.cloth.sliding
    rows[0, [state.VX, state.VY]], rows[0, [state.WX, state.WY, state.WZ]] = v, w
    rows[1, [state.VX, state.VY]], rows[1, [state.WX, state.WY, state.WZ]] = second
    reach = 2.0 * (world.balls[0].radius * world.balls[1].radius) ** 0.5
    rows[1, [state.X, state.Y]] = reach * cos(angle), reach * sin(angle)
    return rows


def rolling_at_last(row):
    r = row[state.RADIUS]
    vx = (5.0 * row[state.VX] + 2.0 * r * row[state.WY]) / 7.0
    return vx, (5.0 * row[state.VY] - 2.0 * r * row[state.WX]) / 7.0


@pytest.mark.parametrize(("shot", "printed"), TABLE.items())
def test_printed_tables(shot, printed):
    speed, cut = shot
    world = world_of()
    rows = rows_of(world, (speed, 0.0), (0.0, speed / R, 0.0), -radians(cut))
    part(rows[0], rows[1], pack_world(world))
    one, two = map(rolling_at_last, rows)
    got = hypot(*one), hypot(*two), degrees(atan2(one[1], one[0])), -degrees(atan2(two[1], two[0]))
    assert got == pytest.approx(printed, rel=4e-3)


def stepped(rows, e, mu, bed, steps=200_000):
    """The same by Euler's method in many steps, written in plain vectors."""
    (x1, y1), (x2, y2) = rows[:, [state.X, state.Y]]
    n = np.array([x2 - x1, y2 - y1, 0.0]) / hypot(x2 - x1, y2 - y1)
    up = np.array([0.0, 0.0, 1.0])
    v = np.zeros((2, 3))
    v[:, :2] = rows[:, [state.VX, state.VY]]
    w = rows[:, [state.WX, state.WY, state.WZ]].copy()
    r, m = rows[:, state.RADIUS], rows[:, state.MASS]
    near = (v[0] - v[1]) @ n
    dp, work, goal = 2.0 * near / (1.0 / m).sum() / steps, 0.0, None
    while True:
        near = (v[0] - v[1]) @ n
        if goal is None and near <= 0.0:
            goal = (1.0 - e * e) * work
        if goal is not None and work <= goal:
            return v, w
        work += near * dp
        slip = v[0] - v[1] + r[0] * np.cross(w[0], n) + r[1] * np.cross(w[1], n)
        slip -= (slip @ n) * n
        size = np.linalg.norm(slip)
        rub = -mu * dp * slip / size if size > 1e-6 else np.zeros(3)
        for k, sign in ((0, 1.0), (1, -1.0)):
            force = sign * (rub - dp * n)
            press = max(0.0, -force[2])
            force[2] = 0.0
            slide = v[k] - r[k] * np.cross(w[k], up)
            slide[2] = 0.0
            far = np.linalg.norm(slide)
            bed_push = -bed * press * slide / far if far > 1e-9 else np.zeros(3)
            v[k] += (force + bed_push) / m[k]
            turn = np.cross(sign * r[k] * n, sign * rub) + np.cross(-r[k] * up, bed_push)
            w[k] += 2.5 * turn / (m[k] * r[k] ** 2)


@pytest.mark.parametrize("seed", range(4))
def test_any_motion_of_both_balls(seed):
    rng = np.random.default_rng(seed)
    e, mu, bed = rng.uniform(0.6, 1.0), rng.uniform(0.05, 0.3), rng.uniform(0.1, 0.4)
    world = world_of(Contact(e, mu), bed)
    world = replace(world, balls=(world.balls[0], Ball("b1", 0.03, 0.21)))
    angle = rng.uniform(-1.0, 1.0)
    rows = rows_of(
        world,
        (2.0, 0.3),
        rng.uniform(-80.0, 80.0, 3),
        angle,
        ((-0.2, 0.1), rng.uniform(-30.0, 30.0, 3)),
    )
    v, w = stepped(rows, e, mu, bed, 20_000)
    part(rows[0], rows[1], pack_world(world))
    assert rows[:, [state.VX, state.VY]] == pytest.approx(v[:, :2], abs=2e-3)
    assert rows[:, state.RADIUS, None] * rows[:, [state.WX, state.WY, state.WZ]] == pytest.approx(
        rows[:, state.RADIUS, None] * w, abs=4e-3
    )


def energy(rows):
    v2 = (rows[:, [state.VX, state.VY]] ** 2).sum(1)
    w2 = (rows[:, [state.WX, state.WY, state.WZ]] ** 2).sum(1)
    return float((rows[:, state.MASS] * (0.5 * v2 + 0.2 * rows[:, state.RADIUS] ** 2 * w2)).sum())


def test_no_energy_is_gained_and_momentum_changes_by_the_bed_alone():
    rng = np.random.default_rng(5)
    for _ in range(400):
        mu, e = rng.uniform(0.0, 1.0), rng.choice([0.0, 0.9, 1.0])
        world = world_of(Contact(e, mu), rng.uniform(0.05, 0.9))
        rows = rows_of(
            world,
            (rng.uniform(0.01, 8.0), 0.0),
            rng.uniform(-250.0, 250.0, 3),
            rng.uniform(-1.5, 1.5),
        )
        before, old = energy(rows), rows.copy()
        part(rows[0], rows[1], pack_world(world))
        assert energy(rows) <= before
        change = (M * (rows - old)[:, [state.VX, state.VY]]).sum(0)
        push = M * np.abs((rows - old)[:, [state.VX, state.VY]]).max()
        assert np.hypot(*change) <= 2.0 * mu * world.cloth.sliding * push + 1e-12


def test_swapped_balls_change_no_bit():
    world = world_of(Contact(0.95, 0.01, 0.1, 1.1))
    rows = rows_of(world, (2.0, 0.1), (3.0, -60.0, 20.0), 0.4)
    other = rows.copy()
    part(rows[0], rows[1], pack_world(world))
    part(other[1], other[0], pack_world(world))
    assert (rows == other).all()


def test_without_friction_it_is_the_elastic_model():
    world = world_of(Contact(0.9, 0.0))
    rows = rows_of(world, (2.0, 0.0), (0.0, 50.0, 9.0), 0.0)
    part(rows[0], rows[1], pack_world(world))
    assert rows[:, state.VX] == pytest.approx([0.1, 1.9], abs=1e-12)
    assert rows[0, state.WY] == 50.0


def test_friction_by_speed_and_constant_differ_in_a_shot():
    ends = [
        throw(
            open_world(2, contact=contact, ball_ball="mathavan-2014"),
            {"b0": (0.0, 0.0), "b1": (0.3, 0.03)},
            {"b0": ((3.0, 0.0), (0.0, 0.0, 0.0))},
        ).final["b1"]
        for contact in (Contact(0.95, 0.06), Contact(0.95, 0.00995, 0.108, 1.088))
    ]
    assert hypot(ends[0][0] - ends[1][0], ends[0][1] - ends[1][1]) > 0.01
