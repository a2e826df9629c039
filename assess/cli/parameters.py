"""`assess parameters`: the rocking parameters of each mechanism."""

from __future__ import annotations

from typing import Annotated

import typer

from assess.cli.options import ProjectPath, refuse_both


def parameters(
    project: ProjectPath,
    as_json: Annotated[bool, typer.Option("--json", help="Print the mechanisms as in results.json.")] = False,
    as_csv: Annotated[bool, typer.Option("--csv", help="Print the table as CSV at full precision.")] = False,
) -> None:
    """Print the rocking parameters of each mechanism and of each case of its sweeps, without analysis."""
    refuse_both(as_json=as_json, as_csv=as_csv)
    from assess.project.schema import load

    loaded = load(project)
    from assess.cli.stderr import print_messages
    from assess.cli.tables.parameters import csv_text, directions_text, parameters_text
    from assess.project.build import build
    from assess.results.json import dumps_mechanisms
    from assess.study.parameters import case_parameters
    from assess.study.parameters import parameters as parameters_of_study

    text = dumps_mechanisms if as_json else csv_text if as_csv else parameters_text
    study = build(loaded)
    print_messages(study.messages)
    mechanisms = parameters_of_study(study)
    print(text((*mechanisms, *case_parameters(study))), end="")
    if text is parameters_text:
        print(directions_text(mechanisms), end="")
