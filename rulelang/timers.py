"""What happens when a timer runs out: `when NAME expires:`, taken apart into the sections.

One idea: that a timer ran out is a fact of the shot, and a rule of that moment is a rule of the
sections its actions belong to, asked only where the fact is told.
Invariant: every action keeps its order among those of its section.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from rulelang import syntax as s
from rulelang.code import Mistake
from rulelang.program import FactDecl, Timer
from rulelang.scope import nearest
from rulelang.statements import SECTION_OF

if TYPE_CHECKING:
    from collections.abc import Callable

    from rulelang.scope import Scope

    Tell = Callable[[s.Script, Mistake], None]

EXPIRES = " expires"
LONGEST = 24 * 3600.0


def declare_timer(scope: Scope, node: s.Timer) -> None:
    """Make a timer known, and that it ran out a fact; raises R307 for a time out of reason."""
    seconds = float(node.seconds)
    if not 0 < seconds <= LONGEST:
        message = f'"{node.name}" cannot last {node.seconds} seconds'
        raise Mistake("R307", node.at, message, "give more than 0 seconds, and at most a day")
    unit = {"rack": "game", "frame": "game"}.get(node.per, node.per)
    if unit in ("player", "side"):
        message = f'"{node.name}" runs for a shot, a turn, a game or the match'
        raise Mistake("R305", node.at, message, "say `per shot`")
    scope.timers[node.name] = Timer(node.name, seconds, unit)
    scope.facts[node.name] = FactDecl(node.name, "flag", default=False)
    scope.fact_nodes[node.name] = s.Fact(
        node.at, node.name, "flag", (), s.Flag(node.at, value=False), None, None
    )


def parted(scope: Scope, script: s.Script, tell: Tell) -> s.Script:
    """Return a script whose rules of timers stand in the sections of their actions."""
    if not any((rule.section or "").endswith(EXPIRES) for rule in script.rules):
        return script
    rules: list[s.Rule] = []
    for rule in script.rules:
        if rule.section is None or not rule.section.endswith(EXPIRES):
            rules.append(rule)
            continue
        name = rule.section.removesuffix(EXPIRES)
        if name not in scope.timers:
            mend = nearest(name, scope.timers) or f"declare it: timer {name} lasts 30 seconds"
            tell(script, Mistake("R207", rule.at, f'"{name}" is not a timer', mend))
            continue
        scope.used.add(name)
        rules.extend(_parts(rule, name))
    return replace(script, rules=tuple(rules))


def home_of(body: tuple[s.Statement, ...]) -> str:
    """Return the section of what stands outside any section: that of its first action."""
    for node in s.walk(body):
        if type(node) in SECTION_OF:
            return SECTION_OF[type(node)]
    return "fouls"


def _parts(rule: s.Rule, timer: str) -> list[s.Rule]:
    """Return a rule for each section that the statements of `rule` belong to.

    What the rule overrides, it overrides in the section of its first statement.
    """
    bodies: dict[str, list[s.Statement]] = {}
    for node in rule.body:
        bodies.setdefault(home_of((node,)), []).append(node)
    parts: list[s.Rule] = []
    for section, body in bodies.items():
        condition = s.Name(rule.at, timer)
        guarded = s.If(body[-1].at, ((condition, tuple(body)),), ())
        overrides = () if parts else rule.overrides
        parts.append(replace(rule, section=section, body=(guarded,), overrides=overrides))
    return parts
