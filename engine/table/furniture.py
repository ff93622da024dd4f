"""The furniture of a table: what a ball can touch, fall into, stand on or be judged by.

One idea: a table is a value, a closed chain of noses with pockets and marks, in metres and
radians, origin at the centre of the bed, +x to the foot, +y to the left seen from the head.
Invariant: nothing here moves and nothing here knows a game.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from types import MappingProxyType
from typing import TYPE_CHECKING, NewType

if TYPE_CHECKING:
    from collections.abc import Mapping

Point = tuple[float, float]
BallId = NewType("BallId", str)
CushionId = NewType("CushionId", str)
PocketId = NewType("PocketId", str)
SpotId = NewType("SpotId", str)
LineId = NewType("LineId", str)
ZoneId = NewType("ZoneId", str)
PinId = NewType("PinId", str)


@dataclass(frozen=True, slots=True)
class Straight:
    """A straight nose from `start` to `end` (m); the bed lies on its left."""

    start: Point
    end: Point


@dataclass(frozen=True, slots=True)
class Curve:
    """A round nose: an arc about `centre` (m) from angle `start` through `sweep` (rad).

    The bed lies on the left of the way from start to end: outside the circle when `sweep` is
    negative (a jaw's shoulder), inside it when `sweep` is positive (a round table).
    """

    centre: Point
    radius: float
    start: float
    sweep: float


Shape = Straight | Curve


@dataclass(frozen=True, slots=True)
class Rubber:
    """Ball on cushion: restitution by the speed into it, friction by the angle of incidence.

    With u = max(0, v_n - knee), e = base - slope u - bend u^2, no less than `restitution_least`;
    friction is `friction - friction_slope * angle`, the angle (rad) counted from the normal.
    `frequency_ratio` belongs to `stronge` alone: of its springs across and along, so that their
    stiffnesses have the ratio of its square to 3.5.
    """

    restitution: float
    restitution_slope: float
    restitution_knee: float
    friction: float
    restitution_bend: float = 0.0
    restitution_least: float = 0.0
    friction_slope: float = 0.0
    frequency_ratio: float = 1.7


@dataclass(frozen=True, slots=True)
class Cushion:
    """One named cushion: the chain of noses that records call by one name.

    `rubber` and the name of a `model` are its own where they differ from the table's. An `upright`
    one is a body with an upright side, such as a post, which a ball meets at its equator.
    """

    id: CushionId
    shapes: tuple[Shape, ...]
    rubber: Rubber | None = None
    model: str | None = None
    upright: bool = False


@dataclass(frozen=True, slots=True)
class Jaw:
    """One side of a pocket's mouth: shoulder and facing, from the cushion into the pocket."""

    pocket: PocketId
    shapes: tuple[Shape, ...]


@dataclass(frozen=True, slots=True)
class Pocket:
    """A pocket: a ball whose centre comes over the circle (`centre`, `radius`, m) drops.

    `rubber` and `jaw_model` are those of its jaws and `model` its own where they differ from the
    table's; `lip` is
    the radius (m) of the round edge over which a ball falls, `rim` the height (m) of what stands
    behind the drop, `restitution` and `friction` those of what it meets there. `value` is what the
    game counts for a ball in it.
    """

    id: PocketId
    centre: Point
    radius: float
    mouth: tuple[Point, Point]
    rubber: Rubber | None = None
    model: str | None = None
    lip: float = 0.0
    rim: float = 0.0
    restitution: float = 0.2
    friction: float = 0.2
    value: int = 0
    jaw_model: str | None = None


@dataclass(frozen=True, slots=True)
class Pin:
    """A turned body that stands on the bed at `at` (m) until something fells it.

    `profile` has heights and radii (m) from the foot up, straight in between; `mass` in kg;
    `restitution` is that of a blow, `friction` that of the fallen pin on the cloth; `threshold`
    (N s) is the blow that fells it, None where its shape says so.
    """

    id: PinId
    at: Point
    profile: tuple[tuple[float, float], ...]
    mass: float
    restitution: float = 0.5
    friction: float = 0.3
    threshold: float | None = None

    @property
    def height(self) -> float:
        """Return how tall it is, m."""
        return self.profile[-1][0]

    @property
    def foot(self) -> float:
        """Return the radius on which it stands, m."""
        return self.profile[0][1]

    @property
    def belly(self) -> float:
        """Return its greatest radius, m."""
        return max(radius for _, radius in self.profile)


@dataclass(frozen=True, slots=True)
class Line:
    """A line across the bed from `start` to `end` (m), drawn on the cloth or only thought of."""

    start: Point
    end: Point
    drawn: bool = True


@dataclass(frozen=True, slots=True)
class HalfPlane:
    """The points p with (p - `point`) . `normal` > 0, or >= 0 where `closed`."""

    point: Point
    normal: Point
    closed: bool


@dataclass(frozen=True, slots=True)
class Disc:
    """The points within `radius` (m) of `centre`, its rim included where `closed`."""

    centre: Point
    radius: float
    closed: bool


@dataclass(frozen=True, slots=True)
class Area:
    """The bed's points that lie in every one of `parts`; with no parts, the whole bed."""

    parts: tuple[HalfPlane | Disc, ...] = ()


@dataclass(frozen=True, slots=True)
class Places:
    """A zone that is no area but some single points (m), such as two starting spots."""

    points: tuple[Point, ...]


@dataclass(frozen=True, slots=True)
class Figure:
    """The bed's points less than `margin` (m) away from a convex figure, or just so if `closed`.

    `corners` go round the figure counter-clockwise.
    """

    corners: tuple[Point, ...]
    margin: float
    closed: bool


@dataclass(frozen=True, slots=True)
class Opposite:
    """Whichever of several areas holds none of the balls that may be hit first.

    Where it is not asked with a situation, it is all of them.
    """

    areas: tuple[Area, ...]


Zone = Area | Places | Figure | Opposite


@dataclass(frozen=True, slots=True)
class Table:
    """One table as it stands in the room; lengths in metres.

    `outline` is the closed chain of noses round the bed, counter-clockwise, as if no pocket were
    cut into it; where it is empty, the bed is the rectangle of `length` and `width`. These are the
    sizes of the box about the bed, whose middle is the origin.
    """

    length: float
    width: float
    nose_height: float
    cushions: tuple[Cushion, ...]
    jaws: tuple[Jaw, ...]
    pockets: tuple[Pocket, ...]
    spots: Mapping[SpotId, Point] = field(default_factory=lambda: MappingProxyType({}))
    lines: Mapping[LineId, Line] = field(default_factory=lambda: MappingProxyType({}))
    zones: Mapping[ZoneId, Zone] = field(default_factory=lambda: MappingProxyType({}))
    rail_width: float = 0.12
    outline: tuple[Shape, ...] = ()
    pins: tuple[Pin, ...] = ()
