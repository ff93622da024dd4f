"""A game as loaded: a frozen value made from one TOML file and one rule script.

Invariant: a Variant never changes after load and holds nothing that was not checked.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rulelang.frozen import value

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    from engine.physics.world import World
    from engine.table.furniture import BallId, PinId, Point, SpotId
    from rulelang.program import Program

Colour = tuple[int, int, int]
"""Red, green, blue, 0 to 255."""

Value = bool | int | str
"""What a setting, a tracked value or a referee's fact can be."""


@value
class BallKind:
    """A ball as the game and the eye know it; its body is in the World.

    `pattern` is "plain", "stripe" or "dots"; `label` is what is painted on it, often empty.
    `spot` is the ball's own spot where the table gives it one.
    """

    id: BallId
    colour: Colour
    pattern: str = "plain"
    label: str = ""
    value: int = 0
    groups: tuple[str, ...] = ()
    spot: SpotId | None = None


@value
class PinKind:
    """A pin as the eye knows it; its body stands on the Table."""

    id: PinId
    colour: Colour


@value
class Lot:
    """Places (m) that are filled by lot: one ball from each of `pools`, in random order.

    There are as many pools as places; a ball that is already placed is not drawn again.
    """

    places: tuple[Point, ...]
    pools: tuple[tuple[BallId, ...], ...]


@value
class Rack:
    """How balls lie at the start: fixed places, and places filled by lot, one Lot after another.

    `fixed` maps a ball to its place (m).
    """

    fixed: Mapping[BallId, Point]
    drawn: tuple[Lot, ...] = ()


@value
class Setting:
    """A house rule that a script may read and a player may set.

    `least` and `most` bound a number, both included.
    """

    name: str
    default: Value
    choices: tuple[Value, ...] = ()
    about: str = ""
    least: int | None = None
    most: int | None = None


@value
class Look:
    """The table's colours, and whether sights are let into the rails."""

    cloth: Colour
    rail: Colour
    pocket: Colour = (12, 12, 12)
    sights: bool = True


@value
class Variant:
    """One game, ready to be played.

    `cue_balls` has one ball that serves every player, or one ball per player in order.
    """

    name: str
    title: str
    rulebook: str
    path: Path
    script_path: Path
    world: World
    balls: tuple[BallKind, ...]
    cue_balls: tuple[BallId, ...]
    rack: Rack
    players: tuple[int, int, int]
    """Fewest, most and usual number of players."""
    settings: Mapping[str, Setting]
    look: Look
    program: Program
    pins: tuple[PinKind, ...] = ()
    same_time: float = 1e-9
    """Hits of one ball that lie no further apart are one event, s."""
