"""Every physical model can be chosen in a variant file, with its figures, and a shot be played."""

from dataclasses import fields

import pytest

from engine.physics.monitor import examine
from engine.physics.simulate import simulate
from engine.physics.world import MODEL_NAMES, Models, Strike
from engine.variant.load import read_draft

HEAD = """\
title = "Model"
rulebook = "none"
table = "wpa-9ft"
balls = "pool-9"
cloth = "worsted-pool"
players = 1
cue_balls = ["cue"]

[cue]
mass = "540 g"
tip_restitution = 0.73
tip_friction = 0.6
end_mass_ratio = 25.0
"""
CASES = [(field, name) for field, names in MODEL_NAMES.items() for name in names]
LAYOUT = {
    "cue": (-0.6, 0.0),
    "1": (0.3, 0.01),
    "2": (0.36, 0.045),
    "3": (0.36, -0.02),
    "4": (1.0, 0.45),
}


def read(tmp_path, text):
    """What a file with these tables says: its draft and the mistakes in it."""
    head = HEAD
    for part in ("table", "balls"):
        if f"[{part}" in text:
            line = next(one for one in HEAD.splitlines() if one.startswith(f"{part} = "))
            head = head.replace(f"{line}\n", "")
            text = f"[{part}]\nuse = {line.partition(' = ')[2]}\n{text}"
    path = tmp_path / "model.toml"
    path.write_text(head + text, encoding="utf-8")
    return read_draft(path)


def load_world(tmp_path, text):
    draft, mistakes = read(tmp_path, text)
    assert not mistakes
    return draft.world


@pytest.mark.parametrize(("field", "name"), CASES)
def test_a_model_is_named_and_played(tmp_path, field, name):
    world = load_world(tmp_path, f'[models]\n{field} = "{name}"\n')
    assert getattr(world.models, field) == name
    trace = simulate(world, LAYOUT, "cue", Strike(4.0, 0.0, side=0.2, follow=0.1))
    assert trace.duration > 1.0
    if world.models.solver == "stepwise":
        assert examine(trace, world).faults() == ()


RARE = [
    ("ball_ball", "mathavan-2014"),
    ("ball_cushion", "stronge"),
    ("cluster", "simultaneous"),
    ("cluster", "sequential"),
    ("pocket", "rim-lip"),
]


@pytest.mark.parametrize(("field", "name"), RARE)
def test_a_rare_model_changes_the_shot(tmp_path, field, name):
    touching = {**LAYOUT, "2": (0.35715, 0.01), "3": (0.1, 0.5)}
    layout = touching if field == "cluster" else LAYOUT
    if field == "pocket":
        layout = {"cue": (0.9, 0.265)}
    strike = Strike(3.0, 0.785398 if field == "pocket" else 0.0, follow=0.2)
    usual = simulate(load_world(tmp_path, ""), layout, "cue", strike)
    other = simulate(load_world(tmp_path, f'[models]\n{field} = "{name}"\n'), layout, "cue", strike)
    assert other.hash() != usual.hash()


@pytest.mark.parametrize("field", [field.name for field in fields(Models)])
def test_a_wrong_name_is_told_with_a_mend(tmp_path, field):
    right = MODEL_NAMES[field][-1]
    _, (one,) = read(tmp_path, f'[models]\n{field} = "{right[:-1]}"\n')
    assert one.code == "V106"
    assert right in one.mend


def test_a_wrong_model_of_one_pocket_is_told(tmp_path):
    _, (one,) = read(tmp_path, '[table.pockets.side]\nmodel = "rim-lips"\n')
    assert one.code == "V106"
    assert "rim-lip" in one.mend


FIGURES = """
[table.rubber]
restitution_slope = -0.257
restitution_bend = 0.044
restitution_least = 0.3
friction_slope = 0.241
frequency_ratio = 1.5

[table.pockets.corner]
lip = "3 mm"
rim = "30 mm"
restitution = 0.4
friction = 0.3
model = "rim-lip"

[balls.contact]
restitution_slope = 0.01
restitution_knee = 0.5
friction_rise = 0.0
cluster_gap = "0.01 mm"
"""


def test_figures_of_the_models_reach_the_world(tmp_path):
    world = load_world(tmp_path, FIGURES)
    rubber, contact = world.rubber, world.contact
    assert (rubber.restitution_slope, rubber.restitution_bend) == (-0.257, 0.044)
    assert (rubber.restitution_least, rubber.friction_slope) == (0.3, 0.241)
    assert rubber.frequency_ratio == 1.5
    assert (contact.restitution_slope, contact.restitution_knee) == (0.01, 0.5)
    assert (contact.friction_rise, contact.cluster_gap) == (0.0, pytest.approx(1e-5))
    corner, side = (
        next(one for one in world.table.pockets if one.id == name)
        for name in ("foot-left", "side-left")
    )
    assert (corner.lip, corner.rim, corner.model) == (0.003, 0.03, "rim-lip")
    assert (corner.restitution, corner.friction) == (0.4, 0.3)
    assert (side.lip, side.model) == (0.0, None)
    assert side.rim > world.table.nose_height
