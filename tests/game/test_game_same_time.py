"""When two hits are one event: a variant says how near in time nobody can tell them apart."""

from types import SimpleNamespace

import pytest

from engine.game.observe import _contacts
from engine.game.phrases import format_event
from engine.physics.events import BallsCollided, CushionHit
from engine.variant.load import check_variant, load_variant

HITS = [
    BallsCollided(0.5, "cue", "red-1", 1.0),
    BallsCollided(0.5004, "cue", "red-2", 1.0),
    CushionHit(0.9, "red-1", "foot", 1.0),
    BallsCollided(0.9001, "cue", "red-3", 1.0),
]


def told(same_time):
    trace = SimpleNamespace(events=lambda: HITS)
    return [format_event(event).split(" at ")[0] for event in _contacts(trace, "cue", same_time)]


@pytest.mark.parametrize(
    ("same_time", "first"),
    [(1e-9, ["cue hits red-1", "cue hits red-2"]), (1e-3, ["cue hits red-1 and red-2"])],
)
def test_hits_that_nobody_can_tell_apart_are_one(same_time, first):
    assert told(same_time) == [*first, "red-1 hits cushion foot", "cue hits red-3"]


def test_a_variant_says_how_near(tmp_path):
    path = tmp_path / "near.toml"
    path.write_text('extends = "snooker"\nsame_time = 0.001\n', encoding="utf-8")
    assert load_variant(path).same_time == 0.001
    assert load_variant("snooker").same_time == 1e-9
    path.write_text('extends = "snooker"\nsame_time = 1\n', encoding="utf-8")
    (found,) = check_variant(path)
    assert (found.code, found.line) == ("V105", 2)
