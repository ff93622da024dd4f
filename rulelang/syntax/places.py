"""Where something stands in the text of a script.

One idea: every piece of a tree carries its place, so that a message can point at it.
Invariant: lines and columns count from 1, characters from 0; `end` is one past the last.
"""

from __future__ import annotations

from rulelang.frozen import value


@value
class Span:
    """Where something stands: line and column from 1, and the range of characters."""

    line: int
    column: int
    start: int
    end: int
