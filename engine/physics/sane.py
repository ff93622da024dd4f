"""Worlds that cannot be: numbers of cloth, balls, rubber and pockets out of their range.

One idea: what is asked once, when a world is packed, need not be asked in any shot. Invariant: the
first number that is out of range is named with what it belongs to.
"""

from __future__ import annotations

from math import isfinite
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from engine.physics.world import World


def own_or(own: float | None, usual: float) -> float:
    """Return a ball's own number, or the usual one where it has none."""
    return usual if own is None else own


LIVELIEST = 0.95
"""The greatest restitution of a bed: balls on a livelier one would bounce for too long."""


def check_world(world: World) -> None:
    """Raise ValueError for a number that no world can have."""
    cloth = world.cloth
    above = {
        "sliding friction": cloth.sliding,
        "rolling friction": cloth.rolling,
        "spin deceleration": cloth.spin_deceleration,
        "gravity": cloth.gravity,
        "threshold": cloth.threshold,
    }
    for ball in world.balls:
        above[f"radius of {ball.id}"] = ball.radius
        above[f"mass of {ball.id}"] = ball.mass
        above[f"sliding friction of {ball.id}"] = own_or(ball.sliding, cloth.sliding)
        above[f"rolling friction of {ball.id}"] = own_or(ball.rolling, cloth.rolling)
        above[f"spin deceleration of {ball.id}"] = own_or(
            ball.spin_deceleration, cloth.spin_deceleration
        )
    for what, number in above.items():
        if not (isfinite(number) and number > 0.0):
            message = f"{what} must be above zero, not {number}"
            raise ValueError(message)
    if not 0.0 <= cloth.bounce <= LIVELIEST:
        message = f"the restitution of ball on bed lies between 0 and {LIVELIEST}: {cloth.bounce}"
        raise ValueError(message)
    for what, number in _restitutions(world):
        if not 0.0 <= number <= 1.0:
            message = f"the restitution of {what} lies between 0 and 1, not at {number}"
            raise ValueError(message)
    for ball in world.balls:
        if not (isfinite(ball.grip) and ball.grip >= 0.0):
            message = f"the grip of {ball.id} is zero or more, not {ball.grip}"
            raise ValueError(message)
    if not 0.0 <= world.contact.cluster_gap <= 1e-3:
        message = f"a cluster's gap lies between 0 and 1 mm, not at {world.contact.cluster_gap}"
        raise ValueError(message)


def _restitutions(world: World) -> list[tuple[str, float]]:
    table = world.table
    found = [
        ("ball on ball", world.contact.restitution),
        ("ball on cushion", world.rubber.restitution),
    ]
    found += [(str(b.id), b.restitution) for b in world.balls if b.restitution is not None]
    found += [(str(c.id), c.rubber.restitution) for c in table.cushions if c.rubber]
    found += [(f"the jaws of {p.id}", p.rubber.restitution) for p in table.pockets if p.rubber]
    found += [(str(p.id), p.restitution) for p in table.pockets]
    return found + [(str(pin.id), pin.restitution) for pin in table.pins]


__all__ = ["check_world", "own_or"]
