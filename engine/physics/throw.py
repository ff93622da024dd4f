"""Balls that already move when the clock starts: a shot without a cue.

One idea: experiments and published figures begin with velocities and spins, not with a strike; so
a shot is begun with a strike of no force and the motions are put in its place. Invariant: from
there on it is a shot like any other.
"""

from __future__ import annotations

from math import inf
from typing import TYPE_CHECKING

from engine.physics import state
from engine.physics.simulate import Simulation
from engine.physics.world import Strike

if TYPE_CHECKING:
    from collections.abc import Mapping

    from engine.physics.strike import Motion
    from engine.physics.trace import Trace
    from engine.physics.world import Layout, World
    from engine.table.furniture import BallId


def throw_balls(
    world: World, layout: Layout, motions: Mapping[BallId, Motion], until: float = inf
) -> Trace:
    """Return the shot that begins with these velocities (m/s) and spins (rad/s).

    A ball with a height or a rise begins in the air, whatever the model of flight. Balls without a
    motion lie still; `until` (s) cuts the shot off. Raises ValueError as `simulate` does, and where
    a ball moves that is not on the table.
    """
    strangers = sorted(set(motions) - set(layout))
    if strangers or not layout:
        message = f"no ball can be thrown that is not on the table: {', '.join(strangers)}"
        raise ValueError(message)
    shot = Simulation(world, layout, next(iter(layout)), Strike(0.0, 0.0))
    balls, rows, kinds = shot._balls, shot._rows, shot._kinds  # noqa: SLF001  the next room
    for index, ball in enumerate(balls):
        if (motion := motions.get(ball.id)) is not None:
            rows[index, [state.VX, state.VY]] = motion.velocity
            rows[index, [state.WX, state.WY, state.WZ]] = motion.spin
            rows[index, state.Z] += motion.height
            rows[index, state.VZ] = motion.rise
            kinds[index] = state.FLY if motion.height > 0.0 or motion.rise > 0.0 else state.SLIDE
    shot.advance(until)
    return shot.trace()


__all__ = ["throw_balls"]
