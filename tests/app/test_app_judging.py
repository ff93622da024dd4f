"""Facts that only an eye can tell: set for the shot played last, which is judged again."""

from dataclasses import replace

import pytest

from engine.app import commands
from engine.app.cloth import DIALS, on_world, roll_words
from engine.app.judging import facts_of, judged_again, why_not
from engine.app.keeping import Keeper
from engine.app.panel import ClothPanel, FactsPanel, facts_panel
from engine.app.prediction import predict
from engine.app.session import SHOWING, Aid, Mode
from engine.app.steps import act, pass_time
from engine.app.units import Units
from engine.records.journal import resume
from engine.variant.load import list_variants, load_variant


def played(session):
    while session.mode not in SHOWING:
        session = act(session, commands.Confirm())
        if session.mode is Mode.CALLING and session.wanted.obliged:
            session = act(session, commands.CallNextBall(1))
            session = act(session, commands.CallNextPocket(1))
    return act(session, commands.Skip())


@pytest.fixture
def missed(start):
    """A stroke in a game of fair attempts that hits nothing."""
    session = start("snooker")
    while session.mode is not Mode.AIMING:
        session = act(session, commands.Confirm())
    away = replace(session, stroke=session.stroke.headed(180.0).at(0.3))
    return act(act(away, commands.Confirm()), commands.Skip())


def fact(session, name):
    return next(one for one in facts_of(session) if one.name == name)


def test_the_facts_are_those_of_the_script_without_its_timers():
    for one in list_variants():
        program = load_variant(one.name).program
        assert {name for name in program.facts if name not in program.timers} == set(
            program.facts
        ) - set(program.timers)


def test_a_miss_that_was_no_fair_attempt_is_told_and_judged_again(missed):
    names = [one.name for one in facts_of(missed)]
    path, fair = names.index("path"), names.index("fair-attempt")
    before = missed.last.verdict.after.options
    panel = facts_panel(missed).stepped(path, 3)
    assert panel.rows[path][1] == "none"
    after = panel.accept(missed)
    assert after.last.shot.facts == {"path": "none"}
    assert after.mode is Mode.VERDICT
    assert set(before) - set(after.last.verdict.after.options) == {"replace"}
    assert after.last.shot.events == missed.last.shot.events
    panel = FactsPanel(facts_of(after)).stepped(fair, 1)
    assert panel.rows[fair][1] == "no"
    unfair = panel.accept(after)
    assert unfair.last.shot.facts == {"path": "none", "fair-attempt": False}
    assert unfair.last.verdict.after.options == before
    seen = FactsPanel(facts_of(unfair)).stepped(path, 1).stepped(fair, 1).accept(unfair)
    assert seen.last.shot.facts == {"fair-attempt": True}


def test_what_is_judged_again_is_in_the_journal(missed, tmp_path):
    keeper = Keeper(tmp_path / "kept.toml", tmp_path)
    keeper.start(missed.match)
    row = [one.name for one in facts_of(missed)].index("fair-attempt")
    after = facts_panel(missed).stepped(row, 1).accept(missed)
    keeper.follow(after.match)
    kept = resume(tmp_path / "kept.toml", load_variant)
    assert kept.played[-1].shot.facts == {"fair-attempt": False}
    assert kept.situation.options == after.match.situation.options


def test_accepting_what_stood_there_changes_nothing(missed):
    same = judged_again(missed, facts_of(missed))
    assert same.match is missed.match
    assert same.note == "judged as before"


def test_why_nothing_can_be_told_is_said(start):
    assert "no shot" in why_not(start("snooker"))
    assert "nothing to an eye" in why_not(played(start("three_cushion")))
    assert why_not(played(start("snooker"))) == ""


def test_a_fact_that_positions_tell_can_be_left_to_them(missed):
    path = fact(missed, "path")
    assert path.words == "as it was seen"
    assert [path.stepped(k).value for k in range(1, 5)] == ["full", "partial", "none", None]


def test_every_fact_of_every_game_can_be_set(start):
    for one in list_variants():
        if not load_variant(one.name).program.facts:
            continue
        try:
            session = played(start(one.name))
        except (RecursionError, IndexError):
            continue
        panel = facts_panel(session)
        for row in range(len(panel.rows)):
            for _ in range(4):
                panel = panel.stepped(row, 1)
        assert panel.accept(session).mode is Mode.VERDICT


def aiming(session):
    while session.mode is not Mode.AIMING:
        session = act(session, commands.Confirm())
    return session


def test_a_slower_cloth_begins_a_practice_match_with_the_same_balls(start):
    session = aiming(start("three_cushion"))
    row = [dial.field for dial in DIALS].index("rolling")
    panel = ClothPanel(session.variant.world).stepped(row, 10)
    after = panel.accept(session)
    assert after.variant.world.cloth.rolling > session.variant.world.cloth.rolling
    assert after.match.seed != session.match.seed
    assert after.layout == session.layout
    one, two = (predict(replace(aiming(s), aid=Aid.ALL)) for s in (session, after))
    assert one.ways != two.ways


def test_the_cloth_as_it_is_changes_nothing(start):
    session = start("three_cushion")
    assert on_world(session, session.variant.world) is session


@pytest.mark.parametrize("dial", DIALS, ids=lambda dial: f"{dial.part}-{dial.field}")
def test_a_dial_stays_within_its_bounds_and_comes_back(start, dial):
    world = start("nine_ball").variant.world
    assert dial.least <= dial.read(world) <= dial.most
    high, low = dial.turned(world, 10**6), dial.turned(world, -(10**6))
    assert (dial.read(low), dial.read(high)) == (dial.least, dial.most)
    assert dial.read(dial.turned(dial.turned(world, 1), -1)) == pytest.approx(
        dial.read(world), abs=dial.step
    )
    assert dial.words(world)


def test_how_far_a_ball_rolls_is_told(start):
    world = start("nine_ball").variant.world
    far = 2.0**2 / (2.0 * world.cloth.rolling * world.cloth.gravity)
    assert Units.METRIC.length(far) in roll_words(world, Units.METRIC)
    assert "ft" in roll_words(world, Units.IMPERIAL)


def test_time_goes_on_after_a_shot_was_judged_again(missed):
    assert pass_time(missed, 1.0).mode is Mode.VERDICT
