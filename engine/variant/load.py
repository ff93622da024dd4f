"""The way from a name to a checked game: load, check, list.

One idea: loading and checking are one walk; `check_variant` returns the mistakes, `load_variant`
raises them all at once. Importing this module reads nothing and starts nothing.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from pydantic import ValidationError

from engine.variant.assemble import Draft, assemble
from engine.variant.library import open_variant, resolve
from engine.variant.report import Report
from engine.variant.source import Node
from engine.variant.spec import VariantSpec

if TYPE_CHECKING:
    from pathlib import Path

    from rulelang.diagnostics import Diagnostic


def read_draft(name_or_path: str | Path) -> tuple[Draft | None, list[Diagnostic]]:
    """Return a variant without its rules, and every mistake in its TOML files.

    Raises VariantError where the variant cannot be found at all.
    """
    draft, _, diagnostics = _read(resolve(name_or_path))
    return draft, diagnostics


def _read(path: Path) -> tuple[Draft | None, Node | None, list[Diagnostic]]:
    opened = open_variant(path)
    if opened.node is None:
        return None, None, opened.diagnostics
    report = Report(opened.node, opened.diagnostics)
    try:
        spec = VariantSpec.model_validate(opened.node.plain())
    except ValidationError as error:
        report.add_shape_errors(error, opened.broken)
        return None, opened.node, report.diagnostics
    return assemble(spec, report), opened.node, report.diagnostics
