"""Where every key and value of a TOML text stands.

One idea: a text that tomllib accepts can be walked again by a scanner that need not judge it,
only follow it, and notes a place for each key path.
Invariant: the scanner reports exactly the key paths of the tree that tomllib builds.
"""

from __future__ import annotations

import re
import tomllib
from bisect import bisect_right

from rulelang.frozen import value

KeyPath = tuple[str | int, ...]
"""Keys from the top of a file down; an int is a place in an array."""

_BARE = re.compile(r"[A-Za-z0-9_-]+")
_SKIP = re.compile(r"[ \t]*")
_BLANK = re.compile(r"(?:[ \t\r\n]|#[^\n]*)*")
_SCALAR = re.compile(r"[^,\]}\n#]*")
_QUOTED = re.compile(
    r"'''.*?'{3,5}"
    r'|"""(?:[^\\]|\\.)*?"{3,5}'
    r"|'[^'\n]*'"
    r'|"(?:[^"\\\n]|\\.)*"',
    re.DOTALL,
)


@value
class Place:
    """Line and column, both from 1, of a key and of the value it names.

    In an array the key's place is the value's own.
    """

    line: int
    column: int
    value_line: int
    value_column: int


def locate(text: str) -> dict[KeyPath, Place]:
    """Return the place of every key path in `text`, which tomllib must have accepted."""
    return _Scanner(text).scan()


class _Scanner:
    """One walk over one text."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.at = 0
        self.starts = [0, *(match.end() for match in re.finditer("\n", text))]
        self.places: dict[KeyPath, Place] = {}
        self.counts: dict[KeyPath, int] = {}

    def scan(self) -> dict[KeyPath, Place]:
        table: KeyPath = ()
        self.skip(_BLANK)
        while self.at < len(self.text):
            if self.text.startswith("[[", self.at):
                table = self.header(2)
            elif self.text.startswith("[", self.at):
                table = self.header(1)
            else:
                self.pair(table)
            self.skip(_BLANK)
        return self.places

    def skip(self, pattern: re.Pattern[str]) -> None:
        match = pattern.match(self.text, self.at)
        self.at = match.end() if match else self.at

    def position(self, at: int) -> tuple[int, int]:
        line = bisect_right(self.starts, at)
        return line, at - self.starts[line - 1] + 1

    def note(self, path: KeyPath, key: int, value: int) -> None:
        if path not in self.places:
            self.places[path] = Place(*self.position(key), *self.position(value))

    def header(self, brackets: int) -> KeyPath:
        self.at += brackets
        keys = self.dotted_key()
        self.at += brackets
        path: KeyPath = ()
        for index, (key, at) in enumerate(keys):
            path = (*path, key)
            last = index == len(keys) - 1
            self.note(path, at, at)
            if last and brackets == 2:
                self.counts[path] = self.counts.get(path, 0) + 1
            if path in self.counts:
                path = (*path, self.counts[path] - 1)
                self.note(path, at, at)
        return path

    def dotted_key(self) -> list[tuple[str, int]]:
        keys = []
        while True:
            self.skip(_SKIP)
            start = self.at
            keys.append((self.simple_key(), start))
            self.skip(_SKIP)
            if not self.text.startswith(".", self.at):
                return keys
            self.at += 1

    def simple_key(self) -> str:
        if self.text[self.at] in "\"'":
            start = self.at
            self.skip(_QUOTED)
            return str(tomllib.loads("k = " + self.text[start : self.at])["k"])
        match = _BARE.match(self.text, self.at)
        if match is None:
            message = f"no key at offset {self.at}"
            raise ValueError(message)
        self.at = match.end()
        return match.group()

    def pair(self, table: KeyPath) -> None:
        keys = self.dotted_key()
        self.at += 1
        self.skip(_SKIP)
        path = table
        for key, at in keys[:-1]:
            path = (*path, key)
            self.note(path, at, at)
        path = (*path, keys[-1][0])
        self.note(path, keys[-1][1], self.at)
        self.value(path)

    def value(self, path: KeyPath) -> None:
        head = self.text[self.at : self.at + 1]
        if head == "[":
            self.array(path)
        elif head == "{":
            self.inline_table(path)
        elif head in ('"', "'"):
            self.skip(_QUOTED)
        else:
            self.skip(_SCALAR)

    def array(self, path: KeyPath) -> None:
        self.at += 1
        index = 0
        self.skip(_BLANK)
        while self.text[self.at] != "]":
            self.note((*path, index), self.at, self.at)
            self.value((*path, index))
            index += 1
            self.separator()
        self.at += 1

    def inline_table(self, path: KeyPath) -> None:
        self.at += 1
        self.skip(_BLANK)
        while self.text[self.at] != "}":
            self.pair(path)
            self.separator()
        self.at += 1

    def separator(self) -> None:
        self.skip(_BLANK)
        if self.text[self.at] == ",":
            self.at += 1
            self.skip(_BLANK)
