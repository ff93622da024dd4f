"""Many shots at one world, one after the other or on many workers.

One idea: a shot depends on nothing but its world, layout and strike, so shots are dealt out in
runs of neighbours and come back in order. Invariant: the same bits as one by one, whatever the
number of workers. joblib does the dealing, so that its back ends (processes here, or dask and ray
over many machines, chosen with `joblib.parallel_config`) serve without a change.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeVar, overload

from engine.physics.simulate import simulate

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from engine.physics.trace import Trace
    from engine.physics.world import Layout, Strike, World
    from engine.table.furniture import BallId

    Stroke = tuple[Layout, BallId, Strike]

    Kept = TypeVar("Kept")

HELPINGS = 8
"""Runs of shots that each worker is given, so that a slow one does not keep the others waiting."""


@overload
def simulate_batch(
    world: World, shots: Sequence[Stroke], workers: int = ..., keep: None = ...
) -> list[Trace]: ...


@overload
def simulate_batch(
    world: World, shots: Sequence[Stroke], workers: int, keep: Callable[[Trace], Kept]
) -> list[Kept]: ...


def simulate_batch(
    world: World,
    shots: Sequence[Stroke],
    workers: int = 1,
    keep: Callable[[Trace], Kept] | None = None,
) -> list[Trace] | list[Kept]:
    """Return the trace of each shot (layout, ball struck, strike), in order.

    With `keep`, what it makes of each trace is returned instead; it runs where the shot is
    played, so that whole traces need not travel. `workers` is the number of processes; -1 means
    one a core, and all but 1 need joblib, the extra `batch`. Raises what `simulate` raises for
    the first shot that cannot be, and ValueError for 0 workers.
    """
    if workers == 0:
        raise ValueError("a batch needs at least one worker; -1 means one a core")
    if workers == 1 or not shots:
        return _play(world, shots, keep)
    try:
        from joblib import Parallel, delayed, effective_n_jobs  # noqa: PLC0415  an extra
    except ModuleNotFoundError as missing:
        message = "several workers need joblib: pip install '.[batch]', or ask for 1 worker"
        raise ModuleNotFoundError(message, name=missing.name) from missing

    size = max(1, -(-len(shots) // (HELPINGS * effective_n_jobs(workers))))
    runs = [shots[first : first + size] for first in range(0, len(shots), size)]
    played = Parallel(n_jobs=workers)(delayed(_play)(world, run, keep) for run in runs)
    return [kept for run in played for kept in run]


def _play(
    world: World, shots: Sequence[Stroke], keep: Callable[[Trace], Kept] | None
) -> list[Trace] | list[Kept]:
    traces = (simulate(world, layout, ball, strike) for layout, ball, strike in shots)
    return list(traces) if keep is None else [keep(trace) for trace in traces]


__all__ = ["simulate_batch"]
