"""Nouns of the language, compiled: sets of balls, players, and what narrows a set.

One idea: a noun that always means the same is a row of a table, the others a function each.
Invariant: a set is a mask of bits, whatever noun it came from.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rulelang import code as k
from rulelang import syntax as s
from rulelang.account import HIT, POCKETED
from rulelang.chance import draw
from rulelang.closures import derive, joined, leader, of_set, opponent, singles
from rulelang.code import Code
from rulelang.ends import loser, winner
from rulelang.events_told import fits_set
from rulelang.program import CONSEQUENCE, STAGE
from rulelang.signs import CUE, Signs, of_all

if TYPE_CHECKING:
    from rulelang.expressions import Expressions
    from rulelang.watch import Watch

ORDINALS = {"first": 0, "second": 1, "third": 2, "last": -1}
_NOUNS: dict[str, tuple[str, k.Run]] = {
    "it": ("", lambda c: c.it),
    "cue ball": (k.CUE_BALL, lambda c: c.cue),
    "struck ball": (k.CUE_BALL, lambda c: c.cue),
    "object ball": (k.OBJECT_BALLS, lambda c: c.objects),
    "object balls": (k.OBJECT_BALLS, lambda c: c.objects),
}
_PLAYERS: dict[str, k.Run] = {
    "shooter": lambda c: c.shooter,
    "opponent": lambda c: opponent(c, c.shooter),
    "chooser": lambda c: c.chooser,
    "breaker": lambda c: c.situation.breaker,
    "leader": leader,
    "player by lot": lambda c: draw(c.situation.seed, c.players),
    "that player": lambda c: c.player,
    "winner": winner,
    "loser": loser,
}


def noun(x: Expressions, node: s.Noun) -> Code:
    """Compile a noun of the language."""
    words = node.words
    if words in _NOUNS:
        word, run = _NOUNS[words]
        return Code(k.BALLS, run, word=word)
    if words in ("ball", "balls", "pin", "pins"):
        mask = x.scope.balls if words.startswith("ball") else x.scope.pins
        return Code(k.BALLS, lambda _c: mask, constant=mask)
    if words == "players":
        return Code(k.NUMBER, lambda c: c.players - len(c.situation.eliminated))
    if words == "cue":
        return x.value(s.Name(node.at, "cue"))
    if words == "phase":
        return Code(k.NAME, lambda c: c.phase, domain="phase", word="phase")
    if words == "next phase":
        since = STAGE["table"]
        return Code(k.NAME, lambda c: c.next_phase, domain="phase", since=since, staged=True)
    if words == "called pocket":
        return Code(k.NAME, lambda c: (c.call and c.call.pocket) or "none", domain="pocket")
    if words == "called ball":
        bits = x.scope.bits
        return Code(k.BALLS, lambda c: bits.get((c.call and c.call.ball) or "", 0))
    if words == "chosen ball":
        return Code(k.BALLS, lambda c: c.chosen)
    if words in ("shot", "scores"):
        return Code(words, lambda c: c, staged=True, fouls=words == "shot")
    if words in ("foul", "fouls"):
        return Code(k.FOULS, lambda c: c.fouls, staged=True, fouls=True)
    x.after_shot(node, words)
    signs = Signs(1 << POCKETED if words.endswith("pocketed") else 1 << CUE + HIT)
    return Code(k.BALLS, _ordinal(words), signs=signs)


def player(_x: Expressions, node: s.Player) -> Code:
    """Compile a word for a player."""
    words = node.words
    if words in ("next player", "waiting player"):
        other = words == "waiting player"
        run = (lambda c: opponent(c, c.next_player)) if other else (lambda c: c.next_player)
        return Code(k.PLAYER, run, since=STAGE["table"], staged=True)
    since = CONSEQUENCE if words in ("winner", "loser") else 0
    return Code(k.PLAYER, _PLAYERS[words], staged=words == "leader", since=since)


def partner_of(x: Expressions, node: s.PartnerOf) -> Code:
    """Compile `partner of WHO`: the next player of the same side, himself where he is alone."""
    who = x.want(node.who, k.PLAYER)
    run, mates = who.run, x.scope.mates

    def find(c: Watch) -> int:
        player: int = run(c)
        sides = max(1, c.players // mates) if mates else c.players
        partner = player + sides
        return partner if partner <= c.players else (player - 1) % sides + 1

    return joined(Code(k.PLAYER, find), who)


def extreme(x: Expressions, node: s.Extreme) -> Code:
    """Compile `lowest X`, `highest X`: the balls of lowest or highest value."""
    base = x.want(node.base, k.BALLS)
    pick, values = min if node.which == "lowest" else max, x.scope.values

    def find(mask: int) -> int:
        members = singles(mask)
        if not members:
            return 0
        best = pick([values[b] for b in members])
        return sum([b for b in members if values[b] == best])

    return joined(Code(k.BALLS, of_set(base, find), signs=of_all([base.signs])), base)


def except_(x: Expressions, node: s.Except) -> Code:
    """Compile `A except B`."""
    base, but = x.want(node.base, k.BALLS), x.want(node.but, k.BALLS)
    a, b = base.run, but.run
    made = Code(k.BALLS, lambda c: a(c) & ~b(c), signs=of_all([base.signs]))
    return joined(made, base, but)


def listing(x: Expressions, node: s.Listing) -> Code:
    """Compile `(a, b)`: the union of sets; as numbers only inside `highest of`."""
    items = [x.want(item, k.BALLS) for item in node.items]
    runs = [item.run for item in items]

    def union(c: Watch) -> int:
        mask = 0
        for run in runs:
            mask |= run(c)
        return mask

    return joined(Code(k.BALLS, union), *items)


def narrowed(x: Expressions, node: s.OnTable) -> Code:
    """Compile `X on table`."""
    base = x.want(node.base, k.BALLS)
    run, on = base.run, x.on_table()
    made = Code(k.BALLS, lambda c: run(c) & on(c), signs=of_all([base.signs]))
    return joined(made, base)


def standing(x: Expressions, node: s.Standing) -> Code:
    """Compile `PINS standing`."""
    base = x.want(node.base, k.BALLS)
    run, up = base.run, x.standing()
    return joined(Code(k.BALLS, lambda c: run(c) & up(c)), base)


def up_to(x: Expressions, node: s.UpTo) -> Code:
    """Compile `up to N among X`: the first N balls of X, none where N is below 1."""
    base, number = x.want(node.base, k.BALLS), x.want(node.count, k.NUMBER)
    run, many = base.run, number.run
    return joined(Code(k.BALLS, lambda c: sum(singles(run(c))[: max(0, many(c))])), base, number)


def quantified(x: Expressions, node: s.Quantified) -> Code:
    """Compile a quantified set that stands alone: it is true by how many there are."""
    base = x.want(node.base, k.BALLS)
    made = derive(base, k.BALLS, base.run)
    run = base.run
    made.truth = lambda c: fits_set(node.how, node.count, run(c), run(c))
    return made


def cue_ball_of(x: Expressions, node: s.CueBallOf) -> Code:
    """Compile `cue ball of PLAYER`."""
    who = x.want(node.who, k.PLAYER)
    run = who.run
    masks = [x.scope.bits.get(name, 0) for name in x.scope.vocabulary.cue_balls]
    if len(masks) == 1:
        only = masks[0]
        return joined(Code(k.BALLS, lambda _c: only), who)
    return joined(Code(k.BALLS, lambda c: masks[(run(c) - 1) % len(masks)]), who)


def opponent_of(x: Expressions, node: s.OpponentOf) -> Code:
    """Compile `opponent of PLAYER`."""
    who = x.want(node.who, k.PLAYER)
    run = who.run
    return joined(Code(k.PLAYER, lambda c: opponent(c, run(c))), who)


def _ordinal(words: str) -> k.Run:
    which = ORDINALS[words.partition(" ")[0]]
    enough = max(which, 0)
    if words.endswith("pocketed"):
        return lambda c: c.ev[POCKETED][which][1] if len(c.ev[POCKETED]) > enough else 0
    if words.endswith("hit"):
        return lambda c: c.cue_hits[which][1] if len(c.cue_hits) > enough else 0

    def find(c: Watch) -> int:
        order: list[int] = []
        seen = 0
        for _, mask in c.cue_hits:
            for one in singles(mask & ~seen):
                order.append(one)
                seen |= one
            if len(order) > which >= 0:
                break
        return order[which] if len(order) > enough else 0

    return find
