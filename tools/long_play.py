"""Half an hour of play in the real window, for memory that grows and frames that take too long.

One idea: a scripted player goes on from game to game; after each frame the time that it took and
what it did are noted, and every few seconds the memory of the process. What the player thinks is
not counted, for a person would not think in the window's time. Where other programs take the
processor away, `--work` counts only the time in which the window's thread was at work.

    python -m tools.long_play [--minutes 30] [--games NAME,NAME] [--display virtual|headless|own]

Exit status 0: no frame over 50 ms outside loading and no growth after the warm-up; 1: there was.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from random import Random
from statistics import quantiles
from time import monotonic
from typing import TYPE_CHECKING

from tools.scripted.display import DISPLAYS, VIRTUAL, display
from tools.scripted.player import Player

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from engine.app.loop import Loop

LONGEST = 0.050
"""Seconds that a frame may take."""
GROWTH = 12.0
"""MB by which the memory may go up and down after the warm-up."""
WARM = 0.2
"""Share of the time that is warm-up, for memory."""
EVERY = 2.0
"""Seconds between two looks at the memory."""
KEPT = 12
"""Slow frames that are told."""


@dataclass(frozen=True, slots=True)
class Slow:
    """A frame that took long: when (s), how long (s), and what was done in it."""

    at: float
    took: float
    cause: str


@dataclass(slots=True)
class Watcher:
    """Looks on while a player plays, until `end` (s) have gone by since all was loaded."""

    player: Player
    end: float
    by_work: bool = False
    times: list[float] = field(default_factory=list)
    slow: list[Slow] = field(default_factory=list)
    memory: list[tuple[float, float]] = field(default_factory=list)
    _began: float = field(default_factory=monotonic)
    _ready: bool = False
    _doing: str = ""
    _script: Iterator[None] | None = None

    def each(self, loop: Loop) -> None:
        """Note the frame before, then let the player do his next step."""
        now = monotonic() - self._began
        if self._ready:
            self._note(loop, now)
        else:
            self._ready = loop.startup.saying == "" and loop.startup.playable
            self._began, now = monotonic(), 0.0
        if now > self.end:
            loop.running = False
            return
        self._doing = f"{loop.session.mode.name.lower()}, {loop.renderer}, {loop.view.camera}"
        self._script = self._script or self._play(loop)
        next(self._script)

    def _note(self, loop: Loop, now: float) -> None:
        took = loop.worked if self.by_work else loop.busy
        self.times.append(took)
        if took > LONGEST:
            then = loop.session.mode.name.lower()
            keys = " ".join(loop.hands.pressed[:3])
            cause = f"{self._doing} -> {then}; keys: {keys or 'none'}; shot {self.player.strokes}"
            self.slow.append(Slow(now, took, f"{cause}; at work {1000.0 * loop.worked:.0f} ms"))
        if not self.memory or now - self.memory[-1][0] >= min(EVERY, self.end / 50.0):
            self.memory.append((now, resident()))

    def _play(self, loop: Loop) -> Iterator[None]:
        yield from self.player.play_on(loop)


def resident() -> float:
    """Return the memory (MB) that the process has in use."""
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6


@dataclass(frozen=True, slots=True)
class Findings:
    """What was seen: frame times in ms, memory in MB."""

    game: str
    frames: int
    shots: int
    games: int
    percentiles: dict[str, float]
    slow: list[str]
    memory_then: float
    memory_now: float

    @property
    def passed(self) -> bool:
        """Whether no frame was slow and the memory did not grow."""
        return not self.slow and self.memory_now - self.memory_then < GROWTH


def findings(game: str, watcher: Watcher) -> Findings:
    """Return what a watcher saw; raises ValueError where it saw next to nothing."""
    if len(watcher.times) < 100 or len(watcher.memory) < 4:
        raise ValueError("too short to say anything")
    cuts = quantiles(watcher.times, n=1000)
    found = {"p50": cuts[499], "p95": cuts[949], "p99": cuts[989], "p99.9": cuts[998]}
    found["worst"] = max(watcher.times)
    warm = [size for at, size in watcher.memory if at >= WARM * watcher.end]
    part = max(1, len(warm) // 4)
    slow = sorted(watcher.slow, key=lambda one: -one.took)
    return Findings(
        game,
        len(watcher.times),
        watcher.player.strokes,
        watcher.player.games,
        {name: round(1000.0 * seconds, 2) for name, seconds in found.items()},
        [f"{1000.0 * one.took:.0f} ms at {one.at:.0f} s: {one.cause}" for one in slow[:KEPT]],
        round(sum(warm[:part]) / part, 1),
        round(sum(warm[-part:]) / part, 1),
    )


def watch(
    game: str, seconds: float, seed: int, rate: int, size: tuple[int, int], *, by_work: bool
) -> Findings:
    """Play a game in a window for so long and return what was seen."""
    from engine.app.play import play  # noqa: PLC0415  the window's process

    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        player = Player(folder, Random(seed), most=10**9, tries=24, looks=False)
        watcher = Watcher(player, seconds, by_work)
        play(
            game,
            seed=seed,
            rate=rate,
            size=size,
            journal=folder / "journal.toml",
            each=watcher.each,
        )
    return findings(game, watcher)


def main(arguments: Sequence[str] | None = None) -> int:
    """Play and tell; return 0 where nothing is amiss."""
    parser = argparse.ArgumentParser(prog="python -m tools.long_play", description=__doc__)
    parser.add_argument("--minutes", type=float, default=30.0, help="of all games together")
    parser.add_argument("--games", default="snooker,nine_ball,three_cushion,eight_ball")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--rate", type=int, default=60)
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--display", choices=DISPLAYS, default=VIRTUAL)
    parser.add_argument("--work", action="store_true", help="count only time at work")
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--inside", action="store_true", help=argparse.SUPPRESS)
    asked = parser.parse_args(arguments)
    width, _, height = asked.size.partition("x")
    size, games = (int(width), int(height)), asked.games.split(",")
    seconds = 60.0 * asked.minutes / len(games)
    if asked.inside:
        found = watch(
            games[0], 60.0 * asked.minutes, asked.seed, asked.rate, size, by_work=asked.work
        )
        print(json.dumps({slot: getattr(found, slot) for slot in Findings.__slots__}))
        return 0
    all_found = []
    with tempfile.TemporaryDirectory() as name, display(asked.display, size) as env:
        env |= {"XDG_CONFIG_HOME": name, "XDG_DATA_HOME": name}
        for game in games:
            words = ["--inside", "--games", game, "--minutes", str(seconds / 60.0)]
            words += ["--seed", str(asked.seed), "--rate", str(asked.rate), "--size", asked.size]
            words += ["--work"] if asked.work else []
            command = [sys.executable, "-m", "tools.long_play", *words]
            done = subprocess.run(command, env=env, check=True, stdout=subprocess.PIPE, text=True)
            all_found.append(Findings(**json.loads(done.stdout.splitlines()[-1])))
            if not asked.json:
                print(told(all_found[-1]), flush=True)
    if asked.json:
        print(json.dumps([{s: getattr(one, s) for s in Findings.__slots__} for one in all_found]))
    return 0 if all(one.passed for one in all_found) else 1


def told(found: Findings) -> str:
    """Return findings in a few lines."""
    times = ", ".join(f"{name} {value}" for name, value in found.percentiles.items())
    passed = "passed" if found.passed else "NOT passed"
    counts = f"{found.frames} frames, {found.shots} shots, {found.games} games over"
    rows = [
        f"{found.game}: {counts}; {passed}",
        f"  frame ms: {times}",
        f"  memory MB: {found.memory_then} after the warm-up, {found.memory_now} at the end",
        *(f"  slow: {one}" for one in found.slow),
    ]
    return "\n".join(rows)


if __name__ == "__main__":
    sys.exit(main())
