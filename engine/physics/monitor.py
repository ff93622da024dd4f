"""The monitor: whether a shot's trace keeps the rules that hold for every shot.

One idea: the trace is read as it stands, just before and just after every event and between them,
without asking the solver: no ball in another, in a nose or in a standing pin, no way torn, no
energy gained (height counts), momentum along the bed kept where balls meet, all numbers finite,
nobody gone without a pocket or a flight. Invariant: reading changes nothing, and a finding is a
figure, so that the worst of many shots can be told.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING

import numpy as np

from engine.physics import state
from engine.physics.noses import pack_noses
from engine.physics.pack import nose_reach, packed
from engine.physics.reading import read
from engine.table.furniture import Table

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from engine.physics.reading import Reading, States
    from engine.physics.trace import Trace
    from engine.physics.world import World

    Floats = NDArray[np.float64]
    Ints = NDArray[np.int64]
    Bools = NDArray[np.bool_]

OVERLAP = 1e-9
"""How far (m) two balls, or a ball and a nose, may lie in each other, or a way be torn."""

GAIN = 1e-12
"""How much energy (J) rounding may add from one moment to the next."""

MOMENTUM = 1e-12
"""By how much (kg m/s) rounding may change the momentum of balls that meet."""

BESIDE = 5e-3
"""How far (m) beside a drop a ball may be that comes out of it."""

MOMENTS = 512
"""So many moments are looked at together, which bounds the memory."""


@dataclass(frozen=True, slots=True)
class Findings:
    """What the monitor found in one shot, in SI units; all zero and finite is the best.

    `overlap` counts from how deep a pair lay at the start; `gap` is the smallest distance of two
    balls' surfaces, below zero in an overlap; `sunk` is how deep a ball lay in a nose; `torn` how
    far a piece begins from where the one before ended; `gain` is of energy; `momentum` the worst
    error of a meeting; `lost` how many balls left the table without flying; `below` how deep a
    flying ball came into the bed, pockets with a lip apart.
    """

    finite: bool
    gap: float
    overlap: float
    sunk: float
    gain: float
    momentum: float
    lost: int
    torn: float = 0.0
    below: float = 0.0

    def faults(self) -> tuple[str, ...]:
        """Return which rules are broken, in words; none for a sound shot."""
        broken = {
            "a number is not finite": not self.finite,
            f"balls overlap by {self.overlap:.3g} m": self.overlap > OVERLAP,
            f"a ball lies {self.sunk:.3g} m in a nose": self.sunk > OVERLAP,
            f"a ball's way is torn by {self.torn:.3g} m": self.torn > OVERLAP,
            f"energy grows by {self.gain:.3g} J": self.gain > GAIN,
            f"momentum is off by {self.momentum:.3g} kg m/s": self.momentum > MOMENTUM,
            f"{self.lost} balls left the table": self.lost > 0,
            f"a flying ball lies {self.below:.3g} m in the bed": self.below > OVERLAP,
        }
        return tuple(words for words, holds in broken.items() if holds)


def examine(trace: Trace, furniture: World | Table | None = None) -> Findings:
    """Return what is found at every event of a trace and between.

    Noses are looked at where the table is given, posts and pins where the world is.
    """
    reading = read(trace)
    before = reading.states(reading.before, reading.knots)
    after = reading.states(reading.after, reading.knots)
    gap, overlap, sunk = _apart(reading, _noses(furniture), furniture)
    left = trace.log[trace.log[:, state.E_KIND] == state.LEFT, state.E_FIRST]
    flown = trace.pieces[trace.pieces[:, state.P_KIND] == state.FLY, state.P_BALL]
    gain = _gain(reading, before, after, _pits(furniture))
    finite = bool(np.isfinite(trace.pieces).all() and np.isfinite(trace.log).all())
    return Findings(
        finite=finite and bool(np.isfinite(gain)),
        gap=gap,
        overlap=overlap,
        sunk=sunk,
        gain=max(gain, 0.0),
        momentum=_momentum(reading, before, after, _bed_share(furniture)),
        lost=int((~np.isin(left, flown)).sum()),
        torn=_torn(reading, before, after),
        below=_below(trace, furniture),
    )


def _below(trace: Trace, furniture: World | Table | None) -> float:
    """Return how deep (m) a flight comes into the bed: a flight is lowest at one of its ends."""
    table = furniture if furniture is None or isinstance(furniture, Table) else furniture.table
    rows = trace.pieces[trace.pieces[:, state.P_KIND] == state.FLY]
    for pocket in table.pockets if table else ():
        x, y = pocket.centre
        away = np.hypot(rows[:, state.P_X] - x, rows[:, state.P_Y] - y)
        rows = rows[away > pocket.radius + BESIDE]
    radii = np.array([ball.radius for ball in trace.balls])[rows[:, state.P_BALL].astype(np.int64)]
    spent = rows[:, state.P_T1] - rows[:, state.P_T0]
    end = rows[:, state.P_Z] + spent * (rows[:, state.P_VZ] - 0.5 * trace.gravity * spent)
    return float((radii - np.minimum(rows[:, state.P_Z], end)).max(initial=0.0))


def _pits(furniture: World | Table | None) -> Floats:
    """Return the pockets (k, 3) of `rim-lip`, in which a ball's way is told by a few places."""
    if furniture is None or isinstance(furniture, Table):
        return np.empty((0, 3))
    drops = packed(furniture).drops
    return drops[drops[:, state.D_MODEL] == state.RIM_LIP, :3]


def _in_pit(reading: Reading, pits: Floats, pieces: Ints, x: Floats, y: Floats) -> Bools:
    """Say which balls (t, n) are on such a way."""
    inside = np.zeros(pieces.shape, dtype=np.bool_)
    for cx, cy, size in pits:
        inside |= np.hypot(x - cx, y - cy) <= size + BESIDE
    flies: Bools = reading.columns[state.P_KIND][pieces] == state.FLY
    return inside & flies


def _bed_share(furniture: World | Table | None) -> float:
    """Return what part of a blow's momentum the bed may take: none but by `mathavan-2014`."""
    if furniture is None or isinstance(furniture, Table):
        return 0.0
    if furniture.models.ball_ball != "mathavan-2014":
        return 0.0
    rows, contact = packed(furniture).rows, furniture.contact
    rubs = (contact.friction_floor + contact.friction_rise) * (1.0 + rows[:, state.GRIP].max())
    return 2.0 * float(rubs * rows[:, state.SLIDING].max())


def _gain(reading: Reading, before: States, after: States, pits: Floats) -> float:
    """Return the most energy (J) won at a moment, or from one to the next, by those not yet gone.

    In a pit a ball counts with what it had when it came; what it has when it leaves is compared.
    """
    old, new = (_energies(reading, states) for states in (before, after))
    if len(pits):
        _hold(reading, before, after, pits, old, new)
    knots, gone = reading.knots[:, None], reading.gone
    at_once = np.where(knots <= gone, new - old, 0.0).sum(-1)
    between = np.where(knots[:-1] < gone, old[1:] - new[:-1], 0.0).sum(-1)
    return float(np.concatenate([at_once, between]).max(initial=0.0))


def _hold(
    reading: Reading, before: States, after: States, pits: Floats, old: Floats, new: Floats
) -> None:
    """Let the energies (k, n) of balls in pits stay what they were when they came."""
    was, is_in = (
        _in_pit(reading, pits, pieces, states.places[..., 0], states.places[..., 1])
        for pieces, states in ((reading.before, before), (reading.after, after))
    )
    for ball in np.flatnonzero((was | is_in).any(0)):
        held = old[0, ball]
        for k in np.flatnonzero((was | is_in)[:, ball]):
            held = held if was[k, ball] and k > 0 and is_in[k - 1, ball] else old[k, ball]
            old[k, ball] = held
            new[k, ball] = held if is_in[k, ball] else new[k, ball]


def _energies(reading: Reading, states: States) -> Floats:
    """Return each ball's energy (k, n) of motion, rotation and height at each knot, J."""
    radii, trace = reading.radii, reading.trace
    each = 0.5 * (states.velocity**2).sum(-1) + 0.2 * radii**2 * (states.spin**2).sum(-1)
    if trace.flies:
        each = each + trace.gravity * (states.places[..., 2] - radii)
    energies: Floats = reading.masses * each
    return energies


def _torn(reading: Reading, before: States, after: States) -> float:
    """Return the farthest (m) that a ball on or above the bed is moved within a moment."""
    moved = np.abs(after.places - before.places)[..., :2].max(-1)
    here = reading.knots[:, None] <= reading.gone
    return float(moved[here].max(initial=0.0))


def _momentum(reading: Reading, before: States, after: States, share: float) -> float:
    """Return the worst change of momentum (kg m/s) where balls met and touched nothing else.

    What the bed may take, that `share` of the balls' own changes, is not counted, nor what a ball
    had that was slower than `STILL` and so was taken to be at rest.
    """
    log, knots = reading.trace.log, reading.knots
    at = np.searchsorted(knots, log[:, state.E_TIME])
    known = at < len(knots)
    known[known] = knots[at[known]] == log[known, state.E_TIME]
    kinds = log[:, state.E_KIND]
    others = ~np.isin(kinds, (state.TOUCHING, state.ROLLING, state.STOPPED))
    meets = np.zeros(before.velocity.shape[:2], dtype=np.bool_)
    bound = np.zeros_like(meets)
    for column in (state.E_FIRST, state.E_SECOND):
        rows = known & (kinds == state.TOUCHING)
        meets[at[rows], log[rows, column].astype(np.int64)] = True
    rows = known & others & (log[:, state.E_FIRST] >= 0.0)
    bound[at[rows], log[rows, state.E_FIRST].astype(np.int64)] = True
    change = reading.masses[:, None] * (after.velocity - before.velocity)[..., :2]
    total = np.abs((change * meets[..., None]).sum(1)).max(-1)
    stopped = meets & (after.velocity[..., :2] == 0.0).all(-1)
    total = np.maximum(total - (reading.masses * state.STILL * stopped).sum(1), 0.0)
    if share > 0.0:
        total = np.maximum(total - share * (np.abs(change).sum(-1) * meets).sum(1), 0.0)
    return float(total[~(meets & bound).any(-1)].max(initial=0.0))


def _noses(furniture: World | Table | None) -> Floats:
    if furniture is None:
        return np.empty((0, state.NOSE_WIDTH))
    if isinstance(furniture, Table):
        return pack_noses(furniture)[0]
    return packed(furniture).noses


def _apart(
    reading: Reading, noses: Floats, furniture: World | Table | None
) -> tuple[float, float, float]:
    """Return the smallest gap of two balls, the greatest overlap since the start, and `sunk`."""
    times, pieces = reading.between()
    pits = _pits(furniture)
    height = None
    if furniture is not None:
        table = furniture if isinstance(furniture, Table) else furniture.table
        height = table.nose_height
    pairs = _pairs(reading)
    least = np.full(len(pairs[0]), inf)
    start, sunk = None, 0.0
    for first in range(0, len(times), MOMENTS):
        run = slice(first, first + MOMENTS)
        centres = reading.centres(pieces[run], times[run])
        here = times[run, None] <= reading.gone
        if len(pits):
            here &= ~_in_pit(reading, pits, pieces[run], centres[0], centres[1])
        square = _squares(centres, here, pairs, space=3 if reading.trace.flies else 2)
        start = square[0] if start is None else start
        least = np.minimum(least, square.min(0))
        if height is not None:
            fresh = _fresh(reading, pieces[run], whole=first == 0)
            sunk = max(sunk, _sunk(reading, noses, height, centres, here & fresh, times[run]))
    need = _need(reading)[pairs]
    gaps = np.sqrt(least) - need
    begun = np.minimum(np.sqrt(start) - need, 0.0) if start is not None else need
    return float(gaps.min(initial=inf)), float((begun - gaps).max(initial=0.0)), sunk


def _need(reading: Reading) -> Floats:
    """Return how far apart (m) the centres of two balls that touch are."""
    radii = reading.radii
    if reading.trace.flies:
        return radii[:, None] + radii
    return 2.0 * np.sqrt(radii[:, None] * radii)


def _pairs(reading: Reading) -> tuple[Ints, Ints]:
    """Return the pairs of balls of which at least one moves."""
    rows = reading.columns
    moved = np.zeros(len(reading.radii), dtype=np.bool_)
    speeds = rows[[state.P_VX, state.P_VY, state.P_VZ]]
    moved[rows[state.P_BALL, (speeds != 0.0).any(0)].astype(np.int64)] = True
    one, two = np.triu_indices(len(moved), 1)
    worth = moved[one] | moved[two]
    return one[worth], two[worth]


def _squares(centres: Floats, here: Bools, pairs: tuple[Ints, Ints], space: int) -> Floats:
    """Return the squared distances (t, p) of pairs, infinite where one is gone."""
    one, two = pairs
    total = np.zeros((centres.shape[1], len(one)))
    for axis in centres[:space]:
        total += (axis[:, one] - axis[:, two]) ** 2
    if not here.all():
        total[~(here[:, one] & here[:, two])] = inf
    return total


def _fresh(reading: Reading, pieces: Ints, *, whole: bool) -> Bools:
    """Return where (t, n) a ball may be elsewhere than a moment ago."""
    rows = reading.columns
    speeds = rows[[state.P_VX, state.P_VY, state.P_AX, state.P_AY, state.P_VZ]]
    fresh = (speeds != 0.0).any(0)[pieces]
    fresh[1:] |= pieces[1:] != pieces[:-1]
    fresh[0] |= whole
    found: Bools = fresh
    return found


def _sunk(
    reading: Reading, noses: Floats, height: float, centres: Floats, here: Bools, times: Floats
) -> float:
    """Return how deep (m) a ball's centre comes within its reach of a nose."""
    if not len(noses):
        return 0.0
    moment, ball = np.nonzero(here)
    x, y, z = centres[:, moment, ball]
    far = 4.0 * float(reading.radii.max(initial=0.0))
    near = (x[:, None] >= noses[:, state.N_LOX] - far) & (x[:, None] <= noses[:, state.N_HIX] + far)
    near &= (y[:, None] >= noses[:, state.N_LOY] - far) & (
        y[:, None] <= noses[:, state.N_HIY] + far
    )
    point, nose = np.nonzero(near)
    rows, radius = noses[nose], reading.radii[ball[point]]
    low = np.array([nose_reach(float(one), height) for one in reading.radii])
    reach = low[ball[point]]
    if reading.trace.flies:
        square = radius**2 - (z[point] - height) ** 2
        reach = np.where(square > 2.0 * OVERLAP * radius, np.sqrt(np.maximum(square, 0.0)), -inf)
    lies = z[point] <= radius  # above the bed a post, too, is no more than its ring at nose height
    reach = np.where((rows[:, state.N_UPRIGHT] != 0.0) & lies, radius, reach)
    over = np.maximum(z[point] - np.maximum(rows[:, state.N_UPRIGHT], radius), 0.0)
    beside = np.sqrt(np.maximum(radius**2 - over**2, 0.0))
    reach = np.where(rows[:, state.N_PIN] >= 0.0, np.where(over < radius, beside, -inf), reach)
    edge = (z[point] > height) & (rows[:, state.N_PIN] < 0.0)
    depth = _depths(rows, x[point], y[point], reach, edge)
    depth[(depth > far) | ~_stands(reading, rows[:, state.N_PIN], times[moment[point]])] = 0.0
    return float(depth.max(initial=0.0))


def _stands(reading: Reading, pins: Floats, times: Floats) -> Bools:
    """Return whether noses stand at given times: pins that were put up do until they topple."""
    log, known = reading.trace.log, reading.trace.pins
    falls = np.full(len(known.names) + 1, inf)  # the last one for noses that are no pins
    falls[[pin for pin in range(len(known.names)) if pin not in known.standing]] = -inf
    for row in log[log[:, state.E_KIND] == state.TOPPLED][::-1]:
        falls[int(row[state.E_SECOND])] = row[state.E_TIME]
    stands: Bools = times <= falls[pins.astype(np.int64)]
    return stands


def _depths(noses: Floats, x: Floats, y: Floats, reaches: Floats, edge: Bools) -> Floats:
    """Return how deep points (m,) lie in noses (m, N_*), m; at most zero where they do not.

    Above a nose there is but its `edge`; below it lies whatever is behind.
    """
    x, y = x - noses[:, state.N_X], y - noses[:, state.N_Y]
    dx, dy, size = noses[:, state.N_DX], noses[:, state.N_DY], noses[:, state.N_SIZE]
    along, away = x * dx + y * dy, np.hypot(x, y)
    round_ = noses[:, state.N_CURVED] != 0.0
    straight = (along >= 0.0) & (along <= size)
    facing = np.where(round_, along >= away * noses[:, state.N_SPAN], straight)
    off = np.where(round_, np.where(size < 0.0, -size - away, away - size), y * dx - x * dy)
    depth: Floats = np.where(facing, reaches - np.where(edge, np.abs(off), off), 0.0)
    return depth


__all__ = ["GAIN", "MOMENTUM", "OVERLAP", "Findings", "examine"]
