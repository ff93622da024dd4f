"""Random shots, sensible and silly, on the shipped games: no clash, no stop, same for any order."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from rule_cases import TABLES, shipped, situation_of, source_of

from rulelang import events as e
from rulelang.evaluate import choose, judge
from rulelang.facts import Call, Rest, Shot, Situation
from rulelang.parse import parse


def events_of(draw: Any, variant: str) -> tuple[e.Event, ...]:
    table = TABLES[variant]
    ball = st.sampled_from([b.name for b in table.balls][:1] * 3 + [b.name for b in table.balls])
    kinds: list[Any] = [
        st.builds(lambda a, b: e.BallsHit(a, (b,)), ball, ball).filter(
            lambda hit: hit.ball != hit.others[0]
        ),
        st.builds(e.CushionHit, ball, st.sampled_from(table.cushions)),
        st.builds(e.LeftTable, ball),
        st.builds(e.OutsideHit, ball),
        st.builds(e.PlayerTouched, ball),
        st.builds(e.TipFollowed, ball),
        st.builds(e.TipHitAgain, ball),
        st.just(e.FootLifted()),
        st.just(e.PlayedTooSoon()),
        st.just(e.StrokeOmitted()),
    ]
    if table.pockets:
        pocket = st.sampled_from(table.pockets)
        kinds += [
            st.builds(e.Pocketed, ball, pocket),
            st.builds(e.Pocketed, ball, pocket),
            st.builds(e.Rebounded, ball, pocket),
            st.builds(e.Settled, ball, pocket, st.sampled_from([1.0, 9.0])),
            st.builds(e.JawHit, ball, pocket),
        ]
    if table.lines:
        kinds.append(st.builds(e.LineCrossed, ball, st.sampled_from(table.lines)))
    return tuple(draw(st.lists(st.one_of(kinds), max_size=12)))


@st.composite
def shots(draw: Any, variant: str) -> tuple[Situation, Shot]:
    table, program = TABLES[variant], shipped(variant)
    names = [b.name for b in table.balls]
    kept = draw(st.sets(st.sampled_from(names), max_size=len(names)))
    told: dict[str, Any] = {
        "shooter": draw(st.integers(1, 2)),
        "phase": draw(st.sampled_from(program.phases)),
        "on_table": sorted(kept | set(table.cue_balls)),
        "scores": draw(st.sampled_from([(0, 0), (39, 30), (50, 57), (40, 39)])),
        "in_hand": draw(st.sampled_from([None, *table.zones])),
    }
    if "group" in program.tracked:
        told["state"] = {"group": draw(st.sampled_from([["none"] * 2, ["solids", "stripes"]]))}
    situation = situation_of(table, program, told, {})
    happened = tuple(x for x in events_of(draw, variant) if named(x) <= situation.on_table)
    call = Call(
        draw(st.sampled_from([None, *names])),
        draw(st.sampled_from([None, *table.pockets])),
        draw(st.booleans()),
    )
    cue = table.cue_balls[(situation.shooter - 1) % len(table.cue_balls)]
    frozen = frozenset({(cue, draw(st.sampled_from(sorted(situation.on_table - {cue} or {cue}))))})
    rest = Rest(frozen=draw(st.sampled_from([frozen, frozenset()])))
    return situation, Shot(cue, happened, call, rest=rest)


def named(event: e.Event) -> frozenset[str]:
    ball = getattr(event, "ball", None)
    return frozenset(x for x in (ball, *getattr(event, "others", ())) if x is not None)


@pytest.mark.parametrize("variant", TABLES)
def test_any_shot_is_judged_and_any_choice_taken(variant: str) -> None:
    program = shipped(variant)

    @settings(max_examples=120, deadline=None, derandomize=True)
    @given(shots(variant))
    def judged(case: tuple[Situation, Shot]) -> None:
        situation, shot = case
        made = judge(program, situation, shot)
        plain = judge(program, situation, shot, explain=False)
        assert replace(made, explanation=()) == plain
        assert len(made.explanation) == len(tuple(made.explanation))
        assert made.next_player in (1, 2)
        assert made.phase in program.phases
        assert set(made.state) == set(program.tracked)
        for offer in made.offers:
            after = replace(situation, shooter=made.next_player, phase=made.phase, state=made.state)
            chosen = choose(program, after, offer.option, offer.key, situation, shot)
            assert chosen.next_player in (1, 2)
            assert chosen.phase in program.phases

    judged()


def test_threads_may_share_the_parser() -> None:
    sources = [source_of(variant) for variant in TABLES] * 8

    def one(source: str) -> int:
        script, mistakes = parse(source, "x")
        return len(script.rules) + 1000 * len(mistakes)

    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(one, sources)) == [one(source) for source in sources]
