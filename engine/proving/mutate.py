"""Whether the records of a game would notice a wrong rule.

One idea: each place of the rules is made wrong, one after the other, and the records that pass
there are judged again; a place that none of them notices survives.
Invariant: a game's rules are compiled once in each process, whatever is made wrong.
"""

from __future__ import annotations

from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

from engine.proving.games import Game, is_caught, load_game, place
from rulelang.probe import CONDITION, NUMBER, WRONG, Site

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence
    from pathlib import Path


@dataclass(frozen=True, slots=True)
class Survivor:
    """A place that can be wrong without any record noticing; `passed_by` how many go there."""

    wrong: str
    kind: str
    text: str
    file: str
    line: int
    passed_by: int

    def __str__(self) -> str:
        seen = f"{self.passed_by} records pass" if self.passed_by else "no record passes"
        return f"{place(self.file, self.line)}: {self.kind} {self.wrong}: {self.text} ({seen})"


@dataclass(frozen=True, slots=True)
class Mutation:
    """How many wrong places of a game were noticed, and those that were not."""

    game: str
    tried: int
    survivors: tuple[Survivor, ...]

    @property
    def caught(self) -> int:
        """How many were noticed."""
        return self.tried - len(self.survivors)


def mutate(game: Game, share: int = 0, shares: int = 1) -> Mutation:
    """Return which places of a game may be wrong unnoticed; of `shares` parts the one asked for."""
    sites = [site for site in game.probe.sites if not site.inert][share::shares]
    survivors = tuple(one for site in sites if (one := _survivor(game, site)) is not None)
    return Mutation(game.variant.name, len(sites), survivors)


def _survivor(game: Game, site: Site) -> Survivor | None:
    both = site.kind in {CONDITION, NUMBER}
    cases = [
        case
        for case in game.cases
        if case.passed and site.number in (case.judging if both else case.fired)
    ]
    if any(is_caught(game, case, site.number) for case in sorted(cases, key=_length)):
        return None
    return Survivor(WRONG[site.kind], site.kind, site.text, site.file, site.line, len(cases))


def _length(case: object) -> int:
    return len(case.record.steps)  # type: ignore[attr-defined]


def mutate_all(
    games: Mapping[str, Sequence[Path]], jobs: int, cache: Path | None = None
) -> Iterator[Mutation]:
    """Yield the mutation of every game as it is done, on `jobs` processes.

    The parts of one game are yielded apart; `joined` puts them together.
    """
    tasks = [
        (name, tuple(paths), cache, share, jobs)
        for name, paths in games.items()
        for share in range(jobs)
    ]
    if jobs == 1:
        yield from (_share(*task) for task in tasks)
        return
    with ProcessPoolExecutor(jobs) as pool:
        for done in as_completed([pool.submit(_share, *task) for task in tasks]):
            yield done.result()


def joined(parts: Sequence[Mutation]) -> Mutation:
    """Return the parts of one game's mutation as one, survivors in the order of the files."""
    survivors = (one for part in parts for one in part.survivors)
    return Mutation(
        parts[0].game,
        sum(part.tried for part in parts),
        tuple(sorted(survivors, key=lambda one: (one.file, one.line, one.kind, one.text))),
    )


def _share(
    name: str, paths: tuple[Path, ...], cache: Path | None, share: int, shares: int
) -> Mutation:
    return mutate(_game(name, paths, cache), share, shares)


@lru_cache(maxsize=1)
def _game(name: str, paths: tuple[Path, ...], cache: Path | None) -> Game:
    return load_game(name, paths, cache)
