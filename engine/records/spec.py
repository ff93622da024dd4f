"""The format of a shot record as pydantic models: which keys there are and of what kind.

One idea: the format's own keys are checked here, the names of a variant in `engine.records.read`.
Invariant: an unknown key is an error; every default is that of format 1.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

Value = bool | int | str
PerPlayer = list[Value]
FASTEST = 100.0
"""No cue moves faster (m/s), several times over."""
FARTHEST = 36_000.0
"""No heading is told by more degrees than these."""
Metres = Annotated[float, Field(ge=-100, le=100)]
Point = Annotated[list[Metres], Field(min_length=2, max_length=2)]
Player = Annotated[int, Field(ge=1)]


class Strict(BaseModel):
    """No other keys, and no turning of one kind of value into another."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)


class BeforeSpec(Strict):
    """The situation before the first shot."""

    shooter: Player = 1
    phase: str | None = None
    scores: list[int] | None = None
    on_table: list[str] | None = None
    positions: dict[str, Point] = {}
    in_hand: str | None = None
    frozen: list[str] = []
    zones: dict[str, str | list[str]] = {}
    state: dict[str, Value | PerPlayer] = {}
    options: list[str] = []


class CallSpec(Strict):
    """What was announced."""

    ball: str | None = None
    pocket: str | None = None
    safety: bool = False
    group: str | None = None


class StrikeSpec(Strict):
    """The stroke as it was played: m/s, degrees, ball radii."""

    speed: Annotated[float, Field(gt=0, le=FASTEST)]
    heading: Annotated[float, Field(ge=-FARTHEST, le=FARTHEST)]
    elevation: Annotated[float, Field(ge=0, lt=90)] = 0.0
    side: Annotated[float, Field(ge=-1, le=1)] = 0.0
    follow: Annotated[float, Field(ge=-1, le=1)] = 0.0


class AfterSpec(Strict):
    """The table at rest, before the referee touches a ball."""

    positions: dict[str, Point] = {}
    spots: dict[str, str] = {}
    frozen: list[str] = []


class ExpectSpec(Strict):
    """What the referee must say; only the keys present are compared."""

    fouls: list[str] | None = None
    points: list[int] | None = None
    spotted: list[str] | None = None
    spotted_in_order: list[str] | None = None
    rerack: int | None = None
    next: Player | None = None
    options: list[str] | None = None
    in_hand: str | None = None
    phase: str | None = None
    over: bool | None = None
    winner: Annotated[int, Field(ge=0)] | None = None
    positions: dict[str, Point] | None = None
    state: dict[str, Value | PerPlayer] | None = None


class ShotSpec(Strict):
    """One shot, or only a choice."""

    choose: str | None = None
    call: CallSpec = CallSpec()
    struck: str | None = None
    place: Point | None = None
    strike: StrikeSpec | None = None
    events: list[str] | None = None
    facts: dict[str, Value] = {}
    after: AfterSpec = AfterSpec()
    expect: ExpectSpec


class RecordSpec(Strict):
    """A whole record."""

    format: Literal[1]
    variant: str
    title: str
    cites: list[str] = []
    settings: dict[str, Value] = {}
    physics: str | None = None
    before: BeforeSpec | None = None
    shot: Annotated[list[ShotSpec], Field(min_length=1)]

    @property
    def by_hand(self) -> bool:
        """Whether nothing of it was played: it tells no stroke."""
        return self.physics is None and all(shot.strike is None for shot in self.shot)
