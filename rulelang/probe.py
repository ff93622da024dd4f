"""What a program did while it judged: which rules fired, which way each condition went.

One idea: a script compiled with a Probe has a counter at every rule, condition, `otherwise`,
choice and number of an action, and one of them at a time can be made wrong: a rule dropped, a
condition turned round, a number one too high. Nothing is compiled twice for that.
Invariant: with nothing made wrong, a probed program decides exactly as one without a probe; a
program compiled without one holds no trace of this module.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from rulelang import code as k
from rulelang import syntax as s
from rulelang.frozen import value
from rulelang.signs import UNKNOWN

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from rulelang.code import Code
    from rulelang.program import CompiledRule, Program
    from rulelang.watch import Watch

    Body = Callable[[Watch, list[tuple[Any, ...]]], bool]

RULE, CONDITION, OTHERWISE, CHOICE, OFFER, NUMBER = (
    "rule", "condition", "otherwise", "choice", "offer", "number",
)  # fmt: skip
WRONG = {
    RULE: "dropped",
    CONDITION: "turned round",
    OTHERWISE: "dropped",
    CHOICE: "without its consequences",
    OFFER: "not on offer",
    NUMBER: "one more",
}
"""What is done to a site of each kind to see whether anybody notices."""


@value
class Site:
    """One place of a script that is watched; `text` is what stands there.

    `inert`: making it wrong changes nothing, so nobody could notice.
    """

    number: int
    kind: str
    text: str
    file: str
    line: int
    inert: bool = False


@dataclass(slots=True)
class Probe:
    """The counters of one program.

    `yes[n]` counts how often site n held, fired or was taken, `no[n]` how often a condition did
    not hold. `wrong` is the site that is made wrong, None for none.
    """

    sites: list[Site] = field(default_factory=list)
    yes: list[int] = field(default_factory=list)
    no: list[int] = field(default_factory=list)
    wrong: int | None = None
    files: dict[str, str] = field(default_factory=dict)
    _known: dict[tuple[str, str, int, int], int] = field(default_factory=dict)

    def forget(self) -> None:
        """Set all counters to zero."""
        self.yes[:] = [0] * len(self.sites)
        self.no[:] = [0] * len(self.sites)

    def touched(self) -> frozenset[int]:
        """Return the sites that were passed since `forget`."""
        return frozenset(n for n in range(len(self.sites)) if self.yes[n] or self.no[n])

    def condition(self, made: Code, source: str, node: s.Expr) -> Code:
        """Watch which way a condition goes; `not` is watched inside."""
        test = made.truth
        if test is None or isinstance(node, s.Not) or made.constant is not None:
            return made
        number = self._site(CONDITION, source, node.at, made.text)

        def watched(c: Watch) -> bool:
            holds = bool(test(c)) is not (self.wrong == number)
            (self.yes if holds else self.no)[number] += 1
            return holds

        made.truth = watched
        if made.kind == k.FLAG:
            made.run = watched
        made.signs = UNKNOWN
        return made

    def body(
        self, kind: str, source: str, at: s.Span, text: str, run: Body, *, inert: bool = False
    ) -> Body:
        """Watch whether a body is run."""
        number = self._site(kind, source, at, text, inert=inert)

        def watched(c: Watch, out: list[tuple[Any, ...]]) -> bool:
            self.yes[number] += 1
            return False if self.wrong == number else run(c, out)

        return watched

    def offer(self, source: str, choice: s.Choice, test: k.Run | None) -> k.Run:
        """Watch whether an option is put on offer."""
        number = self._site(OFFER, source, choice.at, choice.option)

        def watched(c: Watch) -> bool:
            on = test is None or bool(test(c))
            self.yes[number] += on
            return on and self.wrong != number

        return watched

    def number(self, made: Code, source: str, node: s.Number) -> Code:
        """Watch a number that an action writes out."""
        run, number = made.run, self._site(NUMBER, source, node.at, made.text)

        def watched(c: Watch) -> Any:
            self.yes[number] += 1
            return run(c) + (self.wrong == number)

        made.run = watched
        return made

    def rules(self, program: Program) -> Program:
        """Return the program with every rule watched."""
        made = {one.number: self._rule(one) for found in program.compiled.values() for one in found}
        compiled = _exchanged(program.compiled.items(), made)
        by_phase = {
            section: _exchanged(phases.items(), made)
            for section, phases in program.by_phase.items()
        }
        return replace(program, compiled=compiled, by_phase=by_phase)

    def _rule(self, rule: CompiledRule) -> CompiledRule:
        info, run, number = rule.info, rule.run, len(self.sites)
        self._add(Site(number, RULE, info.name, info.file, info.line))

        def watched(c: Watch) -> list[tuple[Any, ...]] | None:
            if self.wrong == number:
                self.no[number] += 1
                return None
            found = run(c)
            (self.no if found is None else self.yes)[number] += 1
            return found

        return replace(rule, run=watched)

    def _site(self, kind: str, source: str, at: s.Span, text: str, *, inert: bool = False) -> int:
        """Return the number of a site; what is compiled twice is one site."""
        key = (kind, source, at.start, at.end)
        if key not in self._known:
            self._known[key] = number = len(self.sites)
            self._add(Site(number, kind, text, self.files.get(source, ""), at.line, inert))
        return self._known[key]

    def _add(self, site: Site) -> None:
        self.sites.append(site)
        self.yes.append(0)
        self.no.append(0)


def _exchanged(
    found: Iterable[tuple[str, tuple[CompiledRule, ...]]], made: dict[int, CompiledRule]
) -> dict[str, tuple[CompiledRule, ...]]:
    return {name: tuple(made[one.number] for one in rules) for name, rules in found}
