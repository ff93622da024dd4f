"""What is on, what must be said and what may be chosen before a shot, in the three games."""

from dataclasses import replace
from functools import cache

import pytest

from engine.game.match import start_match
from engine.game.referee import judge_shot, look_ahead
from engine.game.shot import Shot
from engine.variant.load import load_variant
from rulelang.events import BallsHit, CushionHit, Pocketed
from rulelang.facts import Call

load = cache(load_variant)


def opening(game):
    return start_match(load(game)).situation


def required(game, situation, call=None):
    return [one.what for one in look_ahead(load(game), situation, call).required]


@pytest.mark.parametrize(
    ("game", "phase", "zone"),
    [
        ("eight_ball", "break", "kitchen"),
        ("snooker", "red", "d"),
        ("three_cushion", "opening", "start"),
    ],
)
def test_a_game_begins_in_hand(game, phase, zone):
    situation = opening(game)
    assert (situation.shooter, situation.phase, situation.in_hand) == (1, phase, zone)
    assert situation.options == ()


def test_nothing_is_called_at_the_break():
    assert required("eight_ball", opening("eight_ball")) == []


def open_table(*gone):
    begun = opening("eight_ball")
    left = begun.on_table - set(gone)
    return replace(begun, phase="open", in_hand=None, on_table=left)


def test_ball_and_pocket_are_called_after_the_break():
    assert len(required("eight_ball", open_table("1"))) == 1


def test_a_group_may_be_claimed_only_when_one_is_cleared():
    solids = [str(number) for number in range(1, 8)]
    said = required("eight_ball", open_table(*solids))
    assert len(said) == len(required("eight_ball", open_table("1"))) + 1
    settled = replace(open_table(*solids), phase="groups")
    assert required("eight_ball", settled) == required("eight_ball", open_table("1"))


def test_the_8_is_on_when_the_group_is_cleared():
    solids = [str(number) for number in range(1, 8)]
    state = {"group": ("solids", "stripes")}
    settled = replace(open_table(*solids), phase="groups", state=state)
    assert look_ahead(load("eight_ball"), settled).on == {"8"}
    other = replace(settled, shooter=2)
    assert look_ahead(load("eight_ball"), other).on == {str(number) for number in range(9, 16)}


def test_a_colour_is_nominated_after_a_red_and_for_a_free_ball():
    begun = opening("snooker")
    assert required("snooker", begun) == []
    assert required("snooker", replace(begun, phase="colour")) == ["ball"]
    free = replace(begun, state={**begun.state, "free-ball": True})
    assert required("snooker", free) == ["ball"]


def test_the_nominated_ball_is_on():
    snooker, begun = load("snooker"), opening("snooker")
    colour = replace(begun, phase="colour")
    colours = {"yellow", "green", "brown", "blue", "pink", "black"}
    assert look_ahead(snooker, colour).on == colours
    assert look_ahead(snooker, colour, Call(ball="pink")).on == {"pink"}
    free = replace(begun, state={**begun.state, "free-ball": True})
    assert look_ahead(snooker, free, Call(ball="brown")).on == {"brown"}


def test_replaced_balls_stand_as_they_stood():
    snooker, begun = load("snooker"), replace(opening("snooker"), in_hand=None)
    events = (
        BallsHit("cue", ("blue",)),
        BallsHit("blue", ("red-3",)),
        Pocketed("red-3", "foot-left"),
    )
    judged = judge_shot(snooker, begun, Shot(events=events, facts={"path": "full"})).after
    assert "red-3" not in judged.on_table
    assert "replace" in judged.options
    again = judge_shot(snooker, judged, Shot(choice="replace")).after
    assert again.rest.positions == begun.rest.positions
    assert again.on_table == begun.on_table
    assert again.shooter == 1


def test_lots_for_the_black_come_from_the_seed_alone():
    snooker = load("snooker")
    begun = replace(
        opening("snooker"),
        phase="clearing",
        in_hand=None,
        scores=(50, 57),
        on_table=frozenset({"cue", "black"}),
    )
    events = (BallsHit("cue", ("black",)), Pocketed("black", "foot-left"))

    def drawn(seed):
        return judge_shot(snooker, replace(begun, seed=seed), Shot(events=events)).after.shooter

    first = [drawn(seed) for seed in range(40)]
    assert first == [drawn(seed) for seed in range(40)]
    assert set(first) == {1, 2}


def test_the_loser_of_the_eight_is_no_longer_asked():
    eight = load("eight_ball")
    begun = replace(open_table("1"), phase="groups", state={"group": ("solids", "stripes")})
    events = (BallsHit("cue", ("2",)), BallsHit("2", ("8",)), Pocketed("8", "foot-left"))
    after = judge_shot(eight, begun, Shot(events=events)).after
    assert (after.over, after.winner, after.options, after.in_hand) == (True, 2, (), None)


def test_cushions_count_before_the_second_ball_only():
    carom, begun = load("three_cushion"), opening("three_cushion")
    begun = replace(begun, phase="open", in_hand=None)
    cushions = tuple(CushionHit("white", side) for side in ("left", "foot", "right"))
    good = (BallsHit("white", ("red",)), *cushions, BallsHit("white", ("yellow",)))
    late = (BallsHit("white", ("red",)), BallsHit("white", ("yellow",)), *cushions)
    assert judge_shot(carom, begun, Shot(events=good)).points == (1, 0)
    assert judge_shot(carom, begun, Shot(events=late)).points == (0, 0)


def test_only_balls_on_the_table_are_on():
    begun = opening("snooker")
    left = begun.on_table - {"red-6"}
    assert "red-6" not in look_ahead(load("snooker"), replace(begun, on_table=left)).on
