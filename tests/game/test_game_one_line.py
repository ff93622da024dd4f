"""The smallest whole script works as it stands."""

import pytest

from engine.game.match import start_match
from engine.game.referee import judge_shot
from engine.game.shot import Shot
from engine.records.read import read_record
from engine.records.record import RecordError
from engine.records.run import run_record
from engine.variant.load import check_variant, load_variant
from rulelang.events import BallsHit, LeftTable, Pocketed

SCRIPT = "if cue ball pocketed: respot cue\n"


def variant(folder, parent, script=SCRIPT):
    path = folder / "mini.toml"
    path.write_text(f'extends = "{parent}"\ntitle = "Mini"\n', encoding="utf-8")
    (folder / "mini.rules").write_text(script, encoding="utf-8")
    assert check_variant(path) == []
    return load_variant(path)


@pytest.mark.parametrize("parent", ["eight_ball", "snooker"])
def test_one_line_is_a_game(tmp_path, parent):
    mini = variant(tmp_path, parent)
    start = start_match(mini).situation
    assert start.in_hand is None
    assert "cue" in start.rest.positions
    other = min(start.on_table - {"cue"})
    events = (BallsHit("cue", (other,)), Pocketed("cue", "foot-left"), Pocketed(other, "foot-left"))
    verdict = judge_shot(mini, start, Shot(events=events))
    assert [one.ball for one in verdict.spotted] == ["cue"]
    assert "cue" in verdict.after.on_table
    assert other not in verdict.after.on_table
    assert verdict.after.shooter == 2


def test_a_cue_ball_that_no_rule_brings_back_is_put_at_its_start(tmp_path):
    mini = variant(tmp_path, "eight_ball", "if cue ball pocketed: award 1 to opponent\n")
    start = start_match(mini).situation
    after = judge_shot(mini, start, Shot(events=(LeftTable("cue"),))).after
    assert after.rest.positions["cue"] == start.rest.positions["cue"]
    assert after.scores == (0, 0)


def test_rules_that_clash_are_told_as_the_records_trouble(tmp_path):
    script = "if cue ball pocketed: turn continues\nif any ball pocketed: turn passes\n"
    variant(tmp_path, "eight_ball", script)
    path = tmp_path / "record.toml"
    path.write_text(
        'format = 1\nvariant = "mini"\ntitle = "clash"\n[before]\n[[shot]]\n'
        'events = ["cue pocketed foot-left"]\n[shot.expect]\n',
        encoding="utf-8",
    )
    with pytest.raises(RecordError) as caught:
        run_record(read_record(path, lambda name: load_variant(tmp_path / f"{name}.toml")))
    told = caught.value.diagnostics[0]
    assert (told.code, told.line) == ("T401", 5)
    assert "mini.rules:1" in told.message
    assert "mini.rules:2" in told.message
