"""Every name that scripts and records of a variant may use.

One idea: the vocabulary is read off what is on the table, so nothing can be named that is
not there.
"""

from __future__ import annotations

from types import MappingProxyType
from typing import TYPE_CHECKING, Protocol

from rulelang.vocabulary import BallName, Vocabulary

if TYPE_CHECKING:
    from collections.abc import Mapping

    from engine.physics.world import World
    from engine.table.furniture import BallId
    from engine.variant.variant import BallKind, Setting


class Furnished(Protocol):
    """A variant, with its rules or still without."""

    @property
    def world(self) -> World: ...
    @property
    def balls(self) -> tuple[BallKind, ...]: ...
    @property
    def cue_balls(self) -> tuple[BallId, ...]: ...
    @property
    def players(self) -> tuple[int, int, int]: ...
    @property
    def settings(self) -> Mapping[str, Setting]: ...


def vocabulary_of(variant: Furnished) -> Vocabulary:
    """Return the names of a variant's balls, furniture and settings."""
    table = variant.world.table
    settings = {name: setting.default for name, setting in variant.settings.items()}
    return Vocabulary(
        balls=tuple(
            BallName(ball.id, ball.value, ball.groups, ball.spot) for ball in variant.balls
        ),
        cue_balls=tuple(variant.cue_balls),
        pockets=tuple(pocket.id for pocket in table.pockets),
        cushions=tuple(cushion.id for cushion in table.cushions),
        lines=tuple(table.lines),
        zones=tuple(table.zones),
        spots=tuple(table.spots),
        settings=MappingProxyType(settings),
        players=variant.players[:2],
    )
