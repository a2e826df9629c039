"""Which of the other programs are installed, and why one is not."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from importlib import import_module
from importlib.metadata import version
from types import ModuleType


@dataclass(frozen=True)
class Peer:
    """Another program: its module, None where it does not load, with the version or the reason."""

    package: str
    module: ModuleType | None
    said: str


def find(package: str, module: str | None = None) -> Peer:
    """Import a program; one that lacks a library of the system says which."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return Peer(package, import_module(module or package), version(package))
        except Exception as error:  # programs raise what they like when they do not load
            cause: BaseException = error
            while cause.__context__ is not None:
                cause = cause.__context__
            return Peer(package, None, f"{type(cause).__name__}: {cause}")
