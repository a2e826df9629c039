"""One file that the user names: whole or not at all, and never over another."""

import os
from pathlib import Path
from unittest.mock import Mock

import pytest

from assess.errors import OutputError
from assess.outputs.writing import PREFIX, write_file


def put(path: Path, text: str) -> None:
    with write_file(path, command="a test") as made:
        made.write_text(text)


@pytest.mark.parametrize("links", [True, False])
def test_a_file_is_made_and_never_replaced(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, links: bool) -> None:

    if not links:
        monkeypatch.setattr(os, "link", Mock(side_effect=OSError(95, "Operation not supported")))
    put(tmp_path / "a.svg", "1")
    put(tmp_path / "a.svg", "1")
    with pytest.raises(OutputError, match=r"a\.svg: is there already and holds something else; move it away, or give"):
        put(tmp_path / "a.svg", "2")
    assert [(path.name, path.read_text()) for path in tmp_path.iterdir()] == [("a.svg", "1")]


def test_a_file_that_cannot_be_finished_leaves_nothing(tmp_path: Path) -> None:
    with pytest.raises(TypeError):
        put(tmp_path / "a.svg", 7)  # type: ignore[arg-type]
    assert list(tmp_path.iterdir()) == []


def test_where_no_file_can_be_is_told(tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    for path, words in ((tmp_path / "no" / "a.svg", "make it first"), (tmp_path / "folder", "is a folder")):
        with pytest.raises(OutputError, match=words):
            put(path, "1")
    with pytest.raises(OutputError, match="holds something else"):
        put(Path(os.devnull), "1")


def test_stages_in_use_and_young_ones_without_a_lock_are_left_alone(tmp_path: Path) -> None:
    (tmp_path / f"{PREFIX}young").mkdir()
    (tmp_path / f"{PREFIX}old").mkdir()
    os.utime(tmp_path / f"{PREFIX}old", (1e9, 1e9))
    for name in ("dead", "begun"):  # a lock that is not signed may be a moment old
        (tmp_path / f"{PREFIX}{name}").mkdir()
        (tmp_path / f"{PREFIX}{name}" / ".assess-lock").write_text("")
    os.utime(tmp_path / f"{PREFIX}dead" / ".assess-lock", (1e9, 1e9))
    with write_file(tmp_path / "a", command="a test") as first:
        first.write_text("a")
        put(tmp_path / "b", "b")
        assert first.exists()
    assert sorted(path.name for path in tmp_path.iterdir()) == [f"{PREFIX}begun", f"{PREFIX}young", "a", "b"]
