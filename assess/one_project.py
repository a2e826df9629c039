"""One project of a portfolio, from its file or its row to a row of the ranked table; workers import it by its name.

What is heavy is imported when a project is assessed: the process that gives out the tasks needs none of it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from assess.errors import AssessError, OutputError, ProjectError
from assess.portfolio.row import ProjectRow
from assess.portfolio.tasks import Job
from records.errors import RecordError
from spectra.errors import SpectrumError

if TYPE_CHECKING:
    from assess.portfolio.projects import Task
    from assess.portfolio.template import KeyColumn
    from assess.project.project_file import Project
    from assess.results import Results

PROBES = ("1", "0.01", "100")
"""Numbers of which one at least is within the range of any key, in a unit of its dimension."""


def assess_project(job: Job) -> ProjectRow:
    """Assess one project of a portfolio in this thread, write the outputs that are kept of it, and return its row.

    Raises
    ------
    AssessError, RecordError or SpectrumError : something the user can mend
    """
    with _located(job.task):
        return _assess(job)


def _assess(job: Job) -> ProjectRow:
    from assess.outputs.manifest import RESULTS
    from assess.portfolio.tasks import row_of_verdict
    from assess.project.build import build, build_to_decide
    from assess.study.run import find_verdict, run_study

    project = load_task(job.task)
    if job.keep == "rows":
        study = build_to_decide(project)
        return row_of_verdict(job, find_verdict(study), study.messages)
    study = build(project)
    results = run_study(study, jobs=1)
    report = _write(job, results)
    said = [each for each in study.messages if not each.key.startswith("annex-")]  # which is of the report
    return row_of_verdict(job, results.verdict, said, report=report, results=f"{job.folder.name}/{RESULTS}")


@contextmanager
def _located(task: Task) -> Iterator[None]:
    """Locate the errors of a project of a table in the table."""
    from assess.portfolio.projects import row_fault

    try:
        yield
    except OutputError:
        raise
    except (AssessError, RecordError, SpectrumError) as error:
        if task.content is None:
            raise
        raise ProjectError(row_fault(task, str(error))) from None


def unit_fault(path: Path, tables: Mapping[str, Any], column: KeyColumn) -> str:
    """Return why the unit of a table's column cannot stand at its key of the template; "" if it can.

    Parameters
    ----------
    path : of the template
    tables : of the template
    column : with a unit
    """
    from assess.portfolio.template import key_text, keys_of, with_row
    from assess.project.project_file import load_tree

    told, first = f"{path}: {key_text(keys_of(tables)[column.key])}: ", ""
    for number in PROBES:
        try:
            load_tree(with_row(tables, {column.key: (number, column.unit)}), path, sha256="")
        except ProjectError as error:
            if not str(error).startswith(told):
                return ""
            first = first or str(error).removeprefix(told).removeprefix(f'"{number} {column.unit}": ')
        else:
            return ""
    return first


def load_task(task: Task) -> Project:
    """Read the project of a task: its file, or its template with the values of its row."""
    from assess.portfolio.projects import project_tree
    from assess.project.project_file import load, load_tree

    if task.content is None:
        return load(task.path)
    return load_tree(project_tree(task), task.path, sha256=task.sha256)


def _write(job: Job, results: Results) -> str:
    """Write the outputs of a project, whole or not at all; return the link to its report, "" for none."""
    from assess.outputs.manifest import REPORT, RESULTS
    from assess.outputs.writing import output_folder
    from assess.results.json import dumps

    wanted = (RESULTS, *(REPORT if job.keep == "report" else ()))
    with output_folder(job.folder, command="assess batch", expected=wanted) as stage:
        (stage / RESULTS).write_bytes(dumps(results).encode())
        if job.keep == "results":
            return ""
        from reports.writing import write_all

        return f"{job.folder.name}/{write_all(results, stage, jobs=1).relative_to(stage).as_posix()}"
