"""Practice: balls are put anywhere on the bed, layouts are kept, a stroke is played again.

One idea: an arranged table is the start of a match of its own, so whatever is tried leaves the
match before it as it was, in its journal. Invariant: no ball is ever put where it cannot lie.
"""

from __future__ import annotations

import math
from dataclasses import replace
from math import cos, pi, sin
from typing import TYPE_CHECKING

import tomli_w

from engine.game.match import Match
from engine.game.placing import refuse_spot
from engine.game.referee import announce, on_the_bed
from engine.game.spotting import lift, place_ball
from engine.variant.source import Node, read_source

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    from engine.game.situation import Situation
    from engine.table.furniture import BallId, Point
    from engine.variant.variant import Variant

RINGS, TURNS = 60, 48
"""How many rings about a wish, and places on each, are looked at for room."""


TOUCHING = -1e-6
"""The air (m) that balls of a kept layout need: they may touch, to what a file holds."""


class LayoutError(ValueError):
    """A layout that cannot be laid; the message says why."""


def with_ball(variant: Variant, situation: Situation, ball: BallId, wish: Point) -> Situation:
    """Return the situation with a ball at `wish` (m) or the nearest place where it can lie."""
    lying = {other: at for other, at in situation.rest.positions.items() if other != ball}
    for at in _about(wish):
        if refuse_spot(variant, lying, ball, at) is None:
            rest = place_ball(situation.rest, ball, at)
            return replace(situation, rest=rest, on_table=situation.on_table | {ball})
    return situation


def _about(wish: Point) -> list[Point]:
    places = [wish]
    for ring in range(1, RINGS):
        reach = 0.005 * ring
        turns = (2.0 * pi * k / TURNS for k in range(TURNS))
        places += [(wish[0] + reach * cos(a), wish[1] + reach * sin(a)) for a in turns]
    return [(round(x, 6), round(y, 6)) for x, y in places]


def without_ball(situation: Situation, ball: BallId) -> Situation:
    """Return the situation with a ball taken off the table."""
    gone = frozenset({ball})
    rest = lift(situation.rest, gone)
    return replace(situation, rest=rest, on_table=situation.on_table - gone)


def arranged_match(match: Match, situation: Situation) -> Match:
    """Return the match that begins with an arranged situation."""
    bare = replace(situation, offers=(), judged=None, winner=None, match_over=False, shots=0)
    begun = announce(match.variant, on_the_bed(match.variant, replace(bare, seed=match.seed + 1)))
    return Match(match.variant, match.seed + 1, match.settings, begun, names=match.names)


def save_layout(path: Path, variant: Variant, situation: Situation) -> None:
    """Write where the balls lie; raises OSError."""
    positions = {ball: list(at) for ball, at in situation.rest.positions.items()}
    path.parent.mkdir(parents=True, exist_ok=True)
    text = tomli_w.dumps({"variant": variant.name, "positions": positions})
    path.write_text(text, encoding="utf-8")


def load_layout(path: Path, variant: Variant, situation: Situation) -> Situation:
    """Return the situation with the balls as a file has them; raises LayoutError."""
    source = read_source(path, path.parent)
    if not isinstance(source, Node):
        raise LayoutError(f"{path.name} cannot be read: {source[0].message}")
    table = source.plain()
    known = {kind.id for kind in variant.balls}
    found: dict[BallId, Point] = {}
    for ball, at in _positions(path, table if isinstance(table, dict) else {}).items():
        if ball not in known:
            raise LayoutError(f"{path.name}: {variant.title} has no ball {ball}")
        found[ball] = _point(path, ball, at)
    for ball in known & situation.on_table:
        situation = without_ball(situation, ball)
    for ball, at in found.items():
        refused = refuse_spot(variant, situation.rest.positions, ball, at, TOUCHING)
        if refused is not None:
            raise LayoutError(f"{path.name}: {ball}: {refused.reason}; {refused.mend}")
        rest = place_ball(situation.rest, ball, at)
        situation = replace(situation, rest=rest, on_table=situation.on_table | {ball})
    return situation


def _positions(path: Path, table: Mapping[str, object]) -> dict[BallId, object]:
    positions = table.get("positions")
    if not isinstance(positions, dict) or not positions:
        raise LayoutError(f"{path.name} has no positions: write ball = [x, y] under [positions]")
    return positions


def _point(path: Path, ball: str, at: object) -> Point:
    match at:
        case [int() | float() as x, int() | float() as y] if math.isfinite(x) and math.isfinite(y):
            return float(x), float(y)
    raise LayoutError(f"{path.name}: {ball}: a place is [x, y] in metres, not {at!r}")


__all__ = [
    "LayoutError",
    "arranged_match",
    "load_layout",
    "save_layout",
    "with_ball",
    "without_ball",
]
