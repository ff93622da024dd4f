"""Declarations and rules, built from the parser's trees.

One idea: a line of the text may hold several declarations, so each is built as a list.
Invariant: declarations and rules keep the order of the text.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang import syntax as s
from rulelang.automaton import Tree
from rulelang.building.expressions import expression, guard, maybe
from rulelang.building.statements import statement
from rulelang.building.words import span, text, unquote

if TYPE_CHECKING:
    from collections.abc import Callable


def _header(n: Any) -> list[s.Declaration]:
    word = str(n.data)
    made: list[s.Declaration] = [s.Header(span(n), word, unquote(n.children[0]))]
    if word == "game" and n.children[1] is not None:
        made.append(s.Header(span(n), "cites", unquote(n.children[1])))
    return made


def _track(n: Any) -> list[s.Declaration]:
    name, *units, start = n.children
    return [s.Track(span(n), text(name), tuple(text(u) for u in units), maybe(start))]


def _timer(n: Any) -> list[s.Declaration]:
    name, seconds, per = n.children
    return [s.Timer(span(name), text(name), text(seconds), "shot" if per is None else text(per))]


def _fact(n: Any) -> list[s.Declaration]:
    name, *rest = n.children
    kind = ""
    values: tuple[str, ...] = ()
    if isinstance(rest[0], Tree) and rest[0].data in ("fact_values", "fact_kind"):
        first = rest.pop(0)
        kind = "values" if first.data == "fact_values" else text(first)
        values = tuple(text(v) for v in first.children) if kind == "values" else ()
    rest = [part for part in rest if part is not None]
    default = predicate = asked = zone = None
    for part in rest:
        if part.data == "start_value":
            default = expression(part)
        elif part.data == "name":
            predicate = text(part)
        elif part.data == "asked_from":
            zone = text(part.children[0])
        else:
            asked = expression(part)
    return [s.Fact(span(n), text(name), kind, values, default, predicate, asked, zone)]


def _define(n: Any) -> list[s.Declaration]:
    name, frozen, *rest = n.children
    cases: list[tuple[s.Expr | None, s.Expr]] = []
    if n.data in ("define_as", "define_when"):
        cases = [(None, expression(rest[0]))]
    else:
        for part in rest:
            if part is None:
                continue
            if part.data == "case":
                cases.append((guard(part.children[0]), expression(part.children[1])))
            else:
                cases.append((None, expression(part.children[0])))
    return [s.Define(span(name), text(name), frozen is not None, tuple(cases))]


def _zones(n: Any) -> list[s.Declaration]:
    name, *members = n.children
    return [s.Zones(span(name), text(name), tuple((text(c), span(c)) for c in members))]


_DECLARATIONS: dict[str, Callable[[Any], list[s.Declaration]]] = {
    "language": _header,
    "game": _header,
    "book": _header,
    "uses": _header,
    "order": lambda n: [s.Header(span(n), "spotting", text(n.children[0]))],
    "order_of_sets": lambda n: [s.SpottingOrder(span(n), tuple(map(expression, n.children)))],
    "settled": lambda n: [s.Header(span(n), "settled", text(n.children[0]))],
    "sides": lambda n: [s.Header(span(n), "side", text(n.children[0]))],
    "timer": _timer,
    "phases": lambda n: [s.Phases(span(n), tuple((text(c), span(c)) for c in n.children))],
    "zones": _zones,
    "track": _track,
    "fact": _fact,
    "home": lambda n: [s.Home(span(n), expression(n.children[0]), text(n.children[1]))],
    "define_as": _define,
    "define_when": _define,
    "define_cases": _define,
}


def _rule(n: Any, section: str | None, phases: tuple[str, ...]) -> s.Rule:
    if n.data != "rule":
        return s.Rule(span(n), "", section, phases, (), (), (statement(n),))
    title, cite, overrides, *body = n.children
    cites = () if cite is None else tuple(c.strip() for c in str(cite)[1:-1].split(","))
    over = () if overrides is None else overrides.children
    return s.Rule(
        span(title),
        unquote(title),
        section,
        phases,
        cites,
        tuple((unquote(token), span(token)) for token in over),
        tuple(statement(part) for part in body),
    )


def _section(n: Any) -> list[s.Rule]:
    head, where, *body = n.children
    name = text(head).replace("rack ", "game ").replace("frame ", "game ")
    name = f"{name} expires" if head.data == "expiry" else name
    phases = () if where is None else tuple(text(c) for c in where.children)
    return [_rule(part, name, phases) for part in body]


def script(tree: Any, file: str, source: str) -> s.Script:
    """Build a whole file."""
    declarations: list[s.Declaration] = []
    rules: list[s.Rule] = []
    for child in tree.children:
        if child.data in _DECLARATIONS:
            declarations.extend(_DECLARATIONS[child.data](child))
        elif child.data == "section":
            rules.extend(_section(child))
        else:
            rules.append(_rule(child, None, ()))
    return s.Script(file, source, tuple(declarations), tuple(rules))
