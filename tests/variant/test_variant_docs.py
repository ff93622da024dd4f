"""Closes the hole between what the page on variant files says and what the program reads."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from engine.physics.world import MODEL_NAMES
from engine.variant.codes import CODES
from engine.variant.load import read_draft
from engine.variant.quantity import ANGLES, LENGTHS, MASSES
from engine.variant.spec import VariantSpec
from rulelang.diagnostics import render

PAGE = (Path(__file__).parents[2] / "docs" / "variants.md").read_text(encoding="utf-8")
EXAMPLES = re.findall(r"```toml (\w+)\n(.*?)```", PAGE, re.DOTALL)
PARTS = {"table": ("tables", "wpa-9ft"), "balls": ("balls", "pool"), "cloth": ("cloths", None)}
PARTS |= {"pins": ("pins", None)}
BASE = {
    "title": '"Example"',
    "rulebook": '"House rules"',
    "players": "2",
    "cue_balls": '["cue"]',
    "table": '"wpa-9ft"',
    "balls": '"pool"',
    "cloth": '"worsted-pool"',
    "cue": "{ mass = 0.54, tip_restitution = 0.7, tip_friction = 0.6, end_mass_ratio = 25 }",
}


def base_without(keys):
    return "".join(f"{key} = {value}\n" for key, value in BASE.items() if key not in keys)


@pytest.mark.parametrize(("kind", "text"), EXAMPLES, ids=lambda one: str(one)[:20])
def test_every_example_is_read_without_a_mistake(tmp_path, kind, text):
    if kind == "variant":
        whole = text
    elif kind == "extra":
        keys = re.findall(r"^(\w+)", ("\n" + text).partition("\n[")[0], re.MULTILINE)
        whole = base_without(keys) + text
    else:
        folder, use = PARTS[kind]
        (tmp_path / folder).mkdir()
        head = f'use = "{use}"\n' if use else ""
        (tmp_path / folder / "example.toml").write_text(head + text, encoding="utf-8")
        whole = base_without([kind]) + f'{kind} = "example"\n'
    path = tmp_path / "example.toml"
    path.write_text(whole, encoding="utf-8")
    draft, diagnostics = read_draft(path)
    assert not diagnostics, "\n".join(render(one) for one in diagnostics)
    assert draft is not None


def test_the_page_has_an_example_of_every_kind():
    assert {kind for kind, _ in EXAMPLES} == {"variant", "extra", "table", "balls", "pins", "cloth"}


def test_the_page_lists_every_code_with_its_meaning():
    listed = dict(re.findall(r"^\| (V\d+) \| (.*) \|$", PAGE, re.MULTILINE))
    assert listed == dict(CODES)


def test_the_page_speaks_of_every_key_unit_and_model():
    for key in [*VariantSpec.model_fields, "extends"]:
        assert f"`{key}`" in PAGE, key
    for unit in [*LENGTHS, *MASSES, *ANGLES]:
        assert f"`{unit}`" in PAGE, unit
    (models,) = [text for kind, text in EXAMPLES if kind == "extra" and "[models]" in text]
    for field, names in MODEL_NAMES.items():
        for name in names:
            assert re.search(rf"^{field} = .*{name}", models, re.MULTILINE), name


def test_the_models_that_can_be_named_are_those_that_exist():
    from engine.physics import pack, simulate

    assert set(MODEL_NAMES["solver"]) == set(simulate.SOLVERS)
    assert set(MODEL_NAMES["motion"]) == set(pack.MOTIONS)
    assert set(MODEL_NAMES["ball_ball"]) == set(pack.BALL_BALLS)
    assert set(MODEL_NAMES["ball_cushion"]) == set(pack.CUSHIONS)
    assert set(MODEL_NAMES["strike"]) == set(pack.STRIKES)
    assert set(MODEL_NAMES["pocket"]) == set(pack.POCKETS)
