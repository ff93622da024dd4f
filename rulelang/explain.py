"""Why each rule fired, was silent or was overridden, told only when somebody asks.

One idea: the judgement keeps what each section saw, and an explanation reads it again; nothing
is written while a shot is judged. Invariant: reading an explanation twice tells the same.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, overload

from rulelang.closures import forget
from rulelang.decisions import RuleOutcome
from rulelang.program import STAGE
from rulelang.telling import balls, why
from rulelang.watch import FUEL, Nobody

if TYPE_CHECKING:
    from rulelang.program import CompiledRule, RuleInfo
    from rulelang.watch import Watch


class Log:
    """What is kept of a judgement for its explanation: how rules fared, what sections saw."""

    __slots__ = ("closings", "rules", "views")

    def __init__(self) -> None:
        self.rules: list[tuple[tuple[CompiledRule, ...], Any, Any]] = []
        self.views: list[tuple[Any, ...]] = []
        self.closings: list[tuple[tuple[CompiledRule, ...], Any, Any, tuple[Any, ...], int]] = []
        """Of the rules asked when a game or the match had ended: with what they saw, who won."""

    def look(self, c: Watch) -> None:
        """Keep what a section sees."""
        self.views.append(_view(c))

    def close(self, rules: tuple[CompiledRule, ...], fired: Any, beaten: Any, c: Watch) -> None:
        """Keep how rules fared that were asked at an end."""
        self.closings.append((rules, fired, beaten, _view(c), c.winner))


def _view(c: Watch) -> tuple[Any, ...]:
    return (
        c.fouls, c.legal, c.state, c.scores, c.next_phase, c.next_player, c.continues, c.actions,
        c.homes,
    )  # fmt: skip


class Explanation(Sequence[RuleOutcome]):
    """The outcomes of a judgement's rules, rendered on first use."""

    __slots__ = ("_log", "_outcomes", "_watch")

    def __init__(self, watch: Watch, log: Log) -> None:
        self._watch = watch
        self._log = log
        self._outcomes: tuple[RuleOutcome, ...] | None = None

    @overload
    def __getitem__(self, index: int) -> RuleOutcome: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[RuleOutcome]: ...
    def __getitem__(self, index: int | slice) -> RuleOutcome | Sequence[RuleOutcome]:
        return self.outcomes()[index]

    def __len__(self) -> int:
        asked = [rules for rules, _, _ in self._log.rules]
        return sum(map(len, [*asked, *(one[0] for one in self._log.closings)]))

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
            over = _ender(self._log.rules)
            self._outcomes = (*self._asked(over), *self._closed())
        return self._outcomes

    def _asked(self, over: str) -> Iterator[RuleOutcome]:
        for rules, fired, beaten in self._log.rules:
            for rule in rules:
                stage = max(0, rule.stage - 2)
                self._look(self._log.views[stage], nothing_yet=rule.stage == 1 and not rule.late)
                yield self._tell(rule, *_in_force(rule, over, *self._fared(rule, fired, beaten)))

    def _closed(self) -> Iterator[RuleOutcome]:
        """Return how those rules fared that were asked at the end of a game or the match."""
        for rules, fired, beaten, view, winner in self._log.closings:
            for rule in rules:
                self._look(view)
                self._watch.winner = winner
                outcome, detail = self._fared(rule, fired, beaten)
                mute = not winner and outcome == "silent" and self._needs_winner(rule)
                yield self._tell(rule, outcome, "nobody won" if mute else detail)

    def _needs_winner(self, rule: CompiledRule) -> bool:
        try:
            rule.run(self._watch)
        except Nobody:
            return True
        return False

    def _tell(self, rule: CompiledRule, outcome: str, detail: Any) -> RuleOutcome:
        c = self._watch
        events: tuple[int, ...] = ()
        said: tuple[str, ...] = ()
        if isinstance(detail, str):
            because = detail
        else:
            because, events = why(rule.outline, c, fired=outcome == "fired")
        if outcome == "fired":
            said = tuple(said_of(c, one) for one in detail if not _is_empty(c, one))
        return outcome_of(rule.info, outcome, because, events, said)

    def _fared(self, rule: CompiledRule, fired: Any, beaten: Any) -> tuple[str, Any]:
        """Return how a rule fared, and its decisions or why it was overridden."""
        for other, made in fired:
            if other.number == rule.number:
                nothing = made and all(_is_empty(self._watch, one) for one in made)
                return ("silent", None) if nothing else ("fired", made)
        if rule.number in beaten:
            return "overridden", f'overridden by "{beaten[rule.number].info.name}"'
        return "silent", None

    def _look(self, view: tuple[Any, ...], *, nothing_yet: bool = False) -> None:
        """Set the watch to what a section saw; rules of the fouls begin with none."""
        c = self._watch
        c.fuel = FUEL
        (
            c.fouls, c.legal, c.state, c.scores, c.next_phase, c.next_player, c.continues,
            c.actions, c.homes,
        ) = view  # fmt: skip
        if nothing_yet:
            c.fouls, c.legal = (), True
        forget(c)


def outcome_of(
    info: RuleInfo, outcome: str, because: str, events: tuple[int, ...], said: tuple[str, ...]
) -> RuleOutcome:
    """Return how a rule fared."""
    return RuleOutcome(
        info.name, info.section, info.cites, outcome, because, events, said, info.line, info.file
    )


def _ender(log: Any) -> str:
    """Return the rule that ended the game, "" where it goes on."""
    _, fired, _ = log[-1]
    return next((rule.info.name for rule, made in fired for one in made if one[0] == "end"), "")


def _in_force(rule: CompiledRule, over: str, outcome: str, detail: Any) -> tuple[str, Any]:
    """Return what stands of a rule's decisions: when the game is over, nothing comes next."""
    if not over or outcome != "fired" or not detail:
        return outcome, detail
    left = [one for one in detail if one[0] not in VOID]
    if left or rule.stage == STAGE["ending"]:
        return outcome, left or detail
    return "overridden", f'void: "{over}" ended the game'


VOID = ("turn", "phase", "hand", "offer", "rerack")
"""What is void when the game is over."""


def _is_empty(c: Watch, decision: tuple[Any, ...]) -> bool:
    """Tell whether a decision is one of nothing: no points, no balls, pins that stand."""
    tag = decision[0]
    if tag == "points":
        return bool(decision[2] == 0)
    if tag == "write":
        return bool(decision[1] == "add" and decision[4] == 0)
    if tag == "set up":
        return not decision[1] & ~c.up_after
    return tag in ("spot", "remove", "strike") and decision[1] == 0


def said_of(c: Watch, decision: tuple[Any, ...]) -> str:
    """Return what a rule decided, in the words of a script."""
    tag, *rest = decision
    match tag:
        case "foul":
            return f"foul {rest[0]}" + (f", {rest[1]}" if rest[1] else "")
        case "points":
            side = "the side of " if c.mates > 1 else ""
            return f"{rest[1]:+d} to {side}player {rest[0]}"
        case "write":
            return _written(*rest)
        case "turn":
            passes = "turn passes" + (f" to player {rest[1]}" if rest[1] else "")
            return "turn continues" if rest[0] else passes
        case "phase":
            return f"go to phase {rest[0]}"
        case "spot" | "remove":
            return f"{tag} " + balls(c, rest[0])
        case "set up":
            return "set up " + balls(c, rest[0] & ~c.up_after)
        case "hand":
            return f"player {rest[0]} has the cue ball in hand in {rest[1]}"
        case "offer":
            return f"player {rest[0]} may choose {rest[1]}"
        case "end":
            return f"player {rest[1]} wins the {rest[0]}" if rest[1] else f"the {rest[0]} is tied"
        case "plays":
            return f"player {rest[0]} plays"
        case "restore":
            return "everything back as before the stroke"
        case "seat":
            return f"player {rest[0]} is {'out' if rest[1] else 'back in'}"
        case _:
            return str(tag)


def _written(op: str, name: str, player: int | None, value: Any) -> str:
    whose = "" if player is None else f" of player {player}"
    told = {True: "yes", False: "no"}.get(value, value) if isinstance(value, bool) else value
    if op == "add":
        return f"add {told} to {name}{whose}"
    return f"{op} {name}{whose}" + ("" if value is None else f" to {told}")
