"""Names of a package that are loaded when they are first used, so that importing the package takes no time."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from importlib import import_module
from typing import Any


def late_names(
    package: str, homes: Mapping[str, Sequence[str]], submodules: Sequence[str] = ()
) -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """Return `__getattr__` and `__dir__` of a package.

    Parameters
    ----------
    package : its name
    homes : the public names by the module that defines them
    submodules : of the package, which are reached without an import of their own
    """
    home = {name: module for module, names in homes.items() for name in names}

    def get(name: str) -> Any:
        if name in home:
            return getattr(import_module(home[name]), name)
        if name in submodules:
            return import_module(f"{package}.{name}")
        known = ", ".join(sorted(home))
        raise AttributeError(f"module {package!r} has no attribute {name!r}; the public names are: {known}")

    return get, lambda: sorted([*home, *submodules])
