"""Plant one fault at a time in a copy of the program, and see which solved cases turn red there: `make faults`.

Prints the table of docs/verification.md; ends with 1 where a fault turns no case red.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).parents[1]
PACKAGES = ("assess", "records", "reports", "spectra")


@dataclass(frozen=True)
class Fault:
    """A fault: what it is, the module, and the text that is exchanged there once."""

    name: str
    module: str
    right: str
    wrong: str


FAULTS = (
    Fault("restitution 3.44 with 1 for 2", "assess/mechanisms/restitution.py",
          "return 1 - 2 * M * R**2 / I_O * sin(alpha) ** 2", "return 1 - 1 * M * R**2 / I_O * sin(alpha) ** 2"),
    Fault("virtual work without the rise of masses in the inertia", "assess/mechanisms/chain.py",
          "(moved.dx**2 + moved.dz**2 if bearing", "(moved.dx**2 if bearing"),
    Fault("a tie that pulls the wrong way", "assess/mechanisms/chain.py",
          "work = load.tension * (along * moved.dx + up * moved.dz)",
          "work = -load.tension * (along * moved.dx + up * moved.dz)"),
    Fault("inertia about the hinge with half of M R²", "assess/mechanisms/single_block.py",
          "mass * g * radius / p**2 - mass * radius**2", "mass * g * radius / p**2 - 0.5 * mass * radius**2"),
    Fault("integral of the contact, 2 % too large", "assess/interfaces/kernel/moments.py",
          "length * (p[i, S] + x * rise + 0.5 * w0 * two + (1 / 3) * w1 * three),",
          "length * (p[i, S] + x * rise + 0.5 * w0 * two + (1 / 3) * w1 * three) * 1.02,"),
    Fault("force of a crushed joint without its crushed part", "assess/interfaces/kernel/equilibrium.py",
          "    if k * closure <= f:\n        return 0.0, a, max(over, 0.0)",
          "    if k * closure <= 1e9 * f:\n        return 0.0, a, max(over, 0.0)"),
    Fault("crack of two blocks: load at the wrong place", "assess/model/walls.py",
          "(1.0 - place) * load + arm * tension", "place * load + arm * tension + 0.1 * load"),
    Fault("spectrum of ASCE 7: 0.5 for 0.4 at T = 0", "spectra/asce7.py",
          "ZERO_PERIOD_RATIO = 0.4", "ZERO_PERIOD_RATIO = 0.5"),
    Fault("spectrum of EN 1998 and NTC: level branch up to T_D", "spectra/spectrum.py",
          "np.minimum(1.0, self.t_c / T)", "np.minimum(1.0, self.t_d / T)"),
    Fault("propagator of the linearised equation: sign of the ground", "assess/dynamics/kernel/linearised.py",
          "sides[side, V_K], sides[side, V_V], sides[side, V_A] = sinh / p, cosh_1, -inverse * cosh_1 / dt",
          "sides[side, V_K], sides[side, V_V], sides[side, V_A] = sinh / p, cosh_1, inverse * cosh_1 / dt"),
    Fault("ultimate displacement of NTC 2018: 0.5 for 0.4 d0*", "assess/codes/ntc2018_clauses.py",
          "DisplacementLimit(0.4, breaks=True, clause=CLAUSE), 1.68",
          "DisplacementLimit(0.5, breaks=True, clause=CLAUSE), 1.68"),
    Fault("ultimate displacement of the Guidelines: 0.5 for 0.4 d0*", "assess/codes/dmi2008.py",
          "ULTIMATE = 0.4 ", "ULTIMATE = 0.5 "),
    Fault("rotation that ASCE 43-05 allows: 1/2 for 1/3", "assess/codes/asce43_05.py",
          "THIRD = 1.0 / 3.0", "THIRD = 1.0 / 2.0"),
    Fault("motion at height: sum for square root of the sum of squares", "assess/amplification.py",
          "return float(np.hypot(S_a / _peak_of_motion(record) * mode.shape(height), 1.0))",
          "return float(S_a / _peak_of_motion(record) * mode.shape(height) + 1.0)"),
    Fault("floor factor of EN 1998-1: − 0.5 left out", "spectra/floor.py",
          "3.0 * (1.0 + ratio) / (1.0 + detuned) - 0.5", "3.0 * (1.0 + ratio) / (1.0 + detuned)"),
    Fault("scale factor of a record: half the logarithm", "records/scaling.py",
          "log_factor = np.average(log_ratio, axis=-1, weights=weight)",
          "log_factor = 0.5 * np.average(log_ratio, axis=-1, weights=weight)"),
)  # fmt: skip


def copy_program(folder: Path) -> None:
    """Copy the packages and their metadata into a folder."""
    for name in PACKAGES:
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__"))


def plant(fault: Fault, folder: Path) -> None:
    """Exchange the text of a fault in a copy of the program; raise ValueError where it does not stand there once."""
    path = folder / fault.module
    text = path.read_text(encoding="utf-8")
    if text.count(fault.right) != 1:
        raise ValueError(f"{fault.module}: {fault.right!r} stands there {text.count(fault.right)} times")
    path.write_text(text.replace(fault.right, fault.wrong), encoding="utf-8")


def red_cases(folder: Path, *, quick: bool) -> list[str]:
    """Run the solved cases of a copy of the program, and return the keys of those that fail.

    Parameters
    ----------
    folder : of the copy
    quick : run only the quick cases
    """
    command = [sys.executable, "-P", "-m", "assess", "verify", "--json", "--jobs", "1", *(["--quick"] if quick else ())]
    given = {**os.environ, "PYTHONPATH": str(folder)}
    done = subprocess.run(command, cwd=folder, env=given, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        raise ValueError(f"assess verify ended with {done.returncode}: {done.stderr[-300:]}")
    return [each["key"] for each in json.loads(done.stdout)["cases"] if _fails(each)]


def _fails(case: dict[str, object]) -> bool:
    return bool(case["fault"]) or '"outcome": "fail"' in json.dumps(case)


def rows(faults: Sequence[Fault]) -> Iterator[tuple[Fault, str, list[str]]]:
    """Yield each fault with the run that finds it, `--quick` or, where that finds nothing, all, and its red cases."""
    for fault in faults:
        with TemporaryDirectory() as folder:
            copy_program(Path(folder))
            plant(fault, Path(folder))
            red = red_cases(Path(folder), quick=True)
            yield (fault, "quick", red) if red else (fault, "all", red_cases(Path(folder), quick=False))


def main(words: Sequence[str]) -> int:
    """Print the table; words : faults whose names or modules hold one of them, all if there are none."""
    chosen = [each for each in FAULTS if not words or any(word in each.name + each.module for word in words)]
    missed = 0
    sys.stdout.write("| fault | module | run | cases that turn red |\n|---|---|---|---|\n")
    for fault, run, red in rows(chosen):
        missed += not red
        shown = ", ".join(f"`{key}`" for key in red[:3]) + (f" and {len(red) - 3} more" if len(red) > 3 else "")
        sys.stdout.write(f"| {fault.name} | `{fault.module}` | {run} | {len(red)}: {shown} |\n")
        sys.stdout.flush()
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
