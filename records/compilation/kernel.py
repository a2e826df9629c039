"""Machine code kept on disk, so that only the first run of a version compiles.

numba's own cache looks at the file of the function alone: a function or constant of another file, which is compiled
into it, may change unseen, and files of a removed version stay. Here all code is in one folder, named by the hash of
all sources; in it, a file for each entry point and types of its arguments, named by their hash. A file is written
whole, under its name at last, so that processes may write it at once; it begins with the hash of the rest.
"""

from __future__ import annotations

import os
import pickle
import tempfile
from collections.abc import Callable
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any, TypeVar, cast

import llvmlite
import numba
import numpy as np
from numba.core.caching import FunctionCache
from numba.core.compiler import CompileResult
from numba.core.serialize import dumps
from numba.misc.appdirs import AppDirs

from records.compilation import CACHE_NAME, find_folder, sources_key

F = TypeVar("F", bound=Callable[..., Any])

VERSIONS = (numba.__version__, llvmlite.__version__, np.__version__)
DIGEST = 32  # bytes


def cache_on_disk(function: F) -> F:
    """Have what numba compiles of `function` kept; without a place for it, each process compiles for itself."""
    found, dispatcher = _place(), cast(Any, function)
    if found is not None and hasattr(function, "py_func"):  # else numba's compilation is switched off
        dispatcher._cache = KernelCache(dispatcher.py_func, *found)
    return function


def code_folder() -> Path | None:
    """The folder in which machine code is kept; None where there is no place for it."""
    found = _place()
    return None if found is None else found[1]


class KernelCache(FunctionCache):
    """numba's cache of one function, in a folder of ours."""

    def __init__(self, function: Callable[..., Any], key: str, folder: Path) -> None:
        self._py_func, self._key, self._folder = function, key, folder
        self._enabled = True

    @property
    def cache_path(self) -> str:
        """The folder."""
        return str(self._folder)

    def load_overload(self, signature: Any, target: Any) -> Any:
        """What was compiled for `signature`, or None."""
        target.refresh()
        content = _read(self._file(signature, target.codegen())) if self._enabled else None
        return None if content is None else CompileResult._rebuild(target, *pickle.loads(content))

    def save_overload(self, signature: Any, compiled: Any) -> None:
        """Keep what was compiled, unless sources were replaced while they were imported; a full disk is no error."""
        lasting = not compiled.lifted and not compiled.library.has_dynamic_globals
        if self._enabled and lasting and sources_key(VERSIONS) == self._key:
            _write(self._file(signature, compiled.codegen), dumps(compiled._reduce()))

    def flush(self) -> None:
        """Delete what is kept of the function."""
        for path in self._folder.glob(f"{self._stem()}-*.code"):
            path.unlink(missing_ok=True)

    def _file(self, signature: Any, codegen: Any) -> Path:
        describe: Any = self._index_key  # types, processor, byte code
        which = sha256(repr(describe(signature, codegen)).encode())
        return self._folder / f"{self._stem()}-{which.hexdigest()[:32]}.code"

    def _stem(self) -> str:
        return f"{self._py_func.__module__}.{self._py_func.__qualname__}".replace("<locals>", "in")


@cache
def _place() -> tuple[str, Path] | None:
    """The hash of the sources, taken before most of them are imported, and the folder of that name."""
    of = sources_key(VERSIONS)
    user = AppDirs(appname=CACHE_NAME, appauthor=False).user_cache_dir
    folder = find_folder(of, given=os.environ.get("NUMBA_CACHE_DIR", ""), user=user) if of else None
    return (of, folder) if of and folder else None


def _read(path: Path) -> bytes | None:
    """What `_write` wrote; None where there is no such file of the user's, or it is damaged."""
    try:
        with path.open("rb") as file:
            if os.name == "posix" and os.fstat(file.fileno()).st_uid != os.getuid():
                return None
            content = file.read()
    except OSError:
        return None
    digest, rest = content[:DIGEST], content[DIGEST:]
    return rest if sha256(rest).digest() == digest else None


def _write(path: Path, content: bytes) -> None:
    temporary = ""
    try:
        with tempfile.NamedTemporaryFile(dir=path.parent, prefix=f"{path.name}.", delete=False) as file:
            temporary = file.name
            file.write(sha256(content).digest() + content)
        os.replace(temporary, path)
    except OSError:
        if temporary:
            Path(temporary).unlink(missing_ok=True)
