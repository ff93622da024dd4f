"""What can be proved or suspected of a script as a whole, beyond its names and overrides.

One idea: a rule decides under the statements that its condition joins by `and`, in its phases;
whatever follows from that alone is told before anybody plays.
Invariant: an error here happens in some shot; what only looks wrong is a warning.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang import syntax as s
from rulelang.closures import singles
from rulelang.code import Mistake
from rulelang.frozen import value
from rulelang.syntax.plain import plain

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from rulelang.code import Code
    from rulelang.declarations import Declarations
    from rulelang.program import CompiledRule
    from rulelang.scope import Scope

    Ruled = tuple[s.Script, s.Rule, CompiledRule, list[Code]]
    Tell = Callable[..., None]


_MOST_PAIRS = 100_000
"""How many pairs of decisions are compared; no game for people has a hundredth of them."""


@value
class _Deed:
    """One decision with one value: under which statements, what about, and which value."""

    script: s.Script
    rule: s.Rule
    given: frozenset[str]
    phases: frozenset[str] | None
    about: tuple[str, ...]
    value: str


def clashes(rules: list[Ruled], tell: Tell) -> None:
    """Tell of two rules that decide one thing differently wherever the second one fires."""
    deeds: dict[tuple[str, ...], dict[str, list[_Deed]]] = {}
    patience = _MOST_PAIRS
    overriding = {(rule.name, name) for _, rule, _, _ in rules for name, _ in rule.overrides}
    for script, rule, compiled, _ in rules:
        for given, action in _decided(rule):
            about = (compiled.info.section, *_about(action))
            phases = frozenset(rule.phases) or None
            one = _Deed(script, rule, given, phases, about, plain(action))
            by_value = deeds.setdefault(about, {})
            others = [two for value, some in by_value.items() if value != one.value for two in some]
            patience -= len(others)
            if patience < 0:
                return
            clash = next((two for two in others if _clash(one, two, overriding)), None)
            if clash is not None:
                _tell_clash(one, clash, tell)
            by_value.setdefault(one.value, []).append(one)


def _clash(one: _Deed, two: _Deed, overriding: set[tuple[str, str]]) -> bool:
    if one.rule.at == two.rule.at and one.script is two.script:
        return False
    if not (one.given <= two.given or two.given <= one.given):
        return False
    if one.phases is not None and two.phases is not None and not one.phases & two.phases:
        return False
    names = (one.rule.name, two.rule.name)
    return not {names, names[::-1]} & overriding


def _tell_clash(one: _Deed, two: _Deed, tell: Tell) -> None:
    other = f'"{two.rule.name}"' if two.rule.name else "another rule"
    place = f"line {two.rule.at.line}"
    if two.script is not one.script:
        place = f"{two.script.file}, {place}"
    message = f"this rule and {other} ({place}) decide differently"
    name = two.rule.name or "..."
    mend = f'say `overrides "{name}"`, or change a condition'
    tell(one.script, Mistake("R401", one.rule.at, message, mend))


def _decided(rule: s.Rule) -> list[tuple[frozenset[str], Any]]:
    """Return the decisions at the top of a rule, with the statements they are made under."""
    found: list[tuple[frozenset[str], Any]] = []
    for node in rule.body:
        pairs: list[tuple[Any, Any]] = [(None, node)]
        if isinstance(node, s.If):
            pairs = [(node.branches[0][0], inner) for inner in node.branches[0][1]]
        found.extend((_joined(c), a) for c, a in pairs if _about(a))
    return found


def _joined(condition: s.Expr | None) -> frozenset[str]:
    if condition is None:
        return frozenset()
    if isinstance(condition, s.Junction) and condition.word == "and":
        return frozenset().union(*(_joined(part) for part in condition.parts))
    return frozenset({plain(condition)})


def _about(action: Any) -> tuple[str, ...]:
    """Return what an action decides, where that has one value."""
    if isinstance(action, s.Turn | s.GoToPhase | s.GiveInHand):
        return (type(action).__name__,)
    if isinstance(action, s.Write) and action.verb in ("set", "assign", "reset"):
        return ("Write", action.name, plain(action.who))
    return ()


def _ends(rules: list[Ruled]) -> bool:
    """Tell whether any rule ends a game or match."""
    return any(isinstance(node, s.Win) for _, rule, _, _ in rules for node in s.walk(rule.body))


def shut_phases(declarations: Declarations, rules: list[Ruled], tell: Tell) -> None:
    """Warn of phases in which no rule can end the game or lead on, where others can."""
    ways: list[frozenset[str] | None] = []
    if not _ends(rules):
        return
    for _, rule, compiled, _ in rules:
        for node in s.walk(rule.body):
            if isinstance(node, s.Win):
                ways.append(compiled.phases)
            elif isinstance(node, s.GoToPhase):
                every = compiled.phases or frozenset(declarations.scope.phases)
                ways.append(every - {node.phase})
    if None in ways:
        return
    out = frozenset[str]().union(*(way for way in ways if way is not None))
    for script, name, at in declarations.phase_places:
        if name not in out:
            message = (
                f'there is no way out of the phase "{name}": no rule leads on or ends the game'
            )
            mend = "say `go to phase ...` or `... wins game` in a rule for it"
            tell(script, Mistake("R411", at, message, mend), "warning")


def homeless(scope: Scope, rules: list[Ruled], tell: Tell) -> None:
    """Warn of balls that are to go to their own spot and have none."""
    for script, rule, _, _ in rules:
        for node in s.walk(rule.body):
            if isinstance(node, s.SpotBalls):
                _homeless(scope, script, node, tell)


def _homeless(scope: Scope, script: s.Script, node: s.SpotBalls, tell: Tell) -> None:
    vocabulary = scope.vocabulary
    kinds = {place.kind for place in node.places}
    spots = {ball.name: ball.spot for ball in vocabulary.balls}
    homes = any(isinstance(one, s.Home) for one in _declared(scope))
    if not vocabulary.spots and kinds & {"own", "near-own"}:
        message, mend = "this table has no spots", "give the variant a spot: [table.spots]"
        tell(script, Mistake("R412", node.at, message, mend), "warning")
    elif "home" in kinds and not homes:
        message, mend = "no ball has a home", "declare it: home of ... is SPOT"
        tell(script, Mistake("R412", node.at, message, mend), "warning")
    elif [place.kind for place in node.places] == ["own"] and not homes:
        without = [name for name in _members(scope, node.balls) if not spots.get(name)]
        if without:
            message = f'"{without[0]}" has no spot of its own'
            mend = f"give it one in the variant, or say `at {vocabulary.spots[0]}`"
            tell(script, Mistake("R412", node.at, message, mend), "warning")


def _declared(scope: Scope) -> Iterator[Any]:
    seen: set[int] = set()
    for owner in (*scope.owners.values(), *scope.scripts):
        if id(owner) not in seen:
            seen.add(id(owner))
            yield from owner.declarations


def _members(scope: Scope, node: s.Expr) -> list[str]:
    """Return the balls that a plain name stands for."""
    if isinstance(node, s.BallNumber):
        return [node.name]
    if not isinstance(node, s.Name) or node.name in scope.defines:
        return []
    mask = scope.bits.get(node.name) or scope.group(node.name) or 0
    names = {bit: name for name, bit in scope.bits.items()}
    return [names[bit] for bit in singles(mask & scope.balls)]


def stuck(scope: Scope, rules: list[Ruled], tell: Tell) -> None:
    """Tell of states in which nobody can move: calls nobody can make, players all out."""
    ends = _ends(rules)
    for script, rule, _, _ in rules:
        for node in s.walk(rule.body):
            if isinstance(node, s.Require) and node.verb == "require":
                _impossible(scope, script, node, tell)
            if isinstance(node, s.Seat) and node.verb == "eliminate" and not ends:
                message = "players go out, but no rule ends the game"
                mend = "say who wins: `if ...: leader wins game`"
                tell(script, Mistake("R414", node.at, message, mend), "warning")


def _impossible(scope: Scope, script: s.Script, node: s.Require, tell: Tell) -> None:
    things = {"pocket": scope.vocabulary.pockets, "group": tuple(scope.groups)}
    words = node.what.split()
    open_ = [word for word in words if word not in ("and", "or") and things.get(word, ("",))]
    lacking = [word for word in words if word in things and not things[word]]
    if lacking and ("or" not in words or not open_):
        message = f"nobody can call a {lacking[0]}: this table has none"
        mend = "drop the call, or allow it in another game"
        tell(script, Mistake("R413", node.at, message, mend))
