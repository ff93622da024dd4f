"""Defines, compiled: the cases of a name, worked out when first read and then remembered.

One idea: a define has one Code for the whole program, two where it is also read frozen.
Invariant: a define that reads itself is told, by way of which others; none is compiled twice.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang import code as k
from rulelang import syntax as s
from rulelang.closures import chain, common_kind, derive, remembered
from rulelang.code import Code, Mistake

if TYPE_CHECKING:
    from rulelang.expressions import Expressions


DEEPEST = 40
"""How many defines may lean on each other in a row."""


def _too_deep(name: str, at: s.Span) -> Mistake:
    message = f'"{name}" is the last of more than {DEEPEST} defines that read each other in a row'
    return Mistake("R109", at, message, "say some of them in one")


def defined(x: Expressions, name: str, at: s.Span) -> Code:
    """Return the Code of a define, compiled on first use."""
    scope = x.scope
    scope.used.add(name)
    if name in scope.poisoned:
        raise Mistake("R201", at, "", silent=True)
    node = scope.defines[name]
    frozen = x.frozen or node.frozen
    key = (name, frozen)
    if key not in scope.compiled:
        if name in scope.busy:
            circle = ", ".join([*scope.busy[scope.busy.index(name) :], name])
            raise Mistake(
                "R405", at, f'"{name}" reads itself: by way of {circle}', "break the circle"
            )
        scope.busy.append(name)
        scope.below.append(0)
        try:
            if len(scope.busy) > DEEPEST:
                raise _too_deep(name, at)
            scope.compiled[key] = cases(x.inside(name, frozen=frozen), node)
        except Mistake as trouble:
            trouble.owner = trouble.owner or name
            scope.poisoned.add(name)
            raise
        finally:
            scope.busy.pop()
            scope.depths[name] = max(scope.depths.get(name, 0), 1 + scope.below.pop())
    if scope.below:
        scope.below[-1] = max(scope.below[-1], scope.depths.get(name, 1))
        if scope.below[-1] >= DEEPEST:
            raise _too_deep(name, at)
    made = scope.compiled[key]
    return derive(made, made.kind, made.run, truth=made.truth, domain=made.domain, signs=made.signs)


def cases(x: Expressions, node: s.Define) -> Code:
    """Compile a define to a remembered value."""
    tests = [None if c is None else x.truth(c) for c, _ in node.cases]
    kind, values = _of_one_kind(x, node)
    parts = [test for test in tests if test is not None] + values
    default: Any = {k.BALLS: 0, k.NUMBER: 0, k.FLAG: False, k.NAME: "none"}.get(kind)
    pairs = [
        (None if test is None else test.truth, value.run)
        for test, value in zip(tests, values, strict=True)
    ]
    staged = any(part.staged for part in parts)
    made = derive(
        values[0], kind, remembered(_slot(x, staged=staged), chain(pairs, default), staged=staged)
    )
    made.word = ""
    if len(node.cases) == 1:
        made.shown, made.word = values[0], "define"
        if tests[0] is None:
            made.signs = values[0].signs
    made.parts, made.constant, made.text = tuple(parts), None, node.name
    made.staged = staged
    made.since = max(part.since for part in parts)
    made.fouls = any(part.fouls for part in parts)
    if made.signs.exact:
        bit = made.signs.exact
        made.truth = lambda c: c.facts & bit != 0
    elif kind == k.BALLS:
        run = made.run
        made.truth = lambda c: run(c) != 0
    return made


def _of_one_kind(x: Expressions, node: s.Define) -> tuple[str, list[Code]]:
    """Return the values of all cases, and the kind they share; raise R301 where they do not."""
    values = [_case_value(x, value) for _, value in node.cases]
    kind = common_kind(values)
    if kind is None:
        found = " and ".join(sorted({k.SPOKEN[value.kind] for value in values}))
        raise Mistake("R301", node.at, f'the cases of "{node.name}" are {found}', "one kind")
    return kind, [
        x.want(written, kind) if value.kind != kind else value
        for (_, written), value in zip(node.cases, values, strict=True)
    ]


def _slot(x: Expressions, *, staged: bool) -> int:
    """Return a place of the memory, of its own for what is staged."""
    scope = x.scope
    if staged:
        scope.passing += 1
        return scope.passing - 1
    scope.lasting += 1
    return scope.lasting - 1


def _is_set(node: s.Expr) -> bool:
    """Tell whether an event stands for those it happened to, not for how many they are."""
    while isinstance(node, s.Happened):
        if isinstance(node.subject, s.Quantified):
            return node.subject.how == "any"
        if not isinstance(node.subject, s.Happened):
            return True
        node = node.subject
    return False


def _case_value(x: Expressions, node: s.Expr) -> Code:
    made = x.value(node)
    if made.truth is not None and not (_is_set(node) and made.kind == k.BALLS):
        counted = isinstance(node, s.Quantified | s.Happened)
        if made.kind == k.BALLS and not counted:
            return made
        flag = derive(
            made, k.FLAG, made.truth, truth=made.truth, signs=made.signs, witness=made.witness
        )
        return flag if isinstance(node, s.Name) else x.watched(flag, node)
    return made
