"""What the records of a game prove: rules that fired, both sides of conditions, sections.

One idea: a probe counted; here it is summed up. An outcome is one side of one condition, one
`otherwise`, or one option taken. Invariant: what is missing is told with file and line.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from engine.proving.games import Game, lines_of, place
from rulelang.probe import CHOICE, CONDITION, OTHERWISE, RULE

if TYPE_CHECKING:
    from collections.abc import Iterable

    from rulelang.probe import Site


@dataclass(frozen=True, slots=True)
class Missing:
    """An outcome that no record shows, and where it stands."""

    what: str
    text: str
    file: str
    line: int

    def __str__(self) -> str:
        return f"{place(self.file, self.line)}: {self.what}: {self.text}"


@dataclass(frozen=True, slots=True)
class Coverage:
    """The figures of one game; `proved` are the sections cited by a rule that fired."""

    game: str
    title: str
    toml_lines: int
    rule_lines: int
    records: int
    failing: tuple[str, ...]
    rules: int
    rules_fired: int
    outcomes: int
    outcomes_seen: int
    sections: tuple[str, ...]
    proved: tuple[str, ...]
    missing: tuple[Missing, ...]


def coverage_of(game: Game) -> Coverage:
    """Return what the records of a game prove."""
    yes = frozenset[int]().union(*(case.fired for case in game.cases))
    no = frozenset[int]().union(*(case.unfired for case in game.cases))
    outcomes = [one for site in game.probe.sites for one in _outcomes(site, yes, no)]
    rules = [site for site in game.probe.sites if site.kind == RULE]
    silent = [site for site in rules if site.number not in yes]
    lines = lines_of(game.variant)
    sections, proved = _sections(game, yes)
    return Coverage(
        game=game.variant.name,
        title=game.variant.title,
        toml_lines=lines["toml"],
        rule_lines=lines["rules"],
        records=len(game.cases),
        failing=tuple(str(case.record.path) for case in game.cases if not case.passed),
        rules=len(rules),
        rules_fired=len(rules) - len(silent),
        outcomes=len(outcomes),
        outcomes_seen=sum(one is None for one in outcomes),
        sections=sections,
        proved=proved,
        missing=(
            *(_missing(site, "rule never fires") for site in silent),
            *(one for one in outcomes if one is not None),
        ),
    )


def _outcomes(site: Site, yes: frozenset[int], no: frozenset[int]) -> Iterable[Missing | None]:
    """Yield the outcomes of a site, None for each that was seen."""
    held = site.number in yes
    if site.kind == CONDITION:
        yield None if held else _missing(site, "never true")
        yield None if site.number in no else _missing(site, "never false")
    elif site.kind == OTHERWISE:
        yield None if held else _missing(site, "otherwise never taken")
    elif site.kind == CHOICE:
        yield None if held else _missing(site, "option never taken")


def _missing(site: Site, what: str) -> Missing:
    return Missing(what, site.text, site.file, site.line)


def _sections(game: Game, yes: frozenset[int]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the sections that rules cite, and those of them cited by a rule that fired."""
    fired = {
        (site.file, site.line, site.text)
        for site in game.probe.sites
        if site.kind == RULE and site.number in yes
    }
    cited: dict[str, bool] = {}
    for info in game.variant.program.rules:
        for section in info.cites:
            proved = (info.file, info.line, info.name) in fired
            cited[section] = cited.get(section, False) or proved
    return tuple(cited), tuple(section for section, proved in cited.items() if proved)
