"""The pages on the games and the scripts name the same rules and the same records."""

import re
from functools import cache
from pathlib import Path

import pytest

from engine.variant.load import list_variants, load_variant
from tools.game_pages import START, with_files

ROOT = Path(__file__).parents[2]
PAGES = ROOT / "docs" / "games"
GAMES = sorted(page.stem for page in PAGES.glob("*.md"))
load = cache(load_variant)


def rows(game):
    lines = (PAGES / f"{game}.md").read_text(encoding="utf-8").splitlines()
    cells = [line.strip("|").split("|") for line in lines if line.startswith("| ")]
    return [[cell.strip() for cell in row] for row in cells[1:]]


def named(game):
    texts = (re.sub(r'the book says "[^"]*"', "", row[2]) for row in rows(game))
    return {name for text in texts for name in re.findall(r'"([^"]+)"', text)}


def rules(game):
    compiled = load(game).program.compiled
    return {rule.info.name for section in compiled.values() for rule in section}


def numbers(game):
    found = set()
    for row in rows(game):
        for part in filter(None, row[3].split(", ")):
            first, _, last = part.partition("-")
            found.update(range(int(first), int(last or first) + 1))
    return found


def test_every_page_tells_of_a_game_that_is_shipped():
    assert {"eight_ball", "nine_ball", "snooker", "three_cushion"} <= set(GAMES)
    assert set(GAMES) <= {one.name for one in list_variants()}


def own_rules(game):
    variant = load(game)
    own = str(variant.script_path)
    sections = variant.program.compiled.values()
    return {rule.info.name for rules in sections for rule in rules if rule.info.file == own}


@pytest.mark.parametrize("game", GAMES)
def test_page_and_script_name_the_same_rules(game):
    assert own_rules(game) <= named(game) <= rules(game)


def test_a_rule_that_games_share_is_named_on_a_page():
    assert set().union(*map(rules, GAMES)) == set().union(*map(named, GAMES))


@pytest.mark.parametrize("game", GAMES)
def test_a_page_names_records_that_are_there_and_lists_them_all(game):
    records = list((ROOT / "tests" / "golden" / game).glob("*.toml"))
    assert numbers(game) <= {int(path.stem.split("-")[1]) for path in records}
    page = (PAGES / f"{game}.md").read_text(encoding="utf-8")
    _, _, made = page.partition(START)
    assert made, "run python -m tools.docs"
    assert with_files(page, game) == with_files(with_files(page, game), game)


@pytest.mark.parametrize("game", GAMES)
def test_every_rule_of_a_script_cites_its_section(game):
    compiled = load(game).program.compiled
    uncited = [
        rule.info.name for section in compiled.values() for rule in section if not rule.info.cites
    ]
    assert uncited == []
