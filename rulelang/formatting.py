"""A script in its one canonical spelling: blanks, indentation, empty lines, words.

One idea: a formatter of lines and words, not of trees: the author's own line breaks and comments
stay, and whatever stands between the words is made anew.
Invariant: the text that comes out has the tree of the text that went in, and comes out unchanged
when it goes in again.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from rulelang.diagnostics import ScriptError
from rulelang.parse import parse
from rulelang.syntax.plain import plain

if TYPE_CHECKING:
    from pathlib import Path

STEP = 4
_TOKEN = re.compile(
    r"""(?P<comment>\#[^\n]*)
      |(?P<string>"[^"\n]*")
      |(?P<cite>\[[^\]\n]*\])
      |(?P<ball>[0-9]+-ball(?![a-z0-9-]))
      |(?P<article>(?:a|an|the)(?![a-z0-9-]))
      |(?P<name>[a-z][a-z0-9]*(?:-[a-z0-9]+)*)
      |(?P<number>[0-9]+(?:\.[0-9]+)?)
      |(?P<sign>[(),:])
      |(?P<blank>[ ]+)""",
    re.VERBOSE,
)
_SECTION = re.compile(
    r"(?:before shot|fouls|points|turn|table|next shot|ending|at [a-z]+ [a-z]+|when \S+ expires)"
    r"(?: in phase [^:]*)?:$"
)


@dataclass(slots=True)
class _Line:
    """One line of the text: its words, its comment, and how far it is indented.

    `open` counts the brackets that the lines before have left open.
    """

    words: list[str]
    comment: str
    column: int
    open: int
    level: int = 0
    _said: str = field(default="")

    @property
    def empty(self) -> bool:
        """Tell whether nothing stands in the line."""
        return not self.words and not self.comment

    def said(self) -> str:
        """Return the words as they are written, without comment and indentation."""
        if not self._said:
            self._said = _joined(self.words)
        return self._said


def format_script(source: str, file: str = "", cache: Path | None = None) -> str:
    """Return `source` in its canonical spelling.

    Raises ScriptError where the script cannot be parsed: nothing is guessed.
    """
    before = _tree(source, file, cache)
    text = _formatted(source)
    if _tree(text, file, cache) != before:
        message = f"the formatter would change what {file} means"
        raise RuntimeError(message)
    return text


def _tree(source: str, file: str, cache: Path | None) -> str:
    script, mistakes = parse(source, file, cache)
    if mistakes:
        raise ScriptError(tuple(mistakes))
    return plain((script.declarations, script.rules))


def _formatted(source: str) -> str:
    lines = _lines(source.replace("\r\n", "\n"))
    _indent(lines)
    return _written(_spaced(lines))


def _lines(source: str) -> list[_Line]:
    lines = []
    opened = 0
    for row in source.split("\n"):
        words, comment = _words(row)
        lines.append(_Line(words, comment, len(row) - len(row.lstrip(" ")), opened))
        opened = max(0, opened + words.count("(") - words.count(")"))
    return lines


def _words(row: str) -> tuple[list[str], str]:
    """Return the words of a line without its articles, and its comment."""
    words: list[str] = []
    comment = ""
    for found in _TOKEN.finditer(row):
        kind, text = found.lastgroup, found.group()
        if kind == "comment":
            comment = text.rstrip()
        elif kind == "cite":
            words.append("[" + ", ".join(part.strip() for part in text[1:-1].split(",")) + "]")
        elif kind not in ("blank", "article"):
            words.append(text)
    return _shortened(words), comment


def _shortened(words: list[str]) -> list[str]:
    """Drop the words that a line may have and does not need."""
    if words[:1] == ["define"] and words[-2:] == ["as", ":"]:
        words = [*words[:-2], ":"]
    if words[-2:] == ["from", "table"] and "remove" in words:
        at = len(words) - 1 - words[::-1].index("remove")
        if at == 0 or words[at - 1] == ":":
            words = words[:-2]
    return words


def _joined(words: list[str]) -> str:
    text = ""
    for word in words:
        tight = not text or word in (",", ":", ")") or text.endswith("(")
        text += word if tight else f" {word}"
    return text


def _indent(lines: list[_Line]) -> None:
    """Give every line its level: code by the depths above it, comments by what follows them."""
    depths = [0]
    waiting: list[_Line] = []
    for line in lines:
        if line.empty:
            continue
        if line.open:
            closing = line.words[:1] == [")"]
            line.level = len(depths) - 1 + line.open - (1 if closing else 0)
            continue
        if not line.words:
            waiting.append(line)
            continue
        above = list(depths)
        while line.column < depths[-1]:
            depths.pop()
        if line.column > depths[-1]:
            depths.append(line.column)
        line.level = len(depths) - 1
        _settle(waiting, line, above)
        waiting = []
    _settle(waiting, None, depths)


def _settle(comments: list[_Line], after: _Line | None, depths: list[int]) -> None:
    """Put comments where the line after them stands, or into the body that they end."""
    column, level = (0, 0) if after is None else (after.column, after.level)
    for one in comments:
        if one.column <= column:
            one.level = level
        else:
            deeper = sum(depth <= one.column for depth in depths) - 1
            one.level = max(level, deeper)
            column = one.column if deeper < level else column


def _spaced(lines: list[_Line]) -> list[_Line]:
    """Return the lines with one empty line at most between two, and one before each section."""
    kept: list[_Line] = []
    for line in lines:
        if line.empty and (not kept or kept[-1].empty or line.open or _opens(kept[-1])):
            continue
        kept.append(line)
        if _begins_section(line):
            _part(kept)
    while kept and kept[-1].empty:
        kept.pop()
    return kept


def _opens(line: _Line) -> bool:
    return line.words[-1:] == [":"]


def _begins_section(line: _Line) -> bool:
    return line.level == 0 and not line.open and _SECTION.match(line.said()) is not None


def _part(kept: list[_Line]) -> None:
    """Put an empty line before the section that ends `kept`, and the comments that lead to it."""
    at = len(kept) - 1
    while at and kept[at - 1].comment and not kept[at - 1].words and kept[at - 1].level == 0:
        at -= 1
    if at and not kept[at - 1].empty:
        kept.insert(at, _Line([], "", 0, 0))


def _written(lines: list[_Line]) -> str:
    """Return the lines as text; the comments of lines that follow each other stand in a column."""
    codes = [" " * (STEP * line.level) + line.said() if line.words else "" for line in lines]
    rows = []
    for number, line in enumerate(lines):
        if not line.comment:
            rows.append(codes[number])
        elif not line.words:
            rows.append(" " * (STEP * line.level) + line.comment)
        else:
            rows.append(codes[number].ljust(_column(lines, codes, number)) + "  " + line.comment)
    return "".join(f"{row}\n" for row in rows)


def _column(lines: list[_Line], codes: list[str], number: int) -> int:
    """Return how wide the code of the lines is that have a comment, around one line."""
    first = last = number
    while first and lines[first - 1].comment and lines[first - 1].words:
        first -= 1
    while last + 1 < len(lines) and lines[last + 1].comment and lines[last + 1].words:
        last += 1
    return max(len(code) for code in codes[first : last + 1])
