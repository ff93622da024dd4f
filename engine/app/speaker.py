"""The loudspeaker: plays a shot's noises as the showing passes them.

One idea: it follows the session's clock, so slow motion, replays and skips sound as they look.
Invariant: where no sound can be played, everything else goes on as before.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
import pygame

from engine.app.noises import Kind, between, noises_of
from engine.app.session import SHOWING
from engine.app.waves import RATE, wave

if TYPE_CHECKING:
    from engine.app.noises import Noise
    from engine.app.session import Session
    from engine.physics.trace import Trace

LOUD = 0.7
"""The volume where nothing else is said."""

VOICES = 16
"""Noises that can sound at one time."""

MOST_AT_ONCE = 6
"""Noises played for one frame; more cannot be told apart."""


@dataclass(slots=True)
class Speaker:
    """Plays at `volume` (0 to 1); `muted`, or without a device, it is silent."""

    volume: float = LOUD
    muted: bool = False
    _sounds: dict[Kind, pygame.mixer.Sound] = field(default_factory=dict)
    _tried: bool = False
    _trace: Trace | None = None
    _noises: tuple[Noise, ...] = ()

    def follow(self, before: Session, after: Session) -> list[Noise]:
        """Play what the showing passed between two moments; return it."""
        if after.trace is None or after.mode not in SHOWING or self.muted:
            return []
        self._take(after)
        start = before.clock if before.trace is after.trace else -np.inf
        passed = between(self._noises, min(start, after.clock), after.clock)
        for noise in sorted(passed, key=lambda one: -one.loudness)[:MOST_AT_ONCE]:
            self._play(noise)
        return passed

    def _take(self, session: Session) -> None:
        if self._trace is session.trace or session.trace is None:
            return
        last = session.last_stroke
        speed = last.shot.strike.speed if last and last.shot.strike else 0.0
        self._trace = session.trace
        self._noises = noises_of(session.trace.events(), speed)

    def _play(self, noise: Noise) -> None:
        if not self._tried:
            self._tried, self._sounds = True, open_sounds()
        sound = self._sounds.get(noise.kind)
        channel = pygame.mixer.find_channel() if sound else None
        if sound is not None and channel is not None:
            channel.set_volume(self.volume * noise.loudness)
            channel.play(sound)


def open_sounds() -> dict[Kind, pygame.mixer.Sound]:
    """Return a sound for every kind of noise; none where there is no device to play them."""
    try:
        if not pygame.mixer.get_init():
            pygame.mixer.init(RATE, -16, 2, 512)
        pygame.mixer.set_num_channels(VOICES)
        return {kind: _sound(kind) for kind in Kind}
    except pygame.error:
        return {}


def _sound(kind: Kind) -> pygame.mixer.Sound:
    got = pygame.mixer.get_init()
    rate, channels = (got[0], got[2]) if got else (RATE, 2)
    samples = (wave(kind, rate) * 32000).astype(np.int16)
    shaped = samples if channels == 1 else np.repeat(samples[:, None], channels, axis=1)
    return pygame.mixer.Sound(buffer=np.ascontiguousarray(shaped).tobytes())


__all__ = ["LOUD", "Speaker", "open_sounds"]
