"""What records prove, as a table, a list of what is missing, or JSON.

One idea: text and JSON are made from the same values; a game is one line.
"""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from engine.proving.coverage import Coverage
    from engine.proving.mutate import Mutation

COVERAGE_HEAD = (
    "game", "TOML", "rules", "rules fired", "outcomes", "sections", "records",
)  # fmt: skip
MUTATION_HEAD = ("game", "tried", "caught", "")


def coverage_lines(found: Sequence[Coverage]) -> Iterator[str]:
    """Yield the table of all games, then what is missing in each."""
    yield from _table([COVERAGE_HEAD, *(_coverage_row(one) for one in found)])
    for one in found:
        yield from _under(
            one.game,
            [
                *(f"{path} does not pass" for path in one.failing),
                *map(str, one.missing),
                *(
                    f"section {section} is cited and not proved"
                    for section in one.sections
                    if section not in one.proved
                ),
            ],
        )


def _coverage_row(one: Coverage) -> tuple[str, ...]:
    return (
        one.game,
        f"{one.toml_lines} lines",
        f"{one.rule_lines} lines",
        _share(one.rules_fired, one.rules),
        _share(one.outcomes_seen, one.outcomes),
        f"{len(one.proved)} of {len(one.sections)}",
        str(one.records),
    )


def mutation_lines(found: Sequence[Mutation]) -> Iterator[str]:
    """Yield the table of all games, then the survivors of each."""
    rows = [
        (one.game, str(one.tried), str(one.caught), percent(one.caught, one.tried)) for one in found
    ]
    yield from _table([MUTATION_HEAD, *rows])
    for one in found:
        yield from _under(one.game, [str(survivor) for survivor in one.survivors])


def _under(game: str, lines: Sequence[str]) -> Iterator[str]:
    if lines:
        yield from ("", game, *(f"  {line}" for line in lines))


def percent(part: int, whole: int) -> str:
    """Return a share, rounded down so that only all is 100 %."""
    return f"{1000 * part // whole / 10 if whole else 100.0:.1f} %"


def _share(part: int, whole: int) -> str:
    return f"{part} of {whole}, {percent(part, whole)}"


def _table(rows: Sequence[Sequence[str]]) -> Iterator[str]:
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    for row in rows:
        cells = [
            cell.ljust(width) if not column else cell.rjust(width)
            for column, (cell, width) in enumerate(zip(row, widths, strict=True))
        ]
        yield "  ".join(cells).rstrip()


def coverage_json(found: Iterable[Coverage]) -> list[dict[str, object]]:
    """Return the figures of every game as plain values."""
    return [asdict(one) for one in found]


def mutation_json(found: Iterable[Mutation]) -> list[dict[str, object]]:
    """Return what was tried, caught and survived in every game as plain values."""
    return [{**asdict(one), "caught": one.caught} for one in found]
