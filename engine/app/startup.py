"""What must be ready before the first shot: kernels compiled or loaded, off the main thread.

One idea: the window is there at once and says what goes on; wireframe and the physics come
first, the other renderers follow while the game is already played.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from threading import Thread
from time import monotonic
from typing import TYPE_CHECKING

from engine.render.renderer import RENDERERS, make_renderer

if TYPE_CHECKING:
    from collections.abc import Callable

    from engine.render.renderer import Renderer

LONG = 2.0
"""Seconds after which a start is no longer one that finds everything ready."""


@dataclass(slots=True)
class Startup:
    """How far the preparation has come; written by one thread, read by another."""

    wanted: str
    saying: str = "starting"
    share: float = 0.0
    playable: bool = False
    renderers: dict[str, Renderer] = field(default_factory=dict)
    trouble: BaseException | None = None
    began: float = field(default_factory=monotonic)
    _thread: Thread | None = None

    def begin(self) -> None:
        """Start preparing."""
        self._thread = Thread(target=self._run, name="preparing", daemon=True)
        self._thread.start()

    @property
    def is_first(self) -> bool:
        """Whether this takes so long that it must be the first start of an installation."""
        return monotonic() - self.began > LONG

    def join(self) -> None:
        """Wait until everything is ready."""
        if self._thread is not None:
            self._thread.join()

    def _run(self) -> None:
        try:
            self._prepare()
        except BaseException as trouble:  # noqa: BLE001  raised again where it can be told
            self.trouble = trouble

    def _prepare(self) -> None:
        from engine.physics.simulate import (  # noqa: PLC0415  numba is slow to import
            warm_up,
            warm_up_behind,
        )

        self._warm("wireframe", 0.0, 0.2)
        self.saying, self.share = "preparing the physics ...", 0.2
        warm_up(None)
        warm_up_behind()
        self.share, self.playable = 0.7, self.is_first
        rest = sorted((name for name in RENDERERS if name != "wireframe"), key=self._later)
        if self.wanted == rest[0]:
            self._warm(rest.pop(0), 0.7, 1.0)
        self.saying, self.share, self.playable = "", 1.0, True
        for name in rest:
            self._warm(name, 1.0, 1.0)
        self.saying = ""

    def _later(self, name: str) -> bool:
        return name != self.wanted

    def _warm(self, name: str, start: float, end: float) -> None:
        self.saying = f"preparing the {name} renderer ..."
        renderer = make_renderer(name)
        renderer.warm_up(self._progress(start, end))
        self.renderers[name] = renderer

    def _progress(self, start: float, end: float) -> Callable[[str, float], None]:
        def told(_what: str, share: float) -> None:
            self.share = start + (end - start) * share

        return told

    def pick(self, name: str) -> Renderer | None:
        """Return the renderer of a name, or one that is ready, or None."""
        return self.renderers.get(name) or next(iter(self.renderers.values()), None)
