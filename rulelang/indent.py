"""Indentation as tokens: a pass over the lexer's stream that keeps no state between streams.

One idea: a line's depth is measured from the newline token before it; brackets join lines.
Invariant: every stream has as many _DEDENT as _INDENT; one object may serve many threads.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from lark import Token
from lark.lark import PostLex

if TYPE_CHECKING:
    from collections.abc import Iterator


class BadDedent(Exception):  # noqa: N818 - it names the mistake, as the codes do
    """A line goes back to a depth that no line above it has."""

    def __init__(self, line: int, column: int) -> None:
        super().__init__(f"line {line}")
        self.line = line
        self.column = column


class Indentation(PostLex):
    """Turns the blanks after each newline into _INDENT and _DEDENT tokens."""

    always_accept = ()

    def process(self, stream: Iterator[Token]) -> Iterator[Token]:
        """Yield the tokens of `stream` with _INDENT and _DEDENT put in; raises BadDedent."""
        depths = [0]
        brackets = 0
        last: Token | None = None
        for token in stream:
            if token.type == "_NL":
                if brackets == 0:
                    last = token
                    yield from _line(token, depths)
                continue
            if token.type == "LPAR":
                brackets += 1
            elif token.type == "RPAR":
                brackets = max(0, brackets - 1)
            yield token
        yield from _close(last, depths)


def _line(newline: Token, depths: list[int]) -> Iterator[Token]:
    yield newline
    depth = len(newline.rsplit("\n", 1)[1])
    if depth > depths[-1]:
        depths.append(depth)
        yield Token.new_borrow_pos("_INDENT", "", newline)
        return
    while depth < depths[-1]:
        depths.pop()
        yield Token.new_borrow_pos("_DEDENT", "", newline)
    if depth != depths[-1]:
        raise BadDedent(newline.end_line or 0, newline.end_column or 0)


def _close(last: Token | None, depths: list[int]) -> Iterator[Token]:
    while len(depths) > 1:
        depths.pop()
        yield Token.new_borrow_pos("_DEDENT", "", last) if last else Token("_DEDENT", "")
