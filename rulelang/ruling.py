"""One rule of a script, from its tree to what can be fired.

One idea: the statements say what a rule does and by what signs it can be passed over; here that
becomes one value with the rule's name, place and sections. Invariant: a rule that reads what a
later section decides is never made.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang import syntax as s
from rulelang.code import Mistake
from rulelang.program import CONSEQUENCE, STAGE, CompiledRule, RuleInfo
from rulelang.signs import UNKNOWN, Signs, of_all
from rulelang.telling import in_phases
from rulelang.where import span_of

if TYPE_CHECKING:
    from rulelang.statements import Run, Statements


def compiled_rule(
    script: s.Script, rule: s.Rule, statements: Statements, run: Run, game_book: str
) -> CompiledRule:
    """Return a rule whose body `statements` has made into `run`.

    `game_book` is the rulebook of the game; a section of another book carries its name. Raises a
    Mistake where the rule reads what a later section decides.
    """
    section = statements.section
    stage = STAGE.get(section, CONSEQUENCE)
    _in_time(script, rule, statements, stage)
    alone = len(rule.body) == 1
    guard, signs = (statements.guard, statements.signs) if alone else (None, UNKNOWN)
    if rule.phases:
        signs = of_all([Signs(phases=frozenset(rule.phases)), signs])
    return CompiledRule(
        statements.rule,
        _info(script, rule, section, game_book),
        stage,
        _plain(run) if guard is None else _guarded(guard[0].truth, guard[1]),
        statements.late or (section == "game end" and _ends(rule.body)),
        (),
        in_phases(rule.phases, tuple(statements.outline)),
        signs.all | signs.none,
        signs.all,
        signs.any,
        signs.phases,
    )


def _info(script: s.Script, rule: s.Rule, section: str, game_book: str) -> RuleInfo:
    text = script.source[rule.at.start : rule.body[-1].at.end].strip()
    name = rule.name or " ".join(text.split())[:60]
    cites = cited(rule.cites, book_of(script), game_book)
    return RuleInfo(name, section, cites, text, script.file, rule.at.line)


def _in_time(script: s.Script, rule: s.Rule, statements: Statements, stage: int) -> None:
    for made in statements.codes:
        if made.since > stage:
            message = f"`{made.text}` is decided later than in `{statements.section}:`"
            at = span_of(script.source, made.text, rule.at)
            raise Mistake("R402", at, message, "read it in a later section")


def book_of(script: s.Script) -> str:
    """Return the rulebook whose sections the rules of a script cite, "" where it names none."""
    headers = [one for one in script.declarations if isinstance(one, s.Header)]
    named = [one.text for one in headers if one.word in ("cites", "book")]
    return named[-1] if named else ""


def cited(sections: tuple[str, ...], book: str, main: str) -> tuple[str, ...]:
    """Return sections with the name of their book, where it is not the game's own."""
    if not book or book == main:
        return sections
    return tuple(f"{book} {section}" for section in sections)


def _ends(body: tuple[Any, ...]) -> bool:
    """Tell whether a body may end something."""
    return any(isinstance(node, s.Win) for node in s.walk(body))


def _plain(run: Any) -> Any:
    def fire(c: Any) -> list[Any] | None:
        out: list[Any] = []
        return out if run(c, out) else None

    return fire


def _guarded(test: Any, body: Any) -> Any:
    def fire(c: Any) -> list[Any] | None:
        if not test(c):
            return None
        out: list[Any] = []
        return out if body(c, out) else None

    return fire
