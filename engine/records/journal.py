"""The journal of a match: every shot on disk before the next one is played.

One idea: a journal is a shot record that grows. Each shot is appended as a whole block with a
closing line and flushed to the disk, so that a program killed at any moment loses at most the
shot that was not yet complete.
Invariant: nothing that was written is ever changed; an undo is a line of its own.
"""

from __future__ import annotations

import os
import re
from dataclasses import replace
from typing import TYPE_CHECKING

import tomli_w

from engine.game.match import Match, advance
from engine.game.referee import judge_shot
from engine.records.read import read_record_text
from engine.records.say import expectation
from engine.records.write import before_table, shot_table

if TYPE_CHECKING:
    from pathlib import Path

    from engine.game.match import Played
    from engine.records.read import Load

KEPT = "# kept"
UNDONE = "# undone"
_SEED = re.compile(r"^# seed (-?\d+)$", re.MULTILINE)


class Journal:
    """An open journal; append a shot when its verdict is known."""

    def __init__(self, path: Path) -> None:
        self.path = path

    @classmethod
    def begin(cls, path: Path, match: Match) -> Journal:
        """Start a journal for a match, with the shots it has already; replaces a file there."""
        journal = cls(path)
        path.parent.mkdir(parents=True, exist_ok=True)
        start = match.played[0].before if match.played else match.situation
        head = {
            "format": 1,
            "variant": match.variant.name,
            "title": f"A match of {match.variant.title}",
            "settings": dict(match.settings),
            "before": before_table(match.variant, start),
        }
        text = f"# seed {match.seed}\n{tomli_w.dumps(head)}{KEPT}\n"
        path.write_text(text, encoding="utf-8")
        for played in match.played:
            journal.append(played)
        return journal

    def append(self, played: Played) -> None:
        """Add one shot with its verdict and flush it to the disk."""
        expect = expectation(played.verdict, played.before)
        block = tomli_w.dumps({"shot": [{**shot_table(played.shot), "expect": expect}]})
        self._write(f"\n{block}{KEPT}\n")

    def undo(self) -> None:
        """Note that the last shot was taken back."""
        self._write(f"{UNDONE}\n")

    def _write(self, text: str) -> None:
        with self.path.open("a", encoding="utf-8") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())


def resume(path: Path, load: Load) -> Match:
    """Return the match that a journal holds, up to its last complete shot.

    Raises RecordError for a file that is no journal of a known variant.
    """
    text = path.read_text(encoding="utf-8", errors="replace")
    head, blocks = _blocks(text)
    found = _SEED.search(text)
    seed = int(found[1]) if found else 0
    # A record has at least one shot: an empty one is added to read a journal without any.
    shots = "".join(blocks) or '\n[[shot]]\nchoose = "play"\n[shot.expect]\n'
    record = read_record_text(head + shots, path, load)
    match = Match(record.variant, seed, record.start.settings, replace(record.start, seed=seed))
    for step in record.steps[: len(blocks)]:
        verdict = judge_shot(match.variant, match.situation, step.shot)
        match = advance(match, step.shot, verdict)
    return match


def _blocks(text: str) -> tuple[str, list[str]]:
    """Return the head and the complete shots that were not taken back."""
    blocks: list[str] = []
    current = ""
    for line in text.splitlines(keepends=True):
        if line.rstrip("\n") == UNDONE:
            blocks = blocks[:-1] if len(blocks) > 1 else blocks
            current = ""
        elif line.rstrip("\n") == KEPT and line.endswith("\n"):
            blocks.append(current)
            current = ""
        else:
            current += line
    return (blocks[0], blocks[1:]) if blocks else (text, [])
