"""Vocabularies of three tables, and records judged straight by the rules, without the host."""

from __future__ import annotations

import re
import tomllib
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from engine.game.phrases import parse_event
from rulelang import evaluate
from rulelang.compile import compile_script
from rulelang.decisions import Decisions, Restore, Spot
from rulelang.events import LeftTable, Pocketed, Rebounded, Settled, ZoneEntered, ZoneLeft
from rulelang.facts import Call, Rest, Shot, Situation
from rulelang.vocabulary import BallName, Vocabulary

if TYPE_CHECKING:
    from rulelang.program import Program

ROOT = Path(__file__).parents[2]
VARIANTS = ROOT / "variants"
SIX = ("head-left", "head-right", "side-left", "side-right", "foot-left", "foot-right")
SIX_CUSHIONS = ("head", "foot", "left-head", "left-foot", "right-head", "right-foot")


def group_of(number: int) -> tuple[str, ...]:
    return ("solids",) if number < 8 else ("stripes",) if number > 8 else ()


POOL = Vocabulary(
    balls=(
        BallName("cue"),
        *(BallName(str(n), n, group_of(n)) for n in range(1, 16)),
    ),
    cue_balls=("cue",),
    pockets=SIX,
    cushions=SIX_CUSHIONS,
    lines=("head-string", "centre-string"),
    zones=("kitchen", "table"),
    spots=("head-spot", "centre-spot", "foot-spot"),
)
COLOURS = ("yellow", "green", "brown", "blue", "pink", "black")
SNOOKER = Vocabulary(
    balls=(
        BallName("cue"),
        *(BallName(f"red-{n}", 1, ("reds",)) for n in range(1, 16)),
        *(BallName(c, n, ("colours",), f"{c}-spot") for n, c in enumerate(COLOURS, 2)),
    ),
    cue_balls=("cue",),
    pockets=SIX,
    cushions=SIX_CUSHIONS,
    lines=("baulk-line",),
    zones=("d", "baulk"),
    spots=tuple(f"{c}-spot" for c in reversed(COLOURS)),
)
CAROM = Vocabulary(
    balls=(BallName("white"), BallName("yellow"), BallName("red")),
    cue_balls=("white", "yellow"),
    cushions=("head", "foot", "left", "right"),
    zones=("start",),
    spots=("head-spot", "centre-spot", "foot-spot", "start-left", "start-right"),
    settings={
        "target": 40,
        "equalising-inning": True,
        "innings-limit": 0,
        "opening-by-cushion": False,
    },
)
TABLES = {"eight_ball": POOL, "snooker": SNOOKER, "three_cushion": CAROM}


def library(name: str) -> tuple[str, str] | None:
    for path in (VARIANTS / "rules" / f"{name}.rules", VARIANTS / f"{name}.rules"):
        if path.exists():
            return path.read_text(encoding="utf-8"), str(path.relative_to(ROOT))
    return None


def nothing_to_use(_name: str) -> None:
    return None


def source_of(variant: str) -> str:
    return (VARIANTS / f"{variant}.rules").read_text(encoding="utf-8")


@cache
def shipped(variant: str) -> Program:
    return compile_script(source_of(variant), f"{variant}.rules", TABLES[variant], library)


def situation_of(
    vocabulary: Vocabulary, program: Program, before: dict[str, Any], settings: dict[str, Any]
) -> Situation:
    every = [ball.name for ball in vocabulary.balls]
    on_table = expand(before["on_table"]) if "on_table" in before else every
    zones = {
        ball: frozenset([where] if isinstance(where, str) else where)
        for ball, where in before.get("zones", {}).items()
    }
    state = {}
    for name, track in program.tracked.items():
        start = 1 if track.by_breaker else track.start
        state[name] = (start, start) if track.per_player else start
    for name, value in before.get("state", {}).items():
        state[name] = tuple(value) if isinstance(value, list) else value
    return Situation(
        players=2,
        shooter=before.get("shooter", 1),
        phase=before.get("phase", program.phases[0] if program.phases else ""),
        scores=tuple(before.get("scores", (0, 0))),
        on_table=frozenset(on_table),
        state=state,
        settings={**vocabulary.settings, **settings},
        in_hand=before.get("in_hand"),
        zones=zones,
        frozen=pairs(before.get("frozen", [])),
        options=tuple(before.get("options", ())),
    )


NEEDS_HOST = (
    r"\bpositions\b|\bplace = |\brerack\b|\brespot\b|\bstrike = |hits outside|choose = .replace"
)


def needs_no_geometry(path: Path) -> bool:
    """Whether the rules alone judge a record: no positions, no balls set anew or taken away."""
    return re.search(NEEDS_HOST, path.read_text(encoding="utf-8")) is None


def expand(names: list[str]) -> list[str]:
    found = []
    for name in names:
        ends = re.fullmatch(r"(.*?)(\d+)\.\.\1(\d+)", name)
        if ends is None:
            found.append(name)
        else:
            stem, first, last = ends.groups()
            found.extend(f"{stem}{n}" for n in range(int(first), int(last) + 1))
    return found


def pairs(phrases: list[str]) -> frozenset[tuple[str, str]]:
    return frozenset(tuple(phrase.split(" to ", 1)) for phrase in phrases)  # type: ignore[misc]


def shot_of(vocabulary: Vocabulary, situation: Situation, told: dict[str, Any]) -> Shot:
    call = told.get("call", {})
    after = told.get("after", {})
    balls = vocabulary.cue_balls
    return Shot(
        struck=told.get("struck", balls[(situation.shooter - 1) % len(balls)]),
        events=tuple(parse_event(text) for text in told.get("events", [])),
        call=Call(
            call.get("ball"), call.get("pocket"), call.get("safety", False), call.get("group")
        ),
        chosen=told.get("choose"),
        facts=told.get("facts", {}),
        rest=Rest({}, pairs(after.get("frozen", [])), after.get("spots", {})),
    )


def spotted(decisions: Decisions, rest: Rest, vocabulary: Vocabulary) -> list[str]:
    """Carry out the spots on a table where only the spots of `rest` are covered."""
    covered = dict(rest.spots)
    found = []
    for action in decisions.table:
        if not isinstance(action, Spot):
            continue
        if action.places[0].kind == "lay":
            found.append(action.ball)
            continue
        tried = ""
        for place in action.places:
            spot = place.spot
            if place.kind == "highest-free":
                own = sorted(vocabulary.balls, key=lambda b: -b.value)
                free = [b.spot for b in own if b.spot and b.spot not in covered]
                spot = free[0] if free else None
            if place.kind == "occupant":
                spot = decisions.homes.get(covered.get(tried, ""))
            if place.kind == "near" or (spot is not None and spot not in covered):
                word = "near" if place.kind == "near" else "at"
                found.append(f"{action.ball} {word} {spot}")
                covered[str(spot)] = action.ball
                break
            tried = spot or ""
    return found


def differences(path: Path, variant: str, program: Program | None = None) -> list[str]:
    """Judge a record and return what differs from its expectation."""
    record = tomllib.loads(path.read_text(encoding="utf-8"))
    program = program or shipped(variant)
    vocabulary = TABLES[variant]
    situation = situation_of(
        vocabulary, program, record.get("before", {}), record.get("settings", {})
    )
    found: list[str] = []
    judged: tuple[Situation, Shot, Decisions] | None = None
    for told in record["shot"]:
        shot = shot_of(vocabulary, situation, told)
        if "choose" in told or situation.options:
            chosen = take(program, situation, told.get("choose", "play"), judged)
            lying = replace(situation, on_table=situation.on_table | back(chosen))
            situation = after(lying, chosen, Rest(situation.zones, situation.frozen))
            decisions, rest = chosen, judged[1].rest if judged else Rest()
            shot = shot_of(vocabulary, situation, told)
        if "choose" not in told or "events" in told:
            decisions, rest = evaluate.judge(program, situation, shot), shot.rest
            judged = (situation, shot, decisions)
            situation = after(lying_after(situation, shot, decisions), decisions, rest)
        for key, expected in told["expect"].items():
            got = got_of(key, decisions, rest, vocabulary)
            if normal(key, expected) != normal(key, got, expected):
                found.append(f"{key}: expected {expected}, got {got}")
    return found


def take(program: Program, situation: Situation, option: str, judged: Any) -> Decisions:
    if option not in situation.options:
        option = "play"
    if judged is None:
        return evaluate.choose(program, situation, option, None, None, None)
    before, shot, decisions = judged
    key = next((o.key for o in decisions.offers if o.option == option), None)
    return evaluate.choose(program, situation, option, key, before, shot)


def back(decisions: Decisions) -> frozenset[str]:
    return frozenset(action.ball for action in decisions.table if isinstance(action, Spot))


def lying_after(situation: Situation, shot: Shot, decisions: Decisions) -> Situation:
    """Take off what fell or left the table, put back what is spotted, move between zones."""
    down, zones = set(), dict(situation.zones)
    for event in shot.events:
        match event:
            case Pocketed(ball) | LeftTable(ball) | Settled(ball):
                down.add(ball)
            case Rebounded(ball):
                down.discard(ball)
            case ZoneEntered(ball, zone):
                zones[ball] = zones.get(ball, frozenset()) | {zone}
            case ZoneLeft(ball, zone):
                zones[ball] = zones.get(ball, frozenset()) - {zone}
    cue_balls = {shot.struck}  # taken in hand, or put back
    on_table = (situation.on_table - (down - cue_balls)) | back(decisions)
    zones = {ball: where for ball, where in zones.items() if ball not in down | back(decisions)}
    return replace(situation, on_table=on_table, zones=zones)


def after(situation: Situation, decisions: Decisions, rest: Rest) -> Situation:
    return Situation(
        players=2,
        shooter=decisions.next_player,
        phase=decisions.phase,
        scores=tuple(a + b for a, b in zip(situation.scores, decisions.points, strict=True)),
        on_table=situation.on_table,
        state=decisions.state,
        settings=situation.settings,
        in_hand=decisions.in_hand.zone if decisions.in_hand else None,
        zones=situation.zones,
        frozen=rest.frozen,
        options=tuple(o.option for o in decisions.offers),
    )


def got_of(key: str, decisions: Decisions, rest: Rest, vocabulary: Vocabulary) -> Any:
    match key:
        case "fouls":
            return [foul.name for foul in decisions.fouls]
        case "points":
            return list(decisions.points)
        case "spotted" | "spotted_in_order":
            return spotted(decisions, rest, vocabulary)
        case "next":
            return decisions.next_player
        case "options":
            return [offer.option for offer in decisions.offers]
        case "in_hand":
            hand = decisions.in_hand
            return "none" if hand is None or hand.zone is None else hand.zone
        case "phase":
            return decisions.phase
        case "over":
            return bool(decisions.endings)
        case "winner":
            return decisions.endings[0].winner if decisions.endings else None
        case "state":
            return {k: list(v) if isinstance(v, tuple) else v for k, v in decisions.state.items()}
        case _:
            return Restore in [type(a) for a in decisions.table]


def normal(key: str, value: Any, pattern: Any = None) -> Any:
    if key in ("fouls", "options", "spotted"):
        return sorted(value)
    if key == "state" and pattern is not None:
        return {name: value.get(name) for name in pattern}
    return value
