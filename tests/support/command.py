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
