"""Painting balls: a colour, a band, dots and a label, as a skin that turns with the ball.

One idea: the label looks out along the ball's own +x and -x with its top to +z; a band runs
round z. Invariant: a ball's paint depends on its kind alone.
"""

from __future__ import annotations

from math import cos, radians, sin
from typing import TYPE_CHECKING

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from engine.scene.shape import Skin, skin_directions

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from engine.scene.shape import Rgb

    Field = NDArray[np.float64]

SIZE = 256
"""Texels along a side of a skin."""
BAND = 0.56
"""Half height of a stripe, in radii."""
LABEL = 0.40
"""Radius of the disc under a label, in radii."""
DOT = 0.2
WHITE: Rgb = (246, 241, 226)
INK: Rgb = (16, 16, 18)
DOT_RED: Rgb = (196, 26, 32)
SOFT = 2.2 / SIZE
"""Half the width of a painted border, in radii."""


def paint_skin(colour: Rgb, pattern: str, label: str) -> Skin | None:
    """Return a ball's skin, or None where it has one colour all over.

    Raises ValueError for a pattern that is not "plain", "stripe" or "dots".
    """
    if pattern not in ("plain", "stripe", "dots"):
        raise ValueError(f"a ball is plain, or has a stripe or dots, not {pattern!r}")
    if pattern == "plain" and not label:
        return None
    own = skin_directions(SIZE)
    paint = np.broadcast_to(np.array(colour, dtype=np.float64), own.shape)
    if pattern == "stripe":
        paint = _over(
            np.broadcast_to(np.array(WHITE, float), own.shape),
            colour,
            _inside(BAND - np.abs(own[..., 2])),
        )
    if pattern == "dots":
        peak = np.abs(own).max(axis=-1)
        away = np.sqrt(np.maximum(1.0 - peak * peak, 0.0))
        paint = _over(paint, _contrast(colour), _inside(DOT - away))
    if label:
        paint = _with_label(paint, own, label)
    return Skin(np.rint(paint).astype(np.uint8))


def _with_label(paint: Field, own: Field, label: str) -> Field:
    away = np.sqrt(own[..., 1] ** 2 + own[..., 2] ** 2)
    paint = _over(paint, WHITE, _inside(LABEL - away))
    side = np.sign(own[..., 0])
    right = own[..., 1] * side / LABEL
    ink = _sample(_draw(label), right, own[..., 2] / LABEL)
    return _over(paint, INK, ink * (away < LABEL))


def _contrast(colour: Rgb) -> Rgb:
    light = 0.3 * colour[0] + 0.6 * colour[1] + 0.1 * colour[2]
    return DOT_RED if light > 110.0 else WHITE


def _inside(distance: Field) -> Field:
    """Return 1 well inside a border, 0 well outside, and a soft step between."""
    return np.clip(distance / (2.0 * SOFT) + 0.5, 0.0, 1.0)


def _over(below: Field, colour: Rgb, share: Field) -> Field:
    mixed: Field = below + (np.array(colour, dtype=np.float64) - below) * share[..., None]
    return mixed


def _draw(label: str, size: int = 192) -> Field:
    """Return the label's ink, 0 to 1, on a square that the disc is drawn about."""
    sheet = Image.new("L", (size, size))
    pen = ImageDraw.Draw(sheet)
    points = size * (0.78 if len(label) == 1 else 0.6 if len(label) == 2 else 0.42)
    font = ImageFont.load_default(points)
    pen.text((size / 2, size / 2), label, fill=255, font=font, anchor="mm", stroke_width=3)
    if label in ("6", "9"):
        pen.rectangle((size * 0.32, size * 0.83, size * 0.68, size * 0.88), fill=255)
    return np.asarray(sheet, dtype=np.float64) / 255.0


def _sample(ink: Field, right: Field, up: Field) -> Field:
    """Return ink at places -1 to 1, mixed from the four nearest texels."""
    size = len(ink)
    x = np.clip((right + 1.0) * 0.5 * size - 0.5, 0.0, size - 1.001)
    y = np.clip((1.0 - up) * 0.5 * size - 0.5, 0.0, size - 1.001)
    i, j = y.astype(int), x.astype(int)
    fy, fx = y - i, x - j
    upper = ink[i, j] * (1.0 - fx) + ink[i, j + 1] * fx
    lower = ink[i + 1, j] * (1.0 - fx) + ink[i + 1, j + 1] * fx
    mixed: Field = upper * (1.0 - fy) + lower * fy
    return mixed


def facing(elevation_deg: float = 58.0) -> NDArray[np.float64]:
    """Return the rotation that turns a label up and towards the head (-x)."""
    c, s = cos(radians(elevation_deg)), sin(radians(elevation_deg))
    pole, top = np.array([-c, 0.0, s]), np.array([s, 0.0, c])
    return np.stack([pole, np.cross(top, pole), top], axis=1)
