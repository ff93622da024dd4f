"""Closes the hole between the figures of a pocket and whether a ball goes down there."""

from __future__ import annotations

from math import atan2, hypot

import pytest

from engine.physics.events import BallPocketed
from engine.physics.simulate import simulate
from engine.physics.world import Strike
from engine.table.furniture import BallId
from engine.variant.load import read_draft

TABLES = {"eight_ball": 0.0125, "snooker": 0.006}
"""How far off the middle (m) a ball rolled straight in may come and still drop clean."""


def rolled(world, pocket, aside, speed):
    """Return where a cue ball rolled at a pocket's middle from 0.6 m away ends."""
    (ax, ay), (bx, by) = pocket.mouth
    middle = (ax + bx) / 2, (ay + by) / 2
    way = pocket.centre[0] - middle[0], pocket.centre[1] - middle[1]
    size = hypot(*way)
    way = way[0] / size, way[1] / size
    start = middle[0] - 0.6 * way[0] - aside * way[1], middle[1] - 0.6 * way[1] + aside * way[0]
    ball = BallId("cue")
    trace = simulate(world, {ball: start}, ball, Strike(speed, atan2(way[1], way[0])))
    return [event.pocket for event in trace.events() if isinstance(event, BallPocketed)]


@pytest.mark.parametrize("speed", [0.8, 2.0])
@pytest.mark.parametrize("share", [-1, 0, 1])
@pytest.mark.parametrize("name", TABLES)
def test_a_ball_rolled_into_a_mouth_drops(name, share, speed):
    world = read_draft(name)[0].world
    for pocket in world.table.pockets:
        assert rolled(world, pocket, share * TABLES[name], speed) == [pocket.id]


@pytest.mark.parametrize("name", TABLES)
def test_a_ball_rolled_at_a_tip_stays_out(name):
    world = read_draft(name)[0].world
    for pocket in world.table.pockets:
        aside = hypot(
            pocket.mouth[0][0] - pocket.mouth[1][0], pocket.mouth[0][1] - pocket.mouth[1][1]
        )
        assert rolled(world, pocket, 0.75 * aside, 0.8) == []
