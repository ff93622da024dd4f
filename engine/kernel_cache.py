"""Keeps compiled kernels on disk honest.

One idea: numba compiles a kernel anew when its own file changes, but not when a kernel or a
constant it uses lies in another file that changed. So the text of all files that kernels are made
from is digested, and what was compiled from another text is dropped, to be compiled when it is
next needed. Invariant: nothing but indices of stale kernels is deleted; a cache that cannot be
written is left as it is, and of two processes that share one the worst is a second compilation.
"""

from __future__ import annotations

import re
from contextlib import suppress
from hashlib import sha256
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

KERNEL = re.compile(r"^@(?:njit|kernel)", re.MULTILINE)
IMPORT = re.compile(r"^from (\w+(?:\.\w+)*) import", re.MULTILINE)
STAMP = "kernels.digest"


def drop_stale(cache: Path, sources: Path) -> list[str]:
    """Delete the indices in `cache` that other sources than today's made; return their names.

    `sources` is a package's folder; the kernels are those of its modules that hold `@njit` or
    `@kernel`, and what they are made from is those modules and, followed through their imports, the
    modules of their own top package. Call it before the first kernel runs.
    """
    kernels, digest = _digest(sources)
    stamp = cache / STAMP
    with suppress(OSError):
        if stamp.read_text(encoding="ascii") == digest:
            return []
    dropped = []
    for index in sorted(cache.glob("*.nbi")):
        if index.name.split(".")[0] in kernels:
            with suppress(OSError):
                index.unlink()
                dropped.append(index.name)
    with suppress(OSError):
        cache.mkdir(parents=True, exist_ok=True)
        stamp.write_text(digest, encoding="ascii")
    return dropped


def when_compiling(tell: Callable[[], None]) -> None:
    """Call `tell` when this process first has to compile a kernel, and never again."""
    from numba.core import event  # noqa: PLC0415  slow to import

    class Once(event.Listener):
        told = False

        def on_start(self, _event: object) -> None:
            if not self.told:
                self.told = True
                tell()

        def on_end(self, _event: object) -> None:
            pass

    event.register("numba:compile", Once())  # type: ignore[no-untyped-call]


def _digest(sources: Path) -> tuple[set[str], str]:
    """Return the names of the modules with kernels, and a digest of all they are made from."""
    texts = {path: path.read_text(encoding="utf-8") for path in sources.glob("*.py")}
    kernels = [path for path, text in texts.items() if KERNEL.search(text)]
    root = sources
    while (root.parent / "__init__.py").exists():
        root = root.parent
    found: dict[Path, str] = {}
    pending = list(kernels)
    while pending:
        path = pending.pop()
        if path in found or not path.exists():
            continue
        found[path] = texts[path] if path in texts else path.read_text(encoding="utf-8")
        pending += [_file(root, name) for name in IMPORT.findall(found[path])]
    total = sha256()
    for path in sorted(found):
        total.update(path.relative_to(root.parent).as_posix().encode())
        total.update(found[path].encode())
    return {path.stem for path in kernels}, total.hexdigest()


def _file(root: Path, module: str) -> Path:
    return root.parent.joinpath(*module.split(".")).with_suffix(".py")


__all__ = ["drop_stale", "when_compiling"]
