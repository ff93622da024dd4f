"""One expression compiled to a closure, of the kind that is asked for.

One idea: `Expressions.value` turns a tree into a Code by the table of constructs it was given,
and `want` asks for a kind; what was found and what fits is told where they differ.
Invariant: nothing is looked up by name at run time but tracked values, facts and settings.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang import code as k
from rulelang import syntax as s
from rulelang.closures import derive, kind_mend
from rulelang.code import Code, Mistake
from rulelang.frozen import value
from rulelang.scope import nearest

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from rulelang.scope import Scope
    from rulelang.watch import Watch


@value
class Constructs:
    """How each construct is compiled; a bare word with the sort of name that is preferred."""

    name: Callable[[Expressions, s.Name, str], Code]
    others: Mapping[type, Callable[[Expressions, Any], Code]]


class Expressions:
    """Compiles the expressions of one place; `frozen` reads the table before the shot."""

    def __init__(
        self, scope: Scope, source: str, constructs: Constructs, *, frozen: bool = False
    ) -> None:
        self.scope = scope
        self.source = source
        self.constructs = constructs
        self.frozen = frozen

    def inside(self, name: str, *, frozen: bool) -> Expressions:
        """Return the compiler for what is written where `name` is declared."""
        return Expressions(self.scope, self.scope.sources[name], self.constructs, frozen=frozen)

    def value(self, node: s.Expr, domain: str = "") -> Code:
        """Compile `node`; `domain` is the sort of name to prefer for a bare word."""
        if isinstance(node, s.Name):
            made = self.constructs.name(self, node, domain)
        else:
            made = self.constructs.others[type(node)](self, node)
        if not made.text:
            made.text = " ".join(self.source[node.at.start : node.at.end].split())
        return made

    def want(self, node: s.Expr, kind: str, domain: str = "") -> Code:
        """Compile `node` as `kind`, or raise R301 with what was found and what fits."""
        made = self.value(node, domain)
        if made.kind == kind:
            return made
        if kind == k.BALLS and made.kind in (k.NAME, k.NOTHING):
            return self._as_balls(node, made)
        if kind == k.NAME and made.kind == k.NOTHING:
            return derive(made, k.NAME, lambda _c: "none")
        raise Mistake(
            "R301",
            node.at,
            f"{k.SPOKEN[kind]} is due here, but `{made.text}` is {k.SPOKEN[made.kind]}",
            kind_mend(kind, made),
        )

    def _as_balls(self, node: s.Expr, made: Code) -> Code:
        if made.kind == k.NOTHING:
            return derive(made, k.BALLS, lambda _c: 0, constant=0)
        table = self.masks()
        if made.constant is not None and made.constant not in table and made.constant != "none":
            names = self.scope.known()
            raise Mistake(
                "R201", node.at, f'"{made.constant}" is no ball or group', nearest(made.text, names)
            )
        run = made.run
        if made.constant is not None:
            mask = table.get(made.constant, 0)
            return derive(made, k.BALLS, lambda _c: mask, constant=mask)
        return derive(made, k.BALLS, lambda c: table.get(run(c), 0))

    def masks(self) -> dict[str, int]:
        """Return the mask of every ball and group by name."""
        return {**self.scope.groups, **self.scope.bits}

    def truth(self, node: s.Expr) -> Code:
        """Compile `node` as a condition."""
        return self.watched(self.event(node), node)

    def watched(self, made: Code, node: s.Expr) -> Code:
        """Return a condition with a counter, where the program has a probe."""
        probe = self.scope.probe
        return made if probe is None else probe.condition(made, self.source, node)

    def event(self, node: s.Expr) -> Code:
        """Compile `node` as a condition that is part of another, as an event of a sequence is."""
        made = self.value(node)
        if made.truth is not None:
            return made
        run = made.run
        if made.kind == k.BALLS:
            made.truth = lambda c: run(c) != 0
        elif made.kind == k.FLAG:
            made.truth = run
        else:
            raise Mistake(
                "R301",
                node.at,
                f"a condition is due here, but `{made.text}` is {k.SPOKEN[made.kind]}",
                f"say what it should be: `{made.text} is ...`",
            )
        return made

    def on_table(self) -> Callable[[Watch], int]:
        """Return the closure for the balls on the table, before or after the shot."""
        if self.frozen:
            return lambda c: c.on_before
        return lambda c: c.on_after

    def standing(self) -> Callable[[Watch], int]:
        """Return the closure for the pins that stand, before or after the shot."""
        if self.frozen:
            return lambda c: c.up_before
        return lambda c: c.up_after

    def after_shot(self, node: s.Expr, words: str) -> None:
        """Raise R409 where `words` is read before there is a shot."""
        if self.frozen:
            raise Mistake(
                "R409",
                node.at,
                f'a define "before shot" cannot read `{words}`',
                "drop `before shot` from the define",
            )
