"""Compiling the kernels of a first shot, in two processes at once.

One idea: compiled kernels are kept one by one on disk, so two processes that compile different
ones share the work, and whoever needs them all then finds them there. Invariant: what is compiled
does not depend on who compiles it; where no second process can be had, one does it all, and a
second process that fails or is late costs time alone.
"""

from __future__ import annotations

import os
import sys
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import subprocess
    from collections.abc import Callable, Iterator

PATIENCE = 120.0
"""How long (s) the second process is waited for."""

SHARES = ("meeting", "flying")
"""What a second process can be asked to compile."""


def prepare(progress: Callable[[str], None] | None = None) -> None:
    """Compile what the first shot needs and is not on disk; `progress` hears of it."""
    from engine.physics.stepwise import run  # noqa: PLC0415  numba

    if is_kept(run):
        return
    if progress is not None:
        progress("compiling the physics (once per installation, some seconds)")
    helper = start("meeting") if (os.cpu_count() or 1) > 1 else None
    try:
        for function, types in _foreseeing():
            function.compile(types)
    finally:
        if helper is not None:
            _wait(helper)


def prepare_behind() -> None:
    """Let another process compile the kernel of balls in flight, if it is not on disk."""
    from engine.physics.flight import run_flying  # noqa: PLC0415  numba

    if not is_kept(run_flying):
        start("flying")


def flies_at_once() -> bool:
    """Say whether a ball can fly without anything being compiled first."""
    from engine.physics.flight import run_flying  # noqa: PLC0415  numba

    return is_kept(run_flying)


def is_kept(function: Callable[..., object]) -> bool:
    """Say whether a kernel has been compiled before; what is stale has been dropped."""
    kernel: Any = function
    name = f"{kernel.py_func.__module__.rpartition('.')[2]}.{kernel.py_func.__qualname__}-*.nbi"
    return any(Path(str(kernel.stats.cache_path)).glob(name))


def start(share: str) -> subprocess.Popen[bytes] | None:
    """Let another process compile a share; None where there can be none."""
    import subprocess  # noqa: PLC0415  not needed once all is compiled

    root = Path(__file__).parents[2]
    paths = [str(root), *filter(None, [os.environ.get("PYTHONPATH")])]
    with suppress(OSError):
        return subprocess.Popen(  # noqa: S603  this very program
            [sys.executable, "-m", "engine.physics.prepare", share],
            env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
    return None


def _wait(helper: subprocess.Popen[bytes]) -> None:
    import subprocess  # noqa: PLC0415  not needed once all is compiled

    try:
        helper.wait(PATIENCE)
    except subprocess.TimeoutExpired:
        helper.kill()


def compile_share(share: str) -> None:
    """Compile a share (of SHARES) in this process."""
    for function, types in _meeting() if share == "meeting" else _flying():
        function.compile(types)


def _types() -> tuple[Any, ...]:
    """Return numba's types of a number, a count, a row, a table and a row of counts."""
    from numba import float64, int64, types  # noqa: PLC0415  slow to import

    return (
        float64,
        int64,
        types.Array(float64, 1, "C"),
        types.Array(float64, 2, "C"),
        types.Array(int64, 1, "C"),
    )


def _foreseeing() -> Iterator[tuple[Any, tuple[Any, ...]]]:
    """Yield the kernels that say what comes next, of noses, and the lesser ones, with arguments."""
    from engine.physics.foresee import foresee, next_event  # noqa: PLC0415  numba
    from engine.physics.rebound import meet_nose  # noqa: PLC0415  numba
    from engine.physics.record import arrange  # noqa: PLC0415  numba

    number, count, row, table, counts = _types()
    yield foresee, (table, counts, table, table, table, table, count, number, row)
    yield meet_nose, (row, row, row, number, number)
    yield next_event, (table, counts, table)
    yield arrange, (table, counts, table, counts, number, table)


def _meeting() -> Iterator[tuple[Any, tuple[Any, ...]]]:
    """Yield the kernels of balls that meet or change their motion."""
    from engine.physics.record import change  # noqa: PLC0415  numba
    from engine.physics.stepwise import meet_balls  # noqa: PLC0415  numba

    number, count, row, table, counts = _types()
    written = (table, table, counts)
    yield meet_balls, (table, counts, row, *written, counts, table, count, count, number)
    yield change, (table, counts, row, table, table, counts, count)


def _flying() -> Iterator[tuple[Any, tuple[Any, ...]]]:
    from engine.physics.flight import run_flying  # noqa: PLC0415  numba

    number, _, row, table, counts = _types()
    world = (table, counts, row, table, table, table, table)
    yield run_flying, (*world, table, table, counts, row, number)


if __name__ == "__main__":
    compile_share(sys.argv[1])


__all__ = [
    "SHARES",
    "compile_share",
    "flies_at_once",
    "is_kept",
    "prepare",
    "prepare_behind",
    "start",
]
