"""Group J: blows through balls that touch, by the cluster model that a check is for."""

from __future__ import annotations

import re
from dataclasses import replace
from math import sqrt
from typing import TYPE_CHECKING

import numpy as np

from engine.physics.strike import Motion
from engine.physics.world import MODEL_NAMES, Cloth
from tools.validate.lab import REST, contact_of, radius_of, throw, world_of
from tools.validate.prose import NUMBER, count, spoken

if TYPE_CHECKING:
    from collections.abc import Sequence

    from engine.physics.world import Contact
    from engine.table.furniture import Point
    from tools.validate.check import Check, Wanted
    from tools.validate.lab import Floats

USUAL = "hertz"
"""The model of a blow through touching balls that is meant where a check names none."""

SLIPPERY = Cloth(1e-9, 1e-9, 10.0)
"""A bed that takes nothing while balls cross a gap."""

MOMENT = 1e-9
"""A time (s) in which the blow is over, since the clock stands still while it runs."""


def cluster_of(check: Check) -> str:
    """Return the cluster model that the check names: a field, or the first word that is one."""
    if check.has("cluster"):
        return check.text("cluster")
    found = re.search("|".join(MODEL_NAMES["cluster"]), check.description, re.IGNORECASE)
    return found[0].lower() if found else USUAL


def blow(
    check: Check,
    places: Sequence[Point],
    speeds: Sequence[float],
    until: float = MOMENT,
    *,
    contact: Contact | None = None,
    gap: float = 0.0,
) -> Floats:
    """Return the velocities (n, 2) when a blow along +x has run through the balls, m/s.

    `gap` (m) is the widest over which balls still take part in one blow.
    """
    contact = contact or contact_of(check)
    if gap > 0.0:
        # wider than usual, so that the gap counts and is not taken for touching
        wide = 1.000001 * max(contact.cluster_gap, gap)
        contact = replace(contact, cluster_gap=wide)
    world = world_of(check, len(places), contact=contact, cloth=SLIPPERY, cluster=cluster_of(check))
    motions = {i: Motion((v, 0.0), REST.spin) for i, v in enumerate(speeds) if v}
    trace = throw(world, places, motions, until)
    found: Floats = trace.velocities([until])[0, :, :2]
    return found


def _chain_speeds(check: Check, n: int) -> tuple[float, ...]:
    """Return the balls' speeds before the blow: `speeds`, or those that the words give."""
    if check.has("speeds"):
        return check.numbers("speeds")
    speed = spoken(check, "v", r"# m/s")
    told = check.has("moving") or re.search(r"\w+ balls into", check.words)
    moving = count(check, "moving", r"(\w+) balls into") if told else 1
    return tuple(speed if i < moving else 0.0 for i in range(n))


def _chain(check: Check, wanted: Wanted) -> object:
    """Return the speeds of a chain of balls in a line, each touching the next or `gap` apart."""
    n = len(wanted.value) if isinstance(wanted.value, list) else 0
    found = re.search(rf"gap ({NUMBER}) um", wanted.quantity)
    gap = float(found[1]) * 1e-6 if found else check.number("gap", default=0.0)
    size = 2.0 * radius_of(check)
    # a gap parts the second ball from the third
    places = [(size * i + (gap if i >= 2 else 0.0), 0.0) for i in range(n)]
    speeds = _chain_speeds(check, n)
    until = MOMENT + 2.0 * gap / max(speeds)
    return blow(check, places, speeds, until, gap=gap)[:, 0].tolist()


def _rack(check: Check) -> Floats:
    """Return the velocities over the first ball's speed, of a triangle met at its apex."""
    n = sum(one.quantity.startswith("v ball") for one in check.wanted)
    rows = round((sqrt(8.0 * (n - 1) + 1.0) - 1.0) / 2.0)
    size = 2.0 * radius_of(check)
    places = [(0.0, 0.0)]
    for row in range(rows):
        x = size * (1.0 + row * sqrt(3.0) / 2.0)
        places += [(x, size * (k - row / 2.0)) for k in range(row + 1)]
    return blow(check, places, [check.number("v")])


def _rack_ball(check: Check, wanted: Wanted) -> object:
    return _rack(check)[int(wanted.quantity.split()[-1])].tolist()


def _rack_mirror(check: Check, _: Wanted) -> object:
    """Return the greatest difference between a ball's velocity and its mirror image's, m/s."""
    v, start, worst = _rack(check), 1, float(abs(_rack(check)[0, 1]))
    row = 1
    while start < len(v):
        one = v[start : start + row]
        worst = max(worst, float(np.abs(one - one[::-1] * [1.0, -1.0]).max()))
        start, row = start + row, row + 1
    return worst


def _rack_momentum(check: Check, _: Wanted) -> object:
    return float(_rack(check)[:, 0].sum())


def _rack_energy(check: Check, _: Wanted) -> object:
    return float((_rack(check) ** 2).sum()) / check.number("v") ** 2


KINDS = (
    (r"velocities|gap .* um", _chain),
    (r"v ball \d+", _rack_ball),
    (r"mirror symmetry error", _rack_mirror),
    (r"total momentum x", _rack_momentum),
    (r"KE/KE0", _rack_energy),
)
"""Which quantity is answered by what."""
