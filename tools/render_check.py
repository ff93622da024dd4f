"""Whether the renderers are right, at length: `python -m tools.render_check [--layouts N]`.

One idea: every claim about the renderers is a number that is counted here over many pictures, and
the tests count the same over a few. Claims: no holes and no double hits; one, two and three threads
give the same pixels, and so do a kept table and a full redraw; the painter's picture is that of a
z-buffer with one light a face, but for at most `STANDARD` of the pixels in the standard poses and
`WORST` in the worst random layout.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import dataclass
from time import perf_counter
from typing import TYPE_CHECKING

import numpy as np

from engine.render import raster
from engine.render.painter import Painter
from engine.render.scanline import Scanline
from engine.render.wireframe import Wireframe
from engine.variant.load import list_variants
from tools.render_scenes import (
    POSES,
    TABLES,
    WIDE,
    bare,
    draw,
    make_stage,
    random_scene,
    scatter,
    standard_scene,
    variant_scene,
)

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Sequence

    from numpy.typing import NDArray

    from engine.scene.scene import Scene
    from engine.stage.stage import Stage

    Doubles = NDArray[np.float64]

STANDARD = 1e-4
WORST = 5e-4
KINDS = (Wireframe, Painter, Scanline)
ROUNDING = 1
CORNERS = 5e-5
MESH: tuple[int, int] = (400, 300)
"""Width and height of the pictures in which hits are counted."""


@dataclass(frozen=True, slots=True)
class Count:
    """What was looked at, how much of it, and what was found wrong; `limit` may be wrong."""

    claim: str
    looked_at: str
    wrong: float
    limit: float = 0.0

    @property
    def holds(self) -> bool:
        """Return whether the claim holds."""
        return self.wrong <= self.limit


def crumpled(seed: int, size: tuple[int, int] = MESH) -> Doubles:
    """Return a random mesh of triangles (n, 3, 2) in pixels that covers a picture once.

    One in four has its corners right on the middles of pixels.
    """
    dice = np.random.default_rng(seed)
    columns, rows = int(dice.integers(3, 40)), int(dice.integers(3, 40))
    xs, ys = np.linspace(-2, size[0] + 2, columns), np.linspace(-2, size[1] + 2, rows)
    grid = np.stack(np.meshgrid(xs, ys), axis=-1)
    shift = 0.18 * np.array([xs[1] - xs[0], ys[1] - ys[0]])
    grid[1:-1, 1:-1] += dice.uniform(-1, 1, grid[1:-1, 1:-1].shape) * shift
    if seed % 4 == 0:
        grid = np.round(grid) + 0.5
    a, b, c, d = grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]
    halves = [np.stack([a, b, c], axis=2), np.stack([c, d, a], axis=2)]
    found: Doubles = np.concatenate([half.reshape(-1, 3, 2) for half in halves])
    return np.round(found * raster.SNAP) / raster.SNAP


def count_hits(triangles: Doubles, size: tuple[int, int] = MESH) -> NDArray[np.int32]:
    """Return how often each pixel is filled: one fills alone, two leave their mark by twos."""
    total = np.zeros(size[::-1], np.int32)
    one = np.zeros(size[::-1], np.uint32)
    box = (0, 0, *size)
    for corners in triangles.reshape(-1, 6):
        low = np.clip(corners.reshape(3, 2).min(axis=0).astype(int) - 1, 0, size)
        high = np.clip(corners.reshape(3, 2).max(axis=0).astype(int) + 2, 0, size)
        part = slice(low[1], high[1]), slice(low[0], high[0])
        raster.fill_flat(one, box, tuple(corners.tolist()), np.uint32(1), 1.0)
        total[part] += one[part].astype(np.int32)
        one[part] = 0
    return total


def check_fill(meshes: int) -> Iterator[Count]:
    """Count pixels of random meshes that are not hit exactly once."""
    wrong = 0
    for seed in range(meshes):
        wrong += int((count_hits(crumpled(seed)) != 1).sum())
    pixels = meshes * MESH[0] * MESH[1] / 1e6
    yield Count("each pixel of a mesh is hit once", f"{pixels:.1f} million pixels", wrong)


def check_surfaces(stages: dict[str, Stage], layouts: int) -> Iterator[Count]:
    """Find the share of pixels where surfaces filled by their borders are not their triangles.

    Spans begin elsewhere, which may round a colour by one, and a depth at a corner's pixel.
    """
    shares = []
    surfaces, triangles = Scanline(1, keeps=False), Scanline(1, keeps=False, surfaces=False)
    for scene in _random_scenes(stages, layouts):
        one, two = (_parts(draw(kind, scene, WIDE)) for kind in (surfaces, triangles))
        shares.append(float((np.abs(one - two) > ROUNDING).any(axis=2).mean()))
    claim = "a surface is its triangles, worst share of pixels"
    yield Count(claim, f"{layouts} layouts", max(shares), CORNERS)


def _parts(pixels: NDArray[np.uint32]) -> NDArray[np.int64]:
    return pixels.view(np.uint8).reshape(*pixels.shape, 4).astype(np.int64)


def check_threads(scenes: Sequence[Scene]) -> Iterator[Count]:
    """Count pixels that differ with the number of threads."""
    for kind in KINDS:
        one, two, three = (kind(threads, keeps=False) for threads in (1, 2, 3))
        wrong = 0
        for scene in scenes:
            first = draw(one, scene)
            wrong += sum(int((draw(other, scene) != first).sum()) for other in (two, three))
        yield Count(f"threads do not matter to {kind.__name__}", f"{len(scenes)} scenes", wrong)


def check_kept(stages: dict[str, Stage], layouts: int) -> Iterator[Count]:
    """Count pixels of a table kept while the camera rested that a redraw has otherwise."""
    for kind in KINDS:
        keeping, fresh = kind(2), kind(1, keeps=False)
        wrong = 0
        for seed in range(layouts):
            stage = list(stages.values())[seed // 4 % len(stages)]
            first = random_scene(stage, seed // 4)
            scene = stage.scene(scatter(stage, seed), first.camera)
            wrong += int((draw(keeping, scene) != draw(fresh, scene)).sum())
        what = f"{layouts} layouts, 4 to a camera"
        yield Count(f"a kept table is a full redraw with {kind.__name__}", what, wrong)


def differing(painter: Painter, depth: Scanline, scene: Scene) -> float:
    """Return the share of pixels where the painter's picture is not that of a z-buffer."""
    plain = bare(scene)
    return float((draw(painter, plain, WIDE) != draw(depth, plain, WIDE)).mean())


def check_painter(stages: dict[str, Stage], layouts: int) -> Iterator[Count]:
    """Find the greatest share of pixels that the painter has otherwise than a z-buffer."""
    painter, depth = Painter(2, keeps=False), Scanline(2, flat=True, keeps=False)

    def worst(scenes: Iterable[Scene]) -> float:
        return max(differing(painter, depth, scene) for scene in scenes)

    poses = [standard_scene(stage, pose) for stage in stages.values() for pose in POSES]
    claim = "painter's against a z-buffer, worst share of pixels"
    yield Count(claim, f"{len(poses)} standard poses", worst(poses), STANDARD)
    names = [one.name for one in list_variants()]
    found = worst(variant_scene(name) for name in names)
    yield Count(claim, f"{len(names)} variants' tables", found, STANDARD)
    yield Count(claim, f"{layouts} layouts", worst(_random_scenes(stages, layouts)), WORST)


def _random_scenes(stages: dict[str, Stage], layouts: int) -> Iterator[Scene]:
    made = list(stages.values())
    for seed in range(layouts):
        yield random_scene(made[seed % len(made)], seed)


def check_all(layouts: int) -> Iterator[Count]:
    """Yield every count, with so many random layouts."""
    stages = {name: make_stage(build()) for name, build in TABLES.items()}
    few = max(layouts // 10, 4)
    poses = [standard_scene(stage, pose) for stage in stages.values() for pose in POSES]
    several = [*poses, *_random_scenes(stages, few)]
    parts: tuple[Callable[[], Iterator[Count]], ...] = (
        lambda: check_fill(few),
        lambda: check_surfaces(stages, few),
        lambda: check_threads(several),
        lambda: check_kept(stages, layouts),
        lambda: check_painter(stages, layouts),
    )
    for part in parts:
        yield from part()


def main(arguments: Sequence[str] | None = None) -> int:
    """Print every count; status 1 where a claim does not hold."""
    parser = argparse.ArgumentParser(prog="python -m tools.render_check", description=__doc__)
    parser.add_argument("--layouts", type=int, default=1000, help="random layouts (1000)")
    asked = parser.parse_args(arguments)
    start, failed = perf_counter(), 0
    for count in check_all(asked.layouts):
        failed += not count.holds
        said = "holds" if count.holds else "FAILS"
        print(
            f"{said}  {count.claim}: {count.looked_at}, {count.wrong:g} wrong"
            f" (at most {count.limit:g})  [{perf_counter() - start:.0f} s]",
            flush=True,
        )
    return 1 if failed else 0


__all__ = ["Count", "check_all", "count_hits", "crumpled", "differing"]

if __name__ == "__main__":
    sys.exit(main())
