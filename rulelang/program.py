"""A checked script, ready to judge shots.

One idea: everything that can be decided before a shot is decided here, once; a Program never
changes and may serve many threads. Invariant: a Program has no mistake of its author in it.
"""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING, Any

from rulelang.frozen import value

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping

    from rulelang.code import Code, Run
    from rulelang.telling import Outline
    from rulelang.vocabulary import Value, Vocabulary
    from rulelang.watch import Watch

SECTIONS = ("before shot", "fouls", "points", "turn", "table", "next shot", "ending")
STAGE = {name: number for number, name in enumerate(SECTIONS)}
CONSEQUENCE = len(SECTIONS)
ANNOUNCED = "announced"
"""Where those rules of `before shot:` stand once more that may offer, or let balls be struck."""


@value
class Track:
    """A tracked value: `scope` is "shot", "turn", "game" or "match".

    `start` is the value it starts with; "breaker" stands for the number of the player who
    breaks. `per_player`: one value for each player; `per_side`: the players of a side share it.
    """

    name: str
    scope: str
    per_player: bool
    start: Value
    by_breaker: bool = False
    per_side: bool = False


@value
class Timer:
    """Seconds that run anew for each `per`: "shot", "turn", "game" or "match"."""

    name: str
    seconds: float
    per: str


@value
class FactDecl:
    """A fact that only an eye, or positions, can tell; `kind` as in a script, `values` allowed."""

    name: str
    kind: str
    default: Value | None
    values: tuple[str, ...] = ()
    predicate: str | None = None


@value
class RuleInfo:
    """A rule as the script tells it; `text` is its source.

    `cites` are sections of the game's rulebook; one of another begins with the name of its book.
    """

    name: str
    section: str
    cites: tuple[str, ...]
    text: str
    file: str
    line: int


@value
class Reading:
    """One tested condition of a rule, for the explanation."""

    code: Code


@value
class CompiledRule:
    """A rule's closure and what it overrides, by numbers of rules.

    `run` returns the decisions of a rule that fired, None for a silent one. `late`: a rule of
    the fouls that speaks of fouls. `outline` is what an explanation walks again. A rule
    of whose signs the bits `asked` are not just those `there` cannot fire, nor one without `any`
    of some others (0: there are none); `phases` are the phases in which it can (None: all).
    """

    number: int
    info: RuleInfo
    stage: int
    run: Callable[[Watch], list[tuple[Any, ...]] | None]
    late: bool
    overrides: tuple[int, ...]
    outline: Outline
    asked: int = 0
    there: int = 0
    any: int = 0
    phases: frozenset[str] | None = None


@value
class Consequence:
    """What happens when an option is chosen; `to` is the word of who it is offered to."""

    key: int
    option: str
    to: str
    rule: int
    run: Callable[[Watch, list[tuple[Any, ...]]], bool]
    text: str


@value
class Program:
    """A whole game's rules, compiled against one vocabulary.

    `compiled` has the rules by section; rules of the fouls that speak of fouls stand under
    "late fouls".
    """

    title: str
    rulebook: str
    phases: tuple[str, ...]
    tracked: Mapping[str, Track]
    facts: Mapping[str, FactDecl]
    fouls: Mapping[str, tuple[str, ...]]
    options: tuple[str, ...]
    rules: tuple[RuleInfo, ...]
    settled_within: float
    vocabulary: Vocabulary
    compiled: Mapping[str, tuple[CompiledRule, ...]] = field(repr=False, default_factory=dict)
    by_phase: Mapping[str, Mapping[str, tuple[CompiledRule, ...]]] = field(
        repr=False, default_factory=dict
    )
    consequences: tuple[Consequence, ...] = field(repr=False, default=())
    bits: Mapping[str, int] = field(repr=False, default_factory=dict)
    names: Mapping[int, str] = field(repr=False, default_factory=dict)
    values: Mapping[int, int] = field(repr=False, default_factory=dict)
    ball_mask: int = 0
    lasting: int = 0
    passing: int = 0
    """How many defines are remembered for a shot, and how many for a section."""
    asks: frozenset[str] = frozenset()
    """The lines and zones whose crossing, entering or leaving some rule asks about."""
    homes: tuple[tuple[Run, str], ...] = field(repr=False, default=())
    spotting: str = ""
    spotting_sets: tuple[Run, ...] = field(repr=False, default=())
    """Sets of balls in the order of their spotting; where there are any, `spotting` is void."""
    on: Run | None = field(repr=False, default=None)
    timers: Mapping[str, Timer] = field(default_factory=dict)
    books: tuple[str, ...] = ()
    """The rulebooks that the script and those it uses name, the game's own first."""
    mates: int = 0
    """How many players a side has, 0 where each plays for himself."""


def by_section(rules: Iterable[RuleInfo]) -> list[RuleInfo]:
    """Return rules in the order in which the referee asks: starts, the sections, ends."""

    def place(rule: RuleInfo) -> int:
        if rule.section in STAGE:
            return STAGE[rule.section]
        return -1 if rule.section.endswith("start") else CONSEQUENCE

    return sorted(rules, key=place)
