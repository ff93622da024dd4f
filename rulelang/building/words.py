"""Places and words of Lark's trees.

One idea: what a piece of the parser's tree says, whatever construct it belongs to.
Invariant: nothing here builds a node.
"""

from __future__ import annotations

from typing import Any

from lark import Token, Tree

from rulelang.syntax import Span

Node = Tree[Token]


def span(node: Node | Token) -> Span:
    """Return the place of a tree or token."""
    if isinstance(node, Token):
        start = node.start_pos or 0
        return Span(node.line or 1, node.column or 1, start, node.end_pos or start)
    meta = node.meta
    if meta.empty:
        return Span(1, 1, 0, 0)
    return Span(meta.line, meta.column, meta.start_pos, meta.end_pos)


def text(node: Any) -> str:
    """Return the words of a tree, joined by one blank."""
    if isinstance(node, Token):
        return str(node)
    return " ".join(text(child) for child in node.children if child is not None)


def named(node: Any) -> str | None:
    """Return the words of what the grammar leaves open, or None."""
    return None if node is None else text(node)


def unquote(token: Any) -> str:
    """Return a text without its quotes."""
    return str(token).strip('"')
