"""What solves the cases: a function of the case's folder and given values that returns a tree of numbers.

Each calls the program by the functions that a run calls; it computes nothing of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from assess.verification.solvers.free_rocking import solve_free_rocking
from assess.verification.solvers.joints import solve_joints
from assess.verification.solvers.motion import solve_motion
from assess.verification.solvers.parameters import solve_parameters
from assess.verification.solvers.project import solve_project
from assess.verification.solvers.pulses import solve_pulses
from assess.verification.solvers.risk import solve_risk
from assess.verification.solvers.shake_table import solve_shake_table
from assess.verification.solvers.spectrum import solve_spectra

Solver = Callable[[Path, Mapping[str, Any]], Mapping[str, Any]]

SOLVERS: dict[str, Solver] = {
    "free-rocking": solve_free_rocking,
    "joints": solve_joints,
    "motion": solve_motion,
    "parameters": solve_parameters,
    "project": solve_project,
    "pulses": solve_pulses,
    "risk": solve_risk,
    "shake-table": solve_shake_table,
    "spectra": solve_spectra,
}
