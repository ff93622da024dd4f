"""How fast scripts are checked and shots are judged.

One idea: the shipped scripts and their golden records are the work; a verdict is timed from parsed
events to the situation of the next shot, with the explanation off and on.
"""

from __future__ import annotations

import resource
import subprocess
import sys
from functools import cache, partial
from os import environ
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter, process_time
from typing import TYPE_CHECKING

import numpy as np

from engine.game.phrases import format_event, parse_event
from engine.game.referee import judge_shot
from engine.records.read import read_record
from engine.variant.load import check_variant, list_variants, load_variant
from tools.bench.verdict import long_game, verdict_rows

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from engine.variant.variant import Variant
    from tools.bench.verdict import Stroke

ROOT = Path(__file__).resolve().parent.parent.parent
ROUNDS = 15


def rows() -> Iterator[dict[str, object]]:
    """Yield a row for each kind of work; times in microseconds."""
    yield from verdict_rows()
    yield from check_rows()
    load = cache(load_variant)
    games = [one.name for one in list_variants()]
    yield from _judge_rows(games, load)
    for game in games:
        yield _row(f"check {game}, files and script", _timed(partial(check_variant, game)), 1)
        texts = [
            format_event(event)
            for _, _, shot in first_shots(game, load)
            for event in shot.events or ()
        ]
        if texts:
            yield _row(f"read an event of {game}", _timed(partial(_parse_all, texts)), len(texts))


def _judge_rows(games: list[str], load: Callable[[str], Variant]) -> Iterator[dict[str, object]]:
    """Yield how long a verdict takes in the records of each game, the median of games first.

    `count` is how many records there are whose first shot is judged: in the median the games.
    """
    found: dict[str, list[dict[str, object]]] = {"off": [], "on": []}
    for game in games:
        shots = first_shots(game, load)
        for said, made in found.items():
            if shots:
                work = partial(_judge_all, shots, explain=said == "on")
                name = f"judge {game}, explanation {said}"
                made.append(_row(name, _timed(work, process_time), len(shots)))
    for said, made in found.items():
        times = [float(str(row["median_us"])) for row in made]
        yield _row(f"judge a shot, median of games, explanation {said}", times, 1) | {
            "count": len(made)
        }
    for both in zip(*found.values(), strict=True):
        yield from both


def first_shots(game: str, load: Callable[[str], Variant]) -> list[Stroke]:
    """Return the first shot of every record of a game that begins with a stroke."""
    paths = sorted((ROOT / "tests" / "golden" / game).glob("*.toml"))
    records = [read_record(path, load) for path in paths]
    return [
        (record.variant, record.start, record.steps[0].shot)
        for record in records
        if record.steps[0].shot.events
    ]


def check_rows() -> Iterator[dict[str, object]]:
    """Yield rows on checking a script of 300 lines: warm, in a process of its own, and without.

    They are seconds of work, not of waiting, so that a busy machine makes little difference. The
    tables of the grammar and the compiled modules are there, as they are from the second time on.
    """
    with TemporaryDirectory() as name:
        folder = Path(name)
        path = long_game(folder, lambda source: source.count("\n") >= 300)
        warm = partial(check_variant, path, folder / "headstring")
        if warm():
            raise ValueError("the long script has mistakes")
        yield _row("check-warm, 300 lines, CPU", _timed(warm, process_time), 1, 50e3)
        check = ["-m", "engine", "check", str(path)]
        for title, words, goal in (
            ("check-cold, 300 lines", check, 200e3),
            ("`--help`", ["-m", "engine", "--help"], None),
            ("a bare interpreter", ["-c", "pass"], None),
        ):
            run = partial(_run_apart, words, folder)
            yield _row(f"{title}, CPU", _timed(run, _of_children), 1, goal)


def _run_apart(words: list[str], folder: Path) -> None:
    """Run Python in a process of its own that keeps what it makes in `folder`."""
    around = {key: value for key, value in environ.items() if key != "PYTHONDONTWRITEBYTECODE"}
    around |= {"XDG_CACHE_HOME": str(folder), "PYTHONPYCACHEPREFIX": str(folder / "compiled")}
    command = [sys.executable, *words]
    subprocess.run(command, cwd=ROOT, check=True, env=around, stdout=subprocess.DEVNULL)


def _judge_all(shots: list[Stroke], *, explain: bool) -> None:
    for variant, before, shot in shots:
        judge_shot(variant, before, shot, explain=explain)


def _parse_all(texts: list[str]) -> None:
    for text in texts:
        parse_event(text)


def _timed(work: Callable[[], object], clock: Callable[[], float] = perf_counter) -> list[float]:
    times = []
    for _ in range(ROUNDS):
        start = clock()
        work()
        times.append((clock() - start) * 1e6)
    return times[2:]


def _of_children() -> float:
    """Return the seconds of work that child processes have done."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def _row(name: str, times: list[float], count: int, goal: float | None = None) -> dict[str, object]:
    each = np.array(times) / count
    return {
        "work": name,
        "count": count,
        "median_us": round(float(np.median(each)), 1),
        "p95_us": round(float(np.percentile(each, 95)), 1),
        "goal_us": "" if goal is None else goal,
    }
