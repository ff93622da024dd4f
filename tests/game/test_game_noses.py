"""What a cushion and the jaws of a pocket stop, on lines and arcs drawn by hand and on a table."""

from math import inf, pi, sqrt

import pytest

from engine.game.noses import lies_in_a_mouth, noses_of, reach_of_nose
from engine.game.sight import View, path_to, snookering_ball
from engine.table.furniture import Curve, Straight
from engine.variant.load import load_variant

WALL = Straight((5.0, -3.0), (5.0, 3.0))
SHOULDER = Curve((5.0, 0.0), 1.0, pi, -pi)


@pytest.fixture(scope="module")
def table():
    return load_variant("snooker").world.table


@pytest.mark.parametrize(
    ("heading", "far"), [(0.0, 4.0), (pi / 4, inf), (pi, inf), (0.3, 4.0 / 0.955336489125606)]
)
def test_a_straight_nose_stops_what_runs_into_it(heading, far):
    assert reach_of_nose((0.0, 0.0), heading, [WALL], 1.0) == pytest.approx(far)


def test_a_nose_seen_from_behind_stops_nothing():
    assert reach_of_nose((9.0, 0.0), pi, [WALL], 1.0) == inf


def test_a_ball_at_the_nose_leaves_it_and_cannot_go_into_it():
    assert reach_of_nose((4.0, 0.0), pi / 2, [WALL], 1.0) == inf
    assert reach_of_nose((4.0, 0.0), 0.5, [WALL], 1.0) == 0.0


def test_a_shoulder_is_met_where_the_wider_arc_is():
    assert reach_of_nose((0.0, 0.0), 0.0, [SHOULDER], 0.5) == pytest.approx(3.5)
    assert reach_of_nose((0.0, 1.2), 0.0, [SHOULDER], 0.5) == pytest.approx(5.0 - sqrt(2.25 - 1.44))
    assert reach_of_nose((0.0, -1.2), 0.0, [SHOULDER], 0.5) == inf
    assert reach_of_nose((0.0, 1.6), 0.0, [SHOULDER], 0.5) == inf
    assert reach_of_nose((9.0, 0.0), 0.0, [SHOULDER], 0.5) == inf


def test_the_round_noses_of_a_round_table_stop_no_chord():
    around = Curve((0.0, 0.0), 5.0, 0.0, 2 * pi)
    assert reach_of_nose((1.0, 0.0), 0.0, [around], 0.5) == inf


def test_only_a_mouth_brings_a_ball_behind_the_noses(table):
    assert lies_in_a_mouth(table, (1.775, 0.878), 0.024)
    assert lies_in_a_mouth(table, (0.0, 0.88), 0.024)
    assert not lies_in_a_mouth(table, (1.7, 0.8), 0.024)


def seen(table, at, **others):
    radii = dict.fromkeys(others, 0.02625)
    return View(at, 0.02625, others, radii, noses_of(table), 0.0241)


def test_an_angled_cue_ball_has_no_path_and_is_snookered_by_no_ball(table):
    angled = seen(table, (1.775, 0.878), red=(1.75, -0.5), blue=(1.76, 0.5))
    assert path_to(angled, ["red"]) == "none"
    assert snookering_ball(angled, ["red"]) is None


def test_out_of_the_mouth_the_ball_in_the_way_hides(table):
    free = seen(table, (1.755, 0.8), red=(1.75, -0.5), blue=(1.755, 0.5))
    assert path_to(free, ["red"]) == "none"
    assert snookering_ball(free, ["red"]) == "blue"


def test_a_ball_before_the_jaw_hides_all_the_same(table):
    near = seen(table, (1.775, 0.878), red=(-1.0, -0.5), blue=(1.72, 0.84))
    assert snookering_ball(near, ["red"]) == "blue"
