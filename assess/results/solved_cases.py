"""What each solved case of the program exercises, and which of them concern a project."""

from __future__ import annotations

import tomllib
from collections.abc import Collection, Mapping
from functools import cache
from pathlib import Path

from assess.results.uses import JOINTS, KINDS, ORDINARY

CASES = Path(__file__).parents[1] / "verification" / "cases"
"""The folder of the program's solved cases, one TOML file for each; project files stand beside them."""
OF_A_CASE = frozenset({"source", "solver", "quantities"})
"""Keys of which a case has one and a project file none."""


@cache
def exercised_by_case() -> Mapping[str, frozenset[str]]:
    """Return what each of the program's cases exercises, by key, read once in a process."""
    found = {}
    for path in sorted(CASES.rglob("*.toml")):
        text = path.read_text(encoding="utf-8")
        if "quantities" in text:  # a third of the files are projects, and parsing takes long
            content = tomllib.loads(text)
            if OF_A_CASE & content.keys():
                found[path.relative_to(CASES).with_suffix("").as_posix()] = frozenset(content["uses"])
    return found


def keys_for(exercised: Mapping[str, Collection[str]], uses: Collection[str]) -> frozenset[str]:
    """Return the keys of the cases that concern a project.

    A case is chosen where it shares with the project anything but what is ordinary, such as a procedure, a spectrum, a
    motion or a load; where it exercises a kind of mechanism of the project with one of its kinds of joint, and nothing
    out of the ordinary that the project does not use; or where no case chosen so far exercises what it shares.

    Parameters
    ----------
    exercised : by each case, by key
    uses : of the project; both in the words of `assess.results.uses`
    """
    used = frozenset(uses)
    chosen = {key for key, words in exercised.items() if _concerns(frozenset(words), used)}
    bare = used.difference(*(exercised[key] for key in chosen))
    return frozenset(chosen | {key for key, words in exercised.items() if not bare.isdisjoint(words)})


def _concerns(exercised: frozenset[str], used: frozenset[str]) -> bool:
    both, particular = exercised & used, exercised - ORDINARY
    return bool(particular & used) or (bool(both & KINDS and both & JOINTS) and not particular)
