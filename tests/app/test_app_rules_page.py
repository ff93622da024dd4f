"""The page of a game's rules is its script, with the sections it cites."""

import pytest

from engine.app.keymap import Keymap
from engine.app.pages import Page, rows_of
from engine.app.telling import rules_lines
from engine.variant.load import list_variants, load_variant


@pytest.mark.parametrize("name", [one.name for one in list_variants()])
def test_every_rule_stands_on_the_page_with_its_sections(name):
    variant = load_variant(name)
    said = "\n".join(line.text for line in rules_lines(variant))
    for rule in variant.program.rules:
        assert rule.name in said
        assert all(section in said for section in rule.cites)
        words = rule.text.split("\n")[-1].removeprefix(f'"{rule.name}"')
        assert words.rpartition('": ' if '": ' in words else "]: ")[2].strip() in said


def test_a_rule_in_place_of_another_says_so():
    lines = [line.text.strip() for line in rules_lines(load_variant("nine_ball"))]
    assert any(line.startswith("in place of") for line in lines)


def test_the_page_opens_with_the_rulebook(start):
    session = start("snooker")
    first = rows_of(Page.RULES, session, Keymap())[0]
    assert session.variant.rulebook in first.line.text
