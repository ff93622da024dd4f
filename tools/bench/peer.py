"""The open peer beside us: the same shots, played by another interpreter in its own environment.

One idea: the other side gets plain numbers (places, first velocity and spin of the struck ball)
and answers plain numbers, so that neither project sees the other's code.
"""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING

from engine.physics.strike import strike_ball

if TYPE_CHECKING:
    from collections.abc import Sequence

    from engine.physics.world import Layout, Strike
    from tools.bench.shots import Work

SIDE = Path(__file__).with_name("peer_side.py")
WANTED = "an environment that has it: python -m venv DIR && DIR/bin/pip install pooltool-billiards"


class PeerMissingError(RuntimeError):
    """The interpreter given cannot play; the message says what to do."""


@dataclass(frozen=True, slots=True)
class Played:
    """The peer's times (ms, processor) and events of a work, or why it could not play it."""

    times: tuple[float, ...] = ()
    events: tuple[int, ...] = ()
    error: str = ""


def ask_peer(python: str, works: Sequence[Work], shots: int) -> tuple[str, dict[str, Played]]:
    """Return the peer's version and what it answers, by the work's name.

    At most `shots` of each work are played. Raises PeerMissingError where it cannot be asked.
    """
    told = json.dumps([_plain(work, shots) for work in works])
    done = _run(python, told)
    lines = [json.loads(line) for line in done.splitlines() if line.startswith("{")]
    head, answers = lines[0], lines[1:]
    played = {
        one["name"]: Played(tuple(one.get("times", ())), tuple(one.get("events", ())), one["error"])
        if "error" in one
        else Played(tuple(one["times"]), tuple(one["events"]))
        for one in answers
    }
    return f"pooltool {head['version']}", played


def _run(python: str, told: str) -> str:
    try:
        done = subprocess.run(
            [python, str(SIDE)], input=told, capture_output=True, text=True, check=False
        )
    except OSError as error:
        raise PeerMissingError(
            f"{python} cannot be run ({error.strerror}); give {WANTED}"
        ) from None
    if done.returncode:
        last = (done.stderr.strip().splitlines() or ["no reason given"])[-1]
        raise PeerMissingError(f"{python} has no working pooltool ({last}); give {WANTED}")
    return done.stdout


def first_shot(python: str, work: Work) -> tuple[float, float]:
    """Return the seconds from start to end of a process that compiles anew, and of the next."""
    told = json.dumps([_plain(work, 1)])
    with tempfile.TemporaryDirectory() as cache:
        spent = []
        for _ in range(2):
            start = perf_counter()
            subprocess.run(
                [python, str(SIDE)],
                input=told,
                capture_output=True,
                text=True,
                check=True,
                env={**os.environ, "NUMBA_CACHE_DIR": cache},
            )
            spent.append(perf_counter() - start)
    return spent[0], spent[1]


def _plain(work: Work, shots: int) -> dict[str, object]:
    chosen = work.shots[:: max(1, len(work.shots) // shots)][:shots]
    body = next(ball for ball in work.world.balls if ball.id == work.ball)
    return {
        "name": work.name,
        "kind": work.kind,
        "length": work.world.table.length,
        "width": work.world.table.width,
        "radius": body.radius,
        "mass": body.mass,
        "ball": work.ball,
        "shots": [_shot(work, layout, strike) for layout, strike in chosen],
    }


def _shot(work: Work, layout: Layout, strike: Strike) -> dict[str, object]:
    world = work.world
    body = next(ball for ball in world.balls if ball.id == work.ball)
    motion = strike_ball(body, world.cue, world.cloth, strike, flies=False)
    return {"layout": dict(layout), "velocity": motion.velocity, "spin": motion.spin}
