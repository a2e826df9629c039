"""Files of tests: writing, editing and reading them in a line, and the one line that says what is wrong with one."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

import pytest

from assess.outputs.lock import LOCK
from assess.outputs.manifest import MANIFEST, RESULTS
from assess.outputs.writing import TellMessage, output_folder


def write_file(path: Path, content: str | bytes, *, encoding: str = "utf-8") -> Path:
    """Write a file as it is, line ends too, with the folders above it; return its path."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content if isinstance(content, bytes) else content.encode(encoding))
    return path


def edit_file(path: Path, old: str, new: str) -> Path:
    """Replace what stands in a file once; return its path."""
    text = path.read_text(encoding="utf-8")
    assert text.count(old) == 1, (path, old)
    return write_file(path, text.replace(old, new))


@contextmanager
def refused_in_one_line(error: type[Exception], path: Path, words: str, *, longest: int = 400) -> Iterator[None]:
    """Expect an error of one line that begins with the file, holds `words` and goes on for `longest` letters."""
    with pytest.raises(error, match=words) as caught:
        yield
    assert str(caught.value).startswith(str(path))
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < longest + len(str(path))


def contents_of(folder: Path) -> dict[str, str]:
    """The text of every file below `folder` but what the program keeps there for itself."""
    own = (LOCK, MANIFEST)
    return {
        p.relative_to(folder).as_posix(): p.read_text() for p in folder.rglob("*") if p.is_file() and p.name not in own
    }


def write_files(folder: Path, files: Mapping[str, str]) -> None:
    """Write the files below `folder`."""
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)


def write_output(
    folder: Path, files: Mapping[str, str], *, owner: str = RESULTS, tell: TellMessage = lambda _: None
) -> None:
    """Write the files into `folder` as a command does that is known to write them all."""
    with output_folder(folder, command="a test", owner=owner, expected=[*files], tell=tell) as stage:
        write_files(stage, files)


def names_in(folder: Path) -> list[str]:
    """What a folder holds, by name."""
    return sorted(path.name for path in folder.iterdir())
