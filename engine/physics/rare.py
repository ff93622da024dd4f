"""Answers to what the loop asks about models that are not built into it.

One idea: each reads the rows of the balls concerned, lets the model's own function change them, and
notes what happened; a ball in a pocket with a lip is off the bed until an alarm tells how it ended.
Invariant: an answer follows from the arrays and the shot's memory alone.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import hypot, inf, pi
from typing import TYPE_CHECKING

import numpy as np

from engine.physics import entered, lip, state
from engine.physics.clusters import spread_at_once, spread_one_by_one
from engine.physics.collide import closing_speed, strike_apart
from engine.physics.pressed import meet_pressed
from engine.physics.rebound import HUG, friction_at, lean, restitution_at
from engine.physics.rebound import meet_nose as meet_usual
from engine.physics.record import faster_first, into
from engine.physics.shock import C_A, C_B, C_ORDER, C_SPEED, CONTACT_WIDTH
from engine.physics.stronge import stronge

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from engine.physics.asked import Asked

    Floats = NDArray[np.float64]

POCKETS = "pockets"
"""The name under which balls in pockets are kept, and under which the alarm is set."""

NODES = 400
"""Places that are noted of a ball's way through a pocket, at most."""

OUTSIDE = 1e-10
"""How far (m) outside the drop a ball is at least that has come back from it."""

CLEAR = 1e-7
"""A ball (m) that comes back must not lie deeper than this in a nose or another ball."""


@dataclass(frozen=True, slots=True, eq=False)
class Fallen:
    """A ball in a pocket: when and how it ends there, and its motion (`entered.B_*`) then."""

    time: float
    ball: int
    pocket: int
    outcome: int
    body: Floats


def part(one: Floats, two: Floats, numbers: Floats) -> float:
    """Resolve a meeting of two rows by the world's model; return the speed of approach, m/s."""
    if numbers[state.G_BALL_BALL] == state.MATHAVAN_2014:
        return float(meet_pressed(one, two, numbers))
    return float(strike_apart(one, two, numbers))


def rebound(row: Floats, numbers: Floats, nose: Floats, ix: float, iy: float) -> float:
    """Resolve a hit on a nose in the direction (ix, iy) by its model; return the normal speed."""
    speed = float(row[state.VX] * ix + row[state.VY] * iy)
    if nose[state.N_MODEL] != state.STRONGE or speed < state.SOFT:
        return float(meet_usual(row, numbers, nose, ix, iy))
    mu = friction_at(nose, speed, row[state.VX] * iy - row[state.VY] * ix)
    place, e = lean(row, numbers, nose), restitution_at(nose, speed)
    stronge(row, place, mu, ix, iy, e, nose[state.N_RATIO])
    return speed


def meet_ball(asked: Asked) -> None:
    """Resolve two balls that meet, by `mathavan-2014`."""
    rows, one, two = asked.rows, asked.who, asked.other
    first, second = faster_first(rows, one, two)
    speed = part(rows[one], rows[two], asked.world.numbers)
    asked.note(state.TOUCHING, first, second, speed)


def meet_nose(asked: Asked) -> None:
    """Resolve a hit on a nose, by `stronge`."""
    row, nose, numbers = asked.rows[asked.who], asked.noses[asked.other], asked.world.numbers
    ix, iy = into(row, nose)
    speed = row[state.VX] * ix + row[state.VY] * iy
    along = abs(row[state.VX] * iy - row[state.VY] * ix)
    if nose[state.N_SIZE] < 0.0 and meets_lightly(speed, along):
        speed = meet_usual(row, numbers, nose, ix, iy)
    else:
        speed = rebound(row, numbers, nose, ix, iy)
    asked.note(state.NOSE, asked.who, asked.other, speed)


def meet_cluster(asked: Asked) -> None:
    """Resolve a blow through touching balls, by `simultaneous` or `sequential`."""
    rows, numbers = asked.rows, asked.world.numbers
    members = np.array(asked.touched, dtype=np.int64)
    first, second = faster_first(rows, asked.who, asked.other)
    asked.note(state.TOUCHING, first, second, closing_speed(rows[asked.who], rows[asked.other]))
    contacts = np.empty((len(rows) ** 2 // 2 + 1, CONTACT_WIDTH))
    at_once = numbers[state.G_CLUSTER] == state.SIMULTANEOUS
    spread = spread_at_once if at_once else spread_one_by_one
    total = spread(rows, members, len(members), numbers, contacts)
    found = contacts[:total][contacts[:total, C_ORDER] > 0.0]
    for row in found[np.argsort(found[:, C_ORDER], kind="stable")]:
        if {int(row[C_A]), int(row[C_B])} != {asked.who, asked.other}:
            asked.note(state.TOUCHING, int(row[C_A]), int(row[C_B]), float(row[C_SPEED]))


def reach_pocket(asked: Asked) -> None:
    """Take a ball over the lip: what becomes of it is known at once and told when it is time."""
    ball, row, drop = asked.who, asked.rows[asked.who], asked.world.drops[asked.other]
    body, way = _body(row, drop), np.zeros((NODES, 1 + entered.BODY))
    outcome, time, count = lip.fall(body, _hole(asked, asked.other), way)
    body[entered.B_X] += drop[state.D_X]
    body[entered.B_Y] += drop[state.D_Y]
    way[:, 1 + entered.B_X] += drop[state.D_X]
    way[:, 1 + entered.B_Y] += drop[state.D_Y]
    _write_way(asked, ball, way[:count])
    asked.take(ball)
    fallen = Fallen(asked.time + time, ball, asked.other, outcome, body)
    _inside(asked).append(fallen)
    asked.wake(min(one.time for one in _inside(asked)), POCKETS)


def leave_pocket(asked: Asked) -> None:
    """Tell the end of all whose time has come: fallen in, back on the bed, or over the rim."""
    inside = _inside(asked)
    due = [one for one in inside if one.time <= asked.time]
    inside[:] = [one for one in inside if one.time > asked.time]
    for one in sorted(due, key=lambda fallen: (fallen.time, fallen.ball)):
        if one.outcome == entered.OVER:
            asked.note(state.LEFT, one.ball)
        elif one.outcome == entered.BACK and _has_room(asked, one):
            _put_back(asked, one)
        else:
            asked.note(state.DROPPED, one.ball, one.pocket)
    asked.wake(min((one.time for one in inside), default=inf), POCKETS)


def _inside(asked: Asked) -> list[Fallen]:
    """Return the balls that are in pockets and not told yet."""
    found = asked.memory.setdefault(POCKETS, [])
    if not isinstance(found, list):
        raise TypeError("balls in pockets are a list")
    return found


def _body(row: Floats, drop: Floats) -> Floats:
    """Return a ball's row as the pocket's model takes it."""
    body = np.zeros(entered.BODY)
    body[:3] = row[state.X] - drop[state.D_X], row[state.Y] - drop[state.D_Y], row[state.RADIUS]
    body[3:6] = row[state.VX], row[state.VY], 0.0
    body[6:] = row[[state.WX, state.WY, state.WZ]]
    return body


def _hole(asked: Asked, pocket: int) -> Floats:
    """Return a pocket as the model takes it; where the bed lies depends on the noses about it."""
    drop, row = asked.world.drops[pocket], asked.rows[asked.who]
    hole = np.zeros(entered.HOLE)
    hole[[entered.H_RADIUS, entered.H_LIP, entered.H_RIM]] = drop[
        [state.D_SIZE, state.D_LIP, state.D_RIM]
    ]
    hole[[entered.H_E, entered.H_RUB]] = drop[[state.D_E, state.D_RUB]]
    hole[entered.H_BALL] = row[state.RADIUS]
    hole[entered.H_GRAVITY] = asked.world.numbers[state.G_GRAVITY]
    known = asked.memory.setdefault("mouths", {})
    if not isinstance(known, dict):
        raise TypeError("mouths are kept by pocket")
    key = pocket, float(row[state.REACH])
    if key not in known:
        known[key] = mouth_of(asked, pocket, float(row[state.REACH]))
    bx, by, half = known[key]
    x, y = row[state.X] - drop[state.D_X], row[state.Y] - drop[state.D_Y]
    # where it came from the bed is open, whatever the mouth looks like
    came = (x * bx + y * by) / max(hypot(x, y), 1e-9)
    hole[[entered.H_BED_X, entered.H_BED_Y, entered.H_BED_COS]] = bx, by, min(half, came - 1e-9)
    return hole


def mouth_of(asked: Asked, pocket: int, reach: float) -> tuple[float, float, float]:
    """Return the way from a pocket to the bed and the cosine of the half angle that lies open.

    Open are the directions, from the mouth's on, in which a ball's centre at the drop's edge is
    clear of all noses.
    """
    drop = asked.world.drops[pocket]
    (ax, ay), (bx, by) = asked.world.world.table.pockets[pocket].mouth
    mx, my = 0.5 * (ax + bx) - drop[state.D_X], 0.5 * (ay + by) - drop[state.D_Y]
    size = hypot(mx, my)
    start = np.arctan2(my, mx) if size > 1e-9 else 0.0
    steps = np.linspace(0.0, pi, 361)
    for step in steps[1:]:
        for angle in (start + step, start - step):
            x = drop[state.D_X] + drop[state.D_SIZE] * np.cos(angle)
            y = drop[state.D_Y] + drop[state.D_SIZE] * np.sin(angle)
            if nearest_nose(asked.noses, x, y) < reach:
                half = max(step - steps[1], 0.0)
                return float(np.cos(start)), float(np.sin(start)), float(np.cos(half))
    return 1.0, 0.0, -1.0


def nearest_nose(noses: Floats, x: float, y: float) -> float:
    """Return the distance (m) from a point to the nearest nose."""
    straight = noses[noses[:, state.N_CURVED] == 0.0]
    dx, dy = x - straight[:, state.N_X], y - straight[:, state.N_Y]
    along = dx * straight[:, state.N_DX] + dy * straight[:, state.N_DY]
    along -= np.clip(along, 0.0, straight[:, state.N_SIZE])
    across = dx * straight[:, state.N_DY] - dy * straight[:, state.N_DX]
    best = float(np.hypot(along, across).min(initial=inf))
    curved = noses[noses[:, state.N_CURVED] != 0.0]
    dx, dy = x - curved[:, state.N_X], y - curved[:, state.N_Y]
    far = np.hypot(dx, dy)
    within = (
        dx * curved[:, state.N_DX] + dy * curved[:, state.N_DY] >= curved[:, state.N_SPAN] * far
    )
    gaps = np.abs(far - np.abs(curved[:, state.N_SIZE]))
    return min(best, float(gaps[within].min(initial=inf)))


def meets_lightly(speed: float, along: float) -> bool:
    """Say whether a ball runs along a nose round the bed, carried by hops (`rebound.meet_nose`)."""
    hop = HUG * along
    return hop > state.KICK and speed < 2.0 * hop


def _write_way(asked: Asked, ball: int, way: Floats) -> None:
    """Write the ball's way through the pocket as pieces of flight."""
    gravity = float(asked.world.numbers[state.G_GRAVITY])
    for here, there in pairwise(way):
        took = there[0] - here[0]
        if took <= 0.0:
            continue
        piece = asked.pieces[asked.counts[state.PIECES]]
        piece[:] = 0.0
        piece[[state.P_BALL, state.P_T0, state.P_T1, state.P_KIND]] = (
            ball,
            asked.time + here[0],
            asked.time + there[0],
            state.FLY,
        )
        piece[[state.P_X, state.P_Y, state.P_Z]] = here[1:4]
        vx, vy, vz = (there[1:4] - here[1:4]) / took
        piece[[state.P_VX, state.P_VY, state.P_VZ]] = vx, vy, vz + 0.5 * gravity * took
        piece[[state.P_WX, state.P_WY, state.P_WZ]] = here[7:10]
        asked.counts[state.PIECES] += 1


def _has_room(asked: Asked, fallen: Fallen) -> bool:
    """Say whether no other ball lies where one comes back."""
    x, y = fallen.body[0], fallen.body[1]
    for i, row in enumerate(asked.rows):
        if i == fallen.ball or asked.kinds[i] == state.GONE:
            continue
        s = asked.time - row[state.T0]
        ox = row[state.X] + s * (row[state.VX] + 0.5 * s * row[state.AX])
        oy = row[state.Y] + s * (row[state.VY] + 0.5 * s * row[state.AY])
        reach = 2.0 * np.sqrt(row[state.RADIUS] * asked.rows[fallen.ball, state.RADIUS])
        if hypot(ox - x, oy - y) < reach - CLEAR:
            return False
    return True


def _put_back(asked: Asked, fallen: Fallen) -> None:
    """Let a ball go on on the bed, or above it where balls may fly."""
    row, body = asked.rows[fallen.ball], fallen.body
    row[state.T0] = asked.time
    drop = asked.world.drops[fallen.pocket]
    ex, ey = body[0] - drop[state.D_X], body[1] - drop[state.D_Y]
    d = hypot(ex, ey)
    ex, ey, out = ex / d, ey / d, max(d, drop[state.D_SIZE] + OUTSIDE)
    inward = min(body[3] * ex + body[4] * ey, 0.0)
    row[[state.X, state.Y]] = drop[state.D_X] + out * ex, drop[state.D_Y] + out * ey
    row[[state.VX, state.VY]] = body[3] - inward * ex, body[4] - inward * ey
    row[[state.WX, state.WY, state.WZ]] = body[6:]
    row[state.Z], row[state.VZ] = row[state.RADIUS], 0.0
    asked.kinds[fallen.ball] = state.SLIDE
    asked.foreseen[fallen.ball, state.K_TOUCHED] = 1.0


__all__ = [
    "leave_pocket",
    "meet_ball",
    "meet_cluster",
    "meet_nose",
    "part",
    "reach_pocket",
    "rebound",
]
