"""The second player begins a game with his own ball; the opponent's stands where his would."""

import pytest

from engine.game.match import start_game, start_match
from engine.variant.load import load_variant

_STARTS = [("five_pins", "foot-mark"), ("goriziana", "foot-mark")] + [
    (name, "head-spot")
    for name in (
        "three_cushion",
        "one_cushion",
        "straight_rail",
        "balkline_47_1",
        "balkline_47_2",
        "balkline_71_2",
    )
]


@pytest.mark.parametrize(("name", "mark"), _STARTS)
@pytest.mark.parametrize(
    ("breaker", "own", "other"), [(1, "white", "yellow"), (2, "yellow", "white")]
)
def test_the_opponents_ball_stands_on_its_mark(
    name: str, mark: str, breaker: int, own: str, other: str
) -> None:
    variant = load_variant(name)
    settings = start_match(variant).settings
    begun = start_game(variant, 2, settings, breaker=breaker)
    assert begun.on_table == {"white", "yellow", "red"}
    assert begun.shooter == breaker
    assert begun.in_hand is not None
    assert own not in begun.rest.positions
    assert begun.rest.positions[other] == pytest.approx(variant.world.table.spots[mark])


@pytest.mark.parametrize(
    ("breaker", "own", "other"), [(1, "white-1", "white-2"), (2, "white-2", "white-1")]
)
def test_so_it_does_among_five_balls(breaker: int, own: str, other: str) -> None:
    variant = load_variant("kaisa")
    begun = start_game(variant, 2, start_match(variant).settings, breaker=breaker)
    assert len(begun.on_table) == 5
    assert own not in begun.rest.positions
    assert begun.rest.positions[other] == pytest.approx(variant.world.table.spots["head-spot"])
