"""Why a rule fired or did not, in words: values, loops, defines, what is void, what is nothing."""

from dataclasses import replace

from rule_cases import POOL, nothing_to_use, parse_event, situation_of

from rulelang.compile import compile_script
from rulelang.evaluate import choose, judge
from rulelang.facts import Shot


def program_of(script):
    return compile_script(script, "script.rules", POOL, nothing_to_use)


def before_of(program, **given):
    return situation_of(program.vocabulary, program, given, {})


def play(script, events, **given):
    program = program_of(script)
    shot = Shot("cue", tuple(parse_event(text) for text in events.split("; ") if text))
    return judge(program, before_of(program, **given), shot)


def told(script, events, **before):
    """Return each rule's outcome by its name."""
    return {one.rule: one for one in play(script, events, **before).explanation}


def because(script, events, **before):
    return told(script, events, **before)["A"].because


def test_a_loop_over_players_says_for_whom_its_condition_held():
    script = (
        'track lives per game per player\nending:\n    rule "A":\n        for each player:\n'
        "            if lives of that player is 2: eliminate that player\n"
    )
    state = {"lives": (2, 0)}
    assert because(script, "", state=state) == (
        "for player 1: lives of that player is 2: lives of that player was 2"
    )
    assert because(script, "", state={"lives": (1, 1)}) == (
        "for players 1, 2: lives of that player is 2: lives of that player was 1"
    )


def test_a_loop_over_balls_tells_those_it_was_for_in_the_order_of_the_variant():
    script = (
        'table:\n    rule "A":\n        for each of object balls pocketed:\n'
        "            if it is one of stripes: spot it at foot-spot\n"
    )
    pocketed = "10 pocketed foot-left; 9 pocketed foot-left; 1 pocketed foot-left"
    assert because(script, pocketed) == (
        "for 9, 10 of object balls pocketed: it is one of stripes: yes"
    )
    assert because(script, "1 pocketed foot-left") == (
        "for 1 of object balls pocketed: it is one of stripes: no"
    )
    assert because(script, "cue hits 1") == "object balls pocketed: nothing"


def test_a_define_tells_what_it_holds_for_and_why():
    script = (
        "define weak when number of object balls pocketed is fewer than 2 and shot is legal\n"
        'turn:\n    rule "A": if not weak: turn continues\n'
    )
    one = because(script, "1 pocketed foot-left")
    assert one == (
        "weak: yes (number of object balls pocketed is fewer than 2:"
        " number of object balls pocketed was 1; shot is legal: yes)"
    )
    two = because(script, "1 pocketed foot-left; 2 pocketed foot-left")
    assert two == (
        "weak: no (number of object balls pocketed is fewer than 2:"
        " number of object balls pocketed was 2)"
    )


def test_both_sides_of_a_comparison_are_told_where_they_are_not_in_the_text():
    script = (
        "track low per game\ntrack high per game\n"
        'turn:\n    rule "A": if low is at least high: turn continues\n'
    )
    assert because(script, "", state={"low": 3, "high": 8}) == (
        "low is at least high: low was 3, high was 8"
    )


def test_a_set_of_many_balls_is_cut_short():
    script = 'turn:\n    rule "A": if no object ball is on table: turn continues\n'
    assert because(script, "").endswith("on table was 1, 2, 3, 4, 5, 6, 7, 8 and 7 more")


def test_a_foul_is_named_where_the_shot_is_judged_by_it():
    script = (
        "fouls: if cue ball pocketed: foul scratch\n"
        'turn:\n    rule "A": if shot is legal: turn continues\n'
    )
    assert because(script, "cue pocketed foot-left") == "shot is legal: no (scratch)"
    assert because(script, "cue hits 1") == "shot is legal: yes"


def test_otherwise_tells_what_was_not_the_case():
    script = (
        'phases break, open\nturn:\n    rule "A":\n        if 8-ball pocketed: go to phase break\n'
        "        otherwise: go to phase open\n"
    )
    assert because(script, "cue hits 1") == "otherwise (8-ball pocketed: no)"


def test_a_phase_of_the_heading_is_told():
    script = 'phases break, open\nturn in phase open:\n    rule "A": turn continues\n'
    assert because(script, "", phase="break") == "in phase open: phase was break"
    assert because(script, "", phase="open") == "in phase open"


def test_an_award_of_nothing_and_a_spot_of_no_ball_are_not_fired():
    script = (
        "define down as object balls pocketed\n"
        'points:\n    rule "A": if shot is legal: award number of down to shooter\n'
        'table:\n    rule "B": if shot is legal: spot down at foot-spot\n'
    )
    nothing = told(script, "cue hits 1")
    assert (nothing["A"].outcome, nothing["B"].outcome) == ("silent", "silent")
    assert nothing["A"].because == "number of down was 0"
    assert nothing["B"].because == "down was nothing"
    something = told(script, "1 pocketed foot-left")
    assert something["A"].said == ("+1 to player 1",)
    assert something["B"].said == ("spot 1",)


def test_what_comes_next_is_void_when_the_game_is_over():
    script = (
        "turn: if any object ball pocketed: turn continues\n"
        'next shot:\n    rule "A": if 8-ball pocketed:\n        offer opponent:\n'
        "            play: nothing happens\n"
        'ending:\n    rule "Eight": if 8-ball pocketed: shooter wins game\n'
    )
    over = told(script, "8 pocketed foot-left")
    assert (over["A"].outcome, over["A"].because) == ("overridden", 'void: "Eight" ended the game')
    assert over["Eight"].outcome == "fired"
    assert all("may choose" not in said for one in over.values() for said in one.said)
    assert told(script, "1 pocketed foot-left")["Eight"].outcome == "silent"


def test_counting_goes_on_when_the_game_is_over():
    script = (
        'track won-games per match\nnext shot:\n    rule "A": if 8-ball pocketed:\n'
        "        add 1 to won-games\n        give opponent cue ball in hand in kitchen\n"
        "ending: if 8-ball pocketed: shooter wins game\n"
    )
    assert told(script, "8 pocketed foot-left")["A"].said == ("add 1 to won-games",)


def test_a_timer_is_told_as_one():
    script = (
        "timer shot-clock lasts 30 seconds per shot\n"
        'fouls:\n    rule "A": if shot-clock: foul slow\n'
    )
    program = program_of(script)
    shot = Shot("cue", (parse_event("no stroke"),), facts={"shot-clock": True})
    assert judge(program, before_of(program), shot).explanation[0].because == (
        "shot-clock expired: yes"
    )


def test_a_choice_is_explained_by_the_rule_that_offered_it():
    program = program_of(
        'next shot:\n    rule "A": if cue ball pocketed:\n        offer opponent:\n'
        "            in-hand: give chooser cue ball in hand in kitchen\n"
    )
    shot = Shot("cue", (parse_event("cue pocketed foot-left"),))
    before = before_of(program)
    key = judge(program, before, shot).offers[0].key
    (made,) = choose(program, replace(before, shooter=2), "in-hand", key, before, shot).explanation
    assert (made.rule, made.section, made.outcome) == ("A", "choice", "fired")
    assert made.because == "player 2 chose in-hand"
    assert made.said == ("player 2 has the cue ball in hand in kitchen",)


def test_telling_changes_nothing_and_may_be_asked_again():
    script = (
        'points:\n    rule "A":\n        for each of object balls pocketed:\n'
        "            award 1 to shooter\n"
    )
    made = play(script, "1 pocketed foot-left; 2 pocketed foot-left")
    first = tuple(made.explanation)
    assert made.points == (2, 0)
    assert tuple(made.explanation) == first
    assert first[0].because == "for 1, 2 of object balls pocketed"


def test_a_shared_script_says_which_book_its_sections_belong_to():
    def library(name):
        return SHARED[name], f"{name}.rules"

    script = 'game "G" cites "House"\nuses "fouls"\nrule "B" [2]: if 8-ball pocketed: foul other\n'
    program = compile_script(script, "g.rules", POOL, library)
    assert {rule.name: rule.cites for rule in program.rules} == {
        "A": ("Pool 3.1", "Pool 2.2"),
        "C": ("Here 7",),
        "B": ("2",),
    }
    assert (program.rulebook, program.books) == ("House", ("House", "Pool"))
    same = compile_script(script.replace("House", "Pool"), "g.rules", POOL, library)
    assert {rule.name: rule.cites for rule in same.rules}["A"] == ("3.1", "2.2")
    shot = Shot("cue", (parse_event("cue pocketed foot-left"),))
    made = judge(program, before_of(program), shot)
    assert made.fouls[0].cites == ("Pool 3.1", "Pool 2.2")
    assert made.explanation[1].cites == ("Pool 3.1", "Pool 2.2")


SHARED = {
    "fouls": 'cites "Pool"\nuses "more"\nrule "A" [3.1, 2.2]: if cue ball pocketed: foul scratch\n',
    "more": 'rule "C" [Here 7]: if 9-ball pocketed: foul bad-third\n',
}


def test_pins_that_stand_are_not_set_up_again():
    script = 'table:\n    rule "A": set up pins\n'
    table = replace(POOL, pins=("left-pin", "right-pin"))
    program = compile_script(script, "script.rules", table, nothing_to_use)

    def outcome(events):
        shot = Shot("cue", tuple(parse_event(text) for text in events))
        return judge(program, before_of(program), shot).explanation[0]

    fallen = outcome(["cue hits 1", "1 topples left-pin"])
    assert fallen.said == ("set up left-pin",)
    standing = outcome(["cue hits 1"])
    assert (standing.outcome, standing.because) == ("silent", "pins not standing was nothing")


def test_a_define_is_opened_once_in_a_rule():
    script = (
        "define dry when no object ball pocketed\n"
        "define wet when not dry and 8-ball pocketed\n"
        'turn:\n    rule "A": if dry and not wet: turn continues\n'
    )
    assert because(script, "cue hits 1") == (
        "dry: yes (no object ball pocketed: yes); wet: no (dry: yes)"
    )


def test_what_is_awarded_is_told_with_the_expression():
    script = (
        'points:\n    rule "A":\n'
        "        if shot is legal: award value of object balls pocketed to shooter\n"
    )
    told_because = because(script, "9 pocketed foot-left")
    assert told_because == "shot is legal: yes; value of object balls pocketed was 9"


def test_a_define_of_how_many_is_true_by_their_number():
    for quantifier, events, true in (
        ("no object ball", "cue hits 1", True),
        ("no object ball", "1 pocketed foot-left", False),
        ("at least 2 object balls", "1 pocketed foot-left", False),
        ("at least 2 object balls", "1 pocketed foot-left; 2 pocketed foot-left", True),
        ("only stripes", "9 pocketed foot-left; 1 pocketed foot-left", False),
    ):
        script = f"define d when {quantifier} pocketed\nturn: if d: turn continues\n"
        assert play(script, events).continues is true, (quantifier, events)
    assert play(
        "define d as balls pocketed\nturn: if number of d is 2: turn continues\n",
        "1 pocketed foot-left; 2 pocketed foot-left",
    ).continues


CLOSING = """
track racks per match per player
ending:
    if 9-ball pocketed: shooter wins game
    if 8-ball pocketed: tie game
at game end:
    rule "A": add 1 to racks of winner
    rule "B": if racks of winner is at least 2: winner wins match
at match end:
    rule "C" overrides "D": set racks of shooter to 7
    rule "D": set racks of shooter to 8
"""


def test_the_rules_of_an_end_are_told_with_what_they_saw():
    fared = told(CLOSING, "9 pocketed foot-left", state={"racks": (1, 0)})
    assert fared["A"].said == ("add 1 to racks of player 1",)
    assert fared["B"].outcome == "fired"
    assert "racks of winner was 2" in fared["B"].because
    assert (fared["C"].outcome, fared["D"].because) == ("fired", 'overridden by "C"')


def test_an_end_that_nobody_won_is_told():
    fared = told(CLOSING, "8 pocketed foot-left")
    assert [(fared[name].outcome, fared[name].because) for name in "AB"] == [
        ("silent", "nobody won"),
        ("silent", "nobody won"),
    ]
    assert "C" not in fared


def test_rules_of_an_end_are_not_told_before_it():
    assert "A" not in told(CLOSING, "7 pocketed foot-left")
