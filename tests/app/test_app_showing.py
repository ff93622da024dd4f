"""What a player saw at the window in matches played to their end, and what was mended of it."""

from dataclasses import replace
from math import radians
from types import SimpleNamespace

import numpy as np
import pytest

from engine.app import commands
from engine.app.board import board_of
from engine.app.keymap import Keymap
from engine.app.prompts import buttons_of
from engine.app.session import Mode
from engine.app.showing import Showing
from engine.app.steps import act
from engine.app.telling import verdict_lines
from engine.app.units import Units
from engine.scene.camera import project
from engine.stage.cameras import orbit_camera, orbit_distance
from engine.stage.stage import build_stage

SIZES = [(980, 560), (1500, 840), (660, 470), (400, 700)]


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("turn", [0.0, 0.7, 2.0, 3.4])
def test_the_free_camera_begins_with_all_of_the_table(start, size, turn):
    table = start("eight_ball").variant.world.table
    steep = radians(38.0)
    far = orbit_distance(table, turn, steep, size[0] / size[1])
    camera = orbit_camera(table, turn, steep, far)
    x, y = table.length / 2 + 0.1, table.width / 2 + 0.1
    corners = [(sx * x, sy * y, 0.03) for sx in (-1, 1) for sy in (-1, 1)]
    seen = np.array([project(camera, size, corner) for corner in corners])
    assert (seen >= 0).all()
    assert (seen <= size).all()
    assert (np.ptp(seen, axis=0) / size).max() > 0.6


def test_a_ball_that_falls_at_the_very_end_is_gone_then(start):
    session = start("eight_ball")
    balls = [SimpleNamespace(id="cue"), SimpleNamespace(id="1")]
    trace = SimpleNamespace(
        duration=2.0,
        balls=balls,
        positions=lambda times: np.array([[[0.0, 0.0, 0.03], [1.0, 0.0, _height(times[0])]]]),
    )
    showing = Showing(build_stage(session.variant))
    rolling = replace(session, mode=Mode.ROLLING, trace=trace, clock=1.9)
    assert showing.places(rolling).keys() == {"cue", "1"}
    assert showing.places(replace(rolling, mode=Mode.VERDICT, clock=2.0)).keys() == {"cue"}


def _height(time):
    return 0.03 if time <= 2.0 else -0.03


def test_long_ways_are_told_in_the_greater_unit():
    assert Units.METRIC.length(0.5) == "50.0 cm"
    assert Units.METRIC.length(16.0) == "16.00 m"
    assert Units.IMPERIAL.length(3.048) == "10.0 ft"


def test_house_rules_are_told_with_their_values(start):
    session = start("free_pyramid", **{"jumped-ball": "every-ball"})
    assert "jumped ball: every ball" in board_of(session).phase


def test_a_life_that_is_lost_is_told_where_no_points_are_counted(start):
    session = act(start("killer"), commands.Confirm())
    for command in (commands.SetSpeed(0.2), commands.Confirm(), commands.Skip()):
        session = act(session, command)
    said = [line.text for line in verdict_lines(session.variant, session.last, ("Ann", "Bo"))]
    assert "Ann: lives: 2" in said
    assert not any(text.startswith("Bo:") for text in said)


def test_after_a_match_a_new_one_begins(start):
    session = replace(start("five_pins", **{"sets-to-win": 1}), mode=Mode.OVER)
    assert buttons_of(session, Keymap())[0].text == "Next game"
    over = replace(session.match.situation, match_over=True)
    session = replace(session, match=replace(session.match, situation=over))
    assert buttons_of(session, Keymap())[0].text == "New match"


def test_rules_of_one_name_are_told_once(start):
    session = _broken(start("free_pyramid"))
    for command in (commands.Confirm(), commands.Choose(1), commands.Confirm()):
        session = act(session, command)
    session = _broken(session)
    said = [line.text for line in verdict_lines(session.variant, session.last)]
    assert len(said) == len(set(said))


def _broken(session):
    """Return the session after a feeble break."""
    for command in (
        commands.Confirm(),
        commands.SetSpeed(1.0),
        commands.Confirm(),
        commands.Skip(),
    ):
        session = act(session, command)
    return session


def test_what_is_counted_for_the_turn_is_told(start):
    session = start("bar_billiards")
    now = replace(session.ahead, state={**session.ahead.state, "break-points": 150})
    session = replace(session, match=replace(session.match, situation=now), ahead=now)
    assert board_of(session).turn == ("break points: 150",)
