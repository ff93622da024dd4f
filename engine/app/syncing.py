"""Bringing what was written to the disk, beside the game.

One idea: what was handed to the system outlives the program at once; that it outlives a loss of
power too takes the disk its time, for which no frame waits. Invariant: what was handed over first
is on the disk first.
"""

from __future__ import annotations

import os
from contextlib import suppress
from dataclasses import dataclass, field
from queue import SimpleQueue
from threading import Thread


@dataclass(slots=True)
class Syncer:
    """Brings files to the disk in a thread of its own."""

    _waiting: SimpleQueue[int | None] = field(default_factory=SimpleQueue)
    _thread: Thread | None = None

    def sync(self, file: int) -> None:
        """Let a file, by its descriptor, be brought to the disk soon."""
        if self._thread is None:
            self._thread = Thread(target=self._run, name="syncing", daemon=True)
            self._thread.start()
        self._waiting.put(os.dup(file))

    def close(self) -> None:
        """Wait until everything is on the disk."""
        if self._thread is not None:
            self._waiting.put(None)
            self._thread.join()
            self._thread = None

    def _run(self) -> None:
        while (file := self._waiting.get()) is not None:
            with suppress(OSError):
                os.fsync(file)
            os.close(file)
