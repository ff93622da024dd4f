"""Closes the hole between the corners of an outline and a closed, right-handed table."""

from __future__ import annotations

from hashlib import sha256
from itertools import pairwise
from math import cos, hypot, pi, radians, sin, tau

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine.table.build import PocketCut, build_table
from engine.table.furniture import Area, Curve, Cushion, CushionId, HalfPlane, PocketId, Straight
from engine.table.marks import Piece, contains, zone_changes
from engine.table.mouth import length_of, point_along
from engine.table.outline import Corner, OutlineError, build_outline
from engine.table.region import (
    bounds,
    distance_to,
    ends,
    has_room,
    is_inside,
    nose_reach,
    on_bed,
    span_at,
    trace,
)
from engine.table.room import nearest_place, nearest_room
from engine.table.rounding import round_corner

BALL = 0.028575
CUT = PocketCut(0.1159, radians(142), 0.04, 0.003, 0.062)
SIDE = PocketCut(0.1286, radians(104), 0.005, 0.003, 0.0645)


def corner(x, y, name, **more):
    return Corner((x, y), CushionId(name), **more)


def build(*corners):
    return build_outline(corners, 0.036, 0.12, BALL)


def pocket(name, cut=CUT):
    return {"pocket": PocketId(name), "cut": cut}


ELL = (
    corner(-1.2, -0.8, "right", **pocket("head-right")),
    corner(1.2, -0.8, "foot"),
    corner(1.2, 0.1, "inner-side", **pocket("foot-left")),
    corner(0.1, 0.1, "inner-end"),
    corner(0.1, 0.8, "left"),
    corner(-1.2, 0.8, "head-left"),
    corner(-1.2, 0.0, "head-right", **pocket("side", SIDE)),
)
STADIUM = (
    corner(-0.6, -0.5, "right"),
    corner(0.6, -0.5, "foot", radius=0.5),
    corner(0.6, 0.5, "left"),
    corner(-0.6, 0.5, "head", through=(-1.1, 0.0)),
)
BEAN = (
    corner(-1.0, -0.5, "right"),
    corner(1.0, -0.5, "foot"),
    corner(1.0, 0.5, "left", through=(0.0, 0.1)),
    corner(-1.0, 0.5, "head", rounding=0.2),
)
SHAPES = {"ell": ELL, "stadium": STADIUM, "bean": BEAN}


def polygon_holds(points, point):
    """A plain ray count, for comparison."""
    x, y = point
    inside = False
    for (ax, ay), (bx, by) in pairwise([*points, points[0]]):
        if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
            inside = not inside
    return inside


@pytest.mark.parametrize("name", SHAPES)
def test_the_outline_is_closed_and_has_the_bed_on_its_left(name):
    table = build(*SHAPES[name])
    for one, two in pairwise([*table.outline, table.outline[0]]):
        (x, y), (u, v) = ends(one)[1], ends(two)[0]
        assert hypot(x - u, y - v) < 1e-9
    for shape in table.outline:
        (x, y), (u, v) = point_along(shape, length_of(shape) / 2)
        assert is_inside(table.outline, (x - 1e-4 * v, y + 1e-4 * u))
        assert not is_inside(table.outline, (x + 1e-4 * v, y - 1e-4 * u))


@pytest.mark.parametrize("name", SHAPES)
def test_between_pockets_cushions_and_jaws_hang_together(name):
    table = build(*SHAPES[name])
    shapes = [s for part in (*table.cushions, *table.jaws) for s in part.shapes]
    starts, last = [ends(s)[0] for s in shapes], [ends(s)[1] for s in shapes]
    free = [p for p in last if min(hypot(p[0] - q[0], p[1] - q[1]) for q in starts) > 1e-9]
    assert len(free) == len(table.pockets)
    for end in free:
        away = min(
            hypot(end[0] - p.centre[0], end[1] - p.centre[1]) - p.radius for p in table.pockets
        )
        assert away < 1e-9


@pytest.mark.parametrize("name", SHAPES)
@given(x=st.floats(-1.3, 1.3), y=st.floats(-0.9, 0.9))
@settings(max_examples=150, deadline=None)
def test_inside_agrees_with_a_fine_polygon(name, x, y):
    table = build(*SHAPES[name])
    if min(distance_to(shape, (x, y)) for shape in table.outline) > 1e-3:
        assert is_inside(table.outline, (x, y)) == polygon_holds(trace(table.outline, 0.02), (x, y))


def test_every_pocket_has_its_mouth_and_takes_its_share_of_the_noses():
    table = build(*ELL)
    assert [p.id for p in table.pockets] == ["head-right", "foot-left", "side"]
    for one, cut in zip(table.pockets, (CUT, CUT, SIDE), strict=True):
        (ax, ay), (bx, by) = one.mouth
        assert hypot(bx - ax, by - ay) == pytest.approx(cut.mouth, abs=1e-9)
        assert not is_inside(table.outline, one.centre)
    names = [cushion.id for cushion in table.cushions]
    assert names == [one.cushion for one in ELL]


def test_a_rectangle_as_an_outline_is_the_rectangle():
    short = build_table(2.54, 1.27, 0.036, CUT, SIDE, 0.12)
    x, y = 1.27, 0.635
    table = build(
        corner(x, -y, "foot", **pocket("foot-right")),
        corner(x, y, "left-foot", **pocket("foot-left")),
        corner(0.0, y, "left-head", **pocket("side-left", SIDE)),
        corner(-x, y, "head", **pocket("head-left")),
        corner(-x, -y, "right-head", **pocket("head-right")),
        corner(0.0, -y, "right-foot", **pocket("side-right", SIDE)),
    )
    for one in short.pockets:
        other = next(p for p in table.pockets if p.id == one.id)
        assert other.centre == pytest.approx(one.centre, abs=1e-9)
        assert other.mouth[0] == pytest.approx(one.mouth[0], abs=1e-9)
    for cushion in short.cushions:
        other = next(c for c in table.cushions if c.id == cushion.id)
        assert ends(other.shapes[0])[0] == pytest.approx(cushion.shapes[0].start, abs=1e-9)
        assert ends(other.shapes[0])[1] == pytest.approx(cushion.shapes[0].end, abs=1e-9)
    for jaw in short.jaws:
        near = [j for j in table.jaws if j.pocket == jaw.pocket]
        gaps = [
            max(
                hypot(a[0] - b[0], a[1] - b[1])
                for s, t in zip(jaw.shapes, j.shapes, strict=True)
                for a, b in zip(ends(s), ends(t), strict=True)
            )
            for j in near
        ]
        assert min(gaps) < 1e-9


def test_the_rectangle_in_short_form_keeps_its_bits():
    tables = (
        build_table(2.54, 1.27, 0.0363, CUT, SIDE, 0.12),
        build_table(2.84, 1.42, 0.037, None, None, 0.125),
    )
    text = "".join(repr(shapes_of(table)) for table in tables)
    assert sha256(text.encode()).hexdigest() == GOLDEN


def shapes_of(table):
    return (
        [(one.id, one.shapes) for one in table.cushions],
        [(one.pocket, one.shapes) for one in table.jaws],
        [(one.id, one.centre, one.radius, one.mouth) for one in table.pockets],
        table.outline,
    )


GOLDEN = "cf04507d01a8d068eef0c5b259ae8be19113045f98066e501982bae0d2b8327f"


def test_the_box_is_about_the_outline():
    table = build(*STADIUM)
    assert (table.length, table.width) == pytest.approx((2.2, 1.0))
    assert bounds(table.outline) == pytest.approx((-1.1, -0.5, 1.1, 0.5))


def test_a_corner_into_the_bed_gets_a_round_nose():
    table = build(*ELL)
    nose = next(c for c in table.cushions if c.id == "inner-end").shapes[0]
    assert isinstance(nose, Curve)
    assert nose.radius == 0.01
    assert nose.sweep == pytest.approx(-pi / 2)
    assert nose.centre == pytest.approx((0.11, 0.11))


@pytest.mark.parametrize("hand", [1.0, -1.0])
def test_a_round_between_an_arc_and_a_line_is_tangent_to_both(hand):
    before = Straight((-1.0, -0.5), (0.6, -0.5))
    after = Curve((0.6 - hand * 0.8, -0.5), 0.8, 0.0 if hand > 0 else pi, hand * 1.0)
    turn = pi / 2
    found = round_corner(before, after, 0.15, turn)
    assert found is not None
    for shape, at in ((before, length_of(before) - found.before), (after, found.after)):
        point, way = point_along(shape, at)
        assert distance_to(found.arc, point) < 1e-9
        share = 0.0 if shape is before else length_of(found.arc)
        assert point_along(found.arc, share)[1] == pytest.approx(way, abs=1e-9)


FAULTS = {
    "clockwise": [
        corner(-1, -0.5, "a"),
        corner(-1, 0.5, "b"),
        corner(1, 0.5, "c"),
        corner(1, -0.5, "d"),
    ],
    "crossing": [
        corner(-1, -0.5, "a"),
        corner(1, -0.5, "b"),
        corner(-1, 0.5, "c"),
        corner(1, 0.5, "d"),
    ],
    "centre": [corner(0, 0, "a"), corner(1, 0, "b"), corner(1, 1, "c")],
    "short": [
        corner(-1, -0.5, "a"),
        corner(1, -0.5, "b"),
        corner(1, -0.47, "c"),
        corner(1, 0.5, "d"),
        corner(-1, 0.5, "e"),
    ],
    "narrow": [corner(-1, 0, "a"), corner(1, -0.2, "b"), corner(1, 0.2, "c")],
    "arc": [
        corner(-1, -0.5, "a"),
        corner(1, -0.5, "b", radius=0.3),
        corner(1, 0.5, "c"),
        corner(-1, 0.5, "d"),
    ],
    "pocket": [
        corner(-1, -0.5, "a"),
        corner(1, -0.5, "b"),
        corner(1, 0.5, "c", **pocket("p", PocketCut(1.5, 2.4, 0.04, 0.003, 0.8))),
        corner(-1, 0.5, "d"),
    ],
}


@pytest.mark.parametrize("kind", FAULTS)
def test_what_is_no_table_is_refused_with_its_fault(kind):
    with pytest.raises(OutlineError) as caught:
        build(*FAULTS[kind])
    assert {fault.kind for fault in caught.value.faults} == {kind}
    assert all(fault.mend for fault in caught.value.faults)


def test_on_the_bed_is_within_the_outline_and_not_within_its_box():
    table = build(*ELL)
    whole = Area()
    assert contains(whole, (-0.5, 0.5), table)
    assert contains(whole, (1.2, -0.3), table)
    assert not contains(whole, (0.6, 0.5), table)
    assert not on_bed(table, (0.6, 0.5))
    assert span_at(table, 0, 0.5) == pytest.approx((-0.8, 0.1))
    assert span_at(table, 0, -0.5) == pytest.approx((-0.8, 0.8))
    assert span_at(table, 1, 0.5) == pytest.approx((-1.2, 0.1))


def test_room_for_a_ball_is_clear_of_the_inner_corner():
    table = build(*ELL)
    reach = nose_reach(BALL, table.nose_height)
    assert has_room(table, (0.1 - reach, 0.5), BALL)
    assert not has_room(table, (0.1 - reach + 1e-6, 0.5), BALL)
    assert not has_room(table, (0.6, 0.5), BALL)
    away = 0.11 - (0.01 + reach) / 2**0.5
    assert has_room(table, (away, away), BALL)
    assert not has_room(table, (away + 1e-6, away), BALL)


def test_a_ball_may_lie_against_a_nose_above_or_below_its_equator():
    for height in (BALL, 0.036, 0.7 * BALL):
        table = build_table(2.0, 1.0, height, CUT, SIDE, 0.12)
        reach = (BALL**2 - (height - BALL) ** 2) ** 0.5
        for at, off in (((0.3, 0.5 - reach), (0, 1)), ((reach - 1.0, 0.2), (-1, 0))):
            assert has_room(table, at, BALL)
            assert not has_room(table, (at[0] + 1e-6 * off[0], at[1] + 1e-6 * off[1]), BALL)


def test_a_ball_has_no_room_over_a_drop_between_two_noses():
    wide = PocketCut(0.1159, radians(142), -0.02, 0.003, 0.08)
    corner_of = nose_reach(BALL, 0.036)
    at = 1.0 - corner_of, 0.5 - corner_of
    assert has_room(build_table(2.0, 1.0, 0.036, CUT, SIDE, 0.12), at, BALL)
    table = build_table(2.0, 1.0, 0.036, wide, SIDE, 0.12)
    assert hypot(at[0] - table.pockets[0].centre[0], at[1] - table.pockets[0].centre[1]) < 0.08
    assert not has_room(table, at, BALL)
    assert not has_room(table, table.pockets[1].centre, BALL)


def test_an_upright_post_keeps_a_ball_off_by_its_whole_radius():
    plain = build_table(2.0, 1.0, 0.036, None, None, 0.12)
    for upright, keep in ((True, 0.02 + BALL), (False, 0.02 + nose_reach(BALL, 0.036))):
        ring = (Curve((0.0, 0.0), 0.02, 0.0, -tau),)
        post = Cushion(CushionId("post"), ring, upright=upright)
        table = type(plain)(2.0, 1.0, 0.036, (*plain.cushions, post), (), ())
        assert has_room(table, (keep, 0.0), BALL)
        assert not has_room(table, (keep - 1e-6, 0.0), BALL)


def test_a_zone_is_left_where_the_outline_is_passed():
    table = build(*ELL)
    way = Piece(0.0, 2.0, (-0.4, 0.5), (1.0, 0.0))
    changes = zone_changes(Area((HalfPlane((-0.2, 0.0), (1.0, 0.0), closed=True),)), [way], table)
    assert [(round(c.time, 3), c.entered) for c in changes] == [(0.2, True), (0.5, False)]


def test_a_spotted_ball_passes_a_post_and_does_not_leave_the_bed():
    plain = build_table(2.0, 1.0, 0.036, None, None, 0.12)
    post = Cushion(CushionId("post"), (Curve((0.0, 0.0), 0.02, 0.0, -tau),))
    table = type(plain)(2.0, 1.0, 0.036, (*plain.cushions, post), (), ())
    place = nearest_place(table, (0.0, 0.0), (1.0, 0.0), BALL, [])
    assert place == pytest.approx((0.02 + nose_reach(BALL, 0.036), 0.0))
    ell = build(*ELL)
    taken = [((-0.1, 0.5), BALL)]
    assert nearest_place(ell, (-0.1, 0.5), (1.0, 0.0), BALL, taken) == pytest.approx(
        (-0.1 + 2 * BALL, 0.5)
    )
    assert nearest_place(ell, (0.04, 0.5), (1.0, 0.0), BALL, [((0.04, 0.5), BALL)]) is None


def test_an_ellipse_of_arcs_has_no_corner():
    count, a, b = 16, 1.3, 0.8
    at = [tau * k / count for k in range(2 * count + 1)]
    places = [(a * cos(t / 2), b * sin(t / 2)) for t in at]
    table = build(
        *(
            corner(*places[2 * k], "left" if k < count // 2 else "right", through=places[2 * k + 1])
            for k in range(count)
        )
    )
    assert [(c.id, len(c.shapes)) for c in table.cushions] == [("left", 8), ("right", 8)]
    for shape in table.outline:
        for share in (0.2, 0.7):
            x, y = point_along(shape, share * length_of(shape))[0]
            assert (x / a) ** 2 + (y / b) ** 2 == pytest.approx(1.0, abs=2e-3)


def test_a_ball_without_a_place_on_its_way_finds_the_nearest_room():
    table = build(*ELL)
    taken = [((0.0, 0.0), BALL)]
    assert nearest_place(table, (0.6, 0.5), (1.0, 0.0), BALL, taken) is None
    place = nearest_room(table, (0.6, 0.5), BALL, taken)
    assert place is not None
    assert has_room(table, place, BALL)
    assert hypot(place[0] - 0.6, place[1] - 0.5) < 0.48
