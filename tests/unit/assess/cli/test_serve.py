"""`assess serve`: the address on stdout, a model that becomes a project, and an end by Ctrl-C."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import urllib.error
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

pytest.importorskip("viser", reason="needs viser: .venv/serve of the Makefile")

from assess.examples import copy_example
from tests.support.command import ROOT, ended_with
from tests.support.projects import project_toml


@contextmanager
def served(*arguments: str | Path) -> Iterator[tuple[str, subprocess.Popen[str]]]:
    """Serve in a process of its own; give the address that it prints."""
    command = [sys.executable, "-m", "assess", "serve", *map(str, arguments), "--no-open"]
    variables = os.environ | {"PYTHONPATH": str(ROOT)}
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", env=variables)
    try:
        yield process.stdout.readline().strip(), process
    finally:
        process.kill()
        process.communicate()


def test_the_address_is_printed_and_ctrl_c_ends_it(tmp_path):
    (tmp_path / "project.toml").write_text(project_toml(), encoding="utf-8")
    with served(tmp_path) as (address, process):
        assert address.startswith("http://127.0.0.1:")
        with pytest.raises(urllib.error.HTTPError, match="403"):
            urllib.request.urlopen(address.partition("?")[0], timeout=30)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=60)
        assert (process.returncode, out) == (130, "")
        assert err == "assess: interrupted; what was written to the project file stays\n"


def test_a_model_becomes_a_project_beside_it(tmp_path):
    copy_example("house", tmp_path / "example")
    model = (tmp_path / "example" / "house.ifc").rename(tmp_path / "house.ifc")
    with served(model) as (address, _):
        assert address.startswith("http://127.0.0.1:")
        assert (tmp_path / "house-project" / "project.toml").is_file()


def test_wrong_input_is_one_line(tmp_path, capsys):
    assert ended_with(capsys, "serve", tmp_path / "none.toml")[0] == 2
    (tmp_path / "project.toml").write_text(project_toml(), encoding="utf-8")
    code, line = ended_with(capsys, "serve", tmp_path, "-o", tmp_path / "other")
    assert (code, "-o is of a model" in line) == (2, True)
    code, line = ended_with(capsys, "serve", tmp_path, "--port", 70000)
    assert code == 2
