"""The parser's tables made from the grammar; the only module that needs Lark.

One idea: Lark works out the states, and what it would do at each is written down as plain numbers.
Invariant: importing this module is slow, so nobody does who finds the tables kept in a file.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from lark import Lark
from lark.parsers.lalr_analysis import Shift

from rulelang.automaton import Recipe
from rulelang.tables import Tables

GRAMMAR = Path(__file__).with_name("grammar.lark")


def lark_of(*, strict: bool = False, postlex: Any = None) -> Lark:
    """Return Lark's own parser of the grammar; `strict` refuses any conflict."""
    return Lark(
        GRAMMAR.read_text(encoding="utf-8"),
        parser="lalr",
        lexer="basic",
        postlex=postlex,
        propagate_positions=True,
        maybe_placeholders=True,
        strict=strict,
    )


def make_tables() -> Tables:
    """Return the tables of the grammar."""
    lark: Any = lark_of()
    inner: Any = lark.parser.parser.parser
    table = inner.parse_table
    numbers = {rule: number for number, rule in enumerate(lark.rules)}
    kinds = sorted({str(kind) for row in table.states.values() for kind in row})
    places = {kind: place for place, kind in enumerate(kinds)}

    def packed(row: Any) -> str:
        steps = (
            (places[str(kind)], arg if action is Shift else -1 - numbers[arg])
            for kind, (action, arg) in row.items()
        )
        return " ".join(f"{place} {step}" for place, step in sorted(steps))

    return Tables(
        start=table.start_states["start"],
        end=table.end_states["start"],
        words={t.pattern.value: t.name for t in lark.terminals if t.pattern.type == "str"},
        names=tuple(kinds),
        recipes=tuple(_recipe(rule) for rule in lark.rules),
        rows=tuple(packed(table.states[state]) for state in range(len(table.states))),
    )


def _recipe(rule: Any) -> Recipe:
    """Return how Lark makes a node by a rule: which parts it keeps, inlines and leaves open."""
    options = rule.options
    picks: list[tuple[int, bool, int]] = []
    gaps = _gaps(options.empty_indices, len(rule.expansion))
    waiting = 0
    for number, symbol in enumerate(rule.expansion):
        waiting += gaps[number]
        if options.keep_all_tokens or not (symbol.is_term and symbol.filter_out):
            spread = not symbol.is_term and symbol.name.startswith("_")
            picks.append((number, spread, waiting))
            waiting = 0
    absent = waiting + gaps[-1]
    plain = not absent and picks == [(number, False, 0) for number in range(len(rule.expansion))]
    return Recipe(
        size=len(rule.expansion),
        name=str(rule.origin.name),
        data=str(rule.alias or rule.origin.name),
        single=bool(options.expand1 and not rule.alias),
        picks=None if plain else tuple(picks),
        absent=absent,
    )


def _gaps(empty: Any, size: int) -> list[int]:
    """Return how many parts are left open before each part of a rule, and after the last."""
    if not empty:
        return [0] * (size + 1)
    gaps = [0]
    for one in empty:
        if one:
            gaps[-1] += 1
        else:
            gaps.append(0)
    return gaps
