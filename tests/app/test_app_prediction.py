"""The aiming aid: five steps, all of them the real physics, made in slices."""

from dataclasses import replace
from math import hypot

import pytest

from engine.app import commands, prediction
from engine.app.prediction import Foretelling, predict
from engine.app.session import Aid, Mode
from engine.app.showing import Showing
from engine.app.steps import act
from engine.game.observe import simulate_shot
from engine.physics.events import BallsCollided
from engine.stage.stage import build_stage


def aiming(start, name, aid, speed=3.0):
    session = start(name)
    while session.mode is not Mode.AIMING:
        session = act(session, commands.Confirm())
    return replace(session, aid=aid, stroke=session.stroke.at(speed))


def test_off_tells_nothing(start):
    assert predict(aiming(start, "nine_ball", Aid.OFF)) is None


@pytest.mark.parametrize(
    ("aid", "parts"),
    [
        (Aid.LINE, (True, False, False)),
        (Aid.GHOST, (True, False, False)),
        (Aid.OBJECT, (True, True, False)),
        (Aid.ALL, (True, True, True)),
    ],
)
def test_each_step_tells_more(start, aid, parts):
    told = predict(aiming(start, "nine_ball", aid))
    assert (bool(told.to_contact), bool(told.object_way), bool(told.ways)) == parts
    assert told.contact == told.to_contact[-1]


def test_what_is_told_is_what_happens(start):
    session = aiming(start, "nine_ball", Aid.ALL, 6.0)
    told = predict(session)
    trace = simulate_shot(session.variant, session.ahead, session.shot)
    cue = session.cue_ball
    meeting = next(
        one
        for one in trace.events()
        if isinstance(one, BallsCollided) and cue in (one.ball, one.other)
    )
    names = [ball.id for ball in trace.balls]
    at = trace.positions([meeting.time])[0][names.index(cue)]
    assert told.contact == pytest.approx((at[0], at[1]), abs=1e-12)
    ends = {tuple(place[:2]) for place in trace.positions([trace.duration])[0].tolist()}
    told_ends = [told.object_way[-1], *(way[-1] for way in told.ways)]
    near = [min(hypot(x - a, y - b) for a, b in ends) for x, y in told_ends]
    assert sum(one < 0.005 for one in near) >= len(told_ends) - len(trace.pocketed) - 1


def test_a_way_has_its_corners_where_the_cushions_are(start):
    session = aiming(start, "three_cushion", Aid.ALL, 8.0)
    trace = simulate_shot(session.variant, session.ahead, session.shot)
    told = predict(session)
    points = {point for way in (told.to_contact, told.object_way, *told.ways) for point in way}
    names = [ball.id for ball in trace.balls]
    for event in trace.events():
        if type(event).__name__ == "CushionHit":
            x, y, _ = trace.positions([event.time])[0][names.index(event.ball)]
            assert min(hypot(x - a, y - b) for a, b in points) < 0.006


def test_slices_change_nothing_in_what_is_told(start, monkeypatch):
    session = aiming(start, "eight_ball", Aid.ALL, 9.0)
    whole = predict(session)
    monkeypatch.setattr(prediction, "SLICE", 0.003)
    monkeypatch.setattr(prediction, "QUICK", 0.0)
    slow = Foretelling(session)
    slices = 0
    while not slow.done:
        slow.go_on(0.0)
        slices += 1
    assert slices > 50
    assert slow.answer == whole


def test_while_it_is_looked_at_the_last_answer_on_this_table_is_shown(start, monkeypatch):
    session = aiming(start, "eight_ball", Aid.OBJECT)
    showing = Showing(build_stage(session.variant))
    monkeypatch.setattr("engine.app.showing.SPARE", 10.0)
    first = showing._aim(session)
    assert len(first) == 3
    monkeypatch.setattr("engine.app.showing.SPARE", 0.0)
    turned = replace(session, stroke=session.stroke.turned(0.5))
    assert [one.points.tolist() for one in showing._aim(turned)] == [
        one.points.tolist() for one in first
    ]
    for _ in range(400):
        later = showing._aim(turned)
    assert later[0].points.tolist() != first[0].points.tolist()
