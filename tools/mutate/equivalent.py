"""Mutants that no test can kill, by hand, each with its reason: equivalent.toml.

One is known by its file, its function and the lines before and after, wherever these have moved to.
"""

from __future__ import annotations

import tomllib
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tools.mutate.mutant import Mutant

LIST = Path(__file__).with_name("equivalent.toml")


@cache
def listed() -> dict[tuple[str, str, str, str], str]:
    """The reason of each."""
    found = tomllib.loads(LIST.read_text(encoding="utf-8")).get("mutant", [])
    return {(each["file"], each["function"], each["before"], each["after"]): each["reason"] for each in found}


def reason(mutant: Mutant) -> str | None:
    """Why a mutant is equivalent; None if nobody said so."""
    return listed().get((mutant.site.path, mutant.site.function, *mutant.lines))


def entry(mutant: Mutant) -> str:
    """What would name it in the list, but for the reason."""
    before, after = mutant.lines
    keys = {"file": mutant.site.path, "function": mutant.site.function, "before": before, "after": after}
    return "\n".join(["[[mutant]]", *(f"{key} = '''{value}'''" for key, value in keys.items()), 'reason = ""', ""])
