"""Closes the hole between an outline in a file and a table on which shots are sound."""

from __future__ import annotations

from dataclasses import replace
from math import atan2, hypot, pi
from pathlib import Path

import numpy as np
import pytest

from engine.game.match import start_match
from engine.game.observe import play
from engine.game.placing import refuse_place, usual_place
from engine.game.shot import Shot
from engine.physics.monitor import examine
from engine.physics.simulate import simulate
from engine.physics.world import Strike
from engine.table.furniture import BallId, ZoneId
from engine.table.region import has_room, is_hole, on_bed, posts_of
from engine.variant.load import load_variant, read_draft
from engine.variant.words import vocabulary_of
from rulelang import events as told
from rulelang.diagnostics import render

TABLES = Path(__file__).parent / "tables"
FILES = sorted(TABLES.glob("*.toml"))
CUE = BallId("cue")
SHOTS = 12


def draft_of(name):
    draft, diagnostics = read_draft(TABLES / f"{name}.toml")
    assert not diagnostics, "\n".join(render(one) for one in diagnostics)
    return draft


def random_shot(world, dice):
    """Return a layout of some balls, clear of each other and of all that stands, and a strike."""
    table, layout = world.table, {}
    balls = world.balls[: dice.integers(1, len(world.balls) + 1)]
    while len(layout) < len(balls):
        ball = balls[len(layout)]
        at = dice.uniform(-0.5, 0.5) * table.length, dice.uniform(-0.5, 0.5) * table.width
        clear = all(hypot(at[0] - x, at[1] - y) > 2.01 * ball.radius for x, y in layout.values())
        if clear and has_room(table, at, ball.radius):
            layout[ball.id] = at
    side, follow = dice.uniform(-0.3, 0.3, 2)
    return layout, Strike(dice.uniform(0.2, 8.0), dice.uniform(0.0, 6.28), 0.0, side, follow)


def check_shot(world, seed):
    layout, strike = random_shot(world, np.random.default_rng(seed))
    trace = simulate(world, layout, CUE, strike)
    assert not examine(trace, world.table).faults(), (seed, layout, strike)
    assert len(trace.final) + len(trace.pocketed) == len(layout)
    assert all(
        on_bed(world.table, at, 1e-9) or in_a_mouth(world, at) for at in trace.final.values()
    )
    assert len(trace.log) < 20_000
    return trace


def in_a_mouth(world, at):
    return any(
        hypot(at[0] - p.centre[0], at[1] - p.centre[1]) < 0.2
        for p in world.table.pockets
        if not is_hole(p)
    )


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_random_shots_lose_no_ball_and_invent_no_energy(path):
    world = draft_of(path.stem).world
    for seed in range(SHOTS):
        check_shot(world, seed)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_every_cushion_and_pocket_can_be_met(path):
    world = replace(draft_of(path.stem).world, balls=draft_of(path.stem).world.balls[:1])
    met, dropped = set(), set()
    for seed in range(220):
        dice = np.random.default_rng(seed)
        layout, strike = random_shot(world, dice)
        target = (
            world.table.pockets[seed % len(world.table.pockets)] if world.table.pockets else None
        )
        if target is not None and seed % 2:
            x, y = layout[CUE]
            (ax, ay), (bx, by) = target.mouth
            heading = atan2((ay + by) / 2 - y, (ax + bx) / 2 - x)
            strike = Strike(2.5, heading)
        trace = simulate(world, layout, CUE, strike)
        dropped |= set(trace.pocketed.values())
        met |= {event.cushion for event in trace.events() if hasattr(event, "cushion")}
    assert met == {cushion.id for cushion in world.table.cushions}
    assert dropped == {pocket.id for pocket in world.table.pockets}


def test_a_ball_comes_straight_back_from_a_post():
    world = draft_of("posts").world
    trace = simulate(world, {CUE: (-0.4, 0.0)}, CUE, Strike(1.5, 0.0))
    hit = next(event for event in trace.events() if hasattr(event, "cushion"))
    assert hit.cushion == "centre-post"
    x, y, _ = trace.positions([hit.time])[0, 0]
    reach = world.balls[0].radius ** 2 - (world.table.nose_height - world.balls[0].radius) ** 2
    assert hypot(x, y) == pytest.approx(0.035 + reach**0.5, abs=1e-9)
    assert abs(trace.positions([hit.time + 0.2])[0, 0, 1]) < 1e-9
    assert trace.positions([hit.time + 0.2])[0, 0, 0] < x


def test_a_ball_drops_where_its_centre_comes_over_a_hole():
    world = draft_of("posts").world
    trace = simulate(world, {CUE: (0.4, 0.3)}, CUE, Strike(1.0, atan2(-0.3, 0.4)))
    assert trace.pocketed == {CUE: "foot-hole"}


def test_a_ball_that_runs_along_a_round_cushion_hits_it_once():
    world = draft_of("rounded").world
    start = (0.5, -0.6 + 0.0276)
    trace = simulate(world, {CUE: start}, CUE, Strike(2.0, 0.02))
    hits = [event for event in trace.events() if getattr(event, "cushion", "") == "foot"]
    assert 1 <= len(hits) < 25
    assert len(trace.log) < 3000


def test_a_post_has_its_own_rubber_and_an_upright_one_is_met_at_the_middle_of_the_ball():
    world = replace(draft_of("posts").world)
    world = replace(world, models=replace(world.models, ball_cushion="restitution"))
    gone = {}
    for post in posts_of(world.table):
        x, y = post.centre
        trace = simulate(world, {CUE: (x - 0.15, y)}, CUE, Strike(1.0, 0.0))
        hit = next(one for one in trace.events() if getattr(one, "cushion", "") == post.id)
        place = trace.positions([hit.time])[0, 0]
        came, went = trace.velocities([hit.time - 1e-9, hit.time + 1e-9])[:, 0, 0]
        gone[post.id] = -went / came, x - place[0] - post.radius
    radius = world.balls[0].radius
    ring = (radius**2 - (world.table.nose_height - radius) ** 2) ** 0.5
    assert gone["left-post"] == pytest.approx((0.9, ring), abs=1e-6)
    assert gone["centre-post"] == pytest.approx((0.9, ring), abs=1e-6)
    assert gone["right-post"] == pytest.approx((0.5, radius), abs=1e-6)


def test_scripts_and_records_know_posts_and_holes():
    words = vocabulary_of(draft_of("posts"))
    assert {"left-post", "right-post", "centre-post", "head"} <= set(words.cushions)
    assert set(words.pockets) == {"head-hole", "foot-hole"}


@pytest.fixture
def match(tmp_path):
    text = (TABLES / "posts.toml").read_text(encoding="utf-8")
    (tmp_path / "posts.toml").write_text(text, encoding="utf-8")
    (tmp_path / "plain.rules").write_text(RULES, encoding="utf-8")
    return start_match(load_variant(tmp_path / "posts.toml"), seed=1)


RULES = """language 1
game "Bumpers" cites "House rules"
"""


def test_the_referee_sees_a_post_as_a_cushion(match):
    situation = match.situation
    at = dict(situation.rest.positions)
    at[CUE] = (-0.4, 0.0)
    situation = replace(situation, rest=replace(situation.rest, positions=at), in_hand=None)
    shot = play(match.variant, situation, Shot(strike=Strike(1.0, 0.0)))
    assert any(
        isinstance(event, told.CushionHit) and event.cushion == "centre-post"
        for event in shot.events
    )


def test_a_ball_in_hand_keeps_clear_of_posts_and_holes(match):
    situation = replace(match.situation, in_hand=ZoneId("start"))
    lifted = {b: p for b, p in situation.rest.positions.items() if b != CUE}
    situation = replace(situation, rest=replace(situation.rest, positions=lifted))
    place = usual_place(match.variant, situation)
    assert place is not None
    table = match.variant.world.table
    assert has_room(table, place, match.variant.world.balls[0].radius)
    hole = next(p for p in table.pockets if p.id == "head-hole")
    assert refuse_place(match.variant, situation, hole.centre) is not None
    assert refuse_place(match.variant, situation, (-0.6, 0.3)) is None


def test_lines_of_an_outline_run_from_cushion_to_cushion():
    table = draft_of("ellipse").world.table
    line = table.lines["middle"]
    assert line.start == pytest.approx((0.0, -0.8), abs=1e-3)
    assert line.end == pytest.approx((0.0, 0.8), abs=1e-3)
    assert draft_of("ell").world.table.lines["arm-line"].end[0] == pytest.approx(1.4)


def test_a_shot_through_one_focus_of_an_ellipse_comes_near_the_other():
    world = replace(draft_of("ellipse").world, balls=draft_of("ellipse").world.balls[:1])
    focus = 1.0874
    for heading in (pi / 3, pi / 2, 2.0, -1.3):
        trace = simulate(world, {CUE: (-focus, 0.0)}, CUE, Strike(3.0, heading))
        hit = next(event for event in trace.events() if hasattr(event, "cushion"))
        times = np.linspace(hit.time, hit.time + 2.0, 4000)
        places = trace.positions(times)[:, 0, :2]
        assert np.hypot(places[:, 0] - focus, places[:, 1]).min() < 0.2


def test_posts_are_told_from_other_cushions():
    assert {post.id for post in posts_of(draft_of("posts").world.table)} == {
        "left-post",
        "right-post",
        "centre-post",
    }
    assert posts_of(draft_of("rounded").world.table) == ()
