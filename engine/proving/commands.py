"""`golden --coverage`, `--mutate` and `--pictures`: find the records, prove, print.

One idea: each returns the exit status; what cannot be used is told on stderr and is status 2.
"""

from __future__ import annotations

import json
import os
import sys
from typing import TYPE_CHECKING

import click

from engine.proving.coverage import coverage_of
from engine.proving.games import load_game, records_by_game
from engine.proving.mutate import joined, mutate_all
from engine.proving.told import coverage_json, coverage_lines, mutation_json, mutation_lines
from engine.records.record import RecordError
from engine.variant.library import VariantError
from rulelang.diagnostics import render

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence
    from pathlib import Path

    from engine.proving.coverage import Coverage
    from engine.proving.mutate import Mutation
    from rulelang.diagnostics import Diagnostic

PASSED, DIFFERENT, UNUSABLE = 0, 1, 2


def coverage(given: Sequence[Path], folder: Path, cache: Path, *, as_json: bool) -> int:
    """Print what records prove; 1 where a rule is not proved or a record does not pass."""
    games, trouble = records_by_game(given, folder)
    found: list[Coverage] = []
    for name, paths in sorted(games.items()):
        try:
            found.append(coverage_of(load_game(name, paths, cache)))
        except (RecordError, VariantError) as error:
            trouble += error.diagnostics
    _tell(trouble)
    if as_json:
        click.echo(json.dumps(coverage_json(found), indent=2))
    elif found:
        click.echo("\n".join(coverage_lines(found)))
    short = any(one.failing or one.rules_fired < one.rules for one in found)
    return UNUSABLE if trouble or not found else DIFFERENT if short else PASSED


def mutation(given: Sequence[Path], folder: Path, cache: Path, jobs: int, *, as_json: bool) -> int:
    """Print which places of the rules may be wrong unnoticed; 1 where there are such."""
    games, trouble = records_by_game(given, folder)
    for name, paths in list(games.items()):
        try:
            load_game(name, paths, cache)
        except (RecordError, VariantError) as error:
            trouble += error.diagnostics
            del games[name]
    jobs = jobs or os.cpu_count() or 1
    parts: dict[str, list[Mutation]] = {}
    for one in _progress(mutate_all(dict(sorted(games.items())), jobs, cache), len(games) * jobs):
        parts.setdefault(one.game, []).append(one)
    found = [joined(parts[name]) for name in sorted(parts)]
    _tell(trouble)
    if as_json:
        click.echo(json.dumps(mutation_json(found), indent=2))
    elif found:
        click.echo("\n".join(mutation_lines(found)))
    if trouble or not found:
        return UNUSABLE
    return DIFFERENT if any(one.survivors for one in found) else PASSED


def _progress(done: Iterable[Mutation], whole: int) -> Iterator[Mutation]:
    """Pass on what is done, counting on stderr where somebody looks."""
    for number, one in enumerate(done, 1):
        if sys.stderr.isatty():
            end = "\n" if number == whole else ""
            click.echo(f"\r{number} of {whole} parts, {one.game:30}", nl=False, err=True)
            click.echo(end, nl=False, err=True)
        yield one


def _tell(trouble: Iterable[Diagnostic]) -> None:
    for one in trouble:
        click.echo(render(one), err=True)
