"""From text to tree: the grammar, loaded once, and every mistake of the surface at once.

One idea: a text that does not parse as a whole is parsed piece by piece, each rule and
declaration on its own, so that one mistake hides no other.
Invariant: line numbers are those of the text, whatever piece is parsed.
"""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache
from pathlib import Path
from threading import Lock
from typing import TYPE_CHECKING, Any

from rulelang import building
from rulelang.automaton import Unfit
from rulelang.reading import BadDedent, Unreadable
from rulelang.surface import explain, scan
from rulelang.syntax import Script
from rulelang.tables import kept_tables

if TYPE_CHECKING:
    from rulelang.automaton import Automaton
    from rulelang.diagnostics import Diagnostic

MOST_TOLD = 100
"""Nobody mends more at a time; what comes after is told on the next check."""
GRAMMAR = Path(__file__).with_name("grammar.lark")
_MAKING = Lock()
"""The tables are made once, however many threads ask for them."""


@cache
def _parser(folder: Path | None) -> Automaton:
    return kept_tables(GRAMMAR, folder).automaton()


def grammar(folder: Path | None = None) -> Automaton:
    """Return the parser; with `folder` its tables are kept there between processes."""
    with _MAKING:
        return _parser(folder)


def parse(source: str, file: str, cache: Path | None = None) -> tuple[Script, list[Diagnostic]]:
    """Return the tree of `source` and the mistakes of its surface, all of them.

    Where there are mistakes, the tree holds what could be read.
    """
    source = source.replace("\r\n", "\n")
    if not source.endswith("\n"):
        source += "\n"
    mistakes = scan(source, file)
    if any(one.code == "R109" for one in mistakes):
        return Script(file, source, (), ()), mistakes
    parser = grammar(cache)
    if mistakes:
        script, found = _around(parser, source, file, {one.line for one in mistakes})
        return script, mistakes + found
    tree = _try(parser, source)
    if not isinstance(tree, Exception):
        return building.script(tree, file, source), []
    script, found = _piecewise(parser, source, file)
    return script, found or [explain(tree, source, file, parser)]


def _try(parser: Automaton, text: str) -> Any:
    try:
        return parser.parse(text)
    except (Unfit, Unreadable, BadDedent) as trouble:
        return trouble


def _around(
    parser: Automaton, source: str, file: str, wrong: set[int]
) -> tuple[Script, list[Diagnostic]]:
    """Read what stands around lines that are wrong already; a body may be missing for them."""
    lines = enumerate(source.split("\n"), 1)
    kept = [
        line.expandtabs(4) if "\t" in line else "" if number in wrong else line
        for number, line in lines
    ]
    script, found = _piecewise(parser, "\n".join(kept), file)
    told = [one for one in found if one.line not in wrong and one.code != "R104"]
    return replace(script, source=source), told


def _piecewise(parser: Automaton, source: str, file: str) -> tuple[Script, list[Diagnostic]]:
    """Read every piece that can be read; a group is parted at the piece where it goes wrong."""
    found: list[Diagnostic] = []
    declarations: list[Any] = []
    rules: list[Any] = []
    lines = source.split("\n")
    waiting = [_pieces(lines)]
    while waiting and len(found) < MOST_TOLD:
        group = waiting.pop()
        if not group:
            continue
        tree = _try(parser, _keep(lines, [one for piece in group for one in piece]))
        if not isinstance(tree, Exception):
            part = building.script(tree, file, source)
            declarations.extend(part.declarations)
            rules.extend(part.rules)
        elif len(group) == 1:
            found.append(explain(tree, source, file, parser))
        else:
            at = _piece_at(group, getattr(tree, "line", None))
            waiting += [group[at + 1 :], [group[at]], group[:at]]
    unique = {(d.line, d.column): d for d in found}
    return Script(file, source, tuple(declarations), tuple(rules)), list(unique.values())


Piece = list[tuple[int, int]]
"""Ranges of lines that make sense together."""


def _piece_at(group: list[Piece], line: object) -> int:
    """Return which piece of a group holds a line, the last where that is not known."""
    if not isinstance(line, int) or line < 1:
        return len(group) - 1
    return max((n for n, piece in enumerate(group) if piece[-1][0] < line), default=0)


def _pieces(lines: list[str]) -> list[Piece]:
    """Cut a text into top-level pieces, and sections into their rules, each in its place."""
    starts = [n for n, line in enumerate(lines) if line[:1] not in ("", " ", "#")]
    starts = [n for n in starts if not lines[n].startswith("otherwise")]
    pieces: list[Piece] = []
    for number, start in enumerate(starts):
        end = starts[number + 1] if number + 1 < len(starts) else len(lines)
        if _SECTION.match(lines[start]):
            pieces.extend(_rules(lines, start, end))
        else:
            pieces.append([(start, end)])
    return pieces


_SECTION = re.compile(
    r"(before shot|fouls|points|turn|table|next shot|ending|at \w+ \w+|when [a-z0-9-]+ expires)"
    r"( in phase [^:]*)?:\s*(#.*)?$"
)


def _rules(lines: list[str], start: int, end: int) -> list[Piece]:
    body = [n for n in range(start + 1, end) if lines[n].strip() and lines[n].strip()[0] != "#"]
    if not body:
        return [[(start, end)]]
    depth = min(len(lines[n]) - len(lines[n].lstrip()) for n in body)
    heads = [n for n in body if len(lines[n]) - len(lines[n].lstrip()) == depth]
    heads = [n for n in heads if not lines[n].lstrip().startswith("otherwise")]
    heads = heads or body[:1]
    heads[0] = body[0]
    ends = [*heads[1:], end]
    return [[(start, start + 1), (a, b)] for a, b in zip(heads, ends, strict=True)]


def _keep(lines: list[str], ranges: list[tuple[int, int]]) -> str:
    """Return the text with all characters outside the ranges of lines made blank lines."""
    kept = [""] * len(lines)
    for a, b in ranges:
        kept[a:b] = lines[a:b]
    last = max(b for _, b in ranges)
    return "\n".join(kept[:last]) + "\n"
