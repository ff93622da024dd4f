"""A screen to open windows on: the one there is, else a virtual X display of our own.

Invariant: a display that was started here ends with the block that asked for it.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

SCREEN = "1920x1080x24"


class NoDisplayError(RuntimeError):
    """There is no screen here and none can be made; the message says what to install."""


@contextmanager
def virtual_display() -> Iterator[str]:
    """Start Xvfb on a free number and yield the display's name.

    Raises NoDisplayError where Xvfb is missing or does not come up.
    """
    command = shutil.which("Xvfb")
    if command is None:
        raise NoDisplayError("no display: install Xvfb (Debian: xvfb), or set DISPLAY")
    told, tell = os.pipe()
    server = subprocess.Popen(
        [command, "-displayfd", str(tell), "-screen", "0", SCREEN, "-nolisten", "tcp"],
        pass_fds=(tell,),
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    os.close(tell)
    try:
        with os.fdopen(told) as answer:
            number = answer.readline().strip()
        if not number:
            raise NoDisplayError(f"Xvfb ended with status {server.wait()}")
        yield f":{number}"
    finally:
        server.terminate()
        server.wait()


@contextmanager
def display() -> Iterator[tuple[str, str]]:
    """Yield the display's name and whose it is: "yours" where DISPLAY is set, else "virtual"."""
    if os.environ.get("DISPLAY"):
        yield os.environ["DISPLAY"], "yours"
        return
    with virtual_display() as name:
        yield name, "virtual"


__all__ = ["NoDisplayError", "display", "virtual_display"]
