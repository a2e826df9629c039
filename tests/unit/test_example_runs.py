"""A run of an example that the tests share is kept only if it has finished."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.support import examples
from tests.support.examples import example_run


@pytest.fixture(autouse=True)
def own_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(examples, "RUNS", tmp_path)
    monkeypatch.setattr(examples, "example_run", example_run.__wrapped__)


@pytest.mark.parametrize(("code", "error"), [(143, KeyboardInterrupt), (130, KeyboardInterrupt), (70, AssertionError)])
def test_a_run_that_was_stopped_or_broke_is_made_again(
    code: int, error: type[BaseException], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    codes = iter((code, 1))
    monkeypatch.setattr(examples, "ended", lambda *_: next(codes))
    with pytest.raises(error):
        examples.example_run("single_wall")
    assert examples.example_run("single_wall").code == 1
    assert examples.example_run("single_wall").code == 1  # no third run
