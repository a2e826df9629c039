"""`assess check`: a project read, validated and described, without analysis."""

from __future__ import annotations

from assess.cli.options import ProjectPath
from assess.cli.progress import progress


def check(project: ProjectPath) -> None:
    """Read and validate a project and describe each mechanism, without analysis.

    Shows how the program understood the file: hinges, loads, interfaces and rocking parameters.
    """
    from assess.project.schema import load

    with progress() as shown:
        loaded = load(project)
        from assess.cli.tables.project import description, sensitivity_text
        from assess.project.build import build
        from assess.study.parameters import parameters

        shown.step("mechanisms")
        study = build(loaded)
    print(description(loaded, parameters(study), study.sweeps, study.messages), end="")
    print(sensitivity_text(study.variables), end="")
