"""Frames a second of the real loop: each renderer, while aiming and while balls roll.

One idea: time is taken from one frame's start to the next one's, everything included, with the
rate set higher than any machine keeps up with.

    python -m tools.frame_rate [VARIANT] [--size 1280x720] [--frames 240]
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from statistics import median, quantiles
from time import perf_counter
from typing import TYPE_CHECKING

from engine.app import commands
from engine.app.session import SHOWING, Mode
from engine.app.steps import act

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from engine.app.loop import Loop

KEYS = {"1": "wireframe", "2": "painter", "3": "scanline"}
HARD = 9.0
TURN = 0.5
"""Degrees that the aim turns in every frame, so that the aid is worked out anew."""


@dataclass(slots=True)
class Measure:
    """Takes the times; `found` has milliseconds by renderer, camera and what was done."""

    frames: int
    found: dict[tuple[str, str, str], list[float]] = field(default_factory=dict)
    _script: Iterator[None] | None = None
    _last: float = 0.0

    def each(self, loop: Loop) -> None:
        """Do the next step; to be called before every frame."""
        self._script = self._script or self._measure(loop)
        if next(self._script, self) is self:
            loop.running = False

    def _measure(self, loop: Loop) -> Iterator[None]:
        while len(loop.startup.renderers) < len(KEYS):
            yield
        for name in KEYS.values():
            loop.renderer = name
            for _ in range(3):
                loop.view = loop.view.next_camera()
                yield from self._aiming(loop, name)
                yield from self._rolling(loop, name)

    def _aiming(self, loop: Loop, name: str) -> Iterator[None]:
        while loop.session.mode is not Mode.AIMING:
            loop.session = act(loop.session, commands.Confirm())
            yield
        turns = iter(range(self.frames))
        yield from self._timed(loop, (name, loop.view.camera, "aiming"), turns, commands.Turn(TURN))
        for _ in range(self.frames):
            loop.session = act(loop.session, commands.Turn(-TURN))

    def _rolling(self, loop: Loop, name: str) -> Iterator[None]:
        for command in (commands.SetSpeed(HARD), commands.Confirm()):
            loop.session = act(loop.session, command)
        shown = (one for one in range(self.frames) if loop.session.mode in SHOWING)
        yield from self._timed(loop, (name, loop.view.camera, "rolling"), shown, None)
        loop.session = act(loop.session, commands.Skip())
        loop.session = act(loop.session, commands.Undo())
        yield

    def _timed(
        self,
        loop: Loop,
        what: tuple[str, str, str],
        turns: Iterator[int],
        command: commands.Command | None,
    ) -> Iterator[None]:
        times = self.found.setdefault(what, [])
        yield
        before = perf_counter()
        for _ in turns:
            if command is not None:
                loop.session = act(loop.session, command)
            yield
            now = perf_counter()
            times.append(1000.0 * (now - before))
            before = now


def report(found: dict[tuple[str, str, str], list[float]]) -> str:
    """Return a table of median and 95th percentile, ms, and frames a second of the latter."""
    rows = ["renderer   camera  doing     median ms   p95 ms   fps at p95"]
    for (name, camera, doing), times in found.items():
        if len(times) > 1:
            slow = quantiles(times, n=20)[-1]
            rows.append(
                f"{name:10} {camera:7} {doing:8} {median(times):10.1f} {slow:8.1f}"
                f" {1000.0 / slow:12.0f}"
            )
    return "\n".join(rows)


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure and print."""
    parser = argparse.ArgumentParser(prog="python -m tools.frame_rate", description=__doc__)
    parser.add_argument("variant", nargs="?", default="snooker")
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--frames", type=int, default=240)
    asked = parser.parse_args(arguments)
    from engine.app.play import play  # noqa: PLC0415  pygame is slow to import

    width, _, height = asked.size.partition("x")
    measure = Measure(asked.frames)
    with tempfile.TemporaryDirectory() as folder:
        status = play(
            asked.variant,
            size=(int(width), int(height)),
            rate=1000,
            seed=1,
            journal=Path(folder) / "journal.toml",
            each=measure.each,
        )
    print(report(measure.found))
    return status


if __name__ == "__main__":
    sys.exit(main())
