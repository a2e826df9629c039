"""docs/verdict.md names every basis, limit state and method there is."""

from __future__ import annotations

from pathlib import Path

import pytest

from assess.codes.bases import BASES

PAGE = (Path(__file__).parents[5] / "docs" / "verdict.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", BASES)
def test_every_basis_is_documented(name):
    _, _, rest = PAGE.partition(f"## `{name}`")
    section = " ".join(rest.partition("\n## ")[0].split())
    basis = BASES[name]
    wanted = [*(f"`{method}`" for method in basis.methods), *(state.name for state in basis.states), "Not compared"]
    assert [each for each in wanted if each not in section] == []
