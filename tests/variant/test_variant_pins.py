"""Closes the hole between sets of pins in files and pins that stand on a table."""

from __future__ import annotations

from math import hypot
from pathlib import Path

import pytest

from engine.physics.simulate import simulate
from engine.physics.world import Strike
from engine.table.pin import meeting, solid_of
from engine.table.region import has_room
from engine.variant.load import read_draft
from engine.variant.words import vocabulary_of
from rulelang.diagnostics import render

SETS = sorted((Path(__file__).parents[2] / "variants" / "pins").glob("*.toml"))
GAMES = {"bar-pegs": "bar_billiards", "bar-mushrooms": "bar_billiards"}


def draft_with(name, tmp_path):
    game = GAMES.get(name, "danish_pins" if name == "danish-pins" else "five_pins")
    path = tmp_path / "game.toml"
    path.write_text(f'extends = "{game}"\npins = "{name}"\n', encoding="utf-8")
    draft, mistakes = read_draft(path)
    assert not mistakes, "\n".join(render(one) for one in mistakes)
    return draft


@pytest.mark.parametrize("path", SETS, ids=lambda path: path.stem)
def test_every_shipped_set_stands_and_each_of_its_pins_can_be_felled(path, tmp_path):
    draft = draft_with(path.stem, tmp_path)
    world = draft.world
    pins = world.table.pins
    assert pins
    assert {kind.id for kind in draft.pins} == {pin.id for pin in pins}
    assert vocabulary_of(draft).pins == tuple(pin.id for pin in pins)
    ball = world.balls[0]
    for pin in pins:
        assert not has_room(world.table, pin.at, ball.radius)
        assert 0.0 < solid_of(pin.profile).centre < pin.height
        start = (pin.at[0] - meeting(pin.profile, ball.radius)[0] - 0.002, pin.at[1])
        others = [one for one in pins if hypot(one.at[0] - start[0], one.at[1] - start[1]) < 0.03]
        trace = simulate(
            world, {ball.id: start}, ball.id, Strike(1.5, 0.0), fallen=[one.id for one in others]
        )
        assert pin.id in trace.pins.names
        felled = {one.pin for one in trace.events() if type(one).__name__ == "PinToppled"}
        assert pin.id in felled


def test_a_ball_passes_between_the_pins_of_a_cross_as_narrowly_as_the_sheets_say(tmp_path):
    """Just wide enough for a ball; 62 mm clear at the body of tall ones (DDBU)."""
    for name, clear in (("five-pins", None), ("danish-pins", 0.062)):
        world = draft_with(name, tmp_path).world
        one, other = world.table.pins[0], world.table.pins[1]
        apart = hypot(one.at[0] - other.at[0], one.at[1] - other.at[1])
        spare = apart - 2.0 * meeting(one.profile, world.balls[0].radius)[0]
        assert 0.0 < spare < 0.005
        if clear is not None:
            assert apart - one.belly - other.belly == pytest.approx(clear)


def test_a_pin_says_what_differs_from_its_set(tmp_path):
    path = tmp_path / "game.toml"
    path.write_text(
        'extends = "five_pins"\n'
        'pins.use = "five-pins"\n'
        "[pins.pin.centre-pin]\n"
        'height = "30 mm"\nmass = "3 g"\ntopples_at = 0.001\ncolour = "#102030"\n',
        encoding="utf-8",
    )
    draft, mistakes = read_draft(path)
    assert not mistakes, "\n".join(render(one) for one in mistakes)
    centre, other = draft.world.table.pins[:2]
    assert (centre.height, centre.mass, centre.threshold) == pytest.approx((0.03, 0.003, 0.001))
    assert centre.foot == other.foot
    assert (other.height, other.threshold) == (pytest.approx(0.025), None)
    assert draft.pins[0].colour == (16, 32, 48)
