"""Closes the hole between a mark on the cloth and what a ball's centre does about it."""

from __future__ import annotations

from itertools import pairwise
from math import hypot, pi, sqrt

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from engine.table.build import PocketCut, build_table
from engine.table.furniture import Area, Disc, HalfPlane, Line, Places
from engine.table.marks import Piece, contains, crossings, side, zone_changes
from engine.table.room import free_place, nearest_place, spot_is_free

TABLE = build_table(2.54, 1.27, 0.0363, None, None, 0.12)
CORNER = PocketCut(0.116, 142 * pi / 180, 0.04, 0.006, 0.065)
SIDE = PocketCut(0.1285, 104 * pi / 180, 0.005, 0.006, 0.065)
POCKETED = build_table(2.54, 1.27, 0.0363, CORNER, SIDE, 0.12)
ACROSS = Line((-0.635, -0.635), (-0.635, 0.635))
R = 0.028575


def behind(x, *, closed):
    return Area((HalfPlane((x, 0), (-1, 0), closed),))


@pytest.mark.parametrize(
    ("offset", "open_holds", "closed_holds"),
    [
        (-0.0002, True, True),
        (-9e-05, False, True),
        (0, False, True),
        (9e-05, False, True),
        (0.0002, False, False),
    ],
)
def test_a_centre_within_a_tenth_of_a_millimetre_is_on_the_line(offset, open_holds, closed_holds):
    point = (-0.635 + offset, 0.2)
    assert contains(behind(-0.635, closed=False), point, TABLE) is open_holds
    assert contains(behind(-0.635, closed=True), point, TABLE) is closed_holds


def test_the_half_disc_holds_its_own_border():
    zone = Area((HalfPlane((-1, 0), (-1, 0), closed=True), Disc((-1, 0), 0.2, closed=True)))
    assert contains(zone, (-1, 0.2), TABLE)
    assert contains(zone, (-1.2, 0), TABLE)
    assert contains(zone, (-1.2 * 1 - 0.00009, 0), TABLE)
    assert not contains(zone, (-1.2002, 0), TABLE)
    assert not contains(zone, (-0.99, 0), TABLE)
    assert not contains(zone, (-1.15, 0.15), TABLE)


def test_single_places_hold_only_themselves():
    zone = Places(((0.1, 0.2), (0.1, -0.2)))
    assert contains(zone, (0.1, 0.20009), TABLE)
    assert not contains(zone, (0.1, 0.2002), TABLE)
    assert not contains(zone, (0.1, 0), TABLE)


def test_a_ball_that_hangs_in_a_mouth_is_on_the_bed_and_one_behind_the_nose_is_not():
    hanging = (1.2705, 0.58)
    assert contains(Area(), hanging, POCKETED)
    assert not contains(Area(), hanging, TABLE)
    assert not contains(Area(), (1.2705, 0.3), POCKETED)


def test_sides_of_a_line():
    assert side(ACROSS, (-1, 0)) == 1
    assert side(ACROSS, (0, 0)) == -1
    assert side(ACROSS, (-0.63505, 0)) == 0


def test_a_straight_way_crosses_once_at_the_exact_time():
    (only,) = crossings(ACROSS, [Piece(2.0, 1.0, (0, 0), (-1, 0.1))])
    assert only.time == pytest.approx(2.635, abs=1e-12)
    assert only.to == 1


def test_a_curve_that_turns_back_crosses_twice():
    piece = Piece(0.0, 4.0, (0, 0), (-1, 0), (0.5, 0))
    first, second = crossings(ACROSS, [piece])
    assert first.time == pytest.approx((1 - sqrt(1 - 0.635)) / 0.5)
    assert second.time == pytest.approx((1 + sqrt(1 - 0.635)) / 0.5)
    assert (first.to, second.to) == (1, -1)


def test_touching_the_line_and_going_back_is_no_crossing():
    piece = Piece(0.0, 4.0, (-0.135, 0), (-1, 0), (1.0, 0))
    assert piece.at(1.0)[0] == pytest.approx(-0.635)
    assert crossings(ACROSS, [piece]) == ()


def test_setting_out_from_the_line_is_no_crossing():
    assert crossings(ACROSS, [Piece(0, 1, (-0.635, 0), (1, 0))]) == ()


def test_a_crossing_at_a_joint_is_told_once():
    pieces = [Piece(0, 0.635, (0, 0), (-1, 0)), Piece(0.635, 0.3, (-0.635, 0), (-1, 0))]
    (only,) = crossings(ACROSS, pieces)
    assert only.time == pytest.approx(0.635)


def test_a_line_is_crossed_only_between_its_ends():
    short = Line((0.9, 0.635), (1.27, 0.2))
    assert crossings(short, [Piece(0, 1, (0.5, -0.5), (0.9, 0))]) == ()
    assert len(crossings(short, [Piece(0, 1, (0.9, 0.3), (0.36, 0.3))])) == 1


def test_a_zone_is_entered_and_left():
    zone = Area((Disc((0, 0), 0.1, closed=True),))
    changes = zone_changes(zone, [Piece(0, 1, (-0.5, 0.01), (1, 0))], TABLE)
    half = sqrt(0.1001**2 - 0.01**2)
    assert [change.entered for change in changes] == [True, False]
    assert [change.time for change in changes] == pytest.approx([0.5 - half, 0.5 + half])


coordinate = st.floats(-0.6, 0.6)
speed = st.floats(-3, 3)


@given(coordinate, coordinate, speed, speed, speed, speed, st.floats(-0.5, 0.5))
@settings(max_examples=200, deadline=None)
def test_crossings_agree_with_brute_force(x, y, u, v, a, b, line_x):
    line = Line((line_x, -50), (line_x, 50))
    piece = Piece(0.0, 1.0, (x, y), (u, v), (a, b))
    steps = [piece.at(index / 4000)[0] - line_x for index in range(4001)]
    assume(
        all(abs(step) > 2e-4 or abs(u + a * index / 4000) > 0.9 for index, step in enumerate(steps))
    )
    sides = [step > 0 for step in steps if abs(step) > 1e-4]
    flips = sum(first != second for first, second in pairwise(sides))
    assert len(crossings(line, [piece])) == flips


@given(coordinate, coordinate, speed, speed, speed, speed, st.floats(0.05, 0.5))
@settings(max_examples=200, deadline=None)
def test_zone_changes_agree_with_sampling(x, y, u, v, a, b, radius):
    zone = Area((Disc((0, 0), radius, closed=True), HalfPlane((0, 0), (-1, 0), closed=False)))
    piece = Piece(0.0, 1.0, (x, y), (u, v), (a, b))
    changes = zone_changes(zone, [piece], TABLE)
    for index in range(201):
        time = index / 200
        if any(abs(change.time - time) < 1e-6 for change in changes):
            continue
        inside = contains(zone, piece.at(0), TABLE)
        for change in changes:
            inside = change.entered if change.time < time else inside
        assert inside == contains(zone, piece.at(time), TABLE)


def test_a_free_spot_is_taken():
    assert nearest_place(TABLE, (0.635, 0), (1, 0), R, []) == (0.635, 0)


def test_behind_one_ball_it_rests_against_it():
    other = ((0.64, 0.02), R)
    place = nearest_place(TABLE, (0.635, 0), (1, 0), R, [other])
    assert place == pytest.approx((0.64 + sqrt(4 * R * R - 0.02**2), 0))


def test_a_gap_is_kept_on_request():
    place = nearest_place(TABLE, (0.635, 0), (1, 0), R, [((0.635, 0), R)], 0.001)
    assert place == pytest.approx((0.635 + 2 * R + 0.001, 0))


def test_a_place_between_two_balls_is_found_only_where_it_is_wide_enough():
    row = [((0.635, 0), R), ((0.635 + 4 * R, 0), R)]
    place = nearest_place(TABLE, (0.635, 0), (1, 0), R, row)
    assert place == pytest.approx((0.635 + 2 * R, 0))
    tight = [((0.635, 0), R), ((0.635 + 4 * R - 1e-4, 0), R)]
    place = nearest_place(TABLE, (0.635, 0), (1, 0), R, tight)
    assert place == pytest.approx((0.635 + 6 * R - 1e-4, 0))


def test_a_full_way_sends_the_ball_the_other_way():
    wall = [((0.635 + 2 * R * index, 0), R) for index in range(12)]
    assert nearest_place(TABLE, (0.635, 0), (1, 0), R, wall) is None
    place = free_place(TABLE, (0.635, 0), [(1, 0), (-1, 0)], R, wall)
    assert place == pytest.approx((0.635 - 2 * R, 0))


ball = st.tuples(st.tuples(st.floats(0.3, 1.24), st.floats(-0.2, 0.2)), st.just(R))


@given(st.lists(ball, max_size=12), st.sampled_from([0.0, 0.0005]))
@settings(max_examples=200, deadline=None)
def test_the_place_is_free_and_no_nearer_one_is(others, gap):
    place = nearest_place(TABLE, (0.635, 0), (1, 0), R, others, gap)
    far = TABLE.length / 2 - R if place is None else place[0]
    if place is not None:
        assert spot_is_free(place, R, others, gap)
    steps = 400
    for index in range(steps):
        x = 0.635 + (far - 0.635 - 1e-7) * index / steps
        assert not spot_is_free((x, 0), R, others, gap + 2e-9) or x >= far - 1e-6


def test_a_spot_is_free_when_balls_only_touch():
    assert spot_is_free((0, 0), R, [((2 * R, 0), R)])
    assert not spot_is_free((0, 0), R, [((2 * R, 0), R)], 0.0001)
    assert hypot(2 * R, 0) == 2 * R
