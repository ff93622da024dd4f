from collections import Counter
from pathlib import Path

import pytest

from engine.app import keys

DOCS = Path(__file__).parents[2] / "docs" / "playing.md"


def rows():
    for one in keys.BINDINGS:
        fine = "; with Shift in fine steps" if one.takes == "shift" else ""
        yield f"| {one.shown} | {one.about}{fine} |"
    for what, about in keys.MOUSE:
        yield f"| {what} | {about} |"


def test_the_documentation_has_exactly_the_keys_of_the_table():
    made = DOCS.read_text(encoding="utf-8").split("<!-- made: key-tables -->")[1]
    tables = made.split("<!-- end -->")[0]
    written = [line for line in tables.splitlines() if line[:2] == "| "]
    told = [
        line
        for line in written
        if line not in ("| keys | what they do |", "| hand | what it does |")
    ]
    assert told == list(rows())


def test_every_action_has_one_name():
    assert max(Counter(one.action for one in keys.BINDINGS).values()) == 1


@pytest.mark.parametrize("one", keys.BINDINGS, ids=lambda one: one.action)
def test_every_key_is_one_that_the_window_knows(one):
    import pygame

    pygame.display.init()
    assert all(pygame.key.key_code(key) for key in one.keys)


def test_no_key_does_two_things_in_one_mode():
    shared = {"left", "right", "up", "down", *"123456789"}
    uses = Counter(key for one in keys.BINDINGS for key in one.keys if key not in shared)
    assert max(uses.values()) == 1


def test_one_two_three_are_the_renderers():
    assert [keys.binding(name).keys for name in ("wireframe", "painter", "scanline")] == [
        ("1",),
        ("2",),
        ("3",),
    ]


def test_an_action_that_does_not_exist_has_no_key():
    with pytest.raises(KeyError):
        keys.binding("dance")
