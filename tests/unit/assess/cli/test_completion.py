"""Completion as shells ask for it: bash itself, and what zsh and fish would call."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from assess.examples import EXAMPLES
from assess.verification.case_files import read_cases
from spectra.design_spectra import SPECTRA
from tests.support.command import ended

SHELLS = ("bash", "zsh", "fish")
CASES = {key for each in read_cases() for key in (each.key, each.key.partition("/")[0])}


@pytest.fixture(scope="module")
def environment(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """Variables of a shell in which `assess` can be called by its name."""
    folder = tmp_path_factory.mktemp("bin")
    program = folder / "assess"
    program.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m assess "$@"\n')
    program.chmod(0o755)
    root = Path(__file__).parents[4]
    return os.environ | {"PATH": f"{folder}{os.pathsep}{os.environ['PATH']}", "PYTHONPATH": str(root)}


@pytest.fixture(scope="module")
def scripts(environment: dict[str, str]) -> dict[str, str]:
    """What each shell is given to read at its start."""
    return {
        shell: subprocess.run(
            ["assess"],
            env=environment | {"_ASSESS_COMPLETE": f"source_{shell}"},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for shell in SHELLS
    }


OFFERED = {
    "assess re": ["retrofit", "report", "records"],
    "assess records s": ["spectra", "select", "scale"],
    "assess run --j": ["--jobs"],
    "assess run --qu": ["--quiet"],
    "assess new x --example san_leonardo_s": ["san_leonardo_spire"],
    "assess new x --example ": sorted(EXAMPLES),
    "assess spectrum --code ": list(SPECTRA),
    "assess spectrum --code ntc": [name for name in SPECTRA if name.startswith("ntc")],
    "assess fragility x --export nrml,p": ["nrml,pelicun"],
    "assess records list x --unit c": ["cm/s2"],
    "assess verify housner_1963/r": ["housner_1963/rectangular_pulse"],
    "assess verify hous": sorted([key for key in CASES if key.startswith("hous")]),
}


@pytest.mark.parametrize("line", OFFERED)
def test_the_end_of_a_word_is_offered(
    line: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """As the script of bash asks, in this process."""
    asked = {"_ASSESS_COMPLETE": "complete_bash", "COMP_WORDS": line, "COMP_CWORD": str(line.count(" "))}
    for name, value in asked.items():
        monkeypatch.setenv(name, value)
    assert ended() == 0
    assert capsys.readouterr().out.split() == OFFERED[line]


@pytest.mark.skipif(shutil.which("bash") is None, reason="there is no bash here")
@pytest.mark.parametrize(
    "line", ["assess re", "assess new x --example san_leonardo_s", "assess fragility x --export nrml,p"]
)
def test_bash_completes(line: str, scripts: dict[str, str], environment: dict[str, str]) -> None:
    words = line.split(" ")
    quoted = " ".join(f"'{word}'" for word in words)
    ask = f"COMP_WORDS=({quoted}); COMP_CWORD={len(words) - 1}; _assess_completion assess"
    text = f"{scripts['bash']}\n{ask}\nprintf '%s\\n' \"${{COMPREPLY[@]}}\""
    done = subprocess.run(["bash", "-c", text], env=environment, capture_output=True, text=True, check=True)
    assert done.stderr == ""
    assert done.stdout.split() == OFFERED[line]


@pytest.mark.parametrize("shell", SHELLS)
def test_scripts_are_those_of_their_shell(shell: str, scripts: dict[str, str]) -> None:
    text = scripts[shell]
    assert f"_ASSESS_COMPLETE=complete_{shell}" in text
    if shutil.which(shell):
        option = "--no-execute" if shell == "fish" else "-n"
        subprocess.run([shell, option], input=text, text=True, check=True, capture_output=True)


@pytest.mark.parametrize(
    ("shell", "asked"),
    [
        ("zsh", {"_TYPER_COMPLETE_ARGS": "assess new x --example chi"}),
        ("fish", {"_TYPER_COMPLETE_ARGS": "assess new x --example chi", "_TYPER_COMPLETE_FISH_ACTION": "get-args"}),
    ],
)
def test_zsh_and_fish_get_the_same_values(shell: str, asked: dict[str, str], environment: dict[str, str]) -> None:
    """These shells need not be here: the program is called as their scripts call it."""
    variables = environment | asked | {"_ASSESS_COMPLETE": f"complete_{shell}"}
    done = subprocess.run(["assess"], env=variables, capture_output=True, text=True, check=True)
    assert "chiesa" in done.stdout
    assert "casa_grande" not in done.stdout
