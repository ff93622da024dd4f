"""Closes the hole between the files of a game and its script: found, loaded, checked together."""

from __future__ import annotations

import pytest

from engine.variant.library import VariantError
from engine.variant.load import check_variant, list_variants, load_variant
from rulelang.diagnostics import render

SHIPPED = [one.name for one in list_variants()]
BASE = """\
title = "Test game"
rulebook = "House rules"
players = 2
cue_balls = ["cue"]
table = "wpa-9ft"
balls = "pool"
cloth = "worsted-pool"
cue = { mass = "540 g", tip_restitution = 0.73, tip_friction = 0.6, end_mass_ratio = 25 }
"""
ONE_LINE = "if cue ball pocketed: respot cue\n"


def write(folder, name, text):
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize("name", SHIPPED)
def test_a_shipped_variant_loads_and_checks_clean(name):
    assert [render(one) for one in check_variant(name)] == []
    variant = load_variant(name)
    assert variant.name == name
    assert variant.script_path.is_file()
    assert variant.program.title == variant.title


@pytest.mark.parametrize("name", SHIPPED)
def test_a_variant_is_the_same_by_name_and_by_path(name):
    by_name = load_variant(name)
    by_path = load_variant(by_name.path)
    assert by_name.world == by_path.world
    assert by_name.rack == by_path.rack


def test_the_one_line_script_makes_a_whole_game(tmp_path):
    path = write(tmp_path, "mine.toml", BASE)
    write(tmp_path, "mine.rules", ONE_LINE)
    assert [render(one) for one in check_variant(path)] == []
    assert load_variant(path).script_path == tmp_path / "mine.rules"


def test_mistakes_of_both_files_come_together(tmp_path):
    text = BASE.replace('"540 g"', '"540 stone"') + '[models]\nsolver = "magic"\n'
    broken = write(tmp_path, "broken.toml", text)
    write(tmp_path, "broken.rules", "if cue ball pocketed: respot ceu\n")
    files = {one.file for one in check_variant(broken)}
    assert files == {str(broken)}
    half = write(tmp_path, "half.toml", BASE + '[models]\nsolver = "magic"\n')
    script = write(tmp_path, "half.rules", "if cue ball pocketed: respot ceu\n")
    assert {one.file for one in check_variant(half)} == {str(half), str(script)}
    with pytest.raises(VariantError) as caught:
        load_variant(half)
    assert {one.file for one in caught.value.diagnostics} == {str(half), str(script)}


def test_a_mistake_in_the_script_alone_raises_with_its_place(tmp_path):
    path = write(tmp_path, "mine.toml", BASE)
    script = write(tmp_path, "mine.rules", "# fine\nif cue ball pocketed: respot ceu\n")
    with pytest.raises(VariantError) as caught:
        load_variant(path)
    (one,) = caught.value.diagnostics
    assert (one.file, one.line) == (str(script), 2)


def test_a_mark_that_is_wrong_is_told_once_and_still_known_to_the_script(tmp_path):
    text = BASE.replace('table = "wpa-9ft"', 'table.use = "wpa-9ft"')
    text += "[table.spots]\nmark = [9, 9]\n"
    path = write(tmp_path, "mine.toml", text)
    write(tmp_path, "mine.rules", "if cue ball pocketed: spot cue at mark\n")
    assert [one.code for one in check_variant(path)] == ["V401"]


def test_a_script_that_is_not_text_is_told(tmp_path):
    path = write(tmp_path, "mine.toml", BASE)
    (tmp_path / "mine.rules").write_bytes(b"if cue ball\xff pocketed: respot cue\n")
    assert [one.code for one in check_variant(path)] == ["V002"]


def test_an_extending_variant_plays_by_its_parents_script_until_it_has_its_own(tmp_path):
    path = write(tmp_path, "long.toml", 'extends = "three_cushion"\n')
    assert load_variant(path).script_path.name == "three_cushion.rules"
    write(tmp_path, "long.rules", 'language 1\nuses "three_cushion"\n')
    assert load_variant(path).script_path == tmp_path / "long.rules"


def test_a_named_script_is_taken(tmp_path):
    path = write(tmp_path, "mine.toml", 'rules = "house"\n' + BASE)
    write(tmp_path, "house.rules", ONE_LINE)
    assert load_variant(path).script_path.name == "house.rules"
