"""Chance that comes from a match's seed alone.

One idea: a draw is a function of the seed. Invariant: equal seeds give equal draws, whatever
the process, platform or hash seed.
"""

from __future__ import annotations

from random import Random


def lots(seed: int, most: int) -> tuple[int, ...]:
    """Return the numbers from 1 to `most` in an order drawn from `seed`."""
    numbers = list(range(1, most + 1))
    Random(f"lots {seed}").shuffle(numbers)
    return tuple(numbers)


def draw(seed: int, sides: int) -> int:
    """Return a player number from 1 to `sides`, drawn from `seed`."""
    return Random(f"lot {seed}").randint(1, sides)
