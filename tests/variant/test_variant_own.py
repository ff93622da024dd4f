"""What a variant file says of one ball, one cushion, one pocket."""

import pytest

from engine.variant.load import read_draft

HEAD = """
title = "Example"
rulebook = "House rules"
players = 2
cue_balls = ["cue"]
cloth = "worsted-pool"
cue = { mass = 0.54, tip_restitution = 0.7, tip_friction = 0.6, end_mass_ratio = 25 }
table.use = "wpa-9ft"
balls.use = "pool"
"""


def read(tmp_path, text):
    path = tmp_path / "example.toml"
    path.write_text(HEAD + text, encoding="utf-8")
    return read_draft(path)


def test_one_ball_is_heavier_larger_and_slower(tmp_path):
    draft, found = read(
        tmp_path,
        """
balls.ball.cue.diameter = "60.3 mm"
balls.ball.cue.mass = "200 g"
balls.ball.cue.rolling = 0.02
balls.ball.cue.restitution = 0.9
balls.ball.cue.grip = 1.5
""",
    )
    assert not found
    cue, one = draft.world.balls[0], draft.world.balls[1]
    assert (cue.radius, cue.mass) == (pytest.approx(0.03015), 0.2)
    assert (cue.rolling, cue.restitution, cue.grip, cue.sliding) == (0.02, 0.9, 1.5, None)
    assert (one.rolling, one.restitution, one.grip) == (None, None, 1.0)


def test_one_cushion_is_dead_and_one_pocket_has_other_jaws(tmp_path):
    draft, found = read(
        tmp_path,
        """
[table.cushions.foot]
restitution = 0.4
model = "restitution"
[table.cushions.head-left]
friction = 0.3
""",
    )
    assert not found
    table, usual = draft.world.table, draft.world.rubber
    covered = {one.id: one for one in table.cushions if one.rubber}
    assert list(covered) == ["foot"]
    assert covered["foot"].rubber.restitution == 0.4
    assert covered["foot"].rubber.friction == usual.friction
    assert covered["foot"].model == "restitution"
    jaws = {one.id: one.rubber for one in table.pockets if one.rubber}
    assert list(jaws) == ["head-left"]
    assert (jaws["head-left"].friction, jaws["head-left"].restitution) == (0.3, usual.restitution)


def test_unknown_cushions_and_models_are_told(tmp_path):
    _, found = read(
        tmp_path,
        """
[table.cushions.fot]
restitution = 0.4
[table.cushions.foot]
model = "rubbery"
""",
    )
    assert sorted(one.code for one in found) == ["V106", "V302"]
    assert any("foot" in one.mend for one in found)


def test_one_pocket_is_tighter_than_the_others(tmp_path):
    path = tmp_path / "tight.toml"
    cut = 'cut = "142 deg"\nshelf = "4 cm"\njaw_radius = "6 mm"\nradius = "62 mm"\n'
    corners = "".join(
        f'{{ at = ["{x}", "{y}"], cushion = "{c}", pocket = "{p}", cut = "{kind}" }},\n'
        for x, y, c, p, kind in (
            ("-1.27 m", "-0.635 m", "right", "head-right", "wide"),
            ("1.27 m", "-0.635 m", "foot", "foot-right", "wide"),
            ("1.27 m", "0.635 m", "left", "foot-left", "tight"),
            ("-1.27 m", "0.635 m", "head", "head-left", "wide"),
        )
    )
    path.write_text(
        HEAD.replace('table.use = "wpa-9ft"\n', "")
        + "[table]\n"
        + 'nose_height = "36.29 mm"\nrail_width = "5 in"\n'
        + "rubber = { restitution = 0.9, friction = 0.14 }\n"
        + 'spots = { head-spot = ["-L/4", 0], foot-spot = ["L/4", 0] }\n'
        + f"[table.outline]\ncorners = [\n{corners}]\n"
        + f'[table.outline.cuts.wide]\nmouth = "116 mm"\n{cut}'
        + f'[table.outline.cuts.tight]\nmouth = "104 mm"\n{cut}',
        encoding="utf-8",
    )
    draft, found = read_draft(path)
    assert not found, found
    widths = {}
    for pocket in draft.world.table.pockets:
        (x, y), (u, v) = pocket.mouth
        widths[pocket.id] = ((x - u) ** 2 + (y - v) ** 2) ** 0.5
    assert widths.pop("foot-left") == pytest.approx(0.104, abs=1e-6)
    assert list(widths.values()) == pytest.approx([0.116] * 3, abs=1e-6)
