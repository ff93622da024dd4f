"""Pictures of the last shot, made beside the game.

One idea: what takes long is done by a thread of its own with values that never change, so the game
goes on; what came of it is told when it is there.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from datetime import UTC, datetime
from threading import Thread
from typing import TYPE_CHECKING

from engine.app.clip import NoStrokeError, outcome_of, write_clip
from engine.app.keeping import shown_path
from engine.proving.pictures import draw_outcome
from engine.records.record import RecordError

if TYPE_CHECKING:
    from pathlib import Path

    from engine.game.match import Match

ENDINGS = {"picture": "png", "clip": "gif", "paths": "png"}


@dataclass(slots=True)
class Exporter:
    """Makes pictures into `folder`; `told` is what came of the last one, until it is taken."""

    folder: Path
    told: str = ""
    _thread: Thread | None = None

    @property
    def busy(self) -> bool:
        """Whether a picture is being made."""
        return self._thread is not None and self._thread.is_alive()

    def path(self, kind: str, match: Match) -> Path:
        """Return a name for a new picture."""
        now = datetime.now(tz=UTC).strftime("%Y%m%d-%H%M%S")
        stem = f"{match.variant.name}-{now}-shot-{len(match.played)}-{kind}"
        return self.folder / f"{stem}.{ENDINGS[kind]}"

    def begin(self, kind: str, match: Match) -> str:
        """Begin to make a "clip" or the "paths" of the last stroke; return what to tell now."""
        if self.busy:
            return "the last picture is still being made"
        strokes = [k for k, one in enumerate(match.played) if one.shot.strike is not None]
        if not strokes:
            return "there is no stroke to show yet"
        until = strokes[-1] + 1
        path = self.path(kind, match)
        self._thread = Thread(target=self._make, args=(kind, path, match, until), daemon=True)
        self._thread.start()
        return "the picture is being made ..."

    def join(self) -> None:
        """Wait until nothing is being made."""
        if self._thread is not None:
            self._thread.join()

    def take(self) -> str:
        """Return what came of a picture, once."""
        told, self.told = self.told, ""
        return told

    def _make(self, kind: str, path: Path, match: Match, until: int) -> None:
        try:
            self.told = self._made(kind, path, match, until)
        except (NoStrokeError, RecordError, OSError) as trouble:
            self.told = f"the picture could not be made: {trouble}"

    @staticmethod
    def _made(kind: str, path: Path, match: Match, until: int) -> str:
        last = match.played[until - 1]
        if kind == "clip":
            write_clip(path, match.variant, last.before, last.shot)
        elif not draw_outcome(outcome_of(replace(match, played=match.played[:until])), path):
            return "there is nothing to draw: no place is known"
        return f"saved {shown_path(path)}"


__all__ = ["ENDINGS", "Exporter"]
