"""Lark's parser with a lexer made for this grammar: half the time of a parse.

One idea: one expression takes a token together with the blanks before it, and a dictionary tells
keywords from names; rules that only hand on their child do nothing else.
Invariant: trees, tokens and mistakes are those that Lark makes by itself; a test compares them.
"""

from __future__ import annotations

import itertools
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from lark import Token, Tree
from lark.exceptions import UnexpectedCharacters
from lark.parse_tree_builder import PropagatePositions
from lark.parsers.lalr_analysis import Shift

from rulelang.indent import BadDedent

if TYPE_CHECKING:
    from collections.abc import Iterator

    from lark import Lark

_PATTERN = re.compile(
    r"""[ ]*(?:
        (?P<NAME>[a-z][a-z0-9]*(?:-[a-z0-9]+)*)
      | (?P<_NL>(?:\r?\n[ ]*(?:\#[^\n]*)?)+)
      | (?P<SIGN>[():,])
      | (?P<BALLNO>[0-9]+-ball(?![a-z0-9-]))
      | (?P<NUMBER>[0-9]+(?:\.[0-9]+)?)
      | (?P<STRING>"[^"\n]*")
      | (?P<CITE>\[[^\]\n]*\])
      | (?P<COMMENT>\#[^\n]*)
      | (?P<END>\Z)
    )""",
    re.VERBOSE,
)
_ARTICLES = frozenset({"a", "an", "the"})
_MORE = frozenset("abcdefghijklmnopqrstuvwxyz0123456789-")


class FastLexer:
    """Yields the tokens of a text; `types` has the type of each keyword and sign.

    `plan` is the table of the parser that it serves.
    """

    def __init__(self, types: dict[str, str], plan: Plan | None) -> None:
        self.types = types
        self.plan = plan

    def lex(self, state: Any, _parser_state: Any = None) -> Iterator[Token]:
        """Yield the tokens that Lark's basic lexer would; raises UnexpectedCharacters."""
        text: str = getattr(state.text, "text", state.text)
        match, types = _PATTERN.match, self.types
        at, line, begin = 0, 1, 0
        while True:
            found = match(text, at)
            if found is None:
                raise self._wrong(text, at, line, begin)
            kind = found.lastgroup
            if kind == "END":
                return
            start, end = found.span(found.lastindex or 0)
            word = text[start:end]
            at = end
            if kind == "COMMENT":
                continue
            column = start - begin + 1
            if kind == "_NL":
                first = line
                line += word.count("\n")
                begin = text.rindex("\n", start, end) + 1
                yield Token("_NL", word, start, first, column, line, end - begin + 1, end)
                continue
            if kind == "NAME":
                if word in _ARTICLES and text[end : end + 1] not in _MORE:
                    continue
                kind = types.get(word, "NAME")
            elif kind == "SIGN":
                kind = types[word]
            yield Token(str(kind), word, start, line, column, line, end - begin + 1, end)

    def _wrong(self, text: str, at: int, line: int, begin: int) -> UnexpectedCharacters:
        while text[at : at + 1] == " ":
            at += 1
        made: Any = UnexpectedCharacters
        trouble: UnexpectedCharacters = made(text, at, line, at - begin + 1)
        return trouble


class _Placed:
    """Builds a node and gives it its place, from where its first child begins to its last's end.

    A child that is inlined, or that brackets have been dropped around, tells its container's place.
    """

    __slots__ = ("build",)

    def __init__(self, build: Any) -> None:
        self.build = build

    def __call__(self, children: list[Any]) -> Any:
        """Return the node made of `children`."""
        made = self.build(children)
        if type(made) is not Tree:
            return made
        place = made.meta.__dict__
        known = "line" in place
        for child in children:
            if type(child) is Token:
                line, column, start = child.line, child.column, child.start_pos
            elif type(child) is Tree and not child.meta.empty:
                told = child.meta.__dict__
                line, column = told["container_line"], told["container_column"]
                start = told["container_start_pos"]
            else:
                continue
            if not known:
                place["line"], place["column"], place["start_pos"] = line, column, start
                place["empty"] = False
            place["container_line"], place["container_column"] = line, column
            place["container_start_pos"] = start
            break
        known = "end_line" in place
        for child in reversed(children):
            if type(child) is Token:
                line, column, end = child.end_line, child.end_column, child.end_pos
            elif type(child) is Tree and not child.meta.empty:
                told = child.meta.__dict__
                line, column = told["container_end_line"], told["container_end_column"]
                end = told["container_end_pos"]
            else:
                continue
            if not known:
                place["end_line"], place["end_column"], place["end_pos"] = line, column, end
                place["empty"] = False
            place["container_end_line"], place["container_end_column"] = line, column
            place["container_end_pos"] = end
            break
        return made


def hasten(parser: Lark) -> None:
    """Put faster parts into a parser; where Lark is built otherwise, it stays as it is."""
    frontend: Any = parser.parser
    callbacks = getattr(getattr(frontend.parser, "parser", None), "callbacks", None)
    if isinstance(callbacks, dict):
        for rule in callbacks:
            made = callbacks[rule]
            if getattr(rule, "options", None) is not None and _hands_on(rule):
                callbacks[rule] = _only
            elif isinstance(made, PropagatePositions) and made.node_filter is None:
                callbacks[rule] = _Placed(made.node_builder)
    if hasattr(getattr(frontend.lexer, "lexer", None), "lex"):
        words = {t.pattern.value: t.name for t in parser.terminals if t.pattern.type == "str"}
        frontend.lexer.lexer = FastLexer(words, _plan(getattr(frontend.parser, "parser", None)))


def quick_parse(parser: Lark, text: str) -> Any:
    """Return the tree of `text`, as Lark's own `parse` does and raises.

    The parser's table is walked without its bookkeeping for recovery; a text with a mistake goes
    the long way again.
    """
    frontend: Any = parser.parser
    lexer = getattr(frontend.lexer, "lexer", None)
    if not isinstance(lexer, FastLexer) or lexer.plan is None:
        return parser.parse(text)
    try:
        return _walk(frontend.lexer, lexer.plan, text)
    except (KeyError, UnexpectedCharacters, BadDedent):
        return parser.parse(text)


@dataclass(frozen=True, slots=True)
class Plan:
    """A parser's table with plain keys.

    For each state and type of token: the state to go to, or what builds a node, of how many
    children, under which name; for each state and name the state to go to.
    """

    start: int
    end: int
    tokens: dict[int, dict[str, int | tuple[Any, int, str]]]
    gotos: dict[int, dict[str, int]]


def _plan(inner: Any) -> Plan | None:
    table = getattr(inner, "parse_table", None)
    if table is None:
        return None
    tokens: dict[int, dict[str, int | tuple[Any, int, str]]] = {}
    gotos: dict[int, dict[str, int]] = {}
    for state, row in table.states.items():
        tokens[state], gotos[state] = {}, {}
        for name, (action, arg) in row.items():
            plain = str(name)
            if action is Shift:
                tokens[state][plain] = gotos[state][plain] = arg
            else:
                size = len(arg.expansion)
                tokens[state][plain] = (inner.callbacks[arg], size, str(arg.origin.name))
    return Plan(table.start_states["start"], table.end_states["start"], tokens, gotos)


@dataclass(slots=True)
class _Text:
    """What a lexer is handed: the whole text."""

    text: str


def _walk(lexer: Any, plan: Plan, text: str) -> Any:
    """Return the tree; raises KeyError where a token does not fit."""
    tokens, gotos = plan.tokens, plan.gotos
    states, values = [plan.start], list[Any]()
    stream = itertools.chain(lexer.lex(_Text(text), None), (Token("$END", "", 0, 1, 1),))
    for token in stream:
        kind = token.type
        while True:
            step = tokens[states[-1]][kind]
            if type(step) is int:
                states.append(step)
                values.append(token)
                break
            build, size, name = step  # type: ignore[misc]
            if size:
                made = build(values[-size:])
                del states[-size:], values[-size:]
            else:
                made = build([])
            after = gotos[states[-1]][name]
            states.append(after)
            values.append(made)
            if after == plan.end and kind == "$END":
                return made
    raise KeyError("$END")


def _hands_on(rule: Any) -> bool:
    """Tell whether a rule is nothing but its only child."""
    if not rule.options.expand1 or rule.alias or len(rule.expansion) != 1:
        return False
    if any(getattr(rule.options, "empty_indices", ())):
        return False
    only = rule.expansion[0]
    return not only.is_term and not only.name.startswith("_")


def _only(children: list[Any]) -> Any:
    return children[0]
