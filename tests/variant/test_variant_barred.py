"""Barred zones and anchors of the carom tables: names, sizes, and who is in on a line."""

from __future__ import annotations

from functools import cache
from math import isclose

import pytest

from engine.game.situation import zones_of
from engine.variant.load import load_variant

CORNERS = {f"corner-{end}-{side}" for end in ("head", "foot") for side in ("left", "right")}
NINE = {
    *("zone-head-left", "zone-head-middle", "zone-head-right"),
    *("zone-middle-left", "zone-middle", "zone-middle-right"),
    *("zone-foot-left", "zone-foot-middle", "zone-foot-right"),
}
EIGHT = {
    *("anchor-head-left", "anchor-head-right", "anchor-foot-left", "anchor-foot-right"),
    *("anchor-left-head", "anchor-left-foot", "anchor-right-head", "anchor-right-foot"),
}
SIX = {f"zone-{end}-{side}" for end in ("head", "middle", "foot") for side in ("left", "right")}
MIDDLE = {
    *("anchor-head-middle", "anchor-foot-middle"),
    *("anchor-left-head", "anchor-left-foot", "anchor-right-head", "anchor-right-foot"),
}
ZONES = {
    "one_cushion": set(),
    "straight_rail": CORNERS,
    "balkline_47_2": NINE | EIGHT,
    "balkline_47_1": NINE | EIGHT,
    "balkline_71_2": SIX | MIDDLE,
}
HALF_L, HALF_W = 1.42, 0.71


@cache
def table_of(name):
    return load_variant(name).world.table


def inside(name, x, y):
    return set(zones_of(table_of(name), (x, y)))


@pytest.mark.parametrize("name", ZONES)
def test_the_zones_are_those_of_the_records(name):
    assert set(table_of(name).zones) == ZONES[name] | {"start"}


@pytest.mark.parametrize("name", ZONES)
def test_balls_and_spots_are_those_of_the_carom_table(name):
    variant = load_variant(name)
    assert {ball.name for ball in variant.program.vocabulary.balls} == {"white", "yellow", "red"}
    assert set(table_of(name).spots) == {
        *("head-spot", "centre-spot", "foot-spot", "start-left", "start-right")
    }


def share_of(name, zones, steps=70):
    """Return the share of the bed's area that each zone covers, off all lines."""
    count = dict.fromkeys(zones, 0)
    for i in range(2 * steps):
        for j in range(steps):
            x = (i + 0.5) / steps * HALF_L - HALF_L
            y = (2 * j + 1) / steps * HALF_W - HALF_W
            for zone in inside(name, x, y) & zones:
                count[zone] += 1
    return {zone: number / (2 * steps * steps) for zone, number in count.items()}


def test_a_corner_is_two_sights_by_one():
    share = 0.71 * 0.355 / 2 / (2.84 * 1.42)
    found = share_of("straight_rail", CORNERS)
    assert all(isclose(found[zone], share, rel_tol=0.03) for zone in CORNERS)


@pytest.mark.parametrize(
    ("name", "zones", "along", "across"),
    [("balkline_47_2", NINE, 1 / 3, 1 / 6), ("balkline_71_2", SIX, 1 / 2, 1 / 4)],
)
def test_the_zones_of_balkline_cover_the_bed_once(name, zones, along, across):
    found = share_of(name, zones)
    assert isclose(sum(found.values()), 1.0, rel_tol=0.01)
    ends = [zone for zone in zones if "head" in zone or "foot" in zone]
    assert all(isclose(found[zone], along * across, rel_tol=0.05) for zone in ends)


@pytest.mark.parametrize(
    ("name", "middle", "anchor"),
    [
        ("balkline_47_2", (-HALF_L + 0.089, 0.71 / 3), "anchor-head-left"),
        ("balkline_47_2", (HALF_L - 0.089, -0.71 / 3), "anchor-foot-right"),
        ("balkline_47_2", (2.84 / 3, HALF_W - 0.089), "anchor-left-foot"),
        ("balkline_47_1", (-2.84 / 3, 0.089 - HALF_W), "anchor-right-head"),
        ("balkline_71_2", (0.089 - HALF_L, 0.0), "anchor-head-middle"),
        ("balkline_71_2", (HALF_L - 0.089, 0.0), "anchor-foot-middle"),
        ("balkline_71_2", (-0.71, HALF_W - 0.089), "anchor-left-head"),
        ("balkline_71_2", (0.71, 0.089 - HALF_W), "anchor-right-foot"),
    ],
)
def test_an_anchor_is_a_square_astride_the_end_of_a_line(name, middle, anchor):
    x, y = middle
    reach = 0.089
    for way, other in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        edge = (x + way * reach * 0.99, y + other * reach * 0.99)
        beyond = (x + way * reach * 1.01, y + other * reach * 1.01)
        assert anchor in inside(name, *edge)
        if abs(beyond[0]) < HALF_L and abs(beyond[1]) < HALF_W:
            assert anchor not in inside(name, *beyond)


def test_every_anchor_holds_a_line_and_is_off_the_spots():
    for name in ("balkline_47_2", "balkline_71_2"):
        for spot in table_of(name).spots.values():
            assert not {zone for zone in inside(name, *spot) if zone.startswith("anchor")}


def test_a_ball_on_a_line_is_in_both_zones():
    assert inside("balkline_47_2", -1.2, 0.71 / 3) >= {"zone-head-left", "zone-head-middle"}
    assert inside("balkline_71_2", 0.3, 0.0) == {"zone-middle-left", "zone-middle-right"}
    assert inside("straight_rail", -1.065, 0.5325) == {"corner-head-left"}
    assert inside("straight_rail", -1.065, 0.5323) == set()


def test_the_script_watches_every_barred_zone_and_nothing_else():
    for name, zones in ZONES.items():
        assert load_variant(name).program.asks == zones, name
