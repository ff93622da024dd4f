"""The closing lines of a journal, which a record without them does not have.

One idea: a journal's blocks end in a line of their own, so that what is complete and what was taken
back can be told from the text alone. Invariant: lines keep their numbers; what does not count is
blank.
"""

from __future__ import annotations

import json
import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

KEPT = "# kept"
UNDONE = "# undone"
TORN = "# torn"
_BEGUN = re.compile(r"^# game begun by ([1-9]\d*)\n$")
_LEFT = re.compile(r"^# left (\{.*\})\n$")
_NAMES = re.compile(r"^# names (\[.*\])$", re.MULTILINE)
_SEED = re.compile(r"^# seed (-?\d+)$", re.MULTILINE)

Block = tuple[int, int]
"""The lines from the first up to the one behind the last."""


def seed_line(seed: int) -> str:
    """Return the line that names the seed of a match."""
    return f"# seed {seed}\n"


def seed_of(text: str) -> int:
    """Return the seed that a journal names, 0 for any other record."""
    found = _SEED.search(text)
    return int(found[1]) if found else 0


def names_line(names: Iterable[str]) -> str:
    """Return the line that names the players of a match."""
    return f"# names {json.dumps(list(names))}\n"


def names_of(text: str) -> tuple[str, ...]:
    """Return the players' names in a journal; none for any other record."""
    found = _NAMES.search(text)
    return tuple(map(str, json.loads(found[1]))) if found else ()


def left_line(left: Mapping[str, float]) -> str:
    """Return the line that tells how many seconds each timer has left."""
    return f"# left {json.dumps({name: round(time, 3) for name, time in left.items()})}"


Times = dict[tuple[int, int], dict[str, float]]
"""Seconds left on each timer, by the games begun after the first and the shots before."""


def times_left(text: str) -> Times:
    """Return what time was left at each moment of a journal that still counts."""
    moments: list[tuple[int, int]] = []
    found: Times = {}
    for line in text.splitlines(keepends=True):
        games, shots = moments[-1] if moments else (0, -1)
        if line == f"{KEPT}\n":
            moments.append((games, shots + 1))
        elif _BEGUN.match(line):
            moments.append((games + 1, shots))
        elif line == f"{UNDONE}\n" and len(moments) > 1:
            moments.pop()
        elif (left := _LEFT.match(line)) and moments:
            found[moments[-1]] = {name: float(time) for name, time in json.loads(left[1]).items()}
    return {moment: left for moment, left in found.items() if moment in moments}


def begun_line(breaker: int) -> str:
    """Return the line that tells of the match's next game, and who breaks."""
    return f"# game begun by {breaker}"


def games_begun(text: str) -> list[tuple[int, int]]:
    """Return the games that follow the first in a journal: the shots before each, the breaker."""
    lines = text.splitlines(keepends=True)
    found, shots = [], -1
    for _, end in _blocks(lines):
        begun = _BEGUN.match(lines[end])
        if begun:
            found.append((shots, int(begun[1])))
        else:
            shots += 1
    return found


def standing(text: str) -> str:
    """Return a journal's text without shots taken back and without an incomplete one at its end.

    The text of any other record is returned as it is.
    """
    lines = text.splitlines(keepends=True)
    blocks = _blocks(lines)
    if not blocks:
        return text
    kept = {number for start, end in blocks for number in range(start, end)}
    return "".join(line if number in kept else "\n" for number, line in enumerate(lines))


def _blocks(lines: list[str]) -> list[Block]:
    """Return the blocks that stand: the head, then one for each shot and each later game."""
    blocks: list[Block] = []
    start = 0
    for number, line in enumerate(lines):
        if line == f"{KEPT}\n" or _BEGUN.match(line):
            blocks.append((start, number))
            start = number + 1
        elif line == f"{UNDONE}\n":
            blocks = blocks[:-1] if len(blocks) > 1 else blocks
            start = number + 1
        elif line == f"{TORN}\n" or _LEFT.match(line):
            start = number + 1
    return blocks


def is_torn(text: str) -> bool:
    """Return whether a journal ends within a block."""
    last = text.rpartition("\n")[0].rpartition("\n")[2] if text.endswith("\n") else text
    alone = _BEGUN.match(f"{last}\n") or _LEFT.match(f"{last}\n")
    return bool(text) and last not in {KEPT, UNDONE, TORN} and not alone
