"""A record file becomes a Record, or the list of every mistake in it.

One idea: the file is read as a tree that knows its lines; its shape is checked by pydantic, then
every name by the variant's own vocabulary. No record is half used.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from pydantic import ValidationError

from engine.records.blocks import games_begun, seed_of, standing
from engine.records.build import build_record
from engine.records.record import Record, RecordError
from engine.records.spec import RecordSpec
from engine.variant.library import VariantError
from engine.variant.report import Report
from engine.variant.source import Node, parse_source, read_text
from engine.variant.variant import Variant

if TYPE_CHECKING:
    from pathlib import Path


Load = Callable[[str], Variant]


def read_record(path: Path, load: Load) -> Record:
    """Return the record in a file; `load` gives a variant by its stem.

    Raises RecordError with every mistake, each with file, line and column.
    """
    text = read_text(path)
    if not isinstance(text, str):
        raise RecordError(tuple(text))
    return read_record_text(text, path, load)


def read_record_text(text: str, path: Path, load: Load) -> Record:
    """Return the record in a text; mistakes are told as being in `path`.

    In a journal, shots that were taken back or are incomplete do not count.
    """
    spec, report = _shaped(text, path)
    variant = _variant(spec, load, report)
    if variant is not None:
        record = build_record(path, spec, variant, report, seed_of(text))
        if record is not None:
            return replace(record, begun=dict(games_begun(text)))
    raise RecordError(tuple(report.diagnostics))


def shape_of(path: Path) -> tuple[RecordSpec, Node, int]:
    """Return a record file as written, names unchecked: its keys, its tree, its seed.

    Raises RecordError for a file that has not the shape of a record.
    """
    text = read_text(path)
    if not isinstance(text, str):
        raise RecordError(tuple(text))
    spec, report = _shaped(text, path)
    return spec, report.root, seed_of(text)


def _shaped(text: str, path: Path) -> tuple[RecordSpec, Report]:
    source = parse_source(standing(text), path, path.parent)
    if not isinstance(source, Node):
        raise RecordError(tuple(source))
    report = Report(source, shape=RecordSpec)
    try:
        return RecordSpec.model_validate(source.plain()), report
    except ValidationError as error:
        report.add_shape_errors(error, ())
        raise RecordError(tuple(report.diagnostics)) from None


def _variant(spec: RecordSpec, load: Load, report: Report) -> Variant | None:
    try:
        return load(spec.variant)
    except VariantError as error:
        report.add("T201", ("variant",), str(error).splitlines()[0])
        return None
