"""Keeps compiled kernels on disk honest.

One idea: numba compiles a kernel anew when its own file changes, but not when a kernel it calls
lies in another file that changed. So whatever was compiled before the newest source here was
written is dropped, and compiled when it is next needed.
"""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path


def drop_stale(cache: Path, sources: Path) -> list[str]:
    """Delete the indices in `cache` that are older than the newest source; return their names.

    Only modules with kernels in the folder `sources` count. A cache that cannot be read
    or written is left as it is.
    """
    modules = {
        path.stem: path.stat().st_mtime
        for path in sources.glob("*.py")
        if "@njit" in path.read_text(encoding="utf-8")
    }
    newest = min(max(modules.values(), default=0.0), time.time())
    dropped = []
    for index in sorted(cache.glob("*.nbi")):
        if index.name.split(".")[0] not in modules:
            continue
        try:
            if index.stat().st_mtime < newest:
                index.unlink()
                dropped.append(index.name)
        except OSError:
            continue
    return dropped
