"""Conditions, compiled: `and`, `or`, `not`, and everything that stands after `is`.

One idea: the left side's kind decides what may stand on the right; a set of balls is compared
by its members. Invariant: a condition's closure returns a bool.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang import code as k
from rulelang import syntax as s
from rulelang.closures import constant_name, joined, kind_mend
from rulelang.code import Code, Mistake
from rulelang.events_told import fits_set
from rulelang.scope import nearest
from rulelang.signs import FOUL, LEGAL, UNKNOWN, Signs, exactly, of_all, of_any, opposite
from rulelang.watch import at_cushion, lie_in, together, touching

if TYPE_CHECKING:
    from collections.abc import Callable

    from rulelang.expressions import Expressions
    from rulelang.watch import Watch


def _at_least(a: k.Run, b: k.Run, number: int | None) -> k.Run:
    return (lambda c: a(c) >= b(c)) if number is None else (lambda c: a(c) >= number)


def _at_most(a: k.Run, b: k.Run, number: int | None) -> k.Run:
    return (lambda c: a(c) <= b(c)) if number is None else (lambda c: a(c) <= number)


def _more(a: k.Run, b: k.Run, number: int | None) -> k.Run:
    return (lambda c: a(c) > b(c)) if number is None else (lambda c: a(c) > number)


def _fewer(a: k.Run, b: k.Run, number: int | None) -> k.Run:
    return (lambda c: a(c) < b(c)) if number is None else (lambda c: a(c) < number)


_COMPARISONS: dict[str, Callable[[k.Run, k.Run, int | None], k.Run]] = {
    "at least": _at_least,
    "at most": _at_most,
    "more than": _more,
    "fewer than": _fewer,
}


class Conditions:
    """Compiles the conditions of one Expressions."""

    def __init__(self, expressions: Expressions) -> None:
        self.x = expressions

    def junction(self, node: s.Junction) -> Code:
        """Compile `and`, `or`."""
        parts = [self.x.truth(part) for part in node.parts]
        tests = tuple(part.truth for part in parts)
        made = Code(k.FLAG, _all(tests) if node.word == "and" else _any(tests))
        made.truth = made.run
        made.word = node.word
        made.parts = tuple(parts)
        made.signs = (of_all if node.word == "and" else of_any)([part.signs for part in parts])
        return joined(made, *parts)

    def negation(self, node: s.Not) -> Code:
        """Compile `not`."""
        part = self.x.truth(node.part)
        test = part.truth
        assert test is not None  # noqa: S101
        made = Code(k.FLAG, lambda c: not test(c), word="not", parts=(part,))
        made.truth = made.run
        if part.within is not None:
            within = part.within
            made.within = lambda c, lo, hi: not within(c, lo, hi)
        made.signs = opposite(part.signs)
        return joined(made, part)

    def compare(self, node: s.Is) -> Code:
        """Compile `A is [not] TEST`."""
        subject = node.subject
        if isinstance(subject, s.Quantified):
            made = self._quantified_is(node, subject)
        else:
            made = self._plain_is(node, self.x.value(subject))
        if node.negated and not isinstance(subject, s.Quantified):
            run = made.run
            made.run = lambda c: not run(c)
            made.signs = self._denied(made.signs)
        made.truth = made.run
        return made

    def _denied(self, signs: Signs) -> Signs:
        if signs.phases is None:
            return opposite(signs)
        return Signs(phases=frozenset(self.x.scope.phases) - signs.phases)

    def _quantified_is(self, node: s.Is, subject: s.Quantified) -> Code:
        base = self.x.want(subject.base, k.BALLS)
        test = self._members(node, base)
        whole, mask = base.run, test.run
        how, count, negated = subject.how, subject.count, node.negated
        signs = of_all([base.signs, test.signs]) if how == "any" and not negated else UNKNOWN

        def run(c: Watch) -> bool:
            all_of = whole(c)
            hit = mask(c) & all_of
            return fits_set(how, count, all_of & ~hit if negated else hit, all_of)

        if node.test.word in ("same", "one of"):
            return joined(Code(k.FLAG, run, shown=base, signs=signs), base, test)
        hits = Code(k.BALLS, lambda c: mask(c) & whole(c), text=self._written(node.test))
        return joined(Code(k.FLAG, run, shown=hits, signs=signs), base, test)

    def _written(self, test: s.Test) -> str:
        """Return a test as the script has it, on one line."""
        return " ".join(self.x.source[test.at.start : test.at.end].split())

    def _members(self, node: s.Is, base: Code) -> Code:
        """Compile the right side as the set of balls of which it is true."""
        test = node.test
        frozen = self.x.frozen
        match test.word:
            case "on table":
                return Code(k.BALLS, self.x.on_table())
            case "standing":
                return Code(k.BALLS, self.x.standing())
            case "in":
                zone = self.x.scope.place("zone", test.place or "", test.at)
                return Code(k.BALLS, lambda c: lie_in(c, zone, start=frozen))
            case "together in":
                zones = self.x.scope.zones(test.place or "", test.at)
                whole = base.run
                return Code(k.BALLS, lambda c: together(c, whole(c), zones, start=frozen))
            case "in hand":
                return Code(k.BALLS, self._in_hand(test))
            case "frozen to cushion":
                name = test.place
                if name is not None:
                    self.x.scope.place("cushion", name, test.at)
                return Code(k.BALLS, lambda c: at_cushion(c, name, start=frozen))
            case "touching":
                assert test.value is not None  # noqa: S101
                other = self.x.want(test.value, k.BALLS)
                run = other.run
                return joined(Code(k.BALLS, lambda c: touching(c, run, start=frozen)), other)
            case "same" | "one of":
                assert test.value is not None  # noqa: S101
                return self.x.want(test.value, k.BALLS)
        raise Mistake(
            "R302", test.at, f"`{base.text}` is {k.SPOKEN[base.kind]}, not a number",
            f"say `number of {base.text} is {test.word} ...`",
        )  # fmt: skip

    def _in_hand(self, test: s.Test) -> Callable[[Watch], int]:
        zone = test.place
        if zone is not None:
            self.x.scope.place("zone", zone, test.at)
        return lambda c: (
            (c.cue or -1)
            if c.situation.in_hand is not None and zone in (None, c.situation.in_hand)
            else 0
        )

    def _plain_is(self, node: s.Is, left: Code) -> Code:
        test = node.test
        if left.kind == k.SHOT:
            return self._shot_is(test, left)
        if left.kind == k.SCORES:
            return self._scores_are(test, left)
        if left.kind == k.FOULS:
            return self._foul_is(test, left)
        if test.word in _COMPARISONS:
            return self._number_is(test, left, node.subject)
        if left.kind == k.BALLS or test.word not in ("same", "one of"):
            return self._balls_are(node, left)
        if test.word == "one of":
            return self._name_is_one_of(test, left)
        return self._equal(test, left)

    def _shot_is(self, test: s.Test, left: Code) -> Code:
        value = test.value
        if isinstance(value, s.Name) and value.name == "legal":
            return joined(Code(k.FLAG, lambda c: c.legal, word="shot", signs=exactly(LEGAL)), left)
        if isinstance(value, s.Noun) and value.words == "foul":
            return joined(
                Code(k.FLAG, lambda c: not c.legal, word="shot", signs=exactly(FOUL)), left
            )
        raise Mistake("R302", test.at, "a shot is legal or foul", "say `shot is legal`")

    def _scores_are(self, test: s.Test, left: Code) -> Code:
        if isinstance(test.value, s.Name) and test.value.name == "level":
            return joined(Code(k.FLAG, lambda c: len(set(c.scores)) == 1), left)
        raise Mistake("R302", test.at, "scores are level, or not", "say `scores are level`")

    def _foul_is(self, test: s.Test, left: Code) -> Code:
        value = test.value
        names = value.items if isinstance(value, s.Listing) else (value,)
        wanted = set()
        for name in names:
            if not isinstance(name, s.Name):
                raise Mistake("R302", test.at, "a foul is known by its name", "say `foul is NAME`")
            if name.name not in self.x.scope.fouls:
                mend = nearest(name.name, self.x.scope.fouls) or "no rule finds this foul"
                raise Mistake("R201", name.at, f'"{name.name}" is not a foul', mend)
            wanted.add(name.name)

        def run(c: Watch) -> bool:
            for foul in c.fouls:  # noqa: SIM110 - a generator costs more than all of this
                if foul.name in wanted:
                    return True
            return False

        return joined(Code(k.FLAG, run, word="fouls", signs=Signs(FOUL)), left)

    def _number_is(self, test: s.Test, left: Code, subject: s.Expr) -> Code:
        if left.kind != k.NUMBER:
            raise Mistake(
                "R302",
                subject.at,
                f"`{left.text}` is {k.SPOKEN[left.kind]}, not a number",
                f"say `number of {left.text} is {test.word} ...`" if left.kind == k.BALLS else "",
            )
        assert test.value is not None  # noqa: S101
        right = self.x.want(test.value, k.NUMBER)
        run = _COMPARISONS[test.word](left.run, right.run, right.constant)
        made = Code(k.FLAG, run, shown=left, beside=right)
        return joined(made, left, right)

    def _balls_are(self, node: s.Is, left: Code) -> Code:
        if left.kind != k.BALLS:
            left = self.x.want(node.subject, k.BALLS)
        test, a = node.test, left.run
        if test.word == "same" and isinstance(test.value, s.Nothing):
            return joined(Code(k.FLAG, lambda c: a(c) == 0, shown=left), left)
        right = self._members(node, left)
        b = right.run
        made = Code(k.FLAG, lambda c: a(c) & b(c) != 0)
        made.signs = of_all([left.signs, right.signs])
        if test.word in ("same", "one of"):
            made.shown, made.beside = left, right
        return joined(made, left, right)

    def _name_is_one_of(self, test: s.Test, left: Code) -> Code:
        value = test.value
        items = value.items if isinstance(value, s.Listing) else (value,)
        codes = [self._right(item, left) for item in items if item is not None]
        constants = [code.constant for code in codes]
        a = left.run
        if None not in constants:
            table = frozenset(constants)
            signs = Signs(phases=table) if left.word == "phase" else UNKNOWN
            return joined(Code(k.FLAG, lambda c: a(c) in table, shown=left, signs=signs), left)
        runs = [code.run for code in codes]
        return joined(
            Code(k.FLAG, lambda c: a(c) in [run(c) for run in runs], shown=left), left, *codes
        )

    def _equal(self, test: s.Test, left: Code) -> Code:
        assert test.value is not None  # noqa: S101
        right = self._right(test.value, left)
        a, b, constant = left.run, right.run, right.constant
        if constant is not None:
            signs = Signs(phases=frozenset([constant])) if left.word == "phase" else UNKNOWN
            return joined(Code(k.FLAG, lambda c: a(c) == constant, shown=left, signs=signs), left)
        return joined(Code(k.FLAG, lambda c: a(c) == b(c), shown=left, beside=right), left, right)

    def _right(self, node: s.Expr, left: Code) -> Code:
        if isinstance(node, s.Nothing) and left.kind == k.NAME:
            return constant_name("none")
        domain = "" if left.kind != k.NAME else left.domain or "name"
        if isinstance(node, s.Name) and domain.startswith("fact "):
            self._check_fact_value(node, domain[5:])
        right = self.x.value(node, domain)
        if right.kind != left.kind:
            raise Mistake(
                "R302",
                node.at,
                f"`{left.text}` is {k.SPOKEN[left.kind]}, but `{right.text}` is"
                f" {k.SPOKEN[right.kind]}: they can never be equal",
                self._equal_mend(left, right),
            )
        return right

    def _equal_mend(self, left: Code, right: Code) -> str:
        fact = self.x.scope.facts.get(left.domain.removeprefix("fact "))
        if fact is not None and fact.values:
            return f"it is one of {', '.join(fact.values)}"
        return kind_mend(left.kind, right)

    def _check_fact_value(self, node: s.Name, fact: str) -> None:
        allowed = self.x.scope.facts[fact].values
        if allowed and node.name not in allowed:
            listed = f"it is one of {', '.join(allowed)}"
            raise Mistake(
                "R306", node.at, f'"{fact}" is never "{node.name}"',
                nearest(node.name, allowed) or listed,
            )  # fmt: skip


def _all(tests: tuple[Any, ...]) -> k.Run:
    if len(tests) == 2:
        a, b = tests
        return lambda c: a(c) and b(c)
    if len(tests) == 3:
        a, b, d = tests
        return lambda c: a(c) and b(c) and d(c)

    def run(c: Watch) -> bool:
        for test in tests:  # noqa: SIM110
            if not test(c):
                return False
        return True

    return run


def _any(tests: tuple[Any, ...]) -> k.Run:
    if len(tests) == 2:
        a, b = tests
        return lambda c: a(c) or b(c)
    if len(tests) == 3:
        a, b, d = tests
        return lambda c: a(c) or b(c) or d(c)

    def run(c: Watch) -> bool:
        for test in tests:  # noqa: SIM110
            if test(c):
                return True
        return False

    return run
