"""Cushions and jaws whose rubber differs from the table's.

One idea: what is written of one cushion overlays its own rubber, or the table's; a pocket's name
stands for its jaws. Invariant: the rest of the table stays as it is.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from engine.physics.world import MODEL_NAMES
from engine.variant.report import nearest

if TYPE_CHECKING:
    from engine.table.furniture import Rubber, Table
    from engine.variant.report import Report
    from engine.variant.table_spec import CushionShape, TableShape


def cover(table: Table, shape: TableShape, rubber: Rubber, report: Report) -> Table:
    """Return the table with the rubber and models of single cushions and pockets' jaws."""
    said = shape.cushions
    known = [str(one.id) for one in table.cushions] + [str(one.id) for one in table.pockets]
    for name, own in said.items():
        if name not in known:
            report.unknown("V302", ("table", "cushions", name), "cushion", name, known)
        _check_model(name, own, report)
    return replace(
        table,
        cushions=tuple(
            replace(one, rubber=_own(one.rubber or rubber, said[one.id]), model=said[one.id].model)
            if one.id in said
            else one
            for one in table.cushions
        ),
        pockets=tuple(
            replace(
                one,
                rubber=_own(one.rubber or rubber, said[one.id]),
                jaw_model=said[one.id].model,
            )
            if one.id in said
            else one
            for one in table.pockets
        ),
    )


def _own(base: Rubber, said: CushionShape) -> Rubber:
    written = {key: value for key, value in said.said().items() if key != "model"}
    return replace(base, **written)


def _check_model(name: str, own: CushionShape, report: Report) -> None:
    known = MODEL_NAMES["ball_cushion"]
    if own.model is not None and own.model not in known:
        message = f"there is no ball_cushion model called `{own.model}`"
        path = ("table", "cushions", name, "model")
        report.add("V106", path, message, nearest(own.model, known))


__all__ = ["cover"]
