"""Timers, sides, and what happens where a game or a match begins and ends."""

from __future__ import annotations

from dataclasses import replace

import pytest
from rule_cases import POOL, nothing_to_use, parse_event

from rulelang.compile import check_script, compile_script
from rulelang.evaluate import admit, judge, start
from rulelang.facts import Shot, Situation

TABLE = replace(POOL, players=(2, 4))


def program_of(script):
    return compile_script(script, "s.rules", TABLE, nothing_to_use)


def before(program, players=2, shooter=1, **told):
    """Return a situation in which everything is as it starts."""
    state = {
        name: (track.start,) * players if track.per_player else track.start
        for name, track in program.tracked.items()
    }
    told.setdefault("state", state)
    balls = frozenset(ball.name for ball in TABLE.balls)
    phase = (program.phases or ("",))[0]
    scores = told.pop("scores", (0,) * players)
    return Situation(players, shooter, phase, scores, balls, **told)


def play(script, events="", facts=None, **told):
    program = program_of(script)
    made = tuple(parse_event(text) for text in events.split("; ") if text)
    return judge(program, before(program, **told), Shot("cue", made, facts=facts or {}))


CLOCK = """
timer shot-clock lasts 35 seconds per shot
timer bar lasts 900 seconds per game
track late per game per player
when shot-clock expires:
    rule "Too slow" [1]:
        foul slow
        turn passes
        give opponent cue ball in hand in table
        add 1 to late of shooter
fouls:
    if stroke was not played and not shot-clock: foul no-stroke
"""


def test_a_timer_is_known_and_its_rules_go_to_their_sections():
    program = program_of(CLOCK)
    assert {name: (t.seconds, t.per) for name, t in program.timers.items()} == {
        "shot-clock": (35.0, "shot"),
        "bar": (900.0, "game"),
    }
    told = play(CLOCK, "no stroke", {"shot-clock": True})
    assert [foul.name for foul in told.fouls] == ["slow"]
    assert (told.next_player, told.in_hand.zone, told.state["late"]) == (2, "table", (1, 0))


def test_a_timer_that_did_not_run_out_changes_nothing():
    told = play(CLOCK, "no stroke")
    assert [foul.name for foul in told.fouls] == ["no-stroke"]
    assert (told.in_hand, told.state["late"]) == (None, (0, 0))


def test_a_rule_of_a_timer_may_override_one_of_its_section():
    script = (
        "timer clock lasts 10 seconds\n"
        'fouls:\n    rule "A": if stroke was not played: foul aa\n'
        'when clock expires:\n    rule "B" overrides "A": foul bb\n'
    )
    assert [f.name for f in play(script, "no stroke", {"clock": True}).fouls] == ["bb"]
    assert [f.name for f in play(script, "no stroke").fouls] == ["aa"]


def codes(script):
    return [(one.line, one.code) for one in check_script(script, "s", TABLE, nothing_to_use)]


@pytest.mark.parametrize(
    ("script", "told"),
    [
        ("when clock expires: foul x\n", [(1, "R207")]),
        ("timer clock lasts 0 seconds\nwhen clock expires: foul x\n", [(1, "R307"), (2, "R207")]),
        ("timer clock lasts 999999 seconds\n", [(1, "R307")]),
        ("timer clock lasts 9 seconds per player\n", [(1, "R305")]),
        ("timer clock lasts 9 seconds\nfouls: if foot left floor: foul x\n", [(1, "R407")]),
        ("timer x lasts 9 seconds\ntrack x per game\nif x: foul y\n", [(2, "R205")]),
        ("players per side 3\n", [(1, "R307")]),
        ("players per side 0\n", [(1, "R307")]),
        ("if winner is shooter: foul x\n", [(1, "R402")]),
        ("ending: if 8-ball pocketed: winner wins game\n", [(1, "R402")]),
    ],
)
def test_mistakes_of_moments(script, told):
    assert codes(script) == told


SIDES = """
players per side 2
track lives per match per side starting 3
track own per game per player starting 0
points:
    if 1-ball pocketed: award 2 to shooter
    if cue ball pocketed: deduct 1 from opponent
    if 2-ball pocketed:
        add 1 to lives of partner of shooter
        add 1 to own of partner of shooter
    if 3-ball pocketed:
        set lives of shooter to 7
        set lives of partner of shooter to 7
ending:
    if score of partner of shooter is at least 2: shooter wins game
"""


def test_a_side_has_one_score_and_one_value():
    told = play(SIDES, "1 pocketed foot-left; 2 pocketed foot-left", players=4, shooter=2)
    assert told.points == (0, 2, 0, 2)
    assert told.state == {"lives": (3, 4, 3, 4), "own": (0, 0, 0, 1)}
    assert told.endings[0].winner == 2
    assert play(SIDES, "cue pocketed foot-left", players=4, shooter=4).points == (-1, 0, -1, 0)


def test_two_writes_to_one_side_are_writes_to_one_value():
    assert play(SIDES, "3 pocketed foot-left", players=4).state["lives"] == (7, 3, 7, 3)


def test_without_sides_everybody_is_alone():
    script = SIDES.replace("players per side 2\n", "")
    told = play(script, "1 pocketed foot-left; 2 pocketed foot-left", players=3, shooter=2)
    assert told.points == (0, 2, 0)
    assert told.state == {"lives": (3, 4, 3), "own": (0, 1, 0)}


RACE = """
track racks per match per player
track begun per match
track handicap per match
phases break, open
at match start: set handicap to 5
at game start:
    add 1 to begun
    award handicap to opponent
    turn passes to loser
    go to phase open
ending:
    if 9-ball pocketed: shooter wins game
    if 8-ball pocketed: tie game
    if 7-ball pocketed: opponent wins match
at game end:
    add 1 to racks of winner
    award 10 to winner
    if racks of winner is at least 2: winner wins match
at match end: set handicap to 0
"""


def test_the_match_starts_once_and_each_game_starts():
    program = program_of(RACE)
    first = start(program, before(program))
    assert (first.state["handicap"], first.state["begun"]) == (5, 1)
    again = before(program, games=1, winner=1, state={**first.state, "handicap": 3})
    second = start(program, again)
    assert (second.state["handicap"], second.state["begun"]) == (3, 2)
    assert (second.points, second.next_player, second.phase) == ((0, 3), 2, "open")


def test_a_rule_that_needs_a_winner_is_silent_without_one():
    assert start(program_of(RACE), before(program_of(RACE))).next_player == 1


def test_a_game_is_counted_before_the_match_is_ended_by_the_count():
    state = {"racks": (0, 0), "begun": 1, "handicap": 5}
    told = play(RACE, "9 pocketed foot-left", state=state)
    assert [(one.unit, one.winner) for one in told.endings] == [("game", 1)]
    assert (told.state["racks"], told.points, told.state["handicap"]) == ((1, 0), (10, 0), 5)
    told = play(RACE, "9 pocketed foot-left", state={**state, "racks": (1, 1)})
    assert [(one.unit, one.winner) for one in told.endings] == [("game", 1), ("match", 1)]
    assert (told.state["racks"], told.state["handicap"]) == ((2, 1), 0)


def test_a_draw_has_no_winner_and_a_match_may_end_by_itself():
    state = {"racks": (0, 0), "begun": 1, "handicap": 5}
    drawn = play(RACE, "8 pocketed foot-left", state=state)
    assert (drawn.endings[0].winner, drawn.state["racks"]) == (0, (0, 0))
    over = play(RACE, "7 pocketed foot-left", state=state)
    assert [(one.unit, one.winner) for one in over.endings] == [("match", 2)]
    assert (over.state["racks"], over.state["handicap"]) == ((0, 1), 0)


HIDDEN = """
track secret per game per player
at game start:
    for each player: set secret of that player to lot of that player up to 15
ending:
    if 8-ball pocketed and secret of opponent is 8: opponent wins game
"""


def test_hidden_numbers_differ_and_come_from_the_seed_alone():
    program = program_of(HIDDEN)
    drawn = [start(program, before(program, players=4, seed=n)).state["secret"] for n in range(30)]
    assert all(len(set(one)) == 4 and set(one) <= set(range(1, 16)) for one in drawn)
    assert len(set(drawn)) > 25
    assert drawn[3] == start(program, before(program, players=4, seed=3)).state["secret"]


def test_a_hidden_number_may_decide():
    told = play(HIDDEN, "8 pocketed foot-left", state={"secret": (3, 8)})
    assert told.endings[0].winner == 2
    assert not play(HIDDEN, "8 pocketed foot-left", state={"secret": (8, 3)}).endings


def test_there_is_a_number_for_everybody():
    assert codes("if lot of shooter up to 3 is 2: foul x\n") == [(1, "R307")]


OVERRIDDEN = """
track given per game
track ended per game
at game start:
    rule "Five" [1]: set given to 5
    rule "Seven" [2] overrides "Five": set given to 7
before shot:
    rule "Pocket" [3]: require pocket from shooter
    rule "Ball" [4] overrides "Pocket": require ball from shooter
ending:
    if 9-ball pocketed: shooter wins game
at game end:
    rule "One" [5]: set ended to 1
    rule "Two" [6] overrides "One": set ended to 2
"""


def test_a_rule_overrides_at_every_moment():
    program = program_of(OVERRIDDEN)
    assert start(program, before(program)).state["given"] == 7
    assert [one.what for one in admit(program, before(program)).required] == ["ball"]
    assert play(OVERRIDDEN, "9 pocketed foot-left").state["ended"] == 2


def test_who_is_back_in_plays_at_his_place():
    script = (
        "ending:\n    for each player:\n"
        "        if that player is not shooter and 2-ball pocketed: reinstate that player\n"
        "next shot: give next player cue ball in hand in table\n"
    )
    out = {"players": 4, "eliminated": frozenset({2, 3})}
    passed_over = play(script, "1 pocketed foot-left", **out)
    assert (passed_over.next_player, passed_over.in_hand.player) == (4, 4)
    back = play(script, "2 pocketed foot-left", **out)
    assert (back.next_player, back.in_hand.player) == (2, 2)
