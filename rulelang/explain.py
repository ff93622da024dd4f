"""Why each rule fired, was silent or was overridden, told only when somebody asks.

One idea: the judgement keeps what each section saw, and an explanation reads it again; nothing
is written while a shot is judged. Invariant: reading an explanation twice tells the same.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, overload

from rulelang import code as k
from rulelang.closures import clear, names_of
from rulelang.decisions import RuleOutcome
from rulelang.watch import BEGIN, END

if TYPE_CHECKING:
    from rulelang.code import Code
    from rulelang.program import CompiledRule, Program
    from rulelang.watch import Watch


class Explanation(Sequence[RuleOutcome]):
    """The outcomes of a judgement's rules, rendered on first use."""

    __slots__ = ("_log", "_outcomes", "_program", "_views", "_watch")

    def __init__(self, program: Program, watch: Watch, log: Any, views: Any) -> None:
        self._program = program
        self._watch = watch
        self._log = log
        self._views = views
        self._outcomes: tuple[RuleOutcome, ...] | None = None

    @overload
    def __getitem__(self, index: int) -> RuleOutcome: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[RuleOutcome]: ...
    def __getitem__(self, index: int | slice) -> RuleOutcome | Sequence[RuleOutcome]:
        return self.outcomes()[index]

    def __len__(self) -> int:
        return sum(len(rules) for rules, _, _ in self._log)

    def __iter__(self) -> Iterator[RuleOutcome]:
        return iter(self.outcomes())

    def __eq__(self, other: object) -> bool:
        return tuple(self) == tuple(other) if isinstance(other, Sequence) else NotImplemented

    def __hash__(self) -> int:
        return hash(self.outcomes())

    def __reduce__(self) -> tuple[Any, ...]:
        return (tuple, (self.outcomes(),))

    def outcomes(self) -> tuple[RuleOutcome, ...]:
        """Return every outcome, in the order of sections and script."""
        if self._outcomes is None:
            self._outcomes = tuple(
                self._tell(rule, *_fared(rule, fired, beaten))
                for rules, fired, beaten in self._log
                for rule in rules
            )
        return self._outcomes

    def _tell(self, rule: CompiledRule, outcome: str, detail: Any) -> RuleOutcome:
        c = self._watch
        self._look(rule.stage, late=rule.late)
        because = ""
        events: tuple[int, ...] = ()
        if outcome == "overridden":
            because = f'overridden by "{detail.info.name}"'
        elif outcome == "fired":
            because, events = _fired(rule, c)
        else:
            because = _silent(rule, c)
        said = tuple(_said(c, one) for one in detail) if outcome == "fired" else ()
        info = rule.info
        return RuleOutcome(
            info.name,
            info.section,
            info.cites,
            outcome,
            because,
            events,
            said,
            info.line,
            info.file,
        )

    def _look(self, stage: int, *, late: bool) -> None:
        """Set the watch to what a section saw."""
        c = self._watch
        view = self._views[max(0, stage - 2)] if self._views else None
        if view is not None:
            (
                c.fouls, c.legal, c.state, c.scores, c.next_phase, c.next_player, c.continues,
                c.actions, c.homes,
            ) = view  # fmt: skip
        if stage == 1 and not late:
            c.fouls, c.legal = (), True
        clear(c.memo, self._program.staged)


def _fared(rule: CompiledRule, fired: Any, beaten: Any) -> tuple[str, Any]:
    """Return how a rule fared, and its decisions or the rule that overrode it."""
    for other, made in fired:
        if other.number == rule.number:
            return "fired", made
    if rule.number in beaten:
        return "overridden", beaten[rule.number]
    return "silent", None


def _fired(rule: CompiledRule, c: Watch) -> tuple[str, tuple[int, ...]]:
    for condition in rule.conditions:
        if condition.truth is not None and condition.truth(c):
            return _told(condition, c, holds=True), tuple(sorted(set(_events(condition, c))))
    return "otherwise" if rule.conditions else "always", ()


def _silent(rule: CompiledRule, c: Watch) -> str:
    reasons = [_told(one, c, holds=False) for one in rule.conditions]
    return "; ".join(reasons) or "nothing to do"


def _told(code: Code, c: Watch, *, holds: bool) -> str:
    """Tell the parts that made a condition true, or the first that made it false."""
    if code.word == "and":
        parts = [p for p in code.parts if bool(_true(p, c)) == holds]
        parts = parts if holds else parts[:1]
        return "; ".join(_told(p, c, holds=holds) for p in parts)
    if code.word == "or":
        parts = [p for p in code.parts if bool(_true(p, c)) == holds]
        parts = parts[:1] if holds else parts
        return "; ".join(_told(p, c, holds=holds) for p in parts)
    if code.word == "not":
        return f"{code.text}: {'yes' if holds else 'no'}"
    if code.shown is not None and code.word != "define":
        return f"{code.text}: {code.shown.text} was {_value(code.shown, c)}"
    return f"{code.text}: {'yes' if holds else 'no'}"


def _true(code: Code, c: Watch) -> bool:
    return code.truth is not None and bool(code.truth(c))


def _value(code: Code, c: Watch) -> str:
    value = code.run(c)
    if code.kind == k.BALLS:
        return ", ".join(sorted(names_of(c, value))) or "nothing"
    if code.kind == k.FLAG:
        return "yes" if value else "no"
    if code.kind == k.PLAYER:
        return f"player {value}"
    return str(value)


def _events(code: Code, c: Watch) -> list[int]:
    if code.witness is not None:
        return [n for n in code.witness(c, BEGIN, END) if 0 <= n < END]
    if code.word == "not":
        return []
    parts = [*code.parts, *([code.shown] if code.shown is not None else [])]
    return [n for part in parts if _true(part, c) or part.truth is None for n in _events(part, c)]


def _said(c: Watch, decision: tuple[Any, ...]) -> str:
    tag, *rest = decision
    match tag:
        case "foul":
            return f"foul {rest[0]}" + (f", {rest[1]}" if rest[1] else "")
        case "points":
            return f"{rest[1]:+d} to player {rest[0]}"
        case "write":
            whose = "" if rest[2] is None else f" of player {rest[2]}"
            return f"{rest[0]} {rest[1]}{whose}" + ("" if rest[3] is None else f" to {rest[3]}")
        case "turn":
            passes = "turn passes" + (f" to player {rest[1]}" if rest[1] else "")
            return "turn continues" if rest[0] else passes
        case "phase":
            return f"go to phase {rest[0]}"
        case "spot" | "remove":
            return f"{tag} " + ", ".join(sorted(names_of(c, rest[0])))
        case "set up":
            return "set up " + ", ".join(sorted(names_of(c, rest[0])))
        case "hand":
            return f"player {rest[0]} has the cue ball in hand in {rest[1]}"
        case "offer":
            return f"player {rest[0]} may choose {rest[1]}"
        case "end":
            return f"player {rest[1]} wins the {rest[0]}" if rest[1] else f"the {rest[0]} is tied"
        case "seat":
            return f"player {rest[0]} is {'out' if rest[1] else 'back in'}"
        case _:
            return str(tag)
