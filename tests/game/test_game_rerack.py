"""Closes the hole between balls that stay on the table and the rack that is laid beside them."""

from dataclasses import replace

import pytest

from engine.game.match import start_match
from engine.game.spotting import Board, carry_out
from engine.variant.load import load_variant
from rulelang.decisions import Place, Rerack, Spot

RACK = load_variant("straight_pool")


def racked(keeping, seed=1, actions=()):
    start = replace(start_match(RACK, seed=seed).situation, in_hand=None)
    rest = replace(start.rest, positions={ball: (-0.9, 0.1 * i) for i, ball in enumerate(keeping)})
    board = Board(rest, frozenset(keeping))
    return carry_out(RACK, board, (*actions, Rerack(tuple(keeping))), {}, start)


@pytest.mark.parametrize("seed", range(8))
def test_a_ball_that_stays_leaves_the_place_nearest_to_the_head_empty(seed):
    whole, board = racked(("cue",), seed), racked(("cue", "15"), seed)
    apex = RACK.world.table.spots["foot-spot"]
    places = {at for ball, at in whole.rest.positions.items() if ball != "cue"}
    beside = {at for ball, at in board.rest.positions.items() if ball not in ("cue", "15")}
    assert (whole.reracked, board.reracked) == (15, 14)
    assert places - beside == {apex}
    assert board.rest.positions["15"] == (-0.9, 0.1)


def test_what_was_put_aside_stays_told_and_what_is_racked_does_not():
    aside = Spot("15", (Place("at", "head-spot"),))
    board = racked(("cue", "15"), actions=(aside, Spot("3", (Place("at", "foot-spot"),))))
    assert [one.ball for one in board.spotted] == ["15"]
    assert board.rest.positions["15"] == RACK.world.table.spots["head-spot"]
