"""Closes the hole between a ball drawn at a cushion and a ball frozen to it."""

from functools import cache
from pathlib import Path

import pytest

from engine.game.contacts import contacts_of
from engine.records.read import read_record_text
from engine.records.record import RecordError
from engine.table.region import nose_reach
from engine.variant.load import load_variant

load = cache(load_variant)
GAMES = ("nine_ball", "snooker")
STROKE = "strike = { speed = 1.0, heading = 0.0 }\n"


def sizes(game):
    world = load(game).world
    return world.table, world.balls[0].radius


def read(game, y, *, frozen="[]", played=False):
    ball = "9" if game == "nine_ball" else "red-1"
    positions = f"{ball} = [0.3, {y}]\ncue = [0.0, 0.1]\n".replace("cue", load(game).cue_balls[0])
    text = f"""format = 1
variant = "{game}"
title = "a ball at the left cushion"
[before]
frozen = {frozen}
[before.positions]
{positions}
[[shot]]
{STROKE if played else ""}events = []
[shot.after]
frozen = {frozen}
[shot.after.positions]
{positions}
[shot.expect]
"""
    record = read_record_text(text, Path("drawn.toml"), load)
    world = record.variant.world
    touching = [contacts_of(world, r) for r in (record.start.rest, record.steps[0].shot.after)]
    assert set(touching[0]) == set(touching[1])
    return {other for one, other in touching[0] if one == ball}


@pytest.mark.parametrize("game", GAMES)
@pytest.mark.parametrize("played", [False, True])
def test_a_ball_is_frozen_where_it_is_drawn_or_where_it_is_measured(game, played):
    table, radius = sizes(game)
    edge, reach = table.width / 2.0, nose_reach(radius, table.nose_height)
    assert read(game, edge - reach - 1e-5, played=played)
    assert bool(read(game, edge - radius, played=played)) is not played
    assert bool(read(game, round(edge - radius - 5e-5, 5), played=played)) is not played
    assert not read(game, edge - radius - 2e-4, played=played)


@pytest.mark.parametrize("game", GAMES)
def test_a_contact_told_agrees_with_a_ball_drawn_at_the_nose(game):
    table, radius = sizes(game)
    name = next(c.id for c in table.cushions if c.id.startswith("left"))
    name = "left-foot" if "left-foot" in {c.id for c in table.cushions} else name
    ball = "9" if game == "nine_ball" else "red-1"
    told = f'["{ball} to cushion {name}"]'
    assert read(game, table.width / 2.0 - radius, frozen=told) == {f"cushion {name}"}
    with pytest.raises(RecordError, match="are 2 mm apart"):
        read(game, table.width / 2.0 - radius - 2e-3, frozen=told)
