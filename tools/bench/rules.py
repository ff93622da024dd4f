"""How fast scripts are checked and shots are judged.

One idea: the shipped scripts and their golden records are the work; a verdict is timed from parsed
events to decisions, with the explanation off and on.
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

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from engine.game.shot import Shot
    from engine.game.situation import Situation
    from engine.variant.variant import Variant

ROOT = Path(__file__).resolve().parent.parent.parent
ROUNDS = 15


def rows() -> Iterator[dict[str, object]]:
    """Yield a row for each kind of work; times in microseconds."""
    yield from check_rows()
    load = cache(load_variant)
    for game in (one.name for one in list_variants()):
        yield _row(f"check {game}, files and script", _timed(partial(check_variant, game)), 1)
        paths = sorted((ROOT / "tests" / "golden" / game).glob("*.toml"))
        records = [read_record(path, load) for path in paths]
        shots = [
            (record.variant, record.start, record.steps[0].shot)
            for record in records
            if record.steps[0].shot.events
        ]
        if not shots:
            continue
        for explain in (False, True):
            name = f"judge {game}, explanation {'on' if explain else 'off'}"
            yield _row(name, _timed(partial(_judge_all, shots, explain=explain)), len(shots))
        texts = [format_event(event) for _, _, shot in shots for event in shot.events or ()]
        yield _row(f"read an event of {game}", _timed(partial(_parse_all, texts)), len(texts))


def check_rows() -> Iterator[dict[str, object]]:
    """Yield rows on checking a script of 300 lines: warm, in a process of its own, and without.

    They are seconds of work, not of waiting, so that a busy machine makes little difference. The
    tables of the grammar and the compiled modules are there, as they are from the second time on.
    """
    with TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "long.toml").write_text('extends = "snooker"\n', encoding="utf-8")
        (folder / "long.rules").write_text(long_script(300), encoding="utf-8")
        warm = partial(check_variant, folder / "long.toml", folder / "headstring")
        if warm():
            raise ValueError("the long script has mistakes")
        yield _row("check-warm, 300 lines, CPU", _timed(warm, process_time), 1)
        check = ["-m", "engine", "check", str(folder / "long.toml")]
        for title, words in (
            ("check-cold, 300 lines", check),
            ("`--help`", ["-m", "engine", "--help"]),
            ("a bare interpreter", ["-c", "pass"]),
        ):
            run = partial(_run_apart, words, folder)
            yield _row(f"{title}, CPU", _timed(run, _of_children), 1)


def _run_apart(words: list[str], folder: Path) -> None:
    """Run Python in a process of its own that keeps what it makes in `folder`."""
    around = {key: value for key, value in environ.items() if key != "PYTHONDONTWRITEBYTECODE"}
    around |= {"XDG_CACHE_HOME": str(folder), "PYTHONPYCACHEPREFIX": str(folder / "compiled")}
    command = [sys.executable, *words]
    subprocess.run(command, cwd=ROOT, check=True, env=around, stdout=subprocess.DEVNULL)


def long_script(lines: int) -> str:
    """Return the longest shipped script, its fouls said again until it has so many lines."""
    folder = ROOT / "variants"
    files = ("rules/snooker-play.rules", "rules/snooker-choices.rules", "snooker.rules")
    parts = [(folder / name).read_text(encoding="utf-8") for name in files]
    first = [line for line in parts[-1].split("\n") if line.startswith(("language", "game"))]
    head = ("language", "game", "uses")
    rest = [line for part in parts for line in part.split("\n") if not line.startswith(head)]
    source = "\n".join(first + rest)
    section = source[source.index("\nfouls:") : source.index("\npoints:")]
    for number in range(1, lines):
        for line in section.replace('rule "', f'rule "{number} ').split("\n"):
            if source.count("\n") >= lines and line.startswith("    rule"):
                return source
            source += line + "\n"
    return source


def _judge_all(shots: list[tuple[Variant, Situation, Shot]], *, explain: bool) -> None:
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


def _row(name: str, times: list[float], count: int) -> dict[str, object]:
    each = np.array(times) / count
    return {
        "work": name,
        "count": count,
        "median_us": round(float(np.median(each)), 1),
        "p95_us": round(float(np.percentile(each, 95)), 1),
    }
