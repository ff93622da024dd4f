"""How hot functions are compiled: once, to machine code, kept on disk.

One idea: numba counts references to arrays at every call and every row, with atomic operations
that cost more than the arithmetic; a kernel that makes no array needs no counting, so it is
compiled without (its caller keeps the arrays alive). One that makes arrays says so. A kernel whose
name begins with an underscore is called by kernels alone and has no entrance from Python.
Invariant: neither lets the compiler reorder floating-point arithmetic, and dividing by zero gives
inf or nan.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar

from numba import njit

if TYPE_CHECKING:
    from collections.abc import Callable

    Function = TypeVar("Function", bound=Callable[..., object])


def kernel(function: Function) -> Function:
    """Compile a function that makes no array and returns none."""
    return _compiled(function, counting=False)


def kernel_with_arrays(function: Function) -> Function:
    """Compile a function that makes arrays, or calls one that does and is no kernel itself."""
    return _compiled(function, counting=True)


def _compiled(function: Function, *, counting: bool) -> Function:
    # the last are not in the types that numba tells of itself
    options: dict[str, Any] = {
        "cache": True,
        "error_model": "numpy",
        "_nrt": counting,
        "no_cfunc_wrapper": True,
        "no_cpython_wrapper": function.__name__.startswith("_"),
    }
    compiled: Function = njit(**options)(function)
    return compiled


__all__ = ["kernel", "kernel_with_arrays"]
