"""TOML files as trees in which every value knows the file and key it came from.

One idea: parts and extended files are laid over each other as trees of Nodes, so a mistake found
long after merging is still told at the line that made it.
Invariant: a Node's path leads to it in its own source.
"""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass
from stat import S_ISREG
from typing import TYPE_CHECKING

from engine.variant.locate import KeyPath, Place, locate
from rulelang.diagnostics import Diagnostic

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from pathlib import Path

LARGEST_FILE = 256 * 1024
LONGEST_LINE = 2000
DEEPEST = 16

_POSITION = re.compile(r"\s*\(at (?:line (\d+), column (\d+)|end of document)\)$")
_TOKEN = re.compile(r"\"(?:[^\"\\]|\\.)*\"|'[^']*'|[^\s,\]}=#]+")


@dataclass(frozen=True, slots=True, eq=False)
class Source:
    """One file as read. `home` is the folder that holds its variants and folders of parts."""

    path: Path
    home: Path
    text: str
    places: Mapping[KeyPath, Place]

    def diagnostic(
        self, code: str, path: KeyPath, message: str, mend: str, *, on_key: bool
    ) -> Diagnostic:
        """Return a mistake at the key or the value of `path`, or of what encloses it."""
        at = path
        while at and at not in self.places:
            at, on_key = at[:-1], on_key or not isinstance(at[-1], int)
        place = self.places.get(at, Place(1, 1, 1, 1))
        line, column = place.value_line, place.value_column
        if on_key:
            line, column = place.line, place.column
        return diagnostic_at(code, self, line, column, message, mend, dotted(path))


def diagnostic_at(
    code: str, source: Source, line: int, column: int, message: str, mend: str = "", key: str = ""
) -> Diagnostic:
    """Return a mistake at a line and column of `source`, with its line of text."""
    lines = source.text.split("\n")
    snippet = lines[line - 1].rstrip("\r") if line <= len(lines) else ""
    token = _TOKEN.match(snippet, column - 1)
    width = len(token.group()) if token else 1
    return Diagnostic(
        code, str(source.path), line, column, message, mend, snippet, width=width, key=key
    )


def dotted(path: KeyPath) -> str:
    """Return a key path as it is written in TOML, places in arrays in brackets."""
    text = ""
    for key in path:
        if isinstance(key, int):
            text += f"[{key}]"
            continue
        bare = re.fullmatch(r"[A-Za-z0-9_-]+", key)
        text += ("." if text else "") + (key if bare else f'"{key}"')
    return text


@dataclass(frozen=True, slots=True, eq=False)
class Node:
    """A table, an array or a single value, and where it was written."""

    value: object
    source: Source
    path: KeyPath

    @property
    def table(self) -> dict[str, Node]:
        """Return the children of a table, none for anything else."""
        return self.value if isinstance(self.value, dict) else {}

    def plain(self) -> object:
        """Return the tree as tomllib would give it."""
        if isinstance(self.value, dict):
            return {key: child.plain() for key, child in self.value.items()}
        if isinstance(self.value, list):
            return [child.plain() for child in self.value]
        return self.value

    def find(self, path: KeyPath) -> tuple[Node, KeyPath]:
        """Return the deepest node on the way along `path`, and what of the path is left."""
        node = self
        for index, key in enumerate(path):
            child = node.child(key)
            if child is None:
                return node, path[index:]
            node = child
        return node, ()

    def child(self, key: str | int) -> Node | None:
        """Return one child; a point written as an array or a spot's name answers like a table."""
        if isinstance(self.value, str) and key == "spot":
            return self
        if isinstance(self.value, dict):
            child = self.value.get(key)
            return child if isinstance(child, Node) else None
        if isinstance(self.value, list):
            index = {"x": 0, "y": 1}.get(key, -1) if isinstance(key, str) else key
            if 0 <= index < len(self.value):
                found = self.value[index]
                return found if isinstance(found, Node) else None
        return None

    def diagnostic(
        self, code: str, path: KeyPath, message: str, mend: str = "", *, on_key: bool = False
    ) -> Diagnostic:
        """Return a mistake at `path` below this node, told in the file that wrote it."""
        node, rest = self.find(path)
        on_key = on_key or any(isinstance(key, str) for key in rest)
        return node.source.diagnostic(code, node.path + rest, message, mend, on_key=on_key)


def merge(base: Node, top: Node) -> Node:
    """Return `base` with everything that `top` says laid over it; arrays are replaced whole."""
    if not (isinstance(base.value, dict) and isinstance(top.value, dict)):
        return top
    table = dict(base.value)
    for key, child in top.value.items():
        table[key] = merge(table[key], child) if key in table else child
    return Node(table, top.source, top.path)


def read_text(
    path: Path, most: int = LARGEST_FILE, errors: str = "strict"
) -> str | list[Diagnostic]:
    """Return the text of a file of at most `most` bytes, or why there is none.

    A device or a pipe is not opened, for it may never end; `errors` is what `bytes.decode` does
    with a byte that is not UTF-8.
    """
    try:
        if not S_ISREG(path.stat().st_mode):
            reason = "it is a folder" if path.is_dir() else "it is no plain file"
            return [Diagnostic("V001", str(path), 1, 1, f"cannot read the file: {reason}")]
        with path.open("rb") as file:
            raw = file.read(most + 1)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or "cannot be read"
        return [Diagnostic("V001", str(path), 1, 1, f"cannot read the file: {reason}")]
    if len(raw) > most:
        message = f"the file is larger than {most // 1024} KiB"
        return [Diagnostic("V003", str(path), 1, 1, message, "split it into parts")]
    try:
        return raw.decode("utf-8-sig", errors).replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        line = raw[: error.start].count(b"\n") + 1
        column = error.start - (raw.rfind(b"\n", 0, error.start) + 1) + 1
        mend = "save the file in the encoding UTF-8"
        return [Diagnostic("V002", str(path), line, column, "this byte is not UTF-8", mend)]


def read_source(path: Path, home: Path) -> Node | list[Diagnostic]:
    """Read one TOML file; return its tree, or what is wrong with it as a whole."""
    text = read_text(path)
    return parse_source(text, path, home) if isinstance(text, str) else text


def parse_source(text: str, path: Path, home: Path) -> Node | list[Diagnostic]:
    """Return the tree of a TOML text, or what is wrong with it as a whole."""
    blank = Source(path, home, text, {})
    for number, line_text in enumerate(text.split("\n"), 1):
        if len(line_text) > LONGEST_LINE:
            message = f"a line is longer than {LONGEST_LINE} characters"
            return [Diagnostic("V003", str(path), number, 1, message, "break the line")]
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        return [_syntax(error, blank), *_further(error, text, path, home)]
    except (RecursionError, ValueError):
        mend = f"at most {DEEPEST} levels"
        return [Diagnostic("V003", str(path), 1, 1, "the file is nested too deeply", mend)]
    if _too_deep(data):
        message = f"the file is nested deeper than {DEEPEST} levels"
        return [Diagnostic("V003", str(path), 1, 1, message, "write it flatter")]
    return _grow(data, Source(path, home, text, locate(text)), ())


_PAIR = re.compile(r"\s*[\w.\"'-]+\s*[=:][^\[\]{}]*$")
_MOST_SYNTAX = 20


def _further(
    error: tomllib.TOMLDecodeError, text: str, path: Path, home: Path
) -> Iterator[Diagnostic]:
    """Give the mistakes of syntax below the first one, as long as single lines are wrong."""
    lines, source = text.split("\n"), Source(path, home, text, {})
    for _ in range(_MOST_SYNTAX):
        told = _syntax(error, source)
        if told.code == "V005" or not _PAIR.match(lines[told.line - 1]):
            return
        lines[told.line - 1] = ""
        try:
            tomllib.loads("\n".join(lines))
        except tomllib.TOMLDecodeError as next_error:
            error = next_error
            yield _syntax(error, source)
        except (RecursionError, ValueError):
            return
        else:
            return


def _too_deep(data: object) -> bool:
    """Tell without recursion whether a tree is deeper than DEEPEST."""
    level = [data]
    for _ in range(DEEPEST):
        level = [
            child
            for value in level
            if isinstance(value, dict | list)
            for child in (value.values() if isinstance(value, dict) else value)
        ]
    return bool(level)


def _grow(value: object, source: Source, path: KeyPath) -> Node:
    if isinstance(value, dict):
        table = {key: _grow(child, source, (*path, key)) for key, child in value.items()}
        return Node(table, source, path)
    if isinstance(value, list):
        array = [_grow(child, source, (*path, index)) for index, child in enumerate(value)]
        return Node(array, source, path)
    return Node(value, source, path)


_TWICE = ("Cannot overwrite a value", "Cannot declare", "Cannot mutate", "Duplicate inline")
_CURLY = ("\u201c", "\u201d", "\u201e", "\u2018", "\u2019", "\u00ab", "\u00bb")
_MENDS = (
    ("Invalid statement", "write `key = value`, `[heading]`, or `#` and a comment"),
    ("this is no quote", 'write straight quotes, as in "text"'),
    ("the list that begins", "close the list with `]`"),
    ("Invalid initial", "a key is letters, digits, `_` and `-`"),
    ("Unclosed inline", "close the table with `}`"),
    ("Unescaped", "write `\\\\` for a backslash, or use single quotes"),
    ("Invalid escape", "write `\\\\` for a backslash, or use single quotes"),
    ("Expected '='", "write `key = value`; a name with dots or spaces stands in quotes"),
    (
        "Invalid value",
        "a text stands in quotes, a number in digits; true and false are written small",
    ),
    ("Illegal character", "a text on one line ends with the quote it began with"),
    ("Unclosed array", "close the array with `]`"),
    ("the text that begins", "a text on one line ends with the quote it began with"),
    ("Expected ']'", "close the heading with `]`"),
    ("Unterminated string", "close the text with a quote"),
    ("Expected newline", "one statement on a line; join texts with a comma in an array"),
)


def _syntax(error: tomllib.TOMLDecodeError, source: Source) -> Diagnostic:
    told = str(error)
    found = _POSITION.search(told)
    message = told[: found.start()] if found else told
    line, column = source.text.count("\n") + 1, 1
    if found and found.group(1):
        line, column = int(found.group(1)), int(found.group(2))
    if message.startswith(_TWICE):
        line = _step_back(source.text, line, column)
        message, mend = _told_twice(source.text, line)
        return diagnostic_at("V005", source, line, 1, message, mend)
    if message == "Unclosed array":
        opened = _last_open(source.text.split("\n")[:line])
        if opened:
            line, column = opened
            message = "the list that begins here is not closed"
    if message == "Invalid initial character for a key part" and _in_braces(source.text, line):
        message = "a table in braces must end on the line where it begins"
        mend = "write it on one line, or as a [heading] with one `key = value` a line"
        return diagnostic_at("V004", source, line, column, message, mend)
    if message == 'Expected "\'"':
        lines = enumerate(source.text.split("\n"), 1)
        odd = [(number, text) for number, text in lines if text.count("'") % 2]
        line, column = (odd[-1][0], odd[-1][1].rfind("'") + 1) if odd else (line, column)
        message = "the text that begins here has no closing quote"
    if source.text.split("\n")[line - 1][column - 1 : column] in _CURLY:
        message = "this is no quote of TOML"
    heading = _HEADING.match(source.text.split("\n")[line - 1])
    if heading:
        message, mend = "the heading has no `[`", f"write `[{heading.group(1)}]`"
        return diagnostic_at("V004", source, line, 1, message, mend)
    unit = _UNIT.match(source.text.split("\n")[line - 1])
    if unit and message.startswith("Expected newline"):
        message, mend = "a number with a unit is a text", f'write "{unit.group(1)}"'
        return diagnostic_at("V004", source, line, column, message, mend)
    mend = next((mend for start, mend in _MENDS if message.startswith(start)), "")
    return diagnostic_at(
        "V004",
        source,
        line,
        column,
        _plainly(message),
        mend or "see the examples of the page on variant files",
    )


_HEADING = re.compile(r"\s*([A-Za-z0-9_.-]+)\]\s*(?:#.*)?$")
_UNIT = re.compile(r"[^=]*=\s*([0-9][0-9./ ]* ?[a-z°]+)\s*(?:#.*)?$")
_PLAIN = {
    "Illegal character '\\n'": "the text has no closing quote",
    "Invalid statement": "this is neither a key nor a heading",
    "Invalid value": "this is no value",
    "Expected '=' after a key in a key/value pair": "`=` is missing after the key",
    "Expected ']' at the end of a table declaration": "the heading is not closed",
    "Expected newline or end of document after a statement": "the line should end here",
}


def _plainly(message: str) -> str:
    return _PLAIN.get(message, message)


def _told_twice(text: str, line: int) -> tuple[str, str]:
    """Return what is said twice at `line`, and a mend that tells where it stood before."""
    lines = text.split("\n")
    name = lines[line - 1].split("=")[0].split("#")[0].strip()
    for number, earlier in enumerate(lines[: line - 1], 1):
        if earlier.split("=")[0].split("#")[0].strip() == name:
            return f"`{name}` is given twice", f"keep one of the two; the other is in line {number}"
    return _told_as_value(lines[: line - 1], name) or (
        f"`{name}` is given twice",
        "keep one of the two",
    )


def _told_as_value(lines: list[str], heading: str) -> tuple[str, str] | None:
    """Return what is wrong with a heading whose table was given as a value before, and a mend."""
    outer = heading.strip("[]").split(".")[0].strip()
    for number, earlier in enumerate(lines, 1):
        key, _, value = earlier.partition("=")
        if key.strip() == outer and value.strip():
            message = f"`{outer}` was given as a value in line {number}, and is a table here"
            part = value.split("#")[0].strip()
            return message, f"write `[{outer}]` and below it `use = {part[:60]}`"
    return None


def _last_open(lines: list[str]) -> tuple[int, int] | None:
    """Return line and column of the last list that begins and does not end on its line."""
    for number in range(len(lines), 0, -1):
        bare = re.sub(r"\"(?:[^\"\\]|\\.)*\"|'[^']*'|#.*", _blanked, lines[number - 1])
        if "=" in bare and bare.count("[") > bare.count("]"):
            return number, bare.index("[", bare.index("=")) + 1
    return None


def _blanked(match: re.Match[str]) -> str:
    return " " * len(match.group())


def _in_braces(text: str, line: int) -> bool:
    told = text.split("\n")[line - 1]
    return told.count("{") > told.count("}")


def _step_back(text: str, line: int, column: int) -> int:
    """Return the line of the statement that ends at the start of `line`."""
    return line - 1 if column == 1 and line > 1 and text else line
