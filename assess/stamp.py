"""The stamp of results: by which every output of one analysis is known to be of the same inputs and program."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence

from assess.results import Input, Program

GROUPS, DIGITS = 4, 4  # in groups: no spreadsheet takes it for a number or a date


def stamp(command: str, program: Program, inputs: Sequence[Input]) -> str:
    """A short hash of what decides the results: the command, the program's name and version, and every file read.

    No clock, number of jobs, or place of the output has a part in it.
    """
    files = [[each.path, each.sha256] for each in inputs]
    said = json.dumps([command, program.name, program.version, files], ensure_ascii=True)
    digest = hashlib.sha256(said.encode()).hexdigest()
    return "-".join(digest[DIGITS * place : DIGITS * (place + 1)] for place in range(GROUPS))
