"""A script's text as tokens, the lines' depths among them.

One idea: one expression takes a token together with the blanks before it, a dictionary tells
keywords from names, and a line's depth is measured from the newline before it; brackets join lines.
Invariant: every stream has as many _DEDENT as _INDENT, and keeps no state between texts; tokens
are those that Lark makes of the same grammar, which a test compares.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

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


class Token:
    """A word, sign, number or text, with its place; lines and columns count from 1."""

    __slots__ = ("column", "end", "end_column", "end_line", "kind", "line", "start", "text")

    def __init__(
        self,
        kind: str,
        text: str,
        line: int,
        column: int,
        start: int,
        end: int,
        end_line: int,
        end_column: int,
    ) -> None:
        self.kind = kind
        self.text = text
        self.line = line
        self.column = column
        self.start = start
        self.end = end
        self.end_line = end_line
        self.end_column = end_column

    def __str__(self) -> str:
        return self.text

    def at_its_place(self, kind: str) -> Token:
        """Return a token without text that stands where this one does."""
        return Token(
            kind,
            "",
            self.line,
            self.column,
            self.start,
            self.end,
            self.end_line,
            self.end_column,
        )


class Unreadable(Exception):  # noqa: N818 - it names the mistake, as the codes do
    """A sign that no token begins with."""

    def __init__(self, line: int, column: int) -> None:
        super().__init__(f"line {line}, column {column}")
        self.line = line
        self.column = column


class BadDedent(Exception):  # noqa: N818 - it names the mistake, as the codes do
    """A line goes back to a depth that no line above it has."""

    def __init__(self, line: int, column: int) -> None:
        super().__init__(f"line {line}")
        self.line = line
        self.column = column


def tokens_of(text: str, words: Mapping[str, str]) -> Iterator[Token]:
    """Yield the tokens of `text`, $END the last; `words` has the kind of each keyword and sign.

    Raises Unreadable or BadDedent where the text goes wrong, after the tokens before that.
    """
    match = _PATTERN.match
    at, line, begin, brackets = 0, 1, 0, 0
    depths = [0]
    token = Token("_NL", "", 1, 1, 0, 0, 1, 1)
    newline: Token | None = None
    while True:
        found = match(text, at)
        if found is None:
            raise _unreadable(text, at, line, begin)
        kind = found.lastgroup
        if kind == "END":
            break
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
            if brackets == 0:
                token = Token(kind, word, first, column, start, end, line, end - begin + 1)
                newline = token
                yield token
                yield from _depths(token, depths)
            continue
        if kind == "NAME":
            if word in _ARTICLES and text[end : end + 1] not in _MORE:
                continue
            kind = words.get(word, "NAME")
        elif kind == "SIGN":
            kind = words[word]
            if word == "(":
                brackets += 1
            elif word == ")" and brackets:
                brackets -= 1
        token = Token(str(kind), word, line, column, start, end, line, end - begin + 1)
        yield token
    last = token if newline is None else newline
    for _ in depths[1:]:
        token = last.at_its_place("_DEDENT")
        yield token
    yield token.at_its_place("$END")


def _depths(newline: Token, depths: list[int]) -> Iterator[Token]:
    """Yield how the line after `newline` lies deeper or less deep than the line before it."""
    depth = newline.end_column - 1
    if depth > depths[-1]:
        depths.append(depth)
        yield newline.at_its_place("_INDENT")
        return
    while depth < depths[-1]:
        depths.pop()
        yield newline.at_its_place("_DEDENT")
    if depth != depths[-1]:
        raise BadDedent(newline.end_line, newline.end_column)


def _unreadable(text: str, at: int, line: int, begin: int) -> Unreadable:
    while text[at : at + 1] == " ":
        at += 1
    return Unreadable(line, at - begin + 1)
