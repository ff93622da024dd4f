"""The sound of a blow, made of damped tones and a puff of noise.

One idea: what rings is described by a few numbers (pitch, damping, share), so nothing has to be
recorded or shipped. Invariant: a wave starts and ends in silence and never exceeds 1.
"""

from __future__ import annotations

from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np

from engine.app.noises import Kind

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

RATE = 44100
"""Samples a second."""

SEED = 7
"""Of the puffs of noise, so that a ball sounds alike every day."""


@dataclass(frozen=True, slots=True)
class Ring:
    """What rings: `tones` as pitch (Hz), damping (1/s) and share; `puff` the noise's like."""

    length: float
    tones: tuple[tuple[float, float, float], ...]
    puff: tuple[float, float]


RINGS: Mapping[Kind, Ring] = MappingProxyType(
    {
        Kind.TIP: Ring(0.10, ((420.0, 70.0, 0.7), (1150.0, 130.0, 0.4)), (260.0, 0.5)),
        Kind.BALL: Ring(0.09, ((3150.0, 95.0, 0.8), (5100.0, 150.0, 0.5)), (500.0, 0.4)),
        Kind.CUSHION: Ring(0.22, ((95.0, 26.0, 0.9), (210.0, 45.0, 0.4)), (150.0, 0.25)),
        Kind.POCKET: Ring(0.45, ((140.0, 14.0, 0.6), (330.0, 22.0, 0.5)), (16.0, 0.35)),
        Kind.BED: Ring(0.16, ((120.0, 34.0, 0.9), (520.0, 80.0, 0.3)), (200.0, 0.3)),
        Kind.PIN: Ring(0.20, ((1350.0, 36.0, 0.7), (2280.0, 60.0, 0.5)), (180.0, 0.3)),
    }
)


def wave(kind: Kind, rate: int = RATE) -> NDArray[np.float64]:
    """Return the sound of one blow at full loudness, (n,) between -1 and 1."""
    ring = RINGS[kind]
    times = np.arange(round(ring.length * rate)) / rate
    made = np.zeros(len(times))
    for pitch, damping, share in ring.tones:
        made += share * np.exp(-damping * times) * np.sin(2.0 * np.pi * pitch * times)
    damping, share = ring.puff
    chance = np.random.default_rng(SEED).uniform(-1.0, 1.0, len(times))
    made += share * np.exp(-damping * times) * chance
    made *= np.minimum(1.0, times * rate / 24.0) * np.linspace(1.0, 0.0, len(times)) ** 0.5
    loudest: float = np.abs(made).max()
    return made / loudest


__all__ = ["RATE", "RINGS", "Ring", "wave"]
