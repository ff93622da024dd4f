"""Records from anywhere are run and told about: the rules tester's command.

One idea: each path becomes one Result; printing, JSON and the exit status are made from those.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from engine.records.read import read_record
from engine.records.record import RecordError
from engine.records.run import Outcome, run_record
from rulelang.diagnostics import Diagnostic, render

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from engine.records.read import Load

PASSED, DIFFERENT, UNUSABLE = 0, 1, 2


@dataclass(frozen=True, slots=True)
class Result:
    """What came of one file: an outcome, or the mistakes that make it unusable."""

    path: Path
    outcome: Outcome | None
    mistakes: tuple[Diagnostic, ...] = ()

    @property
    def status(self) -> int:
        """Return 0 for a pass, 1 for differences, 2 for an unusable file."""
        if self.outcome is None:
            return UNUSABLE
        return PASSED if self.outcome.passed else DIFFERENT

    def as_json(self) -> dict[str, object]:
        """Return the result as the JSON list has it."""
        if self.outcome is None:
            told = "\n".join(render(one) for one in self.mistakes)
            return {"path": str(self.path), "passed": False, "differences": [], "error": told}
        return {
            "path": str(self.path),
            "passed": self.outcome.passed,
            "differences": [
                {"shot": one.shot, "key": one.key, "expected": one.expected, "got": one.got}
                for one in self.outcome.differences
            ],
            "replayed": self.outcome.replayed,
        }


def find_records(paths: Iterable[Path]) -> Iterator[Path | Diagnostic]:
    """Yield every record file named or below a folder named; a Diagnostic for what is not there."""
    for path in paths:
        if path.is_dir():
            inside = sorted(path.rglob("*.toml"))
            yield from inside
            if not inside:
                yield Diagnostic("T001", str(path), 1, 1, "there is no record in this folder")
        elif path.exists():
            yield path
        else:
            yield Diagnostic("T001", str(path), 1, 1, "there is no such file or folder")


def run_paths(paths: Iterable[Path], load: Load) -> Iterator[Result]:
    """Yield the result of every record found, in order; `load` gives a variant by its stem."""
    for found in find_records(paths):
        if isinstance(found, Diagnostic):
            yield Result(Path(found.file), None, (found,))
            continue
        try:
            yield Result(found, run_record(read_record(found, load)))
        except RecordError as error:
            yield Result(found, None, error.diagnostics)


def status_of(results: Iterable[Result]) -> int:
    """Return the exit status of a run: the worst of its results."""
    return max((result.status for result in results), default=UNUSABLE)
