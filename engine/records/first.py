"""The first stroke of a game, played without a window.

One idea: the same road as in a match: situation, shot, trace, verdict.
"""

from __future__ import annotations

import json
from dataclasses import replace
from math import radians
from typing import TYPE_CHECKING

from engine.game.match import advance, start_match
from engine.game.observe import play
from engine.game.phrases import format_event
from engine.game.placing import usual_place
from engine.game.referee import judge_shot
from engine.game.shot import Shot
from engine.physics.world import Strike
from engine.records.run import Judgement
from engine.records.say import expectation
from engine.records.show import verdict_lines
from engine.records.spec import FARTHEST, FASTEST
from engine.records.write import save_shot_record
from engine.table.region import on_bed

if TYPE_CHECKING:
    from pathlib import Path

    from engine.table.furniture import Point
    from engine.variant.variant import Variant


def first_stroke(
    variant: Variant,
    place: Point | None,
    *,
    speed: float,
    heading: float = 0.0,
    elevation: float = 0.0,
    side: float = 0.0,
    follow: float = 0.0,
    seed: int = 0,
    record: Path | None = None,
    as_json: bool = False,
) -> str:
    """Play one stroke (m/s, degrees, ball radii) and return what happened as text or JSON.

    Raises ValueError for a stroke that cannot be played.
    """
    if not (speed <= FASTEST and abs(heading) <= FARTHEST):
        raise ValueError(f"at most {FASTEST:g} m/s and {FARTHEST:g} degrees")
    match = start_match(variant, seed=seed)
    before = match.situation
    if before.in_hand is not None and place is None:
        place = usual_place(variant, before)
    elif place is not None and not on_bed(variant.world.table, place):
        raise ValueError(f"{place[0]:g} {place[1]:g} is not on the bed: metres from its middle")
    strike = Strike(speed, radians(heading), radians(elevation), side, follow)
    shot = play(variant, before, Shot(placement=place, strike=strike))
    verdict = judge_shot(variant, before, shot)
    if record is not None:
        save_shot_record(record, advance(match, shot, verdict))
    events = [format_event(event) for event in shot.events or ()]
    positions = {ball: list(at) for ball, at in shot.after.positions.items()}
    if as_json:
        told = {"events": events, "positions": positions, "verdict": expectation(verdict, before)}
        return json.dumps(told, indent=2)
    judged = Judgement(before, shot, replace(verdict))
    lines = [*events, "", *(f"{ball} at {x:.4f} {y:.4f}" for ball, (x, y) in positions.items())]
    return "\n".join([*lines, "", *verdict_lines(judged)])
