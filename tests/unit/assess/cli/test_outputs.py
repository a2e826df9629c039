"""Outputs are written whole or not at all."""

import os
from pathlib import Path
from typing import Any

import pytest

from assess.cli.outputs import LIST, staged
from assess.errors import AssessError


def content(folder: Path) -> dict[str, str]:
    return {str(p.relative_to(folder)): p.read_text() for p in folder.rglob("*") if p.is_file() and p.name != LIST}


def write(folder: Path, files: dict[str, str]) -> None:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)


def run(folder: Path, files: dict[str, str]) -> None:
    with staged(folder) as stage:
        write(stage, files)


class Failing(dict[str, str]):
    """Files of which the last cannot be written."""

    def items(self) -> Any:
        yield from list(super().items())[:-1]
        raise RuntimeError("half-way")


def test_new_folder_with_its_parents(tmp_path: Path) -> None:
    run(tmp_path / "a" / "b", {"results.json": "1", "tables/x.csv": "2"})
    assert content(tmp_path) == {"a/b/results.json": "1", "a/b/tables/x.csv": "2"}
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a"]


def test_own_files_are_replaced_and_others_stay(tmp_path: Path) -> None:
    write(tmp_path, {"mine.txt": "mine", "tables/mine.csv": "mine"})
    run(tmp_path, {"results.json": "1", "report.pdf": "1", "tables/x.csv": "1", "figures/x.svg": "1"})
    run(tmp_path, {"results.json": "2", "tables/y.csv": "2"})
    assert content(tmp_path) == {
        "mine.txt": "mine",
        "tables/mine.csv": "mine",
        "results.json": "2",
        "tables/y.csv": "2",
    }
    assert sorted(p.name for p in tmp_path.iterdir()) == [LIST, "mine.txt", "results.json", "tables"]


def test_report_made_again_keeps_its_results(tmp_path: Path) -> None:
    run(tmp_path, {"results.json": "1", "report.pdf": "1"})
    for text in ("2", "3"):
        run(tmp_path, {"report.pdf": text})
        assert content(tmp_path) == {"results.json": "1", "report.pdf": text}


def test_failing_writer_leaves_everything_as_it_was(tmp_path: Path) -> None:
    run(tmp_path, {"results.json": "1", "report.pdf": "1"})
    before = content(tmp_path)
    with pytest.raises(RuntimeError, match="half-way"):
        run(tmp_path, Failing({"results.json": "2", "tables/x.csv": "2"}))
    assert content(tmp_path) == before
    assert sorted(p.name for p in tmp_path.iterdir()) == [LIST, "report.pdf", "results.json"]


def test_failing_writer_leaves_no_new_folder(tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt), staged(tmp_path / "new" / "deep"):
        raise KeyboardInterrupt
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("fails_at", range(1, 8))
def test_failing_move_is_undone(fails_at: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    run(tmp_path, {"results.json": "1", "report.pdf": "1", "tables/old.csv": "1"})
    before, listed = content(tmp_path), (tmp_path / LIST).read_text()
    moves, replace = 0, os.replace

    def failing(source: Path, target: Path) -> None:
        nonlocal moves
        moves += 1
        if moves == fails_at:
            raise OSError(28, "No space left on device")
        replace(source, target)

    monkeypatch.setattr(os, "replace", failing)
    with pytest.raises(OSError, match="No space left"):
        run(tmp_path, {"results.json": "2", "report.pdf": "2", "figures/new.svg": "2"})
    assert content(tmp_path) == before
    assert (tmp_path / LIST).read_text() == listed
    assert sorted(p.name for p in tmp_path.iterdir()) == [LIST, "report.pdf", "results.json", "tables"]


def test_file_and_folder_in_the_way(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("x")
    with pytest.raises(AssessError, match="is a file; give a folder"):
        run(tmp_path / "file", {})
    (tmp_path / "out" / "report.pdf").mkdir(parents=True)
    with pytest.raises(AssessError, match="is a folder where a file is to be written"):
        run(tmp_path / "out", {"report.pdf": "1", "results.json": "1"})
    assert content(tmp_path) == {"file": "x"}


def test_list_that_leads_out_of_the_folder_is_ignored(tmp_path: Path) -> None:
    write(tmp_path, {"precious": "x", f"out/{LIST}": f"../precious\n{tmp_path}/precious\n"})
    run(tmp_path / "out", {"results.json": "1"})
    assert content(tmp_path) == {"precious": "x", "out/results.json": "1"}


def test_a_file_of_the_users_own_is_never_replaced(tmp_path: Path) -> None:
    write(tmp_path, {"report.pdf": "mine"})
    with pytest.raises(AssessError, match="was not written by assess"):
        run(tmp_path, {"results.json": "1", "report.pdf": "1"})
    assert content(tmp_path) == {"report.pdf": "mine"}
    (tmp_path / "report.pdf").unlink()
    run(tmp_path, {"results.json": "1", "report.pdf": "1"})
    run(tmp_path, {"results.json": "2", "report.pdf": "2"})
    assert content(tmp_path) == {"results.json": "2", "report.pdf": "2"}


def test_a_place_where_nothing_can_be_written_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refusing(**_: object) -> str:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("tempfile.mkdtemp", refusing)
    words = f"{tmp_path / 'x'}: nothing can be written in {tmp_path} .Permission denied.; give another folder"
    with pytest.raises(AssessError, match=words):
        run(tmp_path / "x", {"results.json": "1"})
