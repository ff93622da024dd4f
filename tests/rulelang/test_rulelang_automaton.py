"""Closes the hole between Lark's own parser and the walk through tables that are kept in a file."""

from __future__ import annotations

import random
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from lark import Token as LarkToken
from lark import Tree as LarkTree
from lark.exceptions import UnexpectedCharacters, UnexpectedToken
from lark.lark import PostLex

sys.path.insert(0, str(Path(__file__).parents[2]))

from rulelang import parse, tables
from rulelang.automaton import Tree, Unfit
from rulelang.making import lark_of
from rulelang.reading import BadDedent, Unreadable
from tools.scripts import random_script

ROOT = Path(__file__).parents[2]
SCRIPTS = [
    path.read_text(encoding="utf-8") for path in sorted((ROOT / "variants").rglob("*.rules"))
]
SOURCE = parse.GRAMMAR.read_bytes()


class Indentation(PostLex):
    """The plain way to indentation, as a pass over Lark's stream of tokens."""

    always_accept = ()

    def process(self, stream):
        depths, brackets, last = [0], 0, None
        for token in stream:
            if token.type == "_NL":
                if brackets == 0:
                    last = token
                    yield token
                    yield from self.change(token, depths)
                continue
            brackets = max(0, brackets + {"LPAR": 1, "RPAR": -1}.get(token.type, 0))
            yield token
        for _ in depths[1:]:
            yield LarkToken.new_borrow_pos("_DEDENT", "", last)

    def change(self, newline, depths):
        depth = len(newline.rsplit("\n", 1)[1])
        if depth > depths[-1]:
            depths.append(depth)
            yield LarkToken.new_borrow_pos("_INDENT", "", newline)
            return
        while depth < depths[-1]:
            depths.pop()
            yield LarkToken.new_borrow_pos("_DEDENT", "", newline)
        if depth != depths[-1]:
            raise BadDedent(newline.end_line, newline.end_column)


@pytest.fixture(scope="module")
def slow():
    return lark_of(postlex=Indentation())


def plain(node):
    """Return a tree of either kind as nested tuples with their places."""
    if isinstance(node, LarkToken):
        return str(node), node.line, node.column, node.start_pos, node.end_pos
    if isinstance(node, LarkTree):
        m = node.meta
        place = None if m.empty else (m.line, m.column, m.start_pos, m.end_pos)
        return str(node.data), place, [plain(one) for one in node.children]
    if isinstance(node, Tree):
        return node.data, node.place, [plain(one) for one in node.children]
    if node is None:
        return None
    return node.text, node.line, node.column, node.start, node.end


def by_lark(slow, text):
    try:
        return plain(slow.parse(text))
    except UnexpectedCharacters as trouble:
        return "unreadable", trouble.line, trouble.column
    except UnexpectedToken as trouble:
        token = trouble.token
        return (token.type, str(token), token.line, token.column, token.end_line, trouble.accepts)
    except BadDedent as trouble:
        return "dedent", trouble.line, trouble.column


def by_walk(text):
    try:
        return plain(parse.grammar().parse(text))
    except Unreadable as trouble:
        return "unreadable", trouble.line, trouble.column
    except Unfit as trouble:
        token = trouble.token
        return (token.kind, token.text, token.line, token.column, token.end_line, trouble.fitting)
    except BadDedent as trouble:
        return "dedent", trouble.line, trouble.column


@pytest.mark.parametrize("text", SCRIPTS, ids=lambda text: text.split("\n")[1][:20])
def test_a_shipped_script_makes_the_same_tree(slow, text):
    assert by_walk(text) == by_lark(slow, text)


@pytest.mark.parametrize("seed", range(25))
def test_a_made_up_script_makes_the_same_tree(slow, seed):
    text = random_script(random.Random(seed))
    assert by_walk(text) == by_lark(slow, text)


@settings(max_examples=150, deadline=None, suppress_health_check=list(HealthCheck))
@given(st.data())
def test_a_spoiled_script_makes_the_same_mistake(slow, data):
    text = data.draw(st.sampled_from(SCRIPTS))
    at = data.draw(st.integers(0, len(text)))
    junk = data.draw(st.text('a -\n#"[](),:09the\tX=é', max_size=6))
    text = text[max(0, at - 200) : at] + junk + text[at : at + 200]
    assert by_walk(text) == by_lark(slow, text)


def test_kept_tables_are_those_that_were_made(tmp_path):
    made = tables.kept_tables(parse.GRAMMAR, tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == [tables.FILE]
    assert tables.kept_tables(parse.GRAMMAR, tmp_path) == made
    assert tables.read(tables.written(made, SOURCE), SOURCE) == made


@pytest.mark.parametrize(
    "spoil",
    [
        lambda _text: "",
        lambda text: text[: len(text) // 2],
        lambda text: text.replace(" 7 ", " 8 ", 1),
        lambda text: "\x80\x04pickle" + text,
        lambda text: text[::-1],
    ],
    ids=["empty", "half", "changed", "foreign", "backwards"],
)
def test_a_broken_file_of_tables_is_made_anew(tmp_path, spoil):
    made = tables.kept_tables(parse.GRAMMAR, tmp_path)
    whole = (tmp_path / tables.FILE).read_text(encoding="utf-8")
    (tmp_path / tables.FILE).write_text(spoil(whole), encoding="utf-8")
    again = tables.kept_tables(parse.GRAMMAR, tmp_path)
    assert again.words == made.words
    assert tables.read((tmp_path / tables.FILE).read_text(encoding="utf-8"), SOURCE) == again


def test_bytes_that_are_no_text_are_no_tables(tmp_path):
    (tmp_path / tables.FILE).write_bytes(b"\xff\xfe" * 100)
    assert tables.kept_tables(parse.GRAMMAR, tmp_path).words["if"] == "IF"


def test_tables_of_another_grammar_are_made_anew():
    text = tables.written(tables.kept_tables(parse.GRAMMAR, None), SOURCE)
    assert tables.read(text, SOURCE + b"\n") is None


def test_a_folder_that_cannot_be_written_does_no_harm(tmp_path):
    (tmp_path / "file").write_text("x")
    assert tables.kept_tables(parse.GRAMMAR, tmp_path / "file" / "folder").rows


def test_a_script_is_parsed_without_lark_where_the_tables_are_kept(tmp_path):
    code = (
        "import sys; from pathlib import Path; from rulelang.parse import parse;"
        "print(len(parse('if cue ball pocketed: respot cue', 'x', Path(sys.argv[1]))[0].rules),"
        "'lark' in sys.modules)"
    )
    said = []
    for _ in range(2):
        command = [sys.executable, "-c", code, str(tmp_path)]
        done = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True)
        said.append(done.stdout.split())
    assert said == [["1", "True"], ["1", "False"]]
