"""Closes the hole between the tree that tomllib builds and the places that are told for it."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest
import tomli_w
from hypothesis import given, settings
from hypothesis import strategies as st

from engine.variant.locate import locate

AWKWARD = '''
# a comment with [brackets] and "quotes"
title = "a # in a text, and \\" escaped" # after
'quoted key' = 1
"with.dot"."and = sign" = { a = 1, 'b c' = [1, [2, 3]], d.e = "}" }
many = [
  1, # one ]
  "two, ]",
  { x = 1 }, # table
]
long = """
not = "a key"
[not.a.table]
"" two quotes and one more at the end\\""""
raw = \'\'\'
[[nor.this]]
it''s\'\'\'
date = 1979-05-27 07:32:00Z
empty = []
none = {}
[ a . "b.c" ] # heading
d = 1
[[list]]
x = 1
[list.sub]
y = 2
[[list]]
[[list.inner]]
z = 3
[[list.inner]]
z = 4
[a]
z = -0x1F
'''.replace("-0x1F", "0x1F")


def paths_of(value, path=()):
    if path:
        yield path
    if isinstance(value, dict):
        for key, child in value.items():
            yield from paths_of(child, (*path, key))
    elif isinstance(value, list):
        for index, child in enumerate(value):
            yield from paths_of(child, (*path, index))


def test_every_path_of_an_awkward_text_is_found_and_no_other():
    assert set(locate(AWKWARD)) == set(paths_of(tomllib.loads(AWKWARD)))


@pytest.mark.parametrize(
    ("path", "key", "value"),
    [
        (("title",), (3, 1), (3, 9)),
        (("quoted key",), (4, 1), (4, 16)),
        (("with.dot", "and = sign"), (5, 12), (5, 27)),
        (("with.dot", "and = sign", "b c", 1, 0), (5, 49), (5, 49)),
        (("with.dot", "and = sign", "d", "e"), (5, 59), (5, 63)),
        (("many", 1), (8, 3), (8, 3)),
        (("many", 2, "x"), (9, 5), (9, 9)),
        (("raw",), (15, 1), (15, 7)),
        (("a", "b.c"), (21, 7), (21, 7)),
        (("list", 1, "inner", 1, "z"), (31, 1), (31, 5)),
        (("list",), (23, 3), (23, 3)),
        (("a", "z"), (33, 1), (33, 5)),
    ],
)
def test_keys_and_values_are_told_where_they_stand(path, key, value):
    place = locate(AWKWARD)[path]
    assert (place.line, place.column) == key
    assert (place.value_line, place.value_column) == value


text = st.text(max_size=8).filter(lambda one: "\x00" not in one)
scalar = st.one_of(
    st.integers(-(2**60), 2**60), st.booleans(), st.floats(allow_nan=False), text, st.dates()
)
value = st.recursive(
    scalar,
    lambda inner: st.one_of(st.lists(inner, max_size=3), st.dictionaries(text, inner, max_size=3)),
    max_leaves=12,
)


@given(st.dictionaries(text, value, max_size=4), st.booleans())
@settings(max_examples=300, deadline=None)
def test_every_path_of_a_written_tree_is_found(tree, multiline):
    written = tomli_w.dumps(tree, multiline_strings=multiline)
    places = locate(written)
    assert set(places) == set(paths_of(tomllib.loads(written)))
    lines = written.split("\n")
    for place in places.values():
        assert place.column <= len(lines[place.line - 1]) + 1
        assert place.value_column <= len(lines[place.value_line - 1]) + 1


@pytest.mark.parametrize(
    "path", sorted((Path(__file__).parents[2] / "variants").rglob("*.toml")), ids=lambda p: p.stem
)
def test_the_shipped_files_are_located_whole(path):
    written = path.read_text(encoding="utf-8")
    assert set(locate(written)) == set(paths_of(tomllib.loads(written)))
