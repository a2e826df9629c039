"""Command lines drawn by hypothesis: options of the command added, with values that they may not have."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import typer
from hypothesis import strategies as st

from assess.cli.app import app
from tools.fuzz.fuzz_input import Edit, FuzzInput
from tools.fuzz.tree_edits import drawn

VALUES = (
    *(
        "nan",
        "inf",
        "-inf",
        "-1",
        "0",
        "1",
        "2",
        "0.5",
        "1e300",
        "1e-300",
        "1e9",
        "9" * 30,
        "1,5",
        "1e",
        "",
        " ",
        "abc",
    ),
    *("g", "m/s2", "furlong", "0.2 g", "6 s", "5 km", "B", "T2", "design", "asce7-16", "nzs1170.5", "ntc2018", "table"),
    *(
        "{}/target.csv",
        "{}/flat.csv",
        "{}/nowhere",
        "{}",
        "/dev/null",
        "../x",
        "{}/out.svg",
        "{}/out.xyz",
        "{}/motions",
    ),
    *(
        "\u202e",
        "x" * 5000,
        "=cmd",
        "<b>",
        "%s",
        "{0}",
        "--json",
        "-",
        "pga",
        "none",
        "spectrum",
        "each",
        "together",
        "it",
    ),
)
LARGE = {"--jobs": ("1", "0", "-1", "nan", "abc"), "--count": VALUES}  # nobody wants a thousand processes


@cache
def parameters(command: tuple[str, ...]) -> list[Any]:
    """The options of a command."""
    found: Any = typer.main.get_command(app)
    for name in command:
        found = found.commands[name]
    return [each for each in found.params if each.opts[-1].startswith("-") and each.opts[-1] not in ("--help", "-h")]


def command_of(case: FuzzInput) -> tuple[str, ...]:
    """The words that name the command of a case."""
    return case.arguments[:2] if case.arguments[0] == "records" else case.arguments[:1]


@st.composite
def options(draw: st.DrawFn, case: FuzzInput) -> tuple[str, ...]:
    """One to three options with values."""
    known = parameters(command_of(case))
    typed: list[str] = []
    for _ in range(draw(st.integers(1, 3)) if known else 0):
        one = draw(st.sampled_from(known))
        typed.append(one.opts[-1])
        if one.type_descriptor.annotation is not bool:
            values = LARGE.get(one.opts[-1], VALUES)
            typed += [draw(st.sampled_from(values)) for _ in range(max(one.nargs, 1))]
    return tuple(typed) or (draw(st.sampled_from(VALUES)),)


def option_cases(case: FuzzInput, *, start: int, count: int) -> list[FuzzInput]:
    """The case with options added."""
    return [
        replace(case, arguments=case.arguments + typed, edits=(Edit(0, 0, b"", typed[0], " ".join(typed)[:200]),))
        for typed in drawn(options(case), start=start, count=count)
    ]
