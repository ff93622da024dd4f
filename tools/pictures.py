"""The pictures of the documents, and of every game by every renderer: `python -m tools.pictures`.

One idea: a picture's name says what is on it, GAME-RENDERER-CAMERA.png, so that any of them can
be drawn again.
"""

from __future__ import annotations

import argparse
from itertools import product
from pathlib import Path

from engine.app.picture import render_variant
from engine.game.placing import opening_layout
from engine.variant.load import list_variants, load_variant

ROOT = Path(__file__).resolve().parent.parent
IMAGES = ROOT / "docs" / "images"
RENDERERS = ("wireframe", "painter", "scanline")
CAMERAS = ("cue", "above")
README = (
    "eight_ball-scanline-cue",
    "snooker-wireframe-cue",
    "snooker-painter-cue",
    "snooker-scanline-cue",
)
SMALL, LARGE = (960, 540), (1280, 720)


def draw(name: str, folder: Path, size: tuple[int, int]) -> Path:
    """Draw the picture `name` (GAME-RENDERER-CAMERA) into a folder; return its path."""
    game, renderer, camera = name.split("-")
    variant = load_variant(game)
    path = folder / f"{name}.png"
    render_variant(variant, opening_layout(variant), renderer, camera, size, path)
    return path


def main() -> None:
    """Draw the documents' pictures, or all there are into a folder."""
    parser = argparse.ArgumentParser(prog="python -m tools.pictures", description=__doc__)
    parser.add_argument("--all", type=Path, metavar="DIR", help="every game, renderer and camera")
    folder = parser.parse_args().all
    names: tuple[str, ...] = README
    if folder is not None:
        games = [one.name for one in list_variants()]
        names = tuple("-".join(parts) for parts in product(games, RENDERERS, CAMERAS))
    target, size = (IMAGES, SMALL) if folder is None else (folder, LARGE)
    target.mkdir(parents=True, exist_ok=True)
    for name in names:
        print(draw(name, target, size))


if __name__ == "__main__":
    main()
