"""A recorded shot as the program holds it.

One idea: a record is a start situation, shots, and for each what the referee must say.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    from engine.game.shot import Shot
    from engine.game.situation import Situation
    from engine.records.spec import ExpectSpec
    from engine.variant.source import Node
    from engine.variant.variant import Variant
    from rulelang.diagnostics import Diagnostic


@dataclass(frozen=True, slots=True)
class Step:
    """One shot of a record and what is expected of the referee."""

    shot: Shot
    expect: ExpectSpec


@dataclass(frozen=True, slots=True)
class Record:
    """A record, checked against its variant; `physics` is the hash it was played with.

    `begun` tells of the later games of a journal: who breaks, by the number of shots before.
    """

    path: Path
    title: str
    cites: tuple[str, ...]
    variant: Variant
    start: Situation
    steps: tuple[Step, ...]
    physics: str | None
    source: Node
    begun: Mapping[int, int] = field(default_factory=dict)


class RecordError(Exception):
    """A record that cannot be used; carries every mistake in it."""

    def __init__(self, diagnostics: tuple[Diagnostic, ...]) -> None:
        super().__init__("; ".join(one.message for one in diagnostics))
        self.diagnostics = diagnostics
