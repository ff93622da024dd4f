"""Random shots under the monitor: the same by number, sound, and kept as records that replay."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from engine.physics.simulate import EventStormError, simulate
from engine.variant.load import list_variants
from tools.soak import watch
from tools.soak.strokes import Plan, make_stroke
from tools.soak.watch import record_of, run

ROOT = Path(__file__).parents[2]
PLAN = Plan(7, tuple(listing.name for listing in list_variants()))


def test_a_shot_is_known_by_its_number():
    one, two = make_stroke(PLAN, 11), make_stroke(Plan(7, PLAN.variants), 11)
    assert (one.layout, one.strike, one.scene) == (two.layout, two.strike, two.scene)
    assert make_stroke(Plan(8, PLAN.variants), 11).strike != one.strike


def test_all_scenes_and_variants_come_up_and_are_sound():
    tally = run(PLAN, 60)
    assert tally.shots == 60
    assert tally.faults == []
    assert set(tally.scenes) == {"break", "strewn", "crowd"}
    assert tally.overlap <= 1e-9
    assert tally.gain <= 1e-12
    names = {make_stroke(PLAN, k).variant.name for k in range(2 * len(PLAN.variants))}
    assert names == set(PLAN.variants)


def test_every_model_takes_its_turn():
    plan = Plan(7, PLAN.variants, every=True)
    models = {make_stroke(plan, k).world.models for k in range(6 * len(PLAN.variants))}
    pairs = {(one.ball_ball, one.ball_cushion) for one in models}
    assert len(pairs) == 6
    assert run(Plan(7, PLAN.variants, (("ball_cushion", "restitution"),)), 9).faults == []


def test_a_storm_is_kept_and_its_record_replays(monkeypatch, tmp_path):
    def storm(*shot):
        raise EventStormError(*shot[1:])

    monkeypatch.setattr(watch, "simulate", storm)
    tally = run(PLAN, len(PLAN.variants))
    assert tally.caps == len(PLAN.variants)
    assert all("more than" in fault.words[0] for fault in tally.faults)
    for fault in tally.faults:
        (tmp_path / f"{fault.number}.toml").write_text(fault.record, encoding="utf-8")
    command = [sys.executable, "-m", "engine", "golden", "--json", str(tmp_path)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    told = json.loads(done.stdout)
    assert [(one.get("error"), one["passed"], one["replayed"]) for one in told] == [
        (None, True, True) for _ in told
    ]


@pytest.mark.parametrize("number", range(6))
def test_a_record_holds_the_very_shot(number, tmp_path):
    from engine.game.observe import simulate_shot
    from engine.records.read import read_record
    from engine.variant.load import load_variant

    stroke = make_stroke(PLAN, number)
    path = tmp_path / "shot.toml"
    path.write_text(record_of(stroke), encoding="utf-8")
    record = read_record(path, load_variant)
    trace = simulate_shot(record.variant, record.start, record.steps[0].shot)
    alone = simulate(stroke.world, stroke.layout, stroke.ball, stroke.strike)
    assert trace.hash() == alone.hash()
