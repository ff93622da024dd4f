"""Closes the hole between the cloth's shade and numbers and where they belong."""

from pathlib import Path

import numpy as np
import pytest
from stands import TABLES

from engine.stage import plan
from engine.stage.shade import POST_REACH, SHADE_REACH, build_shade, shade_posts
from engine.stage.values import DIGITS, build_values
from engine.table.region import has_room, is_hole, posts_of
from engine.variant.load import list_variants, load_variant, read_draft

OUTLINES = Path(__file__).parents[1] / "variant" / "tables"


@pytest.mark.parametrize("table", ["pockets", "round jaws"])
def test_the_shade_follows_the_jaws_and_narrows_to_nothing(table):
    """A strip that broke off at the end of a nose would show as a step."""
    furniture = TABLES[table]()
    reach = SHADE_REACH[-1]
    places = build_shade(furniture)[-1].positions[:, :2].astype(float)
    for jaw in furniture.jaws:
        tips = plan.trace_shapes(jaw.shapes, 0.2)
        ends = [min(np.hypot(*(places - tip).T)) for tip in (tips[0], tips[-1])]
        assert min(ends) < 1e-5
    x, y = furniture.length / 2.0, furniture.width / 2.0
    inside = np.minimum(x - np.abs(places[:, 0]), y - np.abs(places[:, 1]))
    assert inside.max() == pytest.approx(reach, abs=1e-3)


def test_posts_stand_in_soft_dark_and_have_no_strips():
    draft, _ = read_draft(OUTLINES / "posts.toml")
    table = draft.world.table
    discs, posts = shade_posts(table), posts_of(table)
    assert len(discs) == len(posts) > 0
    for disc, post in zip(discs, posts, strict=True):
        assert disc.centre[:2] == post.centre
        assert disc.radius == pytest.approx(post.radius + POST_REACH)
    for sheet in build_shade(table):
        for post in posts:
            away = np.hypot(*(sheet.positions[:, :2].astype(float) - post.centre).T)
            assert away.min() > post.radius + 0.01


def test_every_digit_is_drawn_within_its_box():
    assert len(DIGITS) == 10
    for lines in DIGITS:
        ups = [up for line in lines for _, up in line]
        rights = [right for line in lines for right, _ in line]
        assert (min(ups), max(ups)) == (0, 1)
        assert min(rights) >= 0
        assert max(rights) <= 0.55
    assert len(set(DIGITS)) == 10


def test_holes_that_count_say_so_on_the_bed_beyond_their_rims():
    counted = 0
    for entry in list_variants():
        table = load_variant(entry.name).world.table
        holes = [p for p in table.pockets if is_hole(p) and p.value]
        digits = sum(len(DIGITS[int(d)]) for hole in holes for d in str(hole.value))
        lines = build_values(table, (255, 255, 255))
        assert len(lines) == digits
        for line in lines:
            for x, y in line.points[:, :2].astype(float):
                assert has_room(table, (x, y), 0.0)
                assert all(np.hypot(x - h.centre[0], y - h.centre[1]) > h.radius for h in holes)
        counted += len(holes)
    assert counted >= 9


def test_a_number_is_upright_and_in_order_seen_from_the_head():
    """Seen from -x, up is +x and right is -y: the first digit lies further to +y."""
    table = next(
        one
        for one in (load_variant(entry.name).world.table for entry in list_variants())
        if any(is_hole(p) and p.value == 10 for p in one.pockets)
    )
    hole = next(p for p in table.pockets if p.value == 10)
    near = [
        line.points
        for line in build_values(table, (255, 255, 255))
        if abs(line.points[:, 1].mean() - hole.centre[1]) < 0.02
        and line.points[0, 0] > hole.centre[0]
        and line.points[0, 0] < hole.centre[0] + 0.08
    ]
    one, nought = near
    assert len(one) < len(nought)
    assert one[:, 1].mean() > nought[:, 1].mean()
    assert one[-1, 0] < one[1, 0]


def test_a_player_sees_how_carom_balls_spin():
    variant = load_variant("three_cushion")
    assert {kind.pattern for kind in variant.balls} == {"dots"}
