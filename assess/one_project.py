"""One project of a portfolio, from its file or its row to a row of the ranked table; workers import it by its name.

What is heavy is imported when a project is assessed: the process that gives out the tasks needs none of it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from assess.portfolio.row import Row
from assess.portfolio.tasks import Job

if TYPE_CHECKING:
    from assess.portfolio.projects import Task
    from assess.project.schema import Project
    from assess.results import Results


def assess_project(job: Job) -> Row:
    """Assess one project of a portfolio in this thread, write the outputs that are kept of it, and return its row.

    Raises
    ------
    AssessError, RecordError or SpectrumError : something the user can mend
    """
    from assess.outputs.manifest import RESULTS
    from assess.portfolio.verdict_row import row_of_verdict
    from assess.project.build import build, build_to_decide
    from assess.study.decision import find_verdict
    from assess.study.run import run

    project = load_task(job.task)
    if job.keep == "rows":
        return row_of_verdict(job, find_verdict(build_to_decide(project)))
    results = run(build(project), jobs=1)
    report = _write(job, results)
    return row_of_verdict(job, results.verdict, report=report, results=f"{job.folder.name}/{RESULTS}")


def load_task(task: Task) -> Project:
    """Read the project of a task: its file, or its template with the values of its row."""
    from assess.portfolio.projects import project_tree
    from assess.project.schema import load, load_tree

    if task.content is None:
        return load(task.path)
    return load_tree(project_tree(task), task.path, sha256=task.sha256)


def _write(job: Job, results: Results) -> str:
    """Write the outputs of a project, whole or not at all; return the link to its report, "" for none."""
    from assess.outputs.folder import output_folder
    from assess.outputs.manifest import REPORT, RESULTS
    from assess.results.json import dumps

    wanted = (RESULTS, *(REPORT if job.keep == "report" else ()))
    with output_folder(job.folder, command="assess batch", wanted=wanted) as stage:
        (stage / RESULTS).write_bytes(dumps(results).encode())
        if job.keep == "results":
            return ""
        from reports.writing import write_all

        return f"{job.folder.name}/{write_all(results, stage, jobs=1).relative_to(stage).as_posix()}"
