"""The shipped tables return a ball as measured ones do."""

import numpy as np
import pytest

from engine.physics.events import CushionHit, RollingBegan
from engine.physics.simulate import simulate
from engine.physics.world import Strike
from engine.variant.load import load_variant


def push(name, speed, *, start, follow=0.0):
    """A first ball that leaves the tip with `speed` along the table, `start` lengths from head."""
    world = load_variant(name).world
    ball, cue, table = world.balls[0], world.cue, world.table
    gain = (1.0 + cue.tip_restitution) / (1.0 + ball.mass / cue.mass + 2.5 * follow**2)
    layout = {ball.id: ((start - 0.5) * table.length, 0.1 * table.width)}
    return table, simulate(world, layout, ball.id, Strike(speed / gain, 0.0, 0.0, 0.0, follow))


def returned(name, speed):
    """Speed before a square hit, just after it over that, and over that once it rolls again."""
    _, trace = push(name, speed, start=0.88, follow=0.4)
    hit = next(e.time for e in trace.events() if isinstance(e, CushionHit))
    rolls = next(e.time for e in trace.events() if isinstance(e, RollingBegan) and e.time > hit)
    before, after, later = trace.velocities([hit - 1e-9, hit + 1e-9, rolls + 1e-9])[:, 0, 0]
    return before, -after / before, -later / before


@pytest.mark.parametrize("speed", [0.55, 0.8, 1.2, 1.78])
def test_a_heated_table_returns_a_rolling_ball_as_tracked(speed):
    measured = np.interp(speed, [0.50, 0.74, 1.16, 1.78], [0.598, 0.583, 0.566, 0.556])
    before, _, later = returned("three_cushion", speed)
    assert before == pytest.approx(speed, abs=0.1)
    assert later == pytest.approx(measured, abs=0.015)


@pytest.mark.parametrize("speed", [1.0, 2.0, 3.0])
def test_a_twelve_foot_table_returns_a_rolling_ball_as_measured(speed):
    before, after, _ = returned("snooker", speed)
    measured = (-0.0877 * before**2 + 1.131 * before - 0.0953) / before
    assert after == pytest.approx(measured, abs=0.04)


def test_a_nine_foot_table_loses_more_from_faster_balls():
    ratios = [returned("eight_ball", speed)[1] for speed in (1.0, 2.0, 4.0)]
    assert ratios == pytest.approx([0.95, 0.92, 0.86], abs=0.01)


@pytest.mark.parametrize(
    ("name", "low", "high"),
    [("eight_ball", 4.0, 4.6), ("snooker", 3.3, 4.6), ("three_cushion", 4.2, 5.0)],
)
def test_a_firm_stroke_runs_three_to_five_lengths(name, low, high):
    table, trace = push(name, 8.0, start=0.25)
    places = trace.positions(np.linspace(0.0, trace.duration, 4000))[:, 0, :2]
    way = np.hypot(*np.diff(places, axis=0).T).sum()
    assert low <= way / table.length <= high
