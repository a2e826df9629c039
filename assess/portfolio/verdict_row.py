"""The row of a project's verdict."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import inf

from assess.codes.verdict import Answer, Decision, MechanismVerdict, Verdict
from assess.messages.message import Message, Severity
from assess.portfolio.row import Row, RowOutcome
from assess.portfolio.tasks import Job

EXIT_CODES: dict[RowOutcome, int] = {"pass": 0, "fail": 1, "incomplete": 3, "": 3}
_ORDER = (Decision.FAIL, Decision.INCOMPLETE, Decision.PASS)  # the worst first


def row_of_verdict(
    job: Job, found: Verdict | None, messages: Sequence[Message] = (), *, report: str = "", results: str = ""
) -> Row:
    """Return the row of a project that was assessed, by its worst mechanism and the answer that is worst there.

    Parameters
    ----------
    job : Job
        Of the project.
    found : Verdict or None
        Of its run.
    messages : sequence of Message
        On its input.
    report, results : str
        Links to its report and to its results.json; "" for none.
    """
    task = job.task
    warned = sum(each.severity is Severity.WARNING for each in messages)
    if found is None:
        kept = Row(task.key, task.title, task.sha256, "done", report=report, results=results)
        return replace(kept, warnings=warned, exit_code=EXIT_CODES[""])
    one = min(found.mechanisms, key=_severity, default=None)
    answer = None if one is None else min(one.answers, key=_severity_of_answer, default=None)
    outcome: RowOutcome = found.outcome.value
    return Row(
        key=task.key,
        title=task.title,
        sha256=task.sha256,
        status="done",
        outcome=outcome,
        basis=found.basis,
        limit_state="" if answer is None else answer.limit_state,
        worst_mechanism="" if one is None else one.mechanism,
        margin=None if one is None else one.margin,
        demand_capacity=None if answer is None else answer.ratio,
        procedure="" if answer is None else answer.procedure,
        missing=len(found.missing),
        warnings=warned,
        mechanisms=len(found.mechanisms),
        report=report,
        results=results,
        exit_code=EXIT_CODES[outcome],
    )


def _severity(one: MechanismVerdict) -> tuple[int, float, float]:
    """Return what sorts mechanisms, the worst first: by outcome, then by margin, then by demand over capacity."""
    ratios = [answer.ratio for answer in one.answers if answer.ratio is not None]
    return (_ORDER.index(one.outcome), inf if one.margin is None else one.margin, -max(ratios, default=-inf))


def _severity_of_answer(answer: Answer) -> tuple[int, float]:
    return (_ORDER.index(answer.outcome), inf if answer.ratio is None else -answer.ratio)
