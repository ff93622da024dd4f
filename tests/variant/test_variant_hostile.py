"""Closes the hole between files nobody would write and an answer in good time.

Also: everything that needs files made on the spot, such as `extends` and parts of one's own.
"""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine.variant.library import VariantError, open_variant, resolve, shipped_folder
from engine.variant.load import check_variant, list_variants, load_variant, read_draft
from engine.variant.rack import lay_rack

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


def write(folder, name, text):
    path = folder / name
    path.parent.mkdir(exist_ok=True)
    path.write_text(text, encoding="utf-8", newline="")
    return path


def codes(path):
    return [one.code for one in read_draft(path)[1]]


@pytest.mark.parametrize(
    ("raw", "code"),
    [
        (b"title = '\xff\xfe'", "V002"),
        ("title = 'x'".encode("utf-16"), "V002"),
        (b"\x00\x01\x02", "V004"),
        (b"a = " + b"[" * 100, "V004"),
        (b"a = " + b"[" * 1500, "V003"),
        (b"a = " + b"[" * 900 + b"]" * 900, "V003"),
        (b"a." * 600 + b"a = 1", "V003"),
        (b"a.b = " + b"{x=" * 300 + b"1" + b"}" * 300, "V003"),
        (b"a = 1\n" * 60_000, "V003"),
        (b"a." * 60_000 + b"a = 1", "V003"),
        (b"".join(b"k%d = 1\n" % n for n in range(20_000)), "V101"),
        (b"".join(b"[[a]]\n" for n in range(20_000)), "V101"),
        (b"title = 9" + b"9" * 1900, "V103"),
    ],
    ids=lambda one: one if isinstance(one, str) else repr(one[:12]),
)
def test_a_hostile_file_is_answered_at_once(tmp_path, raw, code):
    path = tmp_path / "hostile.toml"
    path.write_bytes(raw)
    begin = time.process_time()
    found = codes(path)
    assert code in found
    assert time.process_time() - begin < 5


def test_a_byte_that_is_not_text_is_told_by_line_and_column(tmp_path):
    path = tmp_path / "broken.toml"
    path.write_bytes(b'title = "x"\nrulebook = "\xe9"\n')
    ((one,),) = [read_draft(path)[1]]
    assert (one.code, one.line, one.column) == ("V002", 2, 13)


@given(st.text(max_size=200))
@settings(max_examples=150, deadline=None)
def test_no_text_raises(tmp_path_factory, text):
    path = tmp_path_factory.mktemp("any") / "any.toml"
    path.write_text(BASE + text, encoding="utf-8", errors="replace", newline="")
    for one in read_draft(path)[1]:
        assert one.line >= 1
        assert one.column >= 1


words = st.sampled_from(
    ["table", "balls", "rack", "places", "1", "use", "spots", "zones", "pattern", "rows", "ball"]
)
anything = st.recursive(
    st.one_of(
        st.integers(),
        st.floats(allow_nan=False),
        st.booleans(),
        st.text(max_size=5),
        st.sampled_from(["wpa-9ft", "pool", "L/4", "foot-spot", "1..15", "*", "3 m"]),
    ),
    lambda inner: st.one_of(st.lists(inner, max_size=3), st.dictionaries(words, inner, max_size=3)),
    max_leaves=10,
)


@given(st.dictionaries(words, anything, max_size=4))
@settings(max_examples=200, deadline=None)
def test_no_tree_raises(tmp_path_factory, tree):
    import tomli_w

    base = {"title": "T", "rulebook": "R", "players": 2, "cue_balls": ["cue"]}
    parts = {"table": "wpa-9ft", "balls": "pool", "cloth": "worsted-pool"}
    cue = {"mass": 0.5, "tip_restitution": 0.7, "tip_friction": 0.6, "end_mass_ratio": 25.0}
    path = tmp_path_factory.mktemp("any") / "any.toml"
    path.write_text(tomli_w.dumps({**base, **parts, "cue": cue, **tree}), encoding="utf-8")
    read_draft(path)


def test_windows_line_ends_and_a_byte_order_mark_are_no_mistake(tmp_path):
    path = tmp_path / "windows.toml"
    path.write_bytes(b"\xef\xbb\xbf" + BASE.replace("\n", "\r\n").encode())
    assert codes(path) == []


@pytest.mark.parametrize("name", ["no_such_game", "no/such/file.toml", "", "\0", "a" * 5000, "."])
def test_an_unknown_variant_is_told_and_not_raised_as_something_else(name):
    with pytest.raises(VariantError) as caught:
        resolve(name)
    assert caught.value.diagnostics[0].code == "V001"


def test_a_near_name_is_offered():
    with pytest.raises(VariantError, match="did you mean `snooker`"):
        resolve("snoker")


def test_a_part_of_ones_own_stands_before_the_shipped_one(tmp_path):
    write(tmp_path, "tables/wpa-9ft.toml", 'use = "wpa-9ft"\nlength = "3 m"\n')
    path = write(tmp_path, "mine.toml", BASE)
    draft, diagnostics = read_draft(path)
    assert diagnostics == []
    assert draft.world.table.length == 3.0
    assert draft.world.table.spots["foot-spot"] == (0.75, 0.0)


def test_a_part_is_used_with_what_differs(tmp_path):
    text = BASE.replace('"wpa-9ft"', '{ use = "wpa-9ft", length = "92 in", width = "46 in" }')
    draft, diagnostics = read_draft(write(tmp_path, "eight_feet.toml", text))
    assert diagnostics == []
    assert draft.world.table.spots["foot-spot"][0] == pytest.approx(0.5842)
    assert len(draft.world.table.pockets) == 6


def test_a_part_that_uses_itself_is_a_circle(tmp_path):
    write(tmp_path, "tables/a.toml", 'use = "b"\n')
    write(tmp_path, "tables/b.toml", 'use = "a"\n')
    path = write(tmp_path, "mine.toml", BASE.replace("wpa-9ft", "a"))
    assert codes(path) == ["V202"]


def test_extending_says_only_what_differs(tmp_path):
    path = write(
        tmp_path,
        "long.toml",
        'extends = "three_cushion"\ntitle = "Long"\nsettings.target.default = 50\n',
    )
    draft, diagnostics = read_draft(path)
    assert diagnostics == []
    assert draft.settings["target"].default == 50
    assert draft.settings["equalising-inning"].default is True
    assert draft.spec.title == "Long"
    assert draft.spec.rules == "three_cushion"
    assert draft.world.table.length == 2.84


def test_an_extending_game_with_a_script_of_its_own_plays_by_it(tmp_path):
    path = write(tmp_path, "long.toml", 'extends = "three_cushion"\n')
    write(tmp_path, "long.rules", "")
    assert read_draft(path)[0].spec.rules is None


def test_an_extending_game_may_change_its_table_or_take_another(tmp_path):
    text = 'extends = "eight_ball"\ntable.rail_width = "10 cm"\n'
    draft, diagnostics = read_draft(write(tmp_path, "one.toml", text))
    assert diagnostics == []
    assert draft.world.table.rail_width == 0.1
    assert draft.world.table.length == 2.54
    text = 'extends = "one"\ntable = "carom-match"\n'
    draft, diagnostics = read_draft(write(tmp_path, "two.toml", text))
    assert draft.world.table.length == 2.84
    assert draft.world.table.rail_width == 0.125


def test_a_mistake_in_a_part_is_told_in_the_part(tmp_path):
    write(tmp_path, "cloths/slow.toml", '# slow\nuse = "worsted-pool"\nrolling = "slow"\n')
    path = write(tmp_path, "mine.toml", BASE.replace("worsted-pool", "slow"))
    (one,) = read_draft(path)[1]
    assert Path(one.file).name == "slow.toml"
    assert (one.line, one.column, one.code) == (3, 11, "V103")


def test_a_broken_part_is_told_once_and_not_what_it_would_have_held(tmp_path):
    write(tmp_path, "cloths/slow.toml", "rolling = \n")
    path = write(tmp_path, "mine.toml", BASE.replace("worsted-pool", "slow"))
    assert codes(path) == ["V004"]


def test_a_name_never_leads_out_of_the_folders(tmp_path):
    for name in ("../x", "/etc/passwd", "a/b", "..", "C:x", "a" * 300):
        path = write(tmp_path, "mine.toml", BASE.replace("wpa-9ft", name))
        assert codes(path) == ["V103"], name
        path = write(tmp_path, "mine.toml", f'extends = "{name}"\n')
        assert codes(path) == ["V103"], name


def test_balls_of_a_rack_with_a_lot_of_named_balls(tmp_path):
    text = BASE + (
        '[rack.pattern]\napex = "foot-spot"\napex_row = 3\ngap = "1 mm"\nballs = ["1..9"]\n'
        'rows = ["1", "* *", "* 9 *", "* *", "-", "tail"]\nlots.tail = ["7"]\n'
    )
    draft, diagnostics = read_draft(write(tmp_path, "mine.toml", text))
    assert diagnostics == []
    layout = lay_rack(draft.rack, 3)
    assert set(layout) == set("123456789")
    assert layout["9"] == pytest.approx((0.635, 0))
    assert layout["1"][0] == pytest.approx(0.635 - 0.05815 * 3**0.5)
    assert layout["7"][0] == pytest.approx(0.635 + 1.5 * 0.05815 * 3**0.5)


def test_a_variant_without_a_script_is_told_where_to_write_it(tmp_path):
    path = write(tmp_path, "mine.toml", BASE)
    (one,) = check_variant(path)
    assert one.code == "V204"
    assert "mine.rules" in one.mend
    with pytest.raises(VariantError, match="V204"):
        load_variant(path)


def test_mistakes_come_in_the_order_of_the_file(tmp_path):
    path = write(tmp_path, "mine.toml", BASE.replace('"House rules"', "1") + "x = 1\ny = 2\n")
    lines = [one.line for one in check_variant(path)]
    assert lines == sorted(lines)
    assert len(lines) == 3


def test_a_file_of_the_folder_one_stands_in_is_found_by_stem(tmp_path, monkeypatch):
    write(tmp_path, "mine.toml", BASE)
    monkeypatch.chdir(tmp_path)
    assert resolve("mine").name == "mine.toml"


def test_the_shipped_folder_is_listed_from_anywhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    listed = {one.name: one.title for one in list_variants()}
    assert listed["eight_ball"] == "Eight-ball"
    assert {"snooker", "three_cushion"} <= set(listed)
    assert open_variant(shipped_folder() / "snooker.toml").diagnostics == []


def test_loading_imports_neither_the_solver_nor_a_window():
    code = (
        "import sys, engine.variant.load as load; load.read_draft('snooker');"
        "print([name for name in ('numba', 'pygame', 'numpy', 'lark') if name in sys.modules])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        check=True,
        cwd=shipped_folder().parent,
    )
    assert done.stdout.strip() == "[]"
