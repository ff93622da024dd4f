"""Friction and restitution as they are, to be looked at and changed while practising.

One idea: each number of the world has a row with its step and its bounds; a world with another
number begins a match of its own, so that a match is played on one cloth. Invariant: a number never
leaves the bounds in which the physics is right.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from engine.app.arranging import arranged_match
from engine.app.before import begin
from engine.app.session import SHOWING, Session

if TYPE_CHECKING:
    from engine.app.units import Units
    from engine.physics.world import World

PLAIN_SPEED = 2.0
"""Speed (m/s) of the rolling ball by which the cloth is told."""


@dataclass(frozen=True, slots=True)
class Dial:
    """A number of the world: its part, its field, what it is called, its step and bounds."""

    part: str
    field: str
    about: str
    step: float
    least: float
    most: float
    unit: str = ""

    def read(self, world: World) -> float:
        """Return the number as the world has it."""
        return float(getattr(getattr(world, self.part), self.field))

    def turned(self, world: World, by: int) -> World:
        """Return the world with the number so many steps higher, within its bounds."""
        wanted = round(round(self.read(world) / self.step + by) * self.step, 6)
        return self.set(world, min(max(wanted, self.least), self.most))

    def set(self, world: World, number: float) -> World:
        """Return the world with another number."""
        part = replace(getattr(world, self.part), **{self.field: number})
        changed: World = replace(world, **{self.part: part})
        return changed

    def words(self, world: World) -> str:
        """Return the number in words."""
        return f"{self.read(world):.4g}{self.unit}"


DIALS = (
    Dial("cloth", "sliding", "Cloth: sliding friction", 0.01, 0.05, 0.5),
    Dial("cloth", "rolling", "Cloth: rolling friction", 0.0005, 0.002, 0.05),
    Dial("cloth", "spin_deceleration", "Cloth: loss of side spin", 0.5, 1.0, 40.0, " rad/s2"),
    Dial("contact", "restitution", "Ball on ball: restitution", 0.01, 0.7, 1.0),
    Dial("contact", "friction_floor", "Ball on ball: friction", 0.005, 0.0, 0.3),
    Dial("rubber", "restitution", "Cushion: restitution", 0.01, 0.4, 1.0),
    Dial("rubber", "friction", "Cushion: friction", 0.01, 0.0, 0.6),
)


def roll_words(world: World, units: Units) -> str:
    """Return how far a ball rolls on this cloth, v^2 / (2 mu g), and past how many lengths."""
    far = PLAIN_SPEED**2 / (2.0 * world.cloth.rolling * world.cloth.gravity)
    lengths = far / world.table.length
    speed = units.speed(PLAIN_SPEED)
    return f"a ball that rolls at {speed} goes {units.length(far)}, {lengths:.1f} tables long"


def on_world(session: Session, world: World) -> Session:
    """Return the session of the practice match that begins on a changed world."""
    if world == session.variant.world or session.mode in SHOWING:
        return session
    variant = replace(session.variant, world=world)
    begun = arranged_match(replace(session.match, variant=variant), session.match.situation)
    after = begin(begun, session.stroke, session.aid)
    return replace(after, note="practice on this cloth, from here on")
