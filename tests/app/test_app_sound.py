"""What is heard: every blow once, as loud as it is fast, and nothing where nothing can be."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pygame
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.app import commands, speaker
from engine.app.noises import Kind, Noise, between, noises_of
from engine.app.session import Mode
from engine.app.speaker import Speaker, open_sounds
from engine.app.steps import act, pass_time
from engine.app.waves import RINGS, wave
from engine.physics import events as seen


def test_each_event_has_its_own_noise():
    events = (
        seen.BallsCollided(0.1, "a", "b", 2.0),
        seen.CushionHit(0.2, "a", "head", 1.0),
        seen.JawHit(0.3, "a", "corner", 1.0),
        seen.BallPocketed(0.4, "b", "corner"),
        seen.BallLanded(0.5, "a", 1.0),
        seen.PinToppled(0.6, "p", ("a",)),
        seen.RollingBegan(0.7, "a"),
        seen.BallStopped(0.8, "a"),
    )
    heard = [one.kind for one in noises_of(events, 3.0)]
    assert heard == [
        Kind.TIP,
        Kind.BALL,
        Kind.CUSHION,
        Kind.CUSHION,
        Kind.POCKET,
        Kind.BED,
        Kind.PIN,
    ]


def test_faster_is_louder_up_to_the_full_loudness():
    speeds = (0.01, 0.5, 2.0, 6.0, 20.0)
    loud = [noises_of((seen.BallsCollided(1.0, "a", "b", v),), 1.0)[1].loudness for v in speeds[1:]]
    assert loud == sorted(loud)
    assert loud[-1] == loud[-2] == 1.0
    assert len(noises_of((seen.BallsCollided(1.0, "a", "b", 0.002),), 1.0)) == 1


@given(
    st.lists(st.floats(0.0, 10.0), max_size=20),
    st.lists(st.floats(0.0, 10.0), max_size=20),
)
def test_no_noise_is_lost_or_doubled_between_frames(times, cuts):
    noises = [Noise(time, Kind.BALL, 1.0) for time in times]
    edges = [-0.3, *sorted(cuts), 10.0]
    heard = [one for a, b in pairwise(edges) for one in between(noises, a, b)]
    assert sorted(one.time for one in heard) == sorted(times)


@pytest.mark.parametrize("kind", Kind)
def test_a_wave_fades_and_never_clips(kind):
    made = wave(kind)
    assert np.abs(made).max() == 1.0
    assert abs(made[0]) < 1e-12
    assert abs(made[-1]) < 1e-3
    assert np.abs(made[-len(made) // 8 :]).max() < 0.2
    assert np.array_equal(made, wave(kind))


def test_every_kind_rings_in_its_own_way():
    assert set(RINGS) == set(Kind)
    assert len({wave(kind).tobytes() for kind in Kind}) == len(Kind)


@pytest.fixture
def struck(start):
    session = start("three_cushion")
    while session.mode is not Mode.AIMING:
        session = act(session, commands.Confirm())
    return act(act(session, commands.SetSpeed(4.0)), commands.Confirm())


def test_the_speaker_hears_the_whole_shot_once(struck, monkeypatch):
    monkeypatch.setattr(speaker, "open_sounds", dict)
    heard = []
    loud, session = Speaker(), struck
    while session.mode in (Mode.STRIKING, Mode.ROLLING):
        after = pass_time(session, 1.0 / 60.0)
        heard += loud.follow(session, after)
        session = after
    known = noises_of(struck.trace.events(), struck.last.shot.strike.speed)
    assert len(known) > 3
    assert heard == [one for one in known if one.time < struck.trace.duration - 1.0 / 60.0]


def test_a_muted_speaker_plays_nothing(struck):
    quiet = Speaker(muted=True)
    assert quiet.follow(struck, replace(struck, clock=3.0, mode=Mode.ROLLING)) == []


@pytest.mark.xdist_group("window")
def test_sounds_open_with_a_device_and_without():
    pygame.mixer.quit()
    assert set(open_sounds()) == set(Kind)
    pygame.mixer.quit()


@pytest.mark.xdist_group("window")
def test_no_device_is_no_trouble(monkeypatch):
    def refuse(*_args):
        raise pygame.error("no device")

    monkeypatch.setattr(pygame.mixer, "get_init", lambda: None)
    monkeypatch.setattr(pygame.mixer, "init", refuse)
    assert open_sounds() == {}
