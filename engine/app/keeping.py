"""What is kept on disk: the journal of the match, and shots saved as records.

One idea: the keeper follows the match; whatever the match became, by a shot, an undo or a new
game, the journal tells it. Invariant: a shot is on disk before the next one can be played.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from typing import TYPE_CHECKING

from engine.app.arranging import load_layout, save_layout
from engine.records.journal import NOTHING, Journal, entries_of
from engine.records.write import save_shot_record

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from pathlib import Path

    from engine.app.session import Session
    from engine.game.match import Match
    from engine.game.situation import Situation


@dataclass(slots=True)
class Keeper:
    """Keeps the journal of a match at `path`, and shots in `folder`; `sync` as in Journal."""

    path: Path
    folder: Path
    sync: Callable[[int], None] = os.fsync
    _journal: Journal | None = None
    _known: Match | None = None
    _laid: int = 0

    def start(self, match: Match) -> None:
        """Begin the journal with the shots that a match has already."""
        self._journal, self._known = Journal.begin(self.path, match, self.sync), match

    def carry_on(self, match: Match) -> None:
        """Go on with a journal that holds this match already."""
        self._journal, self._known = Journal.reopen(self.path, self.sync), match

    def follow(self, match: Match, left: Mapping[str, float] = NOTHING) -> None:
        """Write down what changed since the match was seen last, and the time `left` (s) now."""
        known, self._known = self._known, match
        if self._journal is None or known is None:
            return
        shared = _shared(known, match)
        if match.seed != known.seed or shared is None:
            self.path = _later(self.path)
            self._journal = Journal.begin(self.path, match, self.sync)
            self._journal.note_time(left)
            return
        for _ in entries_of(known)[shared:]:
            self._journal.undo()
        fresh = entries_of(match)[shared:]
        for entry in fresh[:-1]:
            self._journal.append(entry)
        if fresh:
            self._journal.append(fresh[-1], left)
        else:
            self._journal.note_time(left)

    def leave(self, left: Mapping[str, float]) -> None:
        """Note the time `left` (s) when the player goes."""
        if self._journal is not None:
            self._journal.note_time(left)

    def save_shot(self, match: Match) -> str:
        """Save the last shot as a record; return what to tell the player."""
        if not match.played:
            return "there is no shot to save yet"
        now = datetime.now(tz=UTC).strftime("%Y%m%d-%H%M%S")
        path = self.folder / f"{match.variant.name}-{now}-shot-{len(match.played)}.toml"
        try:
            save_shot_record(path, match)
        except OSError as trouble:
            return f"the shot could not be saved: {trouble}"
        return f"saved {shown_path(path)}"

    def keep_layout(self, session: Session) -> str:
        """Keep where the balls lie now; return what to tell the player."""
        folder, name = self.folder.parent / "layouts", session.variant.name
        number = 1 + len(list(folder.glob(f"{name}-*.toml")))
        path = folder / f"{name}-{number:03}.toml"
        lying = replace(session.ahead, rest=replace(session.ahead.rest, positions=session.layout))
        try:
            save_layout(path, session.variant, lying)
        except OSError as trouble:
            return f"the layout could not be kept: {trouble}"
        return f"kept {shown_path(path)}"

    def next_layout(self, session: Session) -> tuple[str, Situation] | None:
        """Return name and situation of the next layout that was kept; raises LayoutError."""
        kept = sorted((self.folder.parent / "layouts").glob(f"{session.variant.name}-*.toml"))
        if not kept:
            return None
        path = kept[self._laid % len(kept)]
        self._laid += 1
        return path.stem, load_layout(path, session.variant, session.match.situation)


def shown_path(path: Path) -> str:
    """Return a path as a player would write it."""
    home = path.home()
    return f"~/{path.relative_to(home)}" if path.is_relative_to(home) else str(path)


def _shared(one: Match, two: Match) -> int | None:
    """Return how many entries two states of a match share; None where they are not the same."""
    count = 0
    for a, b in zip(entries_of(one), entries_of(two), strict=False):
        if a is not b and not (isinstance(a, int) and a == b):
            break
        count += 1
    if count == 0 and one.played and two.played and one.played[0].before != two.played[0].before:
        return None
    return count


def _later(path: Path) -> Path:
    """Return a name beside `path` for the next game's journal."""
    number = 2
    while (later := path.with_name(f"{path.stem}-{number}{path.suffix}")).exists():
        number += 1
    return later
