"""Shot records as tests: pytest collects them where it is told that they lie.

One idea: a record file is one test, and what differs is its failure. Opt in by `shot_records` in
pytest's settings or `--shot-records FOLDER`; nothing else changes a run.
Invariant: nothing of a game is loaded before the first record is judged.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from collections.abc import Iterator

    from engine.records.read import Load

LOADER: pytest.StashKey[Load] = pytest.StashKey()


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the option and the setting."""
    about = "a folder, or a file, of shot records to collect"
    group = parser.getgroup("headstring")
    group.addoption("--shot-records", action="append", default=[], metavar="FOLDER", help=about)
    parser.addini("shot_records", f"{about} (one a line)", type="paths", default=[])


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> RecordFile | None:
    """Collect a TOML file that lies where records lie."""
    if file_path.suffix != ".toml":
        return None
    config = parent.config
    given = [config.invocation_params.dir / one for one in config.getoption("--shot-records")]
    folders = [Path(one).resolve() for one in (*given, *config.getini("shot_records"))]
    if not any(file_path.resolve().is_relative_to(folder) for folder in folders):
        return None
    return RecordFile.from_parent(parent, path=file_path)


class RecordFile(pytest.File):
    """A file that holds one record."""

    def collect(self) -> Iterator[RecordItem]:
        """Yield the one test of the file."""
        yield RecordItem.from_parent(self, name=self.path.stem)


class RecordDiffersError(Exception):
    """The referee says something else than a record expects."""


class RecordItem(pytest.Item):
    """A record, judged; one that cannot be used is a failure too."""

    def runtest(self) -> None:
        """Judge the record; raises where something differs."""
        from engine.records.read import read_record  # noqa: PLC0415
        from engine.records.run import run_record  # noqa: PLC0415

        outcome = run_record(read_record(self.path, _loader(self.config)))
        if not outcome.passed:
            lines = [outcome.record.title, *(f"  {one}" for one in outcome.differences)]
            raise RecordDiffersError("\n".join(lines))

    def repr_failure(  # type: ignore[override]
        self, excinfo: pytest.ExceptionInfo[BaseException], style: None = None
    ) -> str:
        """Return what differs, or the mistakes of the file; a bug keeps its traceback."""
        from engine.records.record import RecordError  # noqa: PLC0415
        from rulelang.diagnostics import render  # noqa: PLC0415

        if isinstance(excinfo.value, RecordDiffersError):
            return str(excinfo.value)
        if isinstance(excinfo.value, RecordError):
            return "\n".join(render(one) for one in excinfo.value.diagnostics)
        return str(super().repr_failure(excinfo, style))

    def reportinfo(self) -> tuple[Path, int, str]:
        """Return where the test stands."""
        return self.path, 0, f"record {self.name}"


def _loader(config: pytest.Config) -> Load:
    """Return a way to load variants, each once in a run."""
    loader: Load | None = config.stash.get(LOADER, None)
    if loader is None:
        from functools import cache  # noqa: PLC0415

        from platformdirs import user_cache_path  # noqa: PLC0415

        from engine.variant.load import load_variant  # noqa: PLC0415

        folder = user_cache_path("headstring")
        loader = cache(lambda name: load_variant(name, folder))
        config.stash[LOADER] = loader  # type: ignore[misc]
    return loader
