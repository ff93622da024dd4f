"""The closing lines of a journal, which a record without them does not have.

One idea: a journal's blocks end in a line of their own, so that what is complete and what was taken
back can be told from the text alone. Invariant: lines keep their numbers; what does not count is
blank.
"""

from __future__ import annotations

import re

KEPT = "# kept"
UNDONE = "# undone"
TORN = "# torn"
_BEGUN = re.compile(r"^# game begun by ([1-9]\d*)\n$")
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
        elif line == f"{TORN}\n":
            start = number + 1
    return blocks


def is_torn(text: str) -> bool:
    """Return whether a journal ends within a block."""
    last = text.rpartition("\n")[0].rpartition("\n")[2] if text.endswith("\n") else text
    return bool(text) and last not in {KEPT, UNDONE, TORN} and not _BEGUN.match(f"{last}\n")
