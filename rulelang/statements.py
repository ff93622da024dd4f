"""Branches, loops and offers, compiled to closures that write decisions.

One idea: a statement is a function of the watch that appends plain tuples and says whether it
did anything; what the tuples mean is the evaluator's business.
Invariant: running a statement changes nothing but the list it is given and `it`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rulelang import code as k
from rulelang import syntax as s
from rulelang.actions import ACTIONS, Decision
from rulelang.closures import singles
from rulelang.code import Code, Mistake
from rulelang.constructs import expressions_in
from rulelang.program import Consequence
from rulelang.signs import UNKNOWN
from rulelang.telling import Branches, Deed, Loop

if TYPE_CHECKING:
    from rulelang.scope import Scope
    from rulelang.telling import Outline
    from rulelang.watch import Watch

Run = Callable[["Watch", list[Decision]], bool]

SECTION_OF: dict[type, str] = {
    s.Foul: "fouls",
    s.Award: "points",
    s.Write: "points",
    s.Turn: "turn",
    s.GoToPhase: "turn",
    s.SpotBalls: "table",
    s.RemoveBalls: "table",
    s.RackAgain: "table",
    s.SetUpPins: "table",
    s.RestoreTable: "table",
    s.GiveInHand: "next shot",
    s.OfferChoices: "next shot",
    s.Require: "before shot",
    s.AllowStrike: "before shot",
    s.Win: "ending",
    s.Seat: "ending",
}
_ALSO: dict[type, tuple[str, ...]] = {
    s.Write: ("turn", "table", "next shot", "ending"),
    s.OfferChoices: ("before shot",),
    s.NothingHappens: (
        "before shot", "fouls", "points", "turn", "table", "next shot", "ending",
    ),
}  # fmt: skip


class Statements:
    """Compiles the statements of one rule."""

    def __init__(
        self, scope: Scope, source: str, section: str, rule: int, consequences: list[Consequence]
    ) -> None:
        self.x = expressions_in(scope, source)
        self.scope = scope
        self.section = section
        self.rule = rule
        self.consequences = consequences
        self.outline: list[Branches | Loop | Deed] = []
        self.codes: list[Code] = []
        self.late = False
        self.said: list[str] = []
        self.depth = 0
        self.free = False
        self.guard: tuple[Code, Run] | None = None
        self.signs = UNKNOWN
        self.troubles: list[Mistake] = []

    def body(self, nodes: tuple[s.Statement, ...]) -> Run:
        """Compile statements that follow each other."""
        self.depth += 1
        tried = [self._tried(node) for node in nodes]
        runs = [one for one in tried if one is not None]
        self.depth -= 1
        if len(runs) == 1:
            return runs[0]

        def run(c: Watch, out: list[Decision]) -> bool:
            did = False
            for one in runs:
                did = one(c, out) or did
            return did

        return run

    def _tried(self, node: s.Statement) -> Run | None:
        """Compile one statement; a mistake in it is kept, and hides none in the next."""
        depth, free = self.depth, self.free
        try:
            return self.statement(node)
        except Mistake as trouble:
            self.depth, self.free = depth, free
            self.troubles.append(trouble)
            return None

    def statement(self, node: s.Statement) -> Run:
        """Compile one statement."""
        if isinstance(node, s.If):
            return self._if(node)
        if isinstance(node, s.ForEach):
            return self._for_each(node)
        if not self.free:
            self._belongs(node)
        if isinstance(node, s.OfferChoices):
            return self._offer(node)
        known = len(self.codes)
        act = ACTIONS[type(node)](self, node)
        self.outline.append(Deed(_amount(node, self.codes[known:])))
        return _acting(act)

    def _under(self, nodes: tuple[s.Statement, ...]) -> tuple[Run, Outline]:
        """Compile a body, with its outline."""
        around, self.outline = self.outline, []
        run = self.body(nodes)
        inner, self.outline = tuple(self.outline), around
        return run, inner

    def _belongs(self, node: s.Statement) -> None:
        home = SECTION_OF.get(type(node), "")
        allowed = (home, *_ALSO.get(type(node), ()))
        moment = self.section.startswith(("game", "match", "turn ")) or " " in self.section
        if self.section in allowed or (moment and self.section not in ("before shot", "next shot")):
            return
        if isinstance(node, s.Plays):
            raise Mistake(
                "R305", node.at, "who plays is said by `turn`, or in the consequences of an option",
                "say `turn passes to ...`",
            )  # fmt: skip
        raise Mistake(
            "R305",
            node.at,
            f"this action does not belong to `{self.section}:`",
            f"move the rule to `{home}:`",
        )

    def value(self, node: s.Expr, kind: str, domain: str = "") -> Code:
        """Compile an operand and keep it for the checks of the rule."""
        made = self.x.want(node, kind, domain)
        if self.scope.probe is not None and isinstance(node, s.Number):
            made = self.scope.probe.number(made, self.x.source, node)
        self.codes.append(made)
        return made

    def _if(self, node: s.If) -> Run:
        pairs: list[tuple[Any, Run]] = []
        cases: list[tuple[Code, Outline]] = []
        outermost = self.depth <= 1 and not self.free
        for condition, body in node.branches:
            try:
                made = self.x.truth(condition)
            except Mistake as trouble:
                self.troubles.append(trouble)
                self.body(body)
                continue
            self.codes.append(made)
            self.late = self.late or made.fouls
            then, inner = self._under(body)
            pairs.append((made.truth, then))
            cases.append((made, inner))
        otherwise, left = self._otherwise(node.otherwise) if node.otherwise else (None, None)
        self.outline.append(Branches(tuple(cases), left))
        if len(pairs) == 1 and len(node.branches) == 1 and otherwise is None:
            test, then = pairs[0]
            if outermost:
                self.guard, self.signs = (made, then), made.signs
            return lambda c, out: then(c, out) if test(c) else False

        def run(c: Watch, out: list[Decision]) -> bool:
            for condition, body in pairs:
                if condition(c):
                    return body(c, out)
            return otherwise(c, out) if otherwise is not None else False

        return run

    def _otherwise(self, body: tuple[s.Statement, ...]) -> tuple[Run, Outline]:
        probe = self.scope.probe
        run, inner = self._under(body)
        if probe is None:
            return run, inner
        at = body[0].at
        inert = all(isinstance(one, s.NothingHappens) for one in body)
        text = self._text(body)
        return probe.body("otherwise", self.x.source, at, text, run, inert=inert), inner

    def _text(self, body: tuple[s.Statement, ...]) -> str:
        """Return what is written in a body, on one line."""
        return " ".join(self.x.source[body[0].at.start : body[-1].at.end].split())

    def _for_each(self, node: s.ForEach) -> Run:
        if node.over is None:
            body, inner = self._under(node.body)
            self.outline.append(Loop(None, inner))

            def players(c: Watch, out: list[Decision]) -> bool:
                did = False
                for player in range(1, c.players + 1):
                    c.burn()
                    c.player = player
                    did = body(c, out) or did
                return did

            return players
        over = self.value(node.over, k.BALLS)
        if self.depth <= 1 and not self.free and self.scope.probe is None:
            self.signs = over.signs
        balls = over.run
        body, inner = self._under(node.body)
        self.outline.append(Loop(over, inner))

        def run(c: Watch, out: list[Decision]) -> bool:
            did = False
            before = c.it
            for one in singles(balls(c)):
                c.burn()
                c.it = one
                did = body(c, out) or did
            c.it = before
            return did

        return run

    def _offer(self, node: s.OfferChoices) -> Run:
        who = self.value(node.who, k.PLAYER).run
        choices: list[tuple[Any, str, int]] = []
        for choice in node.choices:
            test = None
            if choice.condition is not None:
                made = self.x.truth(choice.condition)
                self.codes.append(made)
                test = made.truth
                self.outline.append(Branches(((made, (Deed(),)),), None))
            else:
                self.outline.append(Deed())
            if self.scope.probe is not None:
                test = self.scope.probe.offer(self.x.source, choice, test)
            choices.append((test, choice.option, self._consequence(choice, node.who)))
            self.scope.options.setdefault(choice.option)
            self.said.append(f"offers {choice.option}")

        def run(c: Watch, out: list[Decision]) -> bool:
            did = False
            for test, option, key in choices:
                if test is None or test(c):
                    out.append(("offer", who(c), option, key))
                    did = True
            return did

        return run

    def _consequence(self, choice: s.Choice, to: s.Expr) -> int:
        inner = Statements(self.scope, self.x.source, "consequence", self.rule, self.consequences)
        inner.free = True
        run = inner.body(choice.body)
        words = to.words if isinstance(to, s.Player) else "chooser"
        text = self._text(choice.body)
        if self.scope.probe is not None:
            inert = all(isinstance(one, s.NothingHappens) for one in choice.body)
            run = self.scope.probe.body(
                "choice", self.x.source, choice.at, choice.option, run, inert=inert
            )
        key = len(self.consequences)
        self.consequences.append(Consequence(key, choice.option, words, self.rule, run, text))
        return key


def _amount(node: s.Statement, read: list[Code]) -> Code | None:
    """Return the number or set without which an action does nothing; None where it always does."""
    counted = isinstance(node, s.Award) or (isinstance(node, s.Write) and node.verb == "add")
    if not counted and not isinstance(node, s.SpotBalls | s.RemoveBalls | s.SetUpPins):
        return None
    amount = read[-1] if isinstance(node, s.Write) else read[0]
    if isinstance(node, s.SetUpPins):
        pins = amount.run
        return Code(k.BALLS, lambda c: pins(c) & ~c.up_after, text=f"{amount.text} not standing")
    return None if amount.constant else amount


def _acting(act: Callable[[Watch], Decision | None]) -> Run:
    def run(c: Watch, out: list[Decision]) -> bool:
        made = act(c)
        if made is not None:
            out.append(made)
        return True

    return run
