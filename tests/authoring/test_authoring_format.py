"""Closes the hole between what an author wrote and what the formatter leaves of it."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

sys.path.insert(0, str(Path(__file__).parents[2]))

from click.testing import CliRunner

from engine.__main__ import main
from rulelang.formatting import format_script, plain
from rulelang.parse import parse
from rulelang.surface import scan
from tools.scripts import random_script

ROOT = Path(__file__).parents[2]
SCRIPTS = sorted((ROOT / "variants").rglob("*.rules"))
PAGES = [path for path in sorted((ROOT / "docs").glob("*.md")) if path.stem != "tutorial"]
EXAMPLE = re.compile(r"```rules(?! broken)[^\n]*\n(.*?)```", re.DOTALL)
EXAMPLES = [
    text
    for page in PAGES
    for text in re.findall(
        r"```rules(?! broken)[^\n]*\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL
    )
]


def tree(source: str) -> str:
    script, mistakes = parse(source, "t.rules")
    assert not mistakes
    return plain((script.declarations, script.rules))


def comments(source: str) -> list[str]:
    bare = re.sub(r'"[^"\n]*"', "", source)
    return [found.rstrip() for found in re.findall(r"#[^\n]*", bare)]


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.stem)
def test_a_shipped_script_is_written_as_the_formatter_writes_it(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    assert format_script(text, path.name) == text


@pytest.mark.parametrize("source", EXAMPLES, ids=lambda text: text[:30])
def test_an_example_keeps_its_tree_and_comments(source: str) -> None:
    text = format_script(source)
    assert tree(text) == tree(source)
    assert sorted(comments(text)) == sorted(comments(source))
    assert format_script(text) == text


@settings(max_examples=150, deadline=None, suppress_health_check=list(HealthCheck))
@given(st.randoms(use_true_random=False))
def test_a_made_up_script_keeps_its_tree_and_is_formatted_once(random) -> None:
    source = random_script(random, 4)
    if any(one.code == "R109" for one in scan(source, "")):
        return
    text = format_script(source)
    assert tree(text) == tree(source)
    assert format_script(text) == text


@settings(max_examples=60, deadline=None, suppress_health_check=list(HealthCheck))
@given(st.randoms(use_true_random=False), st.sampled_from(SCRIPTS))
def test_blanks_articles_and_depth_make_no_difference(random, path) -> None:
    text = path.read_text(encoding="utf-8")
    assert format_script(roughened(text, random)) == text


def roughened(text: str, random) -> str:
    """Return a script with other blanks, deeper steps and articles in the bodies of rules."""
    step = random.choice((1, 2, 3, 7))
    rows = []
    for row in text.split("\n"):
        bare = row.lstrip(" ")
        depth = (len(row) - len(bare)) // 4
        if '"' not in bare and "#" not in bare and "[" not in bare:
            gap = random.choice((" ", "  ", " the ", " a  "))
            bare = re.sub(r"(?<=(?<! as)(?<!and|not)[a-z]) (?=[a-z])", gap, bare)
        rows.append(" " * (depth * step) + bare + random.choice(("", " ", "   ")))
    end = random.choice(("\n", "\r\n"))
    return end.join(rows) + random.choice(("", "\n\n"))


def test_the_canonical_spelling() -> None:
    source = (
        "# what it is\n"
        "language   1\n"
        "\n\n\n"
        "define   good   when any  of the reds pocketed   # a comment\n"
        "define x as:\n"
        "   if good : 1\n"
        "   otherwise: 0\n"
        "   # and that is all\n"
        "fouls:\n"
        ' rule "A" [1 ,2]:\n'
        "   if  good and ( not x is at least 1 ,) :\n".replace(" ,)", ")")
        + "       # why\n"
        "       foul a-thing   # long\n"
        "       foul b # short\n"
        "    # after the body\n"
        "table:\n"
        "  if good: remove the reds from table\n"
        "  for each of (reds\n"
        "               ,cue ball # the last\n"
        "     ): remove it\n\n\n"
    )
    assert format_script(source) == (
        "# what it is\n"
        "language 1\n"
        "\n"
        "define good when any of reds pocketed  # a comment\n"
        "define x:\n"
        "    if good: 1\n"
        "    otherwise: 0\n"
        "    # and that is all\n"
        "\n"
        "fouls:\n"
        '    rule "A" [1, 2]:\n'
        "        if good and (not x is at least 1):\n"
        "            # why\n"
        "            foul a-thing  # long\n"
        "            foul b        # short\n"
        "        # after the body\n"
        "\n"
        "table:\n"
        "    if good: remove reds\n"
        "    for each of (reds\n"
        "        , cue ball  # the last\n"
        "    ): remove it\n"
    )


def test_the_command_writes_and_checks(tmp_path: Path) -> None:
    path = tmp_path / "x.rules"
    path.write_bytes(b"if the cue ball pocketed:   respot cue\r\n")
    run = CliRunner().invoke
    assert run(main, ["format", "--check", str(tmp_path)]).exit_code == 1
    assert path.read_bytes().endswith(b"\r\n")
    assert run(main, ["format", str(path)]).exit_code == 0
    assert path.read_bytes() == b"if cue ball pocketed: respot cue\n"
    told = run(main, ["format", "--check", str(path)])
    assert (told.exit_code, told.output) == (0, "1 file, 0 would change\n")


def test_a_broken_script_is_told_and_left_alone(tmp_path: Path) -> None:
    path = tmp_path / "x.rules"
    path.write_text("if the cue ball is pocketed:   respot cue\n")
    told = CliRunner().invoke(main, ["format", str(path), str(tmp_path / "none.rules")])
    assert told.exit_code == 2
    assert "R107" in told.output
    assert "V001" in told.output
    assert "  respot" in path.read_text()
