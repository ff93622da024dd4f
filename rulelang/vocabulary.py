"""The names a host hands to the language: what lies on this table, and what may be set.

One idea: the language knows the words of cue sports and learns every name of a thing from here.
"""

from __future__ import annotations

from dataclasses import field
from types import MappingProxyType
from typing import TYPE_CHECKING

from rulelang.frozen import value

if TYPE_CHECKING:
    from collections.abc import Mapping

Value = bool | int | str
"""What a setting, a tracked value or a fact can be; a name is a str."""

Tracked = Value | tuple[Value, ...]
"""A tracked value: one, or one per player."""


@value
class BallName:
    """A ball: its value in points, the groups it belongs to, its own spot."""

    name: str
    value: int = 0
    groups: tuple[str, ...] = ()
    spot: str | None = None


@value
class Vocabulary:
    """Every name of one variant; `cue_balls` has one for all players or one per player."""

    balls: tuple[BallName, ...]
    cue_balls: tuple[str, ...]
    pockets: tuple[str, ...] = ()
    cushions: tuple[str, ...] = ()
    lines: tuple[str, ...] = ()
    zones: tuple[str, ...] = ()
    spots: tuple[str, ...] = ()
    pins: tuple[str, ...] = ()
    settings: Mapping[str, Value] = field(default_factory=lambda: MappingProxyType({}))
    players: tuple[int, int] = (2, 2)
    pocket_values: Mapping[str, int] = field(default_factory=lambda: MappingProxyType({}))
