"""From a world and a layout to the solvers' arrays.

One idea: names become row numbers here and nowhere else, and what stays from shot to shot is
packed once. Invariant: rows follow the order of `World.balls`, and a nose's row number leads back
to the cushion or the pocket it belongs to.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, sqrt
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np

from engine.physics import state
from engine.physics.noses import Owner, pack_curve, pack_noses, widen
from engine.physics.sane import check_world, own_or
from engine.table.furniture import Curve
from engine.table.pin import meeting

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

    from engine.physics.world import Ball, World
    from engine.table.furniture import BallId, PocketId, Rubber

MOTIONS = {"slide-roll": state.SLIDE_ROLL, "two-speed": state.TWO_SPEED}
BALL_BALLS = {
    "elastic": state.ELASTIC,
    "frictional": state.FRICTIONAL,
    "mathavan-2014": state.MATHAVAN_2014,
}
CUSHIONS = {
    "restitution": state.RESTITUTION,
    "han-2005": state.HAN,
    "mathavan-2010": state.MATHAVAN,
    "stronge": state.STRONGE,
}
STRIKES = ("point",)
POCKETS = {"drop-edge": state.DROP_EDGE, "rim-lip": state.RIM_LIP}
CLUSTERS = {
    "hertz": state.HERTZ,
    "simultaneous": state.SIMULTANEOUS,
    "sequential": state.SEQUENTIAL,
}
FLIGHTS = ("ballistic", "none")


@dataclass(frozen=True, slots=True, eq=False)
class Packed:
    """A world as arrays: its numbers (G_*), noses (N_*) and drop circles, which nothing changes.

    `rows` has one ball's row for each of `world.balls`, at rest at the origin.
    """

    world: World
    numbers: NDArray[np.float64]
    noses: NDArray[np.float64]
    owners: tuple[Owner, ...]
    drops: NDArray[np.float64]
    drop_ids: tuple[PocketId, ...]
    index: Mapping[BallId, int]
    rows: NDArray[np.float64]


def packed(world: World) -> Packed:
    """Return the world as arrays, the same value each time for one and the same world.

    The last few worlds are kept by identity, since comparing two takes longer than a shot.
    Raises ValueError for what cannot be.
    """
    found = _kept.get(id(world))
    if found is None:
        found = _pack(world)
        while len(_kept) >= KEPT:
            _kept.pop(next(iter(_kept)), None)
        _kept[id(world)] = found
    return found


KEPT = 8
_kept: dict[int, Packed] = {}
"""By `id`, which stays the world's own for as long as the value holds the world."""


def _pack(world: World) -> Packed:
    numbers = pack_world(world)
    noses, owners = pack_noses(world.table)
    pins, pinned = pack_pins(world)
    noses, owners = np.concatenate([noses, pins]), (*owners, *pinned)
    give_rubber(world, noses, owners)
    rows = np.zeros((len(world.balls), state.BALL_WIDTH))
    rows[:, state.END] = np.inf
    for row, ball in zip(rows, world.balls, strict=True):
        _pack_ball(row, ball, world)
    return Packed(
        world=world,
        numbers=numbers,
        noses=noses,
        owners=owners,
        drops=pack_pockets(world),
        drop_ids=tuple(pocket.id for pocket in world.table.pockets),
        index=MappingProxyType({ball.id: i for i, ball in enumerate(world.balls)}),
        rows=rows,
    )


def _pack_ball(row: NDArray[np.float64], ball: Ball, world: World) -> None:
    cloth = world.cloth
    row[state.RADIUS], row[state.MASS] = ball.radius, ball.mass
    row[state.Z] = ball.radius
    row[state.REACH] = nose_reach(ball.radius, world.table.nose_height)
    row[state.SLIDING] = own_or(ball.sliding, cloth.sliding)
    row[state.ROLLING_MU] = own_or(ball.rolling, cloth.rolling)
    row[state.SLOWING] = own_or(ball.spin_deceleration, cloth.spin_deceleration)
    usual = world.contact.restitution
    row[state.LIVELY] = own_or(ball.restitution, usual) - usual
    row[state.GRIP] = ball.grip - 1.0


def give_rubber(world: World, noses: NDArray[np.float64], owners: tuple[Owner, ...]) -> None:
    """Fill in the rubber and the model of every nose, in place: its owner's or the world's."""
    table, models = world.table, world.models
    cushions = {cushion.id: cushion for cushion in table.cushions}
    pockets = {pocket.id: pocket for pocket in table.pockets}
    pins = {pin.id: number for number, pin in enumerate(table.pins)}
    for row, owner in zip(noses, owners, strict=True):
        rubber, name = world.rubber, models.ball_cushion
        row[state.N_PIN] = -1.0
        if owner.pin is not None:
            number = pins[owner.pin]
            pin = table.pins[number]
            row[state.N_PIN], row[state.N_UPRIGHT] = number, pin.height
            row[state.N_E], row[state.N_MODEL] = pin.restitution, state.RESTITUTION
            continue
        if owner.cushion is not None:
            cushion = cushions[owner.cushion]
            rubber, name = cushion.rubber or rubber, cushion.model or name
            row[state.N_UPRIGHT] = 1.0 if cushion.upright else 0.0
        elif owner.pocket is not None:
            pocket = pockets[owner.pocket]
            rubber, name = pocket.rubber or rubber, pocket.jaw_model or name
        _cover(row, rubber, name)


def _cover(row: NDArray[np.float64], rubber: Rubber, model: str) -> None:
    row[state.N_E], row[state.N_SLOPE] = rubber.restitution, rubber.restitution_slope
    row[state.N_KNEE], row[state.N_RUB] = rubber.restitution_knee, rubber.friction
    row[state.N_BEND], row[state.N_LEAST] = rubber.restitution_bend, rubber.restitution_least
    row[state.N_RUB_SLOPE], row[state.N_RATIO] = rubber.friction_slope, rubber.frequency_ratio
    row[state.N_MODEL] = _choose(CUSHIONS, model, "ball_cushion")


def pack_rubber(world: World) -> NDArray[np.float64]:
    """Return a nose's row (N_*) with the world's rubber and model, and no place."""
    row = np.zeros(state.NOSE_WIDTH)
    row[state.N_PIN] = -1.0
    _cover(row, world.rubber, world.models.ball_cushion)
    return row


def refuse_rare(world: Packed) -> None:
    """Raise ValueError where a model is chosen that the solvers with a step do not know."""
    numbers, noses = world.numbers, world.noses
    if numbers[state.G_BALL_BALL] > state.FRICTIONAL:
        what = world.world.models.ball_ball
    elif (noses[:, state.N_MODEL] > state.MATHAVAN).any():
        what = world.world.models.ball_cushion
    elif (noses[:, state.N_PIN] >= 0.0).any():
        what = "pins"
    elif (world.drops[:, state.D_MODEL] != state.DROP_EDGE).any():
        what = world.world.models.pocket
    else:
        return
    message = f"the solver {world.world.models.solver} does not know {what}"
    raise ValueError(message)


def pack_world(world: World) -> NDArray[np.float64]:
    """Return the world's numbers, columns G_*; raises ValueError for what cannot be."""
    cloth, contact, table = world.cloth, world.contact, world.table
    check_world(world)
    reach = max((ball.radius for ball in world.balls), default=0.0) * 8.0
    row = np.zeros(state.WORLD_WIDTH)
    row[state.G_THRESHOLD], row[state.G_GRAVITY] = cloth.threshold, cloth.gravity
    row[state.G_FLOOR], row[state.G_RISE] = contact.friction_floor, contact.friction_rise
    row[state.G_DECAY], row[state.G_NOSE] = contact.friction_decay, table.nose_height
    row[state.G_E], row[state.G_TOUCH] = contact.restitution, contact.cluster_gap
    row[state.G_E_SLOPE], row[state.G_E_KNEE] = contact.restitution_slope, contact.restitution_knee
    models = world.models
    row[state.G_MOTION] = _choose(MOTIONS, models.motion, "motion")
    row[state.G_BALL_BALL] = _choose(BALL_BALLS, models.ball_ball, "ball_ball")
    row[state.G_CLUSTER] = _choose(CLUSTERS, models.cluster, "cluster")
    _choose(CUSHIONS, models.ball_cushion, "ball_cushion")
    _choose(dict.fromkeys(STRIKES, 0), models.strike, "strike")
    _choose(POCKETS, models.pocket, "pocket")
    _choose(dict.fromkeys(FLIGHTS, 0), models.flight, "flight")
    row[state.G_OUT_X] = table.length / 2.0 + reach
    row[state.G_OUT_Y] = table.width / 2.0 + reach
    row[state.G_BED], row[state.G_RAIL] = cloth.bounce, table.rail_width
    return row


def _choose(names: Mapping[str, int], name: str, what: str) -> int:
    if name not in names:
        message = f"unknown {what} model {name!r}; there are: {', '.join(names)}"
        raise ValueError(message)
    return names[name]


def nose_reach(radius: float, nose_height: float) -> float:
    """Return the horizontal distance (m) from centre to nose at contact: R cos(theta)."""
    rise = nose_height - radius
    if abs(rise) >= radius:
        message = f"a nose {nose_height} m high never meets a ball of radius {radius} m"
        raise ValueError(message)
    return sqrt(radius * radius - rise * rise)


def pack_pins(world: World) -> tuple[NDArray[np.float64], tuple[Owner, ...]]:
    """Return the pins as upright round noses, as wide as the largest ball finds them.

    They come in the order of their places, so that the order of their names decides nothing.
    """
    radius = max((ball.radius for ball in world.balls), default=0.0)
    rows = []
    pins = sorted(world.table.pins, key=lambda pin: pin.at)
    for pin in pins:
        size = max(meeting(pin.profile, radius)[0] - radius, 0.0)
        rows.append(pack_curve(Curve(pin.at, size, 0.0, -2.0 * pi)))
    return widen(rows), tuple(Owner(None, None, pin.id) for pin in pins)


def pack_pockets(world: World) -> NDArray[np.float64]:
    """Return the pockets, columns D_*."""
    rows = [
        (
            *pocket.centre,
            pocket.radius,
            _choose(POCKETS, pocket.model or world.models.pocket, "pocket"),
            pocket.lip,
            pocket.rim,
            pocket.restitution,
            pocket.friction,
        )
        for pocket in world.table.pockets
    ]
    return np.array(rows, dtype=np.float64).reshape(len(rows), state.DROP_WIDTH)


__all__ = [
    "Packed",
    "give_rubber",
    "nose_reach",
    "pack_pins",
    "pack_pockets",
    "pack_rubber",
    "pack_world",
    "packed",
    "refuse_rare",
]
