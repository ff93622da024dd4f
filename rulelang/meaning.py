"""What is wrong with a script as a whole: overrides, circles, phases, unused names, clashes.

One idea: each check looks at all rules together and tells what it can prove.
Invariant: an error here is certain; what is only likely is a warning.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from rulelang import lints
from rulelang import syntax as s
from rulelang.code import Mistake
from rulelang.scope import nearest

if TYPE_CHECKING:
    from collections.abc import Callable

    from rulelang.code import Code
    from rulelang.declarations import Declarations
    from rulelang.program import CompiledRule

    Ruled = tuple[s.Script, s.Rule, CompiledRule, list[Code]]
    Tell = Callable[..., None]


def check_meaning(
    declarations: Declarations,
    rules: list[Ruled],
    scripts: list[s.Script],
    tell: Tell,
    *,
    sound: bool,
) -> None:
    """Tell every mistake of meaning, and the lints as warnings.

    Where the script is not `sound`, what could not be read may be just what is missed: phases
    without a way to them and names without use are not told then.
    """
    written = [(script, rule) for script in scripts for rule in script.rules]
    _names(written, tell)
    _overrides(written, scripts, tell)
    _circles(written, tell)
    lints.clashes(rules, tell)
    lints.stuck(declarations.scope, rules, tell)
    if sound:
        lints.shut_phases(declarations, rules, tell)
        lints.homeless(declarations.scope, rules, tell)
        _phases(declarations, scripts, tell)
        _unused(declarations, scripts, tell)
    if declarations.header("cites"):
        _cites(written, tell)


def _names(written: list[tuple[s.Script, s.Rule]], tell: Tell) -> None:
    seen: dict[str, tuple[str, s.Span]] = {}
    for script, rule in written:
        if rule.name and rule.name in seen and seen[rule.name] != (script.file, rule.at):
            message = f'there are two rules "{rule.name}"'
            tell(script, Mistake("R410", rule.at, message, "give one of them another name"))
        seen.setdefault(rule.name, (script.file, rule.at))


def _overrides(written: list[tuple[s.Script, s.Rule]], scripts: list[s.Script], tell: Tell) -> None:
    """Tell of overrides without a rule; a rule that could not be read is one all the same."""
    sections = {rule.name: rule.section for _, rule in written}
    for script, rule in written:
        for name, at in rule.overrides:
            if name not in sections and any(_heads(one, name) for one in scripts):
                continue
            if name not in sections:
                mend = nearest(name, [n for n in sections if n]) or "name a rule of this game"
                tell(script, Mistake("R403", at, f'there is no rule "{name}"', mend))
            elif sections[name] != rule.section:
                message = f'"{name}" stands in `{sections[name]}:`, this rule in `{rule.section}:`'
                mend = "a rule can override rules of its own section"
                tell(script, Mistake("R403", at, message, mend))


def _heads(script: s.Script, name: str) -> bool:
    """Tell whether a line gives a rule that name, be its first word misspelt."""
    return re.search(rf'^ *[a-z]+ "{re.escape(name)}"', script.source, re.MULTILINE) is not None


def _circles(written: list[tuple[s.Script, s.Rule]], tell: Tell) -> None:
    graph = {rule.name: [name for name, _ in rule.overrides] for _, rule in written}
    for script, rule in written:
        path, seen = list(graph.get(rule.name, ())), set()
        while path:
            name = path.pop()
            if name == rule.name:
                message = f'"{rule.name}" overrides itself, through others'
                tell(script, Mistake("R404", rule.at, message, "drop one `overrides`"))
                break
            if name not in seen:
                seen.add(name)
                path.extend(graph.get(name, ()))


def _phases(declarations: Declarations, scripts: list[s.Script], tell: Tell) -> None:
    reached = {
        node.phase
        for script in scripts
        for rule in script.rules
        for node in s.walk(rule.body)
        if isinstance(node, s.GoToPhase)
    }
    for script, name, at in declarations.phase_places[1:]:
        if name not in reached:
            message = f'no rule leads to the phase "{name}"'
            mend = f"say `go to phase {name}` in a rule, or drop the phase"
            tell(script, Mistake("R406", at, message, mend), "warning")


def _unused(declarations: Declarations, scripts: list[s.Script], tell: Tell) -> None:
    """Warn of names of the game's own script; a shared one may define more than a game needs."""
    scope = declarations.scope
    if not any(script.rules for script in scripts):
        return
    for name, owner in scope.owners.items():
        if owner.file == scripts[-1].file and name not in scope.used and name not in scope.poisoned:
            at = _place_of(owner, name)
            if at is not None:
                message = f'"{name}" is never used'
                tell(owner, Mistake("R407", at, message, "drop it"), "warning")


def _place_of(script: s.Script, name: str) -> s.Span | None:
    for node in script.declarations:
        if isinstance(node, s.Zones | s.Define | s.Track | s.Fact | s.Timer) and node.name == name:
            return node.at
    return None


def _cites(written: list[tuple[s.Script, s.Rule]], tell: Tell) -> None:
    for script, rule in written:
        if not rule.cites:
            message = "this rule cites no section of the rulebook"
            mend = 'say `rule "..." [section]:`'
            tell(script, Mistake("R408", rule.at, message, mend), "warning")
