"""From a script's text to a Program, or to all its mistakes.

One idea: reading, naming, kinds and meaning are passes that go on after a mistake, so an author
hears of all of them together. Invariant: check_script never raises for a mistake of the author.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from rulelang import code as k
from rulelang import syntax as s
from rulelang.code import Code, Mistake
from rulelang.constructs import expressions_in
from rulelang.declarations import Declarations
from rulelang.defines import defined
from rulelang.diagnostics import Diagnostic, ScriptError
from rulelang.meaning import check_meaning
from rulelang.parse import MOST_TOLD, parse
from rulelang.program import (
    ANNOUNCED,
    SECTIONS,
    CompiledRule,
    Consequence,
    Program,
)
from rulelang.ruling import book_of, compiled_rule
from rulelang.statements import Statements
from rulelang.syntax import walk
from rulelang.timers import home_of, parted
from rulelang.where import head_of, narrowed

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from rulelang.probe import Probe
    from rulelang.scope import Scope
    from rulelang.vocabulary import Vocabulary

    Ruled = tuple[s.Script, s.Rule, CompiledRule, list[Code]]


def compile_script(
    source: str,
    filename: str,
    vocabulary: Vocabulary,
    library: Callable[[str], tuple[str, str] | None],
    cache: Path | None = None,
    probe: Probe | None = None,
) -> Program:
    """Compile a script; `library` gives (source, filename) of a script that `uses` names.

    `cache` is a folder for the grammar's tables; `probe` counts what the program does. Raises
    ScriptError with every mistake.
    """
    work = _Work(vocabulary, library, cache, probe)
    program = work.compile(source, filename)
    errors = [d for d in work.told() if d.severity == "error"]
    if errors or program is None:
        raise ScriptError(tuple(errors))
    return program if probe is None else probe.rules(program)


def check_script(
    source: str,
    filename: str,
    vocabulary: Vocabulary,
    library: Callable[[str], tuple[str, str] | None],
    cache: Path | None = None,
) -> tuple[Diagnostic, ...]:
    """Return every mistake and warning of a script, in the order of files and lines."""
    work = _Work(vocabulary, library, cache)
    work.compile(source, filename)
    return work.told()


_OF_NAMES = frozenset({"R201", "R202", "R203", "R206", "R403"})


@dataclass
class _Work:
    vocabulary: Vocabulary
    library: Callable[[str], tuple[str, str] | None]
    cache: Path | None
    probe: Probe | None = None
    scripts: list[s.Script] = field(default_factory=list)
    diagnostics: list[Diagnostic] = field(default_factory=list)
    consequences: list[Consequence] = field(default_factory=list)
    lost: bool = False
    """Whether a script to use could not be had: nobody knows which names it would bring."""

    def told(self) -> tuple[Diagnostic, ...]:
        """Return the diagnostics in order, each once."""
        order = {script.file: n for n, script in enumerate(self.scripts)}
        unique = {(d.file, d.line, d.column, d.code): d for d in self.diagnostics}
        found = sorted(
            unique.values(), key=lambda d: (order.get(d.file, 0), d.line, d.column, d.code)
        )
        return tuple(found[:MOST_TOLD])

    def tell(self, script: s.Script, trouble: Mistake, severity: str = "error") -> None:
        """Keep a mistake with its place and source line."""
        if trouble.silent or (self.lost and trouble.code in _OF_NAMES):
            return
        at = narrowed(script.source, trouble)
        lines = script.source.split("\n")
        snippet = lines[at.line - 1] if at.line <= len(lines) else ""
        width = min(max(1, at.end - at.start), max(1, len(snippet) - at.column + 1))
        self.diagnostics.append(
            Diagnostic(
                trouble.code,
                script.file,
                at.line,
                at.column,
                trouble.message,
                trouble.mend,
                snippet,
                width,
                "",
                severity,
            )
        )

    def compile(self, source: str, filename: str) -> Program | None:
        """Run every pass; None where the mistakes leave nothing to run."""
        self.read(source, filename, ())
        declarations = Declarations(self.vocabulary, self.scripts, self.tell)
        scope = declarations.scope
        if self.probe is not None:
            scope.probe = self.probe
            self.probe.files.update({script.source: script.file for script in self.scripts})
        self.scripts[:] = [parted(scope, script, self.tell) for script in self.scripts]
        homes, order = self.homes(scope), self.spotting_order(scope)
        rules = self.rules(scope)
        self.defines(scope)
        on = self.balls_on(scope)
        sound = not any(d.severity == "error" for d in self.diagnostics)
        check_meaning(declarations, rules, self.scripts, self.tell, sound=sound)
        if any(d.severity == "error" for d in self.diagnostics):
            return None
        program = self.program(declarations, scope, rules, homes, on)
        return replace(program, spotting_sets=order)

    def read(self, source: str, filename: str, above: tuple[str, ...]) -> None:
        """Parse a script and those it uses; the used come first."""
        script, mistakes = parse(source, filename, self.cache)
        self.diagnostics.extend(mistakes)
        wanted = sum(line.startswith("uses ") for line in source.split("\n")) if mistakes else 0
        had = sum(isinstance(one, s.Header) and one.word == "uses" for one in script.declarations)
        self.lost = self.lost or wanted > had
        for node in script.declarations:
            if not isinstance(node, s.Header) or node.word != "uses":
                continue
            if len(self.diagnostics) >= MOST_TOLD:
                break
            found = self.library(node.text)
            if found is None or len(above) > 16:
                message = f'there is no script "{node.text}" to use'
                mend = "it lies as NAME.rules in `rules/`, or beside this script"
                self.tell(script, Mistake("R204", node.at, message, mend))
                self.lost = True
            elif found[1] not in above and found[1] not in [x.file for x in self.scripts]:
                self.read(found[0], found[1], (*above, filename))
        self.scripts.append(script)

    def homes(self, scope: Scope) -> list[tuple[k.Run, str]]:
        """Compile the home declarations."""
        made = []
        for script in self.scripts:
            for node in script.declarations:
                if not isinstance(node, s.Home):
                    continue
                try:
                    balls = expressions_in(scope, script.source).want(node.balls, k.BALLS)
                    made.append((balls.run, scope.place("spot", node.spot, node.at)))
                except Mistake as trouble:
                    self.blame(scope, script, trouble)
        return made

    def spotting_order(self, scope: Scope) -> tuple[k.Run, ...]:
        """Compile the sets of the last spotting order; empty where none names sets."""
        made: tuple[k.Run, ...] = ()
        for script in self.scripts:
            for node in script.declarations:
                if isinstance(node, s.Header) and node.word == "spotting":
                    made = ()
                if not isinstance(node, s.SpottingOrder):
                    continue
                try:
                    reader = expressions_in(scope, script.source)
                    made = tuple(reader.want(one, k.BALLS).run for one in node.sets)
                except Mistake as trouble:
                    self.blame(scope, script, trouble)
        return made

    def defines(self, scope: Scope) -> None:
        """Compile the defines that no rule reads, for their mistakes."""
        for script in self.scripts:
            for node in script.declarations:
                if len(self.diagnostics) >= MOST_TOLD:
                    return
                if isinstance(node, s.Define) and scope.defines.get(node.name) is node:
                    self._define(scope, script, node)
                if isinstance(node, s.Fact) and node.asked_on is not None:
                    try:
                        expressions_in(scope, script.source).want(node.asked_on, k.BALLS)
                    except Mistake as trouble:
                        self.blame(scope, script, trouble)

    def _define(self, scope: Scope, script: s.Script, node: s.Define) -> None:
        used = set(scope.used)
        try:
            defined(expressions_in(scope, script.source), node.name, node.at)
        except Mistake as trouble:
            self.blame(scope, script, trouble)
        scope.used = (scope.used - {node.name}) | (used & {node.name})

    def balls_on(self, scope: Scope) -> k.Run | None:
        """Compile the define `balls-on`, which the display shows before a shot."""
        if "balls-on" not in scope.defines:
            return None
        scope.used.add("balls-on")
        try:
            reader = expressions_in(scope, "", frozen=True)
            node = s.Name(s.Span(1, 1, 0, 0), "balls-on")
            return reader.want(node, k.BALLS).run
        except Mistake:
            return None

    def blame(self, scope: Scope, script: s.Script, trouble: Mistake) -> None:
        """Tell a mistake where it stands, which may be in a define of another script."""
        owner = scope.owners.get(trouble.owner, script)
        self.tell(owner, trouble)

    def rules(self, scope: Scope) -> list[Ruled]:
        """Compile every rule that can be compiled."""
        made: list[Ruled] = []
        for script in self.scripts:
            for rule in script.rules:
                number = len(made)
                if len(self.diagnostics) >= MOST_TOLD:
                    return made
                try:
                    compiled, codes = self._rule(scope, script, rule, number)
                except Mistake as trouble:
                    self.blame(scope, script, trouble)
                else:
                    made.append((script, rule, compiled, codes))
        return made

    def _rule(
        self, scope: Scope, script: s.Script, rule: s.Rule, number: int
    ) -> tuple[CompiledRule, list[Code]]:
        section = rule.section or home_of(rule.body)
        for phase in rule.phases:
            scope.phase(phase, head_of(script, rule, phase))
        statements = Statements(scope, script.source, section, number, self.consequences)
        run = statements.body(rule.body)
        for trouble in statements.troubles[1:]:
            self.blame(scope, script, trouble)
        if statements.troubles:
            raise statements.troubles[0]
        game_book = book_of(self.scripts[-1])
        return compiled_rule(script, rule, statements, run, game_book), statements.codes

    def program(
        self,
        declarations: Declarations,
        scope: Scope,
        rules: list[Ruled],
        homes: list[tuple[k.Run, str]],
        on: k.Run | None,
    ) -> Program:
        """Put the parts together."""
        sections: dict[str, list[CompiledRule]] = {name: [] for name in SECTIONS}
        sections["late fouls"], sections[ANNOUNCED] = [], []
        for compiled, (_, rule, _, _) in zip(with_overrides(rules), rules, strict=True):
            name = compiled.info.section
            name = "late fouls" if compiled.late and name == "fouls" else name
            sections.setdefault(name, []).append(compiled)
            if name == "before shot" and (self.probe is not None or _announces(rule.body)):
                sections[ANNOUNCED].append(compiled)
        fouls: dict[str, tuple[str, ...]] = {}
        for _, rule, _, _ in rules:
            for name in fouls_of(rule.body):
                fouls[name] = (
                    *fouls.get(name, ()),
                    *(c for c in rule.cites if c not in fouls.get(name, ())),
                )
        return Program(
            title=declarations.header("game"),
            rulebook=book_of(self.scripts[-1]) or declarations.header("cites"),
            books=tuple(dict.fromkeys(filter(None, map(book_of, reversed(self.scripts))))),
            phases=scope.phases,
            tracked=dict(scope.tracks),
            facts=dict(scope.facts),
            fouls=fouls,
            options=tuple(scope.options),
            rules=tuple(compiled.info for _, _, compiled, _ in rules),
            settled_within=float(declarations.header("settled") or 0),
            vocabulary=self.vocabulary,
            compiled={name: tuple(found) for name, found in sections.items() if name != ANNOUNCED},
            by_phase=_by_phase(sections, scope.phases),
            consequences=tuple(self.consequences),
            bits=dict(scope.bits),
            names={bit: name for name, bit in scope.bits.items()},
            values=dict(scope.values),
            ball_mask=scope.balls,
            lasting=scope.lasting,
            passing=scope.passing,
            asks=frozenset(scope.asks),
            homes=tuple(homes),
            spotting=declarations.header("spotting"),
            on=on,
            timers=dict(scope.timers),
            mates=scope.mates,
        )


def with_overrides(rules: list[Ruled]) -> list[CompiledRule]:
    """Return the compiled rules, each with the numbers of the rules it overrides."""
    numbers: dict[str, list[int]] = {}
    for _, rule, compiled, _ in rules:
        numbers.setdefault(rule.name, []).append(compiled.number)
    return [
        replace(
            compiled,
            overrides=tuple(n for name, _ in rule.overrides for n in numbers.get(name, [])),
        )
        for _, rule, compiled, _ in rules
    ]


def fouls_of(body: tuple[Any, ...]) -> list[str]:
    """Return the names of the fouls that a body finds."""
    return [node.name for node in walk(body) if isinstance(node, s.Foul)]


def _announces(body: tuple[Any, ...]) -> bool:
    """Tell whether a body may offer something, or let balls be struck."""
    return any(isinstance(node, s.OfferChoices | s.AllowStrike) for node in s.walk(body))


def _by_phase(
    sections: dict[str, list[CompiledRule]], phases: tuple[str, ...]
) -> dict[str, dict[str, tuple[CompiledRule, ...]]]:
    """Return, for each section and phase, the rules that can fire in it."""
    return {
        name: {
            phase: tuple(rule for rule in found if rule.phases is None or phase in rule.phases)
            for phase in (phases or ("",))
        }
        for name, found in sections.items()
    }
