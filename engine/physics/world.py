"""What a shot is played with: balls, cloth and models on a table, and the strike.

One idea: everything the solvers need is one frozen value. SI units and radians.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING

from engine.table.furniture import BallId, Point, Rubber

if TYPE_CHECKING:
    from engine.table.furniture import Table

Layout = Mapping[BallId, Point]
"""Where the balls in play lie (m); a ball that is not named is not on the table."""


@dataclass(frozen=True, slots=True)
class Ball:
    """A ball's body: radius in m, mass in kg; and what it has of its own, None for the world's.

    Two balls that meet have the mean of both restitutions; `grip` is by how much a ball rubs more
    than others against balls, of which two also have the mean.
    """

    id: BallId
    radius: float
    mass: float
    sliding: float | None = None
    rolling: float | None = None
    spin_deceleration: float | None = None
    restitution: float | None = None
    grip: float = 1.0


@dataclass(frozen=True, slots=True)
class Cloth:
    """Coefficients of sliding and rolling friction, and the loss of side spin in rad/s^2.

    `threshold` (m/s) belongs to the two-speed model alone: rolling friction below, sliding
    friction above. `bounce` is the restitution of ball and slate.
    """

    sliding: float
    rolling: float
    spin_deceleration: float
    threshold: float = 1.5
    gravity: float = 9.81
    bounce: float = 0.5


@dataclass(frozen=True, slots=True)
class Contact:
    """Ball on ball: restitution, and friction `floor + rise * exp(-decay * slip)`.

    Restitution falls with the speed v of approach: `e - slope * max(0, v - knee)`, never below 0.
    Balls whose gaps are no wider than `cluster_gap` (m) take part in one blow, as if they touched;
    where it is wider than usual, the time in which a ball crosses its gap counts.
    """

    restitution: float
    friction_floor: float
    friction_rise: float = 0.0
    friction_decay: float = 0.0
    cluster_gap: float = 2e-6
    restitution_slope: float = 0.0
    restitution_knee: float = 0.0


@dataclass(frozen=True, slots=True)
class Cue:
    """The cue: mass (kg), tip restitution and friction, ball mass over the cue's end mass."""

    mass: float
    tip_restitution: float
    tip_friction: float
    end_mass_ratio: float


@dataclass(frozen=True, slots=True)
class Models:
    """The physical models by name."""

    solver: str = "stepwise"
    motion: str = "slide-roll"
    ball_ball: str = "frictional"
    ball_cushion: str = "han-2005"
    strike: str = "point"
    pocket: str = "drop-edge"
    flight: str = "ballistic"
    cluster: str = "hertz"


MODEL_NAMES: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "solver": ("stepwise", "corrective", "preemptive"),
        "motion": ("slide-roll", "two-speed"),
        "ball_ball": ("frictional", "elastic", "mathavan-2014"),
        "ball_cushion": ("han-2005", "mathavan-2010", "restitution", "stronge"),
        "strike": ("point",),
        "pocket": ("drop-edge", "rim-lip"),
        "flight": ("ballistic", "none"),
        "cluster": ("hertz", "simultaneous", "sequential"),
    }
)
"""The names that each field of Models may have."""


@dataclass(frozen=True, slots=True)
class World:
    """All that stays the same from shot to shot."""

    table: Table
    balls: tuple[Ball, ...]
    cloth: Cloth
    contact: Contact
    rubber: Rubber
    cue: Cue
    models: Models


@dataclass(frozen=True, slots=True)
class Strike:
    """The cue's impulse: speed in m/s, angles in rad, tip offsets in ball radii.

    `heading` counts counter-clockwise from +x; `side` is right of the ball's centre as the
    player sees it, `follow` above it.
    """

    speed: float
    heading: float
    elevation: float = 0.0
    side: float = 0.0
    follow: float = 0.0


__all__ = [
    "MODEL_NAMES",
    "Ball",
    "Cloth",
    "Contact",
    "Cue",
    "Layout",
    "Models",
    "Rubber",
    "Strike",
    "World",
]
