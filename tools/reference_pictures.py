"""Reference pictures of the renderers, one feature each: `python -m tools.reference_pictures`.

One idea: a picture is small, shows one feature from near, and is named by it; it was looked at once
and a renderer's picture must stay like it. `--update` draws them anew, and the difference in the
repository is the review. Without it they are compared: which pixels differ is told, and a picture
of the difference is written to `--out`.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PIL import Image

from engine.render.renderer import RENDERERS, make_renderer
from tools.reference_scenes import SCENES, SIZE

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    Bytes = NDArray[np.uint8]

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "tests" / "render" / "reference"
LEVELS = 6
"""Differences of a colour up to this are none."""
SHARE = 0.002
"""So many of the pixels may differ: a border may fall otherwise on another machine."""
FAINT = 4


@dataclass(frozen=True, slots=True)
class Difference:
    """How a picture differs from the one that was looked at.

    `pixels` differ out of `total`; `box` is left, top, right and bottom of them, `worst` the
    greatest difference of a colour. `picture` shows them white on the faint reviewed one.
    """

    pixels: int
    total: int
    worst: int
    box: tuple[int, int, int, int]
    picture: Bytes

    @property
    def matters(self) -> bool:
        """Return whether more differs than may."""
        return self.pixels > SHARE * self.total

    def __str__(self) -> str:
        """Say which pixels differ."""
        left, top, right, bottom = self.box
        return (
            f"{self.pixels} of {self.total} pixels differ, by up to {self.worst} levels,"
            f" between ({left}, {top}) and ({right}, {bottom})"
        )


def file_of(scene: str, renderer: str, folder: Path = FOLDER) -> Path:
    """Return where the picture of a scene by a renderer is kept."""
    return folder / f"{scene}-{renderer}.png"


def picture_of(scene: str, renderer: str) -> Bytes:
    """Return a scene's picture by a renderer, (h, w, 3)."""
    image = np.zeros((SIZE[1], SIZE[0], 3), np.uint8)
    make_renderer(renderer).render(SCENES[scene](), image)
    return image


def compare(reviewed: Bytes, drawn: Bytes) -> Difference:
    """Return how a picture differs from the reviewed one of the same size."""
    away = np.abs(drawn.astype(int) - reviewed).max(axis=2)
    wrong = away > LEVELS
    rows, columns = np.nonzero(wrong)
    box = (0, 0, 0, 0)
    if len(rows):
        box = int(columns.min()), int(rows.min()), int(columns.max()), int(rows.max())
    shown = np.where(wrong[..., None], 255, reviewed // FAINT).astype(np.uint8)
    return Difference(int(wrong.sum()), wrong.size, int(away.max()), box, shown)


def differing(
    scenes: Sequence[str], renderers: Sequence[str], out: Path | None = None
) -> dict[str, Difference]:
    """Return what differs by more than may be, by file name; write pictures of it to `out`.

    Raises FileNotFoundError where a picture was never made.
    """
    found = {}
    for scene in scenes:
        for renderer in renderers:
            path = file_of(scene, renderer)
            difference = compare(np.asarray(Image.open(path)), picture_of(scene, renderer))
            if difference.matters:
                found[path.name] = difference
                if out is not None:
                    out.mkdir(parents=True, exist_ok=True)
                    Image.fromarray(difference.picture).save(out / path.name)
    return found


def update(scenes: Sequence[str], renderers: Sequence[str]) -> int:
    """Draw pictures anew where they differ at all; return how many were written."""
    FOLDER.mkdir(exist_ok=True)
    written = 0
    for scene in scenes:
        for renderer in renderers:
            path, drawn = file_of(scene, renderer), picture_of(scene, renderer)
            if not path.exists() or (np.asarray(Image.open(path)) != drawn).any():
                Image.fromarray(drawn).save(path, optimize=True)
                written += 1
    return written


def main(arguments: Sequence[str] | None = None) -> int:
    """Compare, or update; status 1 where a picture differs."""
    parser = argparse.ArgumentParser(prog="python -m tools.reference_pictures", description=__doc__)
    parser.add_argument(
        "scenes", nargs="*", metavar="FEATURE", help=f"some of: {', '.join(SCENES)}"
    )
    parser.add_argument("--update", action="store_true", help="draw them anew")
    parser.add_argument("--out", type=Path, default=Path("differences"), help="for differences")
    asked = parser.parse_args(arguments)
    unknown = [name for name in asked.scenes if name not in SCENES]
    if unknown:
        parser.error(f"there is no {', '.join(unknown)}")
    scenes = asked.scenes or list(SCENES)
    if asked.update:
        print(f"{update(scenes, RENDERERS)} pictures drawn anew in {FOLDER.relative_to(ROOT)}")
        return 0
    found = differing(scenes, RENDERERS, asked.out)
    for name, difference in found.items():
        print(f"{name}: {difference}; see {asked.out / name}")
    print(f"{len(scenes) * len(RENDERERS) - len(found)} pictures are as they were reviewed")
    return 1 if found else 0


__all__ = ["Difference", "compare", "differing", "file_of", "picture_of", "update"]

if __name__ == "__main__":
    sys.exit(main())
