"""Compiled code on disk: never that of other sources, never someone else's, and found again where it is ours."""

import ast
import os
import shutil
import subprocess
import sys
import time
from ctypes import CDLL
from pathlib import Path

import pytest

from records.compilation import ROOT, UNUSED, find_folder, is_private, kernel, sources, sources_key
from tests.support.files import edit_file, write_file

SINE = """
import numpy as np
from assess.dynamics.kernel.columns import BOUNCE, IMPACTS, PARTNER, RATE, THRESHOLD
from assess.dynamics.kernel.sine import sine_outcomes as function
branch = np.zeros((1, 2, 6))
branch[0, :, THRESHOLD], branch[0, :, BOUNCE], branch[0, :, PARTNER], branch[0, :, RATE] = 1.0, 0.8, [1, 0], 2.0
found = np.zeros((1, 8))
jobs = np.zeros(1, dtype=np.int64)
function(branch, 2 * np.pi, np.array([1.0]), jobs, jobs, np.array([1.1]), found)
answer = int(found[0, IMPACTS])
"""
"""Impacts of a body under one sine: with REST of `assess.dynamics.kernel.events`, compiled into `sine_outcomes`."""
TOY = "from assess.toy.kernel import total as function\nanswer = function(1.0)\n"
SAYS = "print(answer, sum(function.stats.cache_hits.values()), sum(function.stats.cache_misses.values()))"
BY_NUMBA = """
import records.compilation.kernel
records.compilation.kernel.cache_on_disk = lambda function: (function.enable_caching(), function)[1]
"""


def copied(folder: Path, *paths: Path) -> Path:
    """Sources of the packages."""
    for path in paths:
        write_file(folder / path.relative_to(ROOT), path.read_bytes())
    return folder


def toy(folder: Path) -> Path:
    """A kernel with another in it."""
    copied(folder, *sources(), *(ROOT / "records" / "compilation").glob("*.py"))
    for package in ("assess", "records", "assess/toy", "assess/toy/inner"):
        (folder / package).mkdir(exist_ok=True)
        (folder / package / "__init__.py").touch()
    own = "from assess.kernel import entry\nfrom assess.toy.inner.kernel import PART\n\n\n"
    (folder / "assess/toy/kernel.py").write_text(f"{own}@entry\ndef total(x: float) -> float:\n    return x + PART\n")
    (folder / "assess/toy/inner/kernel.py").write_text("PART = 1.0\n")
    return folder


def started(script: str, packages: Path, environment: dict[str, str], bound: bool = False) -> subprocess.Popen[str]:
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("NUMBA_", "XDG_"))}
    return subprocess.Popen(
        [sys.executable, "-B", "-c", script + SAYS],
        env={**kept, "PYTHONPATH": str(packages), **environment},
        cwd=packages,
        # Modes of files bind root too: PR_CAPBSET_DROP of CAP_DAC_OVERRIDE, from the program that is started next.
        preexec_fn=(lambda: CDLL(None).prctl(24, 1, 0, 0, 0)) if bound else None,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def ended(process: subprocess.Popen[str]) -> tuple[float, int, int]:
    """The answer, and how often compiled code was found and was not."""
    out, errors = process.communicate(timeout=120)
    assert process.returncode == 0, errors
    answer, hits, misses = out.split()
    return float(answer), int(hits), int(misses)


def run(script: str, packages: Path, environment: dict[str, str]) -> tuple[float, int, int]:
    return ended(started(script, packages, environment))


def test_an_edit_of_what_is_compiled_in_changes_the_answer_at_once(tmp_path: Path) -> None:
    """A constant of kernel/events.py is compiled into the machine code of kernel/sine.py, whose file is not touched."""
    whole = (path for package in ("assess", "records", "spectra") for path in (ROOT / package).rglob("*.py"))
    packages, place = copied(tmp_path / "packages", *whole), {"NUMBA_CACHE_DIR": str(tmp_path / "cache")}
    before, *compiled = run(SINE, packages, place)
    edit_file(packages / "assess/dynamics/kernel/events.py", "\nREST = 1e-4\n", "\nREST = 1e+4\n")
    after, *anew = run(SINE, packages, place)
    assert compiled == anew == [0, 1]
    assert before > after > 0.0  # at rest after each first impact
    edit_file(packages / "assess/dynamics/kernel/events.py", "\nREST = 1e+4\n", "\nREST = 1e-4\n")
    assert run(SINE, packages, place) == (before, 1, 0)  # the code of either version stays


@pytest.mark.study
def test_numbas_own_cache_gives_the_old_answer_after_the_edit(tmp_path: Path) -> None:
    """What this cache is there for; should numba learn it, ours can go."""
    packages, place = toy(tmp_path / "packages"), {"NUMBA_CACHE_DIR": str(tmp_path / "cache")}
    inner = packages / "assess/toy/inner/kernel.py"
    assert run(BY_NUMBA + TOY, packages, place) == (2.0, 0, 1)
    assert run(TOY, packages, place) == (2.0, 0, 1)
    edit_file(inner, "PART = 1.0", "PART = 5.0")
    assert run(BY_NUMBA + TOY, packages, place) == (2.0, 1, 0)
    assert run(TOY, packages, place) == (6.0, 0, 1)


def test_processes_that_compile_at_once_leave_whole_code_and_nothing_else(tmp_path: Path) -> None:
    packages, place = toy(tmp_path / "packages"), {"NUMBA_CACHE_DIR": str(tmp_path / "cache")}
    together = [started(TOY, packages, place) for _ in range(3)]
    assert {ended(process)[0] for process in together} == {2.0}
    assert run(TOY, packages, place) == (2.0, 1, 0)
    (folder,) = (tmp_path / "cache" / "rocking-assess").iterdir()
    (code,) = folder.iterdir()
    assert code.suffix == ".code"


@pytest.mark.skipif(sys.platform != "linux", reason="root can be bound by modes on Linux")
def test_a_package_that_cannot_be_written_in_a_home_that_cannot_either(tmp_path: Path) -> None:
    packages, temporary = toy(tmp_path / "packages"), tmp_path / "temporary"
    temporary.mkdir()
    for path in (packages, *packages.rglob("*")):
        path.chmod(0o555 if path.is_dir() else 0o444)
    environment = {"HOME": str(packages), "TMPDIR": str(temporary)}
    script = f"import os\nassert not os.access({str(packages)!r}, os.W_OK)\n{TOY}"
    assert ended(started(script, packages, environment, bound=True)) == (2.0, 0, 1)
    assert ended(started(script, packages, environment, bound=True)) == (2.0, 1, 0)
    (made,) = temporary.iterdir()
    assert made.stat().st_mode & 0o777 == 0o700
    made.chmod(0o777)  # anybody could now put code there
    assert ended(started(script, packages, environment, bound=True)) == (2.0, 0, 1)


def test_the_folder_is_of_the_user_alone(tmp_path: Path) -> None:
    folder = find_folder("0" * 32, given=str(tmp_path), user="")
    assert folder == tmp_path / "rocking-assess" / ("0" * 32)
    assert {path.stat().st_mode & 0o777 for path in (folder, folder.parent)} == {0o700}


@pytest.mark.skipif(os.name != "posix", reason="users and modes of POSIX")
@pytest.mark.parametrize("mode", [0o720, 0o702, 0o777])
def test_a_folder_that_others_may_write_is_not_used(tmp_path: Path, mode: int) -> None:
    (open_to_all := tmp_path / "open").mkdir()
    open_to_all.chmod(mode)
    assert not is_private(open_to_all)
    readable = tmp_path / "readable"
    readable.mkdir(mode=0o755)
    assert is_private(readable)
    assert readable.stat().st_mode & 0o777 == 0o700


@pytest.mark.skipif(os.name != "posix", reason="users and modes of POSIX")
def test_a_folder_or_file_of_someone_else_is_not_used(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    kernel._write(tmp_path / "code", b"code")
    assert kernel._read(tmp_path / "code") == b"code"
    monkeypatch.setattr(os, "getuid", lambda: os.stat(tmp_path).st_uid + 1)
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    assert not is_private(tmp_path)
    assert kernel._read(tmp_path / "code") is None
    assert find_folder("0" * 32, given=str(tmp_path), user=str(tmp_path / "home")) is None


def test_a_link_or_a_file_is_not_a_folder(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    (tmp_path / "link").symlink_to(tmp_path)
    assert not is_private(tmp_path / "file")
    assert not is_private(tmp_path / "link")


def test_places_are_taken_in_turn(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    given, user, temporary = tmp_path / "given", tmp_path / "user" / "rocking-assess", tmp_path / "temporary"
    temporary.mkdir()
    monkeypatch.setattr("tempfile.tempdir", str(temporary))
    found = []
    for closed in ([], [given], [given, user.parent]):
        for path in closed:
            shutil.rmtree(path, ignore_errors=True)
            path.touch()  # a file: no folder can be made below
        found.append(find_folder("0" * 32, given=str(given), user=str(user)))
        for path in closed:
            path.unlink()
    assert [path and path.parent.parent for path in found] == [given, user.parent, temporary]


def test_code_that_is_damaged_is_compiled_anew(tmp_path: Path) -> None:
    path = tmp_path / "code"
    assert kernel._read(path) is None
    kernel._write(path, b"machine code")
    whole = path.read_bytes()
    for damaged in (b"", whole[:-1], whole[:40] + b"X" + whole[41:], b"X" + whole[1:]):
        path.write_bytes(damaged)
        assert kernel._read(path) is None
    kernel._write(tmp_path / "no folder" / "code", b"machine code")  # a disk that cannot be written is no error


def test_code_that_nobody_has_started_with_for_a_month_is_deleted(tmp_path: Path) -> None:
    place = tmp_path / "rocking-assess"
    for name, age in (("a" * 32, 1.1), ("b" * 32, 0.9), ("notes", 2.0)):
        (place / name).mkdir(parents=True)
        (place / name / "file").touch()
        os.utime(place / name, (time.time() - age * UNUSED,) * 2)
    assert find_folder("b" * 32, given=str(tmp_path), user="")  # in use again
    assert {path.name for path in place.iterdir()} == {"a" * 32, "b" * 32, "notes"}
    assert find_folder("c" * 32, given=str(tmp_path), user="")
    assert {path.name for path in place.iterdir()} == {"b" * 32, "c" * 32, "notes"}
    assert time.time() - (place / ("b" * 32)).stat().st_mtime < UNUSED / 2


def test_the_key_is_of_every_kernel_and_of_what_compiles(tmp_path: Path) -> None:
    packages = toy(tmp_path)
    (packages / "assess/toy/kernel").mkdir()
    (packages / "assess/toy/kernel/part.py").write_text("X = 1\n")
    (packages / "assess/toy/other.py").write_text("X = 1\n")
    before = sources_key(("1",), packages)
    assert before != sources_key(("2",), packages)
    assert "assess/toy/kernel/part.py" in {path.relative_to(packages).as_posix() for path in sources(packages)}
    for path in sources(packages):
        text = path.read_text()
        path.write_text(text + "#")
        assert sources_key(("1",), packages) != before
        path.write_text(text)
    (packages / "assess/toy/other.py").write_text("X = 2\n")
    assert sources_key(("1",), packages) == before
    assert sources_key(("1",), tmp_path / "nothing") is None


def test_all_that_is_compiled_is_in_the_key() -> None:
    """A kernel imports only kernels, and the names of array types; nothing else is compiled."""
    kernels = {".".join(path.relative_to(ROOT).with_suffix("").parts) for path in sources()}
    expected = {"assess.kernel", "records.kernel", "assess.dynamics.kernel.sine", "assess.interfaces.kernel.discs"}
    assert expected <= kernels
    for path in (
        path for package in ("assess", "records", "reports", "spectra") for path in (ROOT / package).rglob("*.py")
    ):
        name = ".".join(path.relative_to(ROOT).with_suffix("").parts)
        imported = {
            node.module or "" for node in ast.walk(ast.parse(path.read_text())) if isinstance(node, ast.ImportFrom)
        }
        ours = {module for module in imported if module.split(".")[0] in {"assess", "records", "reports", "spectra"}}
        if name in kernels - {"records.compilation.kernel"}:
            assert ours <= {*kernels, "spectra.arrays"}, name  # types of arguments, of which no code is made
        else:
            assert not {"numba", "assess.kernel", "records.compilation.kernel"} & imported, name
