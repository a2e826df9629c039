"""What all tests share: cases drawn by hypothesis, kernels compiled before the tests are dealt out, Ctrl-C."""

from __future__ import annotations

import os
import signal

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


def pytest_configure() -> None:
    """Hear SIGINT though a shell has started this in the background, where it is ignored by all that are started."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)
