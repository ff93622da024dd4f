"""Closes the hole between Lark's own parser and the one with faster parts in it."""

from __future__ import annotations

import random
import sys
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from lark.exceptions import UnexpectedInput

sys.path.insert(0, str(Path(__file__).parents[2]))

from rulelang import parse
from rulelang.hasten import quick_parse
from rulelang.indent import BadDedent
from tools.scripts import random_script

ROOT = Path(__file__).parents[2]
SCRIPTS = [
    path.read_text(encoding="utf-8") for path in sorted((ROOT / "variants").rglob("*.rules"))
]


@pytest.fixture(scope="module")
def slow():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(parse, "hasten", lambda _parser: None)
        return parse._parser.__wrapped__(None)


def told(parser, text):
    """Return tree and places, or the mistake with its place."""
    try:
        tree = quick_parse(parser, text)
    except UnexpectedInput as trouble:
        kind = type(trouble).__name__
        token = getattr(trouble, "token", None)
        return kind, trouble.line, trouble.column, token, getattr(token, "type", None)
    except BadDedent as trouble:
        return "dedent", trouble.line, trouble.column
    return tree, [
        (node.data, vars(node.meta) if not node.meta.empty else None)
        for node in tree.iter_subtrees_topdown()
    ]


@pytest.mark.parametrize("text", SCRIPTS, ids=lambda text: text.split("\n")[1][:20])
def test_a_shipped_script_makes_the_same_tree(slow, text):
    assert told(parse.grammar(), text) == told(slow, text)


@pytest.mark.parametrize("seed", range(25))
def test_a_made_up_script_makes_the_same_tree(slow, seed):
    text = random_script(random.Random(seed))
    assert told(parse.grammar(), text) == told(slow, text)


@settings(max_examples=150, deadline=None, suppress_health_check=list(HealthCheck))
@given(st.data())
def test_a_spoiled_script_makes_the_same_mistake(slow, data):
    text = data.draw(st.sampled_from(SCRIPTS))
    at = data.draw(st.integers(0, len(text)))
    junk = data.draw(st.text('a -\n#"[](),:09the\tX=é', max_size=6))
    text = text[max(0, at - 200) : at] + junk + text[at : at + 200]
    assert told(parse.grammar(), text) == told(slow, text)
