"""The OpenQuake engine itself reads what is exported to it: GEM Foundation, github.com/gem/oq-engine (3.25).

It needs libraries that the program does without, so it runs in an interpreter of its own: OPENQUAKE_PYTHON names it.
"""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

from assess.risk.estimates import Lognormal, wilson_interval
from assess.risk.exports import ExportedCurve, ExportedState, nrml_text

PYTHON = os.environ.get("OPENQUAKE_PYTHON", "")
PROGRAM = """
import json, sys
import numpy as np
from openquake.hazardlib import nrml
import openquake.risklib.read_nrml
model = nrml.to_python(sys.argv[1])
at = np.array([float(sys.argv[2])])
print(json.dumps({key: [float(f(at.copy())[0]) for f in value.build(model.limitStates, 20, 1)]
                  for (_, key), value in model.items()}))
"""


@pytest.mark.study
@pytest.mark.skipif(not Path(PYTHON).is_file(), reason="OPENQUAKE_PYTHON names no interpreter that has OpenQuake")
@pytest.mark.parametrize(("format", "expected"), [("continuous", [0.98957, 0.26132]), ("discrete", [0.9, 0.2])])
@pytest.mark.parametrize(
    ("measure", "period", "unit", "factor"), [("pga", None, "g", 1), ("pgv", None, "m/s", 100), ("sa", 0.5, "g", 1)]
)
def test_openquake_reads_the_probabilities_of_the_curves(tmp_path, measure, period, unit, factor, format, expected):
    fits = {"rocking": Lognormal(0.15, 0.30), "overturning": Lognormal(0.40, 0.45)}
    records, reached = np.full(3, 10), {"rocking": np.array([3, 9, 10]), "overturning": np.array([0, 2, 6])}
    im = np.array([0.1, 0.3, 0.5])
    states = tuple(ExportedState(name, fit, im, records, reached[name], *wilson_interval(reached[name], records))
                   for name, fit in fits.items())  # fmt: skip
    names = ['Wall 6, <eroded> & "cut"', "wall-7"]
    export = nrml_text([ExportedCurve(name, measure, period, unit, states) for name in names], format=format)
    (tmp_path / "model.xml").write_text(export.text, encoding="utf-8")
    (tmp_path / "program.py").write_text(PROGRAM)
    command = [PYTHON, "-W", "ignore", "program.py", "model.xml", str(0.3 * factor)]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    found = json.loads(done.stdout.splitlines()[-1])
    assert list(found) == ["Wall 6, <eroded> & _cut_", "wall-7"]
    for each in found.values():
        np.testing.assert_allclose(each, expected, atol=1e-5)
