"""Work beside this process."""

from __future__ import annotations

import math
import os
import sys

import pytest

from reports.processes import processes


def test_answers_are_those_of_the_function() -> None:
    for jobs in (1, 2):
        with processes(jobs) as pool:
            asked = [pool.submit(math.isqrt, n * n) for n in range(20)]
        assert [each.result() for each in asked] == list(range(20))


def test_one_job_stays_in_this_process() -> None:
    with processes(1) as pool:
        assert pool.submit(os.getpid).result() == os.getpid()


@pytest.mark.skipif(sys.platform != "linux", reason="processes are copied on Linux only")
def test_two_jobs_leave_it() -> None:
    with processes(2) as pool:
        assert pool.submit(os.getpid).result() != os.getpid()


@pytest.mark.parametrize("jobs", [1, 2])
def test_an_error_of_the_work_is_the_callers(jobs: int) -> None:
    with pytest.raises(ValueError, match="nonnegative"), processes(jobs) as pool:
        pool.submit(math.isqrt, -1).result()
