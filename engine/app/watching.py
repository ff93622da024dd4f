"""Files that are watched while a game is played, so that an author sees what he saves.

One idea: a file has changed when its time or its size is another one. Invariant: nothing is read
here, and a file that comes or goes is a change too.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from time import monotonic
from typing import TYPE_CHECKING

from engine.variant.library import shipped_folder

if TYPE_CHECKING:
    from pathlib import Path

    from engine.variant.variant import Variant

PAUSE = 0.5
"""Seconds between two looks at the files."""

Stamps = dict["Path", tuple[int, int]]


@dataclass(slots=True)
class Watch:
    """Watches the folders that a variant's files and parts may stand in."""

    folders: tuple[Path, ...]
    pause: float = PAUSE
    _stamps: Stamps = field(default_factory=dict)
    _looked: float = field(default_factory=monotonic)

    def __post_init__(self) -> None:
        self._stamps = stamps(self.folders)

    def changed(self) -> bool:
        """Say whether a file has changed since this was asked last."""
        if monotonic() - self._looked < self.pause:
            return False
        self._looked = monotonic()
        before, self._stamps = self._stamps, stamps(self.folders)
        return before != self._stamps


def watch_variant(variant: Variant, pause: float = PAUSE) -> Watch:
    """Return a watch over the files that a variant may be made of."""
    own = {variant.path.resolve().parent, variant.script_path.resolve().parent}
    return Watch(tuple(sorted(own | {shipped_folder().resolve()})), pause)


def stamps(folders: tuple[Path, ...]) -> Stamps:
    """Return time (ns) and size of the variant files and scripts in folders and one below."""
    found: Stamps = {}
    for folder in folders:
        for pattern in ("*.toml", "*.rules", "*/*.toml", "*/*.rules"):
            for path in folder.glob(pattern):
                try:
                    state = path.stat()
                except OSError:
                    continue
                found[path] = state.st_mtime_ns, state.st_size
    return found
