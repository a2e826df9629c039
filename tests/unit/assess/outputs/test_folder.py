"""Outputs are written whole or not at all, and nothing is replaced that is not the program's or was changed since."""

import errno
import os
import shutil
from pathlib import Path
from typing import Any
from unittest.mock import Mock

import pytest

from assess.errors import FullDiskError, OutputError
from assess.outputs.manifest import ENVELOPES, MANIFEST
from assess.outputs.writing import is_full, make_stage, output_folder
from tests.support.files import contents_of, names_in, write_files, write_output

FIRST = {"results.json": "1", "report.pdf": "1", "tables/old.csv": "1"}
SECOND = {"results.json": "2", "report.pdf": "2", "figures/new.svg": "2"}


class Failing(dict[str, str]):
    """Files of which the last cannot be written."""

    def items(self) -> Any:
        yield from list(super().items())[:-1]
        raise RuntimeError("half-way")


def test_new_folder_with_its_parents(tmp_path: Path) -> None:
    write_output(tmp_path / "a" / "b", {"results.json": "1", "tables/x.csv": "2"})
    assert contents_of(tmp_path) == {"a/b/results.json": "1", "a/b/tables/x.csv": "2"}
    assert names_in(tmp_path) == ["a"]


def test_own_files_are_replaced_and_others_stay(tmp_path: Path) -> None:
    write_files(tmp_path, {"mine.txt": "mine", "tables/mine.csv": "mine"})
    write_output(tmp_path, {"results.json": "1", "report.pdf": "1", "tables/x.csv": "1", "figures/x.svg": "1"})
    write_output(tmp_path, {"results.json": "2", "tables/y.csv": "2"})
    expected = {"mine.txt": "mine", "tables/mine.csv": "mine", "results.json": "2", "tables/y.csv": "2"}
    assert contents_of(tmp_path) == expected
    assert names_in(tmp_path) == [MANIFEST, "mine.txt", "results.json", "tables"]


def test_the_same_files_leave_the_same_bytes(tmp_path: Path) -> None:
    for folder in ("a", "b", "b"):
        write_output(tmp_path / folder, FIRST)
    assert (tmp_path / "a" / MANIFEST).read_bytes() == (tmp_path / "b" / MANIFEST).read_bytes()


def test_report_made_again_keeps_its_results(tmp_path: Path) -> None:
    write_output(tmp_path, {"results.json": "1", "report.pdf": "1"})
    for text in ("2", "3"):
        write_output(tmp_path, {"report.pdf": text})
        assert contents_of(tmp_path) == {"results.json": "1", "report.pdf": text}


def test_a_set_of_files_leaves_the_other_alone(tmp_path: Path) -> None:
    write_output(tmp_path, FIRST)
    write_output(tmp_path, {"envelopes.json": "e", "envelopes.pdf": "e"}, owner=ENVELOPES)
    write_output(tmp_path, {"results.json": "2"})
    assert contents_of(tmp_path) == {"results.json": "2", "envelopes.json": "e", "envelopes.pdf": "e"}
    with pytest.raises(OutputError, match="by another of its commands"):
        write_output(tmp_path, {"results.json": "3"}, owner=ENVELOPES)


def test_failing_writer_leaves_everything_as_it_was(tmp_path: Path) -> None:
    write_output(tmp_path, {"results.json": "1", "report.pdf": "1"})
    before = contents_of(tmp_path)
    with pytest.raises(RuntimeError, match="half-way"):
        write_output(tmp_path, Failing({"results.json": "2", "tables/x.csv": "2"}))
    assert contents_of(tmp_path) == before
    assert names_in(tmp_path) == [MANIFEST, "report.pdf", "results.json"]


def test_failing_writer_leaves_no_new_folder(tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt), output_folder(tmp_path / "new" / "deep", command="a test"):
        raise KeyboardInterrupt
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("wrapped", [False, True])
@pytest.mark.parametrize("number", [errno.ENOSPC, errno.EDQUOT])
def test_a_full_disk_is_one_line_and_leaves_nothing(tmp_path: Path, number: int, wrapped: bool) -> None:
    """Packages that write workbooks and pages raise errors of their own while they handle that of the disk."""
    out = tmp_path / "out"

    def write() -> None:
        with output_folder(out, command="assess run") as stage:
            (stage / "results.json").write_text("half")
            try:
                raise OSError(number, os.strerror(number))
            except OSError as error:
                if wrapped:
                    raise RuntimeError("the workbook cannot be closed") from error
                raise

    with pytest.raises(FullDiskError, match=rf"{out}: no space is left on the disk.*; make room"):
        write()
    assert not out.exists()


def test_a_full_disk_under_a_copied_folder_is_one_line(tmp_path: Path) -> None:
    copied = shutil.Error([("a", "b", str(OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), "a", None, "b")))])
    with pytest.raises(FullDiskError, match=rf"{tmp_path}: no space is left"), make_stage(tmp_path, command="new"):
        raise copied
    assert names_in(tmp_path) == []
    assert not is_full(shutil.Error([("a", "b", "[Errno 13] Permission denied: 'a'")]))


@pytest.mark.parametrize("fails_at", range(2, 7))  # the first is that of the journal, before anything is moved
def test_failing_move_is_undone_and_what_was_made_is_kept(
    fails_at: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "out"
    write_output(out, FIRST)
    before, listed = contents_of(out), (out / MANIFEST).read_bytes()
    moves, replace = 0, os.replace

    def failing(source: Path, target: Path) -> None:
        nonlocal moves
        moves += 1
        if moves == fails_at:
            raise OSError(28, "No space left on device", str(source))
        replace(source, target)

    monkeypatch.setattr(os, "replace", failing)
    if fails_at == 6:  # there are but five
        write_output(out, SECOND)
        assert contents_of(out) == SECOND
        return
    with pytest.raises(OutputError, match=rf"No space left.* what was made is in {out}-new-1: close"):
        write_output(out, SECOND)
    assert contents_of(out) == before
    assert (out / MANIFEST).read_bytes() == listed
    assert names_in(out) == [MANIFEST, "report.pdf", "results.json", "tables"]
    assert contents_of(tmp_path / "out-new-1") == SECOND


def test_without_links_files_are_moved(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:

    monkeypatch.setattr(os, "link", Mock(side_effect=OSError(95, "Operation not supported")))
    for files in (FIRST, SECOND):
        write_output(tmp_path, files)
        assert contents_of(tmp_path) == files


def test_file_and_folder_in_the_way(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("x")
    with pytest.raises(OutputError, match="is a file; give a folder"):
        write_output(tmp_path / "file", {})
    (tmp_path / "out" / "report.pdf").mkdir(parents=True)
    with pytest.raises(OutputError, match="is a folder where a file is to be written"):
        write_output(tmp_path / "out", {"report.pdf": "1", "results.json": "1"})
    assert contents_of(tmp_path) == {"file": "x"}


def began(folder: Path, wanted: list[str]) -> bool:
    """Whether the work began before the folder was refused."""
    reached = False
    with pytest.raises(OutputError), output_folder(folder, command="a test", expected=wanted):
        reached = True
    return bool(reached)


def test_a_file_of_the_users_own_is_never_replaced(tmp_path: Path) -> None:
    write_files(tmp_path, {"report.pdf": "mine"})
    with pytest.raises(OutputError, match=r"report\.pdf: was not written by assess"):
        write_output(tmp_path, {"results.json": "1", "report.pdf": "1"})
    assert contents_of(tmp_path) == {"report.pdf": "mine"}
    assert not began(tmp_path, ["report.pdf"])
    (tmp_path / "report.pdf").unlink()
    write_output(tmp_path, {"results.json": "1", "report.pdf": "1"})
    write_output(tmp_path, {"results.json": "2", "report.pdf": "2"})
    assert contents_of(tmp_path) == {"results.json": "2", "report.pdf": "2"}


@pytest.mark.parametrize("files", [FIRST, {"results.json": "2"}], ids=["replaced", "removed"])
def test_a_signed_report_is_neither_replaced_nor_removed(tmp_path: Path, files: dict[str, str]) -> None:
    write_output(tmp_path, FIRST)
    (tmp_path / "report.pdf").write_text("1, signed")
    with pytest.raises(OutputError, match=r"report\.pdf: was changed since assess wrote it; move it away, or give"):
        write_output(tmp_path, files)
    assert not began(tmp_path, [*files])
    assert contents_of(tmp_path) == {**FIRST, "report.pdf": "1, signed"}
    (tmp_path / "report.pdf").rename(tmp_path / "signed.pdf")
    write_output(tmp_path, files)
    assert contents_of(tmp_path) == {**files, "signed.pdf": "1, signed"}


def meanwhile(folder: Path, files: dict[str, str], users: dict[str, str]) -> None:
    """Write the files while the user writes others into the folder."""
    with output_folder(folder, command="a test") as stage:
        write_files(stage, files)
        write_files(folder, users)


def test_what_is_changed_during_the_work_keeps_the_new_files_beside_it(tmp_path: Path) -> None:
    out = tmp_path / "out"
    write_output(out, FIRST)
    words = f"report.pdf, .*tables/old.csv: was changed since .* nothing there was touched, .* is in {out}-new-1"
    with pytest.raises(OutputError, match=words):
        meanwhile(out, SECOND, {"report.pdf": "signed", "tables/old.csv": "noted"})
    assert contents_of(out) == {**FIRST, "report.pdf": "signed", "tables/old.csv": "noted"}
    assert contents_of(tmp_path / "out-new-1") == SECOND
    write_output(tmp_path / "out-new-1", FIRST)  # it has a list of its own
    assert names_in(tmp_path) == ["out", "out-new-1"]


def test_files_of_the_user_that_come_into_the_way_stay(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match=r"x\.csv: was not written by assess"):
        meanwhile(tmp_path, {"tables/x.csv": "1"}, {"tables/x.csv": "mine"})
    assert contents_of(tmp_path) == {"tables/x.csv": "mine"}


def test_names_that_lead_out_of_the_folder_are_not_believed(tmp_path: Path) -> None:
    listed = f'{{"format": 1, "sets": {{"results.json": {{"../precious": null, "{tmp_path}/precious": null}}}}}}'
    write_files(tmp_path, {"precious": "x", f"out/{MANIFEST}": listed})
    write_output(tmp_path / "out", {"results.json": "1"})
    assert contents_of(tmp_path) == {"precious": "x", "out/results.json": "1"}


@pytest.mark.parametrize("damaged", ["", "[]", '{"sets": 7}', '{"sets": {"results.json": 7}}', "\xff"])
def test_without_a_list_that_can_be_read_nothing_is_ours(tmp_path: Path, damaged: str) -> None:
    write_output(tmp_path, FIRST)
    (tmp_path / MANIFEST).write_text(damaged, encoding="latin-1")
    with pytest.raises(OutputError, match="was not written by assess"):
        write_output(tmp_path, SECOND)
    assert contents_of(tmp_path) == FIRST


def test_lists_of_earlier_versions_are_understood_once(tmp_path: Path) -> None:
    old = {
        ".assess-outputs": "results.json\nreport.pdf\ntables/old.csv\n../x\n",
        ".assess-envelopes": "envelopes.json\n",
    }
    write_files(tmp_path, {**FIRST, "envelopes.json": "e", **old})
    write_output(tmp_path, SECOND)
    assert contents_of(tmp_path) == {**SECOND, "envelopes.json": "e"}
    write_output(tmp_path, {"envelopes.json": "f"}, owner=ENVELOPES)
    assert contents_of(tmp_path) == {**SECOND, "envelopes.json": "f"}


def test_what_is_younger_than_its_earlier_list_was_changed(tmp_path: Path) -> None:
    write_files(tmp_path, {**FIRST, ".assess-outputs": "results.json\nreport.pdf\ntables/old.csv\n"})
    os.utime(tmp_path / ".assess-outputs", (1e9, 1e9))
    for name in ("results.json", "tables/old.csv"):
        os.utime(tmp_path / name, (1e9 + 1, 1e9 + 1))
    with pytest.raises(OutputError, match=r"report\.pdf: was changed since"):
        write_output(tmp_path, SECOND)


def test_a_place_where_nothing_can_be_written_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made = Path.mkdir

    def refusing(self: Path, *arguments: Any, **options: Any) -> None:
        if self.name.startswith(".assess"):
            raise PermissionError(13, "Permission denied")
        made(self, *arguments, **options)

    monkeypatch.setattr(Path, "mkdir", refusing)
    words = f"{tmp_path / 'x'}: nothing can be written there .Permission denied.; give another place"
    with pytest.raises(OutputError, match=words):
        write_output(tmp_path / "x", {"results.json": "1"})
    assert names_in(tmp_path) == []


def test_stages_of_commands_that_are_gone_are_removed(tmp_path: Path) -> None:
    write_files(
        tmp_path,
        {".assess-partial-a/made/x": "half", ".assess-partial-b": "half", ".assess-partial-c/.assess-lock": ""},
    )
    (tmp_path / ".assess-partial-d").symlink_to(tmp_path.parent)
    write_output(tmp_path, {"results.json": "1"})
    assert names_in(tmp_path) == [MANIFEST, "results.json"]
    assert tmp_path.parent.is_dir()
