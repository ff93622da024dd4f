"""Closes the hole between what an editor believes of a variant file and what the loader says."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import jsonschema
import pytest
from click.testing import CliRunner

from engine.__main__ import main
from engine.authoring.schema import KINDS, schema_of
from engine.variant.library import PARTS

ROOT = Path(__file__).parents[2]
VARIANTS = ROOT / "variants"
FOLDERS = {"variant": VARIANTS, **{kind: VARIANTS / folder for kind, folder in PARTS.items()}}
SHIPPED = [(kind, path) for kind in KINDS for path in sorted(FOLDERS[kind].glob("*.toml"))]
CHECKS = {kind: jsonschema.Draft202012Validator(schema_of(kind)) for kind in KINDS}
BASE = 'extends = "nine_ball"\n'


def mistakes(kind: str, text: str) -> list[str]:
    return [one.json_path for one in CHECKS[kind].iter_errors(tomllib.loads(text))]


@pytest.mark.parametrize(("kind", "path"), SHIPPED, ids=lambda one: getattr(one, "stem", one))
def test_a_shipped_file_is_valid_and_names_its_schema(kind: str, path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    assert mistakes(kind, text) == []
    line = text.split("\n")[0]
    assert line.startswith("#:schema ")
    assert (path.parent / line.removeprefix("#:schema ")).resolve() == (
        VARIANTS / "schema" / f"{kind}.json"
    )


@pytest.mark.parametrize("kind", KINDS)
def test_the_committed_schema_is_the_one_made(kind: str) -> None:
    jsonschema.Draft202012Validator.check_schema(schema_of(kind))
    text = (VARIANTS / "schema" / f"{kind}.json").read_text(encoding="utf-8")
    assert json.loads(text) == schema_of(kind)
    printed = CliRunner().invoke(main, ["schema", kind]).output
    assert json.loads(printed) == schema_of(kind)


@pytest.mark.parametrize(
    "wrong",
    [
        'titel = "X"',
        "title = 5",
        'title = ""',
        "table = 5",
        'table = "../x"',
        'table.colour = "#ffffff"',
        'table.length = "100"',
        "table.length = true",
        'table.rubber.restitution = "0.9"',
        "table.rubber.restitution = 1.5",
        "table.spots.x = [1]",
        "table.spots.x = [1, 2, 3]",
        "table.spots.x = { dx = 1 }",
        'table.lines.x = { z = "1 m" }',
        "table.zones.x = { bed = false }",
        'balls.ball.cue.colour = "red"',
        'balls.ball.cue.pattern = "striped"',
        'balls.ball.cue.label = "too long a label"',
        'balls.mass = "6"',
        'cloth.rolling = "slow"',
        "players = 0",
        "players = { fewest = 2, some = 3 }",
        'cue_balls = "cue"',
        'rack.pattern.rows = "*"',
        "settings.x.default = 1.5",
        "settings.x = 5",
        "cue.end_mass_ratio = 0",
        "models.ball_ball = 5",
    ],
)
def test_a_mistake_is_not_valid(wrong: str) -> None:
    assert mistakes("variant", BASE) == []
    assert mistakes("variant", BASE + wrong + "\n")


def test_what_is_needed_is_asked_for_unless_the_file_extends_another() -> None:
    assert mistakes("variant", 'title = "X"\n')
    assert mistakes("variant", 'title = "X"\nextends = "nine_ball"\n') == []


@pytest.mark.parametrize(
    "right",
    [
        'table.length = "100 in"',
        'table.length = "2.84 m + 1 cm"',
        "table.length = 2.84",
        'table.spots.x = ["-L/4", 0]',
        'table.spots.x = { spot = "foot-spot", dx = "2 R" }',
        'rack.places.1 = "foot-spot"',
        'table.zones.x = { behind = "head-string" }',
        'table.zones.x = { behind = ["head-string"] }',
        "players = { fewest = 2, most = 4, usual = 2 }",
        'table = { use = "wpa-9ft", rail_width = "5 in" }',
        'balls.ball."1..9".value = "number"',
    ],
)
def test_what_people_write_is_valid(right: str) -> None:
    assert mistakes("variant", BASE + right + "\n") == []


def test_an_unknown_kind_is_refused() -> None:
    told = CliRunner().invoke(main, ["schema", "chair"])
    assert (told.exit_code, "variant" in told.output) == (2, True)
