"""A display for a window where there is no screen.

One idea: a virtual display is started for as long as it is needed and ended by its own process.
"""

from __future__ import annotations

import os
import subprocess
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

HEADLESS, VIRTUAL, OWN = "headless", "virtual", "own"
DISPLAYS = (VIRTUAL, HEADLESS, OWN)
"""No display at all, a virtual one, or the one that is there."""


@contextmanager
def display(kind: str, size: tuple[int, int]) -> Iterator[dict[str, str]]:
    """Lend the environment of a window: `kind` of display, `size` in pixels.

    Raises FileNotFoundError where a virtual display is wanted and Xvfb is not installed.
    """
    env = {**os.environ, "SDL_AUDIODRIVER": "dummy", "PYGAME_HIDE_SUPPORT_PROMPT": "hide"}
    if kind == HEADLESS:
        yield {**env, "SDL_VIDEODRIVER": "dummy"}
    elif kind == OWN:
        yield env
    else:
        with _virtual(size) as name:
            env.pop("SDL_VIDEODRIVER", None)
            yield {**env, "DISPLAY": name}


@contextmanager
def _virtual(size: tuple[int, int]) -> Iterator[str]:
    reads, writes = os.pipe()
    screen = f"{max(size[0], 640)}x{max(size[1], 480)}x24"
    command = ["Xvfb", "-displayfd", str(writes), "-screen", "0", screen, "-nolisten", "tcp"]
    server = subprocess.Popen(command, pass_fds=(writes,), stderr=subprocess.DEVNULL)
    os.close(writes)
    try:
        with os.fdopen(reads) as answer:
            number = answer.readline().strip()
        if not number:
            raise FileNotFoundError("Xvfb did not start")
        yield f":{number}"
    finally:
        server.terminate()
        server.wait()
