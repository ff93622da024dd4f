"""The speed table: what is measured is what it says, and a peer that is not there is told of."""

import argparse
import json
import subprocess
import sys
from itertools import combinations
from math import hypot
from pathlib import Path

import pytest

from engine.physics.strike import strike_ball
from tools.bench import physics
from tools.bench.peer import PeerMissingError, ask_peer
from tools.bench.shots import GAP, breaks, crowds, few, random_breaks

ROOT = Path(__file__).parents[2]


def touching(work, layout):
    reach = 2.0 * next(b.radius for b in work.world.balls if b.id == work.ball)
    gaps = [hypot(a[0] - b[0], a[1] - b[1]) - reach for a, b in combinations(layout.values(), 2)]
    return [gap for gap in gaps if gap < 3e-4]


def test_loosened_racks_have_small_gaps_and_frozen_ones_none():
    for work in breaks(4):
        for layout, _ in work.shots:
            gaps = touching(work, layout)
            assert len(gaps) >= 16
            if "frozen" in work.name:
                assert max(map(abs, gaps)) < 1e-9
            else:
                assert min(gaps) > 0.0
                assert sum(gaps) / len(gaps) == pytest.approx(GAP, rel=0.4)


def test_a_snooker_break_has_all_balls_and_a_free_way_to_the_pack():
    work = next(one for one in breaks(3) if "snooker" in one.name)
    for (layout, strike), trace in zip(work.shots, physics.measure(work, 1)[1], strict=True):
        assert len(layout) == 22
        assert strike.speed == 4.0
        hit = next(e for e in trace.events() if type(e).__name__ == "BallsCollided")
        assert "red" in hit.other


def test_the_same_shots_each_time():
    for make in (lambda: breaks(2), lambda: few(2), lambda: crowds(2)):
        assert [work.shots for work in make()] == [work.shots for work in make()]
    assert random_breaks(5).shots == random_breaks(9).shots[:5]


@pytest.mark.parametrize("python", ["/nowhere/python", sys.executable])
def test_a_peer_that_is_missing_is_told_of_and_how_to_get_it(python):
    with pytest.raises(PeerMissingError, match="pip install pooltool-billiards"):
        ask_peer(python, few(1), 1)


def test_a_missing_peer_ends_the_program_without_a_traceback():
    command = [sys.executable, "-m", "tools.bench", "physics", "--peer-python", "/nowhere/python"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert done.stderr.startswith("no peer: /nowhere/python cannot be run")
    assert done.stdout == ""


def test_the_peer_is_given_our_places_and_the_ball_our_first_velocity(tmp_path):
    heard, fake = tmp_path / "heard.json", tmp_path / "python"
    told = [{"version": "9"}, {"name": "two-ball stroke 1.5 m/s", "times": [3.0], "events": [7]}]
    lines = "\n".join(map(json.dumps, told))
    fake.write_text(f"#!/bin/sh\ncat > {heard}\ncat <<'END'\n{lines}\nEND\n", encoding="utf-8")
    fake.chmod(0o755)
    version, played = ask_peer(str(fake), few(4), 2)
    assert version == "pooltool 9"
    assert played["two-ball stroke 1.5 m/s"].times == (3.0,)
    work, given = few(4)[0], json.loads(heard.read_text())[0]
    layout, strike = work.shots[0]
    assert len(given["shots"]) == 2
    assert given["shots"][0]["layout"] == {str(k): list(at) for k, at in layout.items()}
    body = next(ball for ball in work.world.balls if ball.id == work.ball)
    motion = strike_ball(body, work.world.cue, work.world.cloth, strike, flies=False)
    assert given["shots"][0]["velocity"] == list(motion.velocity)


def test_every_goal_has_its_row(monkeypatch):
    monkeypatch.setattr(physics, "SHOTS", 2)
    chosen = argparse.Namespace(peer_python=None, breaks=3, batch=0, no_starts=True)
    rows = list(physics.rows(chosen))
    names = [str(row["work"]) for row in rows]
    for part in ("9-ball", "8-ball", "frozen rack", "snooker", "two-ball", "three-ball"):
        assert any(part in name for name in names), part
    for count in (2, 9, 16, 22):
        assert any(f"among {count} balls" in name for name in names)
    assert {"positions", "slowest"} <= {name.split()[0] for name in names}
    assert all(row.keys() == rows[0].keys() for row in rows)
    for row in rows:
        if row["goal"]:
            assert row["met"] in ("yes", "no")
