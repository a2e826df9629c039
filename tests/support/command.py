"""The command line as a test calls it: in this process, by its arguments."""

from __future__ import annotations

from pathlib import Path

import pytest

from assess.cli import main


def ended(*arguments: str | Path | float) -> int:
    """The exit code of a command."""
    with pytest.raises(SystemExit) as caught:
        main([str(argument) for argument in arguments])
    return int(caught.value.code or 0)


def ended_with(capsys: pytest.CaptureFixture[str], *arguments: str | Path | float) -> tuple[int, str]:
    """The exit code of a command, and the last line that it wrote on stderr."""
    code = ended(*arguments)
    return code, (capsys.readouterr().err.splitlines() or [""])[-1]
