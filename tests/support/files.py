"""Files of tests: writing one in a line, editing it, and the one line that says what is wrong with it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest


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
