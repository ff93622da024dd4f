"""Events as text: what is written is read back, and what is no event is refused."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.game.phrases import PhraseError, format_event, parse_event
from rulelang import events as told

NAMES = st.sampled_from(["cue", "8", "red-1", "red-15", "white", "hole-200", "zone-head-left"])
TIMES = st.none() | st.integers(0, 10**9).map(lambda ticks: ticks / 10**6)
EVENTS = st.one_of(
    st.builds(told.BallsHit, NAMES, st.lists(NAMES, min_size=1, max_size=3).map(tuple), TIMES),
    st.builds(told.CushionHit, NAMES, NAMES, TIMES),
    st.builds(told.CushionLeft, NAMES, NAMES, TIMES),
    st.builds(told.JawHit, NAMES, NAMES, TIMES),
    st.builds(told.OutsideHit, NAMES, TIMES),
    st.builds(told.Pocketed, NAMES, NAMES, TIMES),
    st.builds(told.Rebounded, NAMES, NAMES, TIMES),
    st.builds(told.Settled, NAMES, NAMES, st.integers(0, 9999).map(lambda n: n / 100), TIMES),
    st.builds(told.LeftTable, NAMES, TIMES),
    st.builds(told.LineCrossed, NAMES, NAMES, TIMES),
    st.builds(told.ZoneEntered, NAMES, NAMES, TIMES),
    st.builds(told.ZoneLeft, NAMES, NAMES, TIMES),
    st.builds(told.JumpedOver, NAMES, NAMES, TIMES),
    st.builds(told.PinToppled, st.lists(NAMES, min_size=1, max_size=2).map(tuple), NAMES, TIMES),
    st.builds(told.PinTouched, NAMES, NAMES, TIMES),
    st.builds(told.PinLeaned, NAMES, NAMES, TIMES),
    st.builds(told.TipHitAgain, NAMES, TIMES),
    st.builds(told.TipFollowed, NAMES, TIMES),
    st.builds(told.PlayerTouched, NAMES, TIMES),
    st.builds(told.FootLifted, TIMES),
    st.builds(told.PlayedTooSoon, TIMES),
    st.builds(told.StrokeOmitted, TIMES),
    st.builds(told.TimeCalled, TIMES),
)


@given(EVENTS)
def test_every_event_is_read_back_as_it_was_written(event):
    assert parse_event(format_event(event)) == event


@pytest.mark.parametrize(
    ("text", "event"),
    [
        ("cue hits 8", told.BallsHit("cue", ("8",))),
        ("cue hits red-1 and red-2 at 0.4 s", told.BallsHit("cue", ("red-1", "red-2"), 0.4)),
        ("5 hits cushion foot", told.CushionHit("5", "foot")),
        ("5 leaves cushion foot", told.CushionLeft("5", "foot")),
        ("5 leaves table", told.LeftTable("5")),
        ("5 leaves kitchen", told.ZoneLeft("5", "kitchen")),
        ("5 settles foot-left after 3 s", told.Settled("5", "foot-left", 3.0)),
        ("red and white topple left-pin", told.PinToppled(("red", "white"), "left-pin")),
        ("tip hits cue again", told.TipHitAgain("cue")),
        ("foot off floor", told.FootLifted()),
    ],
)
def test_sentences(text, event):
    assert parse_event(text) == event


@pytest.mark.parametrize(
    "text",
    [
        "cue  hits 8",
        "cue hit 8",
        "Cue hits 8",
        "cue hits cushion",
        "8 pocketed",
        "",
        "cue hits 8 at 1s",
    ],
)
def test_what_is_no_event_is_refused_with_a_mend(text):
    with pytest.raises(PhraseError) as caught:
        parse_event(text)
    assert "cue hits 8" in caught.value.mend
