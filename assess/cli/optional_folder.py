"""A folder for output that the user may leave out."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def optional_folder(folder: Path | None, *, command: str, owner: str, wanted: Sequence[str]) -> Iterator[Path | None]:
    """Give a temporary folder as `output_folder` does, and print what is recovered; None where no folder is named.

    Parameters
    ----------
    folder : to write into
    command, owner, wanted : as for `output_folder`
    """
    if folder is None:
        yield None
        return
    from assess.cli.stderr import print_message
    from assess.outputs.folder import output_folder

    with output_folder(folder, command=command, owner=owner, wanted=wanted, tell=print_message) as stage:
        yield stage
