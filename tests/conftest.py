"""What all tests share: cases drawn by hypothesis, and kernels compiled before the tests are dealt out."""

from __future__ import annotations

import os

import pytest
from hypothesis import HealthCheck, settings

from tests.support.compile_kernels import compile_kernels

ANYWHERE = {"deadline": None, "database": None, "suppress_health_check": [HealthCheck.function_scoped_fixture]}
settings.register_profile("few", derandomize=True, max_examples=25, **ANYWHERE)
settings.register_profile("deep", derandomize=False, max_examples=1000, print_blob=True, **ANYWHERE)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "few"))


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_setupnodes() -> None:
    """Two workers that meet an uncompiled kernel would both compile it."""
    compile_kernels()
