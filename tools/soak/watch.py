"""Shots played under the monitor, what came of them, and records of those that broke a rule."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import asdict, dataclass, field, replace
from functools import cache
from time import thread_time
from typing import TYPE_CHECKING

import numpy as np
import tomli_w

from engine.game.match import start_match
from engine.game.shot import Shot
from engine.game.situation import Rest
from engine.physics import state
from engine.physics.monitor import examine
from engine.physics.simulate import EventStormError, simulate
from engine.records.hash import physics_hash
from engine.records.write import before_table, shot_table
from tools.soak.strokes import make_stroke

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from engine.physics.trace import Trace
    from tools.soak.strokes import Plan, Stroke

RUN = 250
"""Shots dealt to a worker at once."""


FIGURES = ("overlap", "sunk", "torn", "gain", "momentum")
"""What the monitor finds of which the worst of all shots is told."""


@dataclass(frozen=True, slots=True)
class Fault:
    """A shot that broke a rule, and its record."""

    number: int
    variant: str
    scene: str
    words: tuple[str, ...]
    record: str


@dataclass(slots=True)
class Tally:
    """What came of some shots: the worst figures in SI units, times in ms of this thread."""

    shots: int = 0
    caps: int = 0
    overlap: float = 0.0
    sunk: float = 0.0
    gain: float = 0.0
    momentum: float = 0.0
    torn: float = 0.0
    flights: int = 0
    felled: int = 0
    events: int = 0
    slowest: tuple[float, int, str] = (0.0, -1, "")
    times: list[float] = field(default_factory=list)
    scenes: dict[str, int] = field(default_factory=dict)
    faults: list[Fault] = field(default_factory=list)

    def add(self, other: Tally) -> None:
        """Take in what came of other shots."""
        for name in ("shots", "caps", "flights", "felled"):
            setattr(self, name, getattr(self, name) + getattr(other, name))
        for name in (*FIGURES, "events", "slowest"):
            setattr(self, name, max(getattr(self, name), getattr(other, name)))
        self.times += other.times
        self.faults += other.faults
        for scene, count in other.scenes.items():
            self.scenes[scene] = self.scenes.get(scene, 0) + count


def soak(plan: Plan, first: int, last: int) -> Tally:
    """Return what came of the shots from number `first` up to `last`."""
    _warm(plan)
    tally = Tally()
    for number in range(first, last):
        stroke = make_stroke(plan, number)
        tally.scenes[stroke.scene] = tally.scenes.get(stroke.scene, 0) + 1
        tally.shots += 1
        words = _played(stroke, tally)
        if words:
            record = record_of(stroke, words)
            fault = Fault(number, stroke.variant.name, stroke.scene, words, record)
            tally.faults.append(fault)
    return tally


@cache
def _warm(plan: Plan) -> None:
    """Load this process's kernels, those of flights too, so that no shot's time holds it."""
    for number in range(3 * len(plan.variants)):
        stroke = make_stroke(plan, number)
        with suppress(EventStormError, ValueError, ArithmeticError, LookupError):
            simulate(stroke.world, stroke.layout, stroke.ball, stroke.strike)


def _played(stroke: Stroke, tally: Tally) -> tuple[str, ...]:
    """Play a shot, note its figures, and return in words what it broke."""
    start = thread_time()
    try:
        trace = simulate(stroke.world, stroke.layout, stroke.ball, stroke.strike)
    except EventStormError as storm:
        tally.caps += 1
        return (str(storm).split(":")[0],)
    except (ValueError, ArithmeticError, LookupError) as error:
        return (f"{type(error).__name__}: {error}",)
    spent = (thread_time() - start) * 1000.0
    tally.times.append(spent)
    tally.slowest = max(tally.slowest, (spent, stroke.number, stroke.variant.name))
    tally.events = max(tally.events, len(trace.log))
    tally.flights += trace.flies
    tally.felled += int((trace.log[:, state.E_KIND] == state.TOPPLED).sum())
    found = examine(trace, stroke.world)
    for name in FIGURES:
        setattr(tally, name, max(getattr(tally, name), getattr(found, name)))
    return (*found.faults(), *_ends(stroke, trace))


def _ends(stroke: Stroke, trace: Trace) -> tuple[str, ...]:
    words = []
    left = int((trace.log[:, state.E_KIND] == state.LEFT).sum())
    if len(trace.final) + len(trace.pocketed) + left != len(stroke.layout):
        words.append("a ball is neither on the bed nor in a pocket")
    speeds = trace.velocities([trace.duration])[0], trace.spins([trace.duration])[0]
    lying = [i for i, ball in enumerate(trace.balls) if ball.id in trace.final]
    if any(np.abs(speed[lying]).max(initial=0.0) > 0.0 for speed in speeds):
        words.append("something still moves at the end")
    return tuple(words)


def record_of(stroke: Stroke, words: Sequence[str] = ()) -> str:
    """Return the shot as a record (TOML) that expects nothing of the referee."""
    variant = stroke.variant
    situation = replace(
        start_match(variant).situation,
        in_hand=None,
        offers=(),
        on_table=frozenset(stroke.layout),
        rest=Rest(positions=stroke.layout),
    )
    options = start_match(variant).situation.options
    choice = options[0] if options else None
    names = asdict(variant.world.models)
    other = [name for what, name in asdict(stroke.world.models).items() if name != names[what]]
    told = f" (models {', '.join(other)})" if other else ""
    shot = Shot(choice=choice, struck=stroke.ball, strike=stroke.strike)
    record: dict[str, object] = {
        "format": 1,
        "variant": variant.name,
        "title": f"Soak shot {stroke.number}: {'; '.join(words) or 'sound'}{told}",
        "cites": [],
        "physics": physics_hash(variant.world),
        "before": before_table(variant, situation),
        "shot": [{**shot_table(shot), "expect": {}}],
    }
    return tomli_w.dumps(record)


def run(
    plan: Plan, shots: int, workers: int = 1, progress: Callable[[Tally], None] | None = None
) -> Tally:
    """Return what came of shots 0 to `shots`, dealt to so many workers."""
    runs = [(first, min(first + RUN, shots)) for first in range(0, shots, RUN)]
    tally = Tally()
    if workers == 1:
        parts = (soak(plan, *part) for part in runs)
    else:
        from joblib import Parallel, delayed  # noqa: PLC0415  an extra

        deal = Parallel(n_jobs=workers, return_as="generator")
        parts = deal(delayed(soak)(plan, *part) for part in runs)
    for part in parts:
        tally.add(part)
        if progress is not None:
            progress(tally)
    return tally
