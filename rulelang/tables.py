"""The parser's tables, kept in a file between processes.

One idea: a file of plain lines, signed with what it was made from; whatever is not exactly that is
made anew. Invariant: reading a file runs nothing that stands in it, and a broken or foreign one is
as good as none.
"""

from __future__ import annotations

import os
from contextlib import suppress
from typing import TYPE_CHECKING
from zlib import crc32

from rulelang.automaton import Automaton, Recipe
from rulelang.frozen import value

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

FILE = "rulelang.tables"
_VERSION = "headstring tables 1"
_MOST = 2_000_000
"""No file of tables has so many bytes."""


@value
class Tables:
    """What an Automaton is made of."""

    start: int
    end: int
    words: Mapping[str, str]
    names: tuple[str, ...]
    recipes: tuple[Recipe, ...]
    rows: tuple[str, ...]

    def automaton(self) -> Automaton:
        """Return the parser that walks these tables."""
        return Automaton(self.start, self.end, self.words, self.names, self.recipes, self.rows)


def kept_tables(grammar: Path, folder: Path | None) -> Tables:
    """Return the tables of a grammar, from `folder` where they are kept, or made and kept there.

    Where nothing can be read or written, they are made and not kept.
    """
    if folder is None:
        return _made()
    source = grammar.read_bytes()
    found = _read(folder / FILE, source)
    if found is not None:
        return found
    made = _made()
    _keep(folder, written(made, source))
    return made


def _made() -> Tables:
    from rulelang.making import make_tables  # noqa: PLC0415  Lark is slow to import

    return make_tables()


def _read(path: Path, source: bytes) -> Tables | None:
    try:
        if path.stat().st_size > _MOST:
            return None
        return read(path.read_text(encoding="utf-8"), source)
    except (OSError, ValueError):
        return None


def _keep(folder: Path, text: str) -> None:
    """Put a text into the folder at once, so that nobody reads half of it."""
    own = folder / f"{FILE}.{os.getpid()}"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        own.write_text(text, encoding="utf-8")
        own.replace(folder / FILE)
    except OSError:
        with suppress(OSError):
            own.unlink()


def written(tables: Tables, source: bytes) -> str:
    """Return tables of the grammar `source` as text: a signature, then a line for each thing."""
    lines = [
        f"{tables.start} {tables.end} {len(tables.recipes)}",
        " ".join(part for pair in tables.words.items() for part in pair),
        " ".join(tables.names),
        *(_recipe_line(one) for one in tables.recipes),
        *tables.rows,
    ]
    body = "\n".join(lines)
    return f"{_signature(source, body)}\n{body}"


def read(text: str, source: bytes) -> Tables | None:
    """Return the tables that a text holds, None where they are of another grammar or broken."""
    signature, _, body = text.partition("\n")
    if signature != _signature(source, body):
        return None
    head, words, names, *rest = body.split("\n")
    start, end, count = (int(part) for part in head.split())
    pairs = words.split(" ")
    return Tables(
        start,
        end,
        dict(zip(pairs[::2], pairs[1::2], strict=True)),
        tuple(names.split(" ")),
        tuple(_recipe_of(line) for line in rest[:count]),
        tuple(rest[count:]),
    )


def _signature(source: bytes, body: str) -> str:
    told = body.encode()
    return f"{_VERSION} {len(source)} {crc32(source):08x} {len(told)} {crc32(told):08x}"


def _recipe_line(one: Recipe) -> str:
    picks = "*"
    if one.picks is not None:
        picks = ",".join(f"{n}/{spread:d}/{absent}" for n, spread, absent in one.picks)
    return f"{one.size} {one.name} {one.data} {one.single:d} {one.absent} {picks}"


def _recipe_of(line: str) -> Recipe:
    size, name, data, single, absent, picks = line.split(" ")
    return Recipe(int(size), name, data, bool(int(single)), _picks(picks), int(absent))


def _picks(text: str) -> tuple[tuple[int, bool, int], ...] | None:
    if text == "*":
        return None
    parts = [part.split("/") for part in text.split(",") if part]
    return tuple((int(n), bool(int(spread)), int(absent)) for n, spread, absent in parts)
