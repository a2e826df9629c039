"""Follow a page of the tutorials as its reader would: write its files, give its commands, run its Python.

A page shows what to do in fenced blocks, from top to bottom in one folder:

    toml      whose first line is `# NAME`: write the file; `# NAME, continued`: add to its end;
              `# NAME, below LINE`: add below that line
    console   lines that begin with `$ `: commands; the lines below each: what it prints
    python    run in one session; what it prints is in a block `text` right below

A line "…" stands for any lines, and "…" within a line for any words.
"""

from __future__ import annotations

import io
import os
import re
import shlex
import shutil
from collections.abc import Iterator
from contextlib import chdir, contextmanager, redirect_stderr, redirect_stdout, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

BLOCK = re.compile(r"^```(toml|console|python|text)\n(.*?)^```", re.DOTALL | re.MULTILINE)
PLACE = re.compile(r"# (?P<file>[\w.-]+\.toml)(?:, (?P<how>continued|below (?P<line>.+)))?$")


@dataclass(frozen=True)
class Output:
    """What a page says that a command or a piece of Python prints, and what it printed."""

    given: str
    expected: str
    printed: str

    @property
    def agrees(self) -> bool:
        """Whether the page shows what was printed."""
        return re.fullmatch(_pattern(self.expected), self.printed.rstrip() + "\n", re.DOTALL) is not None


def follow(page: Path, folder: Path) -> Iterator[Output]:
    """Follow a page in an empty folder and yield each output.

    Parameters
    ----------
    page : a Markdown file
    folder : where its files are written and its commands run; it exists
    """
    names: dict[str, Any] = {}
    here = folder
    blocks = BLOCK.findall(page.read_text(encoding="utf-8"))
    for number, (kind, text) in enumerate(blocks):
        if kind == "toml":
            _write(here, text)
        elif kind == "console":
            for command, expected in _commands(text):
                if command.startswith("cd "):
                    here = here / command.removeprefix("cd ")
                else:
                    yield Output(command, expected, _call(command, here))
        elif kind == "python":
            after = blocks[number + 1 : number + 2]
            shown = after[0][1] if after and after[0][0] == "text" else ""
            yield Output(text, shown, _execute(text, names, here))


def _write(folder: Path, text: str) -> None:
    """Write a file, or add to it; a block that names no file is only read."""
    first, _, rest = text.partition("\n")
    place = PLACE.match(first)
    if place is None:
        return
    file = folder / place["file"]
    if place["how"] is None:
        file.write_text(rest, encoding="utf-8")
        return
    before = file.read_text(encoding="utf-8")
    if place["line"] is None:
        file.write_text(f"{before}\n{rest}", encoding="utf-8")
        return
    head, line, tail = before.partition(f"{place['line']}\n")
    if not line:
        raise ValueError(f"{file.name} has no line {place['line']}")
    file.write_text(f"{head}{line}{rest}{tail}", encoding="utf-8")


def _commands(text: str) -> Iterator[tuple[str, str]]:
    """Yield each command of a block with the lines that it is to print."""
    for part in re.split(r"^\$ ", text, flags=re.MULTILINE)[1:]:
        command, _, expected = part.partition("\n")
        yield command, expected


def _call(command: str, folder: Path) -> str:
    """Give a command of this program, or copy a file; return what it prints."""
    words = shlex.split(command)
    if words[0] == "cp":
        shutil.copyfile(folder / words[1], folder / words[2])
        return ""
    from assess.cli import main

    with _printing(folder) as printed, suppress(SystemExit):
        main(words[1:])
    return printed.getvalue()


def _execute(text: str, names: dict[str, Any], folder: Path) -> str:
    """Run Python in a session; return what it prints."""
    with _printing(folder) as printed:
        exec(text, names)
    return printed.getvalue()


@contextmanager
def _printing(folder: Path) -> Iterator[io.StringIO]:
    """Within a folder, collect what is printed, a hundred letters wide."""
    printed, before = io.StringIO(), os.environ.get("COLUMNS")
    os.environ["COLUMNS"] = "100"
    try:
        with chdir(folder), redirect_stdout(printed), redirect_stderr(printed):
            yield printed
    finally:
        os.environ.pop("COLUMNS")
        if before is not None:
            os.environ["COLUMNS"] = before


def _pattern(expected: str) -> str:
    """Return the pattern of what a page shows: a line "…" is any lines, "…" within a line any words."""
    lines = []
    for line in expected.splitlines():
        if line.strip() == "…":
            lines.append(r"(?:[^\n]*\n)*?")
        else:
            lines.append("[^\n]*?".join(re.escape(part) for part in line.rstrip().split("…")) + r" *\n")
    return "".join(lines) or r"\n?"
