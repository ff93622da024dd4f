"""How long the referee takes: strokes of forty events judged by a script of sixty rules.

One idea: the strokes are real ones, played once and kept as records, and the script is the longest
shipped one, lengthened by its own fouls. What is timed is one call: from parsed events to the
whole verdict, the situation of the next shot included.
Invariant: a verdict that is explained has kept all that an explanation is told from, how every rule
fared, what it decided and what each section saw; the words are found when somebody reads them, and
have a row of their own.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from time import process_time
from typing import TYPE_CHECKING

from engine.game.referee import judge_shot
from engine.game.situation import Rest
from engine.records.read import read_record
from engine.variant.load import load_variant
from rulelang.evaluate import judge

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from engine.game.shot import Shot
    from engine.game.situation import Situation
    from engine.variant.variant import Variant

RULES = 60
SHOTS = Path(__file__).resolve().parent / "shots"
ROOT = Path(__file__).resolve().parent.parent.parent
GOAL, GOAL_EXPLAINED = 50.0, 100.0
BATCHES, TURNS = 25, 40

Stroke = tuple["Variant", "Situation", "Shot"]


def long_script(enough: Callable[[str], bool]) -> str:
    """Return the longest shipped script, its fouls said again until there is `enough` of it."""
    folder = ROOT / "variants"
    files = ("rules/snooker-play.rules", "rules/snooker-choices.rules", "snooker.rules")
    parts = [(folder / name).read_text(encoding="utf-8") for name in files]
    first = [line for line in parts[-1].split("\n") if line.startswith(("language", "game"))]
    head = ("language", "game", "uses")
    rest = [line for part in parts for line in part.split("\n") if not line.startswith(head)]
    source = "\n".join(first + rest)
    section = source[source.index("\nfouls:") : source.index("\npoints:")]
    number = 0
    while not enough(source):
        number += 1
        for line in section.replace('rule "', f'rule "{number} ').split("\n"):
            if line.startswith("    rule") and enough(source):
                return source
            source += line + "\n"
    return source


def long_game(folder: Path, enough: Callable[[str], bool]) -> Path:
    """Write a game with a long script into `folder` and return its file."""
    path = folder / "long.toml"
    path.write_text('extends = "snooker"\n', encoding="utf-8")
    path.with_suffix(".rules").write_text(long_script(enough), encoding="utf-8")
    return path


def long_strokes() -> list[Stroke]:
    """Return strokes of forty events, to be judged by sixty rules; balls' places are known."""
    with TemporaryDirectory() as name:
        path = long_game(Path(name), lambda source: source.count("    rule ") >= RULES)
        variant = load_variant(path)
    if len(variant.program.rules) != RULES:
        raise ValueError(f"the long script has {len(variant.program.rules)} rules, not {RULES}")
    records = [read_record(path, lambda _: variant) for path in sorted(SHOTS.glob("*.toml"))]
    return [(variant, record.start, record.steps[0].shot) for record in records]


def told_alone(stroke: Stroke) -> Stroke:
    """Return a stroke of which the events are known and nothing of where balls lie."""
    variant, before, shot = stroke
    return variant, replace(before, rest=Rest()), replace(shot, after=Rest())


def verdict_rows() -> Iterator[dict[str, object]]:
    """Yield rows on a verdict: of events alone, with balls' places known, and of the rules alone.

    Microseconds of processor time for a stroke, and how many strokes there are.
    """
    placed = long_strokes()
    told = [told_alone(stroke) for stroke in placed]
    asked = [_as_asked(stroke) for stroke in told]
    events = "/".join(map(str, sorted({len(shot.events or ()) for _, _, shot in placed})))
    name = f"{RULES} rules, {events} events"
    yield _row(f"verdict, {name}", partial(_judge, told), GOAL)
    yield _row(f"verdict, explained, {name}", partial(_judge, told, explain=True), GOAL_EXPLAINED)
    yield _row(f"verdict, explained and put in words, {name}", partial(_tell, told))
    yield _row(f"verdict, places known, {name}", partial(_judge, placed))
    yield _row(f"the rules alone, {name}", partial(_ask, asked))


def _judge(strokes: list[Stroke], *, explain: bool = False) -> int:
    for variant, before, shot in strokes:
        judge_shot(variant, before, shot, explain=explain)
    return len(strokes)


def _tell(strokes: list[Stroke]) -> int:
    for variant, before, shot in strokes:
        list(judge_shot(variant, before, shot).explanation)
    return len(strokes)


def _as_asked(stroke: Stroke) -> tuple[object, object, object]:
    variant, before, shot = stroke
    judged = judge_shot(variant, before, shot).after.judged
    if judged is None:
        raise ValueError("the stroke was not judged")
    return variant.program, judged.situation, judged.shot


def _ask(asked: list[tuple[object, object, object]]) -> int:
    for program, situation, shot in asked:
        judge(program, situation, shot, explain=False)  # type: ignore[arg-type]
    return len(asked)


def _timed(work: Callable[[], int]) -> list[float]:
    """Return the microseconds of processor time for each stroke, batch by batch."""
    times = []
    for _ in range(BATCHES):
        start = process_time()
        count = sum(work() for _ in range(TURNS))
        times.append((process_time() - start) / count * 1e6)
    return sorted(times[2:])


def _row(name: str, work: Callable[[], int], goal: float | None = None) -> dict[str, object]:
    times = _timed(work)
    return {
        "work": name,
        "count": work(),
        "median_us": round(times[len(times) // 2], 1),
        "p95_us": round(times[int(len(times) * 0.95)], 1),
        "goal_us": "" if goal is None else goal,
    }
