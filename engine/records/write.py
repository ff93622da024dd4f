"""A played shot becomes a record file.

One idea: the record is written from values alone; reading it back gives the same shot. What the
reader supplies by itself, settings and tracked values as they are at a start, is left out.
"""

from __future__ import annotations

from math import degrees
from typing import TYPE_CHECKING

import tomli_w

from engine.game.match import check_settings, start_game, start_state
from engine.game.phrases import format_event
from engine.records.hash import physics_hash
from engine.records.say import expectation, plain

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    from engine.game.match import Match, Played
    from engine.game.shot import Shot
    from engine.game.situation import Situation
    from engine.game.verdict import Verdict
    from engine.table.furniture import BallId, Point
    from engine.variant.variant import Variant
    from rulelang.facts import Call
    from rulelang.program import Program
    from rulelang.vocabulary import Tracked, Value


def save_shot_record(path: Path, match: Match, index: int = -1, title: str = "") -> None:
    """Write the shot `index` of a match, the last by default, as a record with its verdict."""
    text = record_text(match, index, title)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def record_text(match: Match, index: int = -1, title: str = "") -> str:
    """Return the record of one shot of a match as TOML."""
    played = match.played[index]
    number = index % len(match.played) + 1
    record: dict[str, object] = {
        "format": 1,
        "variant": match.variant.name,
        "title": title or f"Shot {number} of a match of {match.variant.title}",
        "cites": cites_of(match.variant, played.verdict),
        "settings": settings_told(match.variant, match.settings),
        "physics": physics_hash(match.variant.world),
        "before": before_table(match.variant, played.before),
        "shot": [{**shot_table(played.shot), "expect": _expect(match.variant, played)}],
    }
    return tomli_w.dumps({key: value for key, value in record.items() if value not in ([], {})})


def cites_of(variant: Variant, verdict: Verdict) -> list[str]:
    """Return the sections that a verdict rests on, with the name of the rulebook."""
    fired = (rule.cites for rule in verdict.explanation if rule.outcome == "fired")
    fouls = (foul.cites for foul in verdict.fouls)
    sections = dict.fromkeys(section for cites in (*fouls, *fired) for section in cites)
    return [with_book(variant.program, section) for section in sections]


def with_book(program: Program, section: str) -> str:
    """Return a section with the name of the rulebook that it stands in."""
    if any(section.startswith(f"{book} ") for book in program.books):
        return section
    return f"{program.rulebook} {section}".strip()


def settings_told(variant: Variant, settings: Mapping[str, Value]) -> dict[str, Value]:
    """Return the settings that are not the variant's own."""
    usual = check_settings(variant, {})
    return {name: value for name, value in settings.items() if usual[name] != value}


def state_told(variant: Variant, situation: Situation) -> Mapping[str, Tracked]:
    """Return the tracked values that are not those of a start."""
    count, settings = situation.players, situation.settings
    bare = start_state(variant, count)
    opened = start_game(variant, count, settings, situation.seed).state
    return {
        name: value
        for name, value in situation.state.items()
        if value != bare[name] or value != opened[name]
    }


def _expect(variant: Variant, played: Played) -> dict[str, object]:
    told = expectation(played.verdict, played.before)
    after = played.verdict.after
    names = {*state_told(variant, played.before), *state_told(variant, after)}
    state = {name: plain(value) for name, value in after.state.items() if name in names}
    return {key: value for key, value in told.items() if key != "state"} | (
        {"state": state} if state else {}
    )


def before_table(variant: Variant, situation: Situation) -> dict[str, object]:
    """Return the situation as a `before` table; balls in the order of the variant."""
    order = [ball.id for ball in variant.balls]
    table: dict[str, object] = {"shooter": situation.shooter}
    if situation.phase:
        table["phase"] = situation.phase
    table["scores"] = list(situation.scores)
    table["on_table"] = [ball for ball in order if ball in situation.on_table]
    if situation.in_hand is not None:
        table["in_hand"] = situation.in_hand
    if situation.offers:
        table["options"] = list(situation.options)
    if state := state_told(variant, situation):
        table["state"] = {name: plain(value) for name, value in state.items()}
    if situation.rest.positions:
        table["positions"] = _positions(situation.rest.positions)
    return table


def shot_table(shot: Shot) -> dict[str, object]:
    """Return the shot as a `[[shot]]` table without its `expect`."""
    table: dict[str, object] = {}
    if shot.choice is not None:
        table["choose"] = shot.choice
    if call := _call(shot.call):
        table["call"] = call
    if shot.struck is not None:
        table["struck"] = shot.struck
    if shot.placement is not None:
        table["place"] = list(shot.placement)
    if shot.strike is not None:
        strike = shot.strike
        table["strike"] = {
            "speed": strike.speed,
            "heading": round(degrees(strike.heading), 9),
            "elevation": round(degrees(strike.elevation), 9),
            "side": strike.side,
            "follow": strike.follow,
        }
    if shot.events is not None:
        table["events"] = [format_event(event) for event in shot.events]
    if shot.facts:
        table["facts"] = dict(shot.facts)
    if shot.after.positions:
        table["after"] = {"positions": _positions(shot.after.positions)}
    return table


def _call(call: Call) -> dict[str, object]:
    told = {"ball": call.ball, "pocket": call.pocket, "group": call.group}
    table: dict[str, object] = {key: value for key, value in told.items() if value is not None}
    return table | ({"safety": True} if call.safety else {})


def _positions(positions: Mapping[BallId, Point]) -> dict[str, list[float]]:
    return {ball: [x, y] for ball, (x, y) in positions.items()}
