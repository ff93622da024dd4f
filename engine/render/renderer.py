"""What a renderer is, and the three of them by name.

Invariant: every renderer draws the same scene; switching changes the manner and nothing else.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Callable

    from engine.render.image import Picture
    from engine.scene.scene import Scene

RENDERERS = ("wireframe", "painter", "scanline")


class Renderer(Protocol):
    """Draws scenes into pictures."""

    def render(self, scene: Scene, image: Picture) -> None:
        """Draw `scene` over the whole of `image`: (h, w) uint32 or (h, w, 3 or 4) uint8."""

    def warm_up(self, progress: Callable[[str, float], None] | None = None) -> None:
        """Compile or load what is needed; tell `progress` what is done, and its share 0 to 1."""


def make_renderer(name: str) -> Renderer:
    """Return a new renderer by name; raises ValueError for a name that is not known.

    Only the one that is asked for is imported, so that wireframe starts at once.
    """
    if name in RENDERERS:
        from engine.kernel_cache import drop_stale  # noqa: PLC0415
        from engine.render import line_kernels  # noqa: PLC0415

        cache = Path(str(line_kernels.draw_strokes.stats.cache_path))
        drop_stale(cache, Path(__file__).parent)
    if name == "wireframe":
        from engine.render.wireframe import Wireframe  # noqa: PLC0415

        return Wireframe()
    if name == "painter":
        from engine.render.painter import Painter  # noqa: PLC0415

        return Painter()
    if name == "scanline":
        from engine.render.scanline import Scanline  # noqa: PLC0415

        return Scanline()
    raise ValueError(f"there is no renderer {name!r}; choose from {', '.join(RENDERERS)}")
