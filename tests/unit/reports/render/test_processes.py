"""Work beside this process."""

from __future__ import annotations

import math
import os
import sys
from operator import call

import pytest

from reports.render.vector import document_processes


def test_answers_are_those_of_the_function() -> None:
    for jobs in (1, 2):
        with document_processes(jobs, 7) as submit:
            asked = [submit(math.comb, n) for n in range(8)]
        assert [each.result() for each in asked] == [1, 7, 21, 35, 35, 21, 7, 1]


def test_one_job_stays_in_this_process() -> None:
    with document_processes(1, os.getpid) as submit:
        assert submit(call).result() == os.getpid()


@pytest.mark.skipif(sys.platform != "linux", reason="processes are copied on Linux only")
def test_two_jobs_leave_it() -> None:
    with document_processes(2, os.getpid) as submit:
        assert submit(call).result() != os.getpid()


def test_what_cannot_be_sent_can_be_worked_on() -> None:
    for jobs in (1, 2):
        with document_processes(jobs, lambda: 3) as submit:
            assert submit(call).result() == 3


@pytest.mark.parametrize("jobs", [1, 2])
def test_an_error_of_the_work_is_the_callers(jobs: int) -> None:
    with pytest.raises(ValueError, match="nonnegative"), document_processes(jobs, -1) as submit:
        submit(math.isqrt).result()
