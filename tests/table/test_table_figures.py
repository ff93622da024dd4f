"""Closes the hole between a figure with a margin and the centres that lie in it."""

from __future__ import annotations

from math import hypot

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine.table.build import build_table
from engine.table.furniture import Figure
from engine.table.marks import Piece, contains, zone_changes

TABLE = build_table(2.54, 1.27, 0.0363, None, None, 0.12)
CORNERS = ((-0.1, 0.0), (0.3, -0.2), (0.3, 0.2))
MARGIN = 0.05
coordinate = st.floats(-0.6, 0.6)
speed = st.floats(-3, 3)


@pytest.mark.parametrize(
    ("point", "open_holds", "closed_holds"),
    [
        ((0.1, 0.0), True, True),
        ((-0.1, 0.0), True, True),
        ((-0.1498, 0.0), True, True),
        ((-0.15, 0.0), False, True),
        ((-0.1502, 0.0), False, False),
        ((0.3498, 0.1), True, True),
        ((0.3502, 0.1), False, False),
        ((0.34, 0.24), False, False),
    ],
)
def test_the_margin_runs_straight_beside_the_sides_and_round_the_corners(
    point, open_holds, closed_holds
):
    assert contains(Figure(CORNERS, MARGIN, closed=False), point, TABLE) == open_holds
    assert contains(Figure(CORNERS, MARGIN, closed=True), point, TABLE) == closed_holds


@given(coordinate, coordinate)
@settings(max_examples=200, deadline=None)
def test_a_place_is_in_it_where_some_place_of_the_figure_is_near(x, y):
    sides = [(CORNERS[i], CORNERS[(i + 1) % 3]) for i in range(3)]
    near = min(
        hypot(x - a[0] - s * (b[0] - a[0]) / 400, y - a[1] - s * (b[1] - a[1]) / 400)
        for a, b in sides
        for s in range(401)
    )
    in_figure = all(
        (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) >= 0.0 for a, b in sides
    )
    if abs(near - MARGIN) > 1e-3:
        holds = contains(Figure(CORNERS, MARGIN, closed=False), (x, y), TABLE)
        assert holds == (in_figure or near < MARGIN)


@given(coordinate, coordinate, speed, speed, speed, speed)
@settings(max_examples=200, deadline=None)
def test_its_changes_agree_with_sampling(x, y, u, v, a, b):
    zone = Figure(CORNERS, MARGIN, closed=False)
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
