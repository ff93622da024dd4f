"""What is read off only where it is asked for tells the same as if all of it were read at once."""

from dataclasses import replace
from pathlib import Path

import pytest

from engine.game.contacts import Contacts, ZonesAt, contacts_of, nose_reach, zones_by_ball
from engine.game.referee import judge_shot
from engine.game.situation import Rest, zones_of
from engine.records.read import read_record
from engine.variant.load import load_variant
from tools.bench.verdict import RULES, long_strokes, told_alone

GOLDEN = Path(__file__).resolve().parent.parent / "golden"


@pytest.fixture(scope="module")
def strokes():
    return long_strokes()


def test_the_long_strokes_are_as_long_as_they_say(strokes):
    assert [len(shot.events) for _, _, shot in strokes] == [40, 40, 40]
    assert {len(variant.program.rules) for variant, _, _ in strokes} == {RULES}


def test_one_contact_asked_for_is_as_all_of_them(strokes):
    variant, before, shot = strokes[0]
    lying = {**before.rest.positions}
    ball, other = sorted(lying)[:2]
    table = variant.world.table
    reach = nose_reach(variant.world.balls[0].radius, table.nose_height)
    lying[ball] = (0.3, table.width / 2 - reach)
    pairs = set(Contacts(variant.world, lying))
    assert any(two.startswith("cushion") for _, two in pairs)
    ids = [one.id for one in variant.world.balls]
    ends = [*ids, *(f"cushion {cushion.id}" for cushion in table.cushions)]
    asked = {(a, b) for a in ids for b in ends if (a, b) in Contacts(variant.world, lying)}
    assert asked == pairs
    told = Contacts(variant.world, lying, frozenset({(other, "cushion head")}))
    assert (other, "cushion head") in told
    assert set(told) == pairs | {(other, "cushion head")}
    assert contacts_of(variant.world, Rest(frozen=frozenset(pairs))) == pairs
    assert shot.after.frozen == frozenset()


def test_zones_of_a_place_are_those_that_hold_it(strokes):
    variant, before, _ = strokes[0]
    table = variant.world.table
    for ball, at in before.rest.positions.items():
        assert ZonesAt(table, at) == zones_of(table, at)
        assert zones_by_ball(table, before.rest)[ball] == zones_of(table, at)


def _asked_always(program):
    """Return the program without the signs by which rules are passed over."""

    def plain(rules):
        return tuple(replace(rule, asked=0, there=0, any=0) for rule in rules)

    return replace(
        program,
        compiled={name: plain(rules) for name, rules in program.compiled.items()},
        by_phase={
            name: {phase: plain(rules) for phase, rules in found.items()}
            for name, found in program.by_phase.items()
        },
    )


@pytest.mark.parametrize("game", ["eight_ball", "snooker", "five_pins", "blackball", "killer"])
def test_a_rule_that_is_passed_over_would_not_have_fired(game):
    variant = load_variant(game)
    asked = replace(variant, program=_asked_always(variant.program))
    passed = [rule for rules in variant.program.compiled.values() for rule in rules]
    assert any(rule.asked or rule.any for rule in passed)
    for path in sorted((GOLDEN / game).glob("*.toml")):
        record = read_record(path, lambda _: variant)
        shot = record.steps[0].shot
        if shot.events is None:
            continue
        one = judge_shot(variant, record.start, shot)
        other = judge_shot(asked, record.start, shot)
        assert (one.fouls, one.points, one.spotted) == (other.fouls, other.points, other.spotted)
        assert tuple(one.explanation) == tuple(other.explanation)
        assert one.after.state == other.after.state
        assert one.after.offers == other.after.offers


def test_what_events_alone_tell_is_enough_for_fouls_and_points(strokes):
    for stroke in strokes:
        known = judge_shot(*stroke, explain=False)
        alone = judge_shot(*told_alone(stroke), explain=False)
        assert ([foul.name for foul in known.fouls], known.points) == (
            [foul.name for foul in alone.fouls], alone.points,
        )  # fmt: skip
