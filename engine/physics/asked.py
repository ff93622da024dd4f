"""Events that the common loop does not resolve: rare models, pins, alarms.

One idea: the loop stops (ASK) with the balls concerned brought to the moment, an answer changes
their rows as any Python code may, and `stepwise.resume` goes on; so a rare model costs nothing to
those who have not chosen it. A resolver notes what happened and marks whom it moved with `touch`.
Invariant: an answer depends on the arrays alone, so chunks of time change no bit.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from engine.physics import state

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from engine.physics.pack import Packed
    from engine.physics.world import Ball

    Floats = NDArray[np.float64]
    Ints = NDArray[np.int64]
    Resolver = Callable[["Asked"], None]


@dataclass(slots=True)
class Asked:
    """One question: the simulation's arrays, which the answer may change.

    `memory` belongs to the resolvers and lasts for one shot; what it holds must follow from the
    shot alone. Set `everyone` where furniture changed, so that all balls are foreseen anew.
    """

    world: Packed
    balls: tuple[Ball, ...]
    rows: Floats
    kinds: Ints
    noses: Floats
    foreseen: Floats
    pieces: Floats
    events: Floats
    counts: Ints
    clock: Floats
    memory: dict[str, object]
    everyone: bool = False

    @property
    def what(self) -> int:
        """Return what is asked: ASK_DROP, ASK_PAIR, ASK_NOSE, ASK_CLUSTER or ASK_ALARM."""
        return int(self.counts[state.ASK_WHAT])

    @property
    def who(self) -> int:
        """Return the row of the ball it is about, -1 for an alarm."""
        return int(self.counts[state.ASK_WHO])

    @property
    def other(self) -> int:
        """Return the row of the other ball, the nose or the pocket."""
        return int(self.counts[state.ASK_OTHER])

    @property
    def time(self) -> float:
        """Return the moment, s; the rows of the touched balls are those of this time."""
        return float(self.clock[state.C_TIME])

    @property
    def touched(self) -> list[int]:
        """Return the rows of the balls brought to the moment: those asked about at first."""
        marks = self.foreseen[:, state.K_TOUCHED]
        return [int(i) for i in np.flatnonzero(marks != 0.0)]

    def touch(self, ball: int) -> None:
        """Bring another ball to the moment, so that its row may be changed."""
        if self.foreseen[ball, state.K_TOUCHED] == 0.0:
            from engine.physics.record import move  # noqa: PLC0415  numba

            move(self.rows, self.kinds, self.pieces, self.counts, ball, self.time)
            self.foreseen[ball, state.K_TOUCHED] = 1.0

    def note(self, kind: float, first: int, second: int = -1, speed: float = 0.0) -> None:
        """Write an event (a kind of `state`) into the log."""
        row = self.events[self.counts[state.EVENTS]]
        row[:] = (kind, self.time, first, second, speed)
        self.counts[state.EVENTS] += 1

    def take(self, ball: int) -> None:
        """Take a touched ball off the bed for good; the event is for the caller to note."""
        row = self.rows[ball]
        row[[state.VX, state.VY, state.VZ, state.WX, state.WY, state.WZ]] = 0.0
        row[[state.AX, state.AY, state.BX, state.BY]] = 0.0
        row[state.END] = np.inf
        self.kinds[ball] = state.GONE

    def clear(self, nose: int) -> None:
        """Take a nose, such as a fallen pin, off the bed."""
        clear_nose(self.noses[nose])
        self.everyone = True

    @property
    def alarms(self) -> dict[str, float]:
        """Return when (s) each of those who are to be woken wants to be, by name."""
        found = self.memory.setdefault("alarms", {})
        if not isinstance(found, dict):
            raise TypeError("alarms are kept by name")
        return found

    def wake(self, time: float, who: str = "pins") -> None:
        """Ask `who` again at `time` (s), infinite for never; each has one alarm."""
        self.alarms[who] = time
        self.clock[state.C_ALARM] = min(self.alarms.values())


def clear_nose(row: Floats) -> None:
    """Make a nose one that no ball ever meets."""
    row[state.N_LOX : state.N_LOY + 1] = np.inf
    row[state.N_HIX : state.N_HIY + 1] = -np.inf
    row[state.N_SIZE] = 0.0


def answer(asked: Asked) -> None:
    """Let the question be resolved by whoever knows the model."""
    if asked.what != state.ASK_ALARM:
        _resolver(asked.what, _model(asked))(asked)
        return
    for who in sorted(who for who, time in asked.alarms.items() if time <= asked.time):
        asked.wake(np.inf, who)
        _woken(who)(asked)


def _model(asked: Asked) -> int:
    """Return the code of the model asked for, -1 where it is a pin's or an alarm."""
    numbers = asked.world.numbers
    match asked.what:
        case state.ASK_DROP:
            return int(asked.world.drops[asked.other, state.D_MODEL])
        case state.ASK_PAIR:
            return int(numbers[state.G_BALL_BALL])
        case state.ASK_CLUSTER:
            return int(numbers[state.G_CLUSTER])
        case state.ASK_NOSE if asked.noses[asked.other, state.N_PIN] < 0.0:
            return int(asked.noses[asked.other, state.N_MODEL])
        case _:
            return -1


def _resolver(what: int, model: int) -> Resolver:
    """Return who resolves a question; each is loaded when it is first needed."""
    if what == state.ASK_NOSE and model < 0:
        from engine.physics.felling import meet_pin  # noqa: PLC0415  tables with pins alone

        return meet_pin
    from engine.physics import rare  # noqa: PLC0415  numba

    match what, model:
        case (state.ASK_PAIR, state.MATHAVAN_2014):
            return rare.meet_ball
        case (state.ASK_NOSE, state.STRONGE):
            return rare.meet_nose
        case (state.ASK_CLUSTER, _):
            return rare.meet_cluster
        case (state.ASK_DROP, state.RIM_LIP):
            return rare.reach_pocket
        case _:
            message = f"nobody resolves event {what} by model {model}"
            raise ValueError(message)


def _woken(who: str) -> Resolver:
    """Return who has asked for an alarm under this name."""
    if who == "pins":
        from engine.physics.felling import go_on  # noqa: PLC0415  tables with pins alone

        return go_on
    from engine.physics import rare  # noqa: PLC0415  numba

    return rare.leave_pocket


__all__ = ["Asked", "answer"]
