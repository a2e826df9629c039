"""Folders of outputs with links and false lists in them, and disks that fail in the middle of the moves."""

import json
import os
from pathlib import Path
from unittest.mock import Mock

import pytest

from assess.errors import OutputError
from assess.outputs import writing
from assess.outputs.manifest import MANIFEST
from assess.outputs.writing import recover_for_reading
from tests.support.files import contents_of, write_files, write_output


def test_a_link_that_leads_out_of_the_folder_is_not_written_through(tmp_path: Path) -> None:
    out, elsewhere = tmp_path / "out", tmp_path / "elsewhere"
    write_output(out, {"results.json": "1", "tables/a.csv": "1"})
    (out / "tables").rename(elsewhere)
    (out / "tables").symlink_to(elsewhere)
    with pytest.raises(OutputError, match=r"tables/a.csv: is to be written where a link leads out of the folder"):
        write_output(out, {"results.json": "2", "tables/a.csv": "2"})
    with pytest.raises(OutputError, match=r"tables/a.csv: is to be written where a link leads"):
        write_output(out, {"results.json": "2"})  # which would remove it
    assert contents_of(elsewhere) == {"a.csv": "1"}
    assert json.loads((out / "results.json").read_text()) == 1


def test_a_list_without_hashes_makes_nothing_ours(tmp_path: Path) -> None:
    write_files(tmp_path, {"mine.txt": "mine"})
    (tmp_path / MANIFEST).write_text(
        json.dumps({"format": 1, "sets": {"results.json": {"mine.txt": None, "\0": None}}})
    )
    with pytest.raises(OutputError, match=r"mine.txt: was changed since assess wrote it"):
        write_output(tmp_path, {"results.json": "1"})
    assert contents_of(tmp_path) == {"mine.txt": "mine"}


def test_where_moves_can_neither_be_finished_nor_undone_the_next_command_does(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_output(tmp_path, {"results.json": "1", "report.pdf": "1"})
    real, calls = os.replace, iter(range(100))

    def broken(source: str | Path, target: str | Path) -> None:
        if Path(source).name.endswith(".draft") or next(calls) < 1:
            return real(source, target)
        raise OSError(5, "Input/output error")

    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", broken)
        with pytest.raises(OSError, match=r"Input/output error"):
            write_output(tmp_path, {"results.json": "2", "report.pdf": "2"})
    recover_for_reading(tmp_path, tell=lambda _: None)
    assert contents_of(tmp_path) == {"results.json": "2", "report.pdf": "2"}


def test_a_disk_that_is_full_before_the_moves_keeps_what_was_made(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "out"
    write_output(out, {"results.json": "1"})

    with monkeypatch.context() as patch:
        patch.setattr(writing, "write_journal", Mock(side_effect=OSError(28, "No space left on device")))
        with pytest.raises(OutputError, match=r"No space left on device.*what was made is in"):
            write_output(out, {"results.json": "2"})
    assert contents_of(out) == {"results.json": "1"}
    assert contents_of(tmp_path / "out-new-1") == {"results.json": "2"}
