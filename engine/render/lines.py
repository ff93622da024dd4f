"""Polylines as segments in a row."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from engine.scene.shape import Polyline

if TYPE_CHECKING:
    from collections.abc import Iterable

    from engine.render.arrays import Bytes, Floats
    from engine.scene.scene import GameObject


@dataclass(frozen=True, slots=True, eq=False)
class Lines:
    """Segments in a row: ends (n, 2, 3), colours (n, 3), widths in m, alphas."""

    ends: Floats
    colours: Bytes
    widths: Floats
    alphas: Floats

    def __len__(self) -> int:
        """Return the number of segments."""
        return len(self.ends)


def lines_of(objects: Iterable[GameObject]) -> Lines:
    """Return the polylines of objects."""
    ends, colours, widths, alphas = [], [], [], []
    for thing in objects:
        for shape in thing.shapes:
            if isinstance(shape, Polyline) and len(shape.points) > 1:
                placed = shape.points @ thing.rotation.T + np.array(thing.position)
                ends.append(np.stack([placed[:-1], placed[1:]], axis=1))
                count = len(placed) - 1
                colours += [shape.colour] * count
                widths += [shape.width] * count
                alphas += [shape.alpha] * count
    return Lines(
        np.concatenate(ends).astype(np.float64) if ends else np.zeros((0, 2, 3)),
        np.array(colours, dtype=np.uint8).reshape(-1, 3),
        np.array(widths, dtype=np.float64),
        np.array(alphas, dtype=np.float64),
    )
