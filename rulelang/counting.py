"""Numbers and flags, compiled: counts, values, scores, arithmetic.

One idea: a number is read from sets and scores when it is asked for.
Invariant: no number grows beyond MOST, however a script multiplies.
"""

from __future__ import annotations

import operator
from typing import TYPE_CHECKING

from rulelang import code as k
from rulelang import syntax as s
from rulelang.account import POCKETED
from rulelang.chance import lots
from rulelang.closures import joined, of_set, singles
from rulelang.code import Code, Mistake

if TYPE_CHECKING:
    from collections.abc import Callable

    from rulelang.expressions import Expressions
    from rulelang.vocabulary import Vocabulary
    from rulelang.watch import Watch

MOST = 10**12
"""No number of a script grows beyond this, either way."""


def _bounded(op: Callable[[int, int], int]) -> Callable[[int, int], int]:
    return lambda a, b: max(-MOST, min(MOST, op(a, b)))


_ARITHMETIC: dict[str, Callable[[int, int], int]] = {
    "plus": operator.add,
    "minus": operator.sub,
    "times": _bounded(operator.mul),
}


def total(x: Expressions, node: s.Total) -> Code:
    """Compile `number of`, `value of`, `highest value of`, `highest worth of`, `highest of`."""
    what = node.what
    if what.endswith("worth"):
        fouls = x.want(node.base, k.FOULS)
        pick = max if what.startswith("highest") else min
        run: k.Run = lambda c: pick((f.worth for f in c.fouls), default=0)  # noqa: E731
        return joined(Code(k.NUMBER, run), fouls)
    if what in ("highest", "lowest"):
        return _extreme_number(x, node)
    if what == "number" and isinstance(node.base, s.Noun) and node.base.words in ("foul", "fouls"):
        fouls = x.want(node.base, k.FOULS)
        return joined(Code(k.NUMBER, lambda c: len(c.fouls)), fouls)
    if what == "number" and isinstance(node.base, s.Noun) and node.base.words == "players":
        return x.want(node.base, k.NUMBER)
    base = x.want(node.base, k.BALLS)
    balls = base.run
    if what == "pocket value":
        x.after_shot(node, what)
        return joined(Code(k.NUMBER, _pocket_value(balls, x.scope.vocabulary)), base)
    if what == "number":
        return joined(Code(k.NUMBER, lambda c: balls(c).bit_count()), base)
    fold: Callable[[list[int]], int] = {
        "value": sum,
        "highest value": lambda v: max(v, default=0),
        "lowest value": lambda v: min(v, default=0),
    }[what]
    values = x.scope.values
    run = of_set(base, lambda mask: fold([values.get(b, 0) for b in singles(mask)]))
    return joined(Code(k.NUMBER, run), base)


def _pocket_value(balls: k.Run, words: Vocabulary) -> k.Run:
    """Return what the pockets are worth that balls of a set went into."""
    values = words.pocket_values

    def run(c: Watch) -> int:
        mask = balls(c)
        return sum(values.get(pocket, 0) for _, ball, pocket in c.ev[POCKETED] if ball & mask)

    return run


def _extreme_number(x: Expressions, node: s.Total) -> Code:
    items = node.base.items if isinstance(node.base, s.Listing) else (node.base,)
    codes = [x.want(item, k.NUMBER) for item in items]
    runs = [code.run for code in codes]
    pick = max if node.what == "highest" else min
    return joined(Code(k.NUMBER, lambda c: pick([run(c) for run in runs])), *codes)


def arithmetic(x: Expressions, node: s.Arithmetic) -> Code:
    """Compile plus, minus, times."""
    left, right = x.want(node.left, k.NUMBER), x.want(node.right, k.NUMBER)
    a, b, op = left.run, right.run, _ARITHMETIC[node.op]
    return joined(Code(k.NUMBER, lambda c: op(a(c), b(c))), left, right)


def score_of(x: Expressions, node: s.ScoreOf) -> Code:
    """Compile `score of PLAYER`."""
    who = x.want(node.who, k.PLAYER)
    run = who.run
    if x.frozen:
        return joined(Code(k.NUMBER, lambda c: c.situation.scores[run(c) - 1]), who)
    return joined(Code(k.NUMBER, lambda c: c.scores[run(c) - 1], staged=True), who)


def lot_of(x: Expressions, node: s.LotOf) -> Code:
    """Compile `lot of WHO up to N`: a number for each player, none twice, from the seed alone."""
    fewest, most = x.scope.vocabulary.players[1], 1000
    if not fewest <= node.most <= most:
        message = f"{node.most} numbers are not one for each of {fewest} players"
        mend = f"say `up to {max(fewest, min(most, node.most))}`"
        raise Mistake("R307", node.at, message, mend)
    who = x.want(node.who, k.PLAYER)
    run, last = who.run, node.most
    return joined(Code(k.NUMBER, lambda c: lots(c.situation.seed, last)[run(c) - 1]), who)


def gap(x: Expressions, _node: s.ScoreGap) -> Code:
    """Compile `score gap`: between the highest and the lowest."""
    if x.frozen:
        return Code(k.NUMBER, lambda c: max(c.situation.scores) - min(c.situation.scores))
    return Code(k.NUMBER, lambda c: max(c.scores) - min(c.scores), staged=True)


def extreme_score(x: Expressions, node: s.ScoreExtreme) -> Code:
    """Compile `highest score`, `lowest score`, `second highest score`.

    Of one player alone the second is 0.
    """
    place, top = int(node.second), node.which == "highest"

    def pick(scores: tuple[int, ...]) -> int:
        ranked = sorted(scores, reverse=top)
        return ranked[place] if place < len(ranked) else 0

    if x.frozen:
        return Code(k.NUMBER, lambda c: pick(c.situation.scores))
    return Code(k.NUMBER, lambda c: pick(c.scores), staged=True)


def number(_x: Expressions, node: s.Number) -> Code:
    """Compile a number as written."""
    value = node.value
    return Code(k.NUMBER, lambda _c: value, constant=value)


def flag(_x: Expressions, node: s.Flag) -> Code:
    """Compile `yes` or `no`."""
    value = node.value
    return Code(k.FLAG, lambda _c: value, constant=value)
