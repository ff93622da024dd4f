"""From the models of the format to a record of values.

One idea: the situation and the shots are built apart, with one lookup of names between them; a
record with one mistake is no record.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from engine.records.before import start_of
from engine.records.names import Names
from engine.records.record import Record
from engine.records.shots import step_of

if TYPE_CHECKING:
    from pathlib import Path

    from engine.records.spec import RecordSpec
    from engine.variant.report import Report
    from engine.variant.variant import Variant


def build_record(
    path: Path, spec: RecordSpec, variant: Variant, report: Report, seed: int = 0
) -> Record | None:
    """Return the record, None where it has mistakes; those go to the report.

    `seed` decides what is by lot in the shots of a whole match.
    """
    names = Names(variant, report, by_hand=spec.by_hand)
    start = start_of(names, spec, seed)
    steps = tuple(
        step_of(names, shot, ("shot", index), start.players) for index, shot in enumerate(spec.shot)
    )
    if report.diagnostics:
        return None
    return Record(
        path, spec.title, tuple(spec.cites), variant, start, steps, spec.physics, report.root
    )
