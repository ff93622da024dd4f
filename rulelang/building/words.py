"""Places and words of the parser's trees.

One idea: what a piece of the parser's tree says, whatever construct it belongs to.
Invariant: nothing here builds a node.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rulelang.reading import Token
from rulelang.syntax import Span

if TYPE_CHECKING:
    from rulelang.automaton import Tree

_NOWHERE = Span(1, 1, 0, 0)


def span(node: Tree | Token) -> Span:
    """Return the place of a tree or token."""
    if isinstance(node, Token):
        return Span(node.line, node.column, node.start, node.end)
    return _NOWHERE if node.place is None else Span(*node.place)


def text(node: Any) -> str:
    """Return the words of a tree, joined by one blank."""
    if isinstance(node, Token):
        return node.text
    return " ".join(text(child) for child in node.children if child is not None)


def named(node: Any) -> str | None:
    """Return the words of what the grammar leaves open, or None."""
    return None if node is None else text(node)


def unquote(token: Any) -> str:
    """Return a text without its quotes."""
    return str(token).strip('"')
