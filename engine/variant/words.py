"""Every name that scripts and records of a variant may use.

One idea: the vocabulary is read off what is on the table, so nothing can be named that is
not there.
"""

from __future__ import annotations

from types import MappingProxyType
from typing import TYPE_CHECKING

from rulelang.vocabulary import BallName, Vocabulary

if TYPE_CHECKING:
    from engine.variant.assemble import Draft
    from engine.variant.variant import Variant


def vocabulary_of(variant: Variant | Draft) -> Vocabulary:
    """Return the names of a variant's balls, furniture and settings."""
    table = variant.world.table
    settings = {name: setting.default for name, setting in variant.settings.items()}
    return Vocabulary(
        balls=tuple(
            BallName(ball.id, ball.value, ball.groups, ball.spot) for ball in variant.balls
        ),
        cue_balls=tuple(variant.cue_balls),
        pockets=tuple(pocket.id for pocket in table.pockets),
        pocket_values=MappingProxyType({one.id: one.value for one in table.pockets if one.value}),
        cushions=tuple(cushion.id for cushion in table.cushions),
        lines=tuple(table.lines),
        zones=tuple(table.zones),
        spots=tuple(table.spots),
        pins=tuple(pin.id for pin in table.pins),
        settings=MappingProxyType(settings),
        players=variant.players[:2],
    )
