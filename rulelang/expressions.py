"""Nouns, numbers and conditions, compiled to closures with their kinds checked.

One idea: `Expressions.value` turns a tree into a Code, and `want` asks for a kind; what was
found and what fits is told where they differ. Invariant: nothing is looked up by name at run
time but tracked values, facts and settings.
"""

from __future__ import annotations

import operator
from typing import TYPE_CHECKING, Any

from rulelang import code as k
from rulelang import syntax as s
from rulelang.chance import draw
from rulelang.closures import (
    chain,
    common_kind,
    constant_name,
    derive,
    joined,
    kind_mend,
    leader,
    names_of,
    opponent,
    remembered,
    singles,
)
from rulelang.code import Code, Mistake
from rulelang.conditions import Conditions
from rulelang.happenings import Happenings
from rulelang.program import STAGE
from rulelang.scope import nearest

if TYPE_CHECKING:
    from collections.abc import Callable

    from rulelang.scope import Scope
    from rulelang.watch import Watch

ORDINALS = {"first": 0, "second": 1, "third": 2, "last": -1}
MOST = 10**12
"""No number of a script grows beyond this, either way."""


def _bounded(op: Callable[[int, int], int]) -> Callable[[int, int], int]:
    return lambda a, b: max(-MOST, min(MOST, op(a, b)))


_ARITHMETIC: dict[str, Callable[[int, int], int]] = {
    "plus": operator.add,
    "minus": operator.sub,
    "times": _bounded(operator.mul),
}


class Expressions:
    """Compiles the expressions of one place; `frozen` reads the table before the shot."""

    def __init__(self, scope: Scope, source: str, *, frozen: bool = False) -> None:
        self.scope = scope
        self.source = source
        self.frozen = frozen
        self.happenings = Happenings(self)
        self.conditions = Conditions(self)

    # -- kinds ---------------------------------------------------------------

    def value(self, node: s.Expr, domain: str = "") -> Code:
        """Compile `node`; `domain` is the sort of name to prefer for a bare word."""
        if isinstance(node, s.Name):
            return self._tell(node, self._name(node, domain))
        made = _COMPILERS[type(node)](self, node)
        return self._tell(node, made)

    def _tell(self, node: s.Expr, made: Code) -> Code:
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

    # -- names ---------------------------------------------------------------

    def _name(self, node: s.Name, domain: str) -> Code:
        name, scope = node.name, self.scope
        if domain == "phase":
            return constant_name(scope.phase(name, node.at))
        if domain == "foul":
            scope.used.add(f"foul {name}")
            return constant_name(name)
        if name in scope.poisoned:
            raise Mistake("R201", node.at, "", silent=True)
        if name in scope.defines:
            return self.defined(name, node.at)
        if name in scope.tracks:
            return self._tracked(name, None, node.at)
        if name in scope.facts:
            return self._fact(name, node.at)
        if name in scope.vocabulary.settings:
            return _setting(name, scope.vocabulary.settings[name])
        if domain:
            return constant_name(name)
        if name in scope.bits:
            mask = scope.bits[name]
            return Code(k.BALLS, lambda _c: mask, constant=mask)
        group = scope.group(name)
        if group is not None:
            return Code(k.BALLS, lambda _c: group, constant=group)
        if name == "none":
            return constant_name(name)
        raise Mistake("R201", node.at, f'"{name}" is not known here', self._mend(name))

    def _mend(self, name: str) -> str:
        known = self.scope.known()
        if name.isdigit() and name in self.scope.bits:
            return f"did you mean `{name}-ball`?"
        return nearest(name, known) or "define it, track it, or use a name of the variant"

    def defined(self, name: str, at: s.Span) -> Code:
        """Return the Code of a define, compiled on first use."""
        scope = self.scope
        scope.used.add(name)
        if name in scope.poisoned:
            raise Mistake("R201", at, "", silent=True)
        node = scope.defines[name]
        frozen = self.frozen or node.frozen
        key = (name, frozen)
        if key not in scope.compiled:
            if name in scope.busy:
                circle = ", ".join([*scope.busy[scope.busy.index(name) :], name])
                raise Mistake(
                    "R405", at, f'"{name}" reads itself: by way of {circle}', "break the circle"
                )
            scope.busy.append(name)
            try:
                inner = Expressions(scope, scope.sources[name], frozen=frozen)
                scope.compiled[key] = inner.cases(node)
            except Mistake as trouble:
                trouble.owner = trouble.owner or name
                scope.poisoned.add(name)
                raise
            finally:
                scope.busy.pop()
        made = scope.compiled[key]
        return derive(
            made, made.kind, made.run, truth=made.truth, domain=made.domain, needs=made.needs,
            phases=made.phases,
        )  # fmt: skip

    def cases(self, node: s.Define) -> Code:
        """Compile a define to a remembered value."""
        codes = [(None if c is None else self.truth(c), v) for c, v in node.cases]
        values = [self._case_value(v) for _, v in codes]
        kind = common_kind(values)
        if kind is None:
            found = " and ".join(sorted({k.SPOKEN[v.kind] for v in values}))
            raise Mistake("R301", node.at, f'the cases of "{node.name}" are {found}', "one kind")
        values = [
            self.want(v, kind) if c.kind != kind else c
            for (_, v), c in zip(codes, values, strict=True)
        ]
        parts = [c for c, _ in codes if c is not None] + values
        default: Any = {k.BALLS: 0, k.NUMBER: 0, k.FLAG: False, k.NAME: "none"}.get(kind)
        pairs = [
            (None if c is None else c.truth, v.run) for (c, _), v in zip(codes, values, strict=True)
        ]
        staged = any(p.staged for p in parts)
        slot = self.scope.memo_size
        self.scope.memo_size += 1
        if staged:
            self.scope.staged.append(slot)
        made = derive(values[0], kind, remembered(slot, chain(pairs, default)))
        if len(codes) == 1 and codes[0][0] is None:
            made.needs, made.phases = values[0].needs, values[0].phases
        else:
            made.word = ""
        made.parts = tuple(parts)
        made.constant = None
        made.staged = staged
        made.since = max(p.since for p in parts)
        made.fouls = any(p.fouls for p in parts)
        made.text = node.name
        if len(node.cases) == 1:
            made.shown = values[0]
            made.word = "define"
        if kind == k.BALLS:
            run = made.run
            made.truth = lambda c: run(c) != 0
        return made

    def _case_value(self, node: s.Expr) -> Code:
        made = self.value(node)
        if made.truth is not None and not (isinstance(node, s.Happened) and made.kind == k.BALLS):
            if made.kind == k.BALLS and not isinstance(node, s.Quantified):
                return made
            return derive(
                made, k.FLAG, made.truth, truth=made.truth, needs=made.needs, phases=made.phases
            )
        return made

    def _tracked(self, name: str, who: s.Expr | None, at: s.Span) -> Code:
        scope = self.scope
        scope.used.add(name)
        track = scope.tracks[name]
        kind = scope.track_kinds[name]
        if track.per_player and who is None:
            raise Mistake(
                "R303", at, f'"{name}" is kept for each player', f"say `{name} of shooter`"
            )
        if who is None:
            if self.frozen:
                return Code(kind, lambda c: c.situation.state[name], domain=name)
            return Code(kind, lambda c: c.state[name], domain=name, staged=True)
        if not track.per_player:
            raise Mistake("R304", at, f'"{name}" is not kept for each player', f"say `{name}`")
        player = self.want(who, k.PLAYER)
        run = player.run
        if self.frozen:
            return joined(
                Code(kind, lambda c: _row(c.situation.state[name])[run(c) - 1], domain=name), player
            )
        return joined(
            Code(kind, lambda c: _row(c.state[name])[run(c) - 1], domain=name, staged=True), player
        )

    def _fact(self, name: str, at: s.Span) -> Code:
        scope = self.scope
        scope.used.add(name)
        fact = scope.facts[name]
        node = scope.fact_nodes[name]
        kind = {"ball": k.BALLS, "number": k.NUMBER, "player": k.PLAYER, "flag": k.FLAG}.get(
            fact.kind, k.NAME
        )
        masks = self.masks()
        empty: Any = 0 if kind in (k.NUMBER, k.BALLS) else False if kind == k.FLAG else "none"
        default = empty if fact.default is None or kind == k.BALLS else fact.default
        asked = None if node.asked_on is None else self._asked(name, node.asked_on, at)
        predicate = fact.predicate
        zone = node.asked_from
        if zone is not None:
            self.scope.place("zone", zone, node.at)

        def read(c: Watch) -> Any:
            shot = c.shot
            found = None if shot is None else shot.facts.get(name)
            if found is None and predicate is not None and shot is not None:
                ask = shot.predicates.get(predicate)
                if ask is not None and asked is not None:
                    found = ask(names_of(c, asked.run(c)), c.actions, zone)
            if found is None:
                return default
            return masks.get(str(found), 0) if kind == k.BALLS else found

        made = Code(kind, read, domain=f"fact {name}")
        if asked is not None:
            made = joined(made, asked)
            made.staged = True
        return made

    def _asked(self, name: str, node: s.Expr, at: s.Span) -> Code:
        if name in self.scope.busy:
            raise Mistake("R405", at, f'the fact "{name}" asks for itself', "break the circle")
        self.scope.busy.append(name)
        try:
            inner = Expressions(self.scope, self.scope.sources[name], frozen=False)
            return inner.want(node, k.BALLS)
        except Mistake as trouble:
            trouble.owner = trouble.owner or name
            raise
        finally:
            self.scope.busy.pop()

    # -- nouns ---------------------------------------------------------------

    def on_table(self) -> Callable[[Watch], int]:
        """Return the closure for the balls on the table, before or after the shot."""
        if self.frozen:
            return lambda c: c.on_before
        return lambda c: c.on_after

    def noun(self, node: s.Noun) -> Code:
        """Compile a noun of the language."""
        words = node.words
        if words in _NOUNS:
            kind, run = _NOUNS[words]
            return Code(kind, run)
        if words in ("ball", "balls", "pin", "pins"):
            mask = self.scope.balls if words.startswith("ball") else self.scope.pins
            return Code(k.BALLS, lambda _c: mask, constant=mask)
        if words == "cue":
            return self.value(s.Name(node.at, "cue"))
        if words == "phase":
            return Code(k.NAME, lambda c: c.phase, domain="phase", word="phase")
        if words == "next phase":
            since = STAGE["table"]
            return Code(k.NAME, lambda c: c.next_phase, domain="phase", since=since, staged=True)
        if words == "called pocket":
            return Code(k.NAME, lambda c: (c.call and c.call.pocket) or "none", domain="pocket")
        if words == "called ball":
            bits = self.scope.bits
            return Code(k.BALLS, lambda c: bits.get((c.call and c.call.ball) or "", 0))
        if words in ("shot", "scores"):
            return Code(words, lambda c: c, staged=True, fouls=words == "shot")
        if words in ("foul", "fouls"):
            return Code(k.FOULS, lambda c: c.fouls, staged=True, fouls=True)
        self._after_shot(node, words)
        return Code(k.BALLS, _ordinal(words))

    def _after_shot(self, node: s.Expr, words: str) -> None:
        if self.frozen:
            raise Mistake(
                "R409",
                node.at,
                f'a define "before shot" cannot read `{words}`',
                "drop `before shot` from the define",
            )

    def player(self, node: s.Player) -> Code:
        """Compile a word for a player."""
        words = node.words
        if words in ("next player", "waiting player"):
            other = words == "waiting player"
            run = (lambda c: opponent(c, c.next_player)) if other else (lambda c: c.next_player)
            return Code(k.PLAYER, run, since=STAGE["table"], staged=True)
        return Code(k.PLAYER, _PLAYERS[words], staged=words == "leader")

    def extreme(self, node: s.Extreme) -> Code:
        """Compile `lowest X`, `highest X`: the balls of lowest or highest value."""
        base = self.want(node.base, k.BALLS)
        run = base.run
        pick = min if node.which == "lowest" else max

        def find(c: Watch) -> int:
            members = list(singles(run(c)))
            if not members:
                return 0
            best = pick(c.values[b] for b in members)
            return sum(b for b in members if c.values[b] == best)

        return joined(Code(k.BALLS, find), base)

    def except_(self, node: s.Except) -> Code:
        """Compile `A except B`."""
        base, but = self.want(node.base, k.BALLS), self.want(node.but, k.BALLS)
        a, b = base.run, but.run
        return joined(Code(k.BALLS, lambda c: a(c) & ~b(c)), base, but)

    def listing(self, node: s.Listing) -> Code:
        """Compile `(a, b)`: the union of sets; as numbers only inside `highest of`."""
        items = [self.want(item, k.BALLS) for item in node.items]
        runs = [item.run for item in items]

        def union(c: Watch) -> int:
            mask = 0
            for run in runs:
                mask |= run(c)
            return mask

        return joined(Code(k.BALLS, union), *items)

    def narrowed(self, node: s.OnTable) -> Code:
        """Compile `X on table`."""
        base = self.want(node.base, k.BALLS)
        run, on = base.run, self.on_table()
        return joined(Code(k.BALLS, lambda c: run(c) & on(c)), base)

    def quantified(self, node: s.Quantified) -> Code:
        """Compile a quantified set that stands alone: it is true by how many there are."""
        base = self.want(node.base, k.BALLS)
        made = derive(base, k.BALLS, base.run)
        run = base.run
        made.truth = lambda c: self.happenings.count(node.how, node.count, run(c), run(c))
        return made

    # -- numbers ---------------------------------------------------------------

    def total(self, node: s.Total) -> Code:
        """Compile `number of`, `value of`, `highest value of`, `highest worth of`, `highest of`."""
        what = node.what
        if what.endswith("worth"):
            fouls = self.want(node.base, k.FOULS)
            pick = max if what.startswith("highest") else min
            run: k.Run = lambda c: pick((f.worth for f in c.fouls), default=0)  # noqa: E731
            return joined(Code(k.NUMBER, run), fouls)
        if what in ("highest", "lowest"):
            return self._extreme_number(node)
        base = self.want(node.base, k.BALLS)
        balls = base.run
        if what == "number":
            return joined(Code(k.NUMBER, lambda c: balls(c).bit_count()), base)
        fold: Callable[[list[int]], int] = {
            "value": sum,
            "highest value": lambda v: max(v, default=0),
            "lowest value": lambda v: min(v, default=0),
        }[what]
        return joined(
            Code(k.NUMBER, lambda c: fold([c.values.get(b, 0) for b in singles(balls(c))])), base
        )

    def _extreme_number(self, node: s.Total) -> Code:
        items = node.base.items if isinstance(node.base, s.Listing) else (node.base,)
        codes = [self.want(item, k.NUMBER) for item in items]
        runs = [code.run for code in codes]
        pick = max if node.what == "highest" else min
        return joined(Code(k.NUMBER, lambda c: pick([run(c) for run in runs])), *codes)

    def arithmetic(self, node: s.Arithmetic) -> Code:
        """Compile plus, minus, times."""
        left, right = self.want(node.left, k.NUMBER), self.want(node.right, k.NUMBER)
        a, b, op = left.run, right.run, _ARITHMETIC[node.op]
        return joined(Code(k.NUMBER, lambda c: op(a(c), b(c))), left, right)

    def score_of(self, node: s.ScoreOf) -> Code:
        """Compile `score of PLAYER`."""
        who = self.want(node.who, k.PLAYER)
        run = who.run
        if self.frozen:
            return joined(Code(k.NUMBER, lambda c: c.situation.scores[run(c) - 1]), who)
        return joined(Code(k.NUMBER, lambda c: c.scores[run(c) - 1], staged=True), who)


def _row(value: Any) -> Any:
    return value


def _setting(name: str, value: Any) -> Code:
    kind = k.FLAG if isinstance(value, bool) else k.NUMBER if isinstance(value, int) else k.NAME
    return Code(kind, lambda c: c.situation.settings.get(name, value), domain=f"setting {name}")


def _ordinal(words: str) -> k.Run:
    which = ORDINALS[words.partition(" ")[0]]
    if words.endswith("pocketed"):
        return lambda c: _nth([b for _, b, _ in c.ev[6]], which)
    if words.endswith("hit"):
        return lambda c: _nth([b for _, b in c.cue_hits], which)

    def find(c: Watch) -> int:
        order: list[int] = []
        seen = 0
        for _, mask in c.cue_hits:
            for one in singles(mask & ~seen):
                order.append(one)
                seen |= one
        return _nth(order, which)

    return find


def _nth(masks: list[int], which: int) -> int:
    if which == -1:
        return masks[-1] if masks else 0
    return masks[which] if len(masks) > which else 0


def _cue_ball_of(x: Expressions, node: s.CueBallOf) -> Code:
    who = x.want(node.who, k.PLAYER)
    run = who.run
    masks = [x.scope.bits.get(name, 0) for name in x.scope.vocabulary.cue_balls]
    if len(masks) == 1:
        only = masks[0]
        return joined(Code(k.BALLS, lambda _c: only), who)
    return joined(Code(k.BALLS, lambda c: masks[(run(c) - 1) % len(masks)]), who)


def _name_of(x: Expressions, node: s.NameOf) -> Code:
    if node.name in x.scope.tracks:
        return x._tracked(node.name, node.who, node.at)  # noqa: SLF001
    if node.name in x.scope.poisoned:
        raise Mistake("R206", node.at, f'"{node.name}" cannot be read', silent=True)
    mend = (
        nearest(node.name, x.scope.tracks) or f"declare it: track {node.name} per game per player"
    )
    raise Mistake("R206", node.at, f'"{node.name}" is not tracked', mend)


def _ball_number(x: Expressions, node: s.BallNumber) -> Code:
    if node.name not in x.scope.bits:
        numbers = [f"{name}-ball" for name in x.scope.bits if name.isdigit()]
        mend = nearest(f"{node.name}-ball", numbers) or "there is no such ball on this table"
        raise Mistake("R201", node.at, f"there is no {node.name}-ball", mend)
    mask = x.scope.bits[node.name]
    return Code(k.BALLS, lambda _c: mask, constant=mask)


def _called(x: Expressions, node: s.Called) -> Code:
    if node.what != "group":
        raise Mistake("R201", node.at, f'nobody can call a "{node.what}"', "say `called group`")
    groups = x.scope.groups
    return Code(k.BALLS, lambda c: groups.get((c.call and c.call.group) or "", 0))


def _opponent_of(x: Expressions, node: s.OpponentOf) -> Code:
    who = x.want(node.who, k.PLAYER)
    run = who.run
    return joined(Code(k.PLAYER, lambda c: opponent(c, run(c))), who)


def _number(_x: Expressions, node: s.Number) -> Code:
    value = node.value
    return Code(k.NUMBER, lambda _c: value, constant=value)


def _flag(_x: Expressions, node: s.Flag) -> Code:
    value = node.value
    return Code(k.FLAG, lambda _c: value, constant=value)


def _gap(x: Expressions, _node: s.ScoreGap) -> Code:
    if x.frozen:
        return Code(k.NUMBER, lambda c: max(c.situation.scores) - min(c.situation.scores))
    return Code(k.NUMBER, lambda c: max(c.scores) - min(c.scores), staged=True)


_NOUNS: dict[str, tuple[str, k.Run]] = {
    "it": (k.BALLS, lambda c: c.it),
    "cue ball": (k.BALLS, lambda c: c.cue),
    "struck ball": (k.BALLS, lambda c: c.cue),
    "object ball": (k.BALLS, lambda c: c.objects),
    "object balls": (k.BALLS, lambda c: c.objects),
}
_PLAYERS: dict[str, k.Run] = {
    "shooter": lambda c: c.shooter,
    "opponent": lambda c: opponent(c, c.shooter),
    "chooser": lambda c: c.chooser,
    "breaker": lambda c: c.situation.breaker,
    "leader": leader,
    "player by lot": lambda c: draw(c.situation.seed, c.players),
    "that player": lambda c: c.player,
}
_COMPILERS: dict[type, Callable[[Expressions, Any], Code]] = {
    s.Number: _number,
    s.Flag: _flag,
    s.Nothing: lambda _x, _n: Code(k.NOTHING, lambda _c: 0),
    s.NameOf: _name_of,
    s.BallNumber: _ball_number,
    s.Noun: Expressions.noun,
    s.Called: _called,
    s.Player: Expressions.player,
    s.OpponentOf: _opponent_of,
    s.CueBallOf: _cue_ball_of,
    s.ScoreOf: Expressions.score_of,
    s.ScoreGap: _gap,
    s.Listing: Expressions.listing,
    s.OnTable: Expressions.narrowed,
    s.Extreme: Expressions.extreme,
    s.Except: Expressions.except_,
    s.Quantified: Expressions.quantified,
    s.Happened: lambda x, n: x.happenings.happened(n),
    s.Sequence: lambda x, n: x.happenings.sequence(n),
    s.Total: Expressions.total,
    s.Arithmetic: Expressions.arithmetic,
    s.Is: lambda x, n: x.conditions.compare(n),
    s.Junction: lambda x, n: x.conditions.junction(n),
    s.Not: lambda x, n: x.conditions.negation(n),
}
