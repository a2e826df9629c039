"""How the kernels are compiled."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar, cast

import numba

from records.compilation.kernel import cache_on_disk

F = TypeVar("F", bound=Callable[..., Any])

OPTIONS: dict[str, Any] = {
    "nogil": True,
    "error_model": "numpy",
    "fastmath": {"contract"},  # a * b + c in one rounding; nothing else is reordered
    "no_cfunc_wrapper": True,
}


def compiled(function: F) -> F:
    """Compiled inside the entry points, which are what numba caches; not to be called from Python.

    They count no references to arrays, which takes a fifth of the time and makes threads wait for each other: they
    can be given arrays, but make none.
    """
    jit: Any = numba.njit
    return cast(F, jit(**OPTIONS, _nrt=False, no_cpython_wrapper=True)(function))


def inlined(function: F) -> F:
    """Compiled into whoever calls it, for what takes many arrays and is called at every step.

    A call copies every array's fields; without it a march takes two thirds of the time. What it computes is the same,
    but for which products and sums `contract` joins.
    """
    jit: Any = numba.njit
    return cast(F, jit(**OPTIONS, _nrt=False, no_cpython_wrapper=True, forceinline=True)(function))


def reachable(function: F) -> F:
    """Compiled, and open to Python, so that an entry point's `.py_func` can call it."""
    jit: Any = numba.njit
    return cast(F, jit(**OPTIONS, _nrt=False)(function))


def entry(function: F) -> F:
    """An entry point: compiled at its first call, cached on disk, free of the interpreter's lock."""
    jit: Any = numba.njit
    return cache_on_disk(cast(F, jit(**OPTIONS)(function)))
