"""The example of a façade before and after works, run once for all tests that read its results."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from tempfile import mkdtemp

import assess
from assess.examples import copy_example
from assess.outputs.manifest import MANIFEST, RESULTS, Manifest, digest
from assess.results import Results
from assess.results.json import dumps


@cache
def folder() -> Path:
    """The example, with the results of the state before where its project file looks for them."""
    made = copy_example("facade", Path(mkdtemp()) / "facade").parent
    place = made / "project-results"
    place.mkdir()
    write_listed(place / RESULTS, dumps(assess.run(made / "project.toml").results))
    return made


def write_listed(path: Path, text: str) -> None:
    """Write results as the program does, with the list of its folder that vouches for them."""
    path.write_text(text, encoding="utf-8")
    listed = Manifest({RESULTS: {path.name: digest(path)}})
    (path.parent / MANIFEST).write_text(listed.text(), encoding="utf-8")


@cache
def with_ties() -> Results:
    """The results of the state after."""
    return assess.run(folder() / "with-ties.toml").results


def variant(name: str, **words: str) -> Path:
    """A project file beside that of the state after, in which words stand in place of others."""
    text = (folder() / "with-ties.toml").read_text(encoding="utf-8")
    for old, new in words.items():
        assert old in text
        text = text.replace(old, new)
    path = folder() / f"{name}.toml"
    path.write_text(text, encoding="utf-8")
    return path
