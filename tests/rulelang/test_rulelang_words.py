"""Closes the hole between the grammar and the tables that editors and the reference are made of."""

from __future__ import annotations

import json
import re
import sys
import tomllib
from dataclasses import replace
from importlib import import_module

import pytest
from rule_cases import POOL, ROOT

sys.path.insert(0, str(ROOT))

from rulelang import highlight, words
from rulelang.compile import check_script
from rulelang.parse import grammar
from tools.phrases import EVENT_PHRASES, PHRASES, Phrase

SCRIPTS = sorted((ROOT / "variants").rglob("*.rules"))
TABLE = replace(
    POOL,
    pins=("left-pin", "right-pin"),
    zones=(*POOL.zones, "foot-end"),
    players=(2, 4),
)
SHARED = ("define contact when cue ball hit 8-ball\n", "shared.rules")


def grammar_words() -> set[str]:
    return {word for word in grammar().words if word.isalpha()}


def test_every_word_of_the_grammar_has_one_class() -> None:
    listed = [word for found in words.WORDS.values() for word in found]
    assert sorted(listed) == sorted(grammar_words())
    assert grammar_words() >= words.PAST
    assert grammar_words() >= words.OPENING


@pytest.mark.parametrize("phrase", PHRASES, ids=lambda one: one.spelling)
def test_the_example_of_a_phrase_compiles_without_a_warning(phrase: Phrase) -> None:
    source = phrase.needs + phrase.example + "\n"
    assert check_script(source, "example", TABLE, lambda _name: SHARED) == ()


def test_every_word_of_the_grammar_is_in_an_example() -> None:
    examples = [one.needs + one.example for one in PHRASES]
    said = " ".join(examples + [told for _, told in EVENT_PHRASES])
    assert grammar_words() - set(re.findall(r"[a-z]+", said)) == set()


def test_the_spelling_of_a_phrase_uses_words_of_the_grammar() -> None:
    known = grammar_words() | {"head", "zone", "group", "legal", "level"}
    for one in PHRASES:
        if "NAME" not in one.spelling or one.group != "Declarations":
            said = set(re.findall(r"(?<![A-Z-])\b[a-z]+\b(?!-)", one.spelling))
            assert said <= known, one.spelling


def test_textmate_is_made_of_the_same_patterns_and_committed() -> None:
    path = ROOT / "editors" / "vscode" / "rules.tmLanguage.json"
    made = json.loads(path.read_text(encoding="utf-8"))
    assert made == highlight.textmate()
    assert [one["match"] for one in made["patterns"]] == [p for _, p in highlight.patterns()]
    package = json.loads((path.parent / "package.json").read_text(encoding="utf-8"))
    for one in package["contributes"]["languages"]:
        json.loads((path.parent / one["configuration"]).read_text(encoding="utf-8"))
    assert (path.parent / package["contributes"]["grammars"][0]["path"]).exists()


def kinds(text: str) -> list[tuple[str, str]]:
    """Return what TextMate would see: at each place the first pattern that matches."""
    table = [(kind, re.compile(pattern, re.MULTILINE)) for kind, pattern in highlight.patterns()]
    found, at = [], 0
    while at < len(text):
        hit = next((m for m in ((k, p.match(text, at)) for k, p in table) if m[1]), None)
        if hit is None:
            assert text[at].isspace(), text[at : at + 20]
            at += 1
            continue
        found.append((hit[0], hit[1].group()))
        at = hit[1].end()
    return found


def test_what_a_line_is_made_of() -> None:
    line = 'fouls:\n    rule "A" [3.1]: if the 8-ball pocketed: foul in-off worth 4  # why\n'
    assert kinds(line) == [
        ("heading", "fouls"), ("sign", ":"), ("head", "rule"), ("string", '"A"'),
        ("cite", "[3.1]"), ("sign", ":"), ("control", "if"), ("article", "the"),
        ("ball", "8-ball"), ("event", "pocketed"), ("sign", ":"), ("action", "foul"),
        ("foul", "in-off"), ("quantity", "worth"), ("number", "4"), ("comment", "# why"),
    ]  # fmt: skip
    assert kinds("fouls-in-a-row the-last if-not") == [
        ("name", "fouls-in-a-row"),
        ("name", "the-last"),
        ("name", "if-not"),
    ]
    assert kinds("when shot-clock expires:")[0] == ("heading", "when shot-clock expires")


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.stem)
def test_pygments_reads_every_shipped_script(path) -> None:
    import pygments
    from pygments.token import Error

    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    where = project["entry-points"]["pygments.lexers"]["headstring-rules"]
    module, name = where.split(":")
    lexer = getattr(import_module(module), name)()
    text = path.read_text(encoding="utf-8")
    tokens = list(pygments.lex(text, lexer))
    assert "".join(value for _, value in tokens) == text
    assert not [value for kind, value in tokens if kind in Error]
    assert len({kind for kind, _ in tokens}) >= 4
