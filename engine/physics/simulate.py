"""From a strike to a trace: the one entrance to the solvers.

One idea: a `Simulation` owns the arrays, the jitted solver runs them from event to event, and the
trace is read off them; how time is cut up for asking never reaches the arrays. Invariant: same
input, same bits, whatever the chunks. The kernels are loaded on first use, not at import.
"""

from __future__ import annotations

from functools import cache
from math import inf
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from engine.physics import state
from engine.physics.felling import MEMORY, NO_PINS, Felling, PinTrace, set_up
from engine.physics.lay import place_balls
from engine.physics.pack import packed, refuse_rare
from engine.physics.strike import strike_ball
from engine.physics.trace import Trace

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from numpy.typing import NDArray

    from engine.physics.world import Layout, Strike, World
    from engine.table.furniture import BallId, PinId

    Floats = NDArray[np.float64]

EVENT_CAP = 400_000
"""More than a row of balls comes to that is pressed together as long as a spin can last."""

STEP = 1.0 / 60.0
"""Time step (s) of the solvers that have one."""

ROOM = 512
"""Rows that an answer to what is asked may write."""

FIXED = ("corrective", "preemptive")
"""Those with a step, in the order of `engine.physics.fixed`."""

SOLVERS = ("stepwise", *FIXED)


class EventStormError(RuntimeError):
    """More events than any real shot has; `layout`, `ball` and `strike` reproduce it."""

    def __init__(self, layout: Layout, ball: BallId, strike: Strike) -> None:
        super().__init__(f"more than {EVENT_CAP} events: {ball} {strike} in {dict(layout)}")
        self.layout, self.ball, self.strike = layout, ball, strike


class Simulation:
    """One shot in progress."""

    def __init__(
        self,
        world: World,
        layout: Layout,
        ball: BallId,
        strike: Strike,
        *,
        step: float = STEP,
        fallen: Iterable[PinId] = (),
    ) -> None:
        """Set the balls and strike one of them; `step` (s) is for the fixed-step solvers.

        All pins stand but the `fallen`, and those whose place a ball takes.
        Raises ValueError for what cannot be played.
        """
        if world.models.solver not in SOLVERS:
            message = f"unknown solver {world.models.solver!r}; there are: {', '.join(SOLVERS)}"
            raise ValueError(message)
        if ball not in layout:
            message = f"the ball to strike is not on the table: {ball}"
            raise ValueError(message)
        self._world, self._layout, self._ball, self._strike = world, layout, ball, strike
        self._step = step
        self._packed = packed(world)
        if world.models.solver in FIXED:
            refuse_rare(self._packed)
        self._balls, self._rows = place_balls(self._packed, layout)
        n = len(self._balls)
        self._kinds = np.zeros(n, dtype=np.int64)  # at rest
        self._pairs = np.empty((n, n))
        self._foreseen = np.zeros((n, state.FORESEEN_WIDTH))
        self._pieces, self._events = _buffers(n)
        self._counts = np.zeros(state.COUNTS_WIDTH, dtype=np.int64)
        self._counts[state.CAP] = EVENT_CAP
        self._clock = np.zeros(state.CLOCK_WIDTH)
        self._clock[state.C_ALARM] = inf
        self._noses = self._packed.noses
        self._memory: dict[str, object] = {}
        if world.table.pins:
            self._noses = self._noses.copy()
            pins = set_up(world, layout, frozenset(fallen))
            pins.clear_fallen(self._noses)
            self._memory[MEMORY] = pins
        self.finished = False
        self._strike_one()

    def _strike_one(self) -> None:
        world = self._world
        i = self._balls.index(world.balls[self._packed.index[self._ball]])
        flies = world.models.flight == "ballistic" and world.models.solver == "stepwise"
        motion = strike_ball(self._balls[i], world.cue, world.cloth, self._strike, flies=flies)
        row = self._rows[i]
        row[state.VX], row[state.VY] = motion.velocity
        row[state.WX], row[state.WY], row[state.WZ] = motion.spin
        row[state.VZ] = motion.rise
        self._kinds[i] = state.FLY if motion.rise > 0.0 else state.SLIDE

    def advance(self, until: float) -> None:
        """Carry out all events up to `until` (s)."""
        while not self.finished:
            answer = self._run(until)
            if answer == state.STORM:
                raise EventStormError(self._layout, self._ball, self._strike)
            if answer == state.FULL:
                self._make_room(1 + self._room())
                continue
            if answer == state.ASK:
                self._answer()
                continue
            self.finished = answer == state.DONE
            if not self.finished:
                self._clock[1] = max(self._clock[1], until)
                return

    def _room(self) -> int:
        """Return how many rows are free, of pieces or of events, whichever has more."""
        return int(max(len(self._pieces) - self._counts[0], len(self._events) - self._counts[1]))

    def _make_room(self, rows: int) -> None:
        """See to it that so many rows are free for pieces and for events."""
        while len(self._pieces) - self._counts[0] < rows:
            self._pieces = np.concatenate([self._pieces, np.empty_like(self._pieces)])
        while len(self._events) - self._counts[1] < rows:
            self._events = np.concatenate([self._events, np.empty_like(self._events)])

    def _answer(self) -> None:
        """Let an event that the kernels do not know be resolved, and go on after it."""
        from engine.physics.asked import Asked, answer  # noqa: PLC0415  rarely needed
        from engine.physics.stepwise import resume  # noqa: PLC0415  numba

        self._make_room(ROOM)
        world = self._packed
        asked = Asked(
            world=world,
            balls=self._balls,
            rows=self._rows,
            kinds=self._kinds,
            noses=self._noses,
            foreseen=self._foreseen,
            pieces=self._pieces,
            events=self._events,
            counts=self._counts,
            clock=self._clock,
            memory=self._memory,
        )
        answer(asked)
        resume(
            self._rows,
            self._kinds,
            world.numbers,
            self._noses,
            world.drops,
            self._pairs,
            self._foreseen,
            self._pieces,
            self._events,
            self._counts,
            self._clock,
            asked.everyone,
        )

    def _run(self, until: float) -> int:
        world, solver = self._packed, self._world.models.solver
        arrays = (self._rows, self._kinds, world.numbers, self._noses, world.drops)
        record = (self._pieces, self._events, self._counts, self._clock, until)
        if solver != "stepwise":
            return int(_fixed()(*arrays, *record, self._step, FIXED.index(solver)))
        run = _prepared()
        if state.FLY in self._kinds.tolist():
            answer = _flight()(*arrays, self._pairs, self._foreseen, *record)
            if answer != state.DOWN:
                return int(answer)
        return int(run(*arrays, self._pairs, self._foreseen, *record))

    def trace(self) -> Trace:
        """Return the shot as far as it has been carried out."""
        now = float(self._clock[0] if self.finished else self._clock[1])
        return Trace(
            balls=self._balls,
            pieces=self._arranged(now),
            log=self._events[: self._counts[1]].copy(),
            owners=self._packed.owners,
            pockets=self._packed.drop_ids,
            spin_rates=self._rows[:, state.SLOWING].copy(),
            gravity=self._world.cloth.gravity,
            duration=now,
            pins=self._pins(),
        )

    def give_back(self) -> None:
        """Let the next shot have this one's memory: nothing may be asked of this one any more."""
        if len(_spare) < SPARE and len(self._pieces) <= LARGEST:
            _spare.append((self._pieces, self._events))

    def _pins(self) -> PinTrace:
        pins = self._memory.get(MEMORY)
        return pins.trace() if isinstance(pins, Felling) else NO_PINS

    def _arranged(self, now: float) -> Floats:
        """Return all pieces (m, 17) by ball and time, those that have not ended cut off `now`."""
        closed = int(self._counts[state.PIECES])
        out = np.empty((closed + len(self._rows), state.PIECE_WIDTH))
        count = _arrange()(self._rows, self._kinds, self._pieces, self._counts, now, out)
        return out[:count]


SPARE, LARGEST = 4, 4096
NO_ROWS = np.empty((0, state.PIECE_WIDTH)), np.empty((0, state.EVENT_WIDTH))
_spare: list[tuple[Floats, Floats]] = []
"""Rows for pieces and events that shots are done with; fresh ones cost more than a small shot."""


def _buffers(balls: int) -> tuple[Floats, Floats]:
    """Return rows for the pieces and the events of a shot of so many balls, with no values yet."""
    rows = 2 * balls * balls + 256
    try:
        pieces, events = _spare.pop()
    except IndexError:
        pieces, events = NO_ROWS
    if len(pieces) >= rows and len(events) >= rows:
        return pieces, events
    return np.empty((rows, state.PIECE_WIDTH)), np.empty((rows, state.EVENT_WIDTH))


@cache
def _kernel() -> Callable[..., int]:
    """Return the solver's kernel, once what was compiled from other sources is dropped."""
    from engine.kernel_cache import drop_stale  # noqa: PLC0415  numba
    from engine.physics.stepwise import run  # noqa: PLC0415  numba

    kernel: Any = run
    drop_stale(Path(str(kernel.stats.cache_path)), Path(__file__).parent)
    return run


@cache
def _prepared() -> Callable[..., int]:
    """Return the solver's kernel, compiled by two processes where it is not on disk."""
    from engine.physics.prepare import prepare  # noqa: PLC0415  numba

    run = _kernel()
    prepare()
    return run


@cache
def _fixed() -> Callable[..., int]:
    """Return the kernel of the solvers with a step."""
    _kernel()
    from engine.physics.fixed import run_fixed  # noqa: PLC0415  numba

    return run_fixed


@cache
def _arrange() -> Callable[..., int]:
    """Return the kernel that puts the pieces in order; an import each shot would cost more."""
    from engine.physics.record import arrange  # noqa: PLC0415  numba

    return arrange


@cache
def _flight() -> Callable[..., int]:
    """Return the kernel of shots that leave the bed."""
    _kernel()
    from engine.physics.flight import run_flying  # noqa: PLC0415  numba

    return run_flying


def simulate(
    world: World,
    layout: Layout,
    ball: BallId,
    strike: Strike,
    *,
    step: float = STEP,
    fallen: Iterable[PinId] = (),
) -> Trace:
    """Return the whole shot until all is at rest; `step` (s) is for the fixed-step solvers.

    All pins stand but the `fallen`, and those whose place a ball takes.
    Raises ValueError for a world, layout or strike that cannot be, EventStormError for a bug.
    """
    simulation = Simulation(world, layout, ball, strike, step=step, fallen=fallen)
    simulation.advance(inf)
    trace = simulation.trace()
    simulation.give_back()
    return trace


def warm_up(progress: Callable[[str], None] | None = None) -> None:
    """Compile or load what the first shot needs, playing a tiny one; `progress` hears of it.

    What only some shots need is left to `warm_up_behind`.
    """
    from engine.physics.prepare import prepare  # noqa: PLC0415  only needed here
    from engine.physics.trial import play_trial  # noqa: PLC0415  only needed here

    if progress is not None:
        progress("preparing the physics")
    _kernel()
    prepare(progress)
    play_trial()
    if progress is not None:
        progress("physics ready")


def warm_up_behind() -> None:
    """Let another process compile what shots that leave the bed need, while this one goes on.

    A shot that needs it earlier compiles it itself.
    """
    from engine.physics.prepare import prepare_behind  # noqa: PLC0415  only needed here

    _kernel()
    prepare_behind()


__all__ = ["EventStormError", "Simulation", "simulate", "warm_up", "warm_up_behind"]
