"""Where in a script a mistake stands, to the word.

One idea: a node of the tree is often wider than what is wrong in it; the name that the message
quotes is looked for inside it. Invariant: what is not found keeps the node's own place.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from rulelang import syntax as s

if TYPE_CHECKING:
    from rulelang.code import Mistake


def narrowed(source: str, trouble: Mistake) -> s.Span:
    """Return where the name that a mistake quotes stands inside its place, else the place."""
    at = trouble.at
    quoted = re.match(r'"([^"]+)" is not', trouble.message)
    if quoted is None or source[at.start : at.end] == quoted.group(1):
        return at
    found = re.search(
        rf"(?<![\w-]){re.escape(quoted.group(1))}(?![\w-])", source[at.start : at.end]
    )
    return at if found is None else _span(source, at.start + found.start(), at.start + found.end())


def span_of(source: str, text: str, at: s.Span) -> s.Span:
    """Return where `text` stands from `at` on, or `at`."""
    start = source.find(text, at.start) if text else -1
    return at if start < 0 else _span(source, start, start + len(text))


def head_of(script: s.Script, rule: s.Rule, phase: str) -> s.Span:
    """Return where the section of a rule names one of its phases, or the rule."""
    heads = re.finditer(
        r"^[a-z][a-z ]* in phase ([^:\n]*):", script.source[: rule.at.start], re.MULTILINE
    )
    for head in reversed(list(heads)):
        name = re.search(rf"(?<![\w-]){re.escape(phase)}(?![\w-])", head.group(1))
        if name is not None:
            start = head.start(1) + name.start()
            return _span(script.source, start, start + len(phase))
    return rule.at


def _span(source: str, start: int, end: int) -> s.Span:
    line = source.count("\n", 0, start) + 1
    return s.Span(line, start - source.rfind("\n", 0, start), start, end)
