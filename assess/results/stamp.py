"""The stamp of results, which shows that outputs are of the same inputs and program."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path

from assess.results import Input, Program

NAME = "rocking-assess"
GROUPS, DIGITS = 4, 4  # in groups: no spreadsheet takes it for a number or a date


def this_program() -> Program:
    """Return the program that runs."""
    return Program(NAME, version(NAME))


def stamp(command: str, program: Program, inputs: Sequence[Input]) -> str:
    """Return a short hash of the command with its options, the program, and every file read.

    Clock, number of jobs, and place of the output are ignored.

    Parameters
    ----------
    command : str
        The command with its options.
    program : Program
        The program that made the results.
    inputs : sequence of Input
        The files that were read.

    Returns
    -------
    str
        Sixteen hexadecimal digits in groups of four.
    """
    files = [[each.path, each.sha256] for each in inputs]
    text = json.dumps([command, program.name, program.version, files], ensure_ascii=True)
    digest = hashlib.sha256(text.encode()).hexdigest()
    return "-".join(digest[DIGITS * place : DIGITS * (place + 1)] for place in range(GROUPS))


def stamp_of_files(command: str, files: Sequence[Path], *options: object) -> str:
    """Return the stamp of what a command makes of files.

    Parameters
    ----------
    command : str
        The command.
    files : sequence of Path
        The files that it reads.
    *options
        Its options.

    Returns
    -------
    str
        The stamp.
    """
    read = [Input(file.name, hashlib.sha256(file.read_bytes()).hexdigest()) for file in files]
    return stamp(f"{command} {options!r}", this_program(), read)


def origin(command: str, shown: str) -> str:
    """Return the origin of a single figure: the program, and a stamp of its content.

    Parameters
    ----------
    command : str
        The command that draws it.
    shown : str
        The numbers it shows, as text.

    Returns
    -------
    str
        Name and version of the program, and the stamp.
    """
    program = this_program()
    return f"{program.name} {program.version}, stamp {stamp(f'{command} {shown}', program, ())}"
