"""Every piece of results shows itself on one short line."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from assess import results as tree
from assess.short_repr import ShortRepr
from assess.study.run import run_study
from tests.support.projects import EC8, block, project_toml, study_of, wall

PROJECT = project_toml(
    site={"spectrum": EC8},
    materials={"stone": {"density": 2000, "disintegration": "excluded"}},
    bodies={"wall": wall(length=4.0, height=4.5, material="stone")},
    mechanisms={"wall": block(direction=[1, 0, 0])},
    records={"synthetic": {"count": 1, "duration": 25}},
    analysis={
        "levels": ["0.1 g", "0.3 g"],
        "procedures": ["asce43-05-history", "asce43-05-spectrum", "dmi2008-linear"],
        "pulses": {
            "shape": "sine",
            "frequency": {"from": "1 Hz", "to": "4 Hz", "count": 3},
            "amplitude": {"from": "0 g", "to": "2 g", "count": 4},
        },
    },
)


def pieces(value: Any) -> Iterator[Any]:
    """Every dataclass within a value."""
    if is_dataclass(value):
        yield value
        for each in fields(value):
            yield from pieces(getattr(value, each.name))
    elif isinstance(value, tuple | list):
        for each in value if value and not isinstance(value[0], float | int) else ():
            yield from pieces(each)
    elif isinstance(value, Mapping):
        for each in value.values():
            yield from pieces(each)


def test_every_piece_of_a_run_has_a_repr_of_one_short_line(tmp_path: Path) -> None:
    found = list(pieces(run_study(study_of(tmp_path, PROJECT), jobs=1)))
    kinds = {type(each).__name__ for each in found}
    assert {"Results", "HistoryTrace", "BranchCurve", "EnvelopeResult", "Check", "Message"} <= kinds
    long = {type(each).__name__ for each in found if len(repr(each)) >= 200 or "\n" in repr(each)}
    assert not long


@pytest.mark.parametrize("name", [n for n in tree.__all__ if isinstance(getattr(tree, n), type)])
def test_every_class_of_the_tree_has_the_short_repr(name: str) -> None:
    assert issubclass(getattr(tree, name), ShortRepr)


def test_what_a_short_repr_shows() -> None:
    @dataclass(frozen=True, repr=False)
    class Motion(ShortRepr):
        name: str
        size: tuple[float, ...]
        time: Any
        rows: Mapping[str, float]
        inner: Any = None

    one = Motion("x" * 100, (1.0, 2.0 / 3.0), np.zeros((12000,)), {"a": 1.0})
    assert repr(one) == (
        f"test_what_a_short_repr_shows.<locals>.Motion(name='{'x' * 39}…', size=(1, 0.666667), time=array[12000], "
        "rows=<1 key>, inner=None)"
    ).removeprefix("test_what_a_short_repr_shows.<locals>.")
    assert "inner=Motion(…)" in repr(Motion("", (), np.zeros(2), {}, one))
    assert "time=<12000 items>" in repr(Motion("", (), (0.0,) * 12000, {}))
