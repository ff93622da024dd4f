import pytest

from engine.app.calling import callable_groups, next_group, next_pocket, wanted_of
from rulelang.decisions import Admission, Required
from rulelang.facts import Call


def wanted(*whats, player=1):
    return wanted_of(Admission(tuple(Required(player, what) for what in whats)), 1)


@pytest.mark.parametrize(
    ("whats", "words", "obliged"),
    [
        ((), "", False),
        (("ball",), "a ball", True),
        (("ball and pocket",), "a ball and a pocket", True),
        (("ball and pocket or safety",), "a ball and a pocket, or a safety", True),
        (("may group",), "a group", False),
        (
            ("ball and pocket or safety", "may group"),
            "a ball and a pocket, or a safety, if you like a group",
            True,
        ),
    ],
)
def test_what_the_rules_require_is_read_as_words(whats, words, obliged):
    asked = wanted(*whats)
    assert asked.in_words == words
    assert asked.obliged is obliged
    assert asked.anything is bool(whats)


def test_what_another_player_must_call_does_not_bind():
    assert not wanted("ball", player=2).anything


@pytest.mark.parametrize(
    ("call", "met"),
    [
        (Call(), False),
        (Call(ball="x"), False),
        (Call(pocket="y"), False),
        (Call(ball="x", pocket="y"), True),
        (Call(safety=True), True),
        (Call(group="z"), False),
    ],
)
def test_a_call_is_complete_with_ball_and_pocket_or_a_safety(call, met):
    assert wanted("ball and pocket or safety", "may group").is_met(call) is met


def test_what_is_only_allowed_may_be_left_out():
    assert wanted("may group").is_met(Call())


def test_groups_come_round_to_none(start):
    groups = callable_groups(start("eight_ball").variant)
    assert {"solids", "stripes"} <= set(groups)
    call = Call()
    seen = []
    for _ in range(len(groups) + 1):
        call = next_group(call, groups)
        seen.append(call.group)
    assert set(seen) == {None, *groups}


def test_pockets_go_round_the_table_both_ways(start):
    variant = start("snooker").variant
    there = next_pocket(Call(), variant, 1)
    assert next_pocket(next_pocket(there, variant, 1), variant, -1) == there
    call, seen = Call(), []
    for _ in variant.world.table.pockets:
        call = next_pocket(call, variant, 1)
        seen.append(call.pocket)
    assert len(set(seen)) == len(variant.world.table.pockets)
