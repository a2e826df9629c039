"""`assess parameters`: the rocking parameters of each mechanism."""

from __future__ import annotations

import sys
from typing import Annotated

import typer

from assess.cli.arguments import ProjectPath


def parameters(
    project: ProjectPath,
    as_json: Annotated[bool, typer.Option("--json", help="Print the mechanisms as in results.json.")] = False,
    as_csv: Annotated[bool, typer.Option("--csv", help="Print the table as CSV, at full precision.")] = False,
) -> None:
    """Print the rocking parameters of each mechanism, and of each case of its sweeps; no analysis."""
    if as_json and as_csv:
        raise typer.BadParameter("--json and --csv exclude each other")
    from assess.project.schema import load

    loaded = load(project)
    from assess.cli.description import warned
    from assess.cli.parameter_table import csv_text, directions_text, parameters_text
    from assess.project.build import build
    from assess.results.json import dumps_mechanisms
    from assess.study.parameters import case_parameters
    from assess.study.parameters import parameters as of_study

    text = dumps_mechanisms if as_json else csv_text if as_csv else parameters_text
    study = build(loaded)
    print(warned(study.notices), end="", file=sys.stderr)
    mechanisms = of_study(study)
    print(text((*mechanisms, *case_parameters(study))), end="")
    if text is parameters_text:
        print(directions_text(mechanisms), end="")
