"""What `explain` prints of a record: text and JSON from the same values."""

import json
from functools import cache
from pathlib import Path

from engine.records.read import read_record, read_record_text
from engine.records.run import run_record
from engine.records.show import explain_json, explain_text
from engine.records.write import cites_of
from engine.variant.load import load_variant

GOLDEN = Path(__file__).resolve().parents[1] / "golden"
load = cache(load_variant)


def outcome_of(text):
    head = 'format = 1\nvariant = "heyball"\ntitle = "A break"\n'
    return run_record(read_record_text(head + text, Path("a.toml"), load))


BREAK = """
[[shot]]
events = ["cue hits 1", "1 hits cushion foot", "cue pocketed foot-left"]
facts = { scooped = true }
call = { ball = "1", pocket = "foot-left" }
expect = {}
[[shot]]
choose = "rerack"
expect = {}
"""


def test_what_was_told_and_why_is_in_the_text():
    text = explain_text(outcome_of(BREAK))
    assert "Shot 1, player 1, phase break" in text
    assert "  call: ball 1, pocket foot-left" in text
    assert "  facts: scooped yes" in text
    assert "foul: scratch [WPA 2025 3.1, WPA 2025 2.2] (Scratch)" in text
    assert "because lost-cue-ball: yes (cue ball pocketed: yes) (event 3)" in text
    assert "default: no rule keeps the turn, so it passes" in text
    assert "fired: choice: Break again [break]\n      because player 2 chose rerack" in text
    assert "silent" not in text
    assert "silent: fouls: No contact" in explain_text(outcome_of(BREAK), everything=True)


def test_json_holds_the_same():
    told = json.loads(json.dumps(explain_json(outcome_of(BREAK))))
    first, second = told["shots"]
    assert first["told"]["facts"] == {"scooped": True}
    assert first["phase"] == "break"
    assert first["defaults"] == ["no rule keeps the turn, so it passes"]
    scratch = next(one for one in first["rules"] if one["rule"] == "Scratch")
    assert scratch["cites"] == ["WPA 2025 3.1", "WPA 2025 2.2"]
    assert (scratch["outcome"], scratch["events"]) == ("fired", [2])
    assert scratch["file"].endswith("pool-standard-fouls.rules")
    assert [one["section"] for one in second["rules"]] == ["choice"]
    assert second["defaults"] == []


def test_a_record_cites_the_book_in_which_a_section_stands():
    outcome = outcome_of(BREAK)
    verdict = outcome.judgements[0].verdict
    cites = cites_of(outcome.record.variant, verdict)
    assert "WPA 2025 3.1" in cites
    assert "WPA Heyball 2025 break" in cites
    assert not any("Heyball 2025 WPA" in one for one in cites)


def test_every_record_is_explained_without_a_word_too_many():
    for path in sorted(GOLDEN.glob("*/*.toml"))[::40]:
        text = explain_text(run_record(read_record(path, load)), everything=True)
        assert "+0 to" not in text, path
        assert "  -> spot \n" not in text, path
        assert max(map(len, text.splitlines())) < 1200, path
        over = "winner: " in text
        assert not (over and "may choose" in text.split("over: yes")[-1]), path
