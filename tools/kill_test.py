"""A match that is killed again and again, and gone on with, to see whether anything is lost.

One idea: a window process plays, tells before a change of the match is saved and after it was, and
is killed (`kill -9`) at a random moment of a random stage: starting, waiting, physics, judging,
saving, drawing. What the journal then holds must be what was told last as saved, or what was just
being saved; the next process goes on from there.

    python -m tools.kill_test [--moments 200] [--game GAME] [--display virtual|headless|own]

Exit status 0: nothing was lost at any moment; 1: something was.
"""

from __future__ import annotations

import argparse
import json
import mmap
import os
import signal
import sys
import tempfile
from collections import Counter
from dataclasses import dataclass, field
from hashlib import sha256
from pathlib import Path
from random import Random
from time import monotonic, sleep
from typing import TYPE_CHECKING, Any

from tools.scripted.display import DISPLAYS, VIRTUAL, display
from tools.scripted.hands import press

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping, Sequence

    from engine.app.loop import Loop
    from engine.game.match import Match

STAGES = ("starting", "waiting", "physics", "judging", "saving", "drawing")
DELAYS = (0.0001, 0.001, 0.02)
"""Seconds into a stage that a process lives on in the mean."""
LONGEST = 20.0
"""Seconds that a stage is waited for."""


@dataclass(slots=True)
class Tally:
    """What came of the moments: `shots` of the longest match, and each moment that was `lost`."""

    moments: int = 0
    stages: Counter[str] = field(default_factory=Counter)
    halfway: int = 0
    shots: int = 0
    matches: int = 0
    lost: list[str] = field(default_factory=list)


def digest(match: Match) -> str:
    """Return a name for the state of a match, alike in every process."""
    from engine.records.write import before_table  # noqa: PLC0415

    state = before_table(match.variant, match.situation)
    told = [match.seed, len(match.played), match.situation.winner, match.situation.games, state]
    return sha256(json.dumps(told, sort_keys=True).encode()).hexdigest()[:16]


def run_moments(game: str, moments: int, seed: int, folder: Path) -> Tally:
    """Kill a match of `game` at so many moments; return what came of it.

    The environment says which display there is. Everything slow is loaded once, here, and the
    processes that play are forked.
    """
    _warm()
    tally, lot = Tally(), Random(seed)
    journal, known = folder / f"{game}-0.toml", ""
    while tally.moments < moments:
        stage, delay = lot.choice(STAGES), lot.expovariate(1.0 / lot.choice(DELAYS))
        told = _killed(game, journal, lot.random(), stage, delay)
        tally.moments += 1
        tally.stages[told.stage] += 1
        known = _judge(tally, journal, told, known)
        if tally.moments % 20 == 0:
            print(f"{tally.moments} of {moments} moments", file=sys.stderr, flush=True)
        if told.over:
            tally.matches += 1
            journal, known = folder / f"{game}-{tally.matches}.toml", ""
    return tally


@dataclass(slots=True)
class Told:
    """What a killed process had said: its first state, the one kept last, the one being saved."""

    stage: str
    first: str = ""
    kept: str = ""
    coming: str = ""
    over: bool = False
    died: str = ""


def _warm() -> None:
    """Load what every process needs, without a thread and without a window."""
    os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "hide")
    from engine.app import before, evening, hud, keeping, loop, play, startup  # noqa: F401, PLC0415
    from engine.physics.simulate import warm_up  # noqa: PLC0415
    from engine.render.renderer import make_renderer  # noqa: PLC0415

    warm_up(None)
    make_renderer("wireframe").warm_up(lambda _what, _share: None)


def _judge(tally: Tally, journal: Path, told: Told, known: str) -> str:
    """Compare a journal with what its process told; return the state that it holds."""
    from engine.records.journal import resume  # noqa: PLC0415
    from engine.variant.load import load_variant  # noqa: PLC0415

    where = f"moment {tally.moments} ({told.stage})"
    if told.died:
        tally.lost.append(f"{where}: the window itself failed: {told.died}")
    if known and told.first and told.first != known:
        tally.lost.append(f"{where}: began at {told.first}, the journal held {known}")
    if not journal.exists():
        if told.first:
            tally.lost.append(f"{where}: there is no journal")
        return known
    match = resume(journal, load_variant)
    found = digest(match)
    tally.shots = max(tally.shots, len(match.played))
    allowed = {one for one in (told.kept or told.first or known, told.coming) if one}
    if allowed and found not in allowed:
        tally.lost.append(f"{where}: the journal holds {found}, not one of {sorted(allowed)}")
    tally.halfway += bool(told.coming)
    return found


def _killed(game: str, journal: Path, seed: float, stage: str, delay: float) -> Told:
    """Start a process, kill it `delay` s into a stage and return what it had told."""
    reads, writes = os.pipe()
    sight = mmap.mmap(-1, 1)
    child = os.fork()
    if child == 0:
        os.close(reads)
        _live(game, journal, seed, sight, writes)
    os.close(writes)
    wanted, start = STAGES.index(stage), monotonic()
    while sight[0] != wanted and monotonic() - start < LONGEST:
        if os.waitid(os.P_PID, child, os.WEXITED | os.WNOHANG | os.WNOWAIT):
            break
        sleep(0.0002)
    sleep(delay)
    os.kill(child, signal.SIGKILL)
    _, status = os.waitpid(child, 0)
    with os.fdopen(reads, encoding="utf-8") as said:
        lines = said.read().splitlines()
    told = _heard(lines, STAGES[sight[0]])
    if os.WIFEXITED(status) and os.WEXITSTATUS(status):
        told.died = told.died or f"exit status {os.WEXITSTATUS(status)}"
    return told


def _heard(lines: list[str], stage: str) -> Told:
    told = Told(stage)
    for line in lines:
        word, _, rest = line.partition(" ")
        match word:
            case "first":
                told.first = rest
            case "coming":
                told.coming = rest
            case "kept":
                told.kept, told.coming = rest, ""
            case "over":
                told.over = True
            case "died":
                told.died = rest
    return told


def _live(game: str, journal: Path, seed: float, sight: mmap.mmap, writes: int) -> None:
    """Play in a window until killed; the end of a forked process."""

    def tell(text: str) -> None:
        os.write(writes, f"{text}\n".encode())

    status = 1
    try:
        _watch_stages(sight, tell)
        status = _play(game, journal, seed, sight, tell)
    except BaseException as trouble:  # noqa: BLE001  told to the other side of the pipe
        tell(f"died {trouble!r}")
    finally:
        os._exit(status)


def _play(
    game: str, journal: Path, seed: float, sight: mmap.mmap, tell: Callable[[str], None]
) -> int:
    from engine.app.play import play  # noqa: PLC0415

    script: list[Iterator[None]] = []

    def each(loop: Loop) -> None:
        sight[0] = STAGES.index("waiting")
        if not script:
            tell(f"first {digest(loop.session.match)}")
            script.append(_strokes(loop, Random(seed), tell))
        next(script[0])

    return play(
        game,
        resume=journal.exists(),
        journal=journal,
        seed=int(seed * 1e6),
        size=(480, 320),
        rate=1000,
        renderer="wireframe",
        each=each,
    )


def _strokes(loop: Loop, lot: Random, tell: Callable[[str], None]) -> Iterator[None]:
    """Yield frame by frame: strokes at random, some taken back and played again."""
    while not loop.startup.playable:
        yield
    while not loop.session.match.situation.match_over:
        key = lot.choice(("u", "y", "h")) if lot.random() < 0.1 else ""
        if key:
            yield from press(key)
            yield from press("escape" if key == "h" else "x")
        mode = loop.session.mode.name
        if mode == "AIMING":
            yield from press(lot.choice(("left", "right")), times=lot.randint(0, 40))
            yield from press(lot.choice(("up", "down")), times=lot.randint(0, 10))
        elif mode == "CALLING":
            yield from press("tab", times=lot.randint(1, 3))
            yield from press("p", times=lot.randint(1, 3))
        elif mode == "OVER":
            yield from press("n")
        yield from press("f" if mode in ("STRIKING", "ROLLING") else "space")
    tell("over")
    while True:
        yield


def _watch_stages(sight: mmap.mmap, tell: Callable[[str], None]) -> None:
    """Let the process say which stage it is in, and what it saves."""
    from engine.app import loop, steps  # noqa: PLC0415
    from engine.app.keeping import Keeper  # noqa: PLC0415

    def staged(name: str, function: Callable[..., Any]) -> Callable[..., Any]:
        def watched(*args: object, **kwargs: object) -> object:
            before, sight[0] = sight[0], STAGES.index(name)
            try:
                return function(*args, **kwargs)
            finally:
                sight[0] = before

        return watched

    follow = Keeper.follow

    def told(self: Keeper, match: Match, left: Mapping[str, float]) -> None:
        tell(f"coming {digest(match)}")
        follow(self, match, left)
        tell(f"kept {digest(match)}")

    for stage, name in (("physics", "simulate_shot"), ("judging", "judge_shot")):
        vars(steps)[name] = staged(stage, vars(steps)[name])
    Keeper.follow = staged("saving", told)  # type: ignore[method-assign]
    loop.Loop.draw = staged("drawing", loop.Loop.draw)  # type: ignore[method-assign]


def main(arguments: Sequence[str] | None = None) -> int:
    """Kill and go on; return 0 where nothing was lost."""
    parser = argparse.ArgumentParser(prog="python -m tools.kill_test", description=__doc__)
    parser.add_argument("--moments", type=int, default=200)
    parser.add_argument("--game", default="nine_ball")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--display", choices=DISPLAYS, default=VIRTUAL)
    asked = parser.parse_args(arguments)
    with tempfile.TemporaryDirectory() as name, display(asked.display, (640, 480)) as env:
        folder = Path(name)
        os.environ.update(env, XDG_CONFIG_HOME=name, XDG_DATA_HOME=name)
        tally = run_moments(asked.game, asked.moments, asked.seed, folder)
    stages = ", ".join(f"{stage} {tally.stages[stage]}" for stage in STAGES)
    print(f"killed at {tally.moments} moments of {asked.game}: {stages}")
    print(f"{tally.halfway} while a change was not yet told as saved; {tally.shots} shots at most")
    for one in tally.lost:
        print(f"LOST: {one}")
    print("nothing was lost" if not tally.lost else f"{len(tally.lost)} times something was lost")
    return 1 if tally.lost else 0


if __name__ == "__main__":
    sys.exit(main())
