"""The stamp of results: by which every output of one analysis is known to be of the same inputs and program."""

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
    """The program that runs."""
    return Program(NAME, version(NAME))


def stamp(command: str, program: Program, inputs: Sequence[Input]) -> str:
    """A short hash of what decides results: the command with its options, the program, and every file read.

    No clock, number of jobs, or place of the output has a part in it.
    """
    files = [[each.path, each.sha256] for each in inputs]
    said = json.dumps([command, program.name, program.version, files], ensure_ascii=True)
    digest = hashlib.sha256(said.encode()).hexdigest()
    return "-".join(digest[DIGITS * place : DIGITS * (place + 1)] for place in range(GROUPS))


def stamp_of_files(command: str, files: Sequence[Path], *options: object) -> str:
    """The stamp of what a command makes of files by these options."""
    read = [Input(file.name, hashlib.sha256(file.read_bytes()).hexdigest()) for file in files]
    return stamp(f"{command} {options!r}", this_program(), read)


def origin(command: str, shown: str) -> str:
    """What a figure of its own says of where it comes from: the program, and a stamp of what it shows."""
    program = this_program()
    return f"{program.name} {program.version}, stamp {stamp(f'{command} {shown}', program, ())}"
