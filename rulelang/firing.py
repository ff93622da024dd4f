"""The rules of one section, asked: which can fire, which did, which are overridden.

One idea: a rule that fires returns its decisions, and a rule in force withdraws those it
overrides. Invariant: what a section decided does not depend on the order of its rules.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang.closures import forget
from rulelang.decisions import Foul
from rulelang.program import SECTIONS, CompiledRule

if TYPE_CHECKING:
    from collections.abc import Iterable

    from rulelang.explain import Log
    from rulelang.program import Program
    from rulelang.watch import Watch

Fired = list[tuple[CompiledRule, list[tuple[Any, ...]]]]
FOULS, POINTS, TURN, TABLE, NEXT_SHOT, ENDING = range(1, 7)


def ask(program: Program, c: Watch, stage: int, log: Log | None) -> Fired:
    """Return the rules of a section that fired and are not overridden, with their decisions."""
    if log is not None:
        log.look(c)
    c.stage = stage
    name = SECTIONS[stage]
    fired = fire(rules_of(program, name, c.phase), c)
    beaten: dict[int, CompiledRule] = {}
    if fired:
        fired, beaten = override(fired)
    if log is not None:
        log.rules.append((program.compiled[name], fired, beaten))
    return fired


def rules_of(program: Program, section: str, phase: str) -> tuple[CompiledRule, ...]:
    """Return the rules of a section that can fire in a phase."""
    found = program.by_phase[section].get(phase) if section in program.by_phase else None
    if found is not None:
        return found
    rules = program.compiled.get(section, ())
    return tuple(rule for rule in rules if rule.phases is None or phase in rule.phases)


def fire(rules: Iterable[CompiledRule], c: Watch) -> Fired:
    """Return the rules that fire, with their decisions."""
    fired: Fired = []
    facts = c.facts
    for rule in rules:
        if facts & rule.asked != rule.there or (rule.any and not facts & rule.any):
            continue
        made = rule.run(c)
        if made is not None:
            fired.append((rule, made))
    return fired


def override(fired: Fired) -> tuple[Fired, dict[int, CompiledRule]]:
    """Withdraw the rules that a rule in force overrides; overrides have no circles."""
    overriding = [rule for rule, _ in fired if rule.overrides]
    if not overriding:
        return fired, {}
    beaten: dict[int, CompiledRule] = {}
    settled = False
    while not settled:
        now: dict[int, CompiledRule] = {}
        for rule in overriding:
            if rule.number not in beaten:
                for number in rule.overrides:
                    now.setdefault(number, rule)
        settled = now.keys() == beaten.keys()
        beaten = now
    return [(rule, made) for rule, made in fired if rule.number not in beaten], beaten


def judge_fouls(program: Program, c: Watch, log: Log | None) -> None:
    """Ask the rules of the fouls; those that speak of fouls see what the others left."""
    c.stage = FOULS
    early = fire(rules_of(program, "fouls", c.phase), c)
    fired, beaten = override(early)
    c.rule_on(_fouls(fired))
    late_rules = rules_of(program, "late fouls", c.phase)
    if late_rules:
        forget(c)
        fired, beaten = override(early + fire(late_rules, c))
        c.rule_on(_fouls(fired))
    if log is not None:
        log.rules.append(
            ((*program.compiled["fouls"], *program.compiled["late fouls"]), fired, beaten)
        )
    forget(c)


def _fouls(fired: Fired) -> tuple[Foul, ...]:
    if not fired:
        return ()
    found: dict[str, Foul] = {}
    alone: dict[str, Foul] = {}
    for rule, made in fired:
        for d in made:
            if d[0] != "foul":
                continue
            foul = Foul(d[1], d[2], rule.info.name, rule.info.cites)
            table = alone if d[3] else found
            if d[1] not in table or table[d[1]].worth < d[2]:
                table[d[1]] = foul
    return tuple((alone or found).values())
