"""Tracked values and facts, compiled: what the match keeps and what an eye has seen.

One idea: both are read by name when a shot is judged, for only then they are known.
Invariant: a fact that nobody stated is asked of its predicate, and else has its default.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang import code as k
from rulelang import syntax as s
from rulelang.closures import joined, names_of
from rulelang.code import Code, Mistake

if TYPE_CHECKING:
    from rulelang.expressions import Expressions
    from rulelang.watch import Watch


def tracked(x: Expressions, name: str, who: s.Expr | None, at: s.Span) -> Code:
    """Compile a tracked value, of one player where `who` is told."""
    scope = x.scope
    scope.used.add(name)
    track = scope.tracks[name]
    kind = scope.track_kinds[name]
    if track.per_player and who is None:
        raise Mistake("R303", at, f'"{name}" is kept for each player', f"say `{name} of shooter`")
    if who is None:
        if x.frozen:
            return Code(kind, lambda c: c.situation.state[name], domain=name)
        return Code(kind, lambda c: c.state[name], domain=name, staged=True)
    if not track.per_player:
        raise Mistake("R304", at, f'"{name}" is not kept for each player', f"say `{name}`")
    player = x.want(who, k.PLAYER)
    run = player.run
    if x.frozen:
        return joined(
            Code(kind, lambda c: _row(c.situation.state[name])[run(c) - 1], domain=name), player
        )
    return joined(
        Code(kind, lambda c: _row(c.state[name])[run(c) - 1], domain=name, staged=True), player
    )


def fact(x: Expressions, name: str, at: s.Span) -> Code:
    """Compile a fact: as stated, else by its predicate, else its default."""
    scope = x.scope
    scope.used.add(name)
    said = scope.facts[name]
    node = scope.fact_nodes[name]
    kind = {"ball": k.BALLS, "number": k.NUMBER, "flag": k.FLAG}.get(said.kind, k.NAME)
    masks = x.masks()
    empty: Any = 0 if kind in (k.NUMBER, k.BALLS) else False if kind == k.FLAG else "none"
    default = empty if said.default is None or kind == k.BALLS else said.default
    asked = None if node.asked_on is None else _asked(x, name, node.asked_on, at)
    predicate = said.predicate
    zone = node.asked_from
    if zone is not None:
        x.scope.place("zone", zone, node.at)

    def read(c: Watch) -> Any:
        shot = c.shot
        found = None if shot is None else shot.facts.get(name)
        if found is None and predicate is not None and shot is not None:
            ask = shot.predicates.get(predicate)
            if ask is not None and asked is not None:
                balls = asked.run(c)
                if shot.located or c.actions:
                    found = ask(names_of(c, balls), c.actions, zone)
        if found is None:
            return default
        return masks.get(str(found), 0) if kind == k.BALLS else found

    made = Code(kind, read, domain=f"fact {name}")
    if name in scope.timers:
        made.text = f"{name} expired"
    if asked is not None:
        made = joined(made, asked)
        made.staged = True
    return made


def _asked(x: Expressions, name: str, node: s.Expr, at: s.Span) -> Code:
    if name in x.scope.busy:
        raise Mistake("R405", at, f'the fact "{name}" asks for itself', "break the circle")
    x.scope.busy.append(name)
    try:
        return x.inside(name, frozen=False).want(node, k.BALLS)
    except Mistake as trouble:
        trouble.owner = trouble.owner or name
        raise
    finally:
        x.scope.busy.pop()


def _row(value: Any) -> Any:
    return value
