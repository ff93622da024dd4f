"""The engine and the language know no game: their sources name none, nor any ball."""

import ast
import re
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
SOURCES = sorted(
    [*ROOT.glob("engine/**/*.py"), *ROOT.glob("rulelang/**/*.py"), *ROOT.glob("rulelang/*.lark")]
)
# Games that ship, and games that people know: none of them may be special. What is a phrase of the
# sport as well (`PHRASES`) cannot be told apart and is left out.
PHRASES = {"one cushion", "one pocket", "rotation"}
KNOWN = """
snooker, eight ball, nine ball, ten ball, straight pool, blackball, three cushion, straight rail,
balkline, five pins, pyramid, keglebillard, bar billiards, english billiards, kitchen, baulk,
rotation pool, cribbage, bank pool, heyball, killer pool
"""
SHIPPED = {path.stem.replace("_", " ") for path in ROOT.glob("variants/*.toml")}
GAMES = sorted((SHIPPED - PHRASES) | {name.strip() for name in KNOWN.split(",")})
GAME = re.compile(
    rf"\b(?:{'|'.join(re.escape(name).replace(chr(92) + ' ', '[ _-]?') for name in GAMES)})\b",
    re.IGNORECASE,
)
# The stick is called a cue too; drawing knows colours by their names.
WORDS_OF_THE_SPORT = {"cue"}
# The digits are keys of the keyboard, and are painted on balls.
DIGITS = ("engine/app/keys.py", "engine/stage/skin.py")
DRAWING = ("engine/stage/", "engine/app/", "engine/render/", "engine/variant/fields.py")


def ball_names():
    names = set()
    for path in (ROOT / "variants" / "balls").glob("*.toml"):
        data = tomllib.loads(path.read_text(encoding="utf-8"))
        names |= set(_names_of_balls(data))
    names |= {str(number) for number in range(1, 16)}
    return names - WORDS_OF_THE_SPORT


def _names_of_balls(data):
    for key, value in data.items():
        if isinstance(value, dict):
            if "colour" in value or "value" in value:
                yield key
            yield from _names_of_balls(value)


def colours():
    return {"white", "yellow", "red", "green", "brown", "blue", "pink", "black", "orange", "purple"}


@pytest.mark.parametrize("path", SOURCES, ids=lambda path: str(path.relative_to(ROOT)))
def test_no_game_is_named(path):
    text = path.read_text(encoding="utf-8")
    found = [
        f"{number}: {line.strip()}"
        for number, line in enumerate(text.splitlines(), 1)
        if GAME.search(line)
    ]
    assert found == []


@pytest.mark.parametrize(
    "path",
    [one for one in SOURCES if one.suffix == ".py"],
    ids=lambda path: str(path.relative_to(ROOT)),
)
def test_no_ball_is_named(path):
    where = path.relative_to(ROOT).as_posix()
    allowed = colours() if where.startswith(DRAWING) else set()
    tree = ast.parse(path.read_text(encoding="utf-8"))
    literals = {
        (node.lineno, node.value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    }
    named = ball_names() - allowed
    if where in DIGITS:
        named = {name for name in named if not name.isdecimal()}
    assert sorted(literal for literal in literals if literal[1] in named) == []


def test_the_list_of_balls_is_not_empty():
    assert {"red", "black", "8"} <= ball_names()
