"""`assess check`: read and validate a project, without analysis."""

from __future__ import annotations

from assess.cli.arguments import ProjectPath


def check(project: ProjectPath) -> None:
    """Read a project, validate it, and print each mechanism; no analysis.

    Shows what the program understood: hinges, loads, interfaces and the rocking parameters.
    """
    from assess.project.schema import load

    loaded = load(project)
    from assess.cli.description import description, sensitivity_text
    from assess.project.build import build
    from assess.study.parameters import parameters

    study = build(loaded)
    print(description(loaded, parameters(study), study.sweeps, study.notices), end="")
    print(sensitivity_text(study.variables), end="")
