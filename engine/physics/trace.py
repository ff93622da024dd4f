"""A shot's trace: what every ball did and when, as plain arrays.

One idea: the solver's pieces are exact formulas, so any question about any time is answered from
them, lazily and in any order, without a further step of simulation. Invariant: a trace never
changes, and its `hash` covers every bit of it.
"""

from __future__ import annotations

from dataclasses import dataclass
from hashlib import sha256
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np

from engine.physics import events as happened
from engine.physics import state
from engine.physics.felling import NO_PINS

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from engine.physics.events import Event
    from engine.physics.felling import PinTrace
    from engine.physics.noses import Owner
    from engine.physics.world import Ball, Layout
    from engine.table.furniture import BallId, PocketId, Point

    Floats = NDArray[np.float64]

Piece = tuple[float, float, "Point", "Point", "Point"]


@dataclass(frozen=True, slots=True, eq=False)
class Trace:
    """A simulated shot.

    `balls` are those on the table, in the order of every array's ball axis; `pieces` (m, 17) and
    `log` (k, 5) have the columns P_* and E_* of `engine.physics.state`, pieces sorted by ball and
    time; `duration` is in s; `spin_rates` (n,) are the losses of side spin on the bed in
    rad/s^2;
    `gravity` in m/s^2 bends what flies; `pins` says how pins stood and fell.
    """

    balls: tuple[Ball, ...]
    pieces: Floats
    log: Floats
    owners: tuple[Owner, ...]
    pockets: tuple[PocketId, ...]
    spin_rates: Floats
    duration: float
    gravity: float = 9.81
    pins: PinTrace = NO_PINS

    def events(self) -> tuple[Event, ...]:
        """Return the events in order, typed.

        A resting contact is carried by tiny bounces; of those only the first is told. `log` has
        them all.
        """
        told = _together([self._event(row) for row in self._told()])
        if not self.flies:
            return tuple(told)
        from engine.physics.passing import jumps, liftoffs  # noqa: PLC0415  only flights need it

        seen = [*told, *liftoffs(self), *jumps(self)]
        return tuple(sorted(seen, key=lambda event: event.time))

    def positions(self, times: ArrayLike) -> Floats:
        """Return the centres (T, n, 3) in m; a ball that is gone rests below the bed."""
        at, rows, s = self._find(times)
        radii = np.array([ball.radius for ball in self.balls])
        out = np.empty((len(at), len(self.balls), 3))
        for k, v, a in ((0, state.P_VX, state.P_AX), (1, state.P_VY, state.P_AY)):
            out[..., k] = rows[..., state.P_X + k] + s * (rows[..., v] + 0.5 * s * rows[..., a])
        height = radii
        if self.flies:
            rise = rows[..., state.P_VZ] - 0.5 * self.gravity * s
            height = np.where(_aloft(rows), rows[..., state.P_Z] + s * rise, radii)
        out[..., 2] = np.where(at[:, None] > self._gone_at()[None, :], -radii, height)
        return out

    def velocities(self, times: ArrayLike) -> Floats:
        """Return the velocities (T, n, 3) in m/s."""
        at, rows, s = self._find(times)
        out = np.zeros((len(at), len(self.balls), 3))
        moving = at[:, None] <= self._ends()[None, :]
        out[..., 0] = rows[..., state.P_VX] + s * rows[..., state.P_AX]
        out[..., 1] = rows[..., state.P_VY] + s * rows[..., state.P_AY]
        if self.flies:
            out[..., 2] = np.where(_aloft(rows), rows[..., state.P_VZ] - self.gravity * s, 0.0)
        return np.where(moving[..., None], out, 0.0)

    def spins(self, times: ArrayLike) -> Floats:
        """Return the angular velocities (T, n, 3) in rad/s."""
        at, rows, s = self._find(times)
        out = np.zeros((len(at), len(self.balls), 3))
        moving = at[:, None] <= self._ends()[None, :]
        out[..., 0] = rows[..., state.P_WX] + s * rows[..., state.P_BX]
        out[..., 1] = rows[..., state.P_WY] + s * rows[..., state.P_BY]
        side = rows[..., state.P_WZ]
        lost = np.where(_aloft(rows), 0.0, self.spin_rates * s)
        out[..., 2] = np.sign(side) * np.maximum(np.abs(side) - lost, 0.0)
        return np.where(moving[..., None], out, 0.0)

    @property
    def flies(self) -> bool:
        """Say whether any ball leaves the bed."""
        return bool(_aloft(self.pieces).any())

    def orientations(self, times: ArrayLike) -> Floats:
        """Return the rotations (T, n, 3, 3) from each ball's start to `times`."""
        from engine.physics.turning import orientations  # noqa: PLC0415  only pictures need it

        return orientations(self, np.atleast_1d(np.asarray(times, dtype=np.float64)))

    def kinetic_energy(self, times: ArrayLike) -> Floats:
        """Return the energy (T,) of motion and rotation of all balls, J."""
        mass = np.array([ball.mass for ball in self.balls])
        radius = np.array([ball.radius for ball in self.balls])
        v2 = (self.velocities(times) ** 2).sum(-1)
        w2 = (self.spins(times) ** 2).sum(-1)
        total: Floats = (mass * (0.5 * v2 + 0.2 * radius**2 * w2)).sum(-1)
        return total

    def pieces_of(self, ball: BallId) -> tuple[Piece, ...]:
        """Return the ball's pieces (t0, t1, r, v, a): place r + v s + a s^2 / 2, s = t - t0."""
        rows = self.pieces[self.pieces[:, state.P_BALL] == self._index(ball)]
        return tuple(
            (
                float(row[state.P_T0]),
                float(row[state.P_T1]),
                (float(row[state.P_X]), float(row[state.P_Y])),
                (float(row[state.P_VX]), float(row[state.P_VY])),
                (float(row[state.P_AX]), float(row[state.P_AY])),
            )
            for row in rows
        )

    @property
    def final(self) -> Layout:
        """Return where the balls that are still on the bed lie at the end."""
        gone = {int(row[state.E_FIRST]) for row in self.log if row[state.E_KIND] in _DEPARTURES}
        places = self.positions([self.duration])[0]
        return MappingProxyType(
            {
                ball.id: (float(places[i, 0]), float(places[i, 1]))
                for i, ball in enumerate(self.balls)
                if i not in gone
            }
        )

    @property
    def pocketed(self) -> dict[BallId, PocketId]:
        """Return which ball dropped into which pocket, in order."""
        return {
            self.balls[int(row[state.E_FIRST])].id: self.pockets[int(row[state.E_SECOND])]
            for row in self.log
            if row[state.E_KIND] == state.DROPPED
        }

    def hash(self) -> str:
        """Return a digest of all bits of pieces, events and duration."""
        digest = sha256(" ".join(ball.id for ball in self.balls).encode())
        flat = np.ascontiguousarray(self.pieces[:, : state.FLAT_WIDTH])
        digest.update(flat.tobytes())
        if self.flies:
            digest.update(np.ascontiguousarray(self.pieces[:, state.FLAT_WIDTH :]).tobytes())
        digest.update(np.ascontiguousarray(self.log).tobytes())
        digest.update(np.float64(self.duration).tobytes())
        if self.pins.standing:
            digest.update(repr(self.pins).encode())
        return digest.hexdigest()

    def _told(self) -> list[Floats]:
        """Return the log without the later bounces of a resting contact."""
        told: list[Floats] = []
        last: dict[tuple[int, int, int], float] = {}
        for row in self.log:
            kind, first = int(row[state.E_KIND]), int(row[state.E_FIRST])
            second = int(row[state.E_SECOND])
            one, two = sorted((first, second)) if kind == state.TOUCHING else (first, second)
            before = last.get((kind, one, two), -1.0)
            last[kind, one, two] = row[state.E_TIME]
            resting = kind in _LASTING and row[state.E_SPEED] <= GENTLE
            if not (resting and row[state.E_TIME] - before <= RESTING):
                told.append(row)
        return told

    def _index(self, ball: BallId) -> int:
        return next(i for i, known in enumerate(self.balls) if known.id == ball)

    def _starts(self) -> NDArray[np.int64]:
        owners = self.pieces[:, state.P_BALL]
        return np.searchsorted(owners, np.arange(len(self.balls) + 1), side="left")

    def _ends(self) -> Floats:
        starts = self._starts()
        ends: Floats = self.pieces[starts[1:] - 1, state.P_T1]
        return ends

    def _gone_at(self) -> Floats:
        gone = np.full(len(self.balls), np.inf)
        for row in self.log:
            if row[state.E_KIND] in _DEPARTURES:
                gone[int(row[state.E_FIRST])] = row[state.E_TIME]
        return gone

    def _find(self, times: ArrayLike) -> tuple[Floats, Floats, Floats]:
        """Return times (T,), their pieces (T, n, 15) and the time into each piece (T, n)."""
        at = np.atleast_1d(np.asarray(times, dtype=np.float64))
        starts = self._starts()
        chosen = np.empty((len(at), len(self.balls)), dtype=np.int64)
        for i in range(len(self.balls)):
            own = self.pieces[starts[i] : starts[i + 1], state.P_T0]
            chosen[:, i] = starts[i] + np.maximum(np.searchsorted(own, at, side="right") - 1, 0)
        rows: Floats = self.pieces[chosen]
        s = np.clip(at[:, None], rows[..., state.P_T0], rows[..., state.P_T1])
        return at, rows, s - rows[..., state.P_T0]

    def _event(self, row: Floats) -> Event:
        kind, time, speed = int(row[state.E_KIND]), float(row[state.E_TIME]), float(row[4])
        if kind in (state.TOPPLED, state.LEANT):
            return self._pin_event(row)
        ball, second = self.balls[int(row[state.E_FIRST])].id, int(row[state.E_SECOND])
        if kind == state.TOUCHING:
            return happened.BallsCollided(time, ball, self.balls[second].id, speed)
        if kind == state.DROPPED:
            return happened.BallPocketed(time, ball, self.pockets[second])
        if kind == state.LEFT:
            return happened.BallLeftTable(time, ball)
        if kind == state.LANDED:
            return happened.BallLanded(time, ball, speed, rail=second == state.ON_RAIL)
        if kind == state.ROLLING:
            return happened.RollingBegan(time, ball)
        if kind == state.STOPPED:
            return happened.BallStopped(time, ball)
        owner = self.owners[second]
        if owner.pin is not None:
            return happened.PinTouched(time, owner.pin, ball)
        if owner.cushion is not None:
            return happened.CushionHit(time, ball, owner.cushion, speed)
        if owner.pocket is None:
            raise AssertionError("a nose belongs to a cushion or a pocket")
        return happened.JawHit(time, ball, owner.pocket, speed)

    def _pin_event(self, row: Floats) -> Event:
        """Return what happened to a pin; who did it is a ball, or a pin below zero."""
        first, time = int(row[state.E_FIRST]), float(row[state.E_TIME])
        by = self.balls[first].id if first >= 0 else self.pins.names[-1 - first]
        pin = self.pins.names[int(row[state.E_SECOND])]
        if row[state.E_KIND] == state.TOPPLED:
            return happened.PinToppled(time, pin, (by,))
        return happened.PinTouched(time, pin, by)


def _together(told: list[Event]) -> list[Event]:
    """Return the events with one for each pin that several felled at once."""
    found: list[Event] = []
    for event in told:
        last = found[-1] if found else None
        if (
            isinstance(event, happened.PinToppled)
            and isinstance(last, happened.PinToppled)
            and (event.pin, event.time) == (last.pin, last.time)
        ):
            found[-1] = happened.PinToppled(last.time, last.pin, (*last.by, *event.by))
        else:
            found.append(event)
    return found


def _aloft(rows: Floats) -> NDArray[np.bool_]:
    aloft: NDArray[np.bool_] = rows[..., state.P_KIND] == state.FLY
    return aloft


_LASTING = (state.TOUCHING, state.NOSE, state.ROLLING, state.STOPPED)
RESTING = 0.02
"""Bounces of one contact that follow each other within this time (s) are one rest."""

GENTLE = (1.0 + 1e-9) * state.SOFT
"""The speed (m/s) of such bounces at most, give or take rounding."""

_DEPARTURES = (float(state.DROPPED), float(state.LEFT))

__all__ = ["Piece", "Trace"]
