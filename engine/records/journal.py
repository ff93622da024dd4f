"""The journal of a match: every shot on disk before the next one is played.

One idea: a journal is a shot record that grows. Each shot is appended as a whole block with a
closing line and flushed to the disk, so that a program killed at any moment loses at most the
shot that was not yet complete.
Invariant: nothing that was written is ever changed; an undo is a line of its own.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from types import MappingProxyType
from typing import TYPE_CHECKING

import tomli_w

from engine.game.match import Match, Played, advance, next_game
from engine.game.referee import judge_shot
from engine.records.blocks import (
    KEPT,
    TORN,
    UNDONE,
    begun_line,
    is_torn,
    left_line,
    names_line,
    names_of,
    seed_line,
    standing,
    times_left,
)
from engine.records.read import read_record_text
from engine.records.record import RecordError
from engine.records.say import expectation
from engine.records.write import before_table, shot_table
from engine.variant.source import read_text

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    from engine.records.blocks import Times
    from engine.records.read import Load

EMPTY_SHOT = '\n[[shot]]\nchoose = "play"\n[shot.expect]\n'


LARGEST = 16 * 1024 * 1024
"""Bytes of the longest journal that is read: some ten thousand shots."""

NOTHING: Mapping[str, float] = MappingProxyType({})

Sync = Callable[[int], None]
"""Brings a file, by its descriptor, from the system's memory to the disk."""

Entry = Played | int
"""What a journal tells: a shot, or that the next game was begun by a player."""


def entries_of(match: Match) -> list[Entry]:
    """Return the shots of a match, and who began each game after its first."""
    entries: list[Entry] = []
    games = match.played[0].before.games if match.played else match.situation.games
    for played in match.played:
        if played.before.games > games:
            entries.append(played.before.breaker)
        games = played.before.games
        entries.append(played)
    return [*entries, match.situation.breaker] if match.situation.games > games else entries


class Journal:
    """An open journal; append a shot when its verdict is known."""

    def __init__(self, path: Path, sync: Sync = os.fsync) -> None:
        """Write to `path`; `sync` sees to it that what was written outlives a loss of power."""
        self.path = path
        self._sync = sync

    @classmethod
    def begin(cls, path: Path, match: Match, sync: Sync = os.fsync) -> Journal:
        """Start a journal for a match, with the shots it has already; replaces a file there."""
        journal = cls(path, sync)
        path.parent.mkdir(parents=True, exist_ok=True)
        start = match.played[0].before if match.played else match.situation
        head = {
            "format": 1,
            "variant": match.variant.name,
            "title": f"A match of {match.variant.title}",
            "settings": dict(match.settings),
            "before": before_table(match.variant, start),
        }
        names = names_line(match.names) if match.names else ""
        text = f"{seed_line(match.seed)}{names}{tomli_w.dumps(head)}{KEPT}\n"
        path.write_text(text, encoding="utf-8")
        for entry in entries_of(match):
            journal.append(entry)
        return journal

    @classmethod
    def reopen(cls, path: Path, sync: Sync = os.fsync) -> Journal:
        """Go on with a journal; what a killed program left half written is marked as torn."""
        journal = cls(path, sync)
        if is_torn(path.read_text(encoding="utf-8", errors="replace")):
            journal.write_line(TORN)
        return journal

    def append(self, played: Entry, left: Mapping[str, float] = NOTHING) -> None:
        """Add one shot with its verdict, or the start of a game, and flush it to the disk.

        `left` are the seconds that each timer has then.
        """
        after = f"{left_line(left)}\n" if left else ""
        if isinstance(played, int):
            self.write_line(f"{begun_line(played)}\n{after}".rstrip("\n"))
            return
        expect = expectation(played.verdict, played.before)
        block = tomli_w.dumps({"shot": [{**shot_table(played.shot), "expect": expect}]})
        self._write(f"\n{block}{KEPT}\n{after}")

    def undo(self) -> None:
        """Note that the last shot, or the start of the last game, was taken back."""
        self.write_line(UNDONE)

    def note_time(self, left: Mapping[str, float]) -> None:
        """Note the seconds that each timer has left now."""
        if left:
            self.write_line(left_line(left))

    def write_line(self, line: str) -> None:
        """Add a closing line that stands for itself, whatever the file ends with."""
        ends = self.path.read_bytes()[-1:] in {b"", b"\n"}
        self._write(f"{'' if ends else chr(10)}{line}\n")

    def _write(self, text: str) -> None:
        with self.path.open("a", encoding="utf-8") as file:
            file.write(text)
            file.flush()
            self._sync(file.fileno())


def resume(path: Path, load: Load) -> Match:
    """Return the match that a journal holds, up to its last complete shot.

    Raises RecordError for a file that is no journal of a known variant.
    """
    text = read_text(path, LARGEST, "replace")
    if not isinstance(text, str):
        raise RecordError(tuple(text))
    # A record has at least one shot: an empty one is read where a journal has none yet.
    empty = "" if "[[shot]]" in standing(text) else f"\n{TORN}\n{EMPTY_SHOT}{KEPT}\n"
    record = read_record_text(text + empty, path, load)
    start = record.start
    match = Match(record.variant, start.seed, start.settings, start, names=names_of(text))
    breakers = record.begun
    for shots, step in enumerate(() if empty else record.steps):
        if shots in breakers:
            match = next_game(match, breakers[shots])
        verdict = judge_shot(match.variant, match.situation, step.shot)
        match = advance(match, step.shot, verdict)
    last = len(match.played)
    return next_game(match, breakers[last]) if last in breakers else match


def times_of(path: Path) -> Times:
    """Return what time each timer had left at each moment of a journal."""
    return times_left(path.read_text(encoding="utf-8", errors="replace"))
