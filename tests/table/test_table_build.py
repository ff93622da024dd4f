"""Rectangular tables: names, closed chains, tangent joints, refusals."""

from itertools import pairwise
from math import atan2, cos, hypot, pi, radians, sin

import numpy as np
import pytest

from engine.table.build import PocketCut, build_table
from engine.table.furniture import Straight

CORNER = PocketCut(0.1159, radians(142), 0.04, 0.003, 0.062)
SIDE = PocketCut(0.1286, radians(104), 0.005, 0.003, 0.0645)
ROUND_CORNER = PocketCut(0.083, radians(135), 0.03, 0.102, 0.05)
ROUND_SIDE = PocketCut(0.087, radians(90), 0.0, 0.064, 0.05)
CUTS = [(CORNER, SIDE), (ROUND_CORNER, ROUND_SIDE)]


def ends(shape):
    if isinstance(shape, Straight):
        way = atan2(shape.end[1] - shape.start[1], shape.end[0] - shape.start[0])
        return shape.start, shape.end, way, way

    def at(angle):
        x = shape.centre[0] + shape.radius * cos(angle)
        return x, shape.centre[1] + shape.radius * sin(angle)

    quarter = pi / 2 if shape.sweep > 0 else -pi / 2
    last = shape.start + shape.sweep
    return at(shape.start), at(last), shape.start + quarter, last + quarter


def walk(table):
    """Cushions and jaws in the order of the outline, each run of shapes without a pocket's gap."""
    for index, cushion in enumerate(table.cushions):
        before = table.jaws[2 * index - 1].shapes
        after = table.jaws[2 * index].shapes
        yield [*before, *cushion.shapes, *after]


def test_without_pockets():
    table = build_table(2.84, 1.42, 0.037, None, None, 0.125)
    assert {c.id for c in table.cushions} == {"head", "foot", "left", "right"}
    assert not table.pockets
    assert not table.jaws
    corners = [c.shapes[0] for c in table.cushions]
    for one, two in pairwise([*corners, corners[0]]):
        assert one.end == two.start
    foot = next(c for c in table.cushions if c.id == "foot").shapes[0]
    assert foot.start[0] == foot.end[0] == 1.42
    left = next(c for c in table.cushions if c.id == "left").shapes[0]
    assert left.start[1] == left.end[1] == 0.71


@pytest.mark.parametrize(("corner", "side"), CUTS)
def test_six_pockets_have_their_names_and_places(corner, side):
    table = build_table(2.54, 1.27, 0.036, corner, side, 0.12)
    assert {c.id for c in table.cushions} == {
        "head",
        "foot",
        "left-head",
        "left-foot",
        "right-head",
        "right-foot",
    }
    places = {p.id: p.centre for p in table.pockets}
    assert set(places) == {
        "head-left",
        "head-right",
        "side-left",
        "side-right",
        "foot-left",
        "foot-right",
    }
    for name, (x, y) in places.items():
        assert (x > 0.1) == name.startswith("foot")
        assert (x < -0.1) == name.startswith("head")
        assert (y > 0.0) == name.endswith("left")
    mouths = {
        p.id: hypot(p.mouth[0][0] - p.mouth[1][0], p.mouth[0][1] - p.mouth[1][1])
        for p in table.pockets
    }
    assert mouths["foot-left"] == pytest.approx(corner.mouth, abs=1e-12)
    assert mouths["side-right"] == pytest.approx(side.mouth, abs=1e-12)


@pytest.mark.parametrize(("corner", "side"), CUTS)
def test_the_chain_is_closed_and_tangent(corner, side):
    table = build_table(2.54, 1.27, 0.036, corner, side, 0.12)
    for shapes in walk(table):
        for one, two in pairwise(shapes):
            _, end, _, way = ends(one)
            start, _, onward, _ = ends(two)
            assert hypot(end[0] - start[0], end[1] - start[1]) < 1e-12
            assert abs(sin(onward - way)) < 1e-9
            assert cos(onward - way) > 0


@pytest.mark.parametrize(("corner", "side"), CUTS)
def test_the_drop_fills_the_throat(corner, side):
    """No path of a point from the mouth to the back leads past the drop circle."""
    table = build_table(2.54, 1.27, 0.036, corner, side, 0.12)
    for index, pocket in enumerate(table.pockets):
        deep = [
            ends(table.jaws[2 * index].shapes[-1])[1],
            ends(table.jaws[2 * index + 1].shapes[0])[0],
        ]
        for end in deep:
            assert np.hypot(end[0] - pocket.centre[0], end[1] - pocket.centre[1]) <= (
                pocket.radius + 0.02
            )


def test_facings_have_the_cut_angle():
    table = build_table(2.54, 1.27, 0.036, CORNER, SIDE, 0.12)
    for jaw in table.jaws:
        facing = next(s for s in jaw.shapes if isinstance(s, Straight))
        way = atan2(facing.end[1] - facing.start[1], facing.end[0] - facing.start[0])
        turns = {round(abs((way - k * pi / 2 + pi) % (2 * pi) - pi), 9) for k in range(4)}
        cut = 104 if jaw.pocket.startswith("side") else 142
        assert any(abs(turn - radians(180 - cut)) < 1e-8 for turn in turns)


def test_refusals():
    with pytest.raises(ValueError, match="six pockets or none"):
        build_table(2.54, 1.27, 0.036, CORNER, None, 0.12)
    with pytest.raises(ValueError, match="above zero"):
        build_table(0.0, 1.27, 0.036, None, None, 0.12)
    with pytest.raises(ValueError, match="drop radius"):
        build_table(
            2.54, 1.27, 0.036, PocketCut(0.1159, radians(142), 0.04, 0.003, 0.03), SIDE, 0.1
        )
    with pytest.raises(ValueError, match="leave nothing"):
        build_table(0.3, 0.15, 0.036, CORNER, SIDE, 0.12)
    with pytest.raises(ValueError, match="cut angle"):
        PocketCut(0.1, 0.1, 0.0, 0.01, 0.06)
    with pytest.raises(ValueError, match="above zero"):
        PocketCut(-0.1, 2.0, 0.0, 0.01, 0.06)
