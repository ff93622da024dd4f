"""Closes the hole between the shipped files and the published figures and names."""

from __future__ import annotations

from math import hypot, sqrt

import pytest

from engine.variant.load import read_draft
from engine.variant.rack import lay_rack
from engine.variant.words import vocabulary_of
from rulelang.diagnostics import render

SIX = {"head-left", "head-right", "side-left", "side-right", "foot-left", "foot-right"}
SIX_CUSHIONS = {"head", "foot", "left-head", "left-foot", "right-head", "right-foot"}
FOUR_CUSHIONS = {"head", "foot", "left", "right"}

NAMES = {
    "eight_ball": {
        "balls": {"cue", *(str(number) for number in range(1, 16))},
        "cue_balls": {"cue"},
        "pockets": SIX,
        "cushions": SIX_CUSHIONS,
        "lines": {"head-string", "centre-string"},
        "zones": {"kitchen", "table"},
        "spots": {"head-spot", "centre-spot", "foot-spot"},
    },
    "snooker": {
        "balls": {
            "cue",
            *(f"red-{number}" for number in range(1, 16)),
            *("yellow", "green", "brown", "blue", "pink", "black"),
        },
        "cue_balls": {"cue"},
        "pockets": SIX,
        "cushions": SIX_CUSHIONS,
        "lines": {"baulk-line"},
        "zones": {"d", "baulk"},
        "spots": {
            *("black-spot", "pink-spot", "blue-spot", "brown-spot", "green-spot", "yellow-spot")
        },
    },
    "english_billiards": {
        "balls": {"white", "yellow", "red"},
        "cue_balls": {"white", "yellow"},
        "pockets": SIX,
        "cushions": SIX_CUSHIONS,
        "lines": {"baulk-line"},
        "zones": {"d", "baulk"},
        "spots": {
            *("black-spot", "pink-spot", "blue-spot", "brown-spot", "green-spot", "yellow-spot")
        },
    },
    "free_pyramid": {
        "balls": {"cue", *(str(number) for number in range(1, 16))},
        "cue_balls": {"cue"},
        "pockets": SIX,
        "cushions": SIX_CUSHIONS,
        "lines": {"home-line", "centre-string"},
        "zones": {"home"},
        "spots": {"head-spot", "centre-spot", "foot-spot"},
    },
    "three_cushion": {
        "balls": {"white", "yellow", "red"},
        "cue_balls": {"white", "yellow"},
        "pockets": set(),
        "cushions": FOUR_CUSHIONS,
        "lines": set(),
        "zones": {"start"},
        "spots": {"head-spot", "centre-spot", "foot-spot", "start-left", "start-right"},
    },
}
SPOTS = {
    "eight_ball": {"head-spot": (-0.635, 0), "centre-spot": (0, 0), "foot-spot": (0.635, 0)},
    "snooker": {
        "black-spot": (1.4605, 0),
        "pink-spot": (0.89225, 0),
        "blue-spot": (0, 0),
        "brown-spot": (-1.0475, 0),
        "green-spot": (-1.0475, 0.292),
        "yellow-spot": (-1.0475, -0.292),
    },
    "free_pyramid": {
        "head-spot": (-0.8875, 0),
        "centre-spot": (0, 0),
        "foot-spot": (0.8875, 0),
    },
    "three_cushion": {
        "head-spot": (-0.71, 0),
        "centre-spot": (0, 0),
        "foot-spot": (0.71, 0),
        "start-left": (-0.71, 0.1825),
        "start-right": (-0.71, -0.1825),
    },
}


def draft_of(name):
    draft, diagnostics = read_draft(name)
    assert not diagnostics, "\n".join(render(one) for one in diagnostics)
    return draft


@pytest.mark.parametrize("name", NAMES)
def test_the_names_are_those_of_the_records(name):
    draft = draft_of(name)
    vocabulary = vocabulary_of(draft)
    for kind, names in NAMES[name].items():
        said = getattr(vocabulary, kind)
        found = {ball.name for ball in said} if kind == "balls" else set(said)
        assert found == names, kind
    assert {cushion.id for cushion in draft.world.table.cushions} == NAMES[name]["cushions"]
    assert {pocket.id for pocket in draft.world.table.pockets} == NAMES[name]["pockets"]


@pytest.mark.parametrize("name", SPOTS)
def test_the_spots_stand_where_the_rulebook_puts_them(name):
    table = draft_of(name).world.table
    assert dict(table.spots) == {
        spot: pytest.approx(place, abs=1e-9) for spot, place in SPOTS[name].items()
    }


def test_the_triangle_has_the_published_coordinates():
    layout = lay_rack(draft_of("eight_ball").rack, 7)
    published = {
        0.635: [0],
        0.684493: [0.028575, -0.028575],
        0.733987: [0.05715, 0, -0.05715],
        0.78348: [0.085725, 0.028575, -0.028575, -0.085725],
        0.832973: [0.1143, 0.05715, 0, -0.05715, -0.1143],
    }
    expected = sorted((x, y) for x, row in published.items() for y in row)
    assert sorted((round(x, 6), round(y, 6)) for x, y in layout.values()) == expected
    assert layout["8"] == pytest.approx((0.733987, 0), abs=1e-6)


@pytest.mark.parametrize("seed", range(40))
def test_the_back_corners_hold_one_solid_and_one_stripe(seed):
    layout = lay_rack(draft_of("eight_ball").rack, seed)
    corners = {ball for ball, (x, y) in layout.items() if x > 0.83 and abs(y) > 0.11}
    assert sorted(int(ball) > 8 for ball in corners) == [False, True]
    assert set(layout) == {str(number) for number in range(1, 16)}


def test_every_place_of_the_triangle_is_filled_by_lot():
    rack = draft_of("eight_ball").rack
    seen = {}
    for seed in range(300):
        for ball, place in lay_rack(rack, seed).items():
            seen.setdefault(place, set()).add(ball)
    fixed = [place for place, balls in seen.items() if balls == {"8"}]
    corners = [place for place in seen if place[0] > 0.83 and abs(place[1]) > 0.11]
    assert len(fixed) == 1
    for place, balls in seen.items():
        if place not in fixed:
            assert len(balls) == 14, place
    assert len(corners) == 2


PINNED = ["14", "10", "5", "13", "8", "4", "2", "6", "7", "9", "1", "15", "3", "11", "12"]


def test_a_seed_lays_the_same_rack_everywhere():
    layout = lay_rack(draft_of("eight_ball").rack, 2026)
    order = sorted(layout, key=lambda ball: (round(layout[ball][0], 6), -layout[ball][1]))
    assert order == PINNED


def test_the_reds_stand_half_a_millimetre_behind_the_pink():
    layout = lay_rack(draft_of("snooker").rack, 1)
    apex = layout["red-1"]
    assert apex == pytest.approx((0.94475 + 0.0005, 0), abs=1e-9)
    assert hypot(layout["pink"][0] - apex[0], apex[1]) - 0.0525 == pytest.approx(0.0005)
    back = [layout[f"red-{number}"] for number in range(11, 16)]
    assert [y for _, y in back] == pytest.approx([0.105, 0.0525, 0, -0.0525, -0.105])
    assert {round(x, 6) for x, _ in back} == {round(0.94525 + 4 * sqrt(3) * 0.02625, 6)}
    assert layout["black"] == pytest.approx((1.4605, 0))
    assert "cue" not in layout


def test_carom_begins_with_the_striker_in_hand():
    layout = lay_rack(draft_of("three_cushion").rack, 1)
    assert layout == {"red": pytest.approx((0.71, 0)), "yellow": pytest.approx((-0.71, 0))}


def test_values_groups_and_own_spots():
    pool = {ball.id: ball for ball in draft_of("eight_ball").balls}
    assert [pool[str(number)].value for number in range(1, 16)] == list(range(1, 16))
    assert {ball for ball in pool if "solids" in pool[ball].groups} == set("1234567")
    assert {ball for ball in pool if "stripes" in pool[ball].groups} == {
        str(number) for number in range(9, 16)
    }
    assert pool["9"].pattern == "stripe"
    assert pool["3"].pattern == "plain"
    snooker = {ball.id: ball for ball in draft_of("snooker").balls}
    colours = ["yellow", "green", "brown", "blue", "pink", "black"]
    assert [snooker[name].value for name in colours] == [2, 3, 4, 5, 6, 7]
    assert [snooker[name].spot for name in colours] == [f"{name}-spot" for name in colours]
    assert {snooker[f"red-{number}"].value for number in range(1, 16)} == {1}
