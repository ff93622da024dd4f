"""The records of each game, ready to be judged again and again.

One idea: a record is read once; what a wrong rule may change in it, its start and its verdicts,
is made anew each time. Invariant: a Case without a probe's wrong is judged as `golden` judges it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from engine.game.referee import look_ahead
from engine.game.shot import NO_CALL
from engine.records.before import start_of
from engine.records.golden import find_records
from engine.records.names import Names
from engine.records.read import read_record, shape_of
from engine.records.record import Record, RecordError
from engine.records.run import Outcome, run_record
from engine.records.spec import RecordSpec
from engine.variant.load import load_variant
from engine.variant.report import Report
from rulelang.diagnostics import Diagnostic
from rulelang.probe import Probe

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from engine.variant.variant import Variant

RECORDS = Path("tests/golden")
"""Where records lie by game, in a checkout."""


@dataclass(frozen=True, slots=True)
class Case:
    """One record of a game: as written, and as built with nothing wrong.

    `opening` are the sites that its start passes, `judging` those that its shots pass, `fired`
    those of both that held, fired or were taken.
    """

    record: Record
    spec: RecordSpec
    seed: int
    opening: frozenset[int]
    judging: frozenset[int]
    fired: frozenset[int]
    unfired: frozenset[int]
    passed: bool
    unasked: int


@dataclass(frozen=True, slots=True)
class Game:
    """A variant with its probe, and what its records touch."""

    variant: Variant
    probe: Probe
    cases: tuple[Case, ...]


def records_by_game(
    given: Iterable[Path], folder: Path = RECORDS
) -> tuple[dict[str, list[Path]], list[Diagnostic]]:
    """Return the record files by the variant they name, and what cannot be used.

    What is given are files, folders, or games whose records lie in a folder of their name below
    `folder`; nothing stands for the whole folder.
    """
    places = [
        path if path.exists() or not (folder / path).is_dir() else folder / path for path in given
    ]
    found: dict[str, list[Path]] = {}
    trouble: list[Diagnostic] = []
    for one in find_records(places or [folder]):
        if isinstance(one, Diagnostic):
            trouble.append(one)
            continue
        try:
            found.setdefault(shape_of(one)[0].variant, []).append(one)
        except RecordError as error:
            trouble += error.diagnostics
    return found, trouble


def load_game(name: str, paths: Sequence[Path], cache: Path | None = None) -> Game:
    """Return a game with all its records judged once.

    Raises VariantError for a variant, RecordError for a record that cannot be used.
    """
    probe = Probe()
    variant = load_variant(name, cache, probe)
    return Game(variant, probe, tuple(_case(path, variant, probe) for path in paths))


def _case(path: Path, variant: Variant, probe: Probe) -> Case:
    spec, _, seed = shape_of(path)
    probe.forget()
    record = read_record(path, lambda _: variant)
    opening = probe.touched()
    outcome = run_record(record, replay=False)
    fired = frozenset(n for n, count in enumerate(probe.yes) if count)
    unfired = frozenset(n for n, count in enumerate(probe.no) if count)
    return Case(
        record, spec, seed, opening, probe.touched(), fired, unfired, outcome.passed,
        _unasked(outcome),
    )  # fmt: skip


def is_caught(game: Game, case: Case, site: int) -> bool:
    """Tell whether a record that passes fails once a site is made wrong."""
    game.probe.wrong = site
    try:
        record = case.record
        if site in case.opening:
            report = Report(record.source, shape=RecordSpec)
            names = Names(game.variant, report, by_hand=case.spec.by_hand)
            start = start_of(names, case.spec, case.seed)
            if report.diagnostics:
                return True
            record = replace(record, start=start)
        outcome = run_record(record, replay=False)
        return not outcome.passed or _unasked(outcome) > case.unasked
    except Exception:  # noqa: BLE001 - whatever a wrong rule leads to, it was noticed
        return True
    finally:
        game.probe.wrong = None


def _unasked(outcome: Outcome) -> int:
    """Return how much is called in a record's shots that no rule asks for or allows."""
    found = 0
    for judged in outcome.judgements:
        call, variant = judged.shot.call, outcome.record.variant
        if call == NO_CALL:
            continue
        asked = " ".join(one.what for one in look_ahead(variant, judged.before).required)
        told = {
            "ball": call.ball, "pocket": call.pocket, "safety": call.safety, "group": call.group,
        }  # fmt: skip
        found += sum(bool(value) and word not in asked for word, value in told.items())
    return found


def place(file: str, line: int) -> str:
    """Return file:line, the file as seen from where the program runs where it lies below."""
    path, here = Path(file), Path.cwd()
    return f"{path.relative_to(here) if path.is_relative_to(here) else path}:{line}"


def lines_of(variant: Variant) -> Mapping[str, int]:
    """Return the lines of a variant's own two files, "toml" and "rules"."""
    files = {"toml": variant.path, "rules": variant.script_path}
    return {
        kind: len(path.read_text(encoding="utf-8").splitlines()) for kind, path in files.items()
    }
